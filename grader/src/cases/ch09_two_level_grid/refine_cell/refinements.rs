//! Refinements of a coarse cell as students make them: into other fine cells, or with shapes named in others.

use super::depth;
use crate::Graded;
use glam::{BVec3, UVec3, Vec3};
use raybook::inside::grid::{Lattice, range};
use raybook::math::aabb::Aabb;
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch08_grid::{Cell, GridResolution};
use raybook_workbook::exercises::ch09_two_level_grid::{Entry, RefineCell, RefineCellAnswer};

/// The answer for the resolution of a cell of these extents with `shapes` shapes, and at most `most` along each axis; the right one
/// for an empty cell.
pub(super) fn cut_for(q: &RefineCell, extents: Vec3, shapes: usize, most: u32) -> RefineCellAnswer {
    cut_by(q, extents, shapes, |n| n.min(UVec3::splat(most)))
}

/// The same with another limit.
pub(super) fn cut_by(
    q: &RefineCell,
    extents: Vec3,
    shapes: usize,
    limited: impl Fn(UVec3) -> UVec3,
) -> RefineCellAnswer {
    if q.shapes.is_empty() {
        return RefineCell::right(q);
    }
    let Cell { x, y, z } = GridResolution::answer(&GridResolution {
        extents,
        shapes: shapes as u32,
        density: q.density,
    });
    cut(q, limited(UVec3::new(x, y, z)))
}

/// The answer for a resolution of one's own.
pub(super) fn cut(q: &RefineCell, along: UVec3) -> RefineCellAnswer {
    let bounds = Aabb {
        min: q.min,
        max: q.max,
    };
    let fine = Lattice::new(&bounds, along);
    let mut entries = Vec::new();
    let all = (along.min_element() > 0).then(|| fine.all());
    for cell in all.into_iter().flatten() {
        for (shape, corners) in (0..).zip(&q.shapes) {
            if depth(&fine, cell, corners) >= 0.0 {
                entries.push(Entry {
                    x: cell.x,
                    y: cell.y,
                    z: cell.z,
                    shape,
                });
            }
        }
    }
    RefineCellAnswer {
        nx: along.x,
        ny: along.y,
        nz: along.z,
        entries,
    }
}

/// The reference's answer with other boxes.
pub(super) fn with_shapes(q: &RefineCell, shape: impl Fn(&Corners) -> Corners) -> RefineCellAnswer {
    RefineCell::misread(q, |q| q.shapes = q.shapes.iter().map(shape).collect())
}

/// The same without the boxes that do not reach the coarse cell.
pub(super) fn without_those_outside(
    q: &RefineCell,
    shape: impl Fn(&Corners) -> Corners,
) -> RefineCellAnswer {
    let mut answer = with_shapes(q, &shape);
    answer.entries.retain(|entry| {
        let shape = shape(&q.shapes[entry.shape as usize]);
        reaches(q, &shape)
    });
    answer
}

/// The reference's answer without the shapes that are dropped.
pub(super) fn without_shapes(q: &RefineCell, drops: impl Fn(&Corners) -> bool) -> RefineCellAnswer {
    let mut answer = RefineCell::right(q);
    let kept = |entry: &Entry| !drops(&q.shapes[entry.shape as usize]);
    answer.entries.retain(kept);
    answer
}

/// The middle of a shape's box, as a box without extent.
pub(super) fn middle(shape: &Corners) -> Corners {
    let middle = 0.5 * (shape.min + shape.max);
    Corners {
        min: middle,
        max: middle,
    }
}

/// Whether a box reaches the coarse cell.
pub(super) fn reaches(q: &RefineCell, shape: &Corners) -> bool {
    shape.max.cmpge(q.min).all() && shape.min.cmple(q.max).all()
}

/// The right resolution, and a rule for the numbers of the first and the last cell that a shape reaches: from where it begins and
/// ends, in cells from the corner, and the last cell's number.
pub(super) fn with_cells(
    q: &RefineCell,
    numbers: impl Fn(Vec3, Vec3, Vec3) -> (Vec3, Vec3),
) -> RefineCellAnswer {
    let right = RefineCell::right(q);
    let size = (q.max - q.min) / resolution(&right);
    with_numbers(right, q, size, numbers)
}

/// The same with fine cells of this size.
pub(super) fn with_numbers(
    mut right: RefineCellAnswer,
    q: &RefineCell,
    size: Vec3,
    numbers: impl Fn(Vec3, Vec3, Vec3) -> (Vec3, Vec3),
) -> RefineCellAnswer {
    let last = resolution(&right) - 1.0;
    let mut entries = Vec::new();
    for (shape, corners) in (0..).zip(&q.shapes) {
        let from_corner = |corner: Vec3| (corner - q.min) / size;
        let (low, high) = numbers(from_corner(corners.min), from_corner(corners.max), last);
        if low.cmpgt(high).any() || !(low + high).is_finite() {
            continue;
        }
        for cell in range(low.as_uvec3(), high.as_uvec3()) {
            let UVec3 { x, y, z } = cell;
            entries.push(Entry { x, y, z, shape });
        }
    }
    right.entries = entries;
    right
}

/// The right resolution, and the numbers of the first and the last cell that a shape reaches by the places of its corners in the coarse cell,
/// from 0 to 1, and the last cell's number.
pub(super) fn with_places(q: &RefineCell, number: fn(Vec3, Vec3) -> Vec3) -> RefineCellAnswer {
    let right = RefineCell::right(q);
    let size = (q.max - q.min).max(Vec3::splat(f32::MIN_POSITIVE));
    with_numbers(right, q, size, |begin, end, last| {
        (number(begin, last), number(end, last))
    })
}

/// The right resolution with fine cells that are as long as the coarse cell divided by `parts` of the resolution, and a rule for the
/// shapes that a cell names.
pub(super) fn by_overlap(
    q: &RefineCell,
    parts: impl Fn(Vec3) -> Vec3,
    names: fn(&Aabb, &Corners) -> bool,
) -> RefineCellAnswer {
    let mut answer = RefineCell::right(q);
    let n = resolution(&answer);
    if n.min_element() < 1.0 {
        return answer;
    }
    let size = (q.max - q.min) / parts(n);
    answer.entries.clear();
    for cell in range(UVec3::ZERO, n.as_uvec3() - UVec3::ONE) {
        let low = q.min + cell.as_vec3() * size;
        let bounds = Aabb {
            min: low,
            max: low + size,
        };
        for (shape, corners) in (0..).zip(&q.shapes) {
            if names(&bounds, corners) {
                let UVec3 { x, y, z } = cell;
                answer.entries.push(Entry { x, y, z, shape });
            }
        }
    }
    answer
}

/// Whether a shape reaches a cell.
pub(super) fn within(cell: &Aabb, shape: &Corners) -> bool {
    reaches_along(cell, shape).all()
}

/// Along which axes a shape reaches a cell.
pub(super) fn reaches_along(cell: &Aabb, shape: &Corners) -> BVec3 {
    shape.max.cmpge(cell.min) & shape.min.cmple(cell.max)
}

/// The number of cells along each axis.
pub(super) fn resolution(answer: &RefineCellAnswer) -> Vec3 {
    UVec3::new(answer.nx, answer.ny, answer.nz).as_vec3()
}

/// When the last cell that a shape reaches along an axis is left out.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Last {
    /// Even if the shape reaches no other.
    Always,
    /// Only if the shape reaches another.
    UnlessAlone,
}

/// The answer without the last cell that each shape reaches along some axes.
pub(super) fn without_last(q: &RefineCell, axes: [bool; 3], when: Last) -> RefineCellAnswer {
    let mut answer = RefineCell::right(q);
    let reached = reached(q, &answer);
    answer.entries.retain(|entry| {
        let reached = reached[entry.shape as usize];
        (0..3).all(|axis| {
            let [first, last] = reached[axis];
            let is_spared = when == Last::UnlessAlone && first == last;
            !axes[axis] || is_spared || at(entry)[axis] < last
        })
    });
    answer
}

/// The first and the last cell that each shape reaches, along each axis.
pub(super) fn reached(q: &RefineCell, answer: &RefineCellAnswer) -> Vec<[[u32; 2]; 3]> {
    let mut reached = vec![[[u32::MAX, 0]; 3]; q.shapes.len()];
    for entry in &answer.entries {
        let reached = &mut reached[entry.shape as usize];
        for ([first, last], at) in reached.iter_mut().zip(at(entry)) {
            (*first, *last) = (at.min(*first), at.max(*last));
        }
    }
    reached
}

/// The cell of an entry.
pub(super) fn at(entry: &Entry) -> [u32; 3] {
    [entry.x, entry.y, entry.z]
}
