//! Directions to a spherical light, as the mistakes of `sample_sphere_light` choose them.

use super::sample_sphere_light::distance;
use super::{crossed, lattice, unless_near};
use crate::Graded;
use glam::{Vec2, Vec3, vec3};
use raybook::math::{basis::Basis, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, sphere::Sphere};
use raybook_workbook::exercises::ch16_soft_shadows::{Chosen, SampleSphereLight};
use std::f32::consts::{PI, TAU};

/// 1 − cos α of the cone in which the light is seen.
pub(super) fn cap(q: &SampleSphereLight) -> f32 {
    let squared = (q.radius / q.at.distance(q.center)).powi(2);
    if squared < 1.0 { rise(squared) } else { 2.0 }
}

/// 1 − cos α of sin²α, 1 at most, without a difference of two numbers that are nearly the same.
pub(super) fn rise(squared_sine: f32) -> f32 {
    squared_sine / (1.0 + (1.0 - squared_sine).max(0.0).sqrt())
}

/// Directions around the light's by 1 − cos θ and φ, with a density, from u and 1 − cos α.
pub(super) fn cone(
    q: &SampleSphereLight,
    choose: impl Fn(Vec2, f32) -> (f32, f32, f32),
) -> Vec<Chosen> {
    around(q, Dir3::new_or(q.center - q.at, Dir3::Y), choose)
}

/// The same around another axis.
pub(super) fn around(
    q: &SampleSphereLight,
    axis: Dir3,
    choose: impl Fn(Vec2, f32) -> (f32, f32, f32),
) -> Vec<Chosen> {
    seen_around(q, axis, &choose)
}

fn seen_around(
    q: &SampleSphereLight,
    axis: Dir3,
    choose: &dyn Fn(Vec2, f32) -> (f32, f32, f32),
) -> Vec<Chosen> {
    let (basis, cap) = (Basis::around(axis), cap(q));
    let light = Sphere::new(q.center, q.radius);
    let chosen = |u: Vec2| {
        let (height, phi, pdf) = choose(u, cap);
        let sine = (height * (2.0 - height)).max(0.0).sqrt();
        let toward = vec3(sine * phi.cos(), sine * phi.sin(), 1.0 - height);
        let toward = Dir3::new_or(basis.to_world(toward), axis);
        let hit = light.hit(&Ray::new(q.at, toward), Interval::AHEAD);
        let distance = hit.map_or(q.at.distance(q.center), |hit| hit.t);
        Chosen {
            toward: *toward,
            distance,
            pdf,
            arriving: q.radiance / pdf,
        }
    };
    lattice(q.n).map(chosen).collect()
}

/// From outside, places on the disc through the centre across the axis, with a density made of cos θ and πr²/d².
pub(super) fn on_disc(q: &SampleSphereLight, pdf: fn(f32, f32) -> f32) -> Vec<Chosen> {
    let squared = (q.radius / q.at.distance(q.center)).powi(2);
    if squared >= 1.0 {
        return SampleSphereLight::right(q);
    }
    cone(q, |u, _| {
        let cosine = (1.0 + squared * u.x).sqrt().recip();
        (1.0 - cosine, TAU * u.y, pdf(cosine, PI * squared))
    })
}

/// The cone's angle α, of 1 − cos α.
pub(super) fn angle(cap: f32) -> f32 {
    2.0 * (0.5 * cap).sqrt().asin()
}

/// Directions whose θ² is uniform, as if the cone were a flat disc with the radius α; with a density made of 1 − cos α.
pub(super) fn as_on_disc(q: &SampleSphereLight, pdf: fn(f32) -> f32) -> Vec<Chosen> {
    cone(q, |u, cap| {
        let half = 0.5 * u.x.sqrt() * angle(cap);
        (2.0 * half.sin().powi(2), TAU * u.y, pdf(cap))
    })
}

/// Places on a cap of the sphere around an axis, of this height in radii, with the density of uniform ones.
pub(super) fn on_cap(q: &SampleSphereLight, axis: Dir3, height: f32) -> Vec<Chosen> {
    let basis = Basis::around(axis);
    let place = |u: Vec2| {
        let cosine = 1.0 - height * u.x;
        let across = (1.0 - cosine * cosine).max(0.0).sqrt();
        let local = (across * Vec2::from_angle(TAU * u.y)).extend(cosine);
        let normal = basis.to_world(local);
        let r = q.center + q.radius * normal - q.at;
        let area = TAU * height * q.radius * q.radius;
        let seen = area * r.normalize_or_zero().dot(normal).abs();
        let pdf = r.length_squared() / seen.max(1e-6);
        Chosen {
            toward: r.normalize_or_zero(),
            distance: r.length(),
            pdf,
            arriving: q.radiance / pdf,
        }
    };
    lattice(q.n).map(place).collect()
}

/// The right answer with another sine of the angle between a direction and the axis than its cosine has.
pub(super) fn with_sine(q: &SampleSphereLight, sine: fn(f32) -> f32) -> Vec<Chosen> {
    let axis = *Dir3::new_or(q.center - q.at, Dir3::Y);
    let mut all = SampleSphereLight::right(q);
    for chosen in &mut all {
        let cosine = chosen.toward.dot(axis);
        let across = (chosen.toward - cosine * axis).normalize_or_zero();
        chosen.toward = sine(cosine) * across + cosine * axis;
    }
    all
}

/// The right answer with another density of each sample, made of its height 1 − cos θ.
pub(super) fn dense(q: &SampleSphereLight, pdf: impl Fn(f32) -> f32) -> Vec<Chosen> {
    let axis = Dir3::new_or(q.center - q.at, Dir3::Y);
    let mut all = SampleSphereLight::right(q);
    for chosen in &mut all {
        chosen.pdf = pdf(0.5 * chosen.toward.distance_squared(*axis));
        chosen.arriving = q.radiance / chosen.pdf;
    }
    all
}

/// Directions around axes beside the cone's that are cross products, and not of length 1.
pub(super) fn squeezed(q: &SampleSphereLight, up: Vec3) -> Vec<Chosen> {
    let axis = Dir3::new_or(q.center - q.at, Dir3::Y);
    let [x, y] = crossed(axis, unless_near(axis, up, Vec3::X));
    let basis = Basis::around(axis);
    let mut all = SampleSphereLight::right(q);
    for chosen in &mut all {
        let [across, along] = [basis.x, basis.y].map(|beside| chosen.toward.dot(*beside));
        let up = chosen.toward.dot(*axis);
        chosen.toward = (across * x + along * y + up * *axis).normalize_or_zero();
        chosen.distance = distance(q, chosen).0 as f32;
    }
    all
}

/// Directions that are uniform in another cone, from its axis to the height 1 − cos α = `cap`.
pub(super) fn wide(q: &SampleSphereLight, cap: f32) -> Vec<Chosen> {
    cone(q, |u, _| (cap * u.x, TAU * u.y, 1.0 / (TAU * cap)))
}
