//! A hand-in that is packed as `.tar.gz`.

use super::Basket;
use flate2::read::MultiGzDecoder;
use std::io::{self, Read};
use tar::EntryType;

/// Takes the files in it.
pub fn collect(packed: impl Read, basket: &mut Basket) -> io::Result<()> {
    let most = basket.most_packed();
    let unpacked = MultiGzDecoder::new(packed).take(most);
    let mut archive = tar::Archive::new(unpacked);
    let result = each(&mut archive, basket);
    if archive.into_inner().limit() == 0 {
        return basket.refuse(format!("unpacked, it has more than {most} bytes"));
    }
    match result {
        Err(error) if basket.refused.is_none() => basket.refuse(format!(
            "it is no .tar.gz that can be read: {}",
            super::shown(error.to_string().as_bytes())
        )),
        result => result,
    }
}

fn each(archive: &mut tar::Archive<impl Read>, basket: &mut Basket) -> io::Result<()> {
    for entry in archive.entries()? {
        let entry = entry?;
        let name = entry.path_bytes().into_owned();
        match entry.header().entry_type() {
            EntryType::Regular | EntryType::Continuous | EntryType::GNUSparse => {
                if let Some(name) = basket.wants(&name)? {
                    basket.put(name, entry)?;
                }
            }
            EntryType::Directory => {
                basket.wants(&name)?;
            }
            EntryType::Symlink | EntryType::Link => basket.leave_out(&name, "a link"),
            EntryType::Char | EntryType::Block | EntryType::Fifo => {
                basket.leave_out(&name, "a device or a pipe");
            }
            _ => {}
        }
    }
    Ok(())
}
