//! What a check says of pictures, in words.

use crate::grade::check::Report;
use crate::grade::score;
use crate::grade::triple::Triple;
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
    if several {
        let table = score::table(&report.pictures);
        lines.extend(table.iter().map(|row| format!("      {row}")));
    }
    lines
}

/// Where the pictures are, how good each is, and the ray of the first wrong pixel.
pub fn wrong(exercise: &str, pictures: &[Triple], path: &Path) -> Vec<String> {
    let bad = |picture: &&Triple| picture.score.wrong() > 0;
    let Some(picture) = pictures.iter().find(bad) else {
        return vec![format!(
            "  Every pixel of your picture is right: these cases are not in it. {}",
            path.display()
        )];
    };
    let mut lines = vec![
        format!("  Picture: {}", path.display()),
        "  It shows yours, the right one, and the difference: orange where yours is too bright, blue where it is too dark.".to_owned(),
    ];
    let mut of_which = String::new();
    if pictures.len() > 1 {
        let table = score::table(pictures);
        lines.extend(table.iter().map(|row| format!("    {row}")));
        of_which = format!(" of {:?}", picture.name);
    }
    if let Some(bad) = &picture.first_bad {
        let (wrong, pixels) = (picture.score.wrong(), picture.score.of);
        let got = bad.got.as_deref().unwrap_or("nothing");
        lines.extend([
            format!("  {wrong} of {pixels} pixels{of_which} are wrong; the first, in column {} of row {} from the top left, asks", bad.x, bad.y),
            format!("      {exercise} {}", bad.question),
            format!("      yours: {got}; right: {}", bad.golden),
        ]);
    }
    lines
}
