//! The figure of rays that pass a black hole at many distances.

use super::simplified::simplified;
use crate::kit::figure::{CENTRE, Canvas, Figure, coloured, figure, write};
use crate::kit::palette::{BLUE, INK, VERMILION};
use crate::kit::sketch::label;
use crate::kit::stage::Drawn;
use glam::{DVec2, DVec3, dvec2, dvec3};
use plotters::element::{Circle, PathElement};
use plotters::prelude::{Color, WHITE};
use raybook::render::curved::follow::{Fate, follow};
use raybook::render::curved::geodesic::{between, geodesic_step};
use raybook::render::curved::{HORIZON, PHOTON_SPHERE, Photon};
use std::ops::ControlFlow;

/// Size of the figure in pixels, and of its canvas.
const SIZE: [u32; 2] = [960, 560];
const MIDDLE: DVec2 = DVec2::new(960.0, 560.0);

/// Pixels of the canvas per radius of the hole.
const SCALE: f64 = 96.0;

/// The x at which the rays begin, in radii of the hole.
const LEFT: f64 = -60.0;

/// Difference between the impact parameters of neighbouring rays, in radii of the hole; the first ray has half of it.
const APART: f64 = 0.4;

/// Points of the curve in each piece of a ray.
const FINE: u32 = 6;

/// Rays from the left, coloured by what becomes of them.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    figure(SIZE[0], SIZE[1], |canvas| {
        for i in 0..15 {
            let b = APART * (f64::from(i) + 0.5);
            for side in [-b, b] {
                ray(canvas, side)?;
            }
        }
        // The ray that goes around the hole: a hair outside the critical impact parameter.
        ray(canvas, 2.5981)?;
        let centre = pixel(MIDDLE);
        let radius = |r: f64| (SCALE * r) as i32;
        canvas.draw(&Circle::new(centre, radius(HORIZON), INK.filled()))?;
        let sphere = Circle::new(centre, radius(PHOTON_SPHERE), INK.stroke_width(3));
        canvas.draw(&sphere)?;
        write(canvas, "horizon", centre, coloured(33, WHITE).pos(CENTRE))?;
        let beside = MIDDLE + SCALE * dvec2(2.95, 0.0);
        label(canvas, beside.as_vec2(), "photon sphere", INK)
    })
}

/// One ray: blue if it escapes; if it falls, vermilion.
fn ray(canvas: &Canvas, b: f64) -> Drawn {
    let (points, fate) = path(b);
    let colour = if matches!(fate, Fate::Escaped(_)) {
        BLUE
    } else {
        VERMILION
    };
    // What is outside would be drawn along the edge.
    let inside = |p: &DVec3| p.x.abs() < MIDDLE.x / SCALE && p.y.abs() < MIDDLE.y / SCALE;
    let points: Vec<_> = points.into_iter().filter(inside).map(on_canvas).collect();
    let corners: Vec<_> = simplified(&points).into_iter().map(pixel).collect();
    canvas.draw(&PathElement::new(corners, colour.stroke_width(3)))?;
    Ok(())
}

/// The points of a ray from the left that a straight ray would take past the middle at the distance b, and its fate. If it falls, they go
/// down to the horizon.
pub(super) fn path(b: f64) -> (Vec<DVec3>, Fate) {
    let mut points = Vec::new();
    let mut last = Photon {
        x: dvec3(LEFT, b, 0.0),
        v: DVec3::X,
    };
    let fate = follow(last, 1e-8, |piece| {
        let share = |i| f64::from(i) / f64::from(FINE);
        points.extend((0..=FINE).map(|i| between(&piece.from, &piece.to, piece.step, share(i))));
        last = piece.to;
        ControlFlow::Continue(())
    });
    if !matches!(fate, Fate::Escaped(_)) {
        while last.x.length() > HORIZON {
            (last, _) = geodesic_step(last, 0.01);
            points.push(last.x);
        }
    }
    (points, fate)
}

/// A point's place on the canvas.
fn on_canvas(p: DVec3) -> DVec2 {
    MIDDLE + SCALE * dvec2(p.x, -p.y)
}

fn pixel(at: DVec2) -> (i32, i32) {
    (at.x.round() as i32, at.y.round() as i32)
}
