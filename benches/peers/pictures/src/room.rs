//! The scene: the Cornell box with its two blocks, as quads, and how high the view of its published camera is.

use raybook::prelude::*;
use raybook::scene::cornell::{GREEN, RED, WHITE};

/// A quad and its albedo; seen from its front, its corners are counter-clockwise.
pub(crate) type Quad = ([Vec3; 4], Rgb);

/// The film of the published camera is 25 mm high, at 35 mm.
const HALF_VIEW: f32 = 12.5 / 35.0;

/// The box with its two blocks, in metres, and its lamp, which faces down.
pub(crate) fn room() -> (Vec<Quad>, [Vec3; 4]) {
    let (low, high) = (Vec3::ZERO, vec3(0.556, 0.5488, 0.5592));
    let middle = 0.5 * (low + high);
    let mut quads = Vec::new();
    // A wall for each face of the box but the one before the eye.
    for (axis, at, albedo) in [
        (0, low, GREEN),
        (0, high, RED),
        (1, low, WHITE),
        (1, high, WHITE),
        (2, high, WHITE),
    ] {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let corners = [(low, low), (high, low), (high, high), (low, high)].map(|(of_u, of_v)| {
            let mut corner = at;
            (corner[u], corner[v]) = (of_u[u], of_v[v]);
            corner
        });
        quads.push((facing(corners, middle), albedo));
    }
    // Height, and the corners on the floor, of the published blocks, in millimetres.
    for (height, corners) in [
        (
            165.0,
            [[130.0, 65.0], [82.0, 225.0], [240.0, 272.0], [290.0, 114.0]],
        ),
        (
            330.0,
            [
                [423.0, 247.0],
                [265.0, 296.0],
                [314.0, 456.0],
                [472.0, 406.0],
            ],
        ),
    ] {
        let corner = |i: usize, y: f32| vec3(corners[i % 4][0], y, corners[i % 4][1]) / 1000.0;
        let inside = 0.5 * (corner(0, 0.0) + corner(2, height));
        let mut add = |quad: [Vec3; 4]| {
            let outside = (quad[0] + quad[2]) - inside;
            quads.push((facing(quad, outside), WHITE));
        };
        add([0, 1, 2, 3].map(|i| corner(i, height)));
        for i in 0..4 {
            add([
                corner(i, 0.0),
                corner(i, height),
                corner(i + 1, height),
                corner(i + 1, 0.0),
            ]);
        }
    }
    let lamp = [
        (0.213, 0.227),
        (0.343, 0.227),
        (0.343, 0.332),
        (0.213, 0.332),
    ];
    let lamp = lamp.map(|(x, z)| vec3(x, 0.5483, z));
    (quads, facing(lamp, middle))
}

/// The quad with its front to a point.
fn facing([a, b, c, d]: [Vec3; 4], point: Vec3) -> [Vec3; 4] {
    let normal = (b - a).cross(c - a);
    if normal.dot(point - a) > 0.0 {
        [a, b, c, d]
    } else {
        [d, c, b, a]
    }
}

/// The quads of each colour.
pub(crate) fn by_colour(quads: &[Quad]) -> [(Rgb, Vec<[Vec3; 4]>); 3] {
    [WHITE, RED, GREEN].map(|colour| {
        let own = quads.iter().filter(|(_, albedo)| *albedo == colour);
        (colour, own.map(|(quad, _)| *quad).collect())
    })
}

/// The height of the view, in degrees.
pub(crate) fn degrees() -> f32 {
    2.0 * HALF_VIEW.atan().to_degrees()
}
