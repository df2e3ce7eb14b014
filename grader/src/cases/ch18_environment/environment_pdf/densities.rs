//! Densities as students write them: with another solid angle for a texel, of another texel, or between texels.

use crate::Graded;
use crate::cases::ch18_environment::{OfMap, cell, toward};
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::light::environment::latlong;
use raybook_workbook::exercises::ch18_environment::{EnvironmentPdf, SampleEnvironment};
use std::f64::consts::PI;

/// What is asked of a question here.
pub(super) trait OfDensity {
    fn map(&self) -> SampleEnvironment;

    /// The texel of the direction: its column and its row.
    fn texel(&self) -> (usize, usize);

    /// The texel's share of the light, and its solid angle.
    fn share(&self) -> (f64, f64);
}

impl OfDensity for EnvironmentPdf {
    fn map(&self) -> SampleEnvironment {
        SampleEnvironment {
            width: self.width,
            height: self.height,
            texels: self.texels.clone(),
        }
    }

    fn texel(&self) -> (usize, usize) {
        let place = latlong::place(self.direction);
        (cell(place.x, self.width), cell(place.y, self.height))
    }

    fn share(&self) -> (f64, f64) {
        let (x, y) = self.texel();
        let share = self.map().share(x, y);
        (
            if share.is_nan() { 0.0 } else { share },
            self.map().solid_angle(y),
        )
    }
}

/// The density by the sine at one place in each row, where 0 is its upper edge and 1 its lower edge.
pub(super) fn by_sines(q: &EnvironmentPdf, place: f64) -> f32 {
    let (map, (x, y)) = (q.map(), q.texel());
    let sine = |row: usize| (PI * (row as f64 + place) / f64::from(q.height)).sin();
    let all = q.texels.iter().enumerate();
    let sum: f64 = all
        .map(|(i, t)| f64::from(*t) * sine(i / q.width as usize))
        .sum();
    let texel = 2.0 * PI * PI / f64::from(q.width * q.height);
    if sum > 0.0 {
        (map.texel(x, y) / (sum * texel)) as f32
    } else {
        0.0
    }
}

/// The density by the sine at the direction.
pub(super) fn by_own_sine(q: &EnvironmentPdf) -> f32 {
    let sine = f64::from(q.direction.x.hypot(q.direction.z)).max(1e-6);
    let on_map = q.share().0 * f64::from(q.width * q.height);
    (on_map / (2.0 * PI * PI * sine)) as f32
}

/// The right density in the middle of the texel's row, and elsewhere in inverse proportion to the sine at the direction.
pub(super) fn from_the_middle(q: &EnvironmentPdf) -> f32 {
    let sine = q.direction.x.hypot(q.direction.z).max(1e-6);
    let row = q.texel().1 as f32 + 0.5;
    let middle = (std::f32::consts::PI * row / q.height as f32).sin();
    EnvironmentPdf::right(q) * (middle / sine)
}

pub(super) fn is_at_pole(q: &EnvironmentPdf) -> bool {
    q.direction.x == 0.0 && q.direction.z == 0.0
}

/// The radiance at a place of the map, in between that of the four nearest texels' middles: columns go round, rows end.
pub(super) fn between(map: &SampleEnvironment, place: Vec2) -> f64 {
    let at = place * vec2(map.width as f32, map.height as f32) - 0.5;
    let [right, down] = (at - at.floor()).as_dvec2().to_array();
    let texel = |x: i32, y: i32| {
        let x = (at.x.floor() as i32 + x).rem_euclid(map.width as i32);
        let y = (at.y.floor() as i32 + y).clamp(0, map.height as i32 - 1);
        map.texel(x as usize, y as usize)
    };
    let row = |y: i32| (1.0 - right) * texel(0, y) + right * texel(1, y);
    (1.0 - down) * row(0) + down * row(1)
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

/// The right density, but for a black map.
pub(super) fn in_the_dark(q: &EnvironmentPdf, density: f32) -> f32 {
    if q.texels.iter().all(|t| *t == 0.0) {
        density
    } else {
        EnvironmentPdf::right(q)
    }
}

/// The density of the texel whose column or row, or both, are rounded.
pub(super) fn rounded(q: &EnvironmentPdf, columns: bool, rows: bool) -> f32 {
    let place = latlong::place(q.direction);
    let near = |v: f32, n: u32| ((v * n as f32).round() as usize).min(n as usize - 1);
    let (x, y) = q.texel();
    let x = if columns { near(place.x, q.width) } else { x };
    let y = if rows { near(place.y, q.height) } else { y };
    let map = q.map();
    let share = map.share(x, y);
    if share.is_nan() {
        0.0
    } else {
        (share / map.solid_angle(y)) as f32
    }
}

/// The density of the texel that is `right` columns to the right and `down` rows below: columns go round, rows end.
pub(super) fn neighbour(q: &EnvironmentPdf, right: i32, down: i32) -> f32 {
    let (x, y) = q.texel();
    let x = (x as i32 + right).rem_euclid(q.width as i32) as usize;
    let y = (y as i32 + down).clamp(0, q.height as i32 - 1) as usize;
    let map = q.map();
    let all = map.all_light();
    if all > 0.0 {
        (map.texel(x, y) / all) as f32
    } else {
        0.0
    }
}
