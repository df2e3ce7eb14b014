//! All kernels of the wide tree find the same hits, bit for bit. `tests/wasm` runs this in WebAssembly, where a program can
//! say nothing but that it panics.

use glam::Vec3;
use rand::RngExt;
use raybook::accel::{
    Accel,
    wide_bvh::{Kernel, WideBvh},
};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::{Hit, mesh::Mesh, teapot};

/// Rays through each mesh.
const RAYS: usize = 10_000;

fn main() {
    let kernels: Vec<_> = Kernel::all().into_iter().map(Kernel::name).collect();
    println!("kernels: {}", kernels.join(", "));
    let expected = option_env!("RAYBOOK_KERNEL").unwrap_or(kernels[0]);
    assert_eq!(kernels[0], expected, "the fastest kernel of this processor");
    for mesh in [teapot::mesh(4), soup(3_000, 5)] {
        let hits = agree(&mesh);
        println!("{hits} hits of {RAYS} rays, the same by all kernels");
        assert!(hits > RAYS / 4, "rays must hit, or agreement says little");
    }
}

/// How many rays hit; all kernels say the same of each ray.
fn agree(mesh: &Mesh) -> usize {
    let tree = WideBvh::new(mesh.facets());
    let kernels = Kernel::all().into_iter();
    let trees: Vec<_> = kernels.map(|kernel| tree.clone().with(kernel)).collect();
    let mut rng = pcg::stream(1, 0);
    let bounds = mesh.bounds();
    let mut place = |spread: f32| {
        let part = Vec3::from(rng.random::<[f32; 3]>()) - 0.5;
        bounds.center() + spread * part * bounds.size()
    };
    for origin in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY].map(Vec3::splat) {
        let nowhere = Ray::new(origin, Dir3::X);
        assert!(
            trees
                .iter()
                .all(|tree| !tree.any(&nowhere, Interval::AHEAD))
        );
    }
    let mut hits = 0;
    for _ in 0..RAYS {
        let (from, to) = (place(3.0), place(1.0));
        let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
        let answers = trees.iter().map(|tree| {
            let hit = tree
                .closest(&ray, Interval::AHEAD)
                .map(|(_, hit)| bits(&hit));
            assert_eq!(hit.is_some(), tree.any(&ray, Interval::AHEAD), "{ray:?}");
            hit
        });
        let answers: Vec<_> = answers.collect();
        assert!(answers.iter().all(|hit| *hit == answers[0]), "{ray:?}");
        hits += usize::from(answers[0].is_some());
    }
    hits
}

/// A hit, bit for bit.
fn bits(hit: &Hit) -> [u32; 4] {
    let [u, v] = hit.uv.to_array().map(f32::to_bits);
    [hit.t.to_bits(), u, v, hit.id]
}
