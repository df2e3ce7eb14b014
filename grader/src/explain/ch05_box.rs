//! Chapter 5: the box, as what remains of an interval after three slabs.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::way::Way;
use glam::{DVec3, Vec3, dvec2};
use raybook::math::interval::Interval;
use raybook_workbook::exercises::ch05_box::{BoundsOf, BoxClip, Corners};

const AXES: [&str; 3] = ["x", "y", "z"];

/// How a student clips by slabs.
#[derive(Clone, Copy)]
struct Slabs {
    /// Asks first whether the ray runs along two planes; who does not may get NaN where it runs in one of them.
    asks: bool,
    /// Sorts two distances by their size, not by the sign of the direction.
    sorts: bool,
}

/// The reference's way.
const BY_SIGN: Slabs = Slabs {
    asks: false,
    sorts: false,
};

/// The distances at which a ray is between the two planes of a box across an axis.
fn slab(q: &BoxClip, axis: usize, way: &mut Way, how: Slabs) -> [f64; 2] {
    let (o, d) = rays::parts(&q.ray);
    let start = way.part("the start's coordinate", o[axis]);
    let speed = way.part("the direction's component", d[axis]);
    let low = way.part("the box's least coordinate", f64::from(q.min[axis]));
    let high = way.part("the box's greatest coordinate", f64::from(q.max[axis]));
    if how.asks && way.is_zero("the ray runs along two planes", speed) {
        let is_below = way.is_less("such a ray is below the planes", start, low);
        let is_above = way.is_less("such a ray is above the planes", high, start);
        return if is_below || is_above {
            [f64::INFINITY, f64::NEG_INFINITY]
        } else {
            [f64::NEG_INFINITY, f64::INFINITY]
        };
    }
    let from = way.part("the start's coordinate in t of the least plane", start);
    let low = way.part("the least plane, seen from the start", low - from);
    let from = way.part("the start's coordinate in t of the greatest plane", start);
    let high = way.part("the greatest plane, seen from the start", high - from);
    let low = way.part("t of the least plane", low / speed);
    let high = way.part("t of the greatest plane", high / speed);
    if how.sorts {
        let near = way.part("the smaller t", low.min(high));
        return [near, way.part("the larger t", low.max(high))];
    }
    // The sign bit, so that −0.0 is the mirror image of 0.0.
    if way.decides(
        "the ray runs backwards along an axis",
        d[axis].is_sign_negative(),
    ) {
        [high, low]
    } else {
        [low, high]
    }
}

/// The same half-space by half-space: each of the six cuts something off, or nothing, or all (Cyrus and Beck 1978).
fn by_half_spaces(q: &BoxClip, way: &mut Way) -> Option<Interval> {
    let (o, d) = rays::parts(&q.ray);
    let mut enter = way.part("within.min", f64::from(q.within.min));
    let mut leave = way.part("within.max", f64::from(q.within.max));
    for axis in way.rounds("the axes", 3) {
        let start = way.part("the start's coordinate", o[axis]);
        let speed = way.part("the direction's component", d[axis]);
        let low = way.part("the box's least coordinate", f64::from(q.min[axis]));
        let high = way.part("the box's greatest coordinate", f64::from(q.max[axis]));
        let below = way.part("how far the start is below the least plane", low - start);
        let above = way.part(
            "how far the start is above the greatest plane",
            start - high,
        );
        for (outside, speed) in [(below, -speed), (above, speed)] {
            // The ray is inside where outside + t · speed is at most 0.
            let t = way.part("t of a plane", -outside / speed);
            if way.is_zero("the ray runs along a plane", speed) {
                if way.is_less("such a ray is outside of the plane", 0.0, outside) {
                    return None;
                }
            } else if way.is_less("the ray enters through a plane", speed, 0.0) {
                enter = way.part("the later entry", enter.max(t));
            } else {
                leave = way.part("the earlier exit", leave.min(t));
            }
        }
    }
    let remains = way.is_at_most("the end is not before the beginning", 0.0, leave - enter);
    remains.then(|| Interval::new(enter as f32, leave as f32))
}

/// Slab by slab.
fn by_slabs(q: &BoxClip, way: &mut Way, how: Slabs) -> Option<Interval> {
    let mut min = way.part("within.min", f64::from(q.within.min));
    let mut max = way.part("within.max", f64::from(q.within.max));
    for axis in way.rounds("the axes", 3) {
        let name = AXES[axis];
        let [near, far] = slab(q, axis, way, how);
        let planes = way.pair(
            format!("between the planes across {name}"),
            "m",
            dvec2(near, far),
        );
        // `max` and `min` drop the NaN of a ray that runs in a face.
        let enter = way.part("the latest entry before", min);
        let leave = way.part("the earliest exit before", max);
        let left = dvec2(enter.max(planes.x), leave.min(planes.y));
        let left = way.pair(format!("what remains after {name}"), "m", left);
        [min, max] = left.to_array();
    }
    if way.is_at_most("the end is not before the beginning", 0.0, max - min) {
        Some(Interval::new(min as f32, max as f32))
    } else {
        way.remark("The end is before the beginning: nothing remains.");
        None
    }
}

impl Explained for BoxClip {
    const WAYS: &'static [fn(&Self, &mut Way) -> Option<Interval>] = &[
        Self::work,
        by_half_spaces,
        |q, way| {
            let how = Slabs {
                asks: true,
                sorts: true,
            };
            by_slabs(q, way, how)
        },
        |q, way| {
            let how = Slabs {
                asks: true,
                sorts: false,
            };
            by_slabs(q, way, how)
        },
    ];

    fn work(&self, way: &mut Way) -> Option<Interval> {
        by_slabs(self, way, BY_SIGN)
    }

    fn draw(&self, right: &Option<Interval>, yours: Option<&Option<Interval>>) -> Option<Diagram> {
        let slabs = [0, 1, 2].map(|axis| slab(self, axis, &mut Way::default(), BY_SIGN));
        let of = |within: &Interval| [within.min, within.max].map(f64::from);
        let within = of(&self.within);
        let (right, yours) = (
            right.as_ref().map(of),
            yours.copied().flatten().as_ref().map(of),
        );
        let ends = slabs
            .iter()
            .chain([&within])
            .chain(&right)
            .chain(&yours)
            .flatten();
        let ends: Vec<_> = ends.copied().filter(|t| t.is_finite()).collect();
        let least = ends.iter().copied().fold(0.0, f64::min);
        let most = ends.iter().copied().fold(least + 1e-6, f64::max);
        let beyond = 0.15 * (most - least);
        let [start, end] = [least - beyond, most + beyond];
        let mut drawing = Diagram::new(
            "The distances t along the ray that are between each pair of planes, and what all of them share",
        );
        drawing.stretched = true;
        let mut row = |y: f64, name: &str, stretch: Option<[f64; 2]>, ink: Ink| {
            drawing.label(
                dvec2(start, y),
                dvec2(-0.4, 0.0),
                name,
                if ink == Ink::Interval { Ink::Ray } else { ink },
            );
            let Some([from, to]) = stretch else {
                drawing.label(
                    dvec2(0.5 * (start + end), y),
                    dvec2(0.0, 0.0),
                    "nothing",
                    ink,
                );
                return;
            };
            // A face in which the ray runs bounds nothing.
            let [from, to] = [
                if from.is_nan() { start } else { from },
                if to.is_nan() { end } else { to },
            ]
            .map(|t| t.clamp(start, end));
            if from <= to {
                drawing.line(&[dvec2(from, y), dvec2(to, y)], ink);
            } else {
                drawing.label(
                    dvec2(0.5 * (start + end), y),
                    dvec2(0.0, 0.0),
                    "nothing",
                    ink,
                );
            }
        };
        for (axis, name) in AXES.iter().enumerate() {
            row(-(axis as f64), name, Some(slabs[axis]), Ink::Shape);
        }
        row(-3.0, "within", Some(within), Ink::Interval);
        row(-4.0, "right", right, Ink::Right);
        if yours.is_some() {
            row(-5.0, "yours", yours, Ink::Yours);
        }
        drawing.arrow(dvec2(start, -6.0), dvec2(end, -6.0), Ink::Guide);
        drawing.label(dvec2(end, -6.0), dvec2(0.5, 0.0), "t", Ink::Guide);
        for t in [right, yours]
            .into_iter()
            .flatten()
            .flatten()
            .filter(|t| t.is_finite())
        {
            drawing.line(&[dvec2(t, 0.3), dvec2(t, -6.0)], Ink::Guide);
            drawing.label(
                dvec2(t, -6.0),
                dvec2(0.0, -1.2),
                format!("{}", t as f32),
                Ink::Guide,
            );
        }
        Some(drawing)
    }
}

impl Explained for BoundsOf {
    fn work(&self, way: &mut Way) -> Corners {
        let points = || self.points.iter().map(|p| p.as_dvec3());
        if way.decides("there are no points", self.points.is_empty()) {
            way.remark("There are no points: the least of none is +∞, the greatest −∞.");
            return Corners {
                min: Vec3::INFINITY,
                max: Vec3::NEG_INFINITY,
            };
        }
        let min = way.vector(
            "the least x, y and z of all points",
            "m",
            points().fold(DVec3::INFINITY, DVec3::min),
        );
        let max = way.vector(
            "the greatest x, y and z of all points",
            "m",
            points().fold(DVec3::NEG_INFINITY, DVec3::max),
        );
        Corners {
            min: min.as_vec3(),
            max: max.as_vec3(),
        }
    }
}
