//! What a search costs, by the number of shapes: counted, not timed. The plots are in `growth.rs` and `lines.rs`.

use crate::kit::of_each::of_each;
use glam::Vec3;
use rand::RngExt;
use raybook::accel::{Accel, Tests};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::mesh::Facet;

/// How far the rays of a question go in a soup of N triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// From a point in the soup, for the mean distance from one triangle to the next: 1/∛N.
    Near,
    /// From a point in the soup to the first hit, which is a few such distances away.
    Inside,
    /// From outside through a soup of triangles a twentieth as large, so that most rays leave it at the other end.
    Across,
}

/// Beside each size the counts of [`mean_tests`]; the sizes are worked on side by side.
pub fn at_sizes<A: Accel<Facet>>(
    sizes: &[u32],
    reach: Reach,
    build: impl Fn(Vec<Facet>) -> A + Sync,
) -> Vec<(f64, [f64; 2])> {
    let at = |n| (f64::from(n), mean_tests(n, reach, &build));
    of_each(sizes.len(), |i| at(sizes[i]))
}

/// The mean number of boxes and of shapes that a ray tests, in a soup of n triangles.
pub fn mean_tests<A: Accel<Facet>>(
    n: u32,
    reach: Reach,
    build: impl FnOnce(Vec<Facet>) -> A,
) -> [f64; 2] {
    const RAYS: u32 = 4000;
    let facets = soup(n, 1).facets();
    let accel = build(match reach {
        Reach::Across => facets.into_iter().map(small).collect(),
        _ => facets,
    });
    let mut rng = pcg::stream(2, u64::from(n));
    let mut point = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
    let mut draw = || {
        let (from, to) = (point(), point());
        let toward = Dir3::new_or(to - from, Dir3::X);
        let (origin, length) = match reach {
            Reach::Near => (from, 1.0 / (n as f32).cbrt()),
            Reach::Inside => (from, f32::INFINITY),
            Reach::Across => (from - 2.0 * *toward, f32::INFINITY),
        };
        (Ray::new(origin, toward), Interval::new(0.0, length))
    };
    // Drawn one after the other, and then followed by all processors: the rays do not depend on their number.
    let rays: Vec<_> = (0..RAYS).map(|_| draw()).collect();
    let counts = of_each(rays.len(), |i| {
        let (ray, within) = &rays[i];
        let mut tests = Tests::default();
        accel.closest_counted(ray, *within, &mut tests);
        [tests.boxes, tests.shapes]
    });
    [0, 1].map(|of| counts.iter().map(|count| count[of]).sum::<u64>() as f64 / f64::from(RAYS))
}

/// A twentieth of a triangle, where it was.
fn small(facet: Facet) -> Facet {
    let center = facet.corners.iter().sum::<Vec3>() / 3.0;
    Facet {
        corners: facet.corners.map(|p| center + 0.05 * (p - center)),
        ..facet
    }
}

/// The line a + b·log₁₀ N that fits counts best, by least squares: [a, b].
pub fn fit(counts: &[(f64, f64)]) -> [f64; 2] {
    let n = counts.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| counts.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0.log10()), mean(|p| p.1));
    let moved = counts.iter().map(|p| (p.0.log10() - x, p.1 - y));
    let (products, squares) = moved.fold((0.0, 0.0), |sum, (dx, dy)| {
        (sum.0 + dx * dy, sum.1 + dx * dx)
    });
    let slope = products / squares;
    [y - slope * x, slope]
}

/// The power of N that fits counts best: the slope between logarithms.
pub fn power(counts: &[(f64, f64)]) -> f64 {
    let logs: Vec<_> = counts.iter().map(|&(n, y)| (n, y.log10())).collect();
    fit(&logs)[1]
}
