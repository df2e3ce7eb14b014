//! Which cells a triangle meets, as students write it: by bounds of another size, by half of the test, in rows that end too soon.

use crate::sample;
use glam::{UVec3, Vec3, Vec3Swizzles};
use raybook::inside::grid::{range, triangle_meets_box};
use raybook::math::{aabb::Aabb, interval::Interval};
use raybook::shape::{Shape, mesh::Facet};
use raybook_workbook::exercises::ch08_grid::{Cell, VoxelsOfTriangle};

/// The cells that reach the triangle's bounding box by the margin, and that a test keeps.
pub(super) fn kept(q: &VoxelsOfTriangle, keep: impl Fn(Aabb, [Vec3; 3]) -> bool) -> Vec<Cell> {
    let around = Aabb::of([q.p0, q.p1, q.p2]).grown(q.margin);
    of_lattice(q, |bounds, corners| {
        let reaches = bounds.min.cmple(around.max) & around.min.cmple(bounds.max);
        reaches.all() && keep(bounds, corners)
    })
}

/// The cells of the whole lattice that a test keeps.
pub(super) fn of_lattice(
    q: &VoxelsOfTriangle,
    keep: impl Fn(Aabb, [Vec3; 3]) -> bool,
) -> Vec<Cell> {
    let (lattice, corners) = (q.lattice(), [q.p0, q.p1, q.p2]);
    let cells = range(UVec3::ZERO, lattice.resolution - 1);
    cells
        .filter(|&cell| keep(lattice.bounds_of(cell, cell), corners))
        .map(Cell::from)
        .collect()
}

/// The first and the last cell of the lattice.
pub(super) fn whole(q: &VoxelsOfTriangle) -> [UVec3; 2] {
    [UVec3::ZERO, q.lattice().resolution - 1]
}

/// The first and the last cell that the triangle's bounding box meets, along each axis.
pub(super) fn around(q: &VoxelsOfTriangle) -> [UVec3; 2] {
    let bounds = Aabb::of([q.p0, q.p1, q.p2]).grown(q.margin);
    q.lattice().cells_of(&bounds).into()
}

/// The cells from the first to the last, along x first.
pub(super) fn along_x([first, last]: [UVec3; 2]) -> impl Iterator<Item = UVec3> {
    range(first, last)
}

/// The same, along z first.
pub(super) fn along_z(ends: [UVec3; 2]) -> impl Iterator<Item = UVec3> {
    along_x(ends.map(UVec3::zyx)).map(UVec3::zyx)
}

/// The cells that meet the triangle, but for those behind a cell that does not, in the same row along an axis.
pub(super) fn in_rows(q: &VoxelsOfTriangle, ends: [UVec3; 2], axis: usize) -> Vec<Cell> {
    up_to_a_miss(q, along_x(ends), |mut row| {
        row[axis] = 0;
        row
    })
}

/// The cells that meet the triangle, but for those that come after a cell that does not, in the same loop: each has a number.
pub(super) fn up_to_a_miss(
    q: &VoxelsOfTriangle,
    cells: impl Iterator<Item = UVec3>,
    in_loop: impl Fn(UVec3) -> UVec3,
) -> Vec<Cell> {
    let (lattice, corners) = (q.lattice(), [q.p0, q.p1, q.p2]);
    let mut ended = Vec::new();
    let is_found = |cell: &UVec3| {
        let own = in_loop(*cell);
        if ended.contains(&own) {
            return false;
        }
        let bounds = lattice.bounds_of(*cell, *cell).grown(q.margin);
        let meets = triangle_meets_box(&corners, &bounds);
        if !meets {
            ended.push(own);
        }
        meets
    };
    cells.filter(is_found).map(Cell::from).collect()
}

/// Whether the plane in which a triangle lies cuts a box.
pub(super) fn plane_cuts(bounds: &Aabb, [p0, p1, p2]: [Vec3; 3]) -> bool {
    let n = (p1 - p0).cross(p2 - p0);
    n.dot(bounds.center() - p0).abs() <= n.abs().dot(0.5 * bounds.size())
}

/// Whether a triangle is met by one of the twelve edges of a box.
pub(super) fn cuts_an_edge(bounds: &Aabb, corners: [Vec3; 3]) -> bool {
    let triangle = Facet { corners, id: 0 };
    let is_cut = |axis: usize, corner: u32| {
        let mut from = bounds.min;
        for across in 1..3 {
            if corner >> (across - 1) & 1 == 1 {
                let across = (axis + across) % 3;
                from[across] = bounds.max[across];
            }
        }
        let within = Interval::new(0.0, bounds.size()[axis]);
        let edge = sample::ray(from, Vec3::AXES[axis]);
        triangle.hit(&edge, within).is_some()
    };
    (0..3).any(|axis| (0..4).any(|corner| is_cut(axis, corner)))
}

/// The cells of the lattice that meet the triangle if each is moved along every axis by its size there times `by`.
pub(super) fn shifted(q: &VoxelsOfTriangle, by: f32) -> Vec<Cell> {
    of_lattice(q, |bounds, corners| {
        let by = by * bounds.size();
        let bounds = Aabb::new(bounds.min + by, bounds.max + by).grown(q.margin);
        triangle_meets_box(&corners, &bounds)
    })
}

/// The cells that meet the triangle if the margin is added along some axes.
pub(super) fn with_margins(q: &VoxelsOfTriangle, along: Vec3) -> Vec<Cell> {
    of_lattice(q, |bounds, corners| {
        let by = q.margin * along;
        triangle_meets_box(&corners, &Aabb::new(bounds.min - by, bounds.max + by))
    })
}

/// Whether a direction across an axis and an edge parts a box and a triangle.
pub(super) fn is_parted_by_edges(corners: [Vec3; 3], bounds: &Aabb) -> bool {
    let half = 0.5 * bounds.size();
    let corners = corners.map(|p| p - bounds.center());
    let edges = [0, 1, 2].map(|i| corners[(i + 1) % 3] - corners[i]);
    let across = edges
        .iter()
        .flat_map(|edge| Vec3::AXES.map(|axis| axis.cross(*edge)));
    across.into_iter().any(|along| {
        let at = corners.map(|p| along.dot(p));
        let reach = along.abs().dot(half);
        let (least, most) = (at[0].min(at[1]).min(at[2]), at[0].max(at[1]).max(at[2]));
        least > reach || most < -reach
    })
}
