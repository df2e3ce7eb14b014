//! The cells that a triangle meets.

use crate::explain::Explained;
use crate::explain::way::Way;
use glam::{DVec3, IVec3, UVec3, Vec3};
use raybook_workbook::exercises::ch08_grid::{Cell, VoxelsOfTriangle};

/// Whether a triangle meets the cell with this least corner and these extents, grown by a margin.
type Meets = fn(&mut Way, [DVec3; 3], DVec3, DVec3, f64) -> bool;

/// Tries all cells of the lattice.
fn all_tried(asked: &VoxelsOfTriangle, way: &mut Way, meets: Meets) -> Vec<Cell> {
    let corners = [asked.p0, asked.p1, asked.p2].map(Vec3::as_dvec3);
    let min = way.part("min", asked.min.as_dvec3());
    let size = way.part("the extents of a cell", asked.cell.as_dvec3());
    let margin = way.part("margin", f64::from(asked.margin));
    let mut found = Vec::new();
    for z in way.rounds("the cells along z", asked.nz as usize) {
        for y in way.rounds("the cells along y", asked.ny as usize) {
            for x in way.rounds("the cells along x", asked.nx as usize) {
                let cell = UVec3::new(x as u32, y as u32, z as u32);
                let place = way.part("the cell's numbers", cell.as_dvec3());
                let apart = way.part("the extents of a cell, in a cell's place", size);
                let low = way.part("a cell's least corner", min + place * apart);
                if meets(way, corners, low, size, margin) {
                    found.push(Cell::from(cell));
                }
            }
        }
    }
    found
}

/// Tries all cells that the triangle's own box reaches.
fn tried(asked: &VoxelsOfTriangle, way: &mut Way, meets: Meets) -> Vec<Cell> {
    let [p0, p1, p2] = [asked.p0, asked.p1, asked.p2].map(Vec3::as_dvec3);
    let corners = [way.part("p₀", p0), way.part("p₁", p1), way.part("p₂", p2)];
    let min = way.part("min", asked.min.as_dvec3());
    let size = way.part("the extents of a cell", asked.cell.as_dvec3());
    let margin = way.part("margin", f64::from(asked.margin));
    let around = way.part("the margin around the triangle's box", margin);
    let most = UVec3::new(asked.nx, asked.ny, asked.nz).as_ivec3() - 1;
    let below = &corners[way.rounds("the corners, for the least corner of their box", 3)];
    let above = &corners[way.rounds("the corners, for the greatest corner of their box", 3)];
    let least = below.iter().copied().fold(DVec3::INFINITY, DVec3::min) - around;
    let greatest = above.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max) + around;
    let least = way.vector(
        "the least corner of the triangle's box, less the margin",
        "m",
        least,
    );
    let greatest = way.vector("the greatest corner, plus the margin", "m", greatest);
    // A face that two cells share belongs to both.
    let first = ((least - min) / size).ceil() - 1.0;
    let last = ((greatest - min) / size).floor();
    let inside = |cell: DVec3| cell.clamp(DVec3::ZERO, most.as_dvec3());
    let first = way.vector("the first cell that it can be in", "", inside(first));
    let last = way.vector("the last cell that it can be in", "", inside(last));
    let [first, last] = [first, last].map(|cell| cell.as_ivec3().clamp(IVec3::ZERO, most));
    way.remark("Of each of these the box, grown by the margin, cuts the triangle; what remains of it has corners, or the cell is not on the list.");
    let most = (last - first + 1).as_usizevec3();
    let mut found = Vec::new();
    for z in way.rounds("the box's cells along z", most.z) {
        for y in way.rounds("the box's cells along y", most.y) {
            for x in way.rounds("the box's cells along x", most.x) {
                let cell = first.as_uvec3() + UVec3::new(x as u32, y as u32, z as u32);
                let apart = way.part("the extents of a cell, in a cell's place", size);
                let from = way.part("min, in a cell's place", min);
                let low = from + cell.as_dvec3() * apart;
                if meets(way, corners, low, size, margin) {
                    found.push(Cell::from(cell));
                }
            }
        }
    }
    way.number("cells that the triangle meets", "", found.len() as f64);
    found
}

/// By what the cell's box leaves of the triangle.
fn by_clipping(way: &mut Way, corners: [DVec3; 3], low: DVec3, size: DVec3, margin: f64) -> bool {
    let size = way.part("from a cell's least corner to its greatest", size);
    let below = way.part("the margin below a cell", margin);
    let above = way.part("the margin above a cell", margin);
    let left = clipped(corners.to_vec(), low - below, low + size + above);
    way.decides("the triangle reaches a cell of its box", !left.is_empty())
}

/// By the directions that can part a box and a triangle (Akenine-Möller 2001).
fn by_directions(way: &mut Way, corners: [DVec3; 3], low: DVec3, size: DVec3, margin: f64) -> bool {
    let to_middle = way.part("from a cell's least corner to its middle", 0.5 * size);
    let half = way.part("half of a cell's extents", 0.5 * size);
    let margin = way.part("the margin around a cell", margin);
    let half = way.part("half of a cell's extents, plus the margin", half + margin);
    let corners = corners.map(|p| p - (low + to_middle));
    let edges = [0, 1, 2].map(|i| corners[(i + 1) % 3] - corners[i]);
    let mut parts = |along: DVec3| {
        let at = corners.map(|p| along.dot(p));
        let weights = way.made(
            "to take the absolute values of a direction's components",
            along,
            along.abs(),
        );
        let weights = DVec3::new(
            way.made(
                "to take the absolute value of a direction's x",
                along.x,
                weights.x,
            ),
            way.made(
                "to take the absolute value of a direction's y",
                along.y,
                weights.y,
            ),
            way.made(
                "to take the absolute value of a direction's z",
                along.z,
                weights.z,
            ),
        );
        let reach = weights.dot(half);
        let least = at.into_iter().fold(f64::INFINITY, f64::min);
        let most = at.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let is_above = way.is_less("all of the triangle lies above a cell", reach, least);
        let is_below = way.is_less("all of the triangle lies below a cell", most, -reach);
        is_above || is_below
    };
    let by_faces = DVec3::AXES.map(&mut parts).contains(&true);
    let by_plane = parts(edges[0].cross(edges[1]));
    let mut across = |edge: DVec3| {
        let each = DVec3::AXES.map(|axis| parts(axis.cross(edge)));
        each.contains(&true)
    };
    let by_edges = edges.map(&mut across);
    let by_edges = [
        way.decides("a direction across p₁ − p₀ parts them", by_edges[0]),
        way.decides("a direction across p₂ − p₁ parts them", by_edges[1]),
        way.decides("a direction across p₀ − p₂ parts them", by_edges[2]),
    ];
    let is_parted = [
        way.decides(
            "a normal of the cell's faces parts it from the triangle",
            by_faces,
        ),
        way.decides("the triangle's normal parts it from a cell", by_plane),
        way.decides(
            "a direction across an edge and an axis parts a cell from the triangle",
            by_edges.contains(&true),
        ),
    ];
    !is_parted.contains(&true)
}

impl Explained for VoxelsOfTriangle {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec<Cell>] = &[
        Self::work,
        |asked, way| tried(asked, way, by_directions),
        |asked, way| all_tried(asked, way, by_clipping),
        |asked, way| all_tried(asked, way, by_directions),
    ];

    fn work(&self, way: &mut Way) -> Vec<Cell> {
        tried(self, way, by_clipping)
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
