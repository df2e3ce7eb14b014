//! Which cells a triangle meets, as students write it: by bounds of another size, by half of the test, in rows that end too soon.

use crate::sample;
use crate::upon::changed;
use glam::{UVec3, Vec3, Vec3Swizzles};
use raybook::inside::grid::{range, triangle_meets_box};
use raybook::math::{aabb::Aabb, interval::Interval, slab};
use raybook::shape::{Shape, mesh::Facet};
use raybook_workbook::exercises::ch08_grid::{Cell, VoxelsOfTriangle};

/// How the cells are found that meet a triangle; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// By how much a cell reaches beyond its planes, along each axis.
    pub(super) margin: fn(q: &VoxelsOfTriangle) -> Vec3,
    /// Whether the loop leaves out cells that do not reach the triangle's bounding box.
    pub(super) is_around: bool,
    /// Whether it goes along z first, and not along x.
    pub(super) is_along_z: bool,
    /// The number of the loop that ends at a `cell` that does not meet the triangle; none, where none ends.
    pub(super) ending: fn(cell: UVec3) -> Option<UVec3>,
    /// By how many of its extents a cell is moved before it is tested.
    pub(super) shift: f32,
    /// By how many of its extents a cell is larger on each side when it is tested.
    pub(super) growth: f32,
    /// The test whether a cell of these `bounds` meets the triangle.
    pub(super) meets: fn(q: &VoxelsOfTriangle, bounds: &Aabb) -> bool,
}

/// As it should be.
const WELL: How = How {
    margin: |q| Vec3::splat(q.margin),
    is_around: false,
    is_along_z: false,
    ending: |_| None,
    shift: 0.0,
    growth: 0.0,
    meets: |q, bounds| triangle_meets_box(&corners(q), bounds),
};

/// The cells that meet the triangle, found rightly but for what is changed.
pub(super) fn found(q: &VoxelsOfTriangle, change: impl FnOnce(&mut How)) -> Vec<Cell> {
    cells(q, &changed(WELL, change))
}

fn cells(q: &VoxelsOfTriangle, how: &How) -> Vec<Cell> {
    let (lattice, around) = (q.lattice(), Aabb::of(corners(q)));
    let (mut last, margin) = (lattice.resolution - 1, (how.margin)(q));
    if how.is_along_z {
        last = last.zyx();
    }
    let mut ended = Vec::new();
    let mut cells = Vec::new();
    for cell in range(UVec3::ZERO, last) {
        let cell = if how.is_along_z { cell.zyx() } else { cell };
        let bounds = lattice.bounds_of(cell, cell);
        let (min, max) = (bounds.min - margin, bounds.max + margin);
        let reaches = (min.cmple(around.max) & around.min.cmple(max)).all();
        let own = (how.ending)(cell);
        if (how.is_around && !reaches) || own.is_some_and(|own| ended.contains(&own)) {
            continue;
        }
        let (shift, growth) = (how.shift * q.cell, how.growth * q.cell);
        if (how.meets)(q, &Aabb::new(min + shift - growth, max + shift + growth)) {
            cells.push(Cell::from(cell));
        } else {
            ended.extend(own);
        }
    }
    cells
}

/// The same of the cells that reach the triangle's bounding box.
pub(super) fn around(q: &VoxelsOfTriangle, change: impl FnOnce(&mut How)) -> Vec<Cell> {
    found(q, |how| {
        how.is_around = true;
        change(how);
    })
}

/// The same of all cells, but without the margin.
pub(super) fn bare(q: &VoxelsOfTriangle, change: impl FnOnce(&mut How)) -> Vec<Cell> {
    found(q, |how| {
        how.margin = |_| Vec3::ZERO;
        change(how);
    })
}

/// The triangle's corners.
pub(super) fn corners(q: &VoxelsOfTriangle) -> [Vec3; 3] {
    [q.p0, q.p1, q.p2]
}

/// Whether the plane in which a triangle lies cuts a box.
pub(super) fn plane_cuts(q: &VoxelsOfTriangle, bounds: &Aabb) -> bool {
    let n = normal(q);
    n.dot(bounds.center() - q.p0).abs() <= n.abs().dot(0.5 * bounds.size())
}

/// A vector perpendicular to the triangle.
pub(super) fn normal(q: &VoxelsOfTriangle) -> Vec3 {
    (q.p1 - q.p0).cross(q.p2 - q.p0)
}

/// Whether an edge of the triangle passes through a box.
pub(super) fn an_edge_passes(q: &VoxelsOfTriangle, bounds: &Aabb) -> bool {
    let corners = corners(q);
    let passes = |i: usize| {
        let (from, to) = (corners[i], corners[(i + 1) % 3]);
        let length = Interval::new(0.0, from.distance(to));
        slab::clip(bounds, &sample::ray(from, to - from), length).is_some()
    };
    (0..3).any(passes)
}

/// Whether a triangle is met by one of the twelve edges of a box.
pub(super) fn cuts_an_edge(q: &VoxelsOfTriangle, bounds: &Aabb) -> bool {
    let corners = corners(q);
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

/// Whether no direction across an axis and an edge parts a box and the triangle.
pub(super) fn no_edge_parts(q: &VoxelsOfTriangle, bounds: &Aabb) -> bool {
    let half = 0.5 * bounds.size();
    let corners = corners(q).map(|p| p - bounds.center());
    let edges = [0, 1, 2].map(|i| corners[(i + 1) % 3] - corners[i]);
    let across = edges
        .iter()
        .flat_map(|edge| Vec3::AXES.map(|axis| axis.cross(*edge)));
    !across.into_iter().any(|along| {
        let at = corners.map(|p| along.dot(p));
        let reach = along.abs().dot(half);
        let (least, most) = (at[0].min(at[1]).min(at[2]), at[0].max(at[1]).max(at[2]));
        least > reach || most < -reach
    })
}
