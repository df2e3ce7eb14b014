//! No ray slips between two triangles that share an edge.

use glam::Vec3;
use rand::RngExt;
use raybook::accel::{
    Accel,
    wide_bvh::{Kernel, WideBvh},
};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::shape::mesh::{Facet, Mesh};

/// Rays that are aimed at edges and corners.
const RAYS: usize = 1_000_000;

#[test]
fn no_ray_from_inside_leaves_a_closed_mesh() {
    let mesh = ball(24);
    let tree = WideBvh::new(mesh.facets());
    let kernels = Kernel::all().into_iter();
    let trees: Vec<_> = kernels.map(|kernel| tree.clone().with(kernel)).collect();
    let mut rng = pcg::stream(1, 0);
    let mut leaks = 0;
    for i in 0..RAYS {
        let from = 0.4 * Vec3::from(std::array::from_fn(|_| rng.random::<f32>() - 0.5));
        let target = aim(&mesh, &mut rng);
        let ray = Ray::new(from, Dir3::new_or(target - from, Dir3::X));
        let tree = &trees[i % trees.len()];
        leaks += usize::from(tree.closest(&ray, Interval::AHEAD).is_none());
        leaks += usize::from(!tree.any(&ray, Interval::AHEAD));
    }
    assert_eq!(
        leaks, 0,
        "of {RAYS} rays at edges and corners, so many went through"
    );
}

#[test]
fn a_mesh_that_is_torn_by_one_digit_leaks() {
    let mesh = ball(24);
    let torn: Vec<_> = mesh
        .facets()
        .into_iter()
        .map(|facet| Facet {
            corners: facet
                .corners
                .map(|p| p * (1.0 - 4e-7 * (facet.id % 2) as f32)),
            ..facet
        })
        .collect();
    let tree = WideBvh::new(torn);
    let mut rng = pcg::stream(1, 0);
    let leaks = (0..RAYS / 10).filter(|_| {
        let target = aim(&mesh, &mut rng);
        tree.closest(
            &Ray::new(Vec3::ZERO, Dir3::new_or(target, Dir3::X)),
            Interval::AHEAD,
        )
        .is_none()
    });
    assert!(
        leaks.count() > 10,
        "the test before this one must be able to fail"
    );
}

/// A point of an edge, or a corner, of the mesh.
fn aim(mesh: &Mesh, rng: &mut pcg::Pcg) -> Vec3 {
    let triangle = mesh.triangles()[rng.random_range(0..mesh.triangles().len())];
    let side = rng.random_range(0..3);
    let [a, b] = [side, (side + 1) % 3].map(|i| mesh.positions()[triangle[i] as usize]);
    match rng.random_range(0..4) {
        0 => a,
        _ => a.lerp(b, rng.random()),
    }
}

/// A closed ball of triangles that share their corners: rings of n, between two poles.
fn ball(n: u32) -> Mesh {
    let angle = |i: u32, of: u32| std::f32::consts::PI * i as f32 / of as f32;
    let mut positions = vec![Vec3::Y, -Vec3::Y];
    for ring in 1..n {
        for i in 0..n {
            let (down, around) = (angle(ring, n), 2.0 * angle(i, n));
            positions.push(Vec3::new(
                down.sin() * around.cos(),
                down.cos(),
                down.sin() * around.sin(),
            ));
        }
    }
    let at = |ring: u32, i: u32| 2 + (ring - 1) * n + i % n;
    let mut triangles = Vec::new();
    for i in 0..n {
        triangles.push([0, at(1, i + 1), at(1, i)]);
        triangles.push([1, at(n - 1, i), at(n - 1, i + 1)]);
        for ring in 1..n - 1 {
            let [a, b] = [at(ring, i), at(ring, i + 1)];
            let [c, d] = [at(ring + 1, i), at(ring + 1, i + 1)];
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    Mesh::new(positions, triangles, None, None).expect("a ball is sound")
}
