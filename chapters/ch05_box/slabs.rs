//! A box in the plane as two slabs: a ray that hits it, a ray that misses it, and the intervals that decide.

use crate::kit::figure::{CENTRE, Canvas, Figure, LEFT, figure};
use crate::kit::palette::{BLUE, GREEN, INK, VERMILION};
use crate::kit::{axis::Axis, chart::Chart, stage::Drawn};
use glam::{Vec3, vec3};
use plotters::style::Color;
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray, slab};

/// The box; the diagram is in the plane z = 0.
const BOX: Aabb = Aabb {
    min: vec3(2.0, 1.0, -1.0),
    max: vec3(5.0, 3.0, 1.0),
};

/// What the diagram shows of the plane.
const VIEW: Aabb = Aabb {
    min: vec3(0.0, 0.0, 0.0),
    max: vec3(7.0, 4.0, 0.0),
};

/// The slabs' diagram: for a hit and a miss, the plane on the left and the ray's t axis on the right.
///
/// # Errors
/// If it cannot be drawn.
pub(super) fn diagram() -> Figure {
    figure(1000, 600, |canvas| {
        let (hit, miss) = canvas.split_vertically(600);
        draw_row(&hit, "A hit", vec3(0.0, 0.3, 0.0), vec3(1.0, 0.58, 0.0))?;
        draw_row(&miss, "A miss", vec3(0.0, 0.8, 0.0), vec3(1.0, 1.16, 0.0))
    })
}

fn draw_row(canvas: &Canvas, title: &str, origin: Vec3, toward: Vec3) -> Drawn {
    let ray = Ray::new(origin, Dir3::new_or(toward, Dir3::X));
    let (plane, axis) = canvas.split_horizontally(1060);
    draw_plane(&plane, title, &ray)?;
    draw_axis(&axis, &ray)
}

/// The slab along x or along y: the box without an end in the other directions.
fn slab_along(axis: usize) -> Aabb {
    let mut slab = Aabb::EVERYTHING;
    slab.min[axis] = BOX.min[axis];
    slab.max[axis] = BOX.max[axis];
    slab
}

/// The box, its slabs, the ray, and where the ray meets their planes.
fn draw_plane(canvas: &Canvas, title: &str, ray: &Ray) -> Drawn {
    let mut chart = Chart::new(
        Axis::linear(0.0..VIEW.max.x).hidden(),
        Axis::linear(0.0..VIEW.max.y).hidden(),
    )
    .titled(title);
    let (min, max) = (BOX.min, BOX.max);
    let box_around = [(min.x, min.y), (max.x, max.y)];
    chart
        .bar([(min.x, 0.0), (max.x, VIEW.max.y)], BLUE.mix(0.2).filled())
        .bar(
            [(0.0, min.y), (VIEW.max.x, max.y)],
            VERMILION.mix(0.2).filled(),
        )
        .bar(box_around, INK.stroke_width(4))
        .label(CENTRE, (0.5 * (min.x + max.x), 0.25), "x slab", BLUE)
        .label(CENTRE, (6.35, 2.0), "y slab", VERMILION);
    draw_arrow(&mut chart, ray);
    for (axis, colour) in [(0, BLUE), (1, VERMILION)] {
        if let Some(inside) = slab::clip(&slab_along(axis), ray, Interval::AHEAD) {
            let meets = [inside.min, inside.max].map(|t| ray.at(t));
            let seen = meets.into_iter().filter(|&p| VIEW.contains(p));
            chart.dots(seen.map(|p| (p.x, p.y)), 10, colour.filled());
        }
    }
    chart.draw(canvas)
}

/// The ray as an arrow, from its origin to where it leaves the view.
fn draw_arrow(chart: &mut Chart, ray: &Ray) {
    let end = slab::clip(&VIEW, ray, Interval::AHEAD).map_or(1.0, |inside| inside.max);
    let tip = ray.at(end - 0.15);
    let back = tip - 0.3 * *ray.direction;
    let side = 0.1 * vec3(-ray.direction.y, ray.direction.x, 0.0);
    let shaft = [ray.origin, back].map(|p| (p.x, p.y));
    let head = [tip, back + side, back - side].map(|p| (p.x, p.y));
    chart
        .line(shaft, INK.stroke_width(5))
        .area(head, INK.filled());
}

/// The t axis, and above it the interval of each slab, and of both.
fn draw_axis(canvas: &Canvas, ray: &Ray) -> Drawn {
    let mut chart = Chart::new(
        Axis::linear(0.0..8.0).named("t: distance along the ray, in metres"),
        Axis::linear(0.0..4.0).hidden(),
    )
    .left(20);
    let rows = [
        (3.0, "in the x slab", BLUE, slab_along(0)),
        (2.0, "in the y slab", VERMILION, slab_along(1)),
        (0.8, "in both: from t_near to t_far", GREEN, BOX),
    ];
    for (y, words, colour, bounds) in rows {
        let inside = slab::clip(&bounds, ray, Interval::AHEAD);
        let (words, from) = inside.map_or(("in both: never", 0.2), |inside| (words, inside.min));
        if let Some(Interval { min, max }) = inside {
            chart.bar([(min, y), (max, y + 0.35)], colour.filled());
        }
        chart.label(LEFT, (from, y + 0.6), words, colour);
    }
    chart.draw(canvas)
}
