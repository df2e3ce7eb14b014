//! Programs that are a little wrong, each in a way of its own: none of them is in the lists of mistakes.

use glam::DVec3;

/// Exercises, what is wrong with the answers, and how a right one is spoilt.
pub type Wrong = (&'static [&'static str], &'static str, fn(&mut [f64]));

const CAMERA: &[&str] = &["camera_ray"];
const COLOURS: &[&str] = &["expose", "tone_map"];
const DIRECTIONS: &[&str] = &[
    "sphere_normal",
    "triangle_normal",
    "interpolate_normal",
    "reflect",
];
const GRIDS: &[&str] = &["regular_grid", "rotated_grid"];
const HIGHLIGHTS: &[&str] = &["phong", "blinn_phong"];
const HITS: &[&str] = &[
    "sphere_hit",
    "plane_hit",
    "box_clip",
    "triangle_hit",
    "mesh_hit",
];
const LISTS: &[&str] = &[
    "refine_cell",
    "two_level_walk",
    "octree_build",
    "octree_walk",
];

const LIGHTS: &[&str] = &["sample_rect", "sample_sphere_light"];
const SPREAD: &[&str] = &["jittered", "poisson_disk"];

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
    (&["grid_resolution"], "one cell too many along y", |n| {
        n[1] += 1.0;
    }),
    (&["voxels_of_triangle"], "x and z are swapped", |cells| {
        cells[1..].chunks_mut(3).for_each(|cell| cell.swap(0, 2));
    }),
    (&["grid_walk"], "cells count from 1", |visits| {
        visits[1..].chunks_mut(4).for_each(|visit| visit[0] += 1.0);
    }),
    (&["grid_walk"], "leaves 1 % too late", |visits| {
        visits[1..].chunks_mut(4).for_each(|visit| visit[3] *= 1.01);
    }),
    (LISTS, "the last counts from 1", |cells| {
        *cells.last_mut().expect("a count") += 1.0;
    }),
    (&["octree_child"], "upside down", |child| {
        child[0] = (child[0] + 2.0) % 8.0;
    }),
    (&["sah_cost"], "1 % too dear", |cost| scale(cost, 1.01)),
    (&["sah_split"], "a box that is not there", |left| {
        left[1] = 99.0;
    }),
    (&["bvh_build"], "the root is too small", |tree| {
        tree[1] += 0.1;
    }),
    (&["bvh_closest"], "t is 1 % too large", |hit| hit[2] *= 1.01),
    (&["bvh_closest"], "ids count from 1", |hit| hit[3] += 1.0),
    (&["bvh_closest"], "three times as many tests", |hit| {
        hit[0] = 3.0 * hit[0] + 9.0;
    }),
    (&["geodesic_step"], "1 % too far", |photon| {
        scale(&mut photon[..3], 1.01);
    }),
    (
        &["geodesic_step"],
        "the velocity is turned by 1°",
        |photon| {
            turn(&mut photon[3..]);
        },
    ),
    (&["deflection_angle"], "1 % too large", |angle| {
        scale(angle, 1.01);
    }),
    (
        &["collapse"],
        "the last child is its neighbour",
        |families| {
            *families.last_mut().expect("a number") += 1.0;
        },
    ),
    (&["wide_closest"], "t is 1 % too large", |hit| {
        hit[2] *= 1.01;
    }),
    (&["wide_closest"], "three times as many nodes", |hit| {
        hit[0] = 3.0 * hit[0] + 2.0;
    }),
    (&["wide_closest"], "three times as many tests", |hit| {
        hit[1] = 3.0 * hit[1] + 2.0;
    }),
    (HIGHLIGHTS, "a little more red", |c| c[0] += 0.01),
    (HIGHLIGHTS, "a little less blue", |c| c[2] -= 0.01),
    (&["shadow_ray"], "1° beside the light", |way| {
        turn(&mut way[3..6]);
    }),
    (&["shadow_ray"], "ends 1 % behind the light", |way| {
        way[7] = if way[7].is_finite() {
            1.02 * way[7]
        } else {
            1e6
        };
    }),
    (&["lit"], "the other way round", |lit| lit[0] = 1.0 - lit[0]),
    (&["point_light"], "1° beside the light", |light| {
        turn(&mut light[..3]);
    }),
    (&["point_light"], "1 % too near", |light| light[3] *= 0.99),
    (&["point_light"], "1 % too bright", |light| {
        scale(&mut light[4..], 1.01);
    }),
    (&["refract"], "turned by 1°", |t| turn(t)),
    (&["refract"], "1 % too long", |t| scale(t, 1.01)),
    (&["fresnel"], "Rp is off by 0.001", |r| r[1] += 0.001),
    (&["fresnel"], "R is off by 0.001", |r| r[2] -= 0.001),
    (LIGHTS, "the last density is off by 2 %", |c| {
        c[c.len() - 2] *= 1.02;
    }),
    (LIGHTS, "the last is 20 % too far", |c| {
        c[c.len() - 3] *= 1.2;
    }),
    (LIGHTS, "the last direction is NaN", |c| {
        c[c.len() - 4] = f64::NAN;
    }),
    (&["visible_fraction"], "dark is light", |f| {
        f[1..].iter_mut().for_each(|f| *f = 1.0 - *f);
    }),
    (&["cosine_hemisphere"], "1 % too long", |list| {
        scale(&mut list[1..], 1.01);
    }),
    (&["cosine_hemisphere"], "every third is the first", |list| {
        let first = [list[1], list[2], list[3]];
        for i in (1..list.len()).step_by(9) {
            list[i..i + 3].copy_from_slice(&first);
        }
    }),
    (&["brdf_phong"], "1 % too bright", |f| scale(f, 1.01)),
    (&["reflected_radiance"], "10 % too bright", |l| {
        scale(l, 1.1);
    }),
    (&["direction_to_cube"], "u is off by 0.01", |place| {
        place[1] += 0.01;
    }),
    (&["direction_to_latlong"], "v is off by 0.01", |place| {
        place[1] += if place[1] < 0.5 { 0.01 } else { -0.01 };
    }),
    (
        &["sample_environment"],
        "every third is the first",
        |list| {
            let first: Vec<f64> = list.iter().skip(1).take(3).copied().collect();
            for direction in list[1..].chunks_exact_mut(9) {
                direction[..3].copy_from_slice(&first);
            }
        },
    ),
    (&["environment_pdf"], "1 % too large", |density| {
        scale(density, 1.01);
    }),
    (GRIDS, "the first is 0.01 to the right", |points| {
        if points.len() > 1 {
            points[1] += 0.01;
        }
    }),
    (&["random_pattern"], "half of them twice", |points| {
        let half = (points.len() - 1) / 4 * 2;
        points.copy_within(1..=half, half + 1);
    }),
    (SPREAD, "the second is where the first is", |points| {
        if points.len() > 4 {
            points.copy_within(1..3, 3);
        }
    }),
    (&["pixel_average"], "1 % too bright", |l| scale(l, 1.01)),
    (&["needs_more"], "the other way round", |more| {
        more[0] = 1.0 - more[0];
    }),
    (&["spend_budget"], "one too many for the last", |counts| {
        *counts.last_mut().expect("a count") += 1.0;
    }),
];

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
