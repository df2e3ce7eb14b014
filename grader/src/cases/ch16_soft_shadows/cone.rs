//! Directions to a spherical light, as the mistakes of `sample_sphere_light` choose them.

use super::lattice;
use glam::{Vec2, vec3};
use raybook::math::{basis::Basis, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, sphere::Sphere};
use raybook_workbook::exercises::ch16_soft_shadows::{Chosen, SampleSphereLight};

/// 1 − cos α of the cone in which the light is seen.
pub(super) fn cap(q: &SampleSphereLight) -> f32 {
    let squared = (q.radius / q.at.distance(q.center)).powi(2);
    if squared < 1.0 {
        squared / (1.0 + (1.0 - squared).sqrt())
    } else {
        2.0
    }
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
