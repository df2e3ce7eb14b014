//! Programs that are a little wrong, each in a way of its own: none of them is in the lists of mistakes.

mod accelerators;
mod light;
mod sampling;
mod shapes;

use glam::DVec3;

/// Exercises, what is wrong with the answers, and how a right one is spoilt.
pub type Wrong = (&'static [&'static str], &'static str, fn(&mut [f64]));

/// All of them.
pub fn wrongs() -> impl Iterator<Item = &'static Wrong> {
    [
        shapes::WRONGS,
        accelerators::WRONGS,
        light::WRONGS,
        sampling::WRONGS,
    ]
    .into_iter()
    .flatten()
}

/// For an exercise for which there is none: all its numbers are a little too large.
pub const OFF: Wrong = (&[], "is 1 % too large", |numbers| scale(numbers, 1.01));

fn scale(numbers: &mut [f64], by: f64) {
    for number in numbers {
        *number *= by;
    }
}

/// Turns the direction in three numbers by 1°.
fn turn(direction: &mut [f64]) {
    let d = DVec3::from_slice(direction).normalize();
    let (sin, cos) = 1.0_f64.to_radians().sin_cos();
    (cos * d + sin * d.any_orthonormal_vector()).write_to_slice(direction);
}
