//! The starter's own sources in C++, compiled once for the class.
//!
//! A hand-in is mostly what every student was given: the answer loop, and chapters that are not begun. Of a file that is byte for
//! byte the starter's, and whose headers are too, the object is the same for everybody. Of a chapter that is begun, most of the
//! time goes to the headers of the standard library: those that the starter includes, and those that students add, are compiled
//! before, too.

use super::files::Files;
use super::stage::{Trouble, write};
use crate::language::Language;
use crate::mutex::lock;
use crate::sandbox::{Ready, Sandbox};
use crate::starter::{self, StarterFile};
use crate::student::StudentError;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// The header of the standard library's headers.
const HEADER: &str = "given.hpp";

/// Headers of the standard library that no chapter needs and many a solution includes: sorting, queues, sums, limits.
const OFTEN_ADDED: [&str; 13] = [
    "algorithm",
    "array",
    "cstddef",
    "cstdint",
    "functional",
    "initializer_list",
    "limits",
    "memory",
    "numeric",
    "queue",
    "random",
    "tuple",
    "utility",
];

/// Objects of the starter's sources, in a folder that hand-ins can only read.
pub struct Prebuilt {
    folder: PathBuf,
    /// Of which sources, and of which header, there are objects; one hand-in at a time adds what it needs.
    compiled: Mutex<BTreeSet<PathBuf>>,
}

impl Prebuilt {
    /// Nothing is compiled yet; the folder is made when something is.
    pub fn new(folder: PathBuf) -> Self {
        Self {
            folder,
            compiled: Mutex::new(BTreeSet::new()),
        }
    }

    /// Takes the sources that are the starter's out of these, and returns the objects in their place, with a header for the others.
    ///
    /// # Errors
    /// If the starter cannot be compiled here.
    pub fn ready(
        &self,
        sandbox: &Sandbox,
        files: &Files,
        sources: &mut Vec<String>,
    ) -> Result<Ready, Trouble> {
        let starter = starter::given(Language::Cpp).map_err(ToString::to_string)?;
        let given = unchanged(starter, files);
        sources.retain(|source| !given.contains(&Path::new(source)));
        if given.is_empty() {
            return Ok(Ready::default());
        }
        let mut compiled = lock(&self.compiled);
        let told = |(built, said): (Result<(), StudentError>, String)| {
            built.map_err(|error| format!("the starter in C++ cannot be compiled: {error}\n{said}"))
        };
        if compiled.is_empty() {
            let header = standard_headers(starter);
            let texts = starter
                .iter()
                .map(|(path, bytes)| (path.as_path(), &bytes[..]))
                .chain([(Path::new(HEADER), header.as_bytes())]);
            write(&self.folder, texts)
                .map_err(|error| format!("the starter in C++ cannot be written: {error}"))?;
            told(sandbox.precompile(&self.folder, HEADER))?;
        }
        let missing: Vec<_> = given
            .iter()
            .filter(|path| !compiled.contains(**path))
            .collect();
        let names = missing.iter().map(|path| path.display().to_string());
        let names: Vec<_> = names.collect();
        if !names.is_empty() {
            told(sandbox.compile_objects(&self.folder, &names))?;
        }
        compiled.extend(missing.into_iter().map(|path| path.to_path_buf()));
        let object = |path: &&Path| {
            path.file_stem()
                .map(|stem| self.folder.join(stem).with_extension("o"))
        };
        Ok(Ready {
            objects: given.iter().filter_map(object).collect(),
            header: Some(self.folder.join(HEADER)),
        })
    }
}

/// What the header of any chapter includes of the standard library, and what students often add.
pub fn standard_headers(starter: &[StarterFile]) -> String {
    let of_chapters = |path: &Path| {
        let name = path.file_name().and_then(|name| name.to_str());
        name.is_some_and(|name| {
            name == "vec.hpp" || name.starts_with("ch") && name.ends_with("hpp")
        })
    };
    let texts = starter.iter().filter(|(path, _)| of_chapters(path));
    let lines = texts.flat_map(|(_, text)| text.split(|&byte| byte == b'\n'));
    let lines = lines.filter(|line| line.starts_with(b"#include <"));
    let mut lines: BTreeSet<_> = lines.map(String::from_utf8_lossy).collect();
    lines.extend(OFTEN_ADDED.map(|name| format!("#include <{name}>").into()));
    lines.iter().flat_map(|line| [line, "\n"]).collect()
}

/// The starter's sources that are in a hand-in as they were given out: none, if a header is another one.
pub fn unchanged<'a>(starter: &'a [StarterFile], files: &Files) -> Vec<&'a Path> {
    let kept = |(path, bytes): &&StarterFile| {
        let name = path.to_str().unwrap_or_default();
        files.get(name) == Some(bytes)
    };
    let of = |extension: &'static str| {
        let is = move |(path, _): &&StarterFile| path.extension().is_some_and(|e| e == extension);
        starter.iter().filter(is)
    };
    if !of("hpp").all(|file| kept(&file)) {
        return Vec::new();
    }
    of("cpp")
        .filter(kept)
        .map(|(path, _)| path.as_path())
        .collect()
}
