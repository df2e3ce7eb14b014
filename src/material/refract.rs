//! Snell's law: how a ray bends where it passes from one medium into another.

use crate::math::dir3::Dir3;

// ANCHOR: refract
/// The direction t in which a ray of the direction i goes on behind a surface; `None` for total internal reflection.
///
/// `outside` is the index of refraction on the side to which the normal points, `inside` that on the other side. A ray against
/// the normal enters, and a ray along the normal leaves: so n, the normal on the ray's side, and η = n₁/n₂ are known.
/// With cos θ₁ = −i·n, the part of i along the surface is i + cos θ₁ n, and its length is sin θ₁. By Snell's law
/// n₁ sin θ₁ = n₂ sin θ₂ it becomes t∥ = η (i + cos θ₁ n). The perpendicular part makes the length 1:
/// t = t∥ − √(1 − |t∥|²) n. If t∥ is longer than 1, there is no such direction.
pub fn refract(i: Dir3, normal: Dir3, outside: f32, inside: f32) -> Option<Dir3> {
    let (n, eta) = if i.dot(*normal) < 0.0 {
        (*normal, outside / inside)
    } else {
        (-*normal, inside / outside)
    };
    let along = eta * (*i - i.dot(n) * n);
    let cos2_squared = 1.0 - along.length_squared();
    if cos2_squared < 0.0 {
        return None;
    }
    Dir3::new(along - cos2_squared.sqrt() * n)
}
// ANCHOR_END: refract
