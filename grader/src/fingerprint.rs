//! Fingerprints: what is equal has the same one, and what is not has another.

use sha2::{Digest, Sha256};
use std::fmt::Write;

/// The first `digits` hexadecimal digits of the SHA-256 of several parts: the length of each before it, so that "ab", "c" and "a", "bc"
/// differ.
pub fn of<'a>(parts: impl IntoIterator<Item = &'a [u8]>, digits: usize) -> String {
    let mut hash = Sha256::new();
    for part in parts {
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    let mut text = hex(&hash.finalize());
    text.truncate(digits);
    text
}

/// Bytes as hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
