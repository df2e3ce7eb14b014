//! The files that others read: tables for people and learning platforms, reports for machines, and pages.

mod exercism;
mod github;
mod gradescope;
mod junit;
mod outcome;
mod page_of_class;
mod page_of_student;
mod table;

use super::grades::{ExerciseGrade, Grade, points};
use super::record::Standing;
use super::roll::Class;
use raybook::store::{self, StoreError};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;

/// The folder of the students' own files.
pub const STUDENTS: &str = "students";

/// The text of a file of a student.
type OfStudent = fn(&Class<'_>, &Grade) -> String;

/// The text of a file of the class.
type OfClass = fn(&Class<'_>) -> String;

/// The files of a student.
const OF_STUDENT: [(&str, OfStudent); 5] = [
    ("grade.json", |class, grade| json(&of_student(class, grade))),
    ("results.json", |_, grade| json(&gradescope::results(grade))),
    ("exercism.json", |_, grade| json(&exercism::results(grade))),
    ("annotations.txt", |_, grade| github::annotations(grade)),
    ("index.html", page_of_student::page),
];

/// The files of the class.
const OF_CLASS: [(&str, OfClass); 7] = [
    ("grades.csv", table::grades),
    ("moodle.csv", table::moodle),
    ("canvas.csv", table::canvas),
    ("items.csv", table::items),
    ("similar.csv", table::similar),
    ("junit.xml", junit::report),
    ("index.html", page_of_class::page),
];

/// Writes all files of a class into the folder of results. Each appears whole or not at all.
///
/// # Errors
/// If one cannot be written.
pub fn write(folder: &Path, class: &Class<'_>) -> Result<(), StoreError> {
    for grade in &class.grades {
        let own = folder.join(STUDENTS).join(&grade.sheet.student);
        for (file, text) in OF_STUDENT {
            store::write(&own.join(file), text(class, grade).as_bytes())?;
        }
    }
    for (file, text) in OF_CLASS {
        store::write(&folder.join(file), text(class).as_bytes())?;
    }
    Ok(())
}

fn json(value: &Value) -> String {
    format!("{value:#}\n")
}

/// A student's grade for programs.
fn of_student(class: &Class<'_>, grade: &Grade) -> Value {
    let exercise = |exercise: &ExerciseGrade| {
        let result = exercise.result.as_ref();
        json!({
            "exercise": exercise.counted.name, "points": exercise.points, "of": exercise.counted.points,
            "bonus": exercise.counted.bonus, "taken": exercise.taken,
            "standing": result.map(|result| result.standing.name()),
            "right": result.map(|result| result.right[0]), "asked": result.map(|result| result.right[1]),
            "mistake": result.and_then(|result| Some(result.mistake.as_ref()?[0].clone())),
        })
    };
    let chapters = grade.chapters.iter().map(|chapter| {
        json!({
            "chapter": chapter.name, "points": chapter.points(), "of": chapter.of_points(), "weight": chapter.weight,
            "days_late": chapter.days_late, "lost": chapter.lost,
            "exercises": chapter.exercises.iter().map(exercise).collect::<Vec<_>>(),
        })
    });
    json!({
        "version": super::roll::VERSION, "raybook": env!("CARGO_PKG_VERSION"), "course": class.course.title,
        "term": class.course.term, "student": grade.sheet.student, "when": class.when.to_string(), "key": class.key,
        "hand_in": grade.sheet.print.as_ref().ok(), "refused": grade.sheet.print.as_ref().err(),
        "complete": grade.is_complete(), "points": grade.points(), "of": grade.of_points(),
        "chapters": chapters.collect::<Vec<_>>(),
    })
}

/// What a student is told of an exercise, in a sentence or a few lines. Nothing in it tells of hidden cases.
fn words(exercise: &ExerciseGrade) -> String {
    let Some(result) = &exercise.result else {
        // The points of a hand-in that is refused are known without a result.
        let what = exercise.points.map_or("not graded", |_| "refused");
        return what.to_owned();
    };
    let [right, asked] = result.right;
    let mut words = match result.standing {
        Standing::Right => "right".to_owned(),
        Standing::Wrong => format!("{right} of {asked} cases are right"),
        other => other.name().to_owned(),
    };
    if result.right_on_visible_only() {
        words += "; right on the visible cases only";
    } else if !result.why.is_empty() && result.standing != Standing::NotGraded {
        words += "\n";
        words += &result.why;
    }
    if let Some([mistake, hint]) = &result.mistake {
        let where_it_shows = if result.right_on_visible_only() {
            "For other questions it seems"
        } else {
            "It seems"
        };
        let _ = write!(
            words,
            "\n{where_it_shows} that your function {mistake}. {hint}"
        );
    }
    if exercise.taken {
        words += "\nThis is the reference, which was taken.";
    }
    words
}

/// A student's points, or that they are not known yet.
fn total(grade: &Grade) -> String {
    if grade.is_complete() {
        points(grade.points())
    } else {
        String::new()
    }
}
