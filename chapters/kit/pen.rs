//! Pens: a colour, a dash and a mark, so that curves can be told apart in colour, in grey and by colour-blind people.

use crate::kit::figure::Canvas;
use crate::kit::stage::Drawn;
use plotters::prelude::{Circle, Color, PathElement, Polygon, RGBColor, WHITE};
use plotters::style::ShapeStyle;

/// What stands at the points of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Nothing.
    None,
    /// A disc.
    Disc,
    /// A regular polygon: its number of corners, and the angle of the first of them in degrees, from the right upwards.
    Corners(u8, i16),
    /// Two crossed lines, the first of them at an angle in degrees.
    Cross(i16),
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    /// Colour and width.
    pub stroke: ShapeStyle,
    /// Lengths of dashes and gaps in turns, in pixels; empty for a line without gaps.
    pub dash: &'static [f64],
    /// What stands at its points.
    pub mark: Mark,
    /// Whether a mark is filled, or a ring.
    pub filled: bool,
}

/// Radius of a mark, in pixels of the canvas.
const RADIUS: f64 = 10.0;

impl Pen {
    /// A line without gaps or marks.
    pub fn plain(stroke: ShapeStyle) -> Self {
        Self {
            stroke,
            dash: &[],
            mark: Mark::None,
            filled: true,
        }
    }

    /// Draws a line through pixels.
    ///
    /// # Errors
    /// What the backend reports.
    pub fn line(&self, canvas: &Canvas, through: &[(i32, i32)]) -> Drawn {
        if self.dash.is_empty() {
            canvas.draw(&PathElement::new(through.to_vec(), self.stroke))?;
            return Ok(());
        }
        for dash in dashes(through, self.dash) {
            canvas.draw(&PathElement::new(dash, self.stroke))?;
        }
        Ok(())
    }

    /// Draws the mark at a pixel.
    ///
    /// # Errors
    /// What the backend reports.
    pub fn mark(&self, canvas: &Canvas, at: (i32, i32)) -> Drawn {
        let colour = self.stroke.color;
        let rim = colour.stroke_width(4);
        let inside = if self.filled {
            colour.filled()
        } else {
            WHITE.filled()
        };
        let corner = |radius: f64, degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let (x, y) = (radius * cos, radius * sin);
            (at.0 + x.round() as i32, at.1 - y.round() as i32)
        };
        match self.mark {
            Mark::None => {}
            Mark::Disc => {
                canvas.draw(&Circle::new(at, RADIUS, inside))?;
                canvas.draw(&Circle::new(at, RADIUS, rim))?;
            }
            Mark::Corners(count, first) => {
                let turn = |i: u8| f64::from(first) + 360.0 * f64::from(i) / f64::from(count);
                let corners = |last| {
                    (0..last)
                        .map(|i| corner(1.25 * RADIUS, turn(i)))
                        .collect::<Vec<_>>()
                };
                canvas.draw(&Polygon::new(corners(count), inside))?;
                canvas.draw(&PathElement::new(corners(count + 1), rim))?;
            }
            Mark::Cross(first) => {
                for turn in [0, 90] {
                    let degrees = f64::from(first + turn);
                    let ends = [degrees, degrees + 180.0].map(|d| corner(1.25 * RADIUS, d));
                    canvas.draw(&PathElement::new(ends, colour.stroke_width(6)))?;
                }
            }
        }
        Ok(())
    }
}

/// A colour and a width as a pen without gaps or marks.
impl From<ShapeStyle> for Pen {
    fn from(stroke: ShapeStyle) -> Self {
        Self::plain(stroke)
    }
}

/// The pieces of a dashed line; `lengths` are those of its dashes and gaps in turns, in pixels.
fn dashes(through: &[(i32, i32)], lengths: &[f64]) -> Vec<Vec<(i32, i32)>> {
    let round = |(x, y): (f64, f64)| (x.round() as i32, y.round() as i32);
    let mut pieces = Vec::new();
    let mut piece: Vec<_> = through.first().copied().into_iter().collect();
    let (mut turn, mut left) = (0, lengths[0]);
    for ends in through.windows(2) {
        let [from, to] = [ends[0], ends[1]].map(|(x, y)| (f64::from(x), f64::from(y)));
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = dx.hypot(dy);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let at = round((from.0 + dx * done / length, from.1 + dy * done / length));
            if turn % 2 == 0 {
                piece.push(at);
                piece.dedup(); // a dash may end at a corner
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![at];
            }
            turn += 1;
            left = lengths[turn % lengths.len()];
        }
        left -= length - done;
        if turn % 2 == 0 {
            piece.push(ends[1]);
        }
    }
    if piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

/// The same colour, so light that it is behind everything.
pub fn pale(colour: RGBColor) -> ShapeStyle {
    colour.mix(0.35).stroke_width(16)
}
