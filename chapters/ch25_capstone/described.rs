//! The words of a described scene as a figure.

use crate::kit::figure::{LEFT, SCALE, coloured, figure, text, write};
use crate::kit::palette::BLUE;
use raybook::image::Image;
use raybook_workbook::exercises::ch25_capstone::Trace;
use raybook_workbook::row::Row;
use std::error::Error;

/// The words of a question, line by line, each under what it is.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn words(
    width: usize,
    height: usize,
    question: &Trace,
) -> Result<Image, Box<dyn Error>> {
    let Trace { depth, ray, scene } = question;
    let mut lines = vec![
        ("the exercise, and the depth", format!("trace {depth}")),
        ("the ray: origin, direction", ray.write()),
        (
            "ambient light; backdrop below, above",
            format!("{}   {}", scene.ambient.write(), scene.backdrop.write()),
        ),
        (
            "number of lamps; position and intensity of each",
            scene.lamps.write(),
        ),
        (
            "number of objects; shape and material of each",
            scene.objects.len().to_string(),
        ),
    ];
    lines.extend(scene.objects.iter().map(|object| ("", object.write())));
    let rows: i32 = lines
        .iter()
        .map(|(title, _)| if title.is_empty() { 1 } else { 2 })
        .sum();
    let step = (SCALE as usize * height) as i32 / (rows + 1);
    // The longest line is about 80 letters of half their height.
    let size = (step * 9 / 10).min((SCALE as usize * width) as i32 / 39);
    let figure = figure(width as u32, height as u32, |canvas| {
        let mut y = step;
        for (title, words) in &lines {
            if !title.is_empty() {
                write(canvas, title, (size, y), coloured(size, BLUE).pos(LEFT))?;
                y += step;
            }
            write(canvas, words, (2 * size, y), text(size).pos(LEFT))?;
            y += step;
        }
        Ok(())
    })?;
    Ok(figure.pixels)
}
