//! The pictures of the answers, kept in a file.

use raybook::image::{Image, file, rgb::Rgb};
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
            (yours, framed(&picture.yours)),
            ("right".to_owned(), framed(&picture.golden)),
            ("yours − right".to_owned(), framed(&picture.difference)),
        ]);
    }
    let path = folder.join(report.exercise).with_extension("png");
    file::save(&path, &sheet(3, &tiles)?)?;
    Ok(Some(path))
}

/// A picture with four by four points for a pixel, and a line around it: a difference of nothing is as white as the page.
fn framed(picture: &Image) -> Image {
    let picture = picture.enlarged(4);
    let (right, bottom) = (picture.width() - 1, picture.height() - 1);
    Image::from_fn(picture.width(), picture.height(), |x, y| {
        if [0, right].contains(&x) || [0, bottom].contains(&y) {
            Rgb::gray(0.4)
        } else {
            picture.at(x, y)
        }
    })
}
