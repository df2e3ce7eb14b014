//! The child of a cell in which a point lies.

use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::view::{AXES, shrunk};
use crate::explain::way::Way;
use glam::{DVec2, DVec3, Vec3, dvec2};
use raybook_workbook::exercises::ch10_octree::OctreeChild;

/// The same by the share of the cell that lies below the point, in halves.
fn by_halves(asked: &OctreeChild, way: &mut Way) -> u32 {
    let [min, max, p] = [asked.min, asked.max, asked.p].map(Vec3::as_dvec3);
    let low = way.part("min in p − min", min);
    let above = way.part("p − min", p - low);
    let size = way.part("max − min", max - min);
    let halves = way.part("2·(p − min)/(max − min)", 2.0 * above / size);
    let whole = way.part("the same, rounded down", halves.floor());
    let digits = way.part("the same, 1 at most", whole.min(DVec3::ONE));
    let weights = way.part("the weights of x, y and z", DVec3::new(1.0, 2.0, 4.0));
    way.part("4·z + 2·y + x", digits.dot(weights)) as u32
}

impl Explained for OctreeChild {
    const WAYS: &'static [fn(&Self, &mut Way) -> u32] = &[Self::work, by_halves];

    fn work(&self, way: &mut Way) -> u32 {
        let [min, max, p] = [self.min, self.max, self.p].map(Vec3::as_dvec3);
        let min = way.part("min", min);
        let max = way.part("max", max);
        let p = way.part("p", p);
        let sum = way.part("min + max", min + max);
        let center = way.vector("the cell's middle, (min + max)/2", "m", 0.5 * sum);
        let mut digits = DVec3::ZERO;
        for (axis, name) in AXES.iter().enumerate() {
            let middle = way.part("the middle along an axis", center[axis]);
            let at = way.part("the point's coordinate", p[axis]);
            let is_upper = way.is_at_most("the point is in the upper half", middle, at);
            let half = ["lower half: 0", "upper half: 1"][usize::from(is_upper)];
            way.remark(format!("Along {name} the point is in the {half}."));
            digits[axis] = u8::from(is_upper).into();
        }
        let digits = way.part("the halves along (x, y, z), 0 or 1", digits);
        let weights = way.part("the weights of x, y and z", DVec3::new(1.0, 2.0, 4.0));
        way.number("4·z + 2·y + x", "", digits.dot(weights)) as u32
    }

    fn draw(&self, right: &u32, yours: Option<&u32>) -> Option<Diagram> {
        let [min, max, p] = [self.min, self.max, self.p].map(Vec3::as_dvec3);
        let mut drawing = Diagram::new(
            "The two layers of children, seen along z: x to the right, y upwards; each child with its number",
        );
        let size = (max - min).max(DVec3::splat(1e-30));
        // Side by side, in units of the cell's extents.
        let corner = |child: u32| {
            let layer = 1.3 * f64::from(child >> 2);
            dvec2(
                layer + 0.5 * f64::from(child & 1),
                0.5 * f64::from(child >> 1 & 1),
            )
        };
        let square = |child: u32, share: f64| {
            let (low, high) = (corner(child), corner(child) + 0.5);
            shrunk(
                [low, dvec2(high.x, low.y), high, dvec2(low.x, high.y)],
                share,
            )
        };
        drawing.area(&square(*right, 0.94), Ink::Right);
        if let Some(yours) = yours.filter(|child| **child < 8) {
            drawing.area(&square(*yours, 0.8), Ink::Yours);
        }
        for child in 0..8 {
            let mut outline = square(child, 1.0).to_vec();
            outline.push(outline[0]);
            drawing.line(&outline, Ink::Guide);
            drawing.label(
                corner(child) + dvec2(0.06, 0.06),
                DVec2::ZERO,
                format!("{child}"),
                Ink::Guide,
            );
        }
        for (layer, name) in ["the lower half along z", "the upper half along z"]
            .iter()
            .enumerate()
        {
            drawing.label(
                dvec2(1.3 * layer as f64 + 0.5, 1.0),
                dvec2(0.0, 1.0),
                *name,
                Ink::Shape,
            );
        }
        let layer = 1.3 * f64::from(right >> 2);
        let place = ((p - min) / size).clamp(DVec3::ZERO, DVec3::ONE);
        let place = dvec2(layer + place.x, place.y);
        drawing.point(place, Ink::Shape);
        drawing.label(place, dvec2(0.6, 0.8), "p", Ink::Shape);
        Some(drawing)
    }
}
