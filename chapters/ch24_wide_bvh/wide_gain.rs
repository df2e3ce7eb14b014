//! What each step from two children to eight gives: in counts, and in time on this machine.

use crate::kit::bars::{Bars, bars};
use crate::kit::figure::Figure;
use raybook::accel::bvh::Bvh;
use raybook::accel::wide_bvh::{Kernel, WideBvh};
use raybook::accel::{Accel, Tests};
use raybook::inside::wide_bvh::in_turns;
use raybook::math::interval::Interval;
use raybook::math::pcg;
use raybook::math::ray::Ray;
use raybook::shape::mesh::{Facet, Mesh};
use std::hint::black_box;
use std::time::Instant;

/// Number of rays in a turn, and number of turns. The best turn counts: other work of the machine can only add time.
const TURN: usize = 5000;
const ROUNDS: usize = 5;

/// Incoherent rays: each from a random point of a sphere around the mesh towards another.
pub(super) fn rays(mesh: &Mesh, n: usize) -> Vec<Ray> {
    use glam::Vec3;
    use rand::RngExt;
    use raybook::math::dir3::Dir3;
    let bounds = mesh.bounds();
    let radius = 0.5 * bounds.size().length();
    let mut rng = pcg::stream(24, 1);
    let mut point = || {
        let p = Vec3::from(std::array::from_fn(|_| rng.random::<f32>() - 0.5));
        bounds.center() + radius * *Dir3::new_or(p, Dir3::Y)
    };
    (0..n)
        .map(|_| {
            let (from, to) = (point(), point());
            Ray::new(from, Dir3::new_or(to - from, Dir3::X))
        })
        .collect()
}

/// Steps per ray, with two children and with eight.
///
/// # Errors
/// What plotters reports.
pub(super) fn steps(rays: &[Ray], two: &Bvh<Facet>, eight: &WideBvh) -> Figure {
    let mut counts = [Tests::default(); 2];
    for ray in rays {
        two.closest_counted(ray, Interval::AHEAD, &mut counts[0]);
        eight.closest_counted(ray, Interval::AHEAD, &mut counts[1]);
    }
    let per_ray = |n: u64| n as f64 / rays.len().max(1) as f64;
    let rows = [
        ("two: pairs of boxes", per_ray(counts[0].boxes / 2)),
        ("eight: nodes", per_ray(counts[1].boxes)),
        ("two: triangles", per_ray(counts[0].shapes)),
        ("eight: triangles", per_ray(counts[1].shapes)),
    ];
    let note = "each pair, each node of eight, and up to eight triangles at once are one step";
    bars(&[Bars {
        title: "Steps of a ray, with two children and with eight",
        unit: "a ray",
        rows: &rows,
        note,
    }])
}

/// A name, and a function that follows a list of rays.
type Contestant<'a> = (&'a str, &'a dyn Fn(&[Ray]));

/// Million rays per second for each step of the way, on one thread.
///
/// # Errors
/// What plotters reports.
pub(super) fn gain(rays: &[Ray], two: &Bvh<Facet>, eight: &WideBvh, note: &str) -> Figure {
    let portable = eight.clone().with(Kernel::PORTABLE);
    let each = |rays: &[Ray], hits: &dyn Fn(&Ray) -> bool| {
        for ray in rays {
            black_box(hits(black_box(ray)));
        }
    };
    let ahead = Interval::AHEAD;
    let contestants: [Contestant; 4] = [
        ("two children", &|rays| {
            each(rays, &|ray| two.closest(ray, ahead).is_some());
        }),
        ("eight, any processor", &|rays| {
            each(rays, &|ray| portable.closest(ray, ahead).is_some());
        }),
        ("eight, this processor", &|rays| {
            each(rays, &|ray| eight.closest(ray, ahead).is_some());
        }),
        ("16 rays in turn", &|rays| {
            black_box(in_turns(eight, rays, ahead));
        }),
    ];
    let mut seconds = [0.0; 4];
    for some in rays.chunks(TURN) {
        let mut best = [f64::INFINITY; 4];
        for _ in 0..ROUNDS {
            for (best, (_, run)) in best.iter_mut().zip(&contestants) {
                let start = Instant::now();
                run(some);
                *best = best.min(start.elapsed().as_secs_f64());
            }
        }
        for (sum, best) in seconds.iter_mut().zip(best) {
            *sum += best;
        }
    }
    let rate = |seconds: f64| 1e-6 * rays.len() as f64 / seconds.max(1e-9);
    let names = contestants.iter().map(|(name, _)| *name);
    let rows: Vec<_> = names.zip(seconds.map(rate)).collect();
    bars(&[Bars {
        title: "Rays per second, one thread",
        unit: "million",
        rows: &rows,
        note,
    }])
}
