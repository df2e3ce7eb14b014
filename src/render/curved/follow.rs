//! A whole ray, in steps as long as their error allows.

use crate::render::curved::{HORIZON, PHOTON_SPHERE, Photon, geodesic::geodesic_step};
use glam::DVec3;
use std::ops::ControlFlow;

/// What becomes of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate {
    /// It falls into the hole, or circles until nobody waits for it any longer.
    Fell,
    /// It gets away, in this direction.
    Escaped(DVec3),
    /// It was told to stop.
    Stopped,
}

/// Two photons of a ray and the step dλ from one to the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Where the step begins.
    pub from: Photon,
    /// Where it ends.
    pub to: Photon,
    /// Its length in λ.
    pub step: f64,
}

/// Beyond this radius a ray that leaves is bent by less than 2e-4 radians more, if it has passed the hole at 10 radii or less.
pub const FAR: f64 = 200.0;

/// A ray that needs more steps circles the photon sphere, and will do so for ever or fall.
const MOST_STEPS: usize = 100_000;

// ANCHOR: follow
/// Follows a ray until it falls or escapes, or `visit`, which sees each piece of it, breaks off.
///
/// A step whose estimated error is above the tolerance is made again, shorter. The error of a step grows with its third
/// power, so the next one is longer or shorter by ∛(tolerance/error), and a little less to be sure.
///
/// No step is longer than a quarter of the radius, and inside the photon sphere an inward ray is lost: nothing there turns it
/// back. So no step crosses the horizon, where the coordinates end.
pub fn follow(
    mut photon: Photon,
    tolerance: f64,
    mut visit: impl FnMut(&Piece) -> ControlFlow<()>,
) -> Fate {
    let far = FAR.max(2.0 * photon.x.length());
    let mut step = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let (r, speed) = (photon.x.length(), photon.v.length());
        let inward = photon.x.dot(photon.v) < 0.0;
        if r <= HORIZON || (inward && r < PHOTON_SPHERE) {
            return Fate::Fell;
        }
        if !inward && r > far {
            return Fate::Escaped(photon.v / speed);
        }
        step = step.min(0.25 * r / speed);
        let (to, error) = geodesic_step(photon, step);
        if error <= tolerance {
            let piece = Piece {
                from: photon,
                to,
                step,
            };
            if visit(&piece).is_break() {
                return Fate::Stopped;
            }
            photon = to;
        }
        step *= (0.9 * (tolerance / error).cbrt()).clamp(0.2, 4.0);
    }
    Fate::Fell
}
// ANCHOR_END: follow
