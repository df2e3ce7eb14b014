//! Marks: lines, arrows, points, circles and labels, and their look in pixels.

use super::ink::Ink;
use super::round;
use glam::{DVec2, dvec2};
use maud::{Markup, html};

/// A mark of a drawing, in the drawing's own coordinates.
#[derive(Clone, Debug)]
pub enum Mark {
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

impl Mark {
    /// What it stands for.
    pub fn ink(&self) -> Ink {
        match self {
            Self::Line { ink, .. }
            | Self::Arrow { ink, .. }
            | Self::Point { ink, .. }
            | Self::Circle { ink, .. }
            | Self::Label { ink, .. } => *ink,
        }
    }

    /// Points between which it lies.
    pub fn corners(&self) -> Vec<DVec2> {
        match self {
            Self::Line { points, .. } => points.clone(),
            Self::Arrow { from, to, .. } => vec![*from, *to],
            Self::Point { at, .. } | Self::Label { at, .. } => vec![*at],
            Self::Circle { center, radius, .. } => vec![center - radius, center + radius],
        }
    }
}

/// A mark as SVG, where `at` says the place of a point in pixels.
pub fn drawn(mark: &Mark, at: &dyn Fn(DVec2) -> DVec2, scale: f64) -> Markup {
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

/// A line of the key: what stands for an ink, in the form of this mark.
pub fn entry(mark: &Mark, at: DVec2) -> Markup {
    let ink = mark.ink();
    let (y, end) = (at.y - 5.0, at.x + 30.0);
    let (from, to) = (dvec2(at.x, y), dvec2(end, y));
    let form = match mark {
        Mark::Arrow { .. } => Mark::Arrow { from, to, ink },
        Mark::Line { .. } | Mark::Circle { .. } => Mark::Line {
            points: vec![from, to],
            ink,
            closed: false,
        },
        Mark::Point { .. } | Mark::Label { .. } => Mark::Point {
            at: 0.5 * (from + to),
            ink,
        },
    };
    html! {
        (drawn(&form, &|p| p, 1.0))
        text x=(end + 10.0) y=(at.y) fill="#282828" { (ink.meaning()) }
    }
}
