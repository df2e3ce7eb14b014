//! The pictures of the answers, kept in a file. Whoever was right and still is, in the cases and in some pixels, others at each check, is not
//! asked for all pixels again.

use raybook::image::{Image, file, rgb::Rgb};
use raybook::store;
use raybook_chapters::kit::sheet::sheet;
use raybook_grader::check::{Report, State};
use raybook_grader::examine::Examiner;
use raybook_grader::fingerprint;
use raybook_grader::picture::ask::STRETCH;
use raybook_grader::picture::triple::Triple;
use std::error::Error;
use std::path::{Path, PathBuf};

/// Hexadecimal digits of a fingerprint that tell two files apart.
const DIGITS: usize = 16;

/// The file of an exercise's pictures, and the file beside it that says that no pixel was wrong.
fn files(exercise: &str, folder: &Path) -> [PathBuf; 2] {
    ["png", "right"].map(|ending| folder.join(exercise).with_extension(ending))
}

/// What is written of a file of right pictures: a fingerprint of the file, and of today's right colours, of one pixel in `STRETCH`.
fn stamp(examiner: &dyn Examiner, png: &[u8]) -> String {
    let mut colours = Vec::new();
    for (picture, size) in examiner.pictures().into_iter().enumerate() {
        for i in (0..size.width * size.height).step_by(STRETCH) {
            let question = examiner.pixel_numbers(picture, i % size.width, i / size.width);
            let answer = (examiner.asked().call)(&question);
            let colour = examiner.colour(picture, &question, &answer);
            let Rgb { r, g, b } = colour.unwrap_or(Rgb::BLACK);
            colours.extend([r, g, b].into_iter().flat_map(f32::to_le_bytes));
        }
    }
    fingerprint::of([png, &colours], DIGITS)
}

/// The file of an exercise's pictures, if no pixel was wrong when they were drawn, nor would be today.
pub fn right_pictures(examiner: &dyn Examiner, folder: &Path) -> Option<PathBuf> {
    let [png, right] = files(examiner.name(), folder);
    let stamped = store::read_text(&right).ok()?;
    let is_right = stamped == stamp(examiner, &store::read(&png).ok()?);
    is_right.then_some(png)
}

/// Writes the pictures of one exercise, a row of three for each; returns the file. In a workbook, pictures that are right are marked as such, so
/// that the next check need not draw them.
pub fn keep_pictures(
    report: &Report,
    examiner: &dyn Examiner,
    folder: Option<&Path>,
    in_workbook: bool,
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
    let [path, right] = files(report.exercise, folder);
    file::save(&path, &sheet(3, &tiles)?)?;
    let is_right = |picture: &Triple| picture.score.wrong() == 0;
    if in_workbook && report.state() == State::Right && report.pictures.iter().all(is_right) {
        store::write(&right, stamp(examiner, &store::read(&path)?).as_bytes())?;
    }
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
