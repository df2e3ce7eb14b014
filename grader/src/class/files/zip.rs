//! A hand-in that is packed as `.zip`.

use super::Basket;
use flate2::bufread::DeflateDecoder;
use rawzip::{CompressionMethod, ZipArchive, ZipSliceArchive};
use std::io::{self, Read};

/// Takes the files in it.
pub fn collect(mut packed: impl Read, basket: &mut Basket) -> io::Result<()> {
    let mut bytes = Vec::new();
    packed.read_to_end(&mut bytes)?;
    let archive = match ZipArchive::from_slice(&bytes) {
        Ok(archive) => archive,
        Err(error) => return basket.refuse(format!("it is no .zip that can be read: {error}")),
    };
    match each(&archive, basket) {
        Err(error) if basket.refused.is_none() => basket.refuse(format!("it is damaged: {error}")),
        result => result,
    }
}

fn each(archive: &ZipSliceArchive<&Vec<u8>>, basket: &mut Basket) -> io::Result<()> {
    let damaged = io::Error::other::<rawzip::Error>;
    let mut entries = archive.entries();
    while let Some(entry) = entries.next_entry().map_err(damaged)? {
        let raw = entry.file_path();
        let name = raw.as_bytes();
        if entry.mode().is_symlink() {
            basket.leave_out(name, "a link");
            continue;
        }
        let Some(path) = basket.wants(name)? else {
            continue;
        };
        if entry.is_dir() {
            continue;
        }
        if entry.flags().is_encrypted() {
            return basket.refuse(format!("{} is encrypted", super::shown(name)));
        }
        let local = archive.get_entry(entry.wayfinder()).map_err(damaged)?;
        match entry.compression_method() {
            CompressionMethod::STORE => basket.put(path, local.verifying_reader(local.data()))?,
            CompressionMethod::DEFLATE => {
                let unpacked = DeflateDecoder::new(local.data());
                basket.put(path, local.verifying_reader(unpacked))?;
            }
            _ => {
                let name = super::shown(name);
                return basket.refuse(format!(
                    "{name} is packed by a method that is not known here"
                ));
            }
        }
    }
    Ok(())
}
