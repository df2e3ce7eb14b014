//! The walk through cells in cells.

use super::cells;
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::rays;
use crate::explain::view::{View, fill_both, middle};
use crate::explain::way::Way;
use glam::{UVec3, Vec3, dvec2};
use raybook::math::interval::Interval;
use raybook_workbook::exercises::ch08_grid::{GridWalk, Visit};
use raybook_workbook::exercises::ch09_two_level_grid::{Resolution, TwoLevelWalk};

/// The walk through a lattice of cells, in an interval.
fn through(q: &TwoLevelWalk, min: Vec3, cell: Vec3, counts: UVec3, within: Interval) -> GridWalk {
    let UVec3 { x, y, z } = counts;
    let (nx, ny, nz, ray) = (x, y, z, q.ray);
    GridWalk {
        min,
        cell,
        nx,
        ny,
        nz,
        ray,
        within,
    }
}

/// The same without a walk: all fine cells in which the ray stays for a while, sorted by the middle of the stay.
fn by_clipping(q: &TwoLevelWalk, way: &mut Way) -> Vec<u32> {
    let of = |n: &Resolution| UVec3::new(n.nx, n.ny, n.nz);
    let ray = rays::parts(&q.ray);
    let begin = way.part("within.min", f64::from(q.within.min));
    let end = way.part("within.max", f64::from(q.within.max));
    let min = way.part("the grid's least corner", q.min.as_dvec3());
    let extents = way.part("the grid's extents", q.max.as_dvec3() - min);
    let coarse = way.part(
        "the number of coarse cells along each axis",
        of(&q.coarse).as_dvec3(),
    );
    let size = way.part("the extents of a coarse cell", extents / coarse);
    let (mut first, mut stays) = (0, Vec::new());
    for (at, n) in cells(of(&q.coarse)).zip(q.fine.iter().map(of)) {
        let place = way.part("a coarse cell's numbers", at.as_dvec3());
        let corner = min + place * size;
        let low = way.part("the least corner of a coarse cell", corner);
        let before = way.part(
            "the fine cells of the coarse cells before",
            f64::from(first),
        );
        let counted = way.part("nx, ny and nz in the number of fine cells", n.as_dvec3());
        let count = counted.element_product() as u32;
        first += count;
        if way.is_less("a coarse cell is empty", count.into(), 1.0) {
            continue;
        }
        let along = way.part("the number of fine cells along each axis", n.as_dvec3());
        // The ray is in the fine cells while it is in the coarse one.
        let Some([begin, end]) = rays::clipped(ray, [begin, end], corner, corner + size) else {
            continue;
        };
        let whole = way.part("the extents of a coarse cell, in those of a fine one", size);
        let size = way.part("the extents of a fine cell", whole / along);
        let strides = way.part("nx and ny in x + nx·(y + ny·z)", n.as_dvec3().truncate());
        for at in cells(n) {
            let low = way.part(
                "the least corner of a fine cell",
                low + at.as_dvec3() * size,
            );
            let inside = rays::clipped(ray, [begin, end], low, low + size);
            let Some([enter, leave]) = inside.filter(|[enter, leave]| leave - enter > TOUCH) else {
                continue;
            };
            let [x, y, z] = at.as_dvec3().to_array();
            let place = way.part("x + nx·(y + ny·z)", x + strides.x * (y + strides.y * z));
            let middle = 0.5 * (enter + leave);
            let middle = way.made("to sort the cells by where the ray is in them", 0.0, middle);
            stays.push((middle, before + place));
        }
    }
    stays.sort_by(|a, b| a.0.total_cmp(&b.0));
    stays.into_iter().map(|(_, place)| place as u32).collect()
}

/// A ray that is no longer than this in a cell, in metres, only touches it.
const TOUCH: f64 = 1e-9;

impl Explained for TwoLevelWalk {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec<u32>] = &[Self::work, by_clipping];

    fn work(&self, way: &mut Way) -> Vec<u32> {
        let levels = self.levels();
        let top = levels.top;
        let [nx, ny, nz] = top.resolution.as_dvec3().to_array();
        let min = way.part("the grid's least corner", self.min.as_dvec3());
        let coarse = through(self, min.as_vec3(), top.cell, top.resolution, self.within);
        way.remark("First through the coarse cells:");
        let visits = coarse.work(way);
        let (mut enter, mut places) = (self.within.min, Vec::new());
        let visits = way.in_order(
            "the coarse cells, each of them from where the ray leaves the one before,",
            visits,
        );
        let stay = |visit: Visit| {
            let inside = Interval::new(enter, visit.leave);
            enter = visit.leave;
            (visit, inside)
        };
        let visits: Vec<_> = visits.into_iter().map(stay).collect();
        let visits = way.in_order("the coarse cells on the ray's way", visits);
        for i in way.rounds("the coarse cells on the ray's way", visits.len()) {
            let (visit, inside) = &visits[i];
            let Visit { x, y, z, .. } = visit;
            let name = format!("coarse cell ({x}, {y}, {z})");
            let along = way.part("the coarse cells along x", nx);
            way.part("the coarse cells along z", nz);
            let up = way.part("the coarse cells along y", ny);
            let [x, y, z] = [x, y, z].map(|at| f64::from(*at));
            let place = way.part("a coarse cell's place in the row", x + along * (y + up * z));
            let cut = &levels.cuts[place as usize];
            let resolution = cut.resolution.as_uvec3();
            if way.decides("a coarse cell is empty", resolution == UVec3::ZERO) {
                way.remark(format!("The {name} is empty: the ray passes on."));
                continue;
            }
            let first = way.number(
                format!("{name}: the place of its first fine cell in the row"),
                "",
                cut.first.into(),
            );
            let whole = top.only(visit.cell());
            let low = way.part("the least corner of a coarse cell", whole.min.as_dvec3());
            let size = whole.cell / resolution.as_vec3();
            let walk = through(self, low.as_vec3(), size, resolution, *inside);
            let cells = way.silently(|way| walk.work(way));
            let cells = way.in_order("a coarse cell's fine cells on the ray's way", cells);
            let count = cells.len();
            for i in way.rounds("a coarse cell's fine cells on the ray's way", count) {
                let Visit { x, y, z, .. } = cells[i];
                let along = way.part("nx", f64::from(resolution.x));
                way.part("nz", f64::from(resolution.z));
                let up = way.part("ny", f64::from(resolution.y));
                let [x_of, y_of, z_of] = [x, y, z].map(f64::from);
                let index = way.part("x + nx·(y + ny·z)", x_of + along * (y_of + up * z_of));
                let place = way.number(
                    format!("fine cell ({x}, {y}, {z}) of it: first + x + nx·(y + ny·z)"),
                    "",
                    first + index,
                );
                places.push(place as u32);
            }
        }
        places
    }

    fn draw(&self, right: &Vec<u32>, yours: Option<&Vec<u32>>) -> Option<Diagram> {
        let levels = self.levels();
        let view = View::least(self.ray.direction.as_dvec3());
        let mut drawing = Diagram::new(format!(
            "The fine cells on the ray's way, in cells that are cut or empty, {}; the right ones with their places in the row",
            view.words()
        ));
        // Every fine cell's box, in the order of the row.
        let mut cells = Vec::new();
        for coarse in levels.top.all() {
            let Some((_, fine)) = levels.fine(coarse) else {
                continue;
            };
            let boxes = fine.all().map(|cell| fine.bounds_of(cell, cell));
            cells
                .extend(boxes.map(|cell| view.rectangle(cell.min.as_dvec3(), cell.max.as_dvec3())));
        }
        let cell = |place: u32| cells.get(place as usize).copied();
        fill_both(&mut drawing, right, yours, [0.94, 0.7], cell);
        for coarse in levels.top.all() {
            let cell = levels.top.bounds_of(coarse, coarse);
            let corners = [cell.min, cell.max].map(Vec3::as_dvec3);
            let counts = levels
                .fine(coarse)
                .map_or(UVec3::ONE, |(_, fine)| fine.resolution);
            let is_seen = right.iter().any(|place| {
                levels.fine(coarse).is_some_and(|(first, fine)| {
                    (first..first + fine.cells()).contains(&(*place as usize))
                })
            });
            // Cells that lie behind each other are cut differently: those that count are shown.
            let counts = if is_seen { counts } else { UVec3::ONE };
            view.lattice(&mut drawing, corners, counts.to_array());
        }
        let corners = [self.min, self.max].map(Vec3::as_dvec3);
        rays::across(&mut drawing, &view, &self.ray, self.within, corners);
        if right.len() < 16 {
            for place in right {
                let Some(square) = cell(*place) else {
                    continue;
                };
                drawing.label(
                    middle(&square),
                    dvec2(0.0, 0.0),
                    format!("{place}"),
                    Ink::Right,
                );
            }
        }
        Some(drawing)
    }
}
