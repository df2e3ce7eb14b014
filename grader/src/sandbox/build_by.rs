//! Building a stranger's workbook by the command that its `raybook.toml` names, in the sandbox.

use super::Sandbox;
use crate::student::StudentError;
use raybook_chapters::kit::say::complain;
use raybook_chapters::kit::untrusted::Untrusted;
use std::env;
use std::ffi::OsString;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

/// The only folder of the workbook that the command writes into.
const BUILD: &str = "build";

impl Sandbox {
    /// Runs the command in the workbook. It reads the workbook and the system's files, and writes into the workbook's folder
    /// `build`. Nothing of it goes on afterwards. What it has to say goes to standard error.
    ///
    /// # Errors
    /// If the command is missing, or does not succeed, or `build` is no folder.
    pub fn build_by(&self, workbook: &Path, words: &[String]) -> Result<(), StudentError> {
        let cannot = |reason: io::Error| StudentError::NoBuilder {
            command: words.join(" "),
            reason,
        };
        let of_folder = StudentError::of("make the workbook's folder `build`");
        let build = workbook.join(BUILD);
        // A link would open what it leads to for writing.
        match build.symlink_metadata() {
            Ok(kind) if kind.is_dir() => {}
            Ok(_) => return Err(of_folder(io::Error::other("there is something else"))),
            Err(_) => std::fs::create_dir(&build).map_err(of_folder)?,
        }
        let (first, rest) = words
            .split_first()
            .ok_or_else(|| cannot(io::Error::other("there is no command")))?;
        let mut command = Command::new(first);
        command
            .args(rest)
            .current_dir(workbook)
            .env("TMPDIR", &build)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        let path = env::var_os("PATH").unwrap_or_else(|| OsString::from("/usr/bin:/bin"));
        let compiler = self.compiler();
        compiler
            .enclose_compiler(&mut command, &path, [workbook.to_owned()], &[&build])
            .map_err(StudentError::of("enclose the command that builds"))?;
        let (built, said) = compiler.finish(command, &[&build]).map_err(cannot)?;
        for line in said.lines() {
            complain(Untrusted::from(line));
        }
        if built {
            Ok(())
        } else {
            Err(StudentError::DoesNotCompile)
        }
    }
}
