//! What a check says of pictures, in words.

use crate::check::Report;
use crate::dress::Dress;
use crate::picture::score;
use crate::picture::triple::{BadPixel, Triple};
use crate::prints::{abbreviated, first_difference, short};
use raybook_chapters::kit::untrusted::Untrusted;
use std::path::Path;

/// The pictures of an exercise whose cases are right: their file, and how good they are.
pub fn right(report: &Report, path: &Path) -> Vec<String> {
    let bad: usize = report.pictures.iter().map(|p| p.score.wrong()).sum();
    let several = report.pictures.len() > 1;
    let but = if bad > 0 && !several {
        format!(", in which {bad} pixels are wrong")
    } else {
        String::new()
    };
    let drawn = if report.pictures.is_empty() {
        ", drawn before"
    } else {
        ""
    };
    let mut lines = vec![format!(
        "    your picture: {}{but}{drawn}",
        Untrusted::from(path)
    )];
    lines.extend(stopped(report));
    if several {
        lines.extend(scores(&report.pictures));
    }
    lines
}

/// What is said after the number of right cases, if it is not the cases that are wrong.
pub fn but(report: &Report) -> &'static str {
    let cases_are_right = report.right() == report.cases.len();
    match (
        cases_are_right,
        report.first_failed(),
        report.pictures.len(),
    ) {
        (false, ..) | (_, None, _) => "",
        (.., 1) => ", the picture is not",
        _ => ", the pictures are not",
    }
}

/// What is wrong with the pictures of an exercise whose cases are right; empty if nothing is.
pub fn alone(report: &Report, path: Option<&Path>, dress: Dress) -> String {
    let Some(failed) = report.first_failed() else {
        return String::new();
    };
    let score = &failed.score;
    let what = if score.wrong() > 0 {
        format!("{} of {} of its pixels are right", score.right, score.of)
    } else {
        format!("its error is {:.4}", score.error)
    };
    let which = match report.pictures.len() {
        1 => String::new(),
        _ => format!(" {:?}", failed.name),
    };
    let title = format!(
        "{}: the cases are right, the picture{which} is not: {what}",
        report.exercise
    );
    let mut lines = vec![dress.paint("1", &title)];
    if let Some(path) = path {
        lines.extend(wrong(report, path));
    } else {
        lines.extend(found(report));
        lines.push("  `--pictures FOLDER` draws yours beside the right one.".to_owned());
    }
    lines.push(String::new());
    lines.join("\n")
}

/// Where the pictures are, how good each is, and the ray of the first wrong pixel.
pub fn wrong(report: &Report, path: &Path) -> Vec<String> {
    let found = found(report);
    if found.is_empty() {
        let (pictures, them) = match report.pictures.len() {
            1 => ("picture", "it"),
            _ => ("pictures", "them"),
        };
        return vec![format!(
            "  Every pixel of your {pictures} is right: these cases are not in {them}. {}",
            Untrusted::from(path)
        )];
    }
    let mut lines = vec![
        format!("  Picture: {}", Untrusted::from(path)),
        "  It shows yours, the right one, and the difference: orange where yours is too bright, blue where it is too dark.".to_owned(),
    ];
    lines.extend(found);
    lines
}

/// How good each picture is, and the ray of the first wrong pixel; nothing if every pixel is right.
fn found(report: &Report) -> Vec<String> {
    let pictures = &report.pictures;
    let bad = |picture: &&Triple| picture.score.wrong() > 0;
    let Some(picture) = report.first_failed().or_else(|| pictures.iter().find(bad)) else {
        return Vec::new();
    };
    let mut lines: Vec<_> = stopped(report).into_iter().collect();
    let mut of_which = String::new();
    if pictures.len() > 1 {
        lines.extend(scores(pictures));
        of_which = format!(" of {:?}", picture.name);
    }
    if let Some(bad) = &picture.first_bad {
        let (wrong, pixels) = (picture.score.wrong(), picture.score.of);
        let are = if wrong == 1 { "is" } else { "are" };
        let got = bad.got.as_ref().map_or_else(|| "nothing".to_owned(), short);
        let from = first_difference(&got, &bad.golden);
        let [got, right] = [&got, &bad.golden].map(|words| abbreviated(words, from));
        lines.extend([
            format!("  {wrong} of {pixels} pixels{of_which} {are} wrong; the first, in column {} of row {} from the top left, asks", bad.x, bad.y),
            format!("      {} {}", report.exercise, asked(report, bad)),
            format!("      yours: {got}; right: {right}"),
        ]);
    }
    lines
}

/// The question of a pixel: what can be read and typed; of a whole tree its beginning, and the command that tells it in full.
fn asked(report: &Report, bad: &BadPixel) -> String {
    /// Letters that a person reads, and those of a description of a scene that can still be typed.
    const WIDE: usize = 120;
    const LONGEST: usize = 1000;
    let question = &bad.question;
    if question.len() <= LONGEST {
        return question.clone();
    }
    let start = question[..WIDE].rfind(' ').unwrap_or(WIDE);
    let pixel = format!("{},{}", bad.x, bad.y);
    format!(
        "{} …\n      (in full: raybook explain {} --pixel {pixel})",
        &question[..start],
        report.exercise
    )
}

/// Why pixels are without an answer.
fn stopped(report: &Report) -> Option<String> {
    let why = report.stopped.as_ref()?;
    Some(format!("  Not every pixel was answered: {why}"))
}

/// How good each picture is.
fn scores(pictures: &[Triple]) -> Vec<String> {
    let mut rows = score::table(pictures);
    if pictures.iter().any(|picture| picture.score.undecided > 0) {
        rows.push(
            "A wrong ray that hangs on the last digits of its question is not counted.".to_owned(),
        );
    }
    rows.iter().map(|row| format!("      {row}")).collect()
}
