//! The rotated lattice, as it should be and as students write it: with other steps, turned by another angle or about another point.

use crate::upon::changed;
use glam::{Mat2, Vec2, mat2, vec2};
use raybook_workbook::exercises::ch22_antialiasing::RotatedGrid;
use std::f32::consts::FRAC_1_SQRT_2;

/// How the points of a lattice are found; one field wrong is a mistake. Lengths are in spacings, and places are told from the square's middle.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// The rotation, counter-clockwise …
    pub turn: Mat2,
    /// … or, which is as right, clockwise.
    pub is_clockwise: bool,
    /// The point, along both axes, about which is rotated.
    pub centre: f32,
    /// What is added to whole steps before the rotation …
    pub offset: Vec2,
    /// … and to places after it.
    pub after: Vec2,
    /// Whether a whole number of steps along each axis is taken.
    pub takes: fn(q: &RotatedGrid, step: Vec2) -> bool,
    /// Whether a point is kept that lies at `before` and then at `after`, where half of the square's side is `half`.
    pub keeps: fn(half: f32, before: Vec2, after: Vec2) -> bool,
    /// What becomes at last of a place in the unit square.
    pub ends: fn(place: Vec2) -> Vec2,
}

impl How {
    /// As it should be.
    fn well(q: &RotatedGrid) -> Self {
        Self {
            turn: mat2(vec2(2.0, 1.0), vec2(-1.0, 2.0)) / 5.0_f32.sqrt(),
            is_clockwise: false,
            centre: 0.0,
            offset: q.offset,
            after: Vec2::ZERO,
            takes: |_, _| true,
            keeps: |half, _, after| is_inside(after, half),
            ends: |place| place,
        }
    }

    /// Where a place comes to lie.
    fn turned(&self, place: Vec2) -> Vec2 {
        let turn = if self.is_clockwise {
            self.turn.transpose()
        } else {
            self.turn
        };
        self.centre + turn * (place - self.centre) + self.after
    }
}

/// The points in the square, rightly but for what is changed.
pub(super) fn points(q: &RotatedGrid, change: impl FnOnce(&mut How)) -> Vec<Vec2> {
    inside(q, &changed(How::well(q), change))
}

fn inside(q: &RotatedGrid, how: &How) -> Vec<Vec2> {
    let sense = if how.is_clockwise { -1.0 } else { 1.0 };
    // Steps that lead into the square are those around the one that leads to its middle.
    let first = -(how.offset + turned(how.turned(Vec2::ZERO), -sense)).floor();
    let taken = steps(q)
        .map(|step| first + step)
        .filter(|step| (how.takes)(q, *step));
    let before = taken.map(|step| step + how.offset);
    before
        .map(|before| (before, how.turned(before)))
        .filter(|(before, after)| (how.keeps)(half_of_side(q), *before, *after))
        .map(|(_, after)| (how.ends)(0.5 + q.spacing * after))
        .collect()
}

/// The same in a lattice that is turned clockwise.
pub(super) fn clockwise(q: &RotatedGrid, change: impl FnOnce(&mut How)) -> Vec<Vec2> {
    points(q, |how| {
        how.is_clockwise = true;
        change(how);
    })
}

/// One of the rotation's cosines has the wrong sign.
pub(super) fn one_cosine_wrong(how: &mut How) {
    how.turn = mat2(vec2(2.0, 1.0), vec2(-1.0, -2.0)) / 5.0_f32.sqrt();
}

/// ½ + spacing · f(i + offset.x, j + offset.y), all that may be in the square.
pub(super) fn lattice(q: &RotatedGrid, f: impl Fn(Vec2) -> Vec2) -> Vec<Vec2> {
    steps(q)
        .map(|step| 0.5 + q.spacing * f(step + q.offset))
        .collect()
}

/// As many whole steps along each axis as may lead into the square.
fn steps(q: &RotatedGrid) -> impl Iterator<Item = Vec2> {
    let reach = (1.0 / q.spacing).ceil() as i32 + 2;
    (-reach..=reach).flat_map(move |j| (-reach..=reach).map(move |i| vec2(i as f32, j as f32)))
}

/// Whether a place is in the square, half of whose side is `half` …
pub(super) fn is_inside(place: Vec2, half: f32) -> bool {
    place.cmpge(Vec2::splat(-half)).all() && place.cmplt(Vec2::splat(half)).all()
}

/// … before the rotation and after it.
pub(super) fn inside_twice(half: f32, before: Vec2, after: Vec2) -> bool {
    is_inside(before, half) && is_inside(after, half)
}

/// The steps that fit into half of the square's side, and one for what is left of it …
pub(super) fn to_half_of_side(q: &RotatedGrid, step: Vec2) -> bool {
    step.abs().max_element() <= half_of_side(q).ceil()
}

/// … without the last one, as a loop from −n to n leaves it out that ends before n …
pub(super) fn before_half_of_side(q: &RotatedGrid, step: Vec2) -> bool {
    to_half_of_side(q, step) && step.max_element() < half_of_side(q).ceil()
}

/// … or those only that fit in.
pub(super) fn within_half_of_side(q: &RotatedGrid, step: Vec2) -> bool {
    step.abs().max_element() <= half_of_side(q).floor()
}

/// The steps that fit into half of the square's diagonal.
pub(super) fn within_half_of_diagonal(q: &RotatedGrid, step: Vec2) -> bool {
    step.abs().max_element() <= (FRAC_1_SQRT_2 / q.spacing).floor()
}

/// The four steps around the origin.
pub(super) fn of_four(_q: &RotatedGrid, step: Vec2) -> bool {
    step.min_element() >= -1.0 && step.max_element() <= 0.0
}

/// A piece around the middle with as many steps along each side as fit into the square's.
pub(super) fn of_a_piece(q: &RotatedGrid, step: Vec2) -> bool {
    let along = (1.0 / q.spacing).round();
    let below = (0.5 * along).floor();
    step.min_element() >= -below && step.max_element() < along - below
}

/// Half of the square's side, in spacings.
pub(super) fn half_of_side(q: &RotatedGrid) -> f32 {
    0.5 / q.spacing
}

/// By arctan ½, counter-clockwise if `sense` is 1, clockwise if it is −1.
pub(super) fn turned(q: Vec2, sense: f32) -> Vec2 {
    vec2(2.0 * q.x - sense * q.y, sense * q.x + 2.0 * q.y) / 5.0_f32.sqrt()
}
