//! Compiling a stranger's C++ in the sandbox: `#include` reads the hand-in and the system's files, and nothing else.

use super::Sandbox;
use crate::converse::Program;
use crate::student::StudentError;
use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, Stdio};

/// Compilers, in the order in which they are looked for.
const COMPILERS: [&str; 2] = ["/usr/bin/g++", "/usr/bin/clang++"];

/// The language, and as much speed as costs little time.
const OPTIONS: [&str; 4] = ["-std=c++17", "-O1", "-pthread", "-I."];

impl Sandbox {
    /// Compiles these files of a folder to the program `output`, in a folder of its own; and what the compiler has to say.
    pub fn compile_cpp(
        &self,
        folder: &Path,
        files: &[String],
        output: &Path,
    ) -> (Result<Program, StudentError>, String) {
        let mut said = String::new();
        let built = self.compile(folder, files, output, &mut said);
        (built, said)
    }

    fn compile(
        &self,
        folder: &Path,
        files: &[String],
        output: &Path,
        said: &mut String,
    ) -> Result<Program, StudentError> {
        let missing = || {
            StudentError::NoCargo(std::io::Error::other(
                "there is neither g++ nor clang++, which compile C++",
            ))
        };
        let compiler = COMPILERS
            .iter()
            .find(|compiler| Path::new(compiler).exists())
            .ok_or_else(missing)?;
        let none = || StudentError::NoProgram {
            folder: folder.to_owned(),
            program: "of C++".to_owned(),
        };
        let target = output.parent().ok_or_else(none)?.to_owned();
        let mut command = Command::new(compiler);
        command
            .args(OPTIONS)
            .arg("-o")
            .arg(output)
            .args(files.iter().map(|file| format!("./{file}"))) // a name may begin like an option
            .current_dir(folder)
            .env("TMPDIR", &target)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        let sandbox = self.compiler();
        sandbox
            .enclose_compiler(
                &mut command,
                OsStr::new("/usr/bin:/bin"),
                [folder.to_owned()],
                &[&target],
            )
            .map_err(StudentError::NoCargo)?;
        let built;
        (built, *said) = sandbox.finish(command).map_err(StudentError::NoCargo)?;
        if !built {
            return Err(StudentError::DoesNotCompile);
        }
        if !output.symlink_metadata().is_ok_and(|kind| kind.is_file()) {
            return Err(none());
        }
        Ok(Program {
            file: output.to_owned(),
            arguments: Vec::new(),
            folder: folder.to_owned(),
            sandbox: Some(self.clone()),
        })
    }
}
