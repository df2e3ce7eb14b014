//! The meshes of the comparison with Embree: made by numbers, the same on every machine.
//!
//! Only +, −, ·, / and √ are used, which IEEE 754 rounds in one way; sines may differ from one C library to the next.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::math::{aabb::Aabb, dir3::Dir3};
use raybook::shape::mesh::{Mesh, MeshError};
use std::collections::BTreeMap;

/// The kinds of meshes, each about 2 m wide.
pub const KINDS: [&str; 5] = ["soup", "ball", "terrain", "crate", "slivers"];

/// A mesh of a kind, of at most `triangles` triangles (if the kind has any so small); `None` if there is no such kind.
///
/// `soup`: triangles at random, which cross each other. `ball`: a sphere with dents. `terrain`: a hill of bumps.
/// `crate`: a cube, each face a net of triangles in one plane. `slivers`: triangles 10 to 1000 times as long as wide.
pub fn named(kind: &str, triangles: u32) -> Option<Mesh> {
    let mut rng = pcg::stream(u64::from(triangles), 7);
    let (positions, triangles) = match kind {
        "soup" => apart(triangles, |_| {
            let center = in_cube(&mut rng);
            let size = (triangles as f32).cbrt().recip().max(0.05);
            [(); 3].map(|()| center + size * in_cube(&mut rng))
        }),
        "slivers" => apart(triangles, |i| {
            let (p, along) = (in_cube(&mut rng), in_cube(&mut rng));
            let width = [0.1, 0.03, 0.01, 0.003, 0.001][i as usize % 5];
            [p, p + along, p + along + width * in_cube(&mut rng)]
        }),
        "terrain" => terrain(side(triangles / 2), &mut rng),
        "crate" => {
            let (lattice, triangles) = cube(side(triangles / 12));
            (lattice, triangles)
        }
        "ball" => {
            let (lattice, triangles) = cube(side(triangles / 12));
            let dent = |p| *Dir3::new_or(p, Dir3::Y) * rng.random_range(0.95_f32..1.0);
            (lattice.into_iter().map(dent).collect(), triangles)
        }
        _ => return None,
    };
    Mesh::new(positions, triangles, None, None).ok()
}

/// The twelve triangles of a box.
///
/// # Errors
/// If a coordinate is not finite.
pub fn around(bounds: Aabb) -> Result<Mesh, MeshError> {
    let (lattice, triangles) = cube(1);
    let corner = |p: Vec3| Vec3::select(p.cmplt(Vec3::ZERO), bounds.min, bounds.max);
    Mesh::new(
        lattice.into_iter().map(corner).collect(),
        triangles,
        None,
        None,
    )
}

/// The largest k ≥ 1 with k² ≤ n.
fn side(n: u32) -> u32 {
    n.isqrt().max(1)
}

/// A point of the cube from −1 to 1.
fn in_cube(rng: &mut Pcg) -> Vec3 {
    vec3(rng.random(), rng.random(), rng.random()) * 2.0 - 1.0
}

type Triangles = (Vec<Vec3>, Vec<[u32; 3]>);

/// n triangles that share no corner.
fn apart(n: u32, mut triangle: impl FnMut(u32) -> [Vec3; 3]) -> Triangles {
    let positions = (0..n).flat_map(&mut triangle).collect();
    (
        positions,
        (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
    )
}

/// A net of k × k squares over −1 ≤ x, z ≤ 1, two triangles each.
fn terrain(k: u32, rng: &mut Pcg) -> Triangles {
    let mut positions = Vec::new();
    for row in 0..=k {
        for column in 0..=k {
            let [x, z] = [column, row].map(|i| 2.0 * i as f32 / k as f32 - 1.0);
            let bump = rng.random::<f32>() / k as f32;
            positions.push(vec3(x, 0.5 * (1.0 - x * x) * (1.0 - z * z) + bump, z));
        }
    }
    let mut triangles = Vec::new();
    for row in 0..k {
        for column in 0..k {
            let [a, b] = [row, row + 1].map(|row| row * (k + 1) + column);
            triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
        }
    }
    (positions, triangles)
}

/// The surface of the cube from −1 to 1, each face a net of k × k squares; neighbouring faces share their corners.
fn cube(k: u32) -> Triangles {
    let mut numbers = BTreeMap::new();
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for axis in 0..3 {
        for (level, above) in [(0, false), (k, true)] {
            let mut corner = |i: u32, j: u32| {
                let mut lattice = [level; 3];
                lattice[(axis + 1) % 3] = i;
                lattice[(axis + 2) % 3] = j;
                *numbers.entry(lattice).or_insert_with(|| {
                    positions.push(Vec3::from(lattice.map(|l| 2.0 * l as f32 / k as f32 - 1.0)));
                    positions.len() as u32 - 1
                })
            };
            for i in 0..k {
                for j in 0..k {
                    let [a, b, c, d] =
                        [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(x, y)| corner(i + x, j + y));
                    // Counter-clockwise from outside: axis + 1 turns to axis + 2 around +axis.
                    let (b, d) = if above { (b, d) } else { (d, b) };
                    triangles.extend([[a, b, c], [a, c, d]]);
                }
            }
        }
    }
    (positions, triangles)
}
