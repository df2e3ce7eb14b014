//! Picture files: OpenEXR and Radiance HDR keep the radiance, PNG keeps what a display shows.
//!
//! ```
//! use raybook::prelude::*;
//! use std::path::Path;
//!
//! assert!(file::expect_name(Path::new("picture.exr")).is_ok());
//! assert!(file::expect_name(Path::new("picture.bmp")).is_err()); // refused before anything is rendered
//! ```

use crate::image::{Image, codec};
use crate::store::{self, StoreError};
use std::io;
use std::path::{Path, PathBuf};

/// Why a picture could not be read or written; every kind names the file.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The system refused, or the path is not that of a file.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The name does not end in .exr, .hdr or .png.
    #[error("{}: a picture's name must end in .exr, .hdr or .png", path.display())]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// The picture to be written has no pixels.
    #[error("{}: a picture of {width} × {height} pixels cannot be written: it needs at least one pixel", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
        /// Columns of the picture.
        width: usize,
        /// Rows of the picture.
        height: usize,
    },
    /// The content is not what the name promises.
    #[error("{}: cannot be read as {format}: {reason}", path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// The format that its name promises.
        format: &'static str,
        /// What the decoder found.
        reason: String,
    },
}

#[derive(Clone, Copy)]
enum Format {
    Exr,
    Hdr,
    Png,
}

/// Checks that a picture can be written under this name: to be called before the rendering, not after.
///
/// # Errors
/// If the name does not end in .exr, .hdr or .png.
pub fn expect_name(path: &Path) -> Result<(), FileError> {
    format_of(path).map(|_| ())
}

/// Writes a picture in the format that the end of its name tells.
///
/// `.exr` keeps each `f32` as it is, bit for bit. `.hdr` keeps 8 bits per channel with one exponent for all three, so that
/// each channel is right to 1/128 of the largest. `.png` keeps 8 bits of the sRGB code and clamps to [0, 1].
/// The folder is made if it does not exist, and the file appears whole or not at all.
///
/// # Errors
/// If the name has another end, the picture has no pixels, or the file cannot be written.
pub fn save(path: &Path, picture: &Image) -> Result<(), FileError> {
    let format = format_of(path)?;
    if picture.pixels().is_empty() {
        return Err(FileError::Empty {
            path: path.into(),
            width: picture.width(),
            height: picture.height(),
        });
    }
    let bytes = match format {
        Format::Exr => codec::encode_exr(picture),
        Format::Hdr => codec::encode_hdr(picture),
        Format::Png => codec::encode_png(picture),
    };
    let failed = StoreError::of(path, "write this file");
    let bytes = bytes.map_err(|reason| failed(io::Error::other(reason)))?;
    Ok(store::write(path, &bytes)?)
}

/// The bytes of a PNG file, for a page that contains its pictures.
///
/// # Errors
/// If the picture has no pixels.
///
/// ```
/// use raybook::image::{Image, file, rgb::Rgb};
///
/// let picture = Image::from_fn(2, 1, |_, _| Rgb::WHITE);
/// assert!(file::to_png(&picture).is_ok_and(|bytes| bytes.starts_with(b"\x89PNG")));
/// ```
pub fn to_png(picture: &Image) -> io::Result<Vec<u8>> {
    if picture.pixels().is_empty() {
        return Err(io::Error::other("a picture needs at least one pixel"));
    }
    codec::encode_png(picture).map_err(io::Error::other)
}

/// The picture of a PNG file's bytes, for a program that contains its pictures; the code values are decoded from sRGB.
///
/// # Errors
/// As for [`load`], in words.
///
/// ```
/// use raybook::image::{Image, file, rgb::Rgb};
///
/// let picture = Image::from_fn(2, 1, |_, _| Rgb::WHITE);
/// let bytes = file::to_png(&picture)?;
/// assert_eq!(file::from_png(&bytes).expect("a PNG file").at(1, 0), Rgb::WHITE);
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn from_png(bytes: &[u8]) -> Result<Image, String> {
    codec::decode_png(bytes)
}

/// Reads a picture of linear radiance; a PNG's code values are decoded from sRGB.
///
/// # Errors
/// If the name does not end in .exr, .hdr or .png, the file cannot be read, its content is of another format, it has no pixels,
/// or decoding it would take more memory than the [budget](crate::memory::BUDGET), which its header tells.
pub fn load(path: &Path) -> Result<Image, FileError> {
    let format = format_of(path)?;
    let bytes = store::read(path)?;
    let (name, decoded) = match format {
        Format::Exr => ("OpenEXR", codec::decode_exr(&bytes)),
        Format::Hdr => ("Radiance HDR", codec::decode_hdr(&bytes)),
        Format::Png => ("PNG", codec::decode_png(&bytes)),
    };
    let some = |picture: Image| match picture.pixels() {
        [] => Err("it has no pixels".to_owned()),
        _ => Ok(picture),
    };
    decoded.and_then(some).map_err(|reason| FileError::Content {
        path: path.into(),
        format: name,
        reason,
    })
}

fn format_of(path: &Path) -> Result<Format, FileError> {
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or_default()
        .to_ascii_lowercase();
    match extension.as_str() {
        "exr" => Ok(Format::Exr),
        "hdr" => Ok(Format::Hdr),
        "png" => Ok(Format::Png),
        _ => Err(FileError::Format { path: path.into() }),
    }
}
