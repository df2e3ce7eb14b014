//! The Cornell box: the best-known test scene of computer graphics.
//!
//! A real box of painted boards, which was measured and photographed so that pictures could be compared with it (Goral et al.
//! 1984; this is the later box, with two blocks). The corners, the reflectance spectra of the paints and the lamp's spectrum are
//! from Cornell University Program of Computer Graphics, *Cornell Box Data*, www.graphics.cornell.edu/online/box/data.html.
//!
//! The spectra are converted to linear sRGB with the colour-matching functions of 1931, as fitted by Wyman, Sloan and Shirley
//! (2013): those of the paints in daylight (D65), relative to a perfectly white paint, that of the lamp as it is.
//! `tests/library/ch17_rendering_equation` repeats the conversion.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::scene::cornell;
//!
//! let area = cornell::lamp().area();
//! assert!((area - 0.13 * 0.105).abs() < 1e-4); // m²
//! let up = Ray::new(vec3(0.1, 0.273, 0.279), Dir3::Y);
//! assert!((cornell::cornell_box().closest(&up).expect("the ceiling").t - (0.5488 - 0.273)).abs() < 1e-4);
//! ```

use crate::accel::Meshed;
use crate::accel::bvh::build::Method;
use crate::accel::wide_bvh::WideBvh;
use crate::image::rgb::Rgb;
use crate::light::{extent::LightSampling, rect_light::RectLight};
use crate::material::lambert::Lambert;
use crate::scene::world::{Scene, Thing};
use crate::shape::mesh::Mesh;
use glam::{Vec3, vec3};

/// The white paint's albedo.
pub const WHITE: Rgb = Rgb::new(0.738, 0.736, 0.740);
/// The red paint's albedo.
pub const RED: Rgb = Rgb::new(0.490, 0.050, 0.051);
/// The green paint's albedo.
pub const GREEN: Rgb = Rgb::new(0.069, 0.398, 0.087);
/// The lamp's radiance, in W·m⁻²·sr⁻¹, if its spectrum is in W·m⁻²·sr⁻¹ too.
pub const LAMP: Rgb = Rgb::new(20.66, 10.90, 2.766);

/// Where the published camera stands, in metres; it looks along +z.
pub const EYE: Vec3 = vec3(0.278, 0.273, -0.8);
/// The published camera's focal length over the width of its square film: 35 mm over 25 mm.
pub const ZOOM: f32 = 35.0 / 25.0;

/// Four corners in millimetres: x points left, y up, z away from the camera.
type Quad = [[f32; 3]; 4];

const WALLS: [Quad; 3] = [
    // Floor, ceiling, back.
    quad(
        [552.8, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 559.2],
        [549.6, 0.0, 559.2],
    ),
    quad(
        [556.0, 548.8, 0.0],
        [556.0, 548.8, 559.2],
        [0.0, 548.8, 559.2],
        [0.0, 548.8, 0.0],
    ),
    quad(
        [549.6, 0.0, 559.2],
        [0.0, 0.0, 559.2],
        [0.0, 548.8, 559.2],
        [556.0, 548.8, 559.2],
    ),
];
const RIGHT: [Quad; 1] = [quad(
    [0.0, 0.0, 559.2],
    [0.0, 0.0, 0.0],
    [0.0, 548.8, 0.0],
    [0.0, 548.8, 559.2],
)];
const LEFT: [Quad; 1] = [quad(
    [552.8, 0.0, 0.0],
    [549.6, 0.0, 559.2],
    [556.0, 548.8, 559.2],
    [556.0, 548.8, 0.0],
)];

/// The short block, which stands on the floor: its height, and x and z of the corners, counter-clockwise as seen from above, in
/// millimetres.
const SHORT: (f32, [[f32; 2]; 4]) = (
    165.0,
    [[130.0, 65.0], [82.0, 225.0], [240.0, 272.0], [290.0, 114.0]],
);
/// The tall block, likewise.
const TALL: (f32, [[f32; 2]; 4]) = (
    330.0,
    [
        [423.0, 247.0],
        [265.0, 296.0],
        [314.0, 456.0],
        [472.0, 406.0],
    ],
);

/// The lamp: x and z of its sides, in millimetres.
const LAMP_X: [f32; 2] = [213.0, 343.0];
const LAMP_Z: [f32; 2] = [227.0, 332.0];
/// The lamp's height, in millimetres. In the data it is that of the ceiling; here it is half a millimetre below the ceiling.
const LAMP_Y: f32 = 548.3;

const fn quad(a: [f32; 3], b: [f32; 3], c: [f32; 3], d: [f32; 3]) -> Quad {
    [a, b, c, d]
}

/// The box with its two blocks. The lamp reflects nothing.
pub fn cornell_box() -> Scene {
    // Everything white is one mesh, so that a ray searches one tree, not three.
    let white = [&WALLS[..], &block(SHORT), &block(TALL)].concat();
    let things = [(&white[..], WHITE), (&RIGHT, GREEN), (&LEFT, RED)];
    let things = things.map(|(quads, albedo)| painted(quads, albedo));
    Scene::new(things.into(), vec![Box::new(lamp())])
}

/// The lamp, which shines downwards.
pub fn lamp() -> RectLight {
    let corner = vec3(LAMP_X[0], LAMP_Y, LAMP_Z[0]) / 1000.0;
    let (width, depth) = (LAMP_X[1] - LAMP_X[0], LAMP_Z[1] - LAMP_Z[0]);
    let (a, b) = (Vec3::X * width / 1000.0, Vec3::Z * depth / 1000.0);
    RectLight::new(corner, a, b, LAMP).choosing(LightSampling::ByArea)
}

/// Quads of one colour.
fn painted(quads: &[Quad], albedo: Rgb) -> Thing {
    let corners = quads.iter().flatten();
    let positions = corners.map(|&p| Vec3::from(p) / 1000.0).collect();
    // No corner is shared: a shared one would have the mean of two walls' normals.
    let triangles = (0..quads.len() as u32).flat_map(|i| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|corner| 4 * i + corner);
        [[a, b, c], [a, c, d]]
    });
    let mesh = Mesh::new(positions, triangles.collect(), None, None)
        .unwrap_or_else(|error| unreachable!("the box is finite: {error}"));
    let mesh = Meshed::new(mesh, |faces| WideBvh::build(faces, Method::BottomUp));
    Thing::new(mesh, Lambert { albedo })
}

/// The quads of a block: the top and the four sides.
fn block((height, corners): (f32, [[f32; 2]; 4])) -> [Quad; 5] {
    let at = |y: f32, i: usize| [corners[i % 4][0], y, corners[i % 4][1]];
    let side = |i: usize| [at(0.0, i), at(height, i), at(height, i + 1), at(0.0, i + 1)];
    let top = [0, 1, 2, 3].map(|i| at(height, i));
    [top, side(0), side(1), side(2), side(3)]
}
