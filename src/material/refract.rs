//! Snell's law: how a ray bends where it passes from one medium into another.
//!
//! ```
//! use raybook::material::refract::refract;
//! use raybook::prelude::*;
//!
//! let into_water = Dir3::new(vec3(0.8, -0.6, 0.0)).expect("longer than 0");
//! let below = refract(into_water, Dir3::Y, 1.0, 1.333).expect("always enters");
//! assert!((below.x - 0.8 / 1.333).abs() < 1e-6); // n₁ sin θ₁ = n₂ sin θ₂
//! let out_of_water = Dir3::new(vec3(0.8, 0.6, 0.0)).expect("longer than 0");
//! assert!(refract(out_of_water, Dir3::Y, 1.0, 1.333).is_none()); // total internal reflection
//! ```

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
