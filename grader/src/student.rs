//! A student's folder, and the answer program that is built from it.

use crate::cases;
use crate::contain;
use crate::converse::Program;
use crate::examine::Examiner;
use crate::language::Language;
use crate::recipe::{Commands, Recipe};
use crate::sandbox::Sandbox;
use crate::starter::{self, MARKER};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_scenes::wrong::TextError;
use serde_json::Value;
use std::io::{self, ErrorKind};
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

/// Why there is no answer program.
#[derive(Debug, thiserror::Error)]
pub enum StudentError {
    /// Not a student's folder.
    #[error("{}: this is not a workbook: neither here nor above is there a {MARKER}; `raybook new my-rays` makes one", Untrusted::from(.0.as_path()))]
    NoWorkbook(PathBuf),
    /// Its `raybook.toml` is wrong.
    #[error(transparent)]
    Recipe(#[from] TextError),
    /// The command that builds it is not there.
    #[error("cannot run `{}`, which builds your program: {reason}; is it installed?", Untrusted::from(command.as_str()))]
    NoBuilder {
        /// The command.
        command: String,
        /// What the system says.
        reason: io::Error,
    },
    /// Cargo is not there.
    #[error(
        "cannot run cargo, which builds your program: {0}; is Rust installed (https://rustup.rs)?"
    )]
    NoCargo(io::Error),
    /// Something else of the system.
    #[error("cannot {doing}: {reason}")]
    System {
        /// "make the folder `target`" or the like.
        doing: &'static str,
        /// What the system says.
        reason: io::Error,
    },
    /// The compiler refused.
    #[error("your program does not compile; the compiler's message is above")]
    DoesNotCompile,
    /// It does not compile, and a file in which an exercise is written is not there.
    #[error("your program does not compile: {}", gone(.0))]
    Gone(String),
    /// Cargo built something else.
    #[error("{}: cargo built no program `{program}` here; is everything in workbook/ still there?", Untrusted::from(folder.as_path()))]
    NoProgram {
        /// Where it was to be built.
        folder: PathBuf,
        /// Its name.
        program: String,
    },
}

impl StudentError {
    /// The error of doing something, from the reason.
    pub(crate) fn of(doing: &'static str) -> impl FnOnce(io::Error) -> Self {
        move |reason| Self::System { doing, reason }
    }

    /// The error of running cargo, from the reason.
    pub(crate) fn of_cargo(reason: io::Error) -> Self {
        match reason.kind() {
            ErrorKind::NotFound => Self::NoCargo(reason),
            _ => Self::of("run cargo")(reason),
        }
    }
}

/// The student's folder: this one, or the nearest above it that is a workbook.
///
/// # Errors
/// If there is none.
pub fn workbook(from: &Path) -> Result<PathBuf, StudentError> {
    let absolute = std::path::absolute(from).unwrap_or_else(|_| from.to_owned());
    let found = absolute
        .ancestors()
        .find(|folder| folder.join(MARKER).is_file());
    found
        .map(Path::to_owned)
        .ok_or(StudentError::NoWorkbook(absolute))
}

/// Builds the answer program, by the folder's `raybook.toml`. What the compiler has to say goes to standard error.
///
/// # Errors
/// If `raybook.toml` is wrong, the compiler is missing, or the program does not compile.
pub fn build(folder: &Path) -> Result<Program, StudentError> {
    build_it(folder).map_err(|error| match (error, first_gone(folder)) {
        (StudentError::DoesNotCompile, Some(file)) => StudentError::Gone(file),
        (error, _) => error,
    })
}

fn build_it(folder: &Path) -> Result<Program, StudentError> {
    match Recipe::read(folder)? {
        Recipe::Rust => build_binary(&mut Command::new("cargo"), folder, "answer", &[]),
        Recipe::Commands(commands) => {
            if let Some(words) = &commands.build {
                build_by(words, folder)?;
            }
            Ok(program(&commands, folder))
        }
    }
}

/// Builds a stranger's answer program in a sandbox, in which it also runs.
///
/// # Errors
/// As [`build`].
pub fn build_in(sandbox: &Sandbox, folder: &Path) -> Result<Program, StudentError> {
    match Recipe::read(folder)? {
        Recipe::Rust => sandbox.build(folder),
        Recipe::Commands(commands) => {
            if let Some(words) = &commands.build {
                sandbox.build_by(folder, words)?;
            }
            Ok(Program {
                sandbox: Some(sandbox.clone()),
                ..program(&commands, folder)
            })
        }
    }
}

/// The program that answers, by the commands of a folder: a program with a slash in its name is the folder's.
pub fn program(commands: &Commands, folder: &Path) -> Program {
    let mut words = commands.run.iter();
    let first = words.next().map(String::as_str).unwrap_or_default();
    Program {
        file: if first.contains('/') {
            folder.join(first)
        } else {
            first.into()
        },
        arguments: words.map(Into::into).collect(),
        folder: folder.to_owned(),
        sandbox: None,
    }
}

/// The file in which an exercise is written in this workbook, if its language has a starter.
pub fn place(folder: &Path, exercise: &str) -> Option<String> {
    starter::place(language(folder)?, exercise)
}

/// What to do about a file of a workbook that is not there.
pub fn gone(file: &str) -> String {
    format!("{file} is gone: bring it back, or copy it from a folder that `raybook new` makes")
}

/// The first file in which an exercise is written that is not there.
fn first_gone(folder: &Path) -> Option<String> {
    let language = language(folder)?;
    let names = cases::all().into_iter().map(<dyn Examiner>::name);
    let mut places = names.filter_map(|name| starter::place(language, name));
    places.find(|file| !folder.join(file).is_file())
}

/// The language of this workbook, if it has a starter.
pub fn language(folder: &Path) -> Option<Language> {
    Language::find(Recipe::read(folder).ok()?.language())
}

/// A build that takes longer is ended.
const LONGEST: Duration = Duration::from_secs(600);

/// Runs the command that builds a folder's program. Nothing of it goes on when it, or this command, ends.
fn build_by(words: &[String], folder: &Path) -> Result<(), StudentError> {
    let [first, rest @ ..] = words else {
        return Ok(());
    };
    let mut command = Command::new(first);
    command
        .args(rest)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(io::stderr()); // standard output may be JSON
    let held = contain::start(&mut command, None).map_err(|reason| StudentError::NoBuilder {
        command: words.join(" "),
        reason,
    })?;
    match held.end(true, LONGEST) {
        Some(status) if status.success() => Ok(()),
        _ => Err(StudentError::DoesNotCompile),
    }
}

/// Builds one of the folder's programs with this cargo and these further options.
///
/// # Errors
/// If cargo is missing, or the program does not compile.
pub fn build_binary(
    cargo: &mut Command,
    folder: &Path,
    binary: &str,
    options: &[&str],
) -> Result<Program, StudentError> {
    cargo
        .args(["build", "--message-format=json-render-diagnostics", "--bin"])
        .arg(binary)
        .args(options)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped());
    let mut held = contain::start(cargo, None).map_err(StudentError::of_cargo)?;
    let output = held.child.stdout.take();
    // It is read beside: a cargo that waits for ever, and says nothing, is ended too.
    let reader = thread::spawn(move || output.map_or(Ok(String::new()), io::read_to_string));
    let status = held.end(true, LONGEST);
    if !status.is_some_and(|status| status.success()) {
        return Err(StudentError::DoesNotCompile);
    }
    let messages = reader.join().unwrap_or_else(|panic| resume_unwind(panic));
    let messages = messages.map_err(StudentError::of("read what cargo says"))?;
    let executable = |line: &str| {
        let message: Value = serde_json::from_str(line).ok()?;
        let is_asked_for = message["target"]["name"] == binary;
        message["executable"]
            .as_str()
            .filter(|_| is_asked_for)
            .map(PathBuf::from)
    };
    let file = messages.lines().find_map(executable);
    let file = file.ok_or_else(|| StudentError::NoProgram {
        folder: folder.to_owned(),
        program: binary.to_owned(),
    })?;
    Ok(Program {
        file,
        arguments: Vec::new(),
        folder: folder.to_owned(),
        sandbox: None,
    })
}
