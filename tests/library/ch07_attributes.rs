//! Chapter 7: normals at the vertices, averaged from the triangles around them.

use glam::{Vec3, vec2, vec3};
use proptest::prelude::*;
use raybook::math::dir3::Dir3;
use raybook::shape::attributes::{interpolate_normal, vertex_normals};

/// An f32 is right to 6e-8; the sums here are of a few terms of size 1.
const ROUNDED: f32 = 1e-6;

fn near(a: Vec3, b: Vec3) -> bool {
    a.abs_diff_eq(b, ROUNDED)
}

/// The cube from −1 to 1, two triangles to a face, counter-clockwise from outside; vertex i is at the signs of its bits.
fn cube() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let sign = |i: u32, bit: u32| if i & bit == 0 { -1.0 } else { 1.0 };
    let positions = (0..8)
        .map(|i| vec3(sign(i, 1), sign(i, 2), sign(i, 4)))
        .collect();
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let triangles = quads
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .collect();
    (positions, triangles)
}

#[test]
fn a_tetrahedron_has_normals_away_from_its_middle() {
    let corners = [
        vec3(1.0, 1.0, 1.0),
        vec3(-1.0, -1.0, 1.0),
        vec3(-1.0, 1.0, -1.0),
        vec3(1.0, -1.0, -1.0),
    ];
    let normals = vertex_normals(&corners, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]);
    for (corner, normal) in corners.iter().zip(normals) {
        assert!(
            near(*normal, corner.normalize()),
            "by symmetry it points from 0 to {corner}, not along {normal:?}"
        );
    }
}

#[test]
fn area_weights_lean_to_the_face_with_more_triangles_at_the_corner() {
    // At vertex 0 of the cube the faces −z and −y have both their triangles, but −x too: each diagonal starts at
    // the first vertex of its quad. At vertex 1, −z and −y have one triangle each, +x has two: weights 1 : 1 : 2.
    let (positions, triangles) = cube();
    let normals = vertex_normals(&positions, &triangles);
    assert!(
        near(*normals[0], Vec3::splat(-1.0).normalize()),
        "vertex 0: {:?}",
        normals[0]
    );
    assert!(
        near(*normals[1], vec3(2.0, -1.0, -1.0).normalize()),
        "vertex 1: {:?}",
        normals[1]
    );
}

#[test]
fn a_fine_sphere_has_the_normals_of_a_sphere() {
    let (across, down) = (64, 32);
    let place = |i: u32, j: u32| {
        let (theta, phi) = (
            std::f32::consts::PI * i as f32 / 32.0,
            std::f32::consts::TAU * j as f32 / 64.0,
        );
        vec3(
            theta.sin() * phi.sin(),
            theta.cos(),
            theta.sin() * phi.cos(),
        )
    };
    let id = |i: u32, j: u32| i * across + j % across;
    let positions: Vec<_> = (0..=down)
        .flat_map(|i| (0..across).map(move |j| place(i, j)))
        .collect();
    let cells = (0..down).flat_map(|i| (0..across).map(move |j| (i, j)));
    let triangles: Vec<_> = cells
        .flat_map(|(i, j)| {
            [
                [id(i, j), id(i + 1, j), id(i + 1, j + 1)],
                [id(i, j), id(i + 1, j + 1), id(i, j + 1)],
            ]
        })
        .collect();
    let normals = vertex_normals(&positions, &triangles);
    // At the poles each of 64 vertices has but one sliver. Elsewhere the largest error is 0.0165, next to a pole, where
    // the cells' diagonals all lean the same way; a triangle's own normal is off by up to 0.07.
    for i in across as usize..(down * across) as usize {
        let off = normals[i].distance(positions[i]);
        assert!(
            off < 0.02,
            "the normal {:?} at {} is off by {off}",
            normals[i],
            positions[i]
        );
    }
}

proptest! {
    #[test]
    fn cutting_a_triangle_from_a_vertex_changes_nothing_at_this_vertex(
        corners in prop::array::uniform3(prop::array::uniform3(-1.0_f32..1.0)),
        cut in 0.0_f32..1.0,
    ) {
        let [a, b, c] = corners.map(Vec3::from);
        let twice_areas = [a.cross(b), b.cross(c)];
        let sum = twice_areas[0] + twice_areas[1];
        // Where the two nearly cancel out, the sum has lost its digits.
        prop_assume!(sum.length() > 0.1);
        let whole = vertex_normals(&[Vec3::ZERO, a, b, c], &[[0, 1, 2], [0, 2, 3]]);
        let between = a.lerp(b, cut);
        let halves = vertex_normals(&[Vec3::ZERO, a, b, c, between], &[[0, 1, 4], [0, 4, 2], [0, 2, 3]]);
        // Rounding of 6e-8 in each of a few products of size 1, divided by a length of 0.1.
        prop_assert!(whole[0].abs_diff_eq(*halves[0], 1e-5), "{:?} became {:?}", whole[0], halves[0]);
    }
}

#[test]
fn equal_weights_would_change_by_a_cut() {
    // The planted mistake: normalise each triangle's normal before the sum. A roof, one side of it cut in two.
    let unweighted = |triangles: &[[Vec3; 3]]| {
        let sum: Vec3 = triangles
            .iter()
            .map(|[p, q, r]| (q - p).cross(r - p).normalize())
            .sum();
        sum.normalize()
    };
    let (a, b, c) = (Vec3::X, Vec3::Y, Vec3::Z);
    let whole = unweighted(&[[Vec3::ZERO, a, b], [Vec3::ZERO, b, c]]);
    let halves = unweighted(&[
        [Vec3::ZERO, a, a.midpoint(b)],
        [Vec3::ZERO, a.midpoint(b), b],
        [Vec3::ZERO, b, c],
    ]);
    assert!(
        whole.distance(halves) > 0.1,
        "the property above must be able to fail"
    );
}

#[test]
fn a_vertex_without_triangles_and_one_whose_triangles_cancel_out_have_a_normal() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Z, Vec3::ONE];
    let two_sides = [[0, 1, 2], [0, 2, 1]];
    for normal in vertex_normals(&positions, &two_sides) {
        assert_eq!(
            normal,
            Dir3::Y,
            "no direction is better than another, but NaN is worse than all"
        );
    }
}

#[test]
fn a_triangle_without_area_adds_nothing() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Y, 2.0 * Vec3::X];
    let normals = vertex_normals(&positions, &[[0, 1, 2], [0, 1, 3], [1, 1, 2]]);
    assert_eq!(normals[0], Dir3::Z, "only the first triangle has an area");
    assert_eq!(normals[1], Dir3::Z, "and at the next corner too");
}

#[test]
fn opposite_normals_do_not_make_nan() {
    let n = interpolate_normal([Dir3::X, -Dir3::X, Dir3::X], vec2(0.5, 0.0));
    assert_eq!(
        n,
        Dir3::X,
        "where the normals cancel out, the first stands in"
    );
}
