//! Meshes from files: the reader for a file's name, and the errors.
//!
//! ```
//! use raybook::shape::mesh_file;
//! use std::path::Path;
//!
//! let error = mesh_file::load(Path::new("scan.doc")).expect_err("not a name of a mesh");
//! assert!(error.to_string().contains(".ply")); // the error tells which names would do
//! ```

use crate::shape::mesh::Mesh;
use crate::shape::obj::{self, Part, Parts};
use crate::shape::ply::{self, PlyError};
use crate::shape::stl::{self, BinaryError};
use crate::shape::word::{Reason, Wrong};
use crate::store::{self, StoreError};
use std::path::{Path, PathBuf};

/// Why a mesh cannot be loaded; every kind names the file.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// The system refused, or the path is not that of a file.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The name does not end in .obj, .stl or .ply.
    #[error("{}: a mesh's name must end in .obj, .stl or .ply", path.display())]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// A line of the text is wrong.
    #[error("{}:{wrong}", path.display())]
    Text {
        /// The file.
        path: PathBuf,
        /// The line, the column and the reason.
        wrong: Wrong,
    },
    /// A byte of a binary STL is wrong.
    #[error("{}: {wrong}", path.display())]
    Binary {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        wrong: BinaryError,
    },
    /// A number of a binary PLY is wrong.
    #[error("{}: byte {byte}: {reason}", path.display())]
    Number {
        /// The file.
        path: PathBuf,
        /// Where the number begins, from 0.
        byte: usize,
        /// What is wrong there.
        reason: Reason,
    },
    /// The file has no faces.
    #[error("{}: there is no face in this file; is it a mesh?", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
}

/// The formats of meshes.
enum Format {
    Obj,
    Stl,
    Ply,
}

/// Reads a mesh: Wavefront OBJ, STL or PLY, as the end of the file's name tells.
///
/// Time and memory are proportional to the size of the file, which is at most 1 GiB; the faces of an OBJ may take another 1 GiB.
/// Bytes that are not UTF-8 are allowed in names and comments; in a number they are an error, like letters.
///
/// # Errors
/// If the name has another end, the file cannot be read, its content is wrong or of another format, or it has no faces.
pub fn load(path: &Path) -> Result<Mesh, LoadError> {
    load_by(
        path,
        obj::parse,
        |mesh| mesh,
        |mesh| mesh.triangles().is_empty(),
    )
}

/// As [`load`], with a mesh for each material of an OBJ; the other formats have no materials, and give one mesh.
///
/// # Errors
/// Those of [`load`].
pub fn load_parts(path: &Path) -> Result<Parts, LoadError> {
    let one = |mesh: Mesh| Parts {
        libraries: Vec::new(),
        parts: vec![Part {
            material: String::new(),
            mesh,
        }],
    };
    let nothing = |parts: &Parts| {
        parts
            .parts
            .iter()
            .all(|part| part.mesh.triangles().is_empty())
    };
    load_by(path, obj::parse_parts, one, nothing)
}

/// Reads an OBJ by `parse_obj`; a mesh of another format is converted by `of_mesh`.
fn load_by<T>(
    path: &Path,
    parse_obj: impl Fn(&str) -> Result<T, Wrong>,
    of_mesh: impl Fn(Mesh) -> T,
    is_empty: impl Fn(&T) -> bool,
) -> Result<T, LoadError> {
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or_default();
    let format = match extension.to_ascii_lowercase().as_str() {
        "obj" => Format::Obj,
        "stl" => Format::Stl,
        "ply" => Format::Ply,
        _ => return Err(LoadError::Format { path: path.into() }),
    };
    let bytes = store::read(path)?;
    let text = || String::from_utf8_lossy(&bytes);
    let path = || path.to_owned();
    let of_text = |wrong| LoadError::Text {
        path: path(),
        wrong,
    };
    let read = match format {
        Format::Obj => parse_obj(&text()).map_err(of_text)?,
        Format::Stl if stl::is_binary(&bytes) => {
            let mesh = stl::parse_binary(&bytes).map_err(|wrong| LoadError::Binary {
                path: path(),
                wrong,
            });
            of_mesh(mesh?)
        }
        Format::Stl => of_mesh(stl::parse(&text()).map_err(of_text)?),
        Format::Ply => of_mesh(ply::parse(&bytes).map_err(|wrong| match wrong {
            PlyError::Text(wrong) => of_text(wrong),
            PlyError::Binary { byte, reason } => LoadError::Number {
                path: path(),
                byte,
                reason,
            },
        })?),
    };
    if is_empty(&read) {
        return Err(LoadError::Empty { path: path() });
    }
    Ok(read)
}
