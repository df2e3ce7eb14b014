//! All rays of one eye around a black hole, interpolated between a few that are followed.
//!
//! ```
//! use glam::dvec3;
//! use raybook::prelude::*;
//! use raybook::render::curved::fan::Fan;
//!
//! let fan = Fan::new(vec3(0.0, 0.0, 20.0), std::f64::consts::PI, 0.01);
//! assert!(fan.ray(-Dir3::Z).escapes().is_none()); // straight into the hole
//! let past = fan.ray(Dir3::X).escapes().expect("past the hole");
//! assert!(past.dot(dvec3(0.0, 0.0, -1.0)) > 0.0); // bent towards the hole
//! ```

use crate::math::dir3::Dir3;
use crate::render::curved::follow::{Fate, Piece, follow};
use crate::render::curved::geodesic::between;
use crate::render::curved::observer;
use glam::{DVec3, Vec3, dvec3};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

/// The rays of an observer at rest: one curve for each of a row of angles α to the direction of the hole.
///
/// The hole is symmetric. So all rays that leave the eye at the same angle α to the hole are one curve, turned around the line
/// from the eye to the hole. Curves are followed for equally spaced angles α, and rays between two curves are interpolated. At
/// the edge of the shadow, one of the two falls in and the other escapes: there the error of the angle is at most half of their
/// distance.
#[derive(Clone, Debug)]
pub struct Fan {
    eye: DVec3,
    /// Δα from one curve to the next, in radians.
    apart: f64,
    curves: Vec<Curve>,
}

/// A ray in its plane: the eye is at the angle φ = 0, and along the ray φ grows.
#[derive(Clone, Debug)]
struct Curve {
    /// 1/r at φ = 0, Δφ, 2Δφ, …, until the ray has fallen in or is far away.
    inverse_radii: Vec<f64>,
    /// The angle, in radians, from the direction of the eye to the direction in which the ray escapes; `None` if it falls in.
    escapes: Option<f64>,
}

/// Δφ, in radians. Linear interpolation of 1/r has a relative error of Δφ²/8, which is below 1e-4.
const STEP: f64 = TAU / 256.0;

/// Maximum number of steps Δφ that are stored: two turns. What a ray meets later would be a ring in the picture that is less than
/// a ten-thousandth as wide as the shadow.
const FARTHEST: usize = 512;

/// The relative error that a step along a curve may have.
const TOLERANCE: f64 = 1e-7;

/// The ray of a direction: it is in a plane through the hole, and interpolated between two curves of the fan.
#[derive(Clone, Copy, Debug)]
pub struct CurvedRay<'a> {
    /// The axes of the plane: from the hole to the eye, and perpendicular to it, to the side to which the ray leaves the eye.
    axes: [DVec3; 2],
    /// The two curves, the nearer one first.
    curves: [&'a Curve; 2],
    /// The share of the second curve.
    share: f64,
}

impl Fan {
    /// Follows curves for angles α from 0 to `widest` radians (at most π), not more than `apart` radians from each other.
    pub fn new(eye: Vec3, widest: f64, apart: f64) -> Self {
        let eye = eye.as_dvec3();
        let widest = widest.min(PI);
        let count = (widest / apart).ceil().max(1.0);
        let apart = widest / count;
        let curve = |i: u32| Curve::follow(eye.length(), apart * f64::from(i));
        Self {
            eye,
            apart,
            curves: (0..=count as u32).map(curve).collect(),
        }
    }

    /// Number of curves that were followed.
    pub fn curves(&self) -> usize {
        self.curves.len()
    }

    /// The observer's place, in radii of the hole.
    pub fn eye(&self) -> Vec3 {
        self.eye.as_vec3()
    }

    /// The ray that the observer sees in a direction.
    pub fn ray(&self, toward: Dir3) -> CurvedRay<'_> {
        let (toward, out) = (toward.as_dvec3(), self.eye.normalize());
        let aside = toward - toward.dot(out) * out;
        let place = aside.length().atan2(-toward.dot(out)) / self.apart;
        let last = self.curves.len() - 1;
        let nearest = (place.round() as usize).min(last);
        let other = if place < nearest as f64 {
            nearest.saturating_sub(1)
        } else {
            (nearest + 1).min(last)
        };
        CurvedRay {
            axes: [out, aside.normalize_or(out.any_orthonormal_vector())],
            curves: [nearest, other].map(|i| &self.curves[i]),
            share: (place - nearest as f64).abs(),
        }
    }
}

impl CurvedRay<'_> {
    /// The direction in which the ray escapes; `None` if it falls in.
    pub fn escapes(&self) -> Option<DVec3> {
        let angle = self.interpolated(|curve| curve.escapes)?;
        Some(self.at_angle(angle))
    }

    /// The points where the ray crosses the plane through the hole with this normal, in order, within two turns.
    pub fn crossings(&self, normal: DVec3) -> impl Iterator<Item = DVec3> {
        // a cos φ + b sin φ = 0 has one solution in every half turn.
        let [a, b] = self.axes.map(|axis| axis.dot(normal));
        let first = (-a).atan2(b).rem_euclid(PI);
        let angles = (0..).map(move |i| first + PI * f64::from(i));
        let end = FARTHEST as f64 * STEP;
        angles
            .take_while(move |angle| *angle < end)
            .filter_map(|angle| {
                let inverse_radius = self.interpolated(|curve| curve.inverse_radius(angle))?;
                Some(self.at_angle(angle) / inverse_radius)
            })
    }

    fn at_angle(&self, angle: f64) -> DVec3 {
        angle.cos() * self.axes[0] + angle.sin() * self.axes[1]
    }

    /// The value of `of`, interpolated between the two curves; that of the nearer curve if the other has none.
    fn interpolated(&self, of: impl Fn(&Curve) -> Option<f64>) -> Option<f64> {
        let [nearer, other] = self.curves;
        let value = of(nearer)?;
        Some(of(other).map_or(value, |other| value + self.share * (other - value)))
    }
}

impl Curve {
    fn follow(r: f64, angle: f64) -> Self {
        let start = observer::seen(r * DVec3::X, dvec3(-angle.cos(), angle.sin(), 0.0));
        let mut inverse_radii = vec![1.0 / r];
        let (mut swept, mut last) = (0.0, start);
        let fate = follow(start, TOLERANCE, |piece| {
            let to = swept + turn(piece.from.x, piece.to.x);
            while inverse_radii.len() <= FARTHEST && inverse_radii.len() as f64 * STEP <= to {
                let angle = inverse_radii.len() as f64 * STEP;
                inverse_radii.push(1.0 / radius(piece, angle));
            }
            (swept, last) = (to, piece.to);
            ControlFlow::Continue(())
        });
        Self {
            inverse_radii,
            escapes: matches!(fate, Fate::Escaped(_)).then(|| swept + turn(last.x, last.v)),
        }
    }

    fn inverse_radius(&self, angle: f64) -> Option<f64> {
        let place = angle / STEP;
        let i = place as usize;
        let (before, after) = (self.inverse_radii.get(i)?, self.inverse_radii.get(i + 1)?);
        Some(before + (place - i as f64) * (after - before))
    }
}

/// The angle from one vector in the plane z = 0 to another, counter-clockwise, in radians.
fn turn(from: DVec3, to: DVec3) -> f64 {
    from.cross(to).z.atan2(from.dot(to))
}

/// The radius r at which a piece of a curve crosses the angle φ = `angle`, found by bisection.
fn radius(piece: &Piece, angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let at = |s| between(&piece.from, &piece.to, piece.step, s);
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..24 {
        let middle = 0.5 * (low + high);
        let p = at(middle);
        if p.x * sin > p.y * cos {
            low = middle;
        } else {
            high = middle;
        }
    }
    at(low).length()
}
