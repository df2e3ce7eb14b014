//! A small kit for drawings in a plane: lines, arrows, points, circles, areas and labels, fitted into an SVG file.

use glam::{DVec2, dvec2};
use maud::{Markup, html};

/// What a mark stands for. Its colour and its form say the same, so that either is enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ink {
    /// The ray, or what arrives.
    Ray,
    /// The distances that count.
    Interval,
    /// The shape that is asked about.
    Shape,
    /// The right answer.
    Right,
    /// The student's answer.
    Yours,
    /// What only helps to see.
    Guide,
}

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

#[derive(Clone, Debug)]
enum Mark {
    Line {
        points: Vec<DVec2>,
        ink: Ink,
        closed: bool,
    },
    Arrow {
        from: DVec2,
        to: DVec2,
        ink: Ink,
    },
    Point {
        at: DVec2,
        ink: Ink,
    },
    Circle {
        center: DVec2,
        radius: f64,
        ink: Ink,
    },
    Label {
        at: DVec2,
        beside: DVec2,
        text: String,
        ink: Ink,
    },
}

/// The picture's width, and the least and greatest height of what is drawn, in pixels.
const WIDTH: f64 = 760.0;
const HEIGHT: [f64; 2] = [180.0, 460.0];
/// Room around what is drawn, for labels.
const RIM: f64 = 58.0;
/// The height of a line of the key.
const LINE: f64 = 26.0;

impl Ink {
    /// Okabe and Ito's colours, which the colour-blind tell apart.
    fn colour(self) -> &'static str {
        match self {
            Self::Ray => "#282828",
            Self::Interval => "#56b4e9",
            Self::Shape => "#0072b2",
            Self::Right => "#009e73",
            Self::Yours => "#d55e00",
            Self::Guide => "#8a8a8a",
        }
    }

    fn width(self) -> f64 {
        match self {
            Self::Interval => 11.0,
            Self::Guide => 1.3,
            _ => 2.6,
        }
    }

    /// The dashes of its lines.
    fn dashes(self) -> &'static str {
        match self {
            Self::Yours => "9 5",
            Self::Guide => "3 4",
            _ => "none",
        }
    }

    /// What the key says of it; nothing of what has its label.
    fn meaning(self) -> &'static str {
        match self {
            Self::Ray => "the ray",
            Self::Interval => "the distances that count",
            Self::Right => "the right answer",
            Self::Yours => "your answer",
            Self::Shape | Self::Guide => "",
        }
    }
}

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
                role="img" aria-label=(self.title) font-family="system-ui, sans-serif" font-size="15" {
                title { (self.title) }
                rect width="100%" height="100%" fill="#ffffff" {}
                @for mark in &self.marks { (drawn(mark, &at, scale.x)) }
                @for lettering in self.letterings(&at) { (lettering.drawn()) }
                @for (i, ink) in key.iter().enumerate() {
                    (entry(*ink, dvec2(24.0 + 0.5 * WIDTH * (i % 2) as f64, height + LINE * (0.4 + (i / 2) as f64))))
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
        let mut seen = Vec::new();
        for mark in &self.marks {
            match mark {
                Mark::Line { points, .. } => seen.extend(points),
                Mark::Arrow { from, to, .. } => seen.extend([*from, *to]),
                Mark::Point { at, .. } | Mark::Label { at, .. } => seen.push(*at),
                Mark::Circle { center, radius, .. } => {
                    seen.extend([center - radius, center + radius]);
                }
            }
        }
        let least = seen.iter().copied().reduce(DVec2::min);
        let most = seen.iter().copied().reduce(DVec2::max);
        [least.unwrap_or(DVec2::ZERO), most.unwrap_or(DVec2::ONE)]
    }

    /// The inks that the key explains.
    fn key(&self) -> Vec<Ink> {
        let ink = |mark: &Mark| match mark {
            Mark::Line { ink, .. }
            | Mark::Arrow { ink, .. }
            | Mark::Point { ink, .. }
            | Mark::Circle { ink, .. }
            | Mark::Label { ink, .. } => *ink,
        };
        let mut inks: Vec<_> = self.marks.iter().map(ink).collect();
        inks.sort_unstable();
        inks.dedup();
        inks.retain(|ink| self.keyed && !ink.meaning().is_empty());
        inks
    }

    /// The labels, each inside of the picture, and moved off those before it.
    fn letterings(&self, at: &dyn Fn(DVec2) -> DVec2) -> Vec<Lettering<'_>> {
        let mut all: Vec<Lettering<'_>> = Vec::new();
        for mark in &self.marks {
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
            let mut lettering = Lettering {
                at: dvec2(x, p.y),
                width,
                text,
                ink: *ink,
            };
            // Upwards what stands above its point, else downwards.
            let step = if beside.y > 0.0 { -ROW } else { ROW };
            while all.iter().any(|other| lettering.meets(other)) {
                lettering.at.y += step;
            }
            all.push(lettering);
        }
        all
    }
}

/// A mark in pixels.
fn drawn(mark: &Mark, at: &dyn Fn(DVec2) -> DVec2, scale: f64) -> Markup {
    match mark {
        Mark::Line {
            points,
            ink,
            closed,
        } => {
            let points = points.iter().map(|p| at(*p));
            let points: Vec<_> = points
                .map(|p| format!("{},{}", round(p.x), round(p.y)))
                .collect();
            let fill = if *closed { ink.colour() } else { "none" };
            let opacity = if *ink == Ink::Interval { "0.45" } else { "1" };
            let path = format!("M{}{}", points.join(" L"), if *closed { " Z" } else { "" });
            html! { path d=(path) fill=(fill) fill-opacity="0.14" stroke=(ink.colour()) stroke-opacity=(opacity)
            stroke-width=(ink.width()) stroke-dasharray=(ink.dashes()) stroke-linejoin="round" {} }
        }
        Mark::Arrow { from, to, ink } => arrow(at(*from), at(*to), *ink),
        Mark::Point { at: p, ink } => point(at(*p), *ink),
        Mark::Circle {
            center,
            radius,
            ink,
        } => {
            let c = at(*center);
            html! { circle cx=(round(c.x)) cy=(round(c.y)) r=(round(radius * scale)) fill=(ink.colour()) fill-opacity="0.10"
            stroke=(ink.colour()) stroke-width=(ink.width()) stroke-dasharray=(ink.dashes()) {} }
        }
        // Labels are laid out together, over everything else.
        Mark::Label { .. } => html! {},
    }
}

/// About the width of a letter, and the height of a line of them, in pixels.
const LETTER: f64 = 7.6;
const ROW: f64 = 18.0;

/// A label in its place: the left end of its line, in pixels.
struct Lettering<'a> {
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

    fn drawn(&self) -> Markup {
        html! { text x=(round(self.at.x)) y=(round(self.at.y)) fill=(self.ink.colour()) stroke="#ffffff" stroke-width="4"
        paint-order="stroke" { (self.text) } }
    }
}

/// Words in lines that fit into the picture.
fn wrapped(text: &str) -> Vec<String> {
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

fn arrow(tail: DVec2, tip: DVec2, ink: Ink) -> Markup {
    let head = (13.0 * (tip - tail).normalize_or_zero()).clamp_length_max(tip.distance(tail));
    let neck = tip - head;
    let side = 0.42 * head.perp();
    let corners = [tip, neck + side, neck - side].map(|p| format!("{},{}", round(p.x), round(p.y)));
    html! {
        line x1=(round(tail.x)) y1=(round(tail.y)) x2=(round(neck.x)) y2=(round(neck.y)) stroke=(ink.colour()) stroke-width=(ink.width())
            stroke-dasharray=(ink.dashes()) {}
        polygon points=(corners.join(" ")) fill=(ink.colour()) {}
    }
}

fn point(p: DVec2, ink: Ink) -> Markup {
    if ink == Ink::Yours {
        let [x, y] = [round(p.x), round(p.y)];
        let path = format!("M{} {} l14 14 m0 -14 l-14 14", x - 7.0, y - 7.0);
        return html! { path d=(path) fill="none" stroke=(ink.colour()) stroke-width="3.5" {} };
    }
    let radius = if ink == Ink::Right { 6.5 } else { 4.5 };
    html! { circle cx=(round(p.x)) cy=(round(p.y)) r=(radius) fill=(ink.colour()) stroke="#ffffff" stroke-width="1.5" {} }
}

/// A line of the key.
fn entry(ink: Ink, at: DVec2) -> Markup {
    let (y, end) = (at.y - 5.0, at.x + 30.0);
    html! {
        @match ink {
            Ink::Interval => line x1=(at.x) y1=(y) x2=(end) y2=(y) stroke=(ink.colour()) stroke-opacity="0.45" stroke-width=(ink.width()) {},
            Ink::Ray => (arrow(dvec2(at.x, y), dvec2(end, y), ink)),
            _ => (point(dvec2(at.x + 15.0, y), ink)),
        }
        text x=(end + 10.0) y=(at.y) fill="#282828" { (ink.meaning()) }
    }
}

/// A tenth of a pixel is enough.
fn round(v: f64) -> f64 {
    (10.0 * v).round() / 10.0
}
