//! Where planes across an axis meet a triangle.

use crate::accel::bvh::build::item::Bounds;
use crate::shape::mesh::Facet;
use glam::Vec3A;

/// A triangle along an axis: its long edge leads from the lowest corner a to the highest c, and a way around it over the middle
/// corner b. A plane between a and c meets each of the two once.
///
/// Where is x on the three edges a–c, a–b and b–c? At t = (x − start)/(end − start), from 0 to 1: so the plane at x meets the long
/// edge at a + t₀·(c − a), and the way around it at a + t₁·(b − a) + t₂·(c − b).
pub(super) struct Profile {
    lowest: Vec3A,
    /// c − a, b − a and c − b.
    edges: [Vec3A; 3],
    /// Where the edges start along the axis, and 1/(end − start).
    starts: Vec3A,
    per_metre: Vec3A,
    /// The box of the middle corner, and where it is along the axis.
    corner: Bounds,
    middle: f32,
}

/// Where a plane is, and the box of the points at which it meets the triangle.
pub(super) struct Section {
    at: f32,
    bounds: Bounds,
}

impl Profile {
    pub(super) fn new(facet: &Facet, axis: usize) -> Self {
        let places = facet.corners.map(|corner| corner.to_array()[axis]);
        // Without a branch, for no processor can guess the order: two numbers, which differ even where places are equal.
        let [p, q, r] = places;
        let low = if r < p.min(q) { 2 } else { usize::from(q < p) };
        let high = if r >= p.max(q) { 2 } else { usize::from(q > p) };
        let order = [low, 3 - low - high, high];
        let [a, b, c] = order.map(|i| Vec3A::from(facet.corners[i]));
        let [from, middle, to] = order.map(|i| places[i]);
        let starts = Vec3A::new(from, from, middle);
        let lengths = Vec3A::new(to, middle, to) - starts;
        Self {
            lowest: a,
            edges: [c - a, b - a, c - b],
            starts,
            // Finite: an edge in a plane is at its start there, and at its end beyond.
            per_metre: lengths.max(Vec3A::splat(f32::MIN_POSITIVE)).recip(),
            corner: Bounds { min: b, max: b },
            middle,
        }
    }

    /// The box of the part between two planes, from the boxes of the points at which they meet the triangle.
    pub(super) fn between(&self, below: &Section, above: &Section) -> Bounds {
        let part = below.bounds.union(&above.bounds);
        if below.at <= self.middle && self.middle <= above.at {
            part.union(&self.corner)
        } else {
            part
        }
    }

    /// The box of the two points at which a plane meets the triangle; of the lowest or the highest corner, if it is beyond them.
    pub(super) fn at(&self, x: f32) -> Section {
        let t = (Vec3A::splat(x) - self.starts) * self.per_metre;
        let t = t.max(Vec3A::ZERO).min(Vec3A::ONE);
        let [whole, before, after] = self.edges;
        let long = self.lowest + whole * t.x;
        let around = self.lowest + before * t.y + after * t.z;
        let bounds = Bounds {
            min: long.min(around),
            max: long.max(around),
        };
        Section { at: x, bounds }
    }
}
