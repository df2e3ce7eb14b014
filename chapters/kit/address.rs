//! Addresses that a browser follows.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use std::fmt::Write;
use std::path::Path;

/// The address of a file with an absolute path.
pub fn of_file(path: &Path) -> String {
    let bytes = path.as_os_str().as_encoded_bytes();
    let parts = bytes.split(|byte| *byte == b'/' || cfg!(windows) && *byte == b'\\');
    let parts: Vec<_> = parts.map(encoded).collect();
    let path = parts.join("/");
    let root = if path.starts_with('/') { "" } else { "/" }; // a drive of Windows
    format!(
        "file://{root}{}",
        path.replacen("%3A", ":", usize::from(cfg!(windows)))
    )
}

/// Text as one part of an address: every byte that has a meaning there, or is no ASCII, as `%` and two digits.
pub fn encoded(text: impl AsRef<[u8]>) -> String {
    let mut address = String::new();
    for byte in text.as_ref() {
        if byte.is_ascii_alphanumeric() || b"-_.".contains(byte) {
            address.push(char::from(*byte));
        } else {
            // Text takes everything.
            let _ = write!(address, "%{byte:02X}");
        }
    }
    address
}

/// The address of a file that stands in the address itself (RFC 2397), for a page that needs no other file.
pub fn of_bytes(kind: &str, bytes: &[u8]) -> String {
    format!("data:{kind};base64,{}", BASE64_STANDARD.encode(bytes))
}
