//! The Utah teapot (Martin Newell's, in Blinn and Newell 1976), as a mesh of any fineness.
//!
//! ```
//! use raybook::shape::teapot;
//!
//! let [coarse, fine] = [1, 4].map(|n| teapot::mesh(n).triangles().len());
//! assert!(fine > 12 * coarse); // triangles grow as n²
//! ```

use crate::math::dir3::Dir3;
use crate::shape::bezier::Patch;
use crate::shape::mesh::Mesh;
use crate::shape::triangle::Triangle;
use crate::shape::word::{self, Wrong};
use glam::{Vec2, Vec3, vec2, vec3};
use std::num::NonZeroUsize;

/// The text of `teapot.txt`: control points and patches, in a format that its comments explain.
pub const DATA: &str = include_str!("teapot.txt");

/// The radius of Newell's lid, and the radius of the rim in which it lies.
const LID_RADIUS: (f32, f32) = (1.3, 1.4);

/// A part of the teapot: a grid of patches, with rows along the part and columns around it.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The part's name, for example "lid".
    pub name: String,
    /// Number of patches around the part.
    pub columns: NonZeroUsize,
    /// The patches, row by row.
    pub patches: Vec<Patch>,
}

/// The parts in a text like [`DATA`]. In the text z points up, here y: (x, y, z) in the text becomes (x, z, −y).
///
/// # Errors
/// The first error, with its line and column.
pub fn parts(text: &str) -> Result<Vec<Part>, Wrong> {
    let (mut points, mut parts) = (Vec::new(), Vec::<Part>::new());
    for words in word::lines(text) {
        match (words[0].text, &words[1..], parts.last_mut()) {
            ("v", _, _) => {
                let n = word::numbers(&words, 3..=3, "a control point", "3 numbers")?;
                points.push(vec3(n[0], n[2], -n[1]));
            }
            ("part", [name, columns], _) => parts.push(Part {
                name: name.text.to_owned(),
                columns: columns
                    .text
                    .parse()
                    .map_err(|_| columns.expected("a number of patches"))?,
                patches: Vec::new(),
            }),
            ("patch", numbers, Some(part)) if numbers.len() == 16 => {
                let mut patch = Patch::default();
                for (i, number) in numbers.iter().enumerate() {
                    let point = number.index(number.text, "control point", points.len())?;
                    patch.rows[i / 4][i % 4] = points[point];
                }
                part.patches.push(patch);
            }
            _ => {
                return Err(
                    words[0].expected("`v x y z`, `part name columns` or `patch` and 16 numbers")
                );
            }
        }
    }
    Ok(parts)
}

/// The teapot, each of its 32 patches cut into n × n quadrilaterals: 64n² − 8n triangles for n ≥ 2. n = 0 counts as 1.
///
/// Its axis is the y axis, from the middle of the bottom at y = 0 to the top of the knob at y = 3.15; the spout points to +x.
/// The lid is widened to meet the rim, so that body and lid together are watertight. The handle and the spout
/// are tubes that end inside the body.
/// The normals are those of the patches, not averages. The texture coordinates count patches, x around a part and
/// y along it, so their fractional parts run from 0 to 1 on each patch. Neighbouring patches share their vertices.
pub fn mesh(n: usize) -> Mesh {
    let parts = parts(DATA).unwrap_or_else(|wrong| unreachable!("teapot.txt:{wrong}"));
    let mut pot = Pot::default();
    for mut part in parts {
        if part.name == "lid" {
            let (from, to) = LID_RADIUS;
            let widen = |p: Vec3| vec3(p.x / from * to, p.y, p.z / from * to);
            for patch in &mut part.patches {
                patch.rows = patch.rows.map(|row| row.map(widen));
            }
        }
        pot.add(&part, n.max(1));
    }
    Mesh::new(
        pot.positions,
        pot.triangles,
        Some(pot.normals),
        Some(pot.textures),
    )
    .unwrap_or_else(|error| unreachable!("the teapot is finite: {error}"))
}

#[derive(Default)]
struct Pot {
    positions: Vec<Vec3>,
    normals: Vec<Dir3>,
    textures: Vec<Vec2>,
    triangles: Vec<[u32; 3]>,
}

impl Pot {
    /// Adds a part: a grid of vertices over all its patches, and two triangles per cell.
    fn add(&mut self, part: &Part, n: usize) {
        let columns = part.columns.get();
        let rows = part.patches.len() / columns;
        let (high, wide) = (rows * n, columns * n);
        let first = self.positions.len() as u32;
        for i in 0..=high {
            for j in 0..=wide {
                // The last vertices belong to the end of the last patch.
                let (row, column) = ((i / n).min(rows - 1), (j / n).min(columns - 1));
                let patch = &part.patches[row * columns + column];
                let u = (i - row * n) as f32 / n as f32;
                let v = (j - column * n) as f32 / n as f32;
                self.positions.push(patch.point(u, v));
                self.normals.push(patch.normal(u, v).unwrap_or(Dir3::Y));
                self.textures.push(vec2(j as f32, i as f32) / n as f32);
            }
        }
        let vertex = |i: usize, j: usize| first + (i * (wide + 1) + j) as u32;
        for i in 0..high {
            for j in 0..wide {
                let (a, b) = (vertex(i, j), vertex(i, j + 1));
                let (c, d) = (vertex(i + 1, j), vertex(i + 1, j + 1));
                for triangle in [[a, b, d], [a, d, c]] {
                    if self.has_area(triangle) {
                        self.triangles.push(triangle);
                    }
                }
            }
        }
    }

    /// Whether a triangle has an area: not at the poles of lid and bottom, where one side of a patch is a single point.
    fn has_area(&self, corners: [u32; 3]) -> bool {
        let [p0, p1, p2] = corners.map(|i| self.positions[i as usize]);
        Triangle::new(p0, p1, p2).normal().is_some()
    }
}
