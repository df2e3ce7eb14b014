//! A coarse cell cut into fine ones.

use super::cells;
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::view::{View, middle, shrunk};
use crate::explain::way::Way;
use glam::{DVec3, UVec3, Vec3, dvec2};
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch08_grid::GridResolution;
use raybook_workbook::exercises::ch09_two_level_grid::{Entry, RefineCell, RefineCellAnswer};

/// The greatest number of fine cells along an axis: what a byte holds.
const MOST: usize = 255;

/// The same cell by cell: each shape is compared with each fine cell.
fn cell_by_cell(q: &RefineCell, way: &mut Way) -> RefineCellAnswer {
    let (min, max) = (q.min.as_dvec3(), q.max.as_dvec3());
    let along = resolution(q, way).unwrap_or(UVec3::ZERO);
    let extents = way.part("max − min", max - min);
    let parts = way.part("the resolution in (max − min)/resolution", along.as_dvec3());
    let size = way.part("the extents of a fine cell", extents / parts);
    let min = way.part("min", min);
    let mut entries = Vec::new();
    for at in cells(along) {
        let place = way.part("the cell's numbers", at.as_dvec3());
        let low = way.part("a fine cell's least corner", min + place * size);
        let high = way.part("a fine cell's greatest corner", low + size);
        for (shape, box_of) in (0..).zip(&q.shapes) {
            let [first, last] = [box_of.min, box_of.max].map(Vec3::as_dvec3);
            let mut axes = way.rounds("the axes", 3);
            let reaches = |axis: usize| {
                way.is_at_most(
                    "a shape begins before a fine cell's end",
                    first[axis],
                    high[axis],
                ) && way.is_at_most(
                    "a shape ends behind a fine cell's begin",
                    low[axis],
                    last[axis],
                )
            };
            if axes.all(reaches) {
                let UVec3 { x, y, z } = at;
                entries.push(Entry { x, y, z, shape });
            }
        }
    }
    let UVec3 {
        x: nx,
        y: ny,
        z: nz,
    } = along;
    RefineCellAnswer {
        nx,
        ny,
        nz,
        entries,
    }
}

/// The number of fine cells along each axis; none of a cell without shapes.
fn resolution(q: &RefineCell, way: &mut Way) -> Option<UVec3> {
    if q.shapes.is_empty() {
        way.remark("The cell has no shapes: it gets no fine cells, 0 × 0 × 0.");
        return None;
    }
    let resolution = GridResolution {
        extents: q.max - q.min,
        shapes: q.shapes.len() as u32,
        density: q.density,
    };
    let along = resolution.work(way);
    let most = way.limit("the most fine cells along an axis", MOST) as u32;
    let along = UVec3::new(along.x, along.y, along.z).min(UVec3::splat(most));
    let along = way.vector("the resolution, 255 at most", "", along.as_dvec3());
    let along = along.clamp(DVec3::ONE, DVec3::splat(most.into()));
    Some(along.as_uvec3())
}

impl Explained for RefineCell {
    const WAYS: &'static [fn(&Self, &mut Way) -> RefineCellAnswer] = &[Self::work, cell_by_cell];

    fn work(&self, way: &mut Way) -> RefineCellAnswer {
        let mut answer = RefineCellAnswer {
            nx: 0,
            ny: 0,
            nz: 0,
            entries: Vec::new(),
        };
        let Some(along) = resolution(self, way) else {
            return answer;
        };
        let (min, last) = (self.min.as_dvec3(), (along - 1).as_dvec3());
        let begin = way.part("min in max − min", min);
        let extents = way.part("max − min", self.max.as_dvec3() - begin);
        let size = extents / along.as_dvec3();
        let size = way.vector("the extents of a fine cell", "m", size);
        let min = way.part("min", min);
        for (
            shape,
            Corners {
                min: low,
                max: high,
            },
        ) in (0..).zip(&self.shapes)
        {
            let inside = |cell: DVec3| cell.clamp(DVec3::ZERO, last);
            let from_min = way.part("its least corner", low.as_dvec3()) - min;
            let from_min = way.part("its least corner − min", from_min);
            let to_max = way.part("its greatest corner", high.as_dvec3()) - min;
            let to_max = way.part("its greatest corner − min", to_max);
            let of_first = way.part("cell, where a shape begins", size);
            let of_last = way.part("cell, where a shape ends", size);
            let first = way.vector(
                format!(
                    "shape {shape}: (its least corner − min)/cell, rounded down, inside the cell"
                ),
                "",
                inside((from_min / of_first).floor()),
            );
            let end = way.vector(
                "the same of its greatest corner",
                "",
                (to_max / of_last).floor(),
            );
            let end = way.made(
                "to keep a shape's last cell inside the coarse cell",
                end,
                inside(end),
            );
            let [first, end] = [first, end].map(DVec3::as_uvec3);
            for z in first.z..=end.z {
                for y in first.y..=end.y {
                    for x in first.x..=end.x {
                        way.goes_on();
                        answer.entries.push(Entry { x, y, z, shape });
                    }
                }
            }
        }
        way.number(
            "pairs of a fine cell and a shape that reaches it",
            "",
            answer.entries.len() as f64,
        );
        RefineCellAnswer {
            nx: along.x,
            ny: along.y,
            nz: along.z,
            ..answer
        }
    }

    fn draw(&self, right: &RefineCellAnswer, yours: Option<&RefineCellAnswer>) -> Option<Diagram> {
        let (min, max) = (self.min.as_dvec3(), self.max.as_dvec3());
        let view = View::least(max - min);
        let mut drawing = Diagram::new(format!(
            "The fine cells that have shapes, and the shapes' boxes, {}",
            view.words()
        ));
        let counts = [right.nx, right.ny, right.nz];
        for (answer, share, ink) in [(Some(right), 0.94, Ink::Right), (yours, 0.7, Ink::Yours)] {
            let Some(answer) = answer else { continue };
            let along = UVec3::new(answer.nx, answer.ny, answer.nz);
            if along.min_element() == 0 || along.max_element() as usize > MOST {
                continue; // nothing that could be drawn
            }
            let size = (max - min) / along.as_dvec3();
            for square in seen_once(&view, answer, along) {
                let corner = min + square.as_dvec3() * size;
                drawing.area(&shrunk(view.rectangle(corner, corner + size), share), ink);
            }
        }
        view.lattice(&mut drawing, [min, max], counts);
        for (shape, corners) in self.shapes.iter().enumerate() {
            let [low, high] = [corners.min, corners.max].map(|p| p.as_dvec3().clamp(min, max));
            let seen = view.rectangle(low, high);
            drawing.area(&seen, Ink::Shape);
            drawing.label(
                middle(&seen),
                dvec2(0.0, 0.0),
                format!("{shape}"),
                Ink::Shape,
            );
        }
        Some(drawing)
    }
}

/// The fine cells with shapes, one of each column of cells that lie behind each other.
fn seen_once(view: &View, answer: &RefineCellAnswer, along: UVec3) -> Vec<UVec3> {
    let cells = answer.entries.iter().map(|e| UVec3::new(e.x, e.y, e.z));
    let mut cells: Vec<_> = cells.filter(|cell| cell.cmplt(along).all()).collect();
    let place = |cell: &UVec3| [cell[view.across], cell[view.up]];
    cells.sort_by_key(place);
    cells.dedup_by_key(|cell| place(cell));
    cells
}
