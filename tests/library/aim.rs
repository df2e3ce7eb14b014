//! The one generator of rays that structures dislike: they run by a few units in the last place beside the planes that a
//! structure owns, at its corners, along axes, and at the edges of the facets.

use glam::Vec3;
use rand::RngExt;
use raybook::accel::{
    bvh::Bvh, grid::Grid, octree::Octree, two_level_grid::TwoLevelGrid, wide_bvh::WideBvh,
};
use raybook::inside;
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook::shape::{Shape, mesh::Facet};

/// The places of planes along each axis, in metres.
#[derive(Clone, Debug, Default)]
pub(crate) struct Planes([Vec<f32>; 3]);

impl Planes {
    /// The faces of boxes.
    pub(crate) fn of_boxes(boxes: impl IntoIterator<Item = Aabb>) -> Self {
        let mut planes = Self::default();
        for bounds in boxes {
            for (axis, along) in planes.0.iter_mut().enumerate() {
                along.extend([bounds.min[axis], bounds.max[axis]]);
            }
        }
        for along in &mut planes.0 {
            along.retain(|place| place.is_finite());
            along.sort_unstable_by(f32::total_cmp);
            along.dedup();
        }
        planes
    }
}

/// A structure whose planes rays are aimed at.
pub(crate) trait Owner {
    /// The faces of all its boxes and cells.
    fn planes(&self) -> Planes;
}

impl<S: Shape> Owner for Grid<S> {
    fn planes(&self) -> Planes {
        let lattice = inside::grid::lattice(self);
        Planes::of_boxes(lattice.all().map(|cell| lattice.bounds_of(cell, cell)))
    }
}

impl<S: Shape> Owner for TwoLevelGrid<S> {
    fn planes(&self) -> Planes {
        let levels = inside::two_level_grid::levels(self);
        let top = levels.top;
        let coarse = top.all().map(|cell| top.bounds_of(cell, cell));
        let fine = top.all().filter_map(|cell| levels.fine(cell));
        let fine = fine.flat_map(|(_, fine)| fine.all().map(move |c| fine.bounds_of(c, c)));
        Planes::of_boxes(coarse.chain(fine))
    }
}

impl<S: Shape> Owner for Octree<S> {
    fn planes(&self) -> Planes {
        let places = inside::octree::tree(self).places();
        Planes::of_boxes(places.iter().map(|place| place.cell))
    }
}

impl<S: Shape> Owner for Bvh<S> {
    fn planes(&self) -> Planes {
        let (root, pairs) = inside::bvh::nodes(self);
        let below = pairs.iter().flat_map(inside::bvh::Pair::nodes);
        Planes::of_boxes(
            root.copied()
                .into_iter()
                .chain(below)
                .map(|node| node.bounds),
        )
    }
}

impl Owner for WideBvh {
    fn planes(&self) -> Planes {
        let nodes = inside::wide_bvh::tree(self).nodes().iter();
        Planes::of_boxes(nodes.flat_map(|node| node.children().map(|(bounds, _)| bounds)))
    }
}

/// What rays are aimed at.
pub(crate) struct Target<'a> {
    pub(crate) facets: &'a [Facet],
    pub(crate) planes: &'a Planes,
    /// Rays start in this box.
    pub(crate) from: Aabb,
}

impl Target<'_> {
    /// A ray, and the distances that count.
    pub(crate) fn ray(&self, rng: &mut Pcg) -> (Ray, Interval) {
        let from = self.from;
        let origin = self.place(rng).clamp(from.min, from.max);
        let toward = match rng.random_range(0..8_u32) {
            0 => axis(rng),
            1 | 2 => nearly_in_a_plane(rng),
            3 => self.place(rng) - origin,
            // Nearly or exactly in a plane in which the origin is, too.
            4 | 5 => {
                let mut to = self.place(rng);
                let axis = rng.random_range(0..3_usize);
                to[axis] = self.beside(origin[axis], rng);
                to - origin
            }
            _ => self.on_a_facet(rng) - origin,
        };
        let size = self.from.size().max_element();
        let within = match rng.random_range(0..8_u32) {
            0 => {
                let min = size * rng.random::<f32>();
                Interval::new(min, min + size * rng.random::<f32>())
            }
            _ => Interval::AHEAD,
        };
        (Ray::new(origin, Dir3::new_or(toward, Dir3::X)), within)
    }

    /// A place: along each axis mostly beside a plane, else anywhere.
    fn place(&self, rng: &mut Pcg) -> Vec3 {
        let along = |axis: usize| {
            let planes = &self.planes.0[axis];
            let (min, max) = (self.from.min[axis], self.from.max[axis]);
            if planes.is_empty() || rng.random_range(0..3_u32) == 0 {
                min + (max - min) * rng.random::<f32>()
            } else {
                let plane = planes[rng.random_range(0..planes.len())];
                self.beside(plane, rng)
            }
        };
        Vec3::from_array([0, 1, 2].map(along))
    }

    /// A point of a facet's edge, one of its corners, or a point in it; or a few units beside.
    fn on_a_facet(&self, rng: &mut Pcg) -> Vec3 {
        let facet = self.facets[rng.random_range(0..self.facets.len())];
        let first = rng.random_range(0..3_usize);
        let [a, b, c] = [0, 1, 2].map(|i| facet.corners[(first + i) % 3]);
        let p = match rng.random_range(0..3_u32) {
            0 => a,
            1 => a.lerp(b, rng.random()),
            _ => a.lerp(b.lerp(c, rng.random()), rng.random()),
        };
        p.map(|v| self.beside(v, rng))
    }

    /// A number itself, or up to 16 units in the last place beside it; or 10⁻⁹ of the size beside it, where it is about 0.
    fn beside(&self, v: f32, rng: &mut Pcg) -> f32 {
        match rng.random_range(0..4_u32) {
            0 => v,
            1 => v + 1e-9 * self.from.size().max_element() * rng.random_range(-3..=3_i32) as f32,
            _ => {
                let steps = rng.random_range(-16..=16_i32);
                (0..steps.abs()).fold(v, |v, _| {
                    if steps < 0 {
                        v.next_down()
                    } else {
                        v.next_up()
                    }
                })
            }
        }
    }
}

/// An axis, either way, with zeros of both signs.
fn axis(rng: &mut Pcg) -> Vec3 {
    let mut sign = || if rng.random() { 1.0_f32 } else { -1.0 };
    let mut d = Vec3::from_array([0.0_f32; 3].map(|zero| zero * sign()));
    let one = sign();
    d[rng.random_range(0..3_usize)] = one;
    d
}

/// A direction of which one component, or two, are nearly 0.
fn nearly_in_a_plane(rng: &mut Pcg) -> Vec3 {
    const SMALL: [f32; 12] = [
        0.0, 1e-45, 1e-38, 1e-36, 1e-30, 1e-20, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4,
    ];
    let mut d = Vec3::from_array(std::array::from_fn(|_| 2.0 * rng.random::<f32>() - 1.0));
    for _ in 0..rng.random_range(1..=2_u32) {
        let small = SMALL[rng.random_range(0..SMALL.len())];
        d[rng.random_range(0..3_usize)] = if rng.random() { small } else { -small };
    }
    d
}
