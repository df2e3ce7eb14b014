//! Models: an OBJ file with its materials and their pictures, as the things of a scene.
//!
//! ```
//! use raybook::scene::model;
//!
//! let path = std::env::temp_dir().join(format!("raybook-{}.obj", std::process::id()));
//! let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
//! raybook::store::write(&path, format!("{corners}usemtl brick\nf 1 2 3\nusemtl roof\nf 1 3 4\n").as_bytes())?;
//! assert_eq!(model::load(&path)?.things.len(), 2); // a thing for each material
//! std::fs::remove_file(&path)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::accel::{Meshed, wide_bvh::WideBvh};
use crate::image::file::{self, FileError};
use crate::image::{mip::MipMap, rgb::Rgb, tone};
use crate::material::mtl::{self, Maps, Mtl};
use crate::material::{Material, lambert::Lambert};
use crate::scene::world::Thing;
use crate::shape::mesh::Mesh;
use crate::shape::mesh_file::{self, LoadError};
use crate::shape::normal_map::NormalMap;
use crate::shape::word::Wrong;
use crate::store::{self, StoreError};
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Why a model cannot be loaded; every kind names the file.
#[derive(Debug, thiserror::Error)]
pub enum ModelError {
    /// The mesh cannot be loaded.
    #[error(transparent)]
    Mesh(#[from] LoadError),
    /// A file of materials cannot be read.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A line of a file of materials is wrong.
    #[error("{}:{wrong}", path.display())]
    Materials {
        /// The file.
        path: PathBuf,
        /// The line, the column and the reason.
        wrong: Wrong,
    },
    /// A picture cannot be read.
    #[error(transparent)]
    Picture(#[from] FileError),
    /// Faces use a material that no file describes.
    #[error("{}: its faces use the material `{}`, which its files of materials (mtllib) do not describe; they describe {}", path.display(), name.escape_debug(), known(described))]
    Unknown {
        /// The OBJ file.
        path: PathBuf,
        /// The name that the faces use.
        name: String,
        /// The names of the materials that are described.
        described: Vec<String>,
    },
}

fn known(names: &[String]) -> String {
    let names: Vec<_> = names
        .iter()
        .map(|name| name.escape_debug().to_string())
        .collect();
    if names.is_empty() {
        return "none".to_owned();
    }
    names.join(", ")
}

/// A model from a file.
#[derive(Clone, Debug)]
pub struct Model {
    /// One thing for each material.
    pub things: Vec<Thing>,
    /// What the files describe and the things do not have, such as `map_Bump`: a sentence for each file of materials.
    pub remarks: Vec<String>,
}

/// Reads a model: one thing for each material of an OBJ file. An STL or PLY file, and faces without a material, are light grey.
///
/// The paths of files of materials, and of the pictures that they name, are relative to the file that names them. Pictures of
/// colours are PNG, EXR or HDR; pictures of normals are PNG.
///
/// # Errors
/// If a file cannot be read or is wrong, or a material is missing.
pub fn load(path: &Path) -> Result<Model, ModelError> {
    let parts = mesh_file::load_parts(path)?;
    let (mut materials, mut remarks) = (HashMap::new(), Vec::new());
    let mut pictures = Pictures::default();
    for library in &parts.libraries {
        let file = beside(path, library);
        let text = store::read(&file)?;
        let described = mtl::parse(&String::from_utf8_lossy(&text));
        let described = described.map_err(|wrong| ModelError::Materials {
            path: file.clone(),
            wrong,
        })?;
        remarks.extend(remark(&file, &described));
        for mtl in described {
            materials.insert(mtl.name.clone(), (mtl, file.clone()));
        }
    }
    let things = parts.parts.into_iter().map(|part| {
        if part.material.is_empty() || parts.libraries.is_empty() {
            let grey = Lambert {
                albedo: Rgb::gray(0.8),
            };
            return Ok(thing(part.mesh, Arc::new(grey)));
        }
        let Some((mtl, file)) = materials.get(&part.material) else {
            let mut described: Vec<_> = materials.keys().cloned().collect();
            described.sort_unstable();
            return Err(ModelError::Unknown {
                path: path.into(),
                name: part.material,
                described,
            });
        };
        pictures.thing(part.mesh, mtl, file)
    });
    Ok(Model {
        things: things.collect::<Result<_, _>>()?,
        remarks,
    })
}

/// What a file of materials describes and this library does not have; `None` if there is nothing.
fn remark(file: &Path, described: &[Mtl]) -> Option<String> {
    let unused: BTreeSet<_> = described.iter().flat_map(|mtl| &mtl.unused).collect();
    if unused.is_empty() {
        return None;
    }
    let words: Vec<_> = unused.iter().map(|word| format!("`{word}`")).collect();
    let is_of_heights = |word: &&&str| word.to_lowercase().ends_with("bump");
    let hint = if unused.iter().any(is_of_heights) {
        "; bumps must be a normal map, which `norm` names"
    } else {
        ""
    };
    let (file, words) = (file.display(), words.join(", "));
    Some(format!("{file}: not used: {words}{hint}"))
}

fn thing(mesh: Mesh, material: Arc<dyn Material>) -> Thing {
    Thing {
        shape: Arc::new(Meshed::new(mesh, WideBvh::new)),
        material,
    }
}

/// The path of a file that another file names.
fn beside(file: &Path, name: &str) -> PathBuf {
    file.parent().unwrap_or(Path::new("")).join(name)
}

/// The pictures that have been read: each is read once, even if several materials use it.
#[derive(Default)]
struct Pictures {
    colours: HashMap<PathBuf, Arc<MipMap>>,
    normals: HashMap<PathBuf, Arc<NormalMap>>,
}

impl Pictures {
    fn thing(&mut self, mesh: Mesh, mtl: &Mtl, file: &Path) -> Result<Thing, ModelError> {
        let mut colours = |name: &Option<String>| match name {
            Some(name) => self.colours(beside(file, name)).map(Some),
            None => Ok(None),
        };
        let maps = Maps {
            diffuse: colours(&mtl.diffuse_map)?,
            specular: colours(&mtl.specular_map)?,
        };
        let mesh = match &mtl.normal_map {
            Some(name) => mesh.with_bumps(self.normals(beside(file, name))?),
            None => mesh,
        };
        Ok(thing(mesh, mtl.material(maps)))
    }

    fn colours(&mut self, path: PathBuf) -> Result<Arc<MipMap>, ModelError> {
        if let Some(map) = self.colours.get(&path) {
            return Ok(map.clone());
        }
        let map = Arc::new(MipMap::new(&file::load(&path)?));
        Ok(self.colours.entry(path).or_insert(map).clone())
    }

    fn normals(&mut self, path: PathBuf) -> Result<Arc<NormalMap>, ModelError> {
        if let Some(map) = self.normals.get(&path) {
            return Ok(map.clone());
        }
        let picture = file::load(&path)?.map(|pixel| pixel.map(tone::encode_srgb));
        let map = Arc::new(NormalMap::new(&picture));
        Ok(self.normals.entry(path).or_insert(map).clone())
    }
}
