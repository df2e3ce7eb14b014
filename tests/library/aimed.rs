//! No structure loses a hit, and none finds a wrong one: rays aimed beside every plane that it owns are answered as the list
//! answers them.
//!
//! `RAYBOOK_RAYS=50 cargo test --release -p raybook --test library -- aimed` asks 50 times as many rays.

mod rooms;

use crate::aim::{Owner, Target};
use glam::Vec3;
use raybook::accel::bvh::{Bvh, build::Method};
use raybook::accel::{
    Accel,
    grid::Grid,
    list::List,
    octree::Octree,
    two_level_grid::TwoLevelGrid,
    wide_bvh::{Kernel, WideBvh},
};
use raybook::math::{aabb::Aabb, interval::Interval, pcg};
use raybook::shape::{ROUNDING, mesh::Facet};
use rooms::{Room, rooms};

/// Rays in all, for each structure, if nobody wants more.
const RAYS: usize = 100_000;

fn times() -> usize {
    let times = std::env::var("RAYBOOK_RAYS").ok();
    times.and_then(|times| times.parse().ok()).unwrap_or(1)
}

/// Asks rays about all scenes; counts the hits, and says which of the rays had a wrong answer.
fn asked<A: Accel<Facet> + Owner>(name: &str, build: impl Fn(Vec<Facet>) -> A) {
    let (mut rays, mut hits, mut lost, mut wrong, mut leaks) = (0_u64, 0_u64, 0_u64, 0_u64, 0_u64);
    let mut first = None;
    let rooms = rooms();
    let each = RAYS * times() / rooms.len();
    for (
        number,
        Room {
            what,
            facets,
            inside,
        },
    ) in rooms.iter().enumerate()
    {
        let (accel, list) = (build(facets.clone()), List::new(facets.clone()));
        let planes = accel.planes();
        let bounds = Aabb::of(facets.iter().flat_map(|facet| facet.corners));
        let around = bounds.grown(0.25 * bounds.size().max_element());
        let mut rng = pcg::stream(1, number as u64);
        for i in 0..each {
            let from = inside.filter(|_| i % 2 == 0).unwrap_or(around);
            let (ray, within) = Target {
                facets,
                planes: &planes,
                from,
            }
            .ray(&mut rng);
            let expected = list.closest(&ray, within).map(|(_, hit)| hit.t);
            let found = accel.closest(&ray, within).map(|(_, hit)| hit.t);
            let any = accel.any(&ray, within);
            rays += 1;
            hits += u64::from(expected.is_some());
            let is_lost = expected.is_some() && (found.is_none() || !any);
            let numbers = [bounds.min, bounds.max, ray.origin].map(|p| p.abs().max_element());
            let largest = numbers.into_iter().chain(expected).fold(0.0, f32::max);
            let is_wrong = match (expected, found) {
                (Some(expected), Some(found)) => (expected - found).abs() > ROUNDING * largest,
                (None, found) => any || found.is_some(),
                (Some(_), None) => false,
            };
            lost += u64::from(is_lost);
            wrong += u64::from(is_wrong);
            leaks += u64::from(
                inside.is_some() && i % 2 == 0 && within == Interval::AHEAD && found.is_none(),
            );
            if (is_lost || is_wrong) && first.is_none() {
                first = Some(format!(
                    "{what}: {ray:?} {within:?}: list {expected:?}, found {found:?}, any {any}"
                ));
            }
        }
    }
    println!("{name:24} {rays:9} rays {hits:9} hits {lost:6} lost {wrong:6} wrong {leaks:6} leaks");
    assert!(3 * hits > rays, "{name}: only {hits} of {rays} rays hit");
    assert_eq!(
        (lost, wrong, leaks),
        (0, 0, 0),
        "{name}: lost, wrong, and out of a closed room; the first: {first:?}"
    );
}

macro_rules! aimed {
    ($($test:ident: $build:expr;)+) => {
        $(
            #[test]
            fn $test() {
                asked(stringify!($test), $build);
            }
        )+
    };
}

aimed! {
    grid: Grid::of_facets;
    grid_by_bounds: Grid::new;
    two_level_grid: TwoLevelGrid::of_facets;
    two_level_grid_by_bounds: TwoLevelGrid::new;
    octree: Octree::of_facets;
    octree_by_bounds: Octree::new;
    bvh_binned: Bvh::new;
    bvh_median: |facets| Bvh::build(facets, Method::Median);
    bvh_middle: |facets| Bvh::build(facets, Method::Middle);
    bvh_sweep: |facets| Bvh::build(facets, Method::Sweep);
    bvh_fine: |facets| Bvh::build(facets, Method::Fine);
    bvh_bottom_up: |facets| Bvh::build(facets, Method::BottomUp);
    wide_bvh: WideBvh::new;
    wide_bvh_portable: |facets| WideBvh::new(facets).with(Kernel::PORTABLE);
    wide_bvh_by_the_second_kernel: |facets| {
        let kernels = Kernel::all();
        WideBvh::new(facets).with(kernels[1.min(kernels.len() - 1)])
    };
    wide_bvh_cut: raybook::inside::wide_bvh::cut;
    wide_bvh_median: |facets| WideBvh::build(facets, Method::Median);
    wide_bvh_bottom_up: |facets| WideBvh::build(facets, Method::BottomUp);
}

/// The generator finds what it is made for: a structure that moves a ray by a unit in the last place.
#[test]
#[should_panic(expected = "lost, wrong")]
fn a_structure_that_is_a_little_off_is_found_out() {
    struct Off(Bvh<Facet>);
    impl Owner for Off {
        fn planes(&self) -> crate::aim::Planes {
            self.0.planes()
        }
    }
    impl Accel<Facet> for Off {
        fn closest_counted(
            &self,
            ray: &raybook::math::ray::Ray,
            within: Interval,
            count: &mut impl raybook::accel::Count,
        ) -> Option<(&Facet, raybook::shape::Hit)> {
            let moved = Vec3::from(ray.origin.to_array().map(f32::next_up));
            let ray = raybook::math::ray::Ray {
                origin: moved,
                ..*ray
            };
            self.0.closest_counted(&ray, within, count)
        }
        fn any(&self, ray: &raybook::math::ray::Ray, within: Interval) -> bool {
            self.0.any(ray, within)
        }
    }
    asked("off", |facets| Off(Bvh::new(facets)));
}
