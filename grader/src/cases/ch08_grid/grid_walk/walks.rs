//! Walks through a grid as students write them: what may be mistaken in each is of the caller's choice.

use super::{entered, start};
use crate::Graded;
use glam::{UVec3, Vec3};
use raybook::inside::grid::Lattice;
use raybook::math::{interval::Interval, slab};
use raybook_workbook::exercises::ch08_grid::{GridWalk, Visit};

/// A walk with a beginning, a plane, and axes along which it steps of the student's choice: where the first of them is crossed, the
/// ray leaves the cell.
pub(super) fn student(
    q: &GridWalk,
    begin: fn(&GridWalk) -> f32,
    plane: fn(f32, i64) -> i64,
    choose: fn([f32; 3]) -> Vec<usize>,
) -> Vec<Visit> {
    let lattice: Lattice = q.lattice();
    if slab::clip(&lattice.bounds(), &q.ray, q.within).is_none() {
        return Vec::new();
    }
    let mut cell = lattice.cell_at(q.ray.at(begin(q)));
    let mut visits = Vec::new();
    for _ in 0..lattice.resolution.element_sum() {
        let next = [0, 1, 2].map(|axis| {
            let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
            let number = plane(d, i64::from(cell[axis])) as f32;
            let t = (lattice.min[axis] + number * lattice.cell[axis] - o) / d;
            if t.is_nan() { f32::INFINITY } else { t }
        });
        let axes = choose(next);
        let leave = axes.first().map_or(f32::INFINITY, |&axis| next[axis]);
        let leave = leave.min(q.within.max);
        let UVec3 { x, y, z } = cell;
        visits.push(Visit { x, y, z, leave });
        let forward = |axis: usize| q.ray.direction[axis] > 0.0;
        let last = |axis: usize| {
            if forward(axis) {
                lattice.resolution[axis] - 1
            } else {
                0
            }
        };
        if leave >= q.within.max || axes.iter().any(|&axis| cell[axis] == last(axis)) {
            break;
        }
        for axis in axes {
            cell[axis] = if forward(axis) {
                cell[axis] + 1
            } else {
                cell[axis] - 1
            };
        }
    }
    visits
}

/// What may be mistaken in a walk that adds the way between two planes in every step.
pub(super) struct Adding {
    /// The way between two planes, from the extents of a cell, the direction, and the axis.
    pub(super) apart: fn(Vec3, Vec3, usize) -> f32,
    /// What the distances of the first planes lack.
    pub(super) late: fn(&GridWalk) -> f32,
    /// Where the lattice begins, for the first cell's number.
    pub(super) corner: fn(&GridWalk) -> Vec3,
    /// A cell's number, from a place in the lattice.
    pub(super) rounded: fn(f32) -> f32,
    /// The axis along which the ray leaves a cell.
    pub(super) chosen: fn([f32; 3]) -> Option<usize>,
    /// The axes along which the cell changes.
    pub(super) moves: [bool; 3],
    /// Whether a distance is that of the plane after the one that is crossed.
    pub(super) is_late: bool,
    /// Whether it ends where the ray leaves the lattice, in whatever cell it is then, and leaves out cells that the ray seems to
    /// leave before it enters.
    pub(super) is_clipped: bool,
}

/// The walk without a mistake.
pub(super) const ADDING: Adding = Adding {
    apart: |cell, d, axis| (cell[axis] / d[axis]).abs(),
    late: |_| 0.0,
    corner: |q| q.min,
    rounded: f32::floor,
    chosen: |next| nearest(next).first().copied(),
    moves: [true; 3],
    is_late: false,
    is_clipped: false,
};

/// A walk that adds the way between two planes in every step (Amanatides and Woo 1987).
pub(super) fn added(q: &GridWalk, by: &Adding) -> Vec<Visit> {
    let lattice: Lattice = q.lattice();
    let Some(part) = slab::clip(&lattice.bounds(), &q.ray, q.within) else {
        return Vec::new();
    };
    let within = if by.is_clipped { part } else { q.within };
    let (o, d) = (q.ray.origin, *q.ray.direction);
    let place = (q.ray.at(start(q)) - (by.corner)(q)) / lattice.cell;
    let last = lattice.resolution.as_ivec3() - 1;
    let mut cell = place.to_array().map(by.rounded).map(|i| i as i32);
    for axis in 0..3 {
        cell[axis] = cell[axis].clamp(0, last[axis]);
    }
    let mut next = [0, 1, 2].map(|axis| {
        let plane = ahead(d[axis] < 0.0, i64::from(cell[axis])) as f32;
        let t = (lattice.min[axis] + plane * lattice.cell[axis] - o[axis]) / d[axis];
        if d[axis] == 0.0 {
            f32::INFINITY
        } else {
            t - (by.late)(q)
        }
    });
    let mut visits = Vec::new();
    let mut enter = part.min;
    for _ in 0..=lattice.resolution.element_sum() {
        let Some(axis) = (by.chosen)(next) else {
            break;
        };
        let [x, y, z] = cell.map(|i| i as u32);
        let apart = (by.apart)(lattice.cell, d, axis);
        let behind = if by.is_late { apart } else { 0.0 };
        let leave = (next[axis] + behind).min(within.max);
        if leave > enter || !by.is_clipped {
            visits.push(Visit { x, y, z, leave });
        }
        enter = leave;
        if by.moves[axis] {
            cell[axis] += if d[axis] < 0.0 { -1 } else { 1 };
        }
        if next[axis] >= within.max || !(0..=last[axis]).contains(&cell[axis]) {
            break;
        }
        next[axis] += apart;
    }
    visits
}

/// A walk of steps along the axes that are chosen, to where the ray leaves the lattice or the interval ends.
pub(super) fn in_lattice(q: &GridWalk, chosen: fn([f32; 3]) -> Option<usize>) -> Vec<Visit> {
    let clipped = slab::clip(&q.lattice().bounds(), &q.ray, q.within);
    let mut inside = q.clone();
    inside.within = clipped.unwrap_or(q.within);
    added(&inside, &Adding { chosen, ..ADDING })
}

/// One cell in each layer of the lattice along the axis on which the ray advances fastest, in cells: the one where the ray is halfway through.
pub(super) fn by_layers(q: &GridWalk) -> Vec<Visit> {
    let lattice: Lattice = q.lattice();
    let Some(inside) = slab::clip(&lattice.bounds(), &q.ray, q.within) else {
        return Vec::new();
    };
    let axis = (*q.ray.direction / lattice.cell).abs().max_position();
    let crossed = |i: u32| {
        let plane = lattice.min[axis] + i as f32 * lattice.cell[axis];
        (plane - q.ray.origin[axis]) / q.ray.direction[axis]
    };
    let planes = (0..=lattice.resolution[axis]).map(crossed);
    let mut ends: Vec<_> = planes.filter(|t| inside.contains(*t)).collect();
    ends.sort_by(f32::total_cmp);
    ends.push(inside.max);
    let mut enter = inside.min;
    let visit = |leave: f32| {
        let UVec3 { x, y, z } = lattice.cell_at(q.ray.at(0.5 * (enter + leave)));
        enter = leave;
        Visit { x, y, z, leave }
    };
    ends.into_iter().map(visit).collect()
}

/// The right visits in the order of numbers of their cells.
pub(super) fn numbered(q: &GridWalk, number: fn(&Visit) -> [u32; 3]) -> Vec<Visit> {
    let mut visits = GridWalk::right(q);
    visits.sort_by_key(number);
    visits
}

/// The right distances, with the cells that have these numbers halfway between each two.
pub(super) fn by_middles(q: &GridWalk, number: fn(&GridWalk, Vec3) -> Vec3) -> Vec<Visit> {
    let last = UVec3::new(q.nx, q.ny, q.nz).as_vec3() - 1.0;
    let of = |(visit, enter): (Visit, f32)| {
        let middle = q.ray.at(0.5 * (enter + visit.leave));
        let UVec3 { x, y, z } = number(q, middle).clamp(Vec3::ZERO, last).as_uvec3();
        Visit { x, y, z, ..visit }
    };
    entered(q).into_iter().map(of).collect()
}

/// A walk on which the cell changes along some axes only.
pub(super) fn stuck(q: &GridWalk, moves: [bool; 3]) -> Vec<Visit> {
    let is_clipped = true;
    added(
        q,
        &Adding {
            moves,
            is_clipped,
            ..ADDING
        },
    )
}

pub(super) fn walked(q: &GridWalk, within: Interval) -> Vec<Visit> {
    GridWalk::right(&GridWalk {
        within,
        ..q.clone()
    })
}

/// A walk to the end of the lattice, of a ray that enters the lattice within its interval; no distance is greater than `end`.
pub(super) fn beyond(q: &GridWalk, end: f32) -> Vec<Visit> {
    if GridWalk::right(q).is_empty() {
        return Vec::new();
    }
    let visits = walked(q, Interval::new(q.within.min, f32::INFINITY)).into_iter();
    visits
        .map(|visit| Visit {
            leave: visit.leave.min(end),
            ..visit
        })
        .collect()
}

/// The number of the plane that the ray meets next, from that of its cell.
pub(super) fn ahead(backward: bool, cell: i64) -> i64 {
    if backward { cell } else { cell + 1 }
}

/// The same, from the ray's direction along the axis.
pub(super) fn in_front(direction: f32, cell: i64) -> i64 {
    ahead(direction.is_sign_negative(), cell)
}

/// The axes along which the ray meets a plane, that of the nearest plane first.
pub(super) fn by_distance(next: [f32; 3]) -> Vec<usize> {
    let mut axes: Vec<_> = (0..3).filter(|&axis| next[axis].is_finite()).collect();
    axes.sort_by(|&a, &b| next[a].total_cmp(&next[b]));
    axes
}

/// The axis of the nearest plane.
pub(super) fn nearest(next: [f32; 3]) -> Vec<usize> {
    let mut axes = by_distance(next);
    axes.truncate(1);
    axes
}

/// The axis of the nearest plane, if x and z are never compared.
pub(super) fn without_xz([x, y, z]: [f32; 3]) -> usize {
    if x < y {
        0
    } else if y < z {
        1
    } else {
        2
    }
}

/// The same, if x and y are never compared.
pub(super) fn without_xy([x, y, z]: [f32; 3]) -> usize {
    if x < z {
        0
    } else if y < z {
        1
    } else {
        2
    }
}

/// The same, if y and z are never compared.
pub(super) fn without_yz([x, y, z]: [f32; 3]) -> usize {
    if z <= x { 2 } else { usize::from(x >= y) }
}

/// The same, if z is taken wherever it comes before y.
pub(super) fn z_before_y([x, y, z]: [f32; 3]) -> usize {
    if z <= y { 2 } else { usize::from(x >= y) }
}

/// The same, if y is compared with x again, and never with z.
pub(super) fn x_again([x, y, z]: [f32; 3]) -> usize {
    if x <= y && x <= z {
        0
    } else if y <= x {
        1
    } else {
        2
    }
}
