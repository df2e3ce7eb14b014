//! All structures, behind one face. A new one is a line in [`facets`], and one in [`things`] if it takes any shapes.

use crate::agreement::scenes::Thing;
use raybook::accel::{
    Accel, Count, Tests,
    bvh::Bvh,
    grid::Grid,
    list::List,
    octree::Octree,
    two_level_grid::TwoLevelGrid,
    wide_bvh::{Kernel, WideBvh},
};
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::{Hit, Shape, mesh::Facet};

/// A structure under test.
pub(super) trait Checked<S> {
    fn validate(&self) -> Result<(), String>;
    fn closest(&self, ray: &Ray, within: Interval) -> Option<(S, Hit)>;
    fn closest_counted(&self, ray: &Ray, within: Interval) -> (Option<(S, Hit)>, Tests);
    fn any(&self, ray: &Ray, within: Interval) -> bool;
}

/// An accelerator with its own statement of what is valid.
struct Structure<A> {
    accel: A,
    validate: fn(&A) -> Result<(), String>,
}

impl<S: Shape + Copy, A: Accel<S>> Checked<S> for Structure<A> {
    fn validate(&self) -> Result<(), String> {
        (self.validate)(&self.accel)
    }

    fn closest(&self, ray: &Ray, within: Interval) -> Option<(S, Hit)> {
        let closest = self.accel.closest(ray, within);
        closest.map(|(shape, hit)| (*shape, hit))
    }

    fn closest_counted(&self, ray: &Ray, within: Interval) -> (Option<(S, Hit)>, Tests) {
        let mut tests = Tests::default();
        let closest = self.accel.closest_counted(ray, within, &mut tests);
        (closest.map(|(shape, hit)| (*shape, hit)), tests)
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        self.accel.any(ray, within)
    }
}

type Named<S> = (&'static str, Box<dyn Checked<S>>);

fn named<S: Shape + Copy, A: Accel<S> + 'static>(
    name: &'static str,
    accel: A,
    validate: fn(&A) -> Result<(), String>,
) -> Named<S> {
    (name, Box::new(Structure { accel, validate }))
}

/// All structures over facets.
pub(super) fn facets(shapes: &[Facet]) -> Vec<Named<Facet>> {
    let shapes = || shapes.to_vec();
    vec![
        named("Grid", Grid::of_facets(shapes()), Grid::validate),
        named("Grid::new", Grid::new(shapes()), Grid::validate),
        named(
            "TwoLevelGrid",
            TwoLevelGrid::of_facets(shapes()),
            TwoLevelGrid::validate,
        ),
        named(
            "TwoLevelGrid::new",
            TwoLevelGrid::new(shapes()),
            TwoLevelGrid::validate,
        ),
        named("Octree", Octree::of_facets(shapes()), Octree::validate),
        named("Octree::new", Octree::new(shapes()), Octree::validate),
        named("Bvh", Bvh::new(shapes()), Bvh::validate),
        named("WideBvh", WideBvh::new(shapes()), WideBvh::validate),
        named(
            "WideBvh, cut",
            raybook::inside::wide_bvh::cut(shapes()),
            WideBvh::validate,
        ),
        named(
            "WideBvh, portable",
            WideBvh::new(shapes()).with(Kernel::PORTABLE),
            WideBvh::validate,
        ),
    ]
}

/// All structures over shapes of any kind.
pub(super) fn things(shapes: &[Thing]) -> Vec<Named<Thing>> {
    let shapes = || shapes.to_vec();
    vec![
        named("Grid", Grid::new(shapes()), Grid::validate),
        named(
            "TwoLevelGrid",
            TwoLevelGrid::new(shapes()),
            TwoLevelGrid::validate,
        ),
        named("Octree", Octree::new(shapes()), Octree::validate),
        named("Bvh", Bvh::new(shapes()), Bvh::validate),
    ]
}

/// How a structure can be wrong.
#[derive(Clone, Copy, Debug)]
pub(super) enum Wrong {
    /// One shape is in no leaf.
    ForgetsOne,
    /// The hit found last is returned, not the nearest.
    Last,
    /// The interval is taken for a half line.
    IgnoresTheEnd,
}

/// A wrong structure.
pub(super) fn wrong(wrong: Wrong, shapes: &[Facet]) -> Box<dyn Checked<Facet>> {
    let kept = match wrong {
        Wrong::ForgetsOne => &shapes[..shapes.len().saturating_sub(1)],
        Wrong::Last | Wrong::IgnoresTheEnd => shapes,
    };
    let accel = WrongList {
        shapes: kept.to_vec(),
        list: List::new(kept.to_vec()),
        wrong,
    };
    named("wrong", accel, |_| Ok(())).1
}

struct WrongList {
    shapes: Vec<Facet>,
    list: List<Facet>,
    wrong: Wrong,
}

impl Accel<Facet> for WrongList {
    fn closest_counted(
        &self,
        ray: &Ray,
        within: Interval,
        count: &mut impl Count,
    ) -> Option<(&Facet, Hit)> {
        match self.wrong {
            Wrong::ForgetsOne => self.list.closest_counted(ray, within, count),
            Wrong::Last => {
                let hits = self
                    .shapes
                    .iter()
                    .map(|shape| (shape, shape.hit(ray, within)));
                hits.inspect(|_| count.tested_shape())
                    .filter_map(|(shape, hit)| Some((shape, hit?)))
                    .last()
            }
            Wrong::IgnoresTheEnd => {
                let within = Interval::new(within.min, f32::INFINITY);
                self.list.closest_counted(ray, within, count)
            }
        }
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        self.list.any(ray, within)
    }
}
