//! A small kit for drawings in a plane: lines, arrows, points, circles, areas and labels, fitted into an SVG file.

mod ink;
mod lettering;
mod mark;

pub use ink::Ink;

use glam::{DVec2, dvec2};
use lettering::{letterings, wrapped};
use mark::{Mark, drawn, entry};
use maud::html;

/// A drawing. Coordinates are those of what is drawn, with y upwards; the picture is fitted around them.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// What it shows, in a sentence: for those too who cannot see it.
    pub title: String,
    /// Whether a metre may be longer along one axis than along the other.
    pub stretched: bool,
    /// Whether a key says what the colours mean.
    pub keyed: bool,
    marks: Vec<Mark>,
}

/// The picture's width, and the least and greatest height of what is drawn, in pixels.
const WIDTH: f64 = 760.0;
const HEIGHT: [f64; 2] = [180.0, 460.0];
/// Room around what is drawn, for labels.
const RIM: f64 = 58.0;
/// The height of a line of the key.
const LINE: f64 = 26.0;

impl Diagram {
    /// A drawing with nothing in it yet.
    pub fn new(title: impl Into<String>) -> Self {
        let title = title.into();
        Self {
            title,
            stretched: false,
            keyed: true,
            marks: Vec::new(),
        }
    }

    /// A line through points.
    pub fn line(&mut self, points: &[DVec2], ink: Ink) {
        self.add(points, |points| Mark::Line {
            points: points.to_vec(),
            ink,
            closed: false,
        });
    }

    /// A polygon, filled lightly.
    pub fn area(&mut self, corners: &[DVec2], ink: Ink) {
        self.add(corners, |corners| Mark::Line {
            points: corners.to_vec(),
            ink,
            closed: true,
        });
    }

    /// An arrow.
    pub fn arrow(&mut self, from: DVec2, to: DVec2, ink: Ink) {
        self.add(&[from, to], |_| Mark::Arrow { from, to, ink });
    }

    /// A point: a disc; the student's is a cross.
    pub fn point(&mut self, at: DVec2, ink: Ink) {
        self.add(&[at], |_| Mark::Point { at, ink });
    }

    /// A circle.
    pub fn circle(&mut self, center: DVec2, radius: f64, ink: Ink) {
        self.add(&[center, dvec2(radius, 0.0)], |_| Mark::Circle {
            center,
            radius,
            ink,
        });
    }

    /// Words beside a point: to the side of it that `beside` names, which has y upwards.
    pub fn label(&mut self, at: DVec2, beside: DVec2, text: impl Into<String>, ink: Ink) {
        let text = text.into();
        self.add(&[at], |_| Mark::Label {
            at,
            beside,
            text,
            ink,
        });
    }

    /// Adds a mark, unless a student's answer has led it to where nothing can be drawn.
    fn add(&mut self, points: &[DVec2], mark: impl FnOnce(&[DVec2]) -> Mark) {
        /// Farther away is out of every picture.
        const FAR: f64 = 1e9;
        if points
            .iter()
            .all(|p| p.is_finite() && p.abs().max_element() < FAR)
        {
            self.marks.push(mark(points));
        }
    }

    /// The file's text.
    pub fn svg(&self) -> String {
        let [least, most] = self.bounds();
        let size = (most - least).max(DVec2::splat(1e-30));
        let room = dvec2(WIDTH, HEIGHT[1]) - 2.0 * RIM;
        let scale = if self.stretched {
            room / size
        } else {
            DVec2::splat((room / size).min_element())
        };
        let height = (size.y * scale.y + 2.0 * RIM).clamp(HEIGHT[0], HEIGHT[1]);
        let middle = 0.5 * (least + most);
        let at = |p: DVec2| 0.5 * dvec2(WIDTH, height) + (p - middle) * scale * dvec2(1.0, -1.0);
        let key = self.key();
        let scaled = if self.stretched {
            " (not to scale)"
        } else {
            ""
        };
        let title = wrapped(&format!("{}{scaled}", self.title));
        let whole =
            height + LINE * (key.len().div_ceil(2) as f64 + 0.6) + 20.0 * title.len() as f64;
        html! {
            svg xmlns="http://www.w3.org/2000/svg" viewBox={ "0 0 " (WIDTH) " " (round(whole)) } width=(WIDTH) height=(round(whole))
                style="max-width: 100%; height: auto" role="img" aria-label=(self.title) font-family="system-ui, sans-serif" font-size="15" {
                title { (self.title) }
                rect width="100%" height="100%" fill="#ffffff" {}
                @for mark in &self.marks { (drawn(mark, &at, scale.x)) }
                @for lettering in letterings(&self.marks, &at, height) { (lettering.drawn()) }
                @for (i, mark) in key.iter().enumerate() {
                    (entry(mark, dvec2(24.0 + 0.5 * WIDTH * (i % 2) as f64, height + LINE * (0.4 + (i / 2) as f64))))
                }
                @for (i, line) in title.iter().enumerate() {
                    text x="24" y=(round(whole - 12.0 - 20.0 * (title.len() - 1 - i) as f64)) fill="#444444" { (line) }
                }
            }
        }
        .into_string()
    }

    /// The corners of what is to be seen.
    fn bounds(&self) -> [DVec2; 2] {
        let seen: Vec<_> = self.marks.iter().flat_map(Mark::corners).collect();
        let least = seen.iter().copied().reduce(DVec2::min);
        let most = seen.iter().copied().reduce(DVec2::max);
        [least.unwrap_or(DVec2::ZERO), most.unwrap_or(DVec2::ONE)]
    }

    /// For each ink that the key explains a mark: what has a label needs no key, and so a point of the ray does not.
    fn key(&self) -> Vec<&Mark> {
        let is_labelled = |mark: &Mark| {
            matches!(mark, Mark::Label { .. }) || matches!(mark, Mark::Point { ink: Ink::Ray, .. })
        };
        let has_meaning = |mark: &&Mark| !mark.ink().meaning().is_empty() && !is_labelled(mark);
        let marks = self.marks.iter().filter(|_| self.keyed);
        let mut marks: Vec<_> = marks.filter(has_meaning).collect();
        marks.sort_by_key(|mark| mark.ink());
        marks.dedup_by_key(|mark| mark.ink());
        marks
    }
}

/// A tenth of a pixel is enough.
fn round(v: f64) -> f64 {
    (10.0 * v).round() / 10.0
}
