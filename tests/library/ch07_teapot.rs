//! Chapter 7: the teapot's data, its shape, and its triangles.

use glam::{Vec3, vec3};
use raybook::shape::bezier::Patch;
use raybook::shape::mesh::Mesh;
use raybook::shape::teapot::{DATA, Part, mesh, parts};
use raybook_common::snapshot;
use std::collections::{BTreeMap, BTreeSet};

fn data() -> Vec<Part> {
    parts(DATA).unwrap_or_else(|wrong| panic!("teapot.txt:{wrong}"))
}

/// Points of the patches, 9 × 9 of each.
fn points(patches: &[Patch]) -> Vec<Vec3> {
    let grid = |patch: &Patch| {
        let patch = *patch;
        (0..81).map(move |i| patch.point((i / 9) as f32 / 8.0, (i % 9) as f32 / 8.0))
    };
    patches.iter().flat_map(grid).collect()
}

#[test]
fn the_data_are_32_patches_of_290_points() {
    let parts = data();
    let shape: Vec<_> = parts
        .iter()
        .map(|p| (p.name.as_str(), p.columns.get(), p.patches.len()))
        .collect();
    assert_eq!(
        shape,
        [
            ("body", 4, 16),
            ("handle", 2, 4),
            ("spout", 2, 4),
            ("lid", 4, 8)
        ],
        "parts, patches around each, patches; every index was in range, or there were no data"
    );
    let used: BTreeSet<_> = parts
        .iter()
        .flat_map(|p| &p.patches)
        .flat_map(|p| p.rows.as_flattened())
        .map(|p| p.to_array().map(f32::to_bits))
        .collect();
    assert_eq!(
        used.len(),
        290,
        "different control points, all of them used"
    );
    assert_eq!(
        DATA.lines().filter(|line| line.starts_with("v ")).count(),
        290,
        "and none is listed twice"
    );
}

#[test]
fn broken_data_are_refused_with_the_place() {
    let table: Vec<_> = [
        "v 0 0",
        "v 0 0 x",
        "part lid",
        "part lid 0",
        "v 0 0 0\npatch 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1",
        "part lid 4\nv 0 0 0\npatch 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1",
        "part lid 4\nv 0 0 0\npatch 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 2",
        "potch",
    ]
    .map(|text| parts(text).expect_err("it is broken").to_string())
    .into();
    snapshot("ch07_teapot_refused", &table.join("\n"));
}

#[test]
fn it_is_as_large_as_everybodys() {
    let bounds = mesh(20).bounds();
    // The known extents; the spout's tip is where the outermost curve turns, at x = 3.434.
    assert!(
        bounds.min.abs_diff_eq(vec3(-3.0, 0.0, -2.0), 1e-6),
        "{}",
        bounds.min
    );
    assert!(
        bounds.max.abs_diff_eq(vec3(3.434, 3.15, 2.0), 1e-3),
        "{}",
        bounds.max
    );
}

#[test]
fn every_part_is_the_same_on_both_sides_and_the_body_from_all_four() {
    for part in data() {
        let all = points(&part.patches);
        // The sums of a curve run the other way on the other side: a few roundings of numbers up to 3.
        let is_there = |p: Vec3| all.iter().any(|q| q.abs_diff_eq(p, 2e-6));
        let mirrored = |mirror: fn(Vec3) -> Vec3| all.iter().all(|&p| is_there(mirror(p)));
        assert!(
            mirrored(|p| p * vec3(1.0, 1.0, -1.0)),
            "{}: front and back",
            part.name
        );
        let round = mirrored(|p| p * vec3(-1.0, 1.0, 1.0)) && mirrored(|p| vec3(p.z, p.y, p.x));
        assert_eq!(
            round,
            part.columns.get() == 4,
            "{}: only body and lid look the same from four sides",
            part.name
        );
    }
}

#[test]
fn the_lid_meets_the_rim_here_but_not_in_newells_data() {
    let parts = data();
    let reach = |row: &[Vec3; 4]| row.iter().map(|p| p.x.abs()).fold(0.0, f32::max);
    assert_eq!(reach(&parts[3].patches[4].rows[3]), 1.3, "Newell's lid");
    assert_eq!(reach(&parts[0].patches[0].rows[0]), 1.4, "the rim");
    let edges = edges(&mesh(6));
    let on_the_rim = |p: Vec3| p.y == 2.4 && (p.with_y(0.0).length() - 1.4).abs() < 0.01;
    let rim: Vec<_> = edges
        .iter()
        .filter(|((a, b), _)| on_the_rim(place(*a)) && on_the_rim(place(*b)))
        .collect();
    assert_eq!(rim.len(), 48, "24 edges, each in both directions");
    assert!(
        rim.iter().all(|(_, uses)| **uses == 1),
        "one by the lid, one by the body"
    );
}

type Point = [u32; 3];

fn place(bits: Point) -> Vec3 {
    bits.map(f32::from_bits).into()
}

/// How often each edge, from a place to a place, is used by a triangle in this direction.
fn edges(mesh: &Mesh) -> BTreeMap<(Point, Point), usize> {
    let bits = |i: u32| {
        (mesh.positions()[i as usize] + Vec3::ZERO)
            .to_array()
            .map(f32::to_bits)
    };
    let mut edges = BTreeMap::new();
    for &[a, b, c] in mesh.triangles() {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            *edges.entry((bits(from), bits(to))).or_default() += 1;
        }
    }
    edges
}

#[test]
fn only_handle_and_spout_have_open_ends() {
    for n in [2, 3, 5, 8] {
        let mesh = mesh(n);
        assert_eq!(
            mesh.triangles().len(),
            64 * n * n - 8 * n,
            "two per cell, one at a pole"
        );
        let edges = edges(&mesh);
        assert!(
            edges.values().all(|&uses| uses == 1),
            "n = {n}: no edge is used twice in one direction"
        );
        let open = edges
            .keys()
            .filter(|&&(a, b)| !edges.contains_key(&(b, a)))
            .count();
        assert_eq!(
            open,
            8 * n,
            "n = {n}: two ends each of two tubes of two patches"
        );
    }
}
