//! How the work of a ray grows with the number of triangles, by counts. The list takes N steps; all others far fewer.
//!
//! An empty grid has N^⅓ cells on a ray's way; in this soup a ray is stopped after a few of them, however small they are, and the
//! more triangles there are, the sooner: all powers but the list's are below ⅓, and no power is exact.

use glam::{UVec3, Vec3};
use rand::RngExt;
use raybook::accel::{
    Accel, Tests, bvh::Bvh, grid::Grid, list::List, octree::Octree, two_level_grid::TwoLevelGrid,
    wide_bvh::WideBvh,
};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::mesh::Facet;
use raybook_common::statistics::slope;

/// Triangles of the soups: each √10 times as many as the one before.
const SIZES: [u32; 6] = [100, 316, 1_000, 3_162, 10_000, 31_623];

/// A power of N to which steps grow.
struct Power {
    /// As it was measured when this was written, by least squares.
    measured: f64,
    /// Two standard errors of that fit.
    error: f64,
}

const LIST: Power = Power {
    measured: 1.0,
    error: 0.0,
};
const GRID: Power = Power {
    measured: 0.194,
    error: 0.033,
};
const TWO_LEVEL_GRID: Power = Power {
    measured: 0.205,
    error: 0.037,
};
const OCTREE: Power = Power {
    measured: 0.209,
    error: 0.033,
};
const BVH: Power = Power {
    measured: 0.277,
    error: 0.046,
};
const WIDE_BVH: Power = Power {
    measured: 0.230,
    error: 0.043,
};

/// What a power may differ beyond its error, for a builder that decides a little otherwise: 6 % of the steps between the smallest
/// size and the largest.
const RESERVE: f64 = 0.01;

/// Logarithms of the size and of the boxes and shapes that 300 rays test.
type Points = [(f64, f64); SIZES.len()];

fn points<A: Accel<Facet>>(build: impl Fn(Vec<Facet>) -> A) -> Points {
    SIZES.map(|n| {
        let accel = build(soup(n, 1).facets());
        let mut rng = pcg::stream(9, 0);
        let mut at = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
        let mut tests = Tests::default();
        for _ in 0..300 {
            let (from, to) = (3.0 * at() - 1.0, at());
            let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
            accel.closest_counted(&ray, Interval::AHEAD, &mut tests);
        }
        let steps = (tests.boxes + tests.shapes) as f64;
        (f64::from(n).ln(), steps.ln())
    })
}

impl Power {
    /// Whether the points grow with this power.
    fn fits(&self, points: &Points) -> bool {
        (slope(points).0 - self.measured).abs() <= self.error + RESERVE
    }

    /// Fails if the steps do not grow with this power, or if they could grow with another one unseen.
    #[track_caller]
    fn assert_fits<A: Accel<Facet>>(&self, build: impl Fn(Vec<Facet>) -> A) {
        let points = points(build);
        assert!(
            self.fits(&points),
            "steps grow as N^{:.3}, and not as N^({} ± {})",
            slope(&points).0,
            self.measured,
            self.error + RESERVE
        );
        for factor in [0.75, 1.25, 2.0] {
            let other = points.map(|(n, steps)| (n, factor * steps));
            assert!(!self.fits(&other), "{factor} times the power passes, too");
        }
    }
}

#[test]
fn the_list_is_linear() {
    LIST.assert_fits(List::new);
}

#[test]
fn a_grid_grows_as_measured() {
    GRID.assert_fits(Grid::of_facets);
}

#[test]
fn a_two_level_grid_grows_as_measured() {
    TWO_LEVEL_GRID.assert_fits(TwoLevelGrid::of_facets);
}

#[test]
fn an_octree_grows_as_measured() {
    OCTREE.assert_fits(Octree::of_facets);
}

#[test]
fn trees_of_boxes_grow_as_measured() {
    BVH.assert_fits(Bvh::new);
    WIDE_BVH.assert_fits(WideBvh::new);
}

/// Such as one that forgets to make its cells smaller.
#[test]
fn a_structure_that_does_not_scale_is_seen() {
    let coarse = points(|facets| Grid::of_facets_with_resolution(facets, UVec3::splat(8)));
    for power in [GRID, TWO_LEVEL_GRID, OCTREE, BVH, WIDE_BVH] {
        let found = slope(&coarse).0;
        assert!(
            !power.fits(&coarse),
            "N^{found} passes for N^{}",
            power.measured
        );
    }
}
