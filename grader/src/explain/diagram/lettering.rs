//! Words in a drawing: labels that do not cover each other, and lines that fit.

use super::ink::Ink;
use super::mark::Mark;
use super::{WIDTH, round};
use glam::{DVec2, dvec2};
use maud::{Markup, html};

/// About the width of a letter, and the height of a line of them, in pixels.
const LETTER: f64 = 7.6;
const ROW: f64 = 18.0;

/// A label in its place: the left end of its line, in pixels.
pub struct Lettering<'a> {
    at: DVec2,
    width: f64,
    text: &'a str,
    ink: Ink,
}

impl Lettering<'_> {
    /// Whether two labels would cover each other.
    fn meets(&self, other: &Self) -> bool {
        let apart = other.at - self.at;
        apart.y.abs() < 0.9 * ROW && apart.x < self.width && -apart.x < other.width
    }

    /// The label as SVG.
    pub fn drawn(&self) -> Markup {
        html! { text x=(round(self.at.x)) y=(round(self.at.y)) fill=(self.ink.colour()) stroke="#ffffff" stroke-width="4"
        paint-order="stroke" { (self.text) } }
    }
}

/// The labels among some marks, inside of a picture of this height, and moved off those before them.
pub fn letterings<'a>(
    marks: &'a [Mark],
    at: &dyn Fn(DVec2) -> DVec2,
    height: f64,
) -> Vec<Lettering<'a>> {
    let mut all: Vec<Lettering<'_>> = Vec::new();
    for mark in marks {
        let Mark::Label {
            at: p,
            beside,
            text,
            ink,
        } = mark
        else {
            continue;
        };
        let width = LETTER * text.chars().count() as f64;
        let left = match beside.x {
            x if x > 0.3 => 0.0,
            x if x < -0.3 => width,
            _ => 0.5 * width,
        };
        let p = at(*p) + 13.0 * beside * dvec2(1.0, -1.0) + dvec2(-left, 5.0);
        let x = p.x.min(WIDTH - 6.0 - width).max(6.0);
        let placed = |y| Lettering {
            at: dvec2(x, y),
            width,
            text,
            ink: *ink,
        };
        // First upwards what stands above its point, else downwards; then to the other side.
        let step = if beside.y > 0.0 { -ROW } else { ROW };
        let (top, bottom) = (ROW, height - 6.0);
        let rows = 0..(height / ROW) as u32;
        let places = rows.flat_map(|i| [step, -step].map(|step| p.y + step * f64::from(i)));
        let mut inside = places.filter(|y| (top..=bottom).contains(y)).map(placed);
        let free = inside.find(|place| all.iter().all(|other| !place.meets(other)));
        // Where the picture is full of labels, two cover each other.
        all.push(free.unwrap_or_else(|| placed(p.y.clamp(top, bottom))));
    }
    all
}

/// Words in lines that fit into the picture.
pub fn wrapped(text: &str) -> Vec<String> {
    const LETTERS: usize = 92;
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) if line.chars().count() + word.chars().count() < LETTERS => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
