//! The plot of the reflected fraction against the angle, into glass and out of glass.

use crate::kit::axis::Axis;
use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::{Canvas, Figure, LEFT, RIGHT, figure};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, VERMILION};
use crate::kit::stage::Drawn;
use plotters::prelude::{Color, RGBColor};
use raybook::material::fresnel::{fresnel, schlick};

/// From this angle on, in degrees, there is room for words at its left.
const ROOM: f32 = 43.0;

/// Points per degree.
const FINE: i32 = 8;

/// A curve: its name, colour, width, and its height by cos θ, n₁ and n₂.
type Curve = (&'static str, RGBColor, u32, fn(f32, f32, f32) -> f32);

const CURVES: [Curve; 3] = [
    ("Rs", BLUE, 5, |c, n1, n2| fresnel(c, n1, n2).s),
    ("Rp", VERMILION, 5, |c, n1, n2| fresnel(c, n1, n2).p),
    ("R = (Rs + Rp)/2", INK, 8, |c, n1, n2| {
        fresnel(c, n1, n2).unpolarised
    }),
];

/// Rs, Rp, R and Schlick's approximation from air into glass of an index of refraction, and out of it.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn plot(glass: f32) -> Figure {
    figure(1000, 470, |canvas| {
        let (into, out) = canvas.split_horizontally(1000);
        panel(&into, "from air into glass", 1.0, glass)?;
        panel(&out, "from glass into air", glass, 1.0)
    })
}

fn panel(canvas: &Canvas, title: &str, n1: f32, n2: f32) -> Drawn {
    let angles = Axis::linear(0.0_f32..90.0)
        .named("angle to the normal")
        .labels(10)
        .format(|angle| format!("{angle:.0}°"));
    let shares = Axis::linear(0.0_f32..1.04)
        .named("reflected share of the light")
        .format(|share| format!("{:.0} %", 100.0 * share));
    let mut chart = Chart::new(angles, shares).titled(title);
    let critical = (n2 < n1).then(|| (n2 / n1).asin().to_degrees());
    // Without a surface there is no such angle.
    let brewster = (n2 != n1).then(|| (n2 / n1).atan().to_degrees());
    // The words at the left of Brewster's angle stand above Rs, the highest curve.
    let above = |angle: f32| fresnel(angle.to_radians().cos(), n1, n2).s + 0.06;
    let height = brewster.filter(|_| n1 < n2).map_or(0.5, above).max(0.5);
    // A line up to a height with its name beside it, and a dot where the curve touches the axis.
    let marks = [
        (brewster, "Brewster's angle", 0.0, height),
        (critical, "critical angle", 1.0, 0.6),
    ];
    for (angle, name, share, top) in marks {
        let Some(angle) = angle else { continue };
        let words = format!("{name} {angle:.1}°");
        // At the side where there is room; at the right, beyond the critical angle, where the curves are above.
        let (end, at) = if angle < ROOM {
            (LEFT, angle.max(critical.unwrap_or(angle)) + 1.5)
        } else {
            (RIGHT, angle - 1.5)
        };
        chart
            .line([(angle, 0.0), (angle, top - 0.03)], FAINT.stroke_width(4))
            .label(end, (at, top), &words, INK)
            .dots([(angle, share)], 9, INK.filled());
    }
    let points = |height: fn(f32, f32, f32) -> f32| {
        (0..=90 * FINE).map(move |i| {
            let angle = i as f32 / FINE as f32;
            (angle, height(angle.to_radians().cos().max(0.0), n1, n2))
        })
    };
    for (name, colour, width, height) in CURVES {
        chart
            .line(points(height), colour.stroke_width(width))
            .named(name);
    }
    chart
        .dashes(points(schlick), GREEN.stroke_width(5))
        .named("Schlick's approximation");
    if n1 <= n2 {
        chart = chart.legend(Corner::UpperLeft);
    }
    chart.draw(canvas)
}
