//! A picture of ratios: a panel for each kind of them, in it a row for each one that is compared, and in that a mark for each scene.

use plotters::element::{Circle, PathElement, Polygon, Rectangle};
use plotters::prelude::{Color, RGBColor};
use raybook::image::file;
use raybook_chapters::kit::figure::{self, CENTRE, Canvas, LEFT, RIGHT, figure, text, text_width};
use raybook_chapters::kit::palette::{BLUE, FAINT, GREEN, INK, ORANGE, PURPLE, SKY, VERMILION};
use raybook_chapters::kit::stage::Drawn;
use std::path::Path;

/// Sizes in pixels of the canvas, which is twice as wide and as high as the picture.
const NAMES: i32 = 470;
const GAP: i32 = 40;
const ROW: i32 = 84;
const HEAD: i32 = 190;
const FOOT: i32 = 320;
/// Minimum width of a panel, and of the picture, so that its title and the lines below the legend have room.
const PANEL: i32 = 500;
const WIDTH: i32 = 3000;
/// From one line below the legend to the next, and from the picture's edge to these lines.
const LINE: i32 = 36;
const MARGIN: i32 = 40;
/// Height of the letters of the title, of the legend, and of the numbers below a panel.
const TITLE: i32 = 44;
const LEGEND: i32 = 36;
const NUMBER: i32 = 32;

/// The least ratio that is drawn in its place: what is slower stands at the edge.
const LEAST: f64 = 0.02;
/// The ratios with a line and a number, where a panel reaches them.
const TICKS: [f64; 11] = [0.03, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 10.0, 25.0, 50.0, 100.0];
/// From the outermost marks to the edges of a panel, as a factor.
const ROOM: f64 = 1.15;

/// A colour and a form for each scene: either would do.
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

/// A ratio, and where it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Ratio {
    /// The name of its panel.
    pub panel: String,
    /// The name of its row.
    pub row: String,
    /// Whether the row is raybook's.
    pub ours: bool,
    /// The scene, by its place in [`Picture::scenes`].
    pub scene: usize,
    /// The ratio.
    pub ratio: f64,
    /// What it scatters between.
    pub spread: [f64; 2],
}

/// What a picture shows. Panels come in the order of the ratios, and so do rows, raybook's first.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// Above the panels.
    pub title: &'a str,
    /// The names of the scenes, each with a mark of its own.
    pub scenes: &'a [&'a str],
    /// What is drawn.
    pub ratios: &'a [Ratio],
    /// Lines below: the machine, and what the numbers are.
    pub how: &'a [String],
}

impl Picture<'_> {
    /// Draws it and writes it as PNG; nothing, if there is nothing to draw.
    ///
    /// # Errors
    /// If it cannot be drawn or written.
    pub fn write(&self, path: &Path) -> Drawn {
        let panels = names(self.ratios.iter().map(|ratio| &*ratio.panel));
        if panels.is_empty() {
            return Ok(());
        }
        let ours = self.ratios.iter().filter(|ratio| ratio.ours);
        let others = self.ratios.iter().filter(|ratio| !ratio.ours);
        let rows = names(ours.clone().chain(others).map(|ratio| &*ratio.row));
        let is_ours = |row: &str| ours.clone().any(|ratio| ratio.row == row);
        let across = panels.len() as i32;
        let panel = PANEL.max((WIDTH - NAMES) / across - GAP);
        let width = NAMES + (panel + GAP) * across;
        let bottom = HEAD + ROW * rows.len() as i32;
        let image = figure(width as u32 / 2, (bottom + FOOT) as u32 / 2, |canvas| {
            let middle = (width / 2, 48);
            figure::write(canvas, self.title, middle, text(TITLE).pos(CENTRE))?;
            for (row, top) in rows.iter().zip((HEAD..).step_by(ROW as usize)) {
                if is_ours(row) {
                    let band = [(0, top), (width - GAP / 2, top + ROW)];
                    canvas.draw(&Rectangle::new(band, SKY.mix(0.12).filled()))?;
                }
                let end = (NAMES - 30, top + ROW / 2);
                figure::write(canvas, row, end, text(38).pos(RIGHT))?;
            }
            for (i, name) in (0..).zip(&panels) {
                let left = NAMES + (panel + GAP) * i;
                self.panel(canvas, name, &rows, left..left + panel, bottom)?;
            }
            self.legend(canvas, (NAMES, bottom + 146))?;
            for (line, y) in self.how.iter().zip((bottom + 216..).step_by(LINE as usize)) {
                figure::write(canvas, line, (MARGIN, y), text(26).pos(LEFT))?;
            }
            Ok(())
        })?;
        Ok(file::save(path, &image.pixels)?)
    }

    fn panel(
        &self,
        canvas: &Canvas,
        name: &str,
        rows: &[&str],
        across: std::ops::Range<i32>,
        bottom: i32,
    ) -> Drawn {
        let middle = i32::midpoint(across.start, across.end);
        figure::write(canvas, name, (middle, HEAD - 44), text(40).pos(CENTRE))?;
        let all = || self.ratios.iter();
        // All panels have the same scale, which always has the 1 in it.
        let ends = || all().flat_map(|r| [r.ratio, r.spread[0], r.spread[1]]);
        let least = ends().fold(1.0, f64::min).max(LEAST) / ROOM;
        let most = ends().fold(1.0, f64::max) * ROOM;
        let x = |ratio: f64| {
            let part = (ratio.clamp(least, most) / least).ln() / (most / least).ln();
            across.start + (f64::from(across.end - across.start) * part) as i32
        };
        let mut free = i32::MIN; // from where on a number has room
        for tick in TICKS
            .into_iter()
            .filter(|tick| (least..most).contains(tick))
        {
            let (colour, wide) = if tick == 1.0 { (INK, 5) } else { (FAINT, 2) };
            let line = vec![(x(tick), HEAD), (x(tick), bottom)];
            canvas.draw(&PathElement::new(line, colour.stroke_width(wide)))?;
            let number = tick.to_string();
            let half = text_width(&number, NUMBER.into())? as i32 / 2;
            if x(tick) - half >= free {
                let at = (x(tick), bottom + 32);
                figure::write(canvas, &number, at, text(NUMBER).pos(CENTRE))?;
                free = x(tick) + half + 6;
            }
        }
        for ratio in all().filter(|ratio| ratio.panel == name) {
            let Some(row) = rows.iter().position(|row| *row == ratio.row) else {
                continue;
            };
            // The scenes one under the other: they do not hide each other.
            let part = (2 * ratio.scene as i32 + 1) * (ROW - 24) / (2 * self.scenes.len() as i32);
            let y = HEAD + ROW * row as i32 + 12 + part;
            let spread = ratio.spread.map(|end| (x(end), y)).to_vec();
            let (colour, _) = MARKS[ratio.scene % MARKS.len()];
            canvas.draw(&PathElement::new(spread, colour.stroke_width(3)))?;
            mark(canvas, ratio.scene, (x(ratio.ratio), y))?;
        }
        Ok(())
    }

    /// The marks and the names of the scenes that are drawn, if there are several.
    fn legend(&self, canvas: &Canvas, (mut x, y): (i32, i32)) -> Drawn {
        if self.scenes.len() < 2 {
            return Ok(());
        }
        for (scene, name) in self.scenes.iter().enumerate() {
            if self.ratios.iter().any(|ratio| ratio.scene == scene) {
                mark(canvas, scene, (x, y))?;
                figure::write(canvas, name, (x + 26, y), text(LEGEND).pos(LEFT))?;
                x += 100 + text_width(name, LEGEND.into())? as i32;
            }
        }
        Ok(())
    }
}

/// The names, each once, in the order in which they come.
fn names<'a>(all: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut names = Vec::new();
    for name in all {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

fn mark(canvas: &Canvas, scene: usize, (x, y): (i32, i32)) -> Drawn {
    let (colour, form) = MARKS[scene % MARKS.len()];
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
