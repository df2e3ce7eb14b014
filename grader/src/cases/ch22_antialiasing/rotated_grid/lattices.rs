//! The rotated lattice, and lattices as students write them: with other steps, turned in the other sense or about another point.

use glam::{Vec2, vec2};
use raybook_workbook::exercises::ch22_antialiasing::RotatedGrid;
use std::f32::consts::FRAC_1_SQRT_2;

/// ½ + spacing · f(i + offset.x, j + offset.y), all that may be in the square.
pub(super) fn lattice(q: &RotatedGrid, f: impl Fn(Vec2) -> Vec2) -> Vec<Vec2> {
    let reach = (1.0 / q.spacing).ceil() as i32 + 2;
    let whole =
        (-reach..=reach).flat_map(|j| (-reach..=reach).map(move |i| vec2(i as f32, j as f32)));
    whole
        .map(|cell| 0.5 + q.spacing * f(cell + q.offset))
        .collect()
}

pub(super) fn inside(points: Vec<Vec2>) -> Vec<Vec2> {
    let keep = |p: &Vec2| p.cmpge(Vec2::ZERO).all() && p.cmplt(Vec2::ONE).all();
    points.into_iter().filter(keep).collect()
}

/// The points to which some steps along the lattice lead, of two whole numbers each, turned in a sense.
fn steps(q: &RotatedGrid, sense: f32, takes: impl Fn(Vec2) -> bool) -> Vec<Vec2> {
    let points = lattice(q, |p| {
        if takes((p - q.offset).round()) {
            turned(p, sense)
        } else {
            Vec2::INFINITY
        }
    });
    inside(points)
}

/// The lattice by its whole steps, turned in a sense, and moved after that by `by` spacings.
pub(super) fn moved(q: &RotatedGrid, sense: f32, by: Vec2) -> Vec<Vec2> {
    // A whole step along the lattice changes nothing.
    let steps = turned(by, -sense);
    inside(lattice(q, |p| {
        turned(p - q.offset + steps - steps.floor(), sense)
    }))
}

/// The points to which no more than `reach` steps along each axis of the lattice lead, turned in a sense.
pub(super) fn within_reach(q: &RotatedGrid, sense: f32, reach: f32) -> Vec<Vec2> {
    steps(q, sense, |step| step.abs().max_element() <= reach)
}

/// The same without the last step along each axis, as a loop from −n to n leaves it out that ends before n.
pub(super) fn without_last_step(q: &RotatedGrid, sense: f32, reach: f32) -> Vec<Vec2> {
    steps(q, sense, |step| {
        step.min_element() >= -reach && step.max_element() < reach
    })
}

/// Steps of the lattice that fit into half of the square's side, and a part of one.
pub(super) fn half_of_side(q: &RotatedGrid) -> f32 {
    0.5 / q.spacing
}

/// Whole steps of the lattice that fit into half of the square's diagonal.
pub(super) fn half_of_diagonal(q: &RotatedGrid) -> f32 {
    (FRAC_1_SQRT_2 / q.spacing).floor()
}

/// The points to which no negative steps along the lattice lead, turned in a sense.
pub(super) fn without_negative(q: &RotatedGrid, sense: f32) -> Vec<Vec2> {
    steps(q, sense, |step| step.min_element() >= 0.0)
}

/// The four points around i = j = 0, turned in a sense.
pub(super) fn four_points(q: &RotatedGrid, sense: f32) -> Vec<Vec2> {
    let cells = [[0.0, 0.0], [-1.0, 0.0], [0.0, -1.0], [-1.0, -1.0]];
    let place = |cell| 0.5 + q.spacing * turned(Vec2::from_array(cell) + q.offset, sense);
    inside(cells.map(place).to_vec())
}

/// The lattice, turned about the square's corner in a sense.
pub(super) fn about_corner(q: &RotatedGrid, sense: f32) -> Vec<Vec2> {
    let half = half_of_side(q);
    inside(lattice(q, |p| turned(p + half, sense) - half))
}

/// The points that are in the square before they are rotated about its middle, in a sense.
pub(super) fn inside_before(q: &RotatedGrid, sense: f32) -> Vec<Vec2> {
    let half = half_of_side(q);
    lattice(q, |p| {
        let is_inside = p.cmpge(Vec2::splat(-half)).all() && p.cmplt(Vec2::splat(half)).all();
        if is_inside {
            turned(p, sense)
        } else {
            Vec2::INFINITY
        }
    })
    .into_iter()
    .filter(|p| p.is_finite())
    .collect()
}

/// A piece of the rotated lattice around the middle, with as many points along each side as fit into the square's, each moved into the square by whole
/// sides of it.
pub(super) fn wrapped(q: &RotatedGrid) -> Vec<Vec2> {
    let along = (1.0 / q.spacing).round() as i32;
    let steps = -(along / 2)..along - along / 2;
    let cells = steps
        .clone()
        .flat_map(|j| steps.clone().map(move |i| vec2(i as f32, j as f32)));
    let place = |cell| 0.5 + q.spacing * turned(cell + q.offset, 1.0);
    cells.map(|cell| place(cell).fract_gl()).collect()
}

/// By arctan ½, counter-clockwise if `sense` is 1, clockwise if it is −1.
pub(super) fn turned(q: Vec2, sense: f32) -> Vec2 {
    vec2(2.0 * q.x - sense * q.y, sense * q.x + 2.0 * q.y) / 5.0_f32.sqrt()
}
