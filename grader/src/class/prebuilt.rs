//! The starter's own sources in C++, compiled once for the class.
//!
//! A hand-in is mostly what every student was given: the answer loop, and chapters that are not begun. Of a file that is byte for
//! byte the starter's, and whose headers are too, the object is the same for everybody.

use super::files::Files;
use super::stage::{Trouble, write};
use crate::sandbox::Sandbox;
use crate::starter::StarterFile;
use crate::starter::cpp;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Objects of the starter's sources, in a folder that hand-ins can only read.
pub struct Prebuilt {
    folder: PathBuf,
    starter: Vec<StarterFile>,
    /// Of which sources there are objects; one hand-in at a time adds what it needs.
    compiled: Mutex<BTreeSet<PathBuf>>,
}

impl Prebuilt {
    /// Nothing is compiled yet; the folder is made when something is.
    pub fn new(folder: PathBuf) -> Self {
        Self {
            folder,
            starter: cpp::files(),
            compiled: Mutex::new(BTreeSet::new()),
        }
    }

    /// Takes the sources that are the starter's out of these, and returns the objects in their place.
    ///
    /// # Errors
    /// If the starter cannot be compiled here.
    pub fn objects(
        &self,
        sandbox: &Sandbox,
        files: &Files,
        sources: &mut Vec<String>,
    ) -> Result<Vec<PathBuf>, Trouble> {
        let given = unchanged(&self.starter, files);
        sources.retain(|source| !given.contains(&Path::new(source)));
        if given.is_empty() {
            return Ok(Vec::new());
        }
        let mut compiled = self.compiled.lock().unwrap_or_else(PoisonError::into_inner);
        if compiled.is_empty() {
            let texts = self
                .starter
                .iter()
                .map(|(path, bytes)| (path.as_path(), &bytes[..]));
            write(&self.folder, texts)
                .map_err(|error| format!("the starter in C++ cannot be written: {error}"))?;
        }
        let missing: Vec<_> = given
            .iter()
            .filter(|path| !compiled.contains(**path))
            .collect();
        let names = missing.iter().map(|path| path.display().to_string());
        let names: Vec<_> = names.collect();
        if !names.is_empty() {
            let (built, said) = sandbox.compile_objects(&self.folder, &names);
            built.map_err(|error| {
                format!("the starter in C++ cannot be compiled: {error}\n{said}")
            })?;
        }
        compiled.extend(missing.into_iter().map(|path| path.to_path_buf()));
        let object = |path: &&Path| {
            path.file_stem()
                .map(|stem| self.folder.join(stem).with_extension("o"))
        };
        Ok(given.iter().filter_map(object).collect())
    }
}

/// The starter's sources that are in a hand-in as they were given out: none, if a header is another one.
fn unchanged<'a>(starter: &'a [StarterFile], files: &Files) -> Vec<&'a Path> {
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

#[cfg(test)]
mod tests {
    use super::{cpp, unchanged};
    use crate::class::files::Files;

    #[test]
    fn what_is_written_anew_is_not_taken_from_the_starter() {
        let starter = cpp::files();
        let handed_in = |changed: &str| -> Files {
            let file = |(path, bytes): &(std::path::PathBuf, Vec<u8>)| {
                let name = path.display().to_string();
                let more: &[u8] = if name == changed { b"//\n" } else { b"" };
                (name, [bytes, more].concat())
            };
            starter.iter().map(file).collect()
        };
        let all = unchanged(&starter, &handed_in("")).len();
        assert_eq!(all, 27, "25 chapters, the answer loop and the exercises");
        for (changed, taken) in [
            ("README.md", all),
            ("ch03_sphere.cpp", all - 1),
            ("raybook/exercises.cpp", all - 1),
            ("raybook/vec.hpp", 0),
        ] {
            let given = unchanged(&starter, &handed_in(changed));
            assert_eq!(given.len(), taken, "{changed} is changed");
            assert!(!given.contains(&changed.as_ref()), "{changed}");
        }
    }
}
