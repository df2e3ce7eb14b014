//! The pictures of the answers, kept in a file.

use raybook::image::file;
use raybook_chapters::kit::sheet::sheet;
use raybook_grader::check::Report;
use std::error::Error;
use std::path::{Path, PathBuf};

/// Writes the pictures of one exercise, a row of three for each; returns the file.
pub fn keep_pictures(
    report: &Report,
    folder: Option<&Path>,
) -> Result<Option<PathBuf>, Box<dyn Error>> {
    let Some(folder) = folder.filter(|_| !report.pictures.is_empty()) else {
        return Ok(None);
    };
    let several = report.pictures.len() > 1;
    let mut tiles = Vec::new();
    for picture in &report.pictures {
        let yours = if several {
            format!("{}: yours", picture.name)
        } else {
            "yours".to_owned()
        };
        tiles.extend([
            (yours, picture.yours.enlarged(4)),
            ("right".to_owned(), picture.golden.enlarged(4)),
            ("yours − right".to_owned(), picture.difference.enlarged(4)),
        ]);
    }
    let tiles: Vec<_> = tiles
        .iter()
        .map(|(title, tile)| (title.as_str(), tile.clone()))
        .collect();
    let path = folder.join(report.exercise).with_extension("png");
    file::save(&path, &sheet(3, &tiles)?)?;
    Ok(Some(path))
}
