//! What a check says of pictures, in words.

use crate::check::Report;
use crate::score;
use crate::triple::Triple;
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
    let mut lines = vec![format!("    your picture: {}{but}", path.display())];
    lines.extend(stopped(report));
    if several {
        lines.extend(scores(&report.pictures));
    }
    lines
}

/// Where the pictures are, how good each is, and the ray of the first wrong pixel.
pub fn wrong(report: &Report, path: &Path) -> Vec<String> {
    let pictures = &report.pictures;
    let failed = |picture: &&Triple| !picture.score.passed();
    let bad = |picture: &&Triple| picture.score.wrong() > 0;
    let first = pictures.iter().find(failed);
    let Some(picture) = first.or_else(|| pictures.iter().find(bad)) else {
        let (pictures, them) = match pictures.len() {
            1 => ("picture", "it"),
            _ => ("pictures", "them"),
        };
        return vec![format!(
            "  Every pixel of your {pictures} is right: these cases are not in {them}. {}",
            path.display()
        )];
    };
    let mut lines = vec![
        format!("  Picture: {}", path.display()),
        "  It shows yours, the right one, and the difference: orange where yours is too bright, blue where it is too dark.".to_owned(),
    ];
    lines.extend(stopped(report));
    let mut of_which = String::new();
    if pictures.len() > 1 {
        lines.extend(scores(pictures));
        of_which = format!(" of {:?}", picture.name);
    }
    if let Some(bad) = &picture.first_bad {
        let (wrong, pixels) = (picture.score.wrong(), picture.score.of);
        let got = bad.got.as_deref().unwrap_or("nothing");
        lines.extend([
            format!("  {wrong} of {pixels} pixels{of_which} are wrong; the first, in column {} of row {} from the top left, asks", bad.x, bad.y),
            format!("      {} {}", report.exercise, bad.question),
            format!("      yours: {got}; right: {}", bad.golden),
        ]);
    }
    lines
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
