//! A whole ray, in steps that are as long as the tolerance allows.
//!
//! ```
//! use glam::dvec3;
//! use raybook::render::curved::{Photon, follow::{Fate, follow}};
//! use std::ops::ControlFlow;
//!
//! let fate = |y| {
//!     let photon = Photon { x: dvec3(-50.0, y, 0.0), v: dvec3(1.0, 0.0, 0.0) };
//!     follow(photon, 1e-5, |_| ControlFlow::Continue(()))
//! };
//! assert_eq!(fate(2.0), Fate::Fell); // the critical impact parameter is 2.6
//! assert!(matches!(fate(4.0), Fate::Escaped(_)));
//! ```

use crate::render::curved::{HORIZON, PHOTON_SPHERE, Photon, geodesic::geodesic_step};
use glam::DVec3;
use std::ops::ControlFlow;

/// The end of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate {
    /// The ray falls into the hole, or circles it until the maximum number of steps is reached.
    Fell,
    /// The ray escapes, in this direction.
    Escaped(DVec3),
    /// The ray was stopped by `visit`.
    Stopped,
}

/// Two photons of a ray and the step dλ from one to the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// The photon where the step begins.
    pub from: Photon,
    /// The photon where the step ends.
    pub to: Photon,
    /// dλ: the length of the step.
    pub step: f64,
}

/// The radius from which an outward ray counts as escaped. If it has passed the hole at 10 radii or less, it would be bent by
/// less than 2e-4 radians more.
pub const FAR: f64 = 200.0;

/// Maximum number of steps. A ray that needs more circles the photon sphere, and counts as fallen.
const MOST_STEPS: usize = 100_000;

// ANCHOR: follow
/// Follows a ray until it falls in or escapes, or until `visit`, which gets each piece of the ray, returns `Break`.
///
/// A step whose estimated error is above `tolerance` (relative, see [`geodesic_step`]) is repeated with a shorter length. The
/// estimated error grows as the third power of the step. So the length of the next step is multiplied by ∛(tolerance/error), and
/// by 0.9 to be on the safe side.
///
/// No step is longer than a quarter of the radius. Inside the photon sphere, an inward ray is lost, because nothing there turns
/// it outwards. So no step crosses the horizon, where the coordinates end.
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
