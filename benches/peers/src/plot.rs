//! The picture of the race: for each set of rays a panel, in it a row for each structure, and in that a mark for each mesh.

use crate::meshes::NAMES as MESHES;
use crate::report::{COLUMNS, Row};
use plotters::element::{Circle, PathElement, Polygon, Rectangle};
use plotters::prelude::{Color, RGBColor};
use raybook::image::file;
use raybook_chapters::kit::figure::{self, CENTRE, Canvas, LEFT, RIGHT, figure, text};
use raybook_chapters::kit::palette::{BLUE, FAINT, GREEN, INK, ORANGE, PURPLE, SKY, VERMILION};
use raybook_chapters::kit::stage::Drawn;
use std::path::Path;

/// Sizes in pixels of the canvas, which is twice as wide and as high as the picture.
const NAMES: i32 = 400;
const PANEL: i32 = 500;
const GAP: i32 = 40;
const ROW: i32 = 84;
const HEAD: i32 = 190;
const FOOT: i32 = 320;
/// From one line below the legend, about the machine, to the next.
const LINE: i32 = 36;

/// The ratios that a panel shows, from its left to its right; what is slower or faster stands at its edges.
const LEAST: f64 = 0.02;
const MOST: f64 = 6.0;
/// The ratios with a line and a number.
const TICKS: [f64; 7] = [0.03, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0];

/// A colour and a form for each mesh: either would do.
const MARKS: [(RGBColor, Form); 9] = [
    (SKY, Form::Ring),
    (BLUE, Form::Disc),
    (VERMILION, Form::Square),
    (ORANGE, Form::Up),
    (GREEN, Form::Down),
    (PURPLE, Form::Diamond),
    (INK, Form::Cross),
    (VERMILION, Form::Ring),
    (GREEN, Form::Up),
];

#[derive(Clone, Copy)]
enum Form {
    Ring,
    Disc,
    Square,
    Up,
    Down,
    Diamond,
    Cross,
}

/// Draws it and writes it as PNG.
///
/// # Errors
/// If it cannot be drawn or written.
pub(crate) fn write(path: &Path, rows: &[Row], how: &[String]) -> Drawn {
    let rows: Vec<&Row> = rows
        .iter()
        .filter(|row| row.structure != "Embree")
        .collect();
    let mut structures: Vec<&Row> = Vec::new();
    for row in &rows {
        if structures
            .iter()
            .all(|known| known.structure != row.structure)
        {
            structures.push(row);
        }
    }
    structures.sort_by_key(|row| !row.ours);
    let is_there = |column: &&str| rows.iter().any(|row| row.column() == *column);
    let columns: Vec<_> = COLUMNS.into_iter().filter(is_there).collect();
    if columns.is_empty() {
        return Ok(());
    }
    let width = NAMES + (PANEL + GAP) * columns.len() as i32;
    let height = HEAD + ROW * structures.len() as i32 + FOOT;
    let image = figure(width as u32 / 2, height as u32 / 2, |canvas| {
        let middle = NAMES + (width - NAMES - GAP) / 2;
        let title = "Rays per second, as a multiple of Embree's in the same round (one thread, one ray at a time; “many”: a batch)";
        figure::write(canvas, title, (middle, 48), text(44).pos(CENTRE))?;
        for (i, row) in (0..).zip(&structures) {
            let top = HEAD + ROW * i;
            if row.ours {
                let band = [(0, top), (width - GAP / 2, top + ROW)];
                canvas.draw(&Rectangle::new(band, SKY.mix(0.12).filled()))?;
            }
            figure::write(
                canvas,
                row.structure,
                (NAMES - 30, top + ROW / 2),
                text(38).pos(RIGHT),
            )?;
        }
        for (i, column) in (0..).zip(&columns) {
            let left = NAMES + (PANEL + GAP) * i;
            panel(canvas, left, column, &structures, &rows)?;
        }
        legend(canvas, &rows, (NAMES, height - FOOT + 146))?;
        for (i, line) in (0..).zip(how) {
            let at = (NAMES, height - FOOT + 216 + LINE * i);
            figure::write(canvas, line, at, text(26).pos(LEFT))?;
        }
        Ok(())
    })?;
    Ok(file::save(path, &image.pixels)?)
}

fn panel(canvas: &Canvas, left: i32, column: &str, structures: &[&Row], rows: &[&Row]) -> Drawn {
    let bottom = HEAD + ROW * structures.len() as i32;
    let x = |ratio: f64| {
        let part = (ratio.max(LEAST) / LEAST).ln() / (MOST / LEAST).ln();
        left + (f64::from(PANEL) * part.min(1.0)) as i32
    };
    figure::write(
        canvas,
        column,
        (left + PANEL / 2, HEAD - 44),
        text(40).pos(CENTRE),
    )?;
    for tick in TICKS {
        let (colour, wide) = if tick == 1.0 { (INK, 5) } else { (FAINT, 2) };
        let line = vec![(x(tick), HEAD), (x(tick), bottom)];
        canvas.draw(&PathElement::new(line, colour.stroke_width(wide)))?;
        let number = format!("{tick}");
        figure::write(
            canvas,
            &number,
            (x(tick), bottom + 32),
            text(32).pos(CENTRE),
        )?;
    }
    for row in rows.iter().filter(|row| row.column() == column) {
        let here = |other: &&Row| other.structure == row.structure;
        let (Some(i), Some(mesh)) = (
            structures.iter().position(here),
            MESHES.iter().position(|name| *name == row.mesh),
        ) else {
            continue;
        };
        // The meshes one under the other: they do not hide each other.
        let spread = (ROW - 24) * (2 * mesh as i32 + 1) / (2 * MESHES.len() as i32);
        let y = HEAD + ROW * i as i32 + 12 + spread;
        mark(canvas, mesh, (x(row.lap.ratios.median()), y))?;
    }
    Ok(())
}

fn legend(canvas: &Canvas, rows: &[&Row], (left, y): (i32, i32)) -> Drawn {
    let mut x = left;
    for (mesh, name) in MESHES.iter().enumerate() {
        if rows.iter().any(|row| row.mesh == *name) {
            mark(canvas, mesh, (x, y))?;
            figure::write(canvas, name, (x + 26, y), text(36).pos(LEFT))?;
            x += 250;
        }
    }
    Ok(())
}

fn mark(canvas: &Canvas, mesh: usize, (x, y): (i32, i32)) -> Drawn {
    let (colour, form) = MARKS[mesh % MARKS.len()];
    let polygon = |corners: &[(i32, i32)]| {
        let corners: Vec<_> = corners.iter().map(|(dx, dy)| (x + dx, y + dy)).collect();
        Polygon::new(corners, colour.filled())
    };
    match form {
        Form::Ring => canvas.draw(&Circle::new((x, y), 8, colour.stroke_width(5)))?,
        Form::Disc => canvas.draw(&Circle::new((x, y), 10, colour.filled()))?,
        Form::Square => canvas.draw(&polygon(&[(-9, -9), (9, -9), (9, 9), (-9, 9)]))?,
        Form::Up => canvas.draw(&polygon(&[(-11, 9), (0, -11), (11, 9)]))?,
        Form::Down => canvas.draw(&polygon(&[(-11, -9), (0, 11), (11, -9)]))?,
        Form::Cross => {
            for rise in [9, -9] {
                let line = vec![(x - 9, y - rise), (x + 9, y + rise)];
                canvas.draw(&PathElement::new(line, colour.stroke_width(5)))?;
            }
        }
        Form::Diamond => canvas.draw(&polygon(&[(-12, 0), (0, -12), (12, 0), (0, 12)]))?,
    }
    Ok(())
}
