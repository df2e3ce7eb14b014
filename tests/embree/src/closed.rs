//! Closed surfaces, and rays that cannot get through them unless a structure leaks.
//!
//! # Why no answer is excused
//!
//! Each ray has one end at a point with a winding number other than 0 and the other outside of the mesh's bounds, and so it
//! crosses the surface, wherever rounding moves it. To find none of the triangles is a leak, whichever edge or corner the ray
//! is aimed at.

use glam::{DVec3, Vec3};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::{Mesh, MeshError};
use std::collections::{BTreeMap, HashMap};
use std::f64::consts::TAU;

/// A closed mesh, its shared edges and corners, and points inside.
pub struct Closed {
    /// The triangles.
    pub mesh: Mesh,
    /// The triangles that were added to close it.
    pub added: usize,
    edges: Vec<[u32; 2]>,
    inside: Vec<Vec3>,
    /// Twice the bounds' diagonal: from anywhere within the bounds this far is outside.
    far: f32,
}

/// Points inside.
const INSIDE: usize = 16;

impl Closed {
    /// The mesh with equal vertices made one, and each hole closed by a fan of triangles around its middle.
    ///
    /// # Errors
    /// If a coordinate is not finite.
    pub fn new(mesh: &Mesh) -> Result<Self, MeshError> {
        let (mut positions, mut triangles) = welded(mesh);
        let before = triangles.len();
        close(&mut positions, &mut triangles);
        let added = triangles.len() - before;
        let edges = edges(&triangles).into_keys().collect();
        let mesh = Mesh::new(positions, triangles, None, None)?;
        Ok(Self {
            inside: points_inside(&mesh),
            edges,
            added,
            far: 2.0 * mesh.bounds().size().length(),
            mesh,
        })
    }

    /// How many shared edges there are.
    pub fn edges(&self) -> usize {
        self.edges.len()
    }

    /// A ray aimed at an edge or, every fourth, a corner, outward or inward, and the stretch on which it must hit.
    pub fn ray(&self, rng: &mut Pcg) -> (Ray, Interval) {
        let edge = self.edges[rng.random_range(0..self.edges.len())];
        let [p, q] = edge.map(|i| self.mesh.positions()[i as usize]);
        let along = if rng.random_range(0..4) == 0 {
            0.0
        } else {
            rng.random::<f32>()
        };
        let aim = p + along * (q - p);
        let inside = self.inside[rng.random_range(0..self.inside.len())];
        let outward = Dir3::new_or(aim - inside, Dir3::Y);
        if rng.random() {
            (Ray::new(inside, outward), Interval::AHEAD)
        } else {
            let outside = inside + self.far * *outward;
            let inward = Dir3::new_or(aim - outside, -outward);
            let end = outside.distance(inside);
            (Ray::new(outside, inward), Interval::new(0.0, end))
        }
    }

    /// Whether every edge is passed as often in one direction as in the other.
    pub fn is_closed(&self) -> bool {
        edges(self.mesh.triangles()).values().all(|&sum| sum == 0)
    }
}

/// Vertices with the same coordinates become one, and triangles with twice the same vertex are left out.
fn welded(mesh: &Mesh) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let mut numbers = HashMap::new();
    let mut positions = Vec::new();
    let mut number = |i: u32| {
        let p = mesh.positions()[i as usize] + 0.0; // −0.0 becomes 0.0
        *numbers
            .entry(p.to_array().map(f32::to_bits))
            .or_insert_with(|| {
                positions.push(p);
                positions.len() as u32 - 1
            })
    };
    let named = mesh.triangles().iter().map(|t| t.map(&mut number));
    let triangles = named.filter(|[a, b, c]| a != b && b != c && c != a);
    let triangles = triangles.collect();
    (positions, triangles)
}

/// For each edge, named by its smaller vertex first: how much more often it is passed in that direction than back.
fn edges(triangles: &[[u32; 3]]) -> BTreeMap<[u32; 2], i32> {
    let mut sums = BTreeMap::new();
    for &[a, b, c] in triangles {
        for [p, q] in [[a, b], [b, c], [c, a]] {
            *sums.entry([p.min(q), p.max(q)]).or_insert(0) += if p < q { 1 } else { -1 };
        }
    }
    sums
}

/// Passes what is left open once more, in the other direction: as many triangles as needed, around the middle of each hole.
fn close(positions: &mut Vec<Vec3>, triangles: &mut Vec<[u32; 3]>) {
    let mut open: Vec<[u32; 2]> = Vec::new();
    for ([p, q], sum) in edges(triangles) {
        let back = if sum > 0 { [q, p] } else { [p, q] };
        open.extend(std::iter::repeat_n(back, sum.unsigned_abs() as usize));
    }
    while let Some(&first) = open.first() {
        // All that hangs together with the first: a hole, or several that touch.
        let mut rim = vec![first[0]];
        let mut hole = Vec::new();
        loop {
            let (found, rest): (Vec<_>, Vec<_>) = open
                .into_iter()
                .partition(|[p, q]| rim.contains(p) || rim.contains(q));
            open = rest;
            if found.is_empty() {
                break;
            }
            rim.extend(found.as_flattened());
            hole.extend(found);
        }
        let sum: Vec3 = hole.iter().map(|[p, _]| positions[*p as usize]).sum();
        let middle = positions.len() as u32;
        positions.push(sum / hole.len() as f32);
        triangles.extend(hole.into_iter().map(|[p, q]| [p, q, middle]));
    }
}

/// Points around which the surface winds, and that are not near to a vertex.
///
/// # Panics
/// If none is found.
fn points_inside(mesh: &Mesh) -> Vec<Vec3> {
    let bounds = mesh.bounds();
    let apart = 0.02 * bounds.size().length();
    let mut rng = pcg::stream(8, 8);
    let places = std::iter::repeat_with(|| {
        let part = Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
        bounds.min + part * bounds.size()
    });
    let is_inside = |&place: &Vec3| {
        let mut vertices = mesh.positions().iter();
        vertices.all(|p| p.distance(place) > apart) && winding(mesh, place).round() != 0.0
    };
    let inside: Vec<_> = places.take(2000).filter(is_inside).take(INSIDE).collect();
    assert!(!inside.is_empty(), "no place inside of the mesh was found");
    inside
}

/// How often the surface winds around a point: its solid angle, divided by 4π (van Oosterom and Strackee 1983).
pub fn winding(mesh: &Mesh, place: Vec3) -> f64 {
    let corner = |i: u32| mesh.positions()[i as usize].as_dvec3() - place.as_dvec3();
    let half_angle = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(corner);
        let [la, lb, lc] = [a, b, c].map(DVec3::length);
        let volume = a.dot(b.cross(c));
        volume.atan2(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb)
    };
    mesh.triangles().iter().map(half_angle).sum::<f64>() / TAU
}
