//! An autograder for Gradescope: a zip that its container unpacks to `/autograder/source`
//! (<https://gradescope-autograders.readthedocs.io/en/latest/specs/>).

use super::beside::Beside;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use rawzip::time::UtcDateTime;
use rawzip::{CompressionMethod, ZipArchiveWriter};
use std::io::{self, Write};

/// The bytes of the zip: the command, the course file with what lies beside it, the course key, and the two scripts that Gradescope
/// calls.
///
/// # Errors
/// If a name is not UTF-8; and those of packing, which does not happen in memory.
pub fn autograder(
    raybook: &[u8],
    course: &[u8],
    beside: &[Beside],
    key: &[u8],
) -> io::Result<Vec<u8>> {
    const PROGRAM: u32 = 0o755;
    const SECRET: u32 = 0o600;
    // 1980-01-01, the first day that a zip can tell: the same course makes the same bytes. Without a time, rawzip writes day 0.
    let day = UtcDateTime::from_unix(315_532_800);
    let mut packed = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut packed);
    let own = beside.iter().map(|file| {
        let name = file.path.to_str();
        let name = name.ok_or_else(|| io::Error::other("a name that is not UTF-8"));
        let rights = if file.runs { 0o700 } else { SECRET };
        Ok((name?, rights, &file.bytes[..]))
    });
    let own = own.collect::<io::Result<Vec<_>>>()?;
    let files = [
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
    ];
    for (name, rights, bytes) in files.into_iter().chain(own) {
        let file = archive.new_file(name).unix_permissions(rights);
        let deflated = file
            .last_modified(day)
            .compression_method(CompressionMethod::DEFLATE);
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
