//! The walk that students write, with a plane and an axis of their choice.

use raybook::accel::lattice::Lattice;
use raybook::math::slab;
use raybook_workbook::exercises::ch08_grid::{GridWalk, Visit};
use glam::UVec3;

/// The number of the plane that the ray meets next, from that of its cell.
pub(super) fn ahead(backward: bool, cell: i64) -> i64 {
    if backward { cell } else { cell + 1 }
}

pub(super) fn least(next: [f32; 3]) -> usize {
    (0..3)
        .min_by(|&a, &b| next[a].total_cmp(&next[b]))
        .unwrap_or(0)
}

/// A walk with a plane and an axis of the student's choice.
pub(super) fn student(
    q: &GridWalk,
    plane: fn(bool, i64) -> i64,
    choose: fn([f32; 3]) -> usize,
) -> Vec<Visit> {
    let lattice: Lattice = q.lattice();
    let Some(inside) = slab::clip(&lattice.bounds(), &q.ray, q.within) else {
        return Vec::new();
    };
    let mut cell = lattice.cell_at(q.ray.at(inside.min));
    let mut visits = Vec::new();
    for _ in 0..lattice.resolution.element_sum() {
        let next = [0, 1, 2].map(|axis| {
            let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
            let number = plane(d.is_sign_negative(), i64::from(cell[axis])) as f32;
            let t = (lattice.min[axis] + number * lattice.cell[axis] - o) / d;
            if t.is_nan() { f32::INFINITY } else { t }
        });
        let axis = choose(next);
        let leave = next[axis].min(q.within.max);
        let UVec3 { x, y, z } = cell;
        visits.push(Visit { x, y, z, leave });
        let forward = !q.ray.direction[axis].is_sign_negative();
        let last = if forward {
            lattice.resolution[axis] - 1
        } else {
            0
        };
        if leave >= q.within.max || cell[axis] == last {
            break;
        }
        cell[axis] = if forward {
            cell[axis] + 1
        } else {
            cell[axis] - 1
        };
    }
    visits
}
