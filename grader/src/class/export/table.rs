//! Tables as comma-separated values (RFC 4180).

use super::total;
use crate::class::grades::{Grade, points};
use crate::class::record::Standing;
use crate::class::roll::Class;
use raybook_chapters::kit::untrusted::Untrusted;
use std::fmt::Write;

/// A row. What a spreadsheet would compute is shown as text, by the apostrophe that spreadsheets know.
fn row<T: AsRef<str>>(table: &mut String, fields: impl IntoIterator<Item = T>) {
    for (i, field) in fields.into_iter().enumerate() {
        let field = Untrusted::from(field.as_ref()).to_string();
        let guard = if field.starts_with(['=', '+', '-', '@', '\t']) {
            "'"
        } else {
            ""
        };
        let comma = if i > 0 { "," } else { "" };
        let _ = if field.contains(['"', ',']) {
            let quoted = format!("\"{guard}{}\"", field.replace('"', "\"\""));
            // PHP, and so Moodle, takes a backslash before a quotation mark for an escape, and reads on into the next field.
            write!(table, "{comma}{}", quoted.replace("\\\"", "/\""))
        } else {
            write!(table, "{comma}{guard}{field}")
        };
    }
    table.push_str("\r\n");
}

/// Everybody's points: in all, by chapter and by exercise.
pub fn grades(class: &Class<'_>) -> String {
    let mut table = String::new();
    let mut head: Vec<String> = [
        "student",
        "points",
        "of",
        "graded",
        "language",
        "days late",
        "references taken",
        "refused",
    ]
    .map(str::to_owned)
    .into();
    if let Some(first) = class.grades.first() {
        head.extend(first.chapters.iter().map(|chapter| chapter.name.to_owned()));
        head.extend(
            first
                .exercises()
                .map(|exercise| exercise.counted.name.to_owned()),
        );
    }
    row(&mut table, head);
    for grade in &class.grades {
        let late = grade
            .chapters
            .iter()
            .map(|chapter| chapter.days_late)
            .max()
            .unwrap_or(0);
        let taken = grade.exercises().filter(|exercise| exercise.taken).count();
        let mut fields = vec![
            grade.sheet.student.clone(),
            points(grade.points()),
            points(grade.of_points()),
            if grade.is_complete() {
                "yes"
            } else {
                "not all"
            }
            .to_owned(),
            grade.sheet.language.clone(),
            late.to_string(),
            taken.to_string(),
            grade
                .sheet
                .print
                .as_ref()
                .err()
                .cloned()
                .unwrap_or_default(),
        ];
        fields.extend(
            grade
                .chapters
                .iter()
                .map(|chapter| points(chapter.points())),
        );
        fields.extend(
            grade
                .exercises()
                .map(|exercise| exercise.points.map_or_else(String::new, points)),
        );
        row(&mut table, fields);
    }
    table
}

/// The columns that Moodle's import of grades asks for: who, how much, and words.
pub fn moodle(class: &Class<'_>) -> String {
    let mut table = String::new();
    row(&mut table, ["username", &class.course.title, "feedback"]);
    for grade in &class.grades {
        row(
            &mut table,
            [grade.sheet.student.clone(), total(grade), feedback(grade)],
        );
    }
    table
}

/// The columns of Canvas' gradebook, with its row of the points that can be reached.
pub fn canvas(class: &Class<'_>) -> String {
    let mut table = String::new();
    row(
        &mut table,
        [
            "Student",
            "ID",
            "SIS User ID",
            "SIS Login ID",
            "Section",
            &class.course.title,
        ],
    );
    row(
        &mut table,
        [
            "    Points Possible",
            "",
            "",
            "",
            "",
            &points(class.course.reachable()),
        ],
    );
    for grade in &class.grades {
        let student = grade.sheet.student.as_str();
        row(&mut table, [student, "", "", student, "", &total(grade)]);
    }
    table
}

/// A sentence or two about a grade.
fn feedback(grade: &Grade) -> String {
    if let Err(why) = &grade.sheet.print {
        return format!("The hand-in cannot be graded: {why}.");
    }
    let count = |standing| {
        grade
            .exercises()
            .filter(|exercise| {
                exercise
                    .result
                    .as_ref()
                    .is_some_and(|result| result.standing == standing)
            })
            .count()
    };
    let all = grade.exercises().count();
    let mut text = format!("{} of {all} exercises are right.", count(Standing::Right));
    let not_graded = grade
        .exercises()
        .filter(|exercise| exercise.points.is_none())
        .count();
    if not_graded > 0 {
        let _ = write!(text, " {not_graded} are not graded yet.");
    }
    if let Some(late) = grade
        .chapters
        .iter()
        .map(|chapter| chapter.days_late)
        .max()
        .filter(|&days| days > 0)
    {
        let _ = write!(text, " Days late: {late}.");
    }
    text
}

/// The exercises in the hands of the class, and under each what goes wrong most often.
pub fn items(class: &Class<'_>) -> String {
    let mut table = String::new();
    row(&mut table, ["exercise", "what", "which", "students"]);
    for item in &class.items {
        let standings = item
            .standing
            .iter()
            .map(|(name, count)| ("standing", (*name).to_owned(), *count));
        let others = [
            (
                "standing",
                "right on the visible cases only".to_owned(),
                item.visible_only,
            ),
            ("reference", "taken".to_owned(), item.taken),
        ];
        let cases = item
            .cases
            .iter()
            .map(|(name, count)| ("wrong case", name.clone(), *count));
        let mistakes = item
            .mistakes
            .iter()
            .map(|(name, count)| ("mistake", name.clone(), *count));
        for (what, which, count) in standings.chain(others).chain(mistakes).chain(cases) {
            row(
                &mut table,
                [&item.exercise, what, &which, &count.to_string()],
            );
        }
    }
    table
}

/// Pairs of hand-ins that are nearly identical.
pub fn similar(class: &Class<'_>) -> String {
    let mut table = String::new();
    row(&mut table, ["student", "other student", "alike"]);
    for pair in class.pairs {
        row(
            &mut table,
            [
                &pair.students[0],
                &pair.students[1],
                &format!("{:.2}", pair.share),
            ],
        );
    }
    table
}
