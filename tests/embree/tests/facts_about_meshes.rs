//! How Embree behaves where two triangles meet, beside raybook: rows of the table in `src/lib.rs`.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::accel::{Accel, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::shape::mesh::Mesh;
use raybook_common::oracle::target::Solid;
use raybook_embree::embree::{Embree, Mode};

#[test]
fn of_two_equal_triangles_raybook_names_the_first() {
    let corners = vec![Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)];
    let twice = Mesh::new(corners, vec![[0, 1, 2]; 2], None, None).expect("a mesh");
    let ray = Ray::new(vec3(0.5, 0.25, 1.0), -Dir3::Z);
    let list = List::new(twice.facets());
    let (first, _) = list.closest(&ray, Interval::AHEAD).expect("a hit");
    assert_eq!(
        first.id, 0,
        "the interval is open: the second is not nearer"
    );
    let embree = Embree::new().expect("Embree works");
    let scene = embree
        .scene(&Solid::Triangles(twice), Mode::Fast)
        .expect("Embree works");
    let theirs = scene.closest(&ray, Interval::AHEAD).expect("a hit");
    assert!(theirs.id < 2, "Embree names one of them: {theirs:?}");
}

/// Rays aimed at the edge between two triangles. (Aimed anywhere, not one in 10⁵ comes so close to an edge.)
#[test]
fn raybook_and_embrees_robust_mode_are_watertight_and_its_fast_mode_is_not() {
    let corners = vec![
        vec3(-1.3, 0.2, 0.1),
        vec3(1.1, -0.9, 0.3),
        vec3(1.7, 0.7, -0.2),
        vec3(-0.8, 1.9, 0.4),
    ];
    let (from, to) = (corners[0], corners[2]);
    let mesh = Mesh::new(corners, vec![[0, 1, 2], [2, 3, 0]], None, None).expect("a mesh");
    let list = List::new(mesh.facets());
    let embree = Embree::new().expect("Embree works");
    let scenes = [Mode::Fast, Mode::Robust].map(|mode| {
        embree
            .scene(&Solid::Triangles(mesh.clone()), mode)
            .expect("Embree works")
    });
    let mut rng = pcg::stream(5, 5);
    let mut slips = [0; 3];
    for _ in 0..100_000 {
        let on_edge = from.lerp(to, rng.random_range(0.1..0.9_f32));
        let origin = on_edge + vec3(rng.random(), rng.random(), 3.0 * rng.random::<f32>() + 1.0);
        let ray = Ray::new(origin, Dir3::new(on_edge - origin).expect("a direction"));
        let hit = [
            list.any(&ray, Interval::AHEAD),
            scenes[0].closest(&ray, Interval::AHEAD).is_some(),
            scenes[1].closest(&ray, Interval::AHEAD).is_some(),
        ];
        for (slips, hit) in slips.iter_mut().zip(hit) {
            *slips += u32::from(!hit);
        }
    }
    let [ours, fast, robust] = slips;
    for (who, slips) in [("raybook", ours), ("Embree's robust mode", robust)] {
        assert_eq!(slips, 0, "{who} has the same sign on both sides of an edge");
    }
    // It computes each triangle's barycentrics by itself: about one ray in 20 is rounded outside of both.
    assert!(
        (1_000..20_000).contains(&fast),
        "of 100,000 rays at the edge, {fast} slip through Embree's fast mode"
    );
}
