//! The plot of the deflection of light against its impact parameter.

use crate::kit::axis::Axis;
use crate::kit::chart::Chart;
use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, INK, ORANGE, VERMILION};
use glam::{DVec3, dvec3};
use plotters::prelude::Color;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use raybook::render::curved::deflection::deflection_angle;
use raybook::render::curved::follow::{Fate, follow};
use raybook::render::curved::{CRITICAL, Photon};
use std::ops::ControlFlow;

/// The impact parameters of the rays that are followed.
const FOLLOWED: [f64; 9] = [2.6, 2.65, 2.8, 3.2, 4.0, 6.0, 10.0, 20.0, 50.0];

/// Angle against impact parameter, both on logarithmic axes.
///
/// # Errors
/// What plotters reports.
pub fn draw() -> Figure {
    let parameters = Axis::log(2.0..100.0)
        .named("impact parameter b, in radii of the hole")
        .marks(&[2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0]);
    let angles = Axis::log(1.0..1000.0)
        .named("deflection")
        .format(|angle| format!("{angle:.0}°"));
    let mut chart = Chart::new(parameters, angles).text(32);
    let below = Pos::new(HPos::Left, VPos::Top);
    chart
        .line(
            [(CRITICAL, 1.0), (CRITICAL, 1000.0)],
            VERMILION.stroke_width(4),
        )
        .label(
            below,
            (2.68, 780.0),
            "b = 2.598: goes around for ever",
            VERMILION,
        );
    let weak = (0..=40).map(|i| {
        let b = 2.0 * 50.0_f64.powf(f64::from(i) / 40.0);
        (b, (2.0 / b).to_degrees())
    });
    chart
        .dashes(weak, ORANGE.stroke_width(5))
        .label(below, (2.08, 36.0), "2/b", INK);
    let curve = (0..=400).filter_map(|i| {
        let b = CRITICAL + 1e-7 * 1e9_f64.powf(f64::from(i) / 400.0);
        Some((b, deflection_angle(b)?.to_degrees()))
    });
    let dots = FOLLOWED
        .into_iter()
        .filter_map(|b| Some((b, followed(b)?.to_degrees())));
    chart
        .line(curve.filter(|(b, _)| *b < 100.0), BLUE.stroke_width(6))
        .dots(dots, 10, BLUE.filled())
        .label(below, (3.7, 80.0), "around a black hole", BLUE);
    chart.figure(960, 520)
}

/// The angle, in radians, by which a ray from far away is turned, followed step by step; `None` if the ray falls into the hole.
pub fn followed(b: f64) -> Option<f64> {
    let start = Photon {
        x: dvec3(-3e5, b, 0.0),
        v: DVec3::X,
    };
    let mut turned = 0.0;
    let fate = follow(start, 1e-10, |piece| {
        let (from, to) = (piece.from.v, piece.to.v);
        turned += from.cross(to).length().atan2(from.dot(to));
        ControlFlow::Continue(())
    });
    matches!(fate, Fate::Escaped(_)).then_some(turned)
}
