//! Reconstruction filters: what a sample counts for a pixel, by its place.

use crate::image::rgb::Rgb;
use glam::Vec2;

/// A filter w(x, y) = f(x/r)·f(y/r), in pixels from the pixel's centre; 0 beyond its radius r along either axis.
#[derive(Clone, Copy, Debug)]
pub struct Filter {
    /// Its name, for figures.
    pub name: &'static str,
    /// r, in pixels.
    pub radius: f32,
    /// f, on [−1, 1). Its height does not matter: weights are divided by their sum.
    pub profile: fn(f32) -> f32,
}

impl Filter {
    /// All of a pixel's own samples alike, and no others.
    pub const BOX: Self = Self {
        name: "box",
        radius: 0.5,
        profile: |_| 1.0,
    };
    /// 1 − |t|: less, the farther away.
    pub const TENT: Self = Self {
        name: "tent",
        radius: 1.0,
        profile: |t| 1.0 - t.abs(),
    };
    /// A Gaussian bell of standard deviation r/3 = ½ pixel, lowered to end at 0.
    pub const GAUSSIAN: Self = Self {
        name: "Gaussian",
        radius: 1.5,
        profile: |t| (-4.5 * t * t).exp() - (-4.5_f32).exp(),
    };
    /// Mitchell's cubic: sharper than a bell, by weights below 0 beyond the next pixel's centre.
    pub const MITCHELL: Self = Self {
        name: "Mitchell",
        radius: 2.0,
        profile: |t| mitchell(2.0 * t),
    };
    /// All of them.
    pub const ALL: [Self; 4] = [Self::BOX, Self::TENT, Self::GAUSSIAN, Self::MITCHELL];

    /// What a sample counts that is so far from the pixel's centre.
    pub fn weight(&self, offset: Vec2) -> f32 {
        let t = offset / self.radius;
        // Half open: a sample between two pixels belongs to one of them.
        let inside = |t: f32| (-1.0..1.0).contains(&t);
        if inside(t.x) && inside(t.y) {
            (self.profile)(t.x) * (self.profile)(t.y)
        } else {
            0.0
        }
    }
}

/// The cubic filter with B = C = ⅓ (Mitchell and Netravali, "Reconstruction filters in computer graphics", 1988).
fn mitchell(x: f32) -> f32 {
    let x = x.abs();
    if x < 1.0 {
        ((7.0 * x - 12.0) * x * x + 16.0 / 3.0) / 6.0
    } else {
        (((-7.0 / 3.0 * x + 12.0) * x - 20.0) * x + 32.0 / 3.0) / 6.0
    }
}

/// What a ray saw, and where its pixel's centre was passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// From the pixel's centre, in pixels.
    pub offset: Vec2,
    /// What was seen there.
    pub radiance: Rgb,
}

// ANCHOR: pixel_average
/// The pixel's colour, Σ w L/Σ w: the average of the samples, each counted by the filter.
///
/// Black if they count nothing together.
pub fn pixel_average(filter: &Filter, samples: &[Sample]) -> Rgb {
    let (mut light, mut weights) = (Rgb::BLACK, 0.0);
    for sample in samples {
        let weight = filter.weight(sample.offset);
        light += sample.radiance * weight;
        weights += weight;
    }
    if weights == 0.0 {
        Rgb::BLACK
    } else {
        light / weights
    }
}
// ANCHOR_END: pixel_average
