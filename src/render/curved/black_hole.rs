//! A black hole in front of the stars, with or without a disc of gas around it.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::curved::black_hole::BlackHole;
//!
//! let hole = BlackHole { disc: None, sky: &|_| Rgb::WHITE };
//! let eye = vec3(0.0, 0.0, 20.0);
//! assert_eq!(hole.radiance(eye, -Dir3::Z), Rgb::BLACK); // straight into the hole
//! assert_eq!(hole.radiance(eye, Dir3::X), Rgb::WHITE); // past it, to the sky
//! ```

use crate::image::rgb::Rgb;
use crate::math::dir3::Dir3;
use crate::render::curved::fan::Fan;
use crate::render::curved::follow::{Fate, Piece, follow};
use crate::render::curved::geodesic::between;
use crate::render::curved::{Photon, doppler::shift, observer};
use crate::scene::accretion_disc::AccretionDisc;
use glam::{DVec3, Vec3};
use std::fmt;
use std::ops::ControlFlow;

/// A black hole at the origin, and what is around it. Lengths are in radii of the hole.
pub struct BlackHole<'a> {
    /// The disc of gas, in the plane y = 0.
    pub disc: Option<&'a AccretionDisc>,
    /// The radiance of the sky by direction, infinitely far away.
    pub sky: &'a (dyn Fn(Dir3) -> Rgb + Sync),
}

impl fmt::Debug for BlackHole<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("BlackHole")
            .field("disc", &self.disc)
            .finish_non_exhaustive()
    }
}

/// The relative error that a step may have. Then what is seen moves by less than a thousandth of a radian, unless the ray has
/// gone around the hole.
const TOLERANCE: f64 = 1e-5;

impl BlackHole<'_> {
    /// The radiance that an observer at rest at `eye`, outside the horizon, sees in the direction `toward`.
    ///
    /// The ray is followed backwards, from the eye: light takes the same path in both directions.
    pub fn radiance(&self, eye: Vec3, toward: Dir3) -> Rgb {
        let start = observer::seen(eye.as_dvec3(), toward.as_dvec3());
        let mut seen = Layers::NONE;
        let fate = follow(start, TOLERANCE, |piece| {
            if let Some(at) = crossing(piece) {
                seen.add(self.gas(at, &start));
            }
            if seen.through > 0.0 {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
        match fate {
            Fate::Escaped(toward) => seen.before(self.sky, toward),
            Fate::Fell | Fate::Stopped => seen.light,
        }
    }

    /// As [`BlackHole::radiance`] for the eye of a [`Fan`], by the fan's curves: for a picture, which has far more rays than
    /// curves.
    pub fn radiance_by(&self, fan: &Fan, toward: Dir3) -> Rgb {
        let start = observer::seen(fan.eye().as_dvec3(), toward.as_dvec3());
        let ray = fan.ray(toward);
        let mut seen = Layers::NONE;
        if self.disc.is_some() {
            for at in ray.crossings(DVec3::Y) {
                seen.add(self.gas(at, &start));
            }
        }
        match ray.escapes() {
            Some(toward) => seen.before(self.sky, toward),
            None => seen.light,
        }
    }

    /// The radiance of the gas and its opacity where a ray crosses the plane of the disc; `None` where there is no gas.
    fn gas(&self, at: DVec3, start: &Photon) -> Option<(Rgb, f32)> {
        let disc = self.disc?;
        let r = at.length();
        if !disc.holds(r) {
            return None;
        }
        // The minus sign: the light runs towards the eye, against the ray.
        let axial = -start.x.cross(start.v).y / start.energy();
        let shift = shift(r, axial, start.x.length());
        Some(disc.glow(at.as_vec3(), shift as f32))
    }
}

/// The light along a ray, collected from front to back.
struct Layers {
    light: Rgb,
    /// The share of the light from behind that comes through.
    through: f32,
}

impl Layers {
    const NONE: Self = Self {
        light: Rgb::BLACK,
        through: 1.0,
    };

    fn add(&mut self, layer: Option<(Rgb, f32)>) {
        if let Some((glow, opacity)) = layer {
            self.light += glow * (self.through * opacity);
            self.through *= 1.0 - opacity;
        }
    }

    /// The radiance with the sky behind the layers.
    fn before(&self, sky: &(dyn Fn(Dir3) -> Rgb + Sync), toward: DVec3) -> Rgb {
        let toward = Dir3::new_or(toward.as_vec3(), Dir3::Y);
        self.light + sky(toward) * self.through
    }
}

/// The point where a piece of a ray crosses the plane y = 0, found by bisection; `None` if it does not.
fn crossing(piece: &Piece) -> Option<DVec3> {
    let above = |p: DVec3| p.y > 0.0;
    let at = |s| between(&piece.from, &piece.to, piece.step, s);
    if above(piece.from.x) == above(piece.to.x) {
        return None;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..24 {
        let middle = 0.5 * (low + high);
        if above(at(middle)) == above(piece.from.x) {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(at(low))
}
