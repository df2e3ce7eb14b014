//! Chapters 1 to 7, and the mirror: rays, colours, hits, normals.

use crate::alternatives::wrong::{Wrong, scale, turn};

const CAMERA: &[&str] = &["camera_ray"];
const COLOURS: &[&str] = &["expose", "tone_map"];
const DIRECTIONS: &[&str] = &[
    "sphere_normal",
    "triangle_normal",
    "interpolate_normal",
    "reflect",
];
const HITS: &[&str] = &[
    "sphere_hit",
    "plane_hit",
    "box_clip",
    "triangle_hit",
    "mesh_hit",
];

pub const WRONGS: &[Wrong] = &[
    (&["ray_at"], "1 % too far", |p| scale(p, 1.01)),
    (CAMERA, "turned by 1°", |ray| turn(&mut ray[3..])),
    (CAMERA, "1 cm to the right", |ray| ray[0] += 0.01),
    (COLOURS, "1 % too bright", |c| scale(c, 1.01)),
    (COLOURS, "blue is red", |c| c[2] = c[0]),
    (&["encode_srgb"], "a byte too dark", |code| {
        code[0] -= 1.0 / 255.0;
    }),
    (&["solve_quadratic"], "1 % too large", |t| scale(t, 1.01)),
    (HITS, "t is 1 % too large", |t| t[0] *= 1.01),
    (HITS, "t is NaN", |t| t[0] = f64::NAN),
    (&["box_clip"], "leaves 1 % too late", |t| t[1] *= 1.01),
    (&["bounds_of"], "a millimetre too large", |b| b[4] += 1e-3),
    (&["bounds_of"], "ends at 1", |b| b[3] = 1.0),
    (&["triangle_hit"], "b1 is off by 0.01", |hit| hit[1] += 0.01),
    (&["triangle_hit"], "b2 is off by 0.01", |hit| hit[2] -= 0.01),
    (DIRECTIONS, "turned by 1°", |n| turn(n)),
    (DIRECTIONS, "1 % too long", |n| scale(n, 1.01)),
    (&["interpolate_texture"], "v is off by 0.01", |uv| {
        uv[1] += 0.01;
    }),
    (&["vertex_normals"], "the last is turned by 1°", |normals| {
        turn(normals.last_chunk_mut::<3>().expect("a normal"));
    }),
    (&["mesh_hit"], "ids count from 1", |hit| hit[1] += 1.0),
];
