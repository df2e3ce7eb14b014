//! Chapter 7: which way the teapot faces, how smooth it is, and what rays find on it.

use glam::{Vec2, Vec3, vec3};
use raybook::accel::{Meshed, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::Shape;
use raybook::shape::attributes::vertex_normals;
use raybook::shape::mesh::Mesh;
use raybook::shape::teapot::{DATA, mesh, parts};

/// Patches before the handle's, which are followed by the spout's: 4 each.
const BODY: usize = 16;

/// The corners of a mesh's triangle.
fn corners(mesh: &Mesh, triangle: [u32; 3]) -> [Vec3; 3] {
    triangle.map(|i| mesh.positions()[i as usize])
}

/// A ray towards the axis of the teapot, at a height, from an angle around it; 0 is the spout's side.
fn inward(degrees: f32, height: f32) -> Ray {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let from = vec3(10.0 * cos, height, 10.0 * sin);
    Ray::new(from, Dir3::new_or(vec3(0.0, height, 0.0) - from, Dir3::X))
}

#[test]
fn the_body_faces_away_from_its_axis() {
    let n = 6;
    let mesh = mesh(n);
    let body = &mesh.triangles()[4 * 2 * n * n..12 * 2 * n * n]; // without the rim and the bottom
    for &triangle in body {
        let [p0, p1, p2] = corners(&mesh, triangle);
        let outward = (p0 + p1 + p2).with_y(0.0);
        assert!(
            (p1 - p0).cross(p2 - p0).dot(outward) > 0.0,
            "the triangle at {p0} faces the axis"
        );
    }
}

#[test]
fn the_closed_body_has_the_volume_of_its_profile() {
    let n = 16;
    let mesh = mesh(n);
    let tubes = BODY * 2 * n * n - 4 * n..(BODY + 8) * 2 * n * n - 4 * n;
    let triangles = mesh
        .triangles()
        .iter()
        .enumerate()
        .filter(|(i, _)| !tubes.contains(i));
    // The signed volumes of the tetrahedra from the origin add up to what is inside, if all face outward.
    let volume: f32 = triangles
        .map(|(_, &t)| corners(&mesh, t))
        .map(|[a, b, c]| a.dot(b.cross(c)) / 6.0)
        .sum();
    // The profile's radius at a height, measured by a ray and turned around the axis. The patches bulge a little beyond
    // circles, by up to 0.4 % at 45°, and the triangles lie inside the patches: the two differ by 0.1 %.
    let shape = Meshed::new(mesh, List::new);
    let slices = 500;
    let turned: f32 = (0..slices)
        .map(|i| {
            let height = 3.15 * (i as f32 + 0.5) / slices as f32;
            let radius = shape
                .hit(&inward(90.0, height), Interval::AHEAD)
                .map_or(0.0, |hit| 10.0 - hit.t);
            std::f32::consts::PI * radius * radius * 3.15 / slices as f32
        })
        .sum();
    assert!(
        (volume / turned - 1.0).abs() < 0.02,
        "{volume} by triangles, {turned} by the profile"
    );
}

#[test]
fn the_patches_normals_are_those_of_the_triangles_in_the_limit() {
    let farthest = |n: usize| {
        let mesh = mesh(n);
        let averaged = vertex_normals(mesh.positions(), mesh.triangles());
        let used: std::collections::BTreeSet<_> = mesh.triangles().iter().flatten().collect();
        used.into_iter()
            .map(|&i| mesh.normals()[i as usize].dot(*averaged[i as usize]))
            .fold(1.0, f32::min)
    };
    // 60°, 40° and 23° at the lid's edge, where it turns down within one row of triangles; less elsewhere.
    let cosines = [4, 8, 16].map(farthest);
    let expected = [60.3_f32, 40.4, 22.6].map(|degrees| degrees.to_radians().cos());
    for (cosine, expected) in cosines.into_iter().zip(expected) {
        assert!(
            (cosine - expected).abs() < 0.01,
            "{cosines:?} should near 1"
        );
    }
}

#[test]
fn neighbouring_patches_have_one_normal_on_their_border() {
    let mut borders = 0;
    for part in parts(DATA).unwrap_or_else(|wrong| panic!("{wrong}")) {
        let columns = part.columns.get();
        for (i, patch) in part.patches.iter().enumerate() {
            let beside = &part.patches[i / columns * columns + (i + 1) % columns];
            let after = part.patches.get(i + columns);
            for t in [0.1, 0.35, 0.5, 0.75, 0.9] {
                let mut pairs = vec![(patch.normal(t, 1.0), beside.normal(t, 0.0))];
                pairs.extend(after.map(|after| (patch.normal(1.0, t), after.normal(0.0, t))));
                for (here, there) in pairs {
                    let (Some(here), Some(there)) = (here, there) else {
                        panic!("{}, patch {i}: no normal", part.name)
                    };
                    assert!(
                        here.abs_diff_eq(*there, 1e-5),
                        "{}, patch {i}: {here:?} and {there:?}",
                        part.name
                    );
                    borders += 1;
                }
            }
        }
    }
    assert_eq!(
        borders,
        5 * (32 + 20),
        "a border beside each patch, and 12 + 2 + 2 + 4 after one"
    );
}

#[test]
fn poles_point_up_and_down() {
    let mesh = mesh(4);
    let mut poles = 0;
    for (p, n) in mesh.positions().iter().zip(mesh.normals()) {
        if p.with_y(0.0) == Vec3::ZERO {
            assert_eq!(*n, if p.y > 1.0 { Dir3::Y } else { -Dir3::Y }, "at {p}");
            poles += 1;
        }
    }
    assert_eq!(
        poles,
        2 * 17,
        "each side of the 16 cells around has its vertex, for its texture coordinate"
    );
}

#[test]
fn patches_side_by_side_share_their_vertices() {
    for n in [2, 5] {
        let grids = [(4, 4), (2, 2), (2, 2), (2, 4)];
        let vertices: usize = grids
            .map(|(rows, columns)| (rows * n + 1) * (columns * n + 1))
            .iter()
            .sum();
        assert_eq!(
            mesh(n).positions().len(),
            vertices,
            "one grid of vertices per part"
        );
    }
    let last = mesh(2)
        .textures()
        .iter()
        .fold(Vec2::ZERO, |most, t| most.max(*t));
    assert_eq!(
        last,
        Vec2::splat(4.0),
        "the texture coordinates count patches: 4 around the body, 4 along it"
    );
}

#[test]
fn no_number_of_cells_makes_it_panic() {
    assert_eq!(mesh(0), mesh(1), "0 counts as 1");
}

#[test]
fn rays_find_the_teapot_where_it_was() {
    let rays = [
        ("body from the front", inward(90.0, 1.0)),
        ("body from behind", inward(-90.0, 1.0)),
        ("spout", inward(0.0, 2.0)),
        ("handle", inward(180.0, 2.0)),
        (
            "through the handle's hole",
            Ray::new(vec3(-2.2, 1.6, 9.0), -Dir3::Z),
        ),
        ("knob from above", Ray::new(vec3(0.1, 9.0, 0.1), -Dir3::Y)),
        ("bottom from below", Ray::new(vec3(0.5, -9.0, 0.3), Dir3::Y)),
        ("above it", inward(90.0, 3.2)),
        ("from inside", Ray::new(vec3(0.0, 1.0, 0.0), Dir3::Z)),
    ];
    let teapot = Meshed::new(mesh(8), List::new);
    raybook_common::snapshot(
        "ch07_teapot_hits",
        &raybook_common::hit_table(&teapot, &rays),
    );
}
