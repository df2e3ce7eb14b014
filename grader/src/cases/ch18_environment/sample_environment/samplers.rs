//! Samplers of directions as students write them: texels are chosen by another weight or from one list, and directions point to other places in
//! them.

use crate::Graded;
use crate::cases::ch18_environment::{OfMap, cell, toward};
use glam::{Vec2, Vec3};
use raybook::light::environment::latlong;
use raybook::math::piecewise::Piecewise;
use raybook_workbook::exercises::ch17_rendering_equation::lattice;
use raybook_workbook::exercises::ch18_environment::{POINTS, SampleEnvironment};

/// What is asked of a question here.
pub(super) trait Asked {
    /// The directions of a sampler that goes by rows, then by columns.
    ///
    /// `weight` is what a texel counts for when its row is chosen and when it is chosen in the row; `cosine` places the
    /// direction between the cosines of the row's edges.
    fn sampled(
        &self,
        weight: fn(&Self, usize, usize) -> f64,
        cosine: fn(f64, f64, f64) -> f64,
    ) -> Vec<Vec3>;
}

impl Asked for SampleEnvironment {
    fn sampled(
        &self,
        weight: fn(&Self, usize, usize) -> f64,
        cosine: fn(f64, f64, f64) -> f64,
    ) -> Vec<Vec3> {
        let (width, height) = (self.width as usize, self.height as usize);
        let columns: Vec<_> = (0..height)
            .map(|y| Piecewise::new((0..width).map(|x| weight(self, x, y))))
            .collect();
        let rows = Piecewise::new(columns.iter().map(Piecewise::total));
        let direction = |u: Vec2| {
            let row = rows.choose(u.y)?;
            let column = columns[row.cell].choose(u.x)?;
            let [top, bottom] = [row.cell, row.cell + 1].map(|row| latlong::cosine(row, height));
            let turn = (column.cell as f32 + column.within) / width as f32;
            let cosine = cosine(top, bottom, f64::from(row.within));
            Some(*latlong::toward(turn, cosine))
        };
        lattice(POINTS).filter_map(direction).collect()
    }
}

pub(super) fn by_solid_angle(top: f64, bottom: f64, within: f64) -> f64 {
    top + (bottom - top) * within
}

pub(super) fn by_angle(top: f64, bottom: f64, within: f64) -> f64 {
    (top.acos() + (bottom.acos() - top.acos()) * within).cos()
}

/// The sine of the angle from +y at a place in a row, from 0 at its upper edge to 1 at its lower one.
pub(super) fn sine(q: &SampleEnvironment, row: usize, place: f64) -> f64 {
    let angle = std::f64::consts::PI * (row as f64 + place) / f64::from(q.height);
    angle.sin().abs()
}

/// The sine at (y + 1)/(height + 1) of the way from pole to pole.
pub(super) fn sine_without_ends(q: &SampleEnvironment, row: usize) -> f64 {
    let way = (row + 1) as f64 / f64::from(q.height + 1);
    (std::f64::consts::PI * way).sin()
}

/// The sine at y/(height − 1) of the way from pole to pole.
pub(super) fn sine_from_end_to_end(q: &SampleEnvironment, row: usize) -> f64 {
    let way = row as f64 / f64::from(q.height.max(2) - 1);
    (std::f64::consts::PI * way).sin().abs()
}

/// What a texel counts for, if something is added to the radiance of each.
pub(super) fn raised(q: &SampleEnvironment, x: usize, y: usize, by: f64) -> f64 {
    (q.texel(x, y) + by) * q.solid_angle(y)
}

/// What a texel counts for, if no radiance is above a limit.
pub(super) fn cut_off(q: &SampleEnvironment, x: usize, y: usize, limit: f64) -> f64 {
    q.texel(x, y).min(limit) * q.solid_angle(y)
}

/// What a texel counts for, if the light of none is above this share of all light.
pub(super) fn of_whole(q: &SampleEnvironment, x: usize, y: usize, share: f64) -> f64 {
    q.light(x, y).min(share * q.all_light())
}

/// The light of a row.
pub(super) fn of_row(q: &SampleEnvironment, y: usize) -> f64 {
    (0..q.width as usize).map(|x| q.light(x, y)).sum()
}

/// A column and a row, and the shares of the way to the right and of the area downwards in that texel.
pub(super) type Place = ([usize; 2], [f32; 2]);

/// The right directions, each in another texel or at another place in its texel. `change` says so of column and row, and of the shares of the
/// way to the right and of the area downwards.
pub(super) fn elsewhere(
    q: &SampleEnvironment,
    change: fn(&SampleEnvironment, [usize; 2], [f32; 2]) -> Place,
) -> Vec<Vec3> {
    let moved = |d: &Vec3| {
        let place = latlong::place(toward(d.x, d.y, d.z));
        let (x, y) = (cell(place.x, q.width), cell(place.y, q.height));
        let [top, bottom] = edges(q, y);
        let down = (top - f64::from(d.y)) / (top - bottom);
        let right = place.x * q.width as f32 - x as f32;
        direction(q, change(q, [x, y], [right, down as f32]))
    };
    SampleEnvironment::right(q).iter().map(moved).collect()
}

/// The cosines of the angles from +y at a row's upper and lower edge.
fn edges(q: &SampleEnvironment, row: usize) -> [f64; 2] {
    [row, row + 1].map(|row| latlong::cosine(row, q.height as usize))
}

/// The direction to a place in a texel.
pub(super) fn direction(q: &SampleEnvironment, ([x, y], [right, down]): Place) -> Vec3 {
    let [top, bottom] = edges(q, y);
    let cosine = by_solid_angle(top, bottom, f64::from(down));
    *latlong::toward((x as f32 + right) / q.width as f32, cosine)
}

/// The directions of a sampler that has all texels in one list. `place` is made of the number of the texel that u.x chooses, of the
/// share of it that is left, and of u.
pub(super) fn in_one_list(
    q: &SampleEnvironment,
    place: fn(&SampleEnvironment, usize, f32, Vec2) -> Place,
) -> Vec<Vec3> {
    listed(q, SampleEnvironment::light, place)
}

/// The same, where `weight` is what a texel counts for.
pub(super) fn listed(
    q: &SampleEnvironment,
    weight: fn(&SampleEnvironment, usize, usize) -> f64,
    place: fn(&SampleEnvironment, usize, f32, Vec2) -> Place,
) -> Vec<Vec3> {
    let width = q.width as usize;
    let weights = (0..q.texels.len()).map(|i| weight(q, i % width, i / width));
    let list = Piecewise::new(weights);
    let chosen = |u: Vec2| {
        let texel = list.choose(u.x)?;
        Some(direction(q, place(q, texel.cell, texel.within, u)))
    };
    lattice(POINTS).filter_map(chosen).collect()
}

/// The place in a texel of the list by what is left of the number that chose it, from left to right, and by the other number, from top to bottom.
pub(super) fn rest_of_number(q: &SampleEnvironment, texel: usize, left: f32, u: Vec2) -> Place {
    (in_rows(q, texel), [left, u.y])
}

/// The column and the row of a texel of the list.
pub(super) fn in_rows(q: &SampleEnvironment, texel: usize) -> [usize; 2] {
    let width = q.width as usize;
    [texel % width, texel / width]
}
