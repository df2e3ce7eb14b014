//! What rays are aimed at: closed rooms, the teapot, soups, a strip, at scales from 10⁻⁶ to 10⁶.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::{aabb::Aabb, pcg};
use raybook::scene::soup::soup;
use raybook::shape::{mesh::Facet, teapot};

/// Facets, and the box inside of them if they are closed.
pub(crate) struct Room {
    pub(crate) what: String,
    pub(crate) facets: Vec<Facet>,
    pub(crate) inside: Option<Aabb>,
}

/// Every kind at every scale, half of them off the world's origin.
pub(crate) fn rooms() -> Vec<Room> {
    let mut rooms = Vec::new();
    let kinds = [
        ("room", room(4, vec3(1.0, 0.7, 1.3)), true),
        ("bare room", room(1, vec3(1.0, 1.0, 1.0)), true),
        ("furnished room", furnished(), true),
        ("teapot", corners(&teapot::mesh(2).facets()), false),
        ("soup", corners(&soup(300, 3).facets()), false),
        ("lattice", lattice(200), false),
        ("strip", strip(150), false),
        ("teapot in a stadium", stadium(), false),
    ];
    for (kind, (name, triangles, closed)) in kinds.into_iter().enumerate() {
        for power in [-6, -3, -1, 0, 2, 6] {
            let scale = 10.0_f32.powi(power);
            let off = scale
                * [vec3(0.0, 0.0, 0.0), vec3(3.7, -1.3, 0.4)]
                    [(kind + power.unsigned_abs() as usize) % 2];
            let at = |p: Vec3| scale * p + off;
            let facets = triangles.iter().zip(0..).map(|(corners, id)| Facet {
                corners: corners.map(at),
                id,
            });
            let facets: Vec<_> = facets.collect();
            let bounds = Aabb::of(facets.iter().flat_map(|facet| facet.corners));
            rooms.push(Room {
                what: format!("{name} at scale {scale}"),
                inside: closed.then(|| bounds.grown(-1e-4 * scale)),
                facets,
            });
        }
    }
    rooms
}

fn corners(facets: &[Facet]) -> Vec<[Vec3; 3]> {
    facets.iter().map(|facet| facet.corners).collect()
}

/// The faces of a box, each cut into n × n squares of two triangles. Neighbours share their corners to the last digit.
pub(crate) fn room(n: u32, size: Vec3) -> Vec<[Vec3; 3]> {
    let place = |i: u32, length: f32| length * (i as f32 / n as f32);
    let mut triangles = Vec::new();
    for axis in 0..3 {
        for side in [0, n] {
            for i in 0..n {
                for j in 0..n {
                    let at = |i: u32, j: u32| {
                        let mut p = Vec3::ZERO;
                        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                        p[axis] = place(side, size[axis]);
                        p[u] = place(i, size[u]);
                        p[v] = place(j, size[v]);
                        p
                    };
                    let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                    triangles.extend([[a, b, c], [a, c, d]]);
                }
            }
        }
    }
    triangles
}

/// A room with a soup in it.
fn furnished() -> Vec<[Vec3; 3]> {
    let soup = corners(&soup(150, 8).facets());
    let inside = soup.into_iter().map(|t| t.map(|p| 0.3 + 0.4 * p));
    room(3, Vec3::ONE).into_iter().chain(inside).collect()
}

/// Triangles whose corners are whole numbers: they share edges, planes and places, and some have no area.
fn lattice(n: usize) -> Vec<[Vec3; 3]> {
    let mut rng = pcg::stream(5, 5);
    let mut corner =
        || Vec3::from_array(std::array::from_fn(|_| rng.random_range(-3..=3_i32) as f32));
    (0..n).map(|_| [corner(), corner(), corner()]).collect()
}

/// A ribbon, n times as long as wide.
pub(crate) fn strip(n: u32) -> Vec<[Vec3; 3]> {
    let at = |i: u32, z: f32| vec3(i as f32 / n as f32, 0.1, z / n as f32);
    let square = |i: u32| {
        let [a, b, c, d] = [at(i, 0.0), at(i + 1, 0.0), at(i + 1, 1.0), at(i, 1.0)];
        [[a, b, c], [a, c, d]]
    };
    (0..n).flat_map(square).collect()
}

/// A small teapot, and two triangles far away.
fn stadium() -> Vec<[Vec3; 3]> {
    let teapot = corners(&teapot::mesh(2).facets());
    let mut all: Vec<_> = teapot.into_iter().map(|t| t.map(|p| 0.002 * p)).collect();
    let far = |p: Vec3| [p, p + 0.3 * Vec3::X, p + 0.3 * Vec3::Y];
    all.extend([far(Vec3::splat(0.6)), far(Vec3::splat(-0.8))]);
    all
}
