//! An instructor's own exercises: a folder of texts, and a program that knows the answers. Nothing of them is compiled.
//!
//! An exercise `lens_power` is two files: `lens_power.toml` says what is asked and answered (`declaration`), and `lens_power.txt` has
//! its named cases, as the golden files of the course have them. Its hidden cases are drawn from the ranges that it declares, by the
//! course key. The right answers are those of the program (`reference`), which may judge the answers of hand-ins too.

mod declaration;
mod draw;
mod exercise;
mod judge;
mod reference;

use crate::cases;
use crate::examine::Examiner;
use crate::fingerprint;
use crate::golden;
use declaration::Declaration;
use exercise::OwnExercise;
use raybook::store;
use raybook_chapters::kit::untrusted::Untrusted;
use reference::Reference;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// The files of a folder by their names.
type Files = BTreeMap<OsString, Vec<u8>>;

/// The largest file of a folder of exercises, and of all together: it is a folder of texts and a program.
const LARGEST: u64 = 64 << 20;

/// The exercises of a folder, in the order of their names. `program` is the command that answers for them, run in the folder.
///
/// # Errors
/// Which file is wrong, and why.
pub fn read(folder: &Path, program: &[&str]) -> Result<Vec<&'static dyn Examiner>, String> {
    let files = files(folder)?;
    let edition = edition(&files, program);
    let reference = Reference::new(folder, program)?;
    let reference: &'static Reference = Box::leak(Box::new(reference));
    let mut exercises: Vec<&'static dyn Examiner> = Vec::new();
    for name in files.keys().map(Path::new) {
        if name.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let file = folder.join(name);
        let declaration = Declaration::read(&file, text(&files, folder, name)?)?;
        let taken = cases::find(declaration.asked.name).is_some();
        if taken {
            return Err(format!(
                "{}: the course has an exercise `{}` already; choose another name",
                shown(&file),
                declaration.asked.name
            ));
        }
        let cases = file.with_extension("txt");
        let named = text(&files, folder, &name.with_extension("txt"))?;
        // The answers depend on everything in the folder, and the edition of an exercise on the text of its cases.
        let exercise = OwnExercise {
            declaration,
            cases: format!("{named}\n# edition {edition}\n"),
            reference,
        };
        let exercise: &'static OwnExercise = Box::leak(Box::new(exercise));
        let examiner: &'static dyn Examiner = exercise;
        let named = golden::admitted(examiner, examiner.golden());
        let named = named.map_err(|error| format!("{}: {error}", shown(&cases)))?;
        if named.is_empty() {
            return Err(format!(
                "{}: there is no case; write one on a line, `name | {}`",
                shown(&cases),
                examiner.asked().question_names().join(" ")
            ));
        }
        exercises.push(examiner);
    }
    if exercises.is_empty() {
        return Err(format!(
            "{}: there is no exercise here; one called lens_power is the files lens_power.toml and lens_power.txt",
            shown(folder)
        ));
    }
    Ok(exercises)
}

/// The files of a folder; those of folders in it do not belong to it.
///
/// # Errors
/// If one cannot be read, or they are too large.
pub fn files(folder: &Path) -> Result<Files, String> {
    let wrong = |error| format!("{}: {error}", shown(folder));
    let mut files = Files::new();
    let mut left = LARGEST;
    for entry in fs::read_dir(folder).map_err(wrong)? {
        let entry = entry.map_err(wrong)?;
        let path: PathBuf = entry.path();
        let size = fs::metadata(&path).map_err(wrong)?;
        if !size.is_file() {
            continue;
        }
        left = left.checked_sub(size.len()).ok_or_else(|| {
            format!(
                "{}: its files are larger than {} MB together; leave in it what the exercises need",
                shown(folder),
                LARGEST >> 20
            )
        })?;
        let bytes = store::read(&path).map_err(|error| error.to_string())?;
        files.insert(entry.file_name(), bytes);
    }
    Ok(files)
}

/// The fingerprint of a folder and its command: whatever changes in them may change the answers.
fn edition(files: &Files, program: &[&str]) -> String {
    let words = program.iter().map(|word| word.as_bytes());
    let files = files.iter();
    let files = files.flat_map(|(name, bytes)| [name.as_encoded_bytes(), bytes]);
    fingerprint::of(words.chain(files), 16)
}

/// The text of one of the files.
fn text<'a>(files: &'a Files, folder: &Path, name: &Path) -> Result<&'a str, String> {
    let shown = || shown(&folder.join(name));
    let bytes = files.get(name.as_os_str());
    let bytes = bytes.ok_or_else(|| format!("{}: there is no such file", shown()))?;
    let text = str::from_utf8(bytes);
    text.map_err(|error| format!("{}: this is no text: {error}", shown()))
}

fn shown(path: &Path) -> Untrusted {
    Untrusted::from(path)
}
