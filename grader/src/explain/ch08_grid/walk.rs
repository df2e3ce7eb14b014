//! The walk of a ray from cell to cell.

use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::rays;
use crate::explain::view::{View, middle, shrunk};
use crate::explain::way::Way;
use glam::{DVec2, DVec3, IVec3, UVec3, dvec2};
use raybook_workbook::exercises::ch08_grid::{GridWalk, Visit};

/// A ray's way through a lattice.
struct Through {
    o: DVec3,
    d: DVec3,
    min: DVec3,
    size: DVec3,
    count: UVec3,
    /// Where the interval ends.
    limit: f64,
    /// Where the ray enters the lattice, or the interval begins.
    enter: f64,
    /// Where the ray leaves the lattice, or the interval ends.
    end: f64,
}

/// Where a walk begins.
struct Start {
    through: Through,
    /// The first cell.
    cell: UVec3,
    /// 1 for each axis along which the next plane is the upper one of a cell, 0 where it is the lower one.
    ahead: DVec3,
    /// What is added to the number of a cell along each axis: 1, or −1 where the ray goes backwards.
    step: DVec3,
    /// Along each axis the number of the first cell that is no more in the lattice, of a walk forward.
    above: DVec3,
    /// The same of a walk backwards.
    below: DVec3,
    /// The number of cells along each axis, which a walk stays below in either sense.
    bound: DVec3,
}

impl Through {
    /// None if the ray misses the lattice.
    fn of(asked: &GridWalk, way: &mut Way) -> Option<Self> {
        let (o, d) = rays::parts(&asked.ray);
        let (min, size) = (asked.min.as_dvec3(), asked.cell.as_dvec3());
        let count = UVec3::new(asked.nx, asked.ny, asked.nz);
        let o = way.part("o", o);
        let d = way.part("d", d);
        let min = way.part("min", min);
        let size = way.part("the extents of a cell", size);
        let mut enter = way.part("within.min", f64::from(asked.within.min));
        let limit = way.part("within.max", f64::from(asked.within.max));
        let mut end = limit;
        for axis in 0..3 {
            let planes = [0.0, f64::from(count[axis])]
                .map(|i| (min[axis] + i * size[axis] - o[axis]) / d[axis]);
            let [near, far] = if d[axis].is_sign_negative() {
                [planes[1], planes[0]]
            } else {
                planes
            };
            (enter, end) = (enter.max(near), end.min(far));
        }
        let both = way.pair(
            "the distances at which the ray enters and leaves the lattice",
            "m",
            dvec2(enter, end),
        );
        let [enter, end] = both.to_array();
        if way.is_less("the ray leaves the lattice before it enters", end, enter) {
            way.remark("It leaves before it enters: the ray misses the lattice.");
            return None;
        }
        Some(Self {
            o,
            d,
            min,
            size,
            count,
            limit,
            enter,
            end,
        })
    }

    /// The cell of a place that is measured in cells.
    fn cell(&self, place: DVec3) -> UVec3 {
        let last = self.count.as_ivec3() - 1;
        place.floor().as_ivec3().clamp(IVec3::ZERO, last).as_uvec3()
    }

    /// Whether the ray goes backwards along an axis.
    fn backward(&self, axis: usize) -> bool {
        self.d[axis].is_sign_negative()
    }
}

impl Start {
    /// None if the ray misses the lattice.
    fn of(asked: &GridWalk, way: &mut Way) -> Option<Self> {
        let through = Through::of(asked, way)?;
        let enter = way.part("enter in o + enter·d", through.enter);
        let start = through.o + enter * through.d;
        let start = way.part("o + enter·d", start);
        let inside = way.part("o + enter·d − min", start - through.min);
        let size = way.part("cell in (o + enter·d − min)/cell", through.size);
        let place = way.part("(o + enter·d − min)/cell", inside / size);
        let cell = through.cell(place);
        let is_backward = [0, 1, 2].map(|axis| through.backward(axis));
        let forward = DVec3::from(is_backward.map(|it| f64::from(u8::from(!it))));
        let ahead = way.part(
            "the plane ahead: 1 for a cell's upper one, 0 for the lower one where the ray goes backwards",
            forward,
        );
        let above = way.part(
            "the number at which the walk ends where the ray goes forward",
            through.count.as_dvec3(),
        );
        let below = way.part(
            "the number at which the walk ends where the ray goes backwards",
            DVec3::NEG_ONE,
        );
        let bound = way.part(
            "the number of cells, which a cell's number is below whichever way the ray goes",
            through.count.as_dvec3(),
        );
        let step = way.part(
            "the step from cell to cell: 1, or −1 where the ray goes backwards",
            2.0 * forward - 1.0,
        );
        Some(Self {
            through,
            cell,
            ahead,
            step,
            above,
            below,
            bound,
        })
    }

    /// The next cell along an axis; none if the lattice ends there.
    fn next(&self, cell: UVec3, axis: usize) -> Option<UVec3> {
        let at = f64::from(cell[axis]) + self.step[axis];
        let is_inside = if self.step[axis] < 0.0 {
            at > self.below[axis] && at >= 0.0
        } else {
            at < self.above[axis]
        };
        let mut next = cell;
        next[axis] = at as u32;
        (is_inside && at < self.bound[axis]).then_some(next)
    }
}

/// A cell on the way, as it is returned.
fn visit(way: &mut Way, cell: UVec3, leave: f64) -> Visit {
    let UVec3 { x, y, z } = cell;
    let leave = way.part("leave, returned", leave) as f32;
    Visit { x, y, z, leave }
}

/// The distances to planes ahead; those that are never met are infinitely far.
fn met(ahead: DVec3, d: DVec3) -> DVec3 {
    (ahead / d).map(|t| if t.is_finite() { t } else { f64::INFINITY })
}

/// The same with the distance from plane to plane added at each step (Amanatides and Woo 1987). Cells that the ray only touches may be left out.
fn by_increments(asked: &GridWalk, way: &mut Way, leaves_out: bool) -> Vec<Visit> {
    let Some(start) = Start::of(asked, way) else {
        return Vec::new();
    };
    let Through {
        o,
        d,
        min,
        size,
        mut enter,
        end,
        ..
    } = start.through;
    let mut cell = start.cell;
    let plane = way.part(
        "the numbers of the first planes",
        cell.as_dvec3() + start.ahead,
    );
    let extents = way.part("cell in the first planes", size);
    let along = way.part("the number of the first plane · cell", plane * extents);
    let min = way.part("min, where the planes begin", min);
    let plane = way.part("min + the number of the first plane · cell", min + along);
    let from = way.part("o, from where the first planes are measured", o);
    let ahead = way.part("how far the first planes are ahead", plane - from);
    let mut next = way.part("the first planes ahead, at t", met(ahead, d));
    let size = way.part("cell in cell/|d|", size);
    let speed = way.made("to take the absolute value of d in cell/|d|", d, d.abs());
    let apart = way.part("from plane to plane: cell/|d|", met(size, speed));
    let mut visits = Vec::new();
    for _ in 0..most(asked) {
        next = way.part("the next planes ahead, at t", next);
        let axis = way.least("the axis of the nearest plane", &next.to_array());
        let nearest = way.part("the nearest of the next planes", next[axis]);
        let is_beyond = way.is_less("the way through the lattice ends in a cell", end, nearest);
        let leave = if is_beyond { end } else { nearest };
        if leave > enter || !leaves_out {
            visits.push(visit(way, cell, leave));
        }
        enter = leave;
        if way.is_at_most("the way through the lattice has ended", end, leave) {
            return visits;
        }
        let Some(beyond) = start.next(cell, axis) else {
            return visits;
        };
        cell = beyond;
        let step = way.part("the distance that is added", apart[axis]);
        next[axis] += step;
    }
    visits
}

/// More cells than these no ray passes through.
fn most(asked: &GridWalk) -> u32 {
    asked.nx.saturating_add(asked.ny).saturating_add(asked.nz)
}

/// The same by the distances to all planes, sorted: between two of them lies a cell, in which their middle is.
fn by_sorting(asked: &GridWalk, way: &mut Way) -> Vec<Visit> {
    let Some(through) = Through::of(asked, way) else {
        return Vec::new();
    };
    let Through { o, d, min, .. } = through;
    let from = way.part("min, where the planes begin", min);
    let mut planes = vec![through.enter, through.end];
    for axis in (0..3).filter(|axis| d[*axis] != 0.0) {
        for i in way.rounds(
            "the planes across an axis",
            through.count[axis] as usize + 1,
        ) {
            let plane = from[axis] + i as f64 * through.size[axis];
            let plane = way.part("min + i·cell", plane);
            let t = way.part("t of a plane", (plane - o[axis]) / d[axis]);
            if through.enter < t && t < through.end {
                planes.push(t);
            }
        }
    }
    planes.sort_by(f64::total_cmp);
    planes.dedup();
    let mut visits = Vec::new();
    for ends in planes.windows(2) {
        let enter = way.part("where the ray enters a cell", ends[0]);
        let leave = way.part("where the ray leaves a cell", ends[1]);
        let between = way.part("the middle of both", 0.5 * (enter + leave));
        let at = way.part("o + that·d", o + between * d);
        let inside = way.part("o + that·d − min", at - min);
        let place = way.part("(o + that·d − min)/cell", inside / through.size);
        visits.push(visit(way, through.cell(place), leave));
    }
    visits
}

impl Explained for GridWalk {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec<Visit>] = &[
        Self::work,
        |asked, way| by_increments(asked, way, false),
        |asked, way| by_increments(asked, way, true),
        by_sorting,
    ];

    fn work(&self, way: &mut Way) -> Vec<Visit> {
        let Some(start) = Start::of(self, way) else {
            return Vec::new();
        };
        let Through {
            o,
            d,
            min,
            size,
            limit,
            ..
        } = start.through;
        let mut cell = start.cell;
        way.vector(
            "apart: the distance between two planes, along each axis",
            "m",
            (size / d).abs(),
        );
        let mut visits = Vec::new();
        for _ in 0..most(self) {
            let plane = way.part(
                "the numbers of the next planes",
                cell.as_dvec3() + start.ahead,
            );
            let along = way.part("the number · cell", plane * size);
            let min = way.part("min, where the planes begin", min);
            let plane = way.part("min + the number · cell", min + along);
            let ahead = way.part("how far the planes are ahead", plane - o);
            let next = met(ahead, d);
            let UVec3 { x, y, z } = cell;
            let next = way.vector(
                format!("cell ({x}, {y}, {z}): the next planes ahead, at t ="),
                "m",
                next,
            );
            let axis = way.least("the axis of the nearest plane", &next.to_array());
            let nearest = way.part("the nearest plane ahead", next[axis]);
            let is_beyond = way.is_less("the interval ends in a cell", limit, nearest);
            let leave = if is_beyond { limit } else { nearest };
            visits.push(visit(way, cell, leave));
            let beyond = start.next(cell, axis);
            let Some(beyond) = beyond.filter(|_| leave < limit) else {
                let why = if leave >= limit {
                    "The interval ends here."
                } else {
                    "Behind the nearest of them the lattice ends."
                };
                way.remark(why);
                return visits;
            };
            cell = beyond;
        }
        visits
    }

    fn draw(&self, right: &Vec<Visit>, yours: Option<&Vec<Visit>>) -> Option<Diagram> {
        let (o, d) = rays::parts(&self.ray);
        let view = View::least(d);
        let flat = |p: DVec3| view.at(p);
        let (min, size) = (self.min.as_dvec3(), self.cell.as_dvec3());
        let counts = [self.nx, self.ny, self.nz];
        let max = min + UVec3::from(counts).as_dvec3() * size;
        let mut drawing = Diagram::new(format!("The cells on the ray's way, {}", view.words()));
        let square = |visit: &Visit, share: f64| {
            let corner = min + visit.cell().as_dvec3() * size;
            shrunk(view.rectangle(corner, corner + size), share)
        };
        for visit in right {
            drawing.area(&square(visit, 0.94), Ink::Right);
        }
        // A list of a student's may hold anything.
        let inside = |visit: &&Visit| visit.x < self.nx && visit.y < self.ny && visit.z < self.nz;
        for visit in yours.into_iter().flatten().filter(inside) {
            drawing.area(&square(visit, 0.7), Ink::Yours);
        }
        view.lattice(&mut drawing, [min, max], counts);
        let end = right.last().map_or(0.0, |visit| f64::from(visit.leave));
        let beyond = if end.is_finite() && end > 0.0 {
            end
        } else {
            (max - min).length()
        };
        let way = |t: f64| flat(o + t * d);
        let [from, to] =
            [self.within.min, self.within.max].map(|t| f64::from(t).clamp(0.0, 1.12 * beyond));
        if from < to {
            drawing.line(&[way(from), way(to)], Ink::Interval);
        }
        drawing.arrow(way(0.0), way(1.12 * beyond), Ink::Ray);
        let mut before = f64::from(self.within.min).max(0.0);
        for (i, visit) in right.iter().enumerate() {
            let leave = f64::from(visit.leave);
            if leave.is_finite() && right.len() < 16 {
                // The cell's number in the order of the walk, in the middle of the ray's way through it.
                let entered: DVec2 = if i == 0 {
                    middle(&square(visit, 1.0))
                } else {
                    way(0.5 * (before + leave))
                };
                drawing.label(entered, dvec2(0.0, 0.9), format!("{}", i + 1), Ink::Right);
                before = leave;
            }
        }
        Some(drawing)
    }
}
