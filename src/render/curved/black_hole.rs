//! A black hole before the stars, with or without a disc of gas around it.

use crate::image::rgb::Rgb;
use crate::math::dir3::Dir3;
use crate::render::curved::follow::{Fate, Piece, follow};
use crate::render::curved::geodesic::between;
use crate::render::curved::{Photon, doppler::shift, observer};
use crate::scene::accretion_disc::AccretionDisc;
use glam::{DVec3, Vec3};
use std::fmt;
use std::ops::ControlFlow;

/// What there is to be seen around the hole.
pub struct BlackHole<'a> {
    /// The gas, in the plane y = 0.
    pub disc: Option<&'a AccretionDisc>,
    /// Radiance by direction, from infinitely far away.
    pub sky: &'a (dyn Fn(Dir3) -> Rgb + Sync),
}

impl fmt::Debug for BlackHole<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("BlackHole")
            .field("disc", &self.disc)
            .finish_non_exhaustive()
    }
}

/// Of a step. What is seen moves by less than a thousandth of a radian then, unless the ray has gone around the hole.
const TOLERANCE: f64 = 1e-5;

impl BlackHole<'_> {
    /// The radiance that an observer at rest sees, outside the horizon.
    ///
    /// The ray is followed backwards, from the eye: light takes the same way in both directions.
    pub fn radiance(&self, eye: Vec3, toward: Dir3) -> Rgb {
        let start = observer::seen(eye.as_dvec3(), toward.as_dvec3());
        let (mut light, mut through) = (Rgb::BLACK, 1.0);
        let fate = follow(start, TOLERANCE, |piece| {
            if let Some((glow, opacity)) = self.gas(piece, &start) {
                light += glow * (through * opacity);
                through *= 1.0 - opacity;
            }
            if through > 0.0 {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
        match fate {
            Fate::Escaped(toward) => {
                let toward = Dir3::new_or(toward.as_vec3(), Dir3::Y);
                light + (self.sky)(toward) * through
            }
            Fate::Fell | Fate::Stopped => light,
        }
    }

    /// The glow of the gas, and its opacity, where a piece of the ray passes through the disc.
    fn gas(&self, piece: &Piece, start: &Photon) -> Option<(Rgb, f32)> {
        let disc = self.disc?;
        let at = crossing(piece)?;
        let r = at.length();
        if !disc.holds(r) {
            return None;
        }
        // The light runs towards the eye, against the ray.
        let axial = -start.x.cross(start.v).y / start.energy();
        let shift = shift(r, axial, start.x.length());
        Some(disc.glow(at.as_vec3(), shift as f32))
    }
}

/// Where a piece of a ray passes through the plane y = 0: by halving.
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
