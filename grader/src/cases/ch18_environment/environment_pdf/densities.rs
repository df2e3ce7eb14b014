//! Densities as students write them: with another solid angle for a texel, of another texel, or between texels.

use crate::Graded;
use crate::cases::ch18_environment::{OfMap, cell, toward};
use crate::upon::changed;
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::light::environment::latlong;
use raybook::math::dir3::Dir3;
use raybook_workbook::exercises::ch18_environment::EnvironmentPdf;
use std::f64::consts::PI;

/// What else is asked of a question's map here.
pub(super) trait OfDensity {
    /// The texel of this number in the list; none behind its end.
    fn listed(&self, number: usize) -> Option<f64>;

    /// The solid angle of a texel by the sine at one place in the row, where 0 is its upper edge and 1 its lower edge.
    fn by_sine(&self, row: usize, place: f64) -> f64;

    /// What each texel has of something if all have as much.
    fn of_one(&self, whole: f64) -> f64;

    /// The light of a row.
    fn of_row(&self, row: usize) -> f64;
}

impl OfDensity for EnvironmentPdf {
    fn listed(&self, number: usize) -> Option<f64> {
        self.texels.get(number).copied().map(f64::from)
    }

    fn by_sine(&self, row: usize, place: f64) -> f64 {
        let sine = (PI * (row as f64 + place) / f64::from(self.height)).sin();
        self.of_one(2.0 * PI * PI) * sine
    }

    fn of_one(&self, whole: f64) -> f64 {
        whole / f64::from(self.width * self.height)
    }

    fn of_row(&self, row: usize) -> f64 {
        let texels = (0..self.width as usize).map(|x| self.texel(x, row));
        texels.sum::<f64>() * self.solid_angle(row)
    }
}

/// How a density is found; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// The place of a direction on the map.
    pub place: fn(direction: Dir3) -> Vec2,
    /// The column and the row of a place in [0, 1), of `n` …
    pub number: [fn(place: f32, n: u32) -> i32; 2],
    /// … and how many columns further to the right it is, which go round, …
    pub right: i32,
    /// … and how many rows further down, which end.
    pub down: i32,
    /// The radiance in a direction with this place and this texel.
    pub radiance: fn(q: &EnvironmentPdf, place: Vec2, texel: [usize; 2]) -> f64,
    /// What the radiance of a row's texels is multiplied by where they are chosen.
    pub weight: fn(q: &EnvironmentPdf, row: usize) -> f64,
    /// The solid angle by which a texel's probability is divided, if it is not its weight.
    pub area: Option<fn(q: &EnvironmentPdf, row: usize) -> f64>,
    /// What the radiance is divided by, if it is not the sum of all weighted radiance.
    pub whole: Option<fn(q: &EnvironmentPdf, row: usize) -> f64>,
    /// The density for a black map.
    pub dark: f32,
}

/// As it should be.
const WELL: How = How {
    place: latlong::place,
    number: [|place, n| cell(place, n) as i32; 2],
    right: 0,
    down: 0,
    radiance: |q, _, [x, y]| q.texel(x, y),
    weight: EnvironmentPdf::solid_angle,
    area: None,
    whole: None,
    dark: 0.0,
};

/// The density, rightly but for what is changed.
pub(super) fn density(q: &EnvironmentPdf, change: fn(&mut How)) -> f32 {
    let how = changed(WELL, change);
    let place = (how.place)(q.direction);
    let [column, row] = how.number;
    let x = (column(place.x, q.width) + how.right).rem_euclid(q.width as i32) as usize;
    let y = (row(place.y, q.height) + how.down).clamp(0, q.height as i32 - 1) as usize;
    let sum = || {
        let all = q.texels.iter().enumerate();
        let weighted = all.map(|(i, t)| f64::from(*t) * (how.weight)(q, i / q.width as usize));
        weighted.sum()
    };
    let whole = how.whole.map_or_else(sum, |whole| whole(q, y));
    if whole <= 0.0 {
        return how.dark;
    }
    let more = how.area.map_or(1.0, |area| (how.weight)(q, y) / area(q, y));
    ((how.radiance)(q, place, [x, y]) * more / whole) as f32
}

/// The solid angle of a texel by the sine at the direction.
pub(super) fn by_own_sine(q: &EnvironmentPdf, _row: usize) -> f64 {
    let sine = f64::from(q.direction.x.hypot(q.direction.z)).max(1e-6);
    q.of_one(2.0 * PI * PI) * sine
}

/// The column or the row by rounding.
pub(super) fn rounded(place: f32, n: u32) -> i32 {
    ((place * n as f32).round() as i32).min(n as i32 - 1)
}

/// The radiance in between that of the four nearest texels' middles: columns go round, rows end.
pub(super) fn between(q: &EnvironmentPdf, place: Vec2, _texel: [usize; 2]) -> f64 {
    let at = place * vec2(q.width as f32, q.height as f32) - 0.5;
    let [right, down] = (at - at.floor()).as_dvec2().to_array();
    let texel = |x: i32, y: i32| {
        let x = (at.x.floor() as i32 + x).rem_euclid(q.width as i32);
        let y = (at.y.floor() as i32 + y).clamp(0, q.height as i32 - 1);
        q.texel(x as usize, y as usize)
    };
    let row = |y: i32| (1.0 - right) * texel(0, y) + right * texel(1, y);
    (1.0 - down) * row(0) + down * row(1)
}

/// The radiance of a texel whose probability is that of its row times that of its column in the whole map.
pub(super) fn by_row_and_column(q: &EnvironmentPdf, _place: Vec2, [x, y]: [usize; 2]) -> f64 {
    let rows = 0..q.height as usize;
    let all: f64 = rows.clone().map(|row| q.of_row(row)).sum();
    let column = rows.map(|row| q.texel(x, row) * q.solid_angle(row));
    q.of_row(y) * column.sum::<f64>() / all / q.solid_angle(y)
}

/// The right density in the middle of the texel's row, and elsewhere in inverse proportion to the sine at the direction.
pub(super) fn from_the_middle(q: &EnvironmentPdf) -> f32 {
    let sine = q.direction.x.hypot(q.direction.z).max(1e-6);
    let row = cell(latlong::place(q.direction).y, q.height) as f32 + 0.5;
    let middle = (std::f32::consts::PI * row / q.height as f32).sin();
    EnvironmentPdf::right(q) * (middle / sine)
}

pub(super) fn is_at_pole(q: &EnvironmentPdf) -> bool {
    q.direction.x == 0.0 && q.direction.z == 0.0
}

/// The right density in a direction that is turned around +y, a quarter turn at a time.
pub(super) fn quarters(q: &EnvironmentPdf, turns: usize) -> f32 {
    let quarter = |d: Vec3| vec3(-d.z, d.y, d.x);
    let d = (0..turns).fold(*q.direction, |d, _| quarter(d));
    EnvironmentPdf::misread(q, |q| q.direction = toward(d.x, d.y, d.z))
}

/// A tenth of the mean of the texels.
pub(super) fn tenth(q: &EnvironmentPdf) -> f32 {
    0.1 * q.texels.iter().sum::<f32>() / q.texels.len() as f32
}
