//! Wavefront OBJ files: a line per vertex, a line per face.
//!
//! This reader exists although there are crates for OBJ: `tobj` 4 reports no line, accepts NaN as a number and the index 0 as a
//! missing index, and shifts the normals if only some corners have one. The tests compare the two readers on valid files.
//!
//! ```
//! use raybook::shape::obj;
//!
//! let mesh = obj::parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
//! assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3]]);
//! let error = obj::parse("v 0 0 0\nv 1 0 O\n").expect_err("a letter for a zero");
//! assert_eq!((error.line, error.column), (2, 7));
//! # Ok::<(), raybook::shape::word::Wrong>(())
//! ```

use crate::math::dir3::Dir3;
use crate::memory::BUDGET;
use crate::shape::attributes::vertex_normals;
use crate::shape::mesh::{Mesh, MeshError};
use crate::shape::word::{self, MOST_WORDS, Reason, Word, Wrong};
use glam::{Vec2, Vec3, vec2, vec3};
use std::collections::HashMap;

/// A corner of a face: indices from 0.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Corner {
    position: u32,
    texture: Option<u32>,
    normal: Option<u32>,
}

/// The faces of an OBJ text that are made of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The material's name; empty if none was named.
    pub material: String,
    /// The faces.
    pub mesh: Mesh,
}

/// An OBJ text, part by part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parts {
    /// The names of the files with the materials (`mtllib`), relative to the OBJ file.
    pub libraries: Vec<String>,
    /// One part for each material that faces use, in the order in which the materials are first named.
    pub parts: Vec<Part>,
}

#[derive(Default)]
struct Obj {
    positions: Vec<Vec3>,
    textures: Vec<Vec2>,
    /// `None` for a normal of length 0, which some programs write; it counts as missing.
    normals: Vec<Option<Dir3>>,
    triangles: Vec<[Corner; 3]>,
    /// The place in `materials` of each triangle's material.
    made_of: Vec<u32>,
    materials: Vec<String>,
    /// The place in `materials` of the material for the next faces.
    current: u32,
    libraries: Vec<String>,
}

/// The mesh of all faces of an OBJ text.
///
/// The keywords `v` (a weight or colour after x, y, z is ignored), `vt`, `vn` and `f` are read. Indices count from the first, 1,
/// or back from the last, −1; a face can only use what is above it in the text. Other keywords are ignored. A face of more than
/// three corners becomes a fan of triangles around its first corner, which is right for convex faces. So in a face `f 1 1 1 1 …`,
/// every two bytes of text make a triangle.
///
/// # Errors
/// The first error, with its line and column, for example more faces than the [budget](crate::memory::BUDGET) allows;
/// line 1 if the mesh as a whole is outside the [domain](crate::math::domain).
pub fn parse(text: &str) -> Result<Mesh, Wrong> {
    let obj = read(text)?;
    let mesh = obj.to_mesh(&obj.averaged(), &obj.triangles);
    mesh.map_err(Wrong::as_mesh)
}

/// The faces of an OBJ text, as one mesh for each material (`usemtl`) that they use.
///
/// # Errors
/// Those of [`parse`].
pub fn parse_parts(text: &str) -> Result<Parts, Wrong> {
    let mut obj = read(text)?;
    let averaged = obj.averaged();
    let mut of_materials = vec![Vec::new(); obj.materials.len()];
    for (triangle, material) in obj.triangles.iter().zip(&obj.made_of) {
        of_materials[*material as usize].push(*triangle);
    }
    let mut parts = Vec::new();
    for (triangles, material) in of_materials.iter().zip(&obj.materials) {
        if !triangles.is_empty() {
            let mesh = obj.to_mesh(&averaged, triangles);
            parts.push(Part {
                material: material.clone(),
                mesh: mesh.map_err(Wrong::as_mesh)?,
            });
        }
    }
    Ok(Parts {
        libraries: std::mem::take(&mut obj.libraries),
        parts,
    })
}

fn read(text: &str) -> Result<Obj, Wrong> {
    let mut obj = Obj {
        materials: vec![String::new()],
        ..Obj::default()
    };
    let mut places = HashMap::from([(String::new(), 0)]);
    for words in word::lines(text) {
        match words[0].text {
            "v" => {
                obj.positions.push(word::place(
                    &words,
                    3..=7,
                    "a vertex (v)",
                    "3 numbers, or 4 to 7 with a weight or colour",
                )?);
            }
            "vt" => {
                let n = word::numbers(&words, 1..=3, "a texture point (vt)", "1 to 3 numbers")?;
                obj.textures
                    .push(vec2(n[0], n.get(1).copied().unwrap_or(0.0)));
            }
            "vn" => {
                let n = word::numbers(&words, 3..=3, "a normal (vn)", "3 numbers")?;
                obj.normals.push(Dir3::new(vec3(n[0], n[1], n[2])));
            }
            "f" => obj.face(&words)?,
            "usemtl" => {
                let name = word::name(&words);
                let next = obj.materials.len() as u32;
                obj.current = *places.entry(name.clone()).or_insert(next);
                if obj.current == next {
                    obj.materials.push(name);
                }
            }
            "mtllib" => obj.libraries.push(word::name(&words)),
            _ => {}
        }
        let needed = obj.bytes();
        if needed > BUDGET {
            return Err(words[0].wrong(Reason::TooLarge(needed)));
        }
    }
    Ok(obj)
}

impl Obj {
    /// Size of what was read, in bytes. A triangle counts as stored here, plus twice three indices while the mesh is made.
    fn bytes(&self) -> u64 {
        /// Estimate for a name and its entry in the table of names, in bytes.
        const NAME: usize = 200;
        let triangle = size_of::<[Corner; 3]>() + 2 * size_of::<[u32; 3]>() + size_of::<u32>();
        let bytes = self.triangles.len() * triangle
            + (self.materials.len() + self.libraries.len()) * NAME
            + size_of_val(&*self.positions)
            + size_of_val(&*self.textures)
            + size_of_val(&*self.normals);
        bytes as u64
    }

    fn face(&mut self, words: &[Word]) -> Result<(), Wrong> {
        if words.len() > MOST_WORDS {
            return Err(words[0].wrong(Reason::Count {
                what: "a face (f)",
                needs: "3 corners or more, and at most a million",
                found: words.len(),
            }));
        }
        let corners = words[1..]
            .iter()
            .map(|word| self.corner(word))
            .collect::<Result<Vec<_>, _>>()?;
        if corners.len() < 3 {
            return Err(words[0].wrong(Reason::Count {
                what: "a face (f)",
                needs: "3 corners or more",
                found: corners.len(),
            }));
        }
        let fan = corners[1..].windows(2);
        self.triangles
            .extend(fan.map(|side| [corners[0], side[0], side[1]]));
        self.made_of.resize(self.triangles.len(), self.current);
        Ok(())
    }

    /// A corner: `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn corner(&self, word: &Word) -> Result<Corner, Wrong> {
        let mut parts = word.text.split('/');
        let mut next = |what, given| match parts.next() {
            None | Some("") => Ok(None),
            Some(part) => word.index(part, what, given).map(|i| Some(i as u32)),
        };
        let position = next("vertex (v)", self.positions.len())?;
        let texture = next("texture point (vt)", self.textures.len())?;
        let normal = next("normal (vn)", self.normals.len())?;
        match (position, parts.next()) {
            (Some(position), None) => Ok(Corner {
                position,
                texture,
                normal,
            }),
            _ => Err(word.expected(word::INDICES)),
        }
    }

    /// The mean normal of the faces around each position. So shading has no seam where texture coordinates or materials have one.
    fn averaged(&self) -> Vec<Dir3> {
        let by_position: Vec<_> = self
            .triangles
            .iter()
            .map(|corners| corners.map(|corner| corner.position))
            .collect();
        vertex_normals(&self.positions, &by_position)
    }

    /// The mesh with one vertex for each different corner: a position with two normals, at a sharp edge, becomes two vertices.
    fn to_mesh(&self, averaged: &[Dir3], triangles: &[[Corner; 3]]) -> Result<Mesh, MeshError> {
        let (mut positions, mut normals, mut textures) = (Vec::new(), Vec::new(), Vec::new());
        let mut vertices = HashMap::new();
        let mut vertex = |corner: Corner| {
            *vertices.entry(corner).or_insert_with(|| {
                let position = corner.position as usize;
                positions.push(self.positions[position]);
                let given = corner.normal.and_then(|i| self.normals[i as usize]);
                normals.push(given.unwrap_or(averaged[position]));
                let texture = corner.texture.map(|i| self.textures[i as usize]);
                textures.push(texture.unwrap_or(Vec2::ZERO));
                positions.len() as u32 - 1
            })
        };
        let triangles = triangles
            .iter()
            .map(|corners| corners.map(&mut vertex))
            .collect();
        Mesh::new(positions, triangles, Some(normals), Some(textures))
    }
}
