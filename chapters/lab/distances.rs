//! Distances of points to their nearest neighbours, measured over the edges too, as on a torus.

use glam::Vec2;
use raybook::inside::Space;
use raybook::sample::pattern::dart_throwing::largest_distance;

/// The distance of each point to its nearest neighbour, over the edges too: infinite for a point that is alone.
pub fn nearest(points: &[Vec2]) -> Vec<f64> {
    let mut squared = vec![f64::INFINITY; points.len()];
    for i in 0..points.len() {
        for j in 0..i {
            let distance = Space::Torus.distance_squared(points[i], points[j]);
            squared[i] = squared[i].min(distance);
            squared[j] = squared[j].min(distance);
        }
    }
    squared.into_iter().map(f64::sqrt).collect()
}

/// The least and the mean distance to the nearest neighbour, as shares of √(2/(√3·n)), the largest least distance that n points can
/// have: that of a hexagonal lattice.
///
/// Random points have a mean distance of 1/(2√n), which is 0.465 of this distance (Clark and Evans, *Distance to nearest neighbor
/// as a measure of spatial relationships in populations*, 1954). The least distance is the relative radius of Lagae and Dutré, *A
/// comparison of methods for generating Poisson disk distributions*, 2008: for a good Poisson disk 0.65 to 0.85. A single point
/// has 0 of both.
pub fn relative(points: &[Vec2]) -> [f64; 2] {
    if points.len() < 2 {
        return [0.0; 2];
    }
    let all = nearest(points);
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    [least, mean].map(|distance| distance / largest_distance(points.len()))
}
