//! STL files, as 3D printers read them: every triangle on its own, in text or in binary.
//!
//! Corners at the same place become one vertex, whose normal is averaged. The normals in the file, one per triangle and
//! often wrong, are ignored. This reader reports each error with its line or byte.
//!
//! ```
//! use raybook::shape::stl;
//!
//! let corners = |z| format!("outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 {z}\nendloop\n");
//! let facet = |z| format!("facet normal 0 0 1\n{}endfacet\n", corners(z));
//! let mesh = stl::parse(&format!("solid two\n{}{}endsolid two\n", facet(0), facet(1)))?;
//! // Two triangles of three corners, two of which they share.
//! assert_eq!((mesh.triangles().len(), mesh.positions().len()), (2, 4));
//! # Ok::<(), raybook::shape::word::Wrong>(())
//! ```

use crate::math::domain::LARGEST;
use crate::shape::mesh::{Mesh, MeshError};
use crate::shape::word::{self, Reason, Wrong};
use glam::{Vec3, vec3};
use std::collections::HashMap;

/// Size of a binary file's header, in bytes: 80 arbitrary bytes, then the number of triangles.
const HEADER: usize = 84;
/// Size of a triangle in a binary file, in bytes: 12 numbers (the normal and three corners) and 2 arbitrary bytes.
const RECORD: usize = 50;

/// An error in a binary file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BinaryError {
    /// The file is cut off, or of another format, or text that does not begin with `solid`.
    #[error(
        "this is neither STL text (there is no `solid`) nor binary STL: {found} bytes cannot hold a header of 84"
    )]
    Header {
        /// How many bytes there are.
        found: usize,
    },
    /// The file is too short or too long.
    #[error(
        "byte 80 promises {triangles} triangles, that is a file of {needed} bytes, but it has {found}"
    )]
    Size {
        /// Number of triangles that the header promises.
        triangles: u32,
        /// Size of a file with this number of triangles, in bytes.
        needed: u64,
        /// How many bytes there are.
        found: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error(
        "byte {byte}: a corner of triangle {triangle} (the first is 0) is not at a finite place"
    )]
    NotFinite {
        /// Where the corner begins, from 0.
        byte: usize,
        /// Which triangle, from 0.
        triangle: usize,
    },
    /// A coordinate is outside the domain.
    #[error(
        "byte {byte}: a corner of triangle {triangle} (the first is 0) is more than {LARGEST:e} m from 0 along an axis; make the mesh smaller"
    )]
    TooFar {
        /// Where the corner begins, from 0.
        byte: usize,
        /// Which triangle, from 0.
        triangle: usize,
    },
    /// The triangles do not make a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// Whether the bytes are binary STL: their number fits the number of triangles, or they do not begin with `solid`.
///
/// Some programs begin a binary file with `solid` too, so the size is tested first.
pub fn is_binary(bytes: &[u8]) -> bool {
    promised(bytes).is_some_and(|(_, needed)| needed == bytes.len() as u64)
        || !bytes.trim_ascii_start().starts_with(b"solid")
}

/// The number of triangles in the header, and the size of a file that holds them.
fn promised(bytes: &[u8]) -> Option<(u32, u64)> {
    let count = bytes.get(HEADER - 4..HEADER)?.first_chunk()?;
    let triangles = u32::from_le_bytes(*count);
    Some((
        triangles,
        HEADER as u64 + RECORD as u64 * u64::from(triangles),
    ))
}

/// The mesh of a binary STL file.
///
/// # Errors
/// If the size does not fit the header, a corner is not finite, or the mesh is outside the [domain](crate::math::domain).
pub fn parse_binary(bytes: &[u8]) -> Result<Mesh, BinaryError> {
    let found = bytes.len();
    let (triangles, needed) = promised(bytes).ok_or(BinaryError::Header { found })?;
    if needed != found as u64 {
        return Err(BinaryError::Size {
            triangles,
            needed,
            found,
        });
    }
    let mut soup = Soup::default();
    for (triangle, record) in bytes[HEADER..].chunks_exact(RECORD).enumerate() {
        for (k, corner) in record[12..48].chunks_exact(12).enumerate() {
            let number = |i: usize| {
                corner[4 * i..]
                    .first_chunk()
                    .map_or(f32::NAN, |bytes| f32::from_le_bytes(*bytes))
            };
            let place = vec3(number(0), number(1), number(2));
            let byte = HEADER + RECORD * triangle + 12 * (k + 1);
            if !place.is_finite() {
                return Err(BinaryError::NotFinite { byte, triangle });
            }
            if place.abs().max_element() > LARGEST {
                return Err(BinaryError::TooFar { byte, triangle });
            }
            soup.add(place);
        }
    }
    Ok(soup.into_mesh()?)
}

/// The mesh of an STL text.
///
/// # Errors
/// The first error, with its line and column; line 1 if the mesh as a whole is outside the [domain](crate::math::domain).
pub fn parse(text: &str) -> Result<Mesh, Wrong> {
    /// The order of the keywords, each with what the error message expects; any name may follow `solid`.
    const GRAMMAR: [(&str, &str); 7] = [
        ("facet", "`facet normal …` or `endsolid`"),
        ("outer", "`outer loop`"),
        ("vertex", "`vertex x y z`, three times"),
        ("vertex", "`vertex x y z`, three times"),
        ("vertex", "`vertex x y z`, three times"),
        ("endloop", "`endloop`"),
        ("endfacet", "`endfacet`"),
    ];
    let mut soup = Soup::default();
    let (mut step, mut solid, mut last) = (0, false, None);
    for words in word::lines(text) {
        let (keyword, expected) = if solid {
            GRAMMAR[step]
        } else {
            ("solid", "`solid`")
        };
        let first = words[0];
        last = words.last().copied();
        match first.text.to_ascii_lowercase().as_str() {
            "solid" if !solid => solid = true,
            "endsolid" if solid && step == 0 => solid = false,
            found if !solid || found != keyword => return Err(first.expected(expected)),
            found => {
                if found == "vertex" {
                    soup.add(word::place(&words, 3..=3, "a vertex", "3 numbers")?);
                }
                step = (step + 1) % GRAMMAR.len();
            }
        }
    }
    match last {
        Some(word) if solid => Err(word.wrong(Reason::End(if step == 0 {
            "`endsolid`"
        } else {
            GRAMMAR[step].1
        }))),
        _ => soup.into_mesh().map_err(Wrong::as_mesh),
    }
}

/// Unconnected triangles while they are welded: corners at the same place become one vertex.
#[derive(Default)]
struct Soup {
    positions: Vec<Vec3>,
    /// The vertex of each corner; three consecutive corners are a triangle.
    corners: Vec<u32>,
    vertices: HashMap<[u32; 3], u32>,
}

impl Soup {
    /// Adds a corner: with the vertex that is exactly at this place, or with a new vertex.
    fn add(&mut self, place: Vec3) {
        let place = place + Vec3::ZERO; // −0.0 becomes 0.0: the same place, but other bits
        let vertex = *self
            .vertices
            .entry(place.to_array().map(f32::to_bits))
            .or_insert_with(|| {
                self.positions.push(place);
                self.positions.len() as u32 - 1
            });
        self.corners.push(vertex);
    }

    fn into_mesh(self) -> Result<Mesh, MeshError> {
        let triangles = self.corners.chunks_exact(3);
        let triangles = triangles.map(|c| [c[0], c[1], c[2]]).collect();
        Mesh::new(self.positions, triangles, None, None)
    }
}
