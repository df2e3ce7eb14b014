//! Programs that tests make.
//!
//! Another process copies them: a file that this one has open for writing is open in every process that another thread starts at
//! that moment, and what is open for writing cannot be run ("Text file busy").

use std::fs;
use std::path::Path;
use std::process::Command;

/// Copies a file to another place, where it can be run.
pub fn copy(from: &Path, to: &Path) {
    let copied = Command::new("install")
        .args(["-m", "755"])
        .args([from, to])
        .status();
    assert!(
        copied.is_ok_and(|status| status.success()),
        "{} is copied to {}",
        from.display(),
        to.display()
    );
}

/// Writes a script that can be run.
pub fn script(path: &Path, text: &str) {
    let written = path.with_extension("text");
    fs::write(&written, text).expect("the script can be written");
    copy(&written, path);
}
