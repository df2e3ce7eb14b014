//! PLY files, as 3D scanners write them: a header that describes what follows, then vertices and faces, in text or in binary.
//!
//! Greg Turk, "The PLY Polygon File Format", Stanford University, 1994. This reader reports each error with its line or byte.
//!
//! ```
//! use raybook::shape::ply;
//!
//! let text = "ply\nformat ascii 1.0\n\
//!     element vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
//!     element face 1\nproperty list uchar int vertex_indices\nend_header\n\
//!     0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
//! assert_eq!(ply::parse(text.as_bytes())?.triangles(), [[0, 1, 2]]);
//! # Ok::<(), ply::PlyError>(())
//! ```

mod body;
mod header;

use crate::math::dir3::Dir3;
use crate::math::domain::LARGEST;
use crate::memory::BUDGET;
use crate::shape::mesh::Mesh;
use crate::shape::word::{Reason, Wrong};
use body::{Body, each_number};
use glam::{Vec2, Vec3, vec2};
use header::{Element, Header, Role, SLOTS};

/// What is wrong with a file, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlyError {
    /// An error in a line of the header or of a text.
    #[error(transparent)]
    Text(#[from] Wrong),
    /// An error in a number of a binary file.
    #[error("byte {byte}: {reason}")]
    Binary {
        /// Where the number begins, from 0.
        byte: usize,
        /// What is wrong there.
        reason: Reason,
    },
}

/// The mesh of a PLY file.
///
/// The vertices with their normals (`nx`, `ny`, `nz`) and texture coordinates (`u`, `v` or `s`, `t`) are read, and the corners of
/// the faces. Other elements and properties are ignored. If a normal is missing or is 0, all normals are averaged from the
/// triangles. A face of more than three corners becomes a fan of triangles around its first corner, which is right for convex
/// faces.
///
/// # Errors
/// The first error, with its line or its byte, for example more faces than the [budget](crate::memory::BUDGET) allows;
/// line 1 if the mesh as a whole is outside the [domain](crate::math::domain).
pub fn parse(bytes: &[u8]) -> Result<Mesh, PlyError> {
    let (header, rest) = Header::parse(bytes)?;
    match header.order {
        None => read(
            &header,
            body::Text::new(&String::from_utf8_lossy(rest), header.lines + 1),
        ),
        Some(order) => read(&header, body::Binary::new(bytes, rest, order)),
    }
}

fn read(header: &Header, mut body: impl Body) -> Result<Mesh, PlyError> {
    let vertices = header.count("vertex");
    let mut parts = Parts::default();
    for element in &header.elements {
        // An element without properties takes no space in the file, whatever its number of rows.
        let rows = if element.properties.is_empty() {
            0
        } else {
            element.count
        };
        for _ in 0..rows {
            body.begin_row()?;
            match element.name.as_str() {
                "vertex" => parts.vertex(element, &mut body)?,
                _ => parts.face(element, &mut body, vertices)?,
            }
            body.end_row()?;
        }
    }
    body.end()?;
    let normals = parts.normals.into_iter().collect();
    let mesh = Mesh::new(
        parts.positions,
        parts.triangles,
        normals,
        Some(parts.textures),
    );
    Ok(mesh.map_err(Wrong::as_mesh)?)
}

/// What was read.
#[derive(Default)]
struct Parts {
    positions: Vec<Vec3>,
    /// `None` for a normal that is missing or is 0.
    normals: Vec<Option<Dir3>>,
    textures: Vec<Vec2>,
    triangles: Vec<[u32; 3]>,
}

impl Parts {
    /// Reads a row of vertices.
    fn vertex(&mut self, element: &Element, body: &mut impl Body) -> Result<(), PlyError> {
        let mut slots = [0.0; SLOTS];
        for property in &element.properties {
            each_number(property, body, |body, number| {
                if let Role::Slot(slot) = property.role {
                    slots[slot] = number as f32;
                    if !slots[slot].is_finite() {
                        return Err(body.wrong(Reason::NotFinite(format!("{number:e}"))));
                    }
                    if slot < 3 && slots[slot].abs() > LARGEST {
                        return Err(body.wrong(Reason::TooFar(format!("{number:e}"))));
                    }
                }
                Ok(())
            })?;
        }
        let [x, y, z, nx, ny, nz, u, v] = slots;
        self.positions.push(Vec3::new(x, y, z));
        self.normals.push(Dir3::new(Vec3::new(nx, ny, nz)));
        self.textures.push(vec2(u, v));
        self.within_budget(body)
    }

    /// Reads a row of faces, or of another element, whose numbers are ignored.
    fn face(
        &mut self,
        element: &Element,
        body: &mut impl Body,
        vertices: u64,
    ) -> Result<(), PlyError> {
        for property in &element.properties {
            let (mut first, mut previous, mut corners) = (0, 0, 0);
            each_number(property, body, |body, number| {
                if property.role != Role::Corners {
                    return Ok(());
                }
                let index = index(body, number, vertices)?;
                match corners {
                    0 => first = index,
                    1 => {}
                    _ => self.triangles.push([first, previous, index]),
                }
                previous = index;
                corners += 1;
                self.within_budget(body)
            })?;
            if property.role == Role::Corners && corners < 3 {
                return Err(body.wrong(Reason::Count {
                    what: "a face",
                    needs: "3 corners or more",
                    found: corners,
                }));
            }
        }
        Ok(())
    }

    fn within_budget(&self, body: &impl Body) -> Result<(), PlyError> {
        let bytes = size_of_val(&*self.positions)
            + size_of_val(&*self.normals)
            + size_of_val(&*self.textures)
            + size_of_val(&*self.triangles);
        if bytes as u64 > BUDGET {
            return Err(body.wrong(Reason::TooLarge(bytes as u64)));
        }
        Ok(())
    }
}

/// A number as an index, from 0, of one of the `vertices` vertices.
fn index(body: &impl Body, number: f64, vertices: u64) -> Result<u32, PlyError> {
    let index = number as u32;
    if f64::from(index) == number && u64::from(index) < vertices {
        Ok(index)
    } else {
        Err(body.wrong(Reason::FromZero {
            index: number.to_string(),
            given: vertices,
        }))
    }
}
