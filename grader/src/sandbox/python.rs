//! The Python that the grader's user has: it may lie anywhere, and what is found on the path may be a script that looks for it.

use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// A Python outside of the system's folders.
#[derive(Debug)]
pub struct Python {
    /// The program.
    pub executable: PathBuf,
    /// The folder of the program.
    pub programs: PathBuf,
    /// What it reads.
    pub read: Vec<PathBuf>,
}

/// Asked with `-I`, so that neither the present folder nor the user's settings have a say.
const ASK: &str = "import sys
print(sys.executable)
print(sys.prefix)
print(sys.base_prefix)
print(sys.exec_prefix)";

/// Finds it once, by asking it.
pub fn find() -> Option<&'static Python> {
    static FOUND: OnceLock<Option<Python>> = OnceLock::new();
    FOUND.get_or_init(ask).as_ref()
}

fn ask() -> Option<Python> {
    let told = Command::new("python3")
        .args(["-I", "-c", ASK])
        .current_dir("/") // a hand-in's folder may name another version
        .stdin(Stdio::null())
        .stderr(Stdio::null())
        .output()
        .ok()?;
    let told = String::from_utf8(told.stdout).ok()?;
    let mut lines = told
        .lines()
        .map(PathBuf::from)
        .filter(|path| path.is_absolute());
    let executable = lines.next()?;
    let programs = executable.parent()?.to_owned();
    let of_prefix =
        |prefix: PathBuf| ["bin", "lib", "lib64", "pyvenv.cfg"].map(|part| prefix.join(part));
    let mut read: Vec<_> = lines.flat_map(of_prefix).collect();
    read.push(executable.clone());
    Some(Python {
        executable,
        programs,
        read,
    })
}
