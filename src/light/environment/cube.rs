//! The cube map: six square pictures, as on the walls of a room.
//!
//! ```
//! use raybook::light::environment::cube;
//! use raybook::prelude::*;
//!
//! assert_eq!(cube::place(Dir3::X), (0, vec2(0.5, 0.5))); // the middle of the face +x
//! assert_eq!(cube::direction(5, vec2(0.5, 0.5)), -Dir3::Z);
//! ```

use crate::light::environment::convert::Layout;
use crate::math::dir3::Dir3;
use glam::{UVec2, Vec2, uvec2, vec2, vec3};

// ANCHOR: direction_to_cube
/// The face that a direction points at, 0 to 5 for +x, −x, +y, −y, +z, −z, and the place on it, in [0, 1]² from the top left.
///
/// The face belongs to the component m with the largest absolute value. The other two, divided by |m|, are in [−1, 1]. Each face
/// is drawn as seen from inside: +y is up on the four walls; on the ceiling +y, −z is down, and on the floor −y, −z is up.
/// (OpenGL's faces are mirror images of these, as seen from outside.)
pub fn place(direction: Dir3) -> (usize, Vec2) {
    let d = *direction;
    let axis = d.abs().max_position();
    let m = d[axis];
    let (right, down) = match (axis, m > 0.0) {
        (0, true) => (d.z, -d.y),
        (0, false) => (-d.z, -d.y),
        (1, true) => (d.x, -d.z),
        (1, false) => (d.x, d.z),
        (_, true) => (-d.x, -d.y),
        (_, false) => (d.x, -d.y),
    };
    let face = 2 * axis + usize::from(m <= 0.0);
    (face, 0.5 + 0.5 * vec2(right, down) / m.abs())
}
// ANCHOR_END: direction_to_cube

/// The direction at a place on a face, 0 to 5: the inverse of [`place`].
pub fn direction(face: usize, place: Vec2) -> Dir3 {
    let Vec2 { x: right, y: down } = 2.0 * place - 1.0;
    let toward = match face {
        0 => vec3(1.0, -down, right),
        1 => vec3(-1.0, -down, -right),
        2 => vec3(right, 1.0, -down),
        3 => vec3(right, -1.0, down),
        4 => vec3(-right, -down, 1.0),
        _ => vec3(right, -down, -1.0),
    };
    Dir3::new_or(toward, Dir3::Z)
}

/// The layout of a cross: the six faces unfolded in a picture of 4 × 3 squares, with −z where the column and the row of the cross
/// meet.
#[derive(Clone, Copy, Debug)]
pub struct Cross;

/// The square of the cross, column and row from the top left, for each face.
const SQUARES: [UVec2; 6] = [
    uvec2(2, 1),
    uvec2(0, 1),
    uvec2(1, 0),
    uvec2(1, 2),
    uvec2(3, 1),
    uvec2(1, 1),
];

impl Layout for Cross {
    fn direction(&self, place: Vec2) -> Option<Dir3> {
        let squares = place * vec2(4.0, 3.0);
        let square = squares.floor();
        let face = SQUARES.iter().position(|s| s.as_vec2() == square)?;
        Some(direction(face, squares - square))
    }

    fn place(&self, direction: Dir3) -> Vec2 {
        /// The largest `f32` below 1: so the far edge of a face still belongs to the face.
        const LAST: Vec2 = Vec2::splat(1.0 - f32::EPSILON / 2.0);
        let (face, on_face) = place(direction);
        (SQUARES[face].as_vec2() + on_face.min(LAST)) / vec2(4.0, 3.0)
    }
}
