//! Chapter 8: the resolution of a grid, the cells of a triangle, and the walk from cell to cell.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::view::{AXES, View, middle, shrunk};
use super::way::Way;
use glam::{DVec2, DVec3, IVec3, UVec3, Vec3, dvec2};
use raybook_workbook::exercises::ch08_grid::{
    Cell, GridResolution, GridWalk, Visit, VoxelsOfTriangle,
};

impl Explained for GridResolution {
    fn work(&self, way: &mut Way) -> Cell {
        let extents = self.extents.as_dvec3();
        let extents = way.part("the extents", extents);
        let density = way.part("density", f64::from(self.density));
        let shapes = way.part("shapes", f64::from(self.shapes));
        let cells = way.number("cells = density · shapes", "", density * shapes);
        let mut thick: Vec<usize> = (0..3).filter(|&axis| extents[axis] > 0.0).collect();
        let along = loop {
            if way.decides("no axis is left to be cut", thick.is_empty()) {
                way.remark("No axis is left to be cut: there is one cell.");
                break DVec3::ONE;
            }
            let names: Vec<_> = thick.iter().map(|&axis| AXES[axis]).collect();
            let volume: f64 = thick.iter().map(|&axis| extents[axis]).product();
            let names = names.join(" · ");
            let volume = way.number(format!("the volume, of {names}"), "", volume);
            let dense = way.part("cells/volume", cells / volume);
            let root = way.part("1 over the number of axes", 1.0 / thick.len() as f64);
            let per_metre = way.number(
                "cells per metre: the root of cells/volume",
                "1/m",
                dense.powf(root),
            );
            let mut along = DVec3::ONE;
            for &axis in &thick {
                along[axis] = (extents[axis] * per_metre).min(cells.max(1.0));
            }
            let along = way.vector("extent · cells per metre", "", along);
            let before = thick.len();
            let thin = thick.iter().any(|&axis| along[axis] < 1.0);
            if !way.decides("an axis gets less than one cell", thin) {
                break along;
            }
            thick.retain(|&axis| along[axis] >= 1.0);
            if thick.len() == before {
                break along;
            }
            way.remark("An axis gets less than one cell: it has 1, and is left out of the volume.");
        };
        way.vector("rounded, and 1 at least", "", along.round().max(DVec3::ONE))
            .as_uvec3()
            .into()
    }
}

impl Explained for VoxelsOfTriangle {
    fn work(&self, way: &mut Way) -> Vec<Cell> {
        let (min, size, margin) = (
            self.min.as_dvec3(),
            self.cell.as_dvec3(),
            f64::from(self.margin),
        );
        let [p0, p1, p2] = [self.p0, self.p1, self.p2].map(Vec3::as_dvec3);
        let corners = [way.part("p₀", p0), way.part("p₁", p1), way.part("p₂", p2)];
        let min = way.part("min", min);
        let size = way.part("the extents of a cell", size);
        let margin = way.part("margin", margin);
        let most = UVec3::new(self.nx, self.ny, self.nz).as_ivec3() - 1;
        let [least, greatest] = [
            corners.into_iter().fold(DVec3::INFINITY, DVec3::min) - margin,
            corners.into_iter().fold(DVec3::NEG_INFINITY, DVec3::max) + margin,
        ];
        let least = way.vector(
            "the least corner of the triangle's box, less the margin",
            "m",
            least,
        );
        let greatest = way.vector("the greatest corner, plus the margin", "m", greatest);
        // One more on each side: a face that two cells share belongs to both.
        let cell = |p: DVec3, more: i32| {
            (((p - min) / size).floor().as_ivec3() + more).clamp(IVec3::ZERO, most)
        };
        let (first, last) = (cell(least, -1), cell(greatest, 1));
        let first = way.vector("the first cell that it can be in", "", first.as_dvec3());
        let last = way.vector("the last cell that it can be in", "", last.as_dvec3());
        let [first, last] = [first, last].map(|cell| cell.as_ivec3().clamp(IVec3::ZERO, most));
        way.remark("Of each of these the box, grown by the margin, cuts the triangle; what remains of it has corners, or the cell is not on the list.");
        let mut found = Vec::new();
        for z in first.z..=last.z {
            for y in first.y..=last.y {
                for x in first.x..=last.x {
                    let cell = UVec3::new(x as u32, y as u32, z as u32);
                    let low = min + cell.as_dvec3() * size;
                    let left = clipped(corners.to_vec(), low - margin, low + size + margin);
                    if way.decides("the triangle reaches a cell of its box", !left.is_empty()) {
                        found.push(Cell::from(cell));
                    }
                }
            }
        }
        way.number("cells that the triangle meets", "", found.len() as f64);
        found
    }
}

/// What a box leaves of a polygon: one side after the other cuts it (Sutherland and Hodgman 1974).
fn clipped(mut polygon: Vec<DVec3>, min: DVec3, max: DVec3) -> Vec<DVec3> {
    for axis in 0..3 {
        for (plane, sign) in [(min[axis], 1.0), (max[axis], -1.0)] {
            let inside = |p: &DVec3| sign * (p[axis] - plane);
            let mut kept = Vec::new();
            for (i, p) in polygon.iter().enumerate() {
                let next = &polygon[(i + 1) % polygon.len()];
                let [here, there] = [inside(p), inside(next)];
                if here >= 0.0 {
                    kept.push(*p);
                }
                if here * there < 0.0 {
                    kept.push(p.lerp(*next, here / (here - there)));
                }
            }
            polygon = kept;
        }
    }
    polygon
}

/// Where a walk begins.
struct Start {
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
    /// The first cell.
    cell: UVec3,
}

impl Start {
    /// None if the ray misses the lattice.
    fn of(asked: &GridWalk, way: &mut Way) -> Option<Self> {
        let mut start = Self::outside(asked, way)?;
        let at = way.part("o + enter·d", start.o + start.enter * start.d);
        let inside = way.part("o + enter·d − min", at - start.min);
        let place = way.part("(o + enter·d − min)/cell", inside / start.size);
        start.cell = start.cell_of(place);
        Some(start)
    }

    /// The cell of a place that is measured in cells.
    fn cell_of(&self, place: DVec3) -> UVec3 {
        let last = self.count.as_ivec3() - 1;
        place.floor().as_ivec3().clamp(IVec3::ZERO, last).as_uvec3()
    }

    /// Where the ray enters and leaves the lattice, if it does not miss it; the first cell is not known yet.
    fn outside(asked: &GridWalk, way: &mut Way) -> Option<Self> {
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
        if way.decides("the ray leaves the lattice before it enters", end < enter) {
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
            cell: UVec3::ZERO,
        })
    }

    /// Whether the ray goes backwards along an axis.
    fn backward(&self, axis: usize) -> bool {
        self.d[axis].is_sign_negative()
    }

    /// 1 for each axis along which the next plane is the upper one of a cell.
    fn forward(&self) -> UVec3 {
        UVec3::from([0, 1, 2].map(|axis| u32::from(!self.backward(axis))))
    }

    /// The next cell along an axis; none if the lattice ends there.
    fn next(&self, cell: UVec3, axis: usize) -> Option<UVec3> {
        let last = if self.backward(axis) {
            0
        } else {
            self.count[axis] - 1
        };
        let mut next = cell;
        if cell[axis] == last {
            return None;
        }
        next[axis] = if self.backward(axis) {
            cell[axis] - 1
        } else {
            cell[axis] + 1
        };
        Some(next)
    }
}

/// The distances to planes ahead; those that are never met are infinitely far.
fn met(ahead: DVec3, d: DVec3) -> DVec3 {
    (ahead / d).map(|t| if t.is_finite() { t } else { f64::INFINITY })
}

/// The same with the distance from plane to plane added at each step (Amanatides and Woo 1987).
fn by_increments(asked: &GridWalk, way: &mut Way) -> Vec<Visit> {
    let Some(start) = Start::of(asked, way) else {
        return Vec::new();
    };
    let Start {
        o,
        d,
        min,
        size,
        end,
        mut cell,
        ..
    } = start;
    let plane = way.part(
        "the numbers of the first planes",
        (cell + start.forward()).as_dvec3(),
    );
    let along = way.part("the number of the first plane · cell", plane * size);
    let min = way.part("min, where the planes begin", min);
    let plane = way.part("min + the number of the first plane · cell", min + along);
    let ahead = way.part("how far the first planes are ahead", plane - o);
    let mut next = way.part("the first planes ahead, at t", met(ahead, d));
    let apart = way.part("from plane to plane: cell/|d|", met(size, d.abs()));
    let mut visits = Vec::new();
    loop {
        next = way.part("the next planes ahead, at t", next);
        let nearest = way.part("the nearest of the next planes", next.min_element());
        let is_beyond = way.decides("the way through the lattice ends in a cell", nearest > end);
        let leave = if is_beyond { end } else { nearest };
        let UVec3 { x, y, z } = cell;
        visits.push(Visit {
            x,
            y,
            z,
            leave: leave as f32,
        });
        if way.decides("the way through the lattice has ended", leave >= end) {
            return visits;
        }
        let axis = next.min_position();
        let Some(beyond) = start.next(cell, axis) else {
            return visits;
        };
        cell = beyond;
        let step = way.part("the distance that is added", apart[axis]);
        next[axis] += step;
    }
}

/// The same by the distances to all planes, sorted: between two of them lies a cell, in which their middle is.
fn by_sorting(asked: &GridWalk, way: &mut Way) -> Vec<Visit> {
    let Some(start) = Start::outside(asked, way) else {
        return Vec::new();
    };
    let Start { o, d, min, .. } = start;
    let min = way.part("min, where the planes begin", min);
    let mut planes = vec![start.enter, start.end];
    for axis in (0..3).filter(|axis| d[*axis] != 0.0) {
        for i in 0..=start.count[axis] {
            let plane = way.part("min + i·cell", min[axis] + f64::from(i) * start.size[axis]);
            let t = way.part("t of a plane", (plane - o[axis]) / d[axis]);
            if start.enter < t && t < start.end {
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
        let inside = way.part("o + that·d − min", at - start.min);
        let place = way.part("(o + that·d − min)/cell", inside / start.size);
        let UVec3 { x, y, z } = start.cell_of(place);
        let leave = way.part("leave, returned", leave) as f32;
        visits.push(Visit { x, y, z, leave });
    }
    visits
}

impl Explained for GridWalk {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec<Visit>] =
        &[Self::work, by_increments, by_sorting];

    fn work(&self, way: &mut Way) -> Vec<Visit> {
        let Some(start) = Start::of(self, way) else {
            return Vec::new();
        };
        let Start {
            o,
            d,
            min,
            size,
            limit,
            mut cell,
            ..
        } = start;
        way.vector(
            "apart: the distance between two planes, along each axis",
            "m",
            (size / d).abs(),
        );
        let mut visits = Vec::new();
        loop {
            let plane = way.part(
                "the numbers of the next planes",
                (cell + start.forward()).as_dvec3(),
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
            let nearest = way.part("the nearest plane ahead", next.min_element());
            let is_beyond = way.decides("the interval ends in a cell", nearest > limit);
            let leave = if is_beyond { limit } else { nearest };
            visits.push(Visit {
                x,
                y,
                z,
                leave: leave as f32,
            });
            let beyond = start.next(cell, next.min_position());
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
