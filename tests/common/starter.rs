//! Making and building student's folders.

use raybook::grade::converse::Program;
use raybook::grade::starter::files;
use raybook::workbook::anchor::Anchored;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Writes a starter whose anchored functions are rewritten so.
pub fn write(folder: &Path, rewrite: &dyn Fn(&Anchored<'_>) -> Option<String>) {
    for (path, bytes) in files(rewrite).expect("the library's anchors are right") {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().expect("a file is in a folder"))
            .expect("the folder can be made");
        fs::write(path, bytes).expect("the file can be written");
    }
}

/// The folder in which all starters of the tests compile: their dependencies are compiled once.
pub fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("starter")
}

/// Builds one of the folder's programs, and keeps it apart from the next folder's.
pub fn build(folder: &Path, binary: &str) -> Program {
    let output = Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--offline", "--bin", binary])
        .current_dir(folder)
        .env("CARGO_TARGET_DIR", target())
        .output()
        .expect("cargo can be run");
    assert!(
        output.status.success(),
        "the starter compiles: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(
        output.stderr.is_empty(),
        "without a warning: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    let (built, kept) = (target().join("debug").join(binary), folder.join(binary));
    fs::copy(built, &kept).expect("the program can be kept");
    Program {
        file: kept,
        arguments: Vec::new(),
        folder: PathBuf::new(),
    }
}
