//! Compiling a stranger's C++ in the sandbox: `#include` reads the hand-in and the system's files, and nothing else.

use super::{Ready, Sandbox};
use crate::converse::Program;
use crate::student::StudentError;
use std::ffi::OsStr;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

/// Compilers, in the order in which they are looked for.
const COMPILERS: [&str; 2] = ["/usr/bin/g++", "/usr/bin/clang++"];

/// The language, and as much speed as costs little time.
const OPTIONS: [&str; 4] = ["-std=c++17", "-O1", "-pthread", "-I."];

impl Sandbox {
    /// Compiles these files of a folder, with what there is already, to the program `output`, in a folder of its own; and what the
    /// compiler has to say.
    pub fn compile_cpp(
        &self,
        folder: &Path,
        files: &[String],
        ready: &Ready,
        output: &Path,
    ) -> (Result<Program, StudentError>, String) {
        let none = || StudentError::NoProgram {
            folder: folder.to_owned(),
            program: "of C++".to_owned(),
        };
        let Some(target) = output.parent() else {
            return (Err(none()), String::new());
        };
        let linked = ["-o".as_ref(), output.as_os_str()].into_iter();
        let included = ready.header.iter();
        let included = included.flat_map(|path| ["-include".as_ref(), path.as_os_str()]);
        let objects = ready.objects.iter().map(|path| path.as_os_str());
        let words = linked.chain(included).chain(objects);
        let paths = ready.objects.iter().chain(&ready.header);
        let readable = paths.filter_map(|path| path.parent());
        let (built, said) = self.compile(folder, files, words, readable, target);
        let built = built.and_then(|()| {
            if !output.symlink_metadata().is_ok_and(|kind| kind.is_file()) {
                return Err(none());
            }
            Ok(Program {
                file: output.to_owned(),
                arguments: Vec::new(),
                folder: folder.to_owned(),
                sandbox: Some(self.clone()),
            })
        });
        (built, said)
    }

    /// Compiles these files of a folder to objects of the same names at its top; and what the compiler has to say.
    pub fn compile_objects(
        &self,
        folder: &Path,
        files: &[String],
    ) -> (Result<(), StudentError>, String) {
        self.compile(
            folder,
            files,
            ["-c".as_ref()].into_iter(),
            [].into_iter(),
            folder,
        )
    }

    /// Compiles a header of a folder once for all files that include it first; and what the compiler has to say.
    pub fn precompile(&self, folder: &Path, header: &str) -> (Result<(), StudentError>, String) {
        let words = ["-x".as_ref(), "c++-header".as_ref(), "-c".as_ref()];
        self.compile(
            folder,
            &[header.to_owned()],
            words.into_iter(),
            [].into_iter(),
            folder,
        )
    }

    /// Runs a compiler with these words beside its options; it reads the folder and what is readable, and writes into its target.
    fn compile<'a>(
        &self,
        folder: &'a Path,
        files: &[String],
        words: impl Iterator<Item = &'a OsStr>,
        readable: impl Iterator<Item = &'a Path>,
        target: &Path,
    ) -> (Result<(), StudentError>, String) {
        let there = COMPILERS
            .iter()
            .find(|compiler| Path::new(compiler).exists());
        let Some(compiler) = there else {
            let missing = StudentError::NoBuilder {
                command: "g++".to_owned(),
                reason: io::Error::other("there is neither g++ nor clang++"),
            };
            return (Err(missing), String::new());
        };
        let mut command = Command::new(compiler);
        command
            .args(OPTIONS)
            .args(words)
            .args(files.iter().map(|file| format!("./{file}"))) // a name may begin like an option
            .current_dir(folder)
            .env("TMPDIR", target)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        let sandbox = self.compiler();
        let readable = readable.chain([folder]).map(Path::to_path_buf);
        let path = OsStr::new("/usr/bin:/bin");
        let ended = sandbox
            .enclose_compiler(&mut command, path, readable, &[&target.to_owned()])
            .and_then(|()| sandbox.finish(command, &[target]));
        match ended {
            Ok((true, said)) => (Ok(()), said),
            Ok((false, said)) => (Err(StudentError::DoesNotCompile), said),
            Err(error) => (
                Err(StudentError::of("run the compiler")(error)),
                String::new(),
            ),
        }
    }
}
