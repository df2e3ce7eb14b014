//! Hand-ins: who handed in, in which language, and a fingerprint by which equal ones are known.

use super::course::Course;
use super::files::{self, Files, FilesError, packed};
use super::similar::Prints;
use super::tokens::tokens;
use super::{reaches, similar, taken};
use crate::fingerprint;
use crate::language::Language;
use crate::starter;
use raybook_scenes::fields::Fields;
use raybook_scenes::wrong::Source;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A hand-in, without its files: a class of them is held in memory.
#[derive(Clone, Debug)]
pub struct HandIn {
    /// Who handed in: the name of the folder or the file.
    pub student: String,
    /// Where it lies.
    pub path: PathBuf,
    /// What it is; or why it is refused.
    pub content: Result<Content, String>,
    /// What was left out of it.
    pub notes: Vec<String>,
}

/// What a hand-in is.
#[derive(Clone, Debug)]
pub struct Content {
    /// Its language.
    pub language: Language,
    /// The fingerprint of its source files.
    pub print: String,
    /// The references in it.
    pub taken: BTreeSet<&'static str>,
    /// What its text reaches for that no exercise needs.
    pub tries: BTreeSet<&'static str>,
    /// What it is compared with others by.
    pub similar: Prints,
}

/// Where the hand-ins of a class lie: by student, in the order of their names.
#[derive(Clone, Debug, Default)]
pub struct Listed {
    /// By student.
    pub found: BTreeMap<String, PathBuf>,
    /// What lies beside them and is no hand-in, and why.
    pub others: Vec<String>,
}

/// The hand-ins in a folder: a folder each, or a packed file, or a single source file. What is `except`ed is none.
///
/// # Errors
/// If the folder cannot be listed, or a student handed in twice.
pub fn list(folder: &Path, except: &[PathBuf]) -> Result<Listed, String> {
    let wrong = |error: io::Error| {
        format!(
            "{}: cannot be listed: {error}",
            files::shown(folder.as_os_str().as_encoded_bytes())
        )
    };
    let mut listed = Listed::default();
    for entry in fs::read_dir(folder).map_err(wrong)? {
        let entry = entry.map_err(wrong)?;
        let name = entry.file_name();
        let shown = files::shown(name.as_encoded_bytes());
        let is_excepted = entry
            .path()
            .canonicalize()
            .is_ok_and(|path| except.contains(&path));
        let kind = entry.file_type().map_err(wrong)?;
        let Some(name) = name.to_str() else {
            listed.others.push(format!(
                "{shown}: a name that is not UTF-8; rename it to have it graded"
            ));
            continue;
        };
        if is_excepted || name.starts_with('.') {
            continue;
        }
        let source = name
            .rsplit_once('.')
            .filter(|(_, ending)| ["py", "cpp", "cc", "cxx"].contains(ending));
        let student = match (kind.is_dir(), kind.is_file()) {
            (true, _) => Some(name),
            (_, true) => packed(name).or(source.map(|(student, _)| student)),
            _ => None,
        };
        let Some(student) = student.filter(|student| !student.trim().is_empty()) else {
            listed.others.push(format!(
                "{shown}: neither a folder, nor .zip or .tar.gz, nor a program in Python or C++"
            ));
            continue;
        };
        if let Some(other) = listed.found.insert(student.to_owned(), entry.path()) {
            let other = files::shown(other.file_name().unwrap_or_default().as_encoded_bytes());
            return Err(format!(
                "{shown} and {other} are both of the same student; leave the one that counts"
            ));
        }
    }
    listed.others.sort();
    Ok(listed)
}

/// Reads a hand-in.
///
/// # Errors
/// If the system cannot read it. What is wrong with the hand-in itself is no error, but said in its content.
pub fn read(student: &str, path: &Path, course: &Course) -> Result<HandIn, FilesError> {
    let mut hand_in = HandIn {
        student: student.to_owned(),
        path: path.to_owned(),
        content: Err(String::new()),
        notes: Vec::new(),
    };
    match files(path, course) {
        Ok((language, files, left_out)) => {
            hand_in.notes = left_out;
            hand_in.content = Ok(content(language, &files));
        }
        Err(FilesError::Refused(why)) => hand_in.content = Err(why),
        Err(unread) => return Err(unread),
    }
    Ok(hand_in)
}

/// The language of a hand-in, its source files in it, and what was left out.
///
/// # Errors
/// If it is refused, or the system cannot read it.
pub fn files(path: &Path, course: &Course) -> Result<(Language, Files, Vec<String>), FilesError> {
    let read = files::read(path, &course.limits)?;
    let language = language(&read.files).map_err(FilesError::Refused)?;
    if !course.languages.contains(&language) {
        let names: Vec<_> = course
            .languages
            .iter()
            .map(|language| language.name())
            .collect();
        let why = format!(
            "it is in {}, and the course takes {}",
            language.name(),
            names.join(", ")
        );
        return Err(FilesError::Refused(why));
    }
    let of_language = |path: &String| {
        let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
        language.endings().contains(&ending) || path == taken::FILE
    };
    let mut files = read.files;
    files.retain(|path, _| of_language(path));
    Ok((language, files, read.left_out))
}

/// The language that `raybook.toml` names; else that of `Cargo.toml`; else the one that the files are of.
fn language(files: &Files) -> Result<Language, String> {
    let named = files.get("raybook.toml").and_then(|text| {
        let source = Source {
            path: Path::new("raybook.toml"),
            text: std::str::from_utf8(text).ok()?,
        };
        let parsed = source.parse().ok()?;
        let fields = Fields::new(source, "a workbook", 0, parsed.get_ref());
        Language::find(fields.text("language").ok()??)
    });
    if let Some(language) = named {
        return Ok(language);
    }
    if files.contains_key("Cargo.toml") {
        return Ok(Language::Rust);
    }
    let is_there = |language: &Language| {
        let mut endings = files
            .keys()
            .filter_map(|path| Some(path.rsplit_once('.')?.1));
        endings.any(|ending| language.endings().contains(&ending))
    };
    let there: Vec<_> = Language::ALL.into_iter().filter(is_there).collect();
    match there[..] {
        [language] => Ok(language),
        [] => Err("there is no source file in it".to_owned()),
        _ => Err("it has sources of several languages, and no raybook.toml that says which counts (language = \"python\")".to_owned()),
    }
}

fn content(language: Language, files: &Files) -> Content {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let starter = starter::given(language).unwrap_or_default();
    let is_given = |path: &str, bytes: &[u8]| {
        let mut all = starter.iter();
        all.any(|(given, text)| given.as_path() == Path::new(path) && text == bytes)
    };
    let mut all = Vec::new();
    let mut found = BTreeSet::new();
    let mut tries = BTreeSet::new();
    for (path, bytes) in files {
        if path == taken::FILE {
            found.extend(taken::recorded(&text(bytes)));
        } else if !is_given(path, bytes) {
            let text = text(bytes);
            all.extend(tokens(language, &text));
            tries.extend(reaches::reaches(&text));
        }
    }
    found.extend(taken::found(language, &all));
    Content {
        language,
        print: fingerprint(language, files),
        taken: found,
        tries,
        similar: similar::prints(language, &all),
    }
}

/// The fingerprint of language, paths and texts.
pub fn fingerprint(language: Language, files: &Files) -> String {
    let files = files.iter();
    let parts = files.flat_map(|(path, bytes)| [path.as_bytes(), bytes]);
    fingerprint::of([language.name().as_bytes()].into_iter().chain(parts), 32)
}
