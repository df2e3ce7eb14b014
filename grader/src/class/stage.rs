//! A hand-in made ready to be asked: its sources in a folder of its own, built in the sandbox.

use super::files::Files;
use super::prebuilt::Prebuilt;
use super::programs::programs;
use super::record::Standing;
use super::shortage::Shortage;
use crate::converse::Program;
use crate::examine::Examiner;
use crate::language::Language;
use crate::mutex::lock;
use crate::sandbox::{ANSWER, Ready, Sandbox};
use crate::starter;
use crate::student::StudentError;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// A program of a hand-in, or how its exercises stand without one, and why; and the exercises that it is asked.
pub type Staged = (
    Result<Program, (Standing, String)>,
    Vec<&'static dyn Examiner>,
);

/// Something that says nothing about the hand-in.
pub type Trouble = String;

/// Runs the file of its third argument as Python itself would, with modules from its first two. `-I` keeps everything else out, and
/// these too; the module `runpy` would take longer than the start of Python.
const PYTHON: &str = "import sys; sys.path[:0] = sys.argv[1:3]; del sys.argv[:3]; __file__ = sys.argv[0]; del sys; exec(compile(open(__file__, 'rb').read(), __file__, 'exec'))";

/// Settings of cargo that a workbook of a hand-in is built with: little processor time, and nothing that only a debugger needs.
const CARGO: &str = "[profile.dev]\nopt-level = 0\ndebug = false\nincremental = false\ncodegen-units = 1\n\n[net]\noffline = true\n";

/// Where hand-ins are made ready.
pub struct Stage {
    /// The folder of the whole run, which nobody else uses.
    folder: PathBuf,
    /// The sandbox that they are built and run in.
    sandbox: Sandbox,
    /// Whether the packages that workbooks use are compiled; one is tried at a time.
    warm: Mutex<bool>,
    /// What is the same in all hand-ins in C++.
    prebuilt: Prebuilt,
    /// What the system was short of in this run.
    shortage: Shortage,
}

/// The folder, in that of the results, in which hand-ins are built.
const STAGE: &str = "stage";

impl Stage {
    /// An empty one in the folder of the results.
    ///
    /// # Errors
    /// If what an earlier run left of it cannot be removed.
    pub fn new(results: &Path, sandbox: Sandbox) -> io::Result<Self> {
        let folder = results.canonicalize()?.join(STAGE);
        remove(&folder)?;
        Ok(Self {
            prebuilt: Prebuilt::new(folder.join("starter-cpp")),
            shortage: Shortage::from_now_on(results),
            folder,
            sandbox,
            warm: Mutex::new(false),
        })
    }

    /// Removes a hand-in that has been asked.
    ///
    /// # Errors
    /// If something cannot be removed.
    pub fn strike(&self, name: &str) -> io::Result<()> {
        remove(&self.folder.join(name))
    }

    /// Removes it: nothing of it stays.
    ///
    /// # Errors
    /// If something cannot be removed.
    pub fn clear(self) -> io::Result<()> {
        remove(&self.folder)
    }

    /// Makes a hand-in ready in a folder of this name.
    ///
    /// # Errors
    /// If the system fails: nothing is known about the hand-in then.
    pub fn make(
        &self,
        name: &str,
        language: Language,
        files: &Files,
        exercises: &[&'static dyn Examiner],
    ) -> Result<Vec<Staged>, Trouble> {
        let folder = self.folder.join(name);
        remove(&folder).map_err(told("be emptied", &folder))?;
        if language == Language::Rust {
            return self.rust(&folder, files, exercises);
        }
        write(
            &folder,
            files
                .iter()
                .map(|(path, bytes)| (Path::new(path), &bytes[..])),
        )
        .map_err(told("be filled", &folder))?;
        let mut staged = Vec::new();
        for (mut sources, exercises) in programs(language, files, exercises) {
            let program = match (language, sources.first()) {
                (_, None) => Err(nothing()),
                (Language::Python, Some(file)) => Ok(self.python(&folder, file)?),
                _ => {
                    let output = folder
                        .join("target")
                        .join(staged.len().to_string())
                        .join("answer");
                    let target = output.parent().unwrap_or(&folder);
                    fs::create_dir_all(target).map_err(told("be made", target))?;
                    let mut ready = self.prebuilt.ready(&self.sandbox, files, &mut sources)?;
                    let compile =
                        |ready: &Ready| self.sandbox.compile_cpp(&folder, &sources, ready, &output);
                    self.built(&folder, || {
                        let compiled = compile(&ready);
                        // What is included first must not be why it does not compile.
                        if compiled.0.is_err() && ready.header.take().is_some() {
                            return compile(&ready);
                        }
                        compiled
                    })?
                }
            };
            staged.push((program, exercises));
        }
        Ok(staged)
    }

    fn python(&self, folder: &Path, file: &str) -> Result<Program, Trouble> {
        let python =
            Sandbox::python().ok_or("there is no python3 here, which runs hand-ins in Python")?;
        let path = folder.join(file);
        let beside = path.parent().unwrap_or(folder);
        let options = ["-I", "-S", "-B", "-c", PYTHON].map(OsString::from);
        let arguments = [beside, folder, &path].map(OsString::from);
        Ok(Program {
            file: python,
            arguments: options.into_iter().chain(arguments).collect(),
            folder: folder.to_owned(),
            sandbox: Some(self.sandbox.clone()),
        })
    }

    /// The starter, in which the sources of the library are the hand-in's. Its manifests, its tables and its answer program are ours.
    /// An exercise of the instructor's own has a program of the hand-in's.
    fn rust(
        &self,
        folder: &Path,
        files: &Files,
        exercises: &[&'static dyn Examiner],
    ) -> Result<Vec<Staged>, Trouble> {
        if !files.contains_key("src/lib.rs") {
            let why = "there is no src/lib.rs in it: a hand-in in Rust is a whole workbook";
            let why = (Standing::NotBuilt, why.to_owned());
            return Ok(vec![(Err(why), exercises.to_vec())]);
        }
        self.warm_up()?;
        let of_own = |name: &str| format!("src/bin/{name}.rs");
        let (apart, course): (Vec<&'static dyn Examiner>, Vec<_>) = exercises
            .iter()
            .partition(|examiner| super::is_own(examiner.name()));
        let is_asked = |path: &String| apart.iter().any(|of| of_own(of.name()) == *path);
        let mut own: BTreeMap<&Path, &[u8]> = BTreeMap::new();
        let starter = starter::given(Language::Rust).map_err(ToString::to_string)?;
        let is_source =
            |path: &Path| path.starts_with("src") && path.extension().is_some_and(|e| e == "rs");
        let is_ours = |path: &String| {
            let mut ours = starter.iter().filter(|(ours, _)| !is_source(ours));
            ours.any(|(ours, _)| Path::new(path).starts_with(ours))
        };
        let is_kept = |path: &&String| {
            let is_program = path.starts_with("src/bin/");
            path.starts_with("src/") && (!is_program || is_asked(path)) && !is_ours(path)
        };
        for (path, bytes) in starter {
            if !is_source(path) {
                own.insert(path, bytes);
            }
        }
        own.insert(Path::new(".cargo/config.toml"), CARGO.as_bytes());
        for path in files.keys().filter(is_kept) {
            own.insert(Path::new(path), &files[path]);
        }
        write(folder, own.into_iter()).map_err(told("be filled", folder))?;
        copy_packages(&self.warm_folder().join("target"), &folder.join("target"))
            .map_err(told("be filled", folder))?;
        let build = |binary: &str| self.built(folder, || self.sandbox.build_told(folder, binary));
        let mut staged = Vec::new();
        if !course.is_empty() {
            staged.push((build(ANSWER)?, course));
        }
        for examiner in apart {
            let program = if files.contains_key(&of_own(examiner.name())) {
                build(examiner.name())?
            } else {
                Err(nothing())
            };
            staged.push((program, vec![examiner]));
        }
        Ok(staged)
    }

    /// The program that was compiled, or what the compiler said of the hand-in; what is no fault of the hand-in is trouble.
    fn built(
        &self,
        folder: &Path,
        mut compile: impl FnMut() -> (Result<Program, StudentError>, String),
    ) -> Result<Result<Program, (Standing, String)>, Trouble> {
        /// Words of a compiler that the system ended. A hand-in can have a compiler say them too.
        const ENDED: [&str; 3] = ["signal: 9", "Killed signal", "No space left on device"];
        let is_ended = |said: &str| ENDED.iter().any(|words| said.contains(words));
        let (mut built, mut said) = compile();
        if built.is_err() && is_ended(&said) && !self.shortage.is_there() {
            // Was the system short of something, and is not any more?
            (built, said) = compile();
        }
        let place = folder.display().to_string();
        let lines = said
            .lines()
            .filter(|line| !line.starts_with("   Compiling"));
        let said: String = lines
            .flat_map(|line| [line.replace(&place, PLACE), "\n".to_owned()])
            .collect();
        match built {
            Ok(program) => Ok(Ok(program)),
            Err(_) if is_ended(&said) && self.shortage.is_there() => {
                Err(format!("the compiler was ended: {said}"))
            }
            Err(StudentError::DoesNotCompile) => Ok(Err((Standing::NotBuilt, said))),
            Err(error @ StudentError::NoProgram { .. }) => {
                Ok(Err((Standing::NotBuilt, error.to_string())))
            }
            Err(error) => Err(error.to_string()),
        }
    }

    fn warm_folder(&self) -> PathBuf {
        self.folder.join("packages")
    }

    /// Compiles the packages that workbooks use, once in a run: for a workbook with nothing in it, as ours are the hand-in's to write.
    fn warm_up(&self) -> Result<(), Trouble> {
        let mut warm = lock(&self.warm);
        if *warm {
            return Ok(());
        }
        let folder = self.warm_folder();
        let starter = starter::given(Language::Rust).map_err(ToString::to_string)?;
        let is_source = |path: &Path| path.extension().is_some_and(|e| e == "rs");
        let manifests = starter
            .iter()
            .filter(|(path, _)| !is_source(path))
            .map(|(path, bytes)| (path.as_path(), &bytes[..]));
        let nothing = [
            ("src/lib.rs", ""),
            ("workbook/src/lib.rs", ""),
            ("workbook/src/bin/answer.rs", "fn main() {}"),
            (".cargo/config.toml", CARGO),
        ]
        .map(|(path, text)| (Path::new(path), text.as_bytes()));
        remove(&folder).map_err(told("be emptied", &folder))?;
        write(&folder, manifests.chain(nothing)).map_err(told("be filled", &folder))?;
        let (built, said) = self.sandbox.build_told(&folder, ANSWER);
        built.map_err(|error| {
            format!("an empty workbook cannot be built here ({error}). Make one of your own once (raybook new, raybook check): that downloads the packages that workbooks use.\n{said}")
        })?;
        *warm = true;
        Ok(())
    }
}

/// What the folder of a hand-in is called where its student reads of it.
pub const PLACE: &str = "hand-in";

/// How an exercise stands that no file answers.
pub fn nothing() -> (Standing, String) {
    let why = "no file of the hand-in answers this exercise";
    (Standing::NotStarted, why.to_owned())
}

/// Writes files into a folder, which is made.
///
/// # Errors
/// If one cannot be written.
pub(super) fn write<'a>(
    folder: &Path,
    files: impl Iterator<Item = (&'a Path, &'a [u8])>,
) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    for (path, bytes) in files {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap_or(folder))?;
        fs::write(path, bytes)?;
    }
    Ok(())
}

/// Copies what was compiled, with its times, by which cargo knows what is new; but for the course's own packages, which are the
/// hand-in's to write.
fn copy_packages(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let name = entry.file_name();
        let is_own = name
            .to_str()
            .is_none_or(|name| name.contains("raybook") || name.contains("answer"));
        if is_own {
            continue;
        }
        let (from, to) = (entry.path(), to.join(&name));
        if entry.file_type()?.is_dir() {
            copy_packages(&from, &to)?;
        } else {
            fs::copy(&from, &to)?;
            let changed = entry.metadata()?.modified()?;
            fs::File::options()
                .append(true)
                .open(&to)?
                .set_modified(changed)?;
        }
    }
    Ok(())
}

/// Removes a folder, if it is there.
fn remove(folder: &Path) -> io::Result<()> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        removed => removed,
    }
}

fn told(what: &str, folder: &Path) -> impl Fn(io::Error) -> Trouble {
    let folder = super::files::shown(folder.as_os_str().as_encoded_bytes());
    move |error| format!("{folder} cannot {what}: {error}")
}
