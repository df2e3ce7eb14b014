//! Path tracing allocates nothing per ray: counted by an allocator that counts.

#![allow(unsafe_code)] // an allocator is an unsafe trait; this one only counts and passes on

use glam::Vec3;
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::{mis::Strategy, path::Path};
use raybook::scene::{cornell, plates};
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicU64, Ordering};

static ALLOCATIONS: AtomicU64 = AtomicU64::new(0);

struct Counting;

// SAFETY: everything is done by the system's allocator, under its own contract.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn a_thousand_paths_allocate_nothing() {
    for (scene, eye) in [
        (cornell::cornell_box(), cornell::EYE),
        (plates::plates(), plates::EYE),
    ] {
        let toward = if eye.z < 0.0 { Vec3::Z } else { Vec3::NEG_Z };
        let ray = Ray::new(eye, Dir3::new(toward).expect("a direction"));
        for strategy in [Strategy::Surface, Strategy::Light, Strategy::Both] {
            let path = Path {
                depth: 8,
                sure: 3,
                strategy,
            };
            let mut rng = pcg::stream(1, 1);
            let before = ALLOCATIONS.load(Ordering::Relaxed);
            let sum: f32 = (0..1000)
                .map(|_| path.radiance(&scene, &ray, &mut rng).g)
                .sum();
            let allocations = ALLOCATIONS.load(Ordering::Relaxed) - before;
            assert!(sum > 0.0, "{strategy:?}: the paths see light");
            assert_eq!(allocations, 0, "{strategy:?}: allocations in 1000 paths");
        }
    }
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    drop(std::hint::black_box(vec![1_u8]));
    assert!(
        ALLOCATIONS.load(Ordering::Relaxed) > before,
        "the counter counts"
    );
}
