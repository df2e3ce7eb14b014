//! Poisson-disk points: random points, none too close to another, with no room left.
//!
//! ```
//! use raybook::inside::Space;
//! use raybook::math::pcg;
//! use raybook::sample::pattern::poisson_disk::poisson_disk;
//!
//! let points = poisson_disk(0.2, Space::Square, &mut pcg::stream(1, 0));
//! let apart = |i: usize| points[..i].iter().all(|q| q.distance(points[i]) > 0.1999);
//! assert!(points.len() > 12 && (0..points.len()).all(apart));
//! ```

use crate::math::pcg::Pcg;
use crate::sample::pattern::dart_throwing::{fill, largest_distance};
use crate::sample::pattern::neighbours::{Neighbours, Space};
use glam::{Vec2, vec2};
use rand::RngExt;
use std::f32::consts::TAU;

/// Number of places that are tried around a point before the point counts as surrounded.
const TRIES: u32 = 30;

/// Minimum distance between points; a smaller one counts as this, because the points would not fit into memory.
pub const LEAST: f32 = 1.0 / 4096.0;

// ANCHOR: poisson_disk
/// Random points that are at least `distance` apart, until hardly another point fits in between (Bridson, "Fast Poisson disk
/// sampling in arbitrary dimensions", 2007).
///
/// New points are tried around an existing point, between one and two distances away. If 30 such places in a row are too close to
/// other points, the point is surrounded. The method ends when all points are surrounded. A `distance` below [`LEAST`] counts as
/// that.
pub fn poisson_disk(distance: f32, space: Space, rng: &mut Pcg) -> Vec<Vec2> {
    let distance = distance.max(LEAST);
    let mut near = Neighbours::new(distance.into(), space);
    let first = vec2(rng.random(), rng.random());
    near.push(first);
    let mut open = vec![first];
    while !open.is_empty() {
        let i = rng.random_range(0..open.len());
        let mut around = (0..TRIES).filter_map(|_| beside(open[i], distance, space, rng));
        if let Some(p) = around.find(|&p| near.has_room(p, distance.into())) {
            near.push(p);
            open.push(p);
        } else {
            open.swap_remove(i);
        }
    }
    near.into_points()
}
// ANCHOR_END: poisson_disk

/// A random point of the ring between one and two distances from p; `None` outside the square.
fn beside(p: Vec2, distance: f32, space: Space, rng: &mut Pcg) -> Option<Vec2> {
    let (r, phi) = (
        distance * rng.random_range(1.0_f32..4.0).sqrt(), // uniform in area
        TAU * rng.random::<f32>(),
    );
    let q = p + r * vec2(phi.cos(), phi.sin());
    let q = match space {
        Space::Square => q,
        Space::Torus => q - q.floor(),
    };
    let inside = |x: f32| (0.0..1.0).contains(&x);
    (inside(q.x) && inside(q.y)).then_some(q)
}

/// The distance d at which Bridson's method finds nearly n points, about 97 % of n.
///
/// On the torus it finds 0.615/d² points. In the plane there are more points along the edges, because no points beyond the edges
/// keep them away: as many as on a torus whose sides are longer by 0.48 d (measured from 2 to 200 points).
pub fn distance_for(n: usize, space: Space) -> f64 {
    const SHARE: f64 = 0.74;
    const LONGER: f64 = 0.48;
    let on_torus = SHARE * largest_distance(n);
    match space {
        Space::Torus => on_torus,
        Space::Square => on_torus / (1.0 - LONGER * on_torus).max(0.5),
    }
}

/// Exactly n Poisson-disk points: nearly all of them by Bridson's method, and the last ones by dart throwing.
pub fn of(n: usize, space: Space, rng: &mut Pcg) -> Vec<Vec2> {
    if n < 2 {
        return fill(Vec::new(), n, space, rng);
    }
    let points = poisson_disk(distance_for(n, space) as f32, space, rng);
    // For a small n, Bridson's method sometimes finds more than n points.
    if points.len() > n {
        return fill(Vec::new(), n, space, rng);
    }
    fill(points, n, space, rng)
}
