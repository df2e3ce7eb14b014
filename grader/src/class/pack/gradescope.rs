//! An autograder for Gradescope: a zip that its container unpacks to `/autograder/source`
//! (<https://gradescope-autograders.readthedocs.io/en/latest/specs/>).

use flate2::Compression;
use flate2::write::DeflateEncoder;
use rawzip::{CompressionMethod, ZipArchiveWriter};
use std::io::{self, Write};

/// The bytes of the zip: the command, the course file, the course key, and the two scripts that Gradescope calls.
///
/// # Errors
/// Those of packing, which does not happen in memory.
pub fn autograder(raybook: &[u8], course: &[u8], key: &[u8]) -> io::Result<Vec<u8>> {
    const PROGRAM: u32 = 0o755;
    const SECRET: u32 = 0o600;
    let mut packed = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut packed);
    for (name, rights, bytes) in [
        (
            "setup.sh",
            PROGRAM,
            &include_bytes!("gradescope/setup.sh")[..],
        ),
        (
            "run_autograder",
            PROGRAM,
            include_bytes!("gradescope/run_autograder"),
        ),
        ("raybook", PROGRAM, raybook),
        ("course.toml", SECRET, course),
        ("course.key", SECRET, key),
    ] {
        let file = archive.new_file(name).unix_permissions(rights);
        let deflated = file.compression_method(CompressionMethod::DEFLATE);
        let (mut entry, config) = deflated.start().map_err(io::Error::other)?;
        let mut writer = config.wrap(DeflateEncoder::new(&mut entry, Compression::default()));
        writer.write_all(bytes)?;
        let (encoder, descriptor) = writer.finish().map_err(io::Error::other)?;
        encoder.finish()?;
        entry.finish(descriptor).map_err(io::Error::other)?;
    }
    archive.finish().map_err(io::Error::other)?;
    Ok(packed)
}
