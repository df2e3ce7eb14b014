//! Chapter 18: light from all around.

mod files;
mod layouts;
mod maps;
mod paths;
mod piecewise;
mod sampling;
mod skies;

use glam::Vec3;
use rand::RngExt;
use raybook::math::{dir3::Dir3, pcg::Pcg};

/// A direction, uniform on the sphere: a point in the ball, as long as it takes to find one.
fn direction(rng: &mut Pcg) -> Dir3 {
    loop {
        let p = Vec3::from_array(std::array::from_fn(|_| rng.random_range(-1.0..1.0)));
        if (0.01..1.0).contains(&p.length_squared()) {
            return Dir3::new_or(p, Dir3::X);
        }
    }
}
