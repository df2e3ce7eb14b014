//! Meshes from files: which reader a file's name asks for, and what to say if it fails.

use crate::shape::mesh::Mesh;
use crate::shape::word::Wrong;
use crate::shape::{obj, stl};
use crate::store::{self, StoreError};
use std::path::{Path, PathBuf};

/// Why a file does not give a mesh; every kind names the file.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// The system refused, or it is no file.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The name does not end like a mesh's.
    #[error("{}: a mesh's name must end in .obj or .stl", path.display())]
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
    /// A byte of a binary file is wrong.
    #[error("{}: {wrong}", path.display())]
    Binary {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        wrong: stl::BinaryError,
    },
    /// Nothing to see.
    #[error("{}: there is no face in this file; is it a mesh?", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
}

/// Reads a mesh: Wavefront OBJ or STL, as the end of the file's name says.
///
/// Takes time and memory in proportion to the file, which may have 1 GiB; the faces of an OBJ may take as much. Bytes that are not UTF-8 do no harm in names and comments;
/// in a number they are refused like other letters.
///
/// # Errors
/// If the file cannot be read, is not what its name says, or has no face.
pub fn load(path: &Path) -> Result<Mesh, LoadError> {
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or_default();
    let is_stl = match extension.to_ascii_lowercase().as_str() {
        "obj" => false,
        "stl" => true,
        _ => return Err(LoadError::Format { path: path.into() }),
    };
    let bytes = store::read(path)?;
    let mesh = if is_stl && stl::is_binary(&bytes) {
        stl::parse_binary(&bytes).map_err(|wrong| LoadError::Binary {
            path: path.into(),
            wrong,
        })
    } else {
        let parse = if is_stl { stl::parse } else { obj::parse };
        parse(&String::from_utf8_lossy(&bytes)).map_err(|wrong| LoadError::Text {
            path: path.into(),
            wrong,
        })
    }?;
    if mesh.triangles().is_empty() {
        return Err(LoadError::Empty { path: path.into() });
    }
    Ok(mesh)
}
