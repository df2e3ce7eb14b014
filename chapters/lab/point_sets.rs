//! Patterns' points in the square, with the cells that some of them have.

use crate::kit::figure::{CENTRE, Canvas, text, write};
use crate::kit::palette::{BLUE, FAINT, INK};
use crate::kit::stage::Drawn;
use crate::lab::plot::Plot;
use crate::lab::subject::Subject;
use glam::{Vec2, vec2};
use plotters::prelude::{Circle, Color, PathElement, RGBColor, Rectangle};
use raybook::sample::pattern::{Pattern, multi_jittered, rows};
use std::fmt::Write;

/// Side of a square, of the space around it and of its title, in pixels of the canvas.
const SIDE: i32 = 420;
const GAP: i32 = 36;
const TITLE: i32 = 64;

/// Maximum number of cells along each side that are drawn: more would only be grey.
const FINEST: usize = 64;

/// Patterns with n points each.
#[derive(Debug)]
pub struct PointSets<'a> {
    /// The patterns.
    pub subjects: &'a [Subject],
    /// How many points.
    pub n: usize,
    /// How many squares side by side.
    pub columns: usize,
}

/// Lines along the cells, from point to point: strong ones, and faint ones.
fn strata(pattern: &Pattern, n: usize) -> Vec<(Vec2, Vec2, RGBColor)> {
    const PALE: RGBColor = RGBColor(226, 226, 226);
    let mut lines = Vec::new();
    let mut grid = |columns: usize, rows: usize, colour| {
        for i in 1..columns {
            let x = i as f32 / columns as f32;
            lines.push((vec2(x, 0.0), vec2(x, 1.0), colour));
        }
        for j in 1..rows {
            let y = j as f32 / rows as f32;
            lines.push((vec2(0.0, y), vec2(1.0, y), colour));
        }
    };
    let side = multi_jittered::columns(n);
    match pattern.name {
        "n-rooks" if n <= FINEST => grid(n, n, PALE),
        "multi-jittered" => {
            if n <= FINEST {
                grid(n, n, PALE);
            }
            grid(side, n / side, FAINT);
        }
        "sobol-owen" if n.is_power_of_two() => {
            grid(side, n / side, FAINT);
        }
        "regular-grid" | "jittered" => {
            let mut above = 0;
            for cells in rows::rows(n) {
                let (top, bottom) = (above as f32 / n as f32, (above + cells) as f32 / n as f32);
                for i in 1..cells {
                    let x = i as f32 / cells as f32;
                    lines.push((vec2(x, top), vec2(x, bottom), FAINT));
                }
                lines.push((vec2(0.0, bottom), vec2(1.0, bottom), FAINT));
                above += cells;
            }
        }
        _ => {}
    }
    lines
}

impl Plot for PointSets<'_> {
    fn size(&self) -> (u32, u32) {
        let rows = self.subjects.len().div_ceil(self.columns) as i32;
        let width = self.columns as i32 * (SIDE + GAP) + GAP;
        let height = rows * (SIDE + GAP + TITLE) + GAP / 2;
        (width as u32 / 2, height as u32 / 2)
    }

    fn draw(&self, canvas: &Canvas) -> Drawn {
        let radius = ((0.16 * f64::from(SIDE) / (self.n as f64).sqrt()) as i32).clamp(2, 12);
        for (i, subject) in (0..).zip(self.subjects) {
            let columns = self.columns as i32;
            let (left, top) = (
                GAP + i % columns * (SIDE + GAP),
                TITLE + i / columns * (SIDE + GAP + TITLE),
            );
            let place = |p: Vec2| {
                let on_canvas = p * SIDE as f32;
                (left + on_canvas.x as i32, top + on_canvas.y as i32)
            };
            let heading = (left + SIDE / 2, top - TITLE / 2);
            write(canvas, &subject.title, heading, text(48).pos(CENTRE))?;
            for (from, to, colour) in strata(&subject.pattern, self.n) {
                let line = vec![place(from), place(to)];
                canvas.draw(&PathElement::new(line, colour.stroke_width(2)))?;
            }
            let frame = Rectangle::new([place(Vec2::ZERO), place(Vec2::ONE)], INK.stroke_width(3));
            canvas.draw(&frame)?;
            for p in subject.points(self.n, 1) {
                canvas.draw(&Circle::new(place(p), radius, BLUE.filled()))?;
            }
        }
        Ok(())
    }

    fn csv(&self) -> String {
        let mut csv = "pattern,x,y\n".to_owned();
        for subject in self.subjects {
            for p in subject.points(self.n, 1) {
                let _ = writeln!(csv, "{},{},{}", subject.key, p.x, p.y);
            }
        }
        csv
    }
}
