//! The source files of a hand-in, read into memory from a folder, a `.zip` or a `.tar.gz`. Nothing is unpacked onto the disk, no
//! link is followed, and what is not source is left out: what a hand-in is made of, and how large it is, decides nothing
//! outside of it.

mod folder;
mod tar;
mod zip;

use super::course::Allowed;
use raybook_chapters::kit::untrusted::{Untrusted, is_hidden};
use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Files by their paths, whose parts are separated by `/`.
pub type Files = BTreeMap<String, Vec<u8>>;

/// Why there are no files.
#[derive(Debug, thiserror::Error)]
pub enum FilesError {
    /// The hand-in is not as it must be, and why.
    #[error("{0}")]
    Refused(String),
    /// The system could not read it: nothing is known about the hand-in.
    #[error("{}: cannot be read: {reason}", Untrusted::from(path.as_path()))]
    Unread {
        /// The hand-in.
        path: PathBuf,
        /// The system's answer.
        reason: io::Error,
    },
}

/// The files of a hand-in, and what was left out that somebody may miss.
#[derive(Debug, Default)]
pub struct Collected {
    /// The files.
    pub files: Files,
    /// Links, devices and the like.
    pub left_out: Vec<String>,
}

/// How the name of a hand-in ends that is a packed one.
const ZIP: &str = ".zip";
const TAR: [&str; 2] = [".tar.gz", ".tgz"];

/// Whether a file of this name is a packed hand-in; its name without the ending.
pub fn packed(name: &str) -> Option<&str> {
    TAR.iter()
        .chain([&ZIP])
        .find_map(|ending| name.strip_suffix(ending))
}

/// Reads a hand-in: a folder, a packed one, or a single source file. A folder that holds nothing but a packed hand-in is that one:
/// learning platforms pack them so.
///
/// # Errors
/// If the hand-in is refused, or the system cannot read it.
pub fn read(path: &Path, allowed: &Allowed) -> Result<Collected, FilesError> {
    let unread = |reason| FilesError::Unread {
        path: path.to_owned(),
        reason,
    };
    let mut basket = Basket::new(allowed);
    if path.is_dir() {
        if let Some(inside) = folder::only_packed(path).map_err(unread)? {
            return read(&inside, allowed);
        }
        folder::collect(path, "", &mut basket).map_err(|error| basket.said(path, error))?;
    } else {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let file = std::fs::File::open(path).map_err(unread)?;
        let length = file.metadata().map_err(unread)?.len();
        if length > basket.most_packed() {
            return Err(FilesError::Refused(format!(
                "it has {length} bytes, and at most {} are read",
                basket.most_packed()
            )));
        }
        let collected = if name.ends_with(ZIP) {
            zip::collect(file, &mut basket)
        } else if packed(&name).is_some() {
            tar::collect(file, &mut basket)
        } else {
            let wanted = basket.wants(name.as_bytes());
            wanted.and_then(|name| name.map_or(Ok(()), |name| basket.put(name, file)))
        };
        collected.map_err(|error| basket.said(path, error))?;
    }
    if let Some(both) = file_and_folder(&basket.files) {
        let shown = shown(both.as_bytes());
        return Err(FilesError::Refused(format!(
            "{shown} is both a file and a folder in it"
        )));
    }
    Ok(Collected {
        files: without_common_folder(basket.files),
        left_out: basket.left_out,
    })
}

/// What is collected of a hand-in, within its limits.
struct Basket {
    files: Files,
    left_out: Vec<String>,
    most_files: usize,
    most_bytes: u64,
    bytes: u64,
    entries: usize,
    refused: Option<String>,
}

/// A hand-in with more entries of any kind is not looked through.
const MOST_ENTRIES: usize = 100_000;

/// Longer paths and parts of paths no file system has.
const LONGEST_PATH: usize = 1000;
const LONGEST_PART: usize = 255;

/// A notice for each link would be a book.
const MOST_NOTICES: usize = 10;

/// Folders that tools make, and that nobody writes.
const MADE: &[&str] = &[
    "target",
    "__pycache__",
    "__MACOSX",
    "node_modules",
    "venv",
    "CMakeFiles",
];

/// Files that are no source, but say what the sources are.
const KNOWN: &[&str] = &["raybook.toml", "Cargo.toml", super::taken::FILE];

impl Basket {
    fn new(allowed: &Allowed) -> Self {
        Self {
            files: Files::new(),
            left_out: Vec::new(),
            most_files: allowed.files,
            most_bytes: allowed.bytes,
            bytes: 0,
            entries: 0,
            refused: None,
        }
    }

    /// Bytes of a packed hand-in, and of all that it holds, source or not.
    fn most_packed(&self) -> u64 {
        8 * self.most_bytes + (32 << 20)
    }

    /// The error of a collection: a refusal, where one was said; else the system's.
    fn said(&mut self, path: &Path, reason: io::Error) -> FilesError {
        match self.refused.take() {
            Some(why) => FilesError::Refused(why),
            None => FilesError::Unread {
                path: path.to_owned(),
                reason,
            },
        }
    }

    /// Refuses the hand-in.
    fn refuse<T>(&mut self, why: impl Into<String>) -> io::Result<T> {
        self.refused = Some(why.into());
        Err(io::Error::other("refused"))
    }

    /// The path of an entry that is wanted; `None` if it is left out.
    fn wants(&mut self, name: &[u8]) -> io::Result<Option<String>> {
        self.entries += 1;
        if self.entries > MOST_ENTRIES {
            return self.refuse(format!("it has more than {MOST_ENTRIES} entries"));
        }
        let shown = shown(name);
        let Ok(name) = std::str::from_utf8(name) else {
            return self.refuse(format!("the name {shown} is not UTF-8"));
        };
        let name = name.replace('\\', "/");
        if name.len() > LONGEST_PATH || name.split('/').any(|part| part.len() > LONGEST_PART) {
            return self.refuse(format!(
                "the name {shown} has {} bytes: that is too long",
                name.len()
            ));
        }
        if name.starts_with('/')
            || name.as_bytes().get(1) == Some(&b':')
            || name.split('/').any(|part| part == "..")
        {
            return self.refuse(format!("the name {shown} leads out of the hand-in"));
        }
        if name.chars().any(is_hidden) {
            return self.refuse(format!(
                "the name {shown} has characters that cannot be seen"
            ));
        }
        let parts: Vec<_> = name
            .split('/')
            .filter(|part| !matches!(*part, "" | "."))
            .collect();
        let Some((file, folders)) = parts.split_last() else {
            return Ok(None);
        };
        let made = |part: &&str| part.starts_with('.') || MADE.contains(part);
        let ending = file.rsplit_once('.').map(|(_, ending)| ending);
        let languages = crate::language::Language::ALL;
        let is_source = languages
            .iter()
            .any(|language| ending.is_some_and(|ending| language.endings().contains(&ending)));
        let wanted = (is_source && !file.starts_with('.')) || KNOWN.contains(file);
        Ok((wanted && !folders.iter().any(made)).then(|| parts.join("/")))
    }

    /// Takes the file of a path.
    fn put(&mut self, path: String, content: impl Read) -> io::Result<()> {
        if self.files.len() >= self.most_files {
            return self.refuse(format!("it has more than {} source files", self.most_files));
        }
        let left = self.most_bytes - self.bytes;
        let mut bytes = Vec::new();
        content.take(left + 1).read_to_end(&mut bytes)?;
        if bytes.len() as u64 > left {
            let most = self.most_bytes;
            return self.refuse(format!("its source files have more than {most} bytes"));
        }
        self.bytes += bytes.len() as u64;
        let shown = shown(path.as_bytes());
        if self.files.insert(path, bytes).is_some() {
            return self.refuse(format!("{shown} is in it twice"));
        }
        Ok(())
    }

    /// Notes that something is no file.
    fn leave_out(&mut self, name: &[u8], what: &str) {
        if self.left_out.len() < MOST_NOTICES {
            self.left_out
                .push(format!("{} is left out: it is {what}", shown(name)));
        }
    }
}

/// A name as people see it, cut where nobody reads on.
pub fn shown(name: &[u8]) -> String {
    const LONGEST: usize = 80;
    let name = Untrusted::from(String::from_utf8_lossy(name).as_ref()).to_string();
    match name.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &name[..end]),
        None => name,
    }
}

/// A file whose name a folder has too: a packed hand-in can hold that, and no file system.
fn file_and_folder(files: &Files) -> Option<&str> {
    let folders = |path: &str| -> Vec<String> {
        let ends = path.match_indices('/');
        ends.map(|(end, _)| path[..end].to_owned()).collect()
    };
    let mut folders = files.keys().flat_map(|path| folders(path));
    let both = folders.find_map(|folder| files.get_key_value(&folder));
    both.map(|(path, _)| path.as_str())
}

/// The files from the folder in which the hand-in begins: that of its `raybook.toml` or `Cargo.toml`, or else the deepest that
/// holds all of it.
fn without_common_folder(files: Files) -> Files {
    let folder = |path: &str| {
        path.rsplit_once('/')
            .map_or("", |(folder, _)| folder)
            .to_owned()
    };
    let marks = |path: &&String| path.ends_with("raybook.toml") || path.ends_with("Cargo.toml");
    let marked = files.keys().filter(marks).map(|path| folder(path));
    let common = || {
        let mut folders = files.keys().map(|path| folder(path));
        let first = folders.next().unwrap_or_default();
        folders.fold(first, |common, other| {
            let same = common
                .split('/')
                .zip(other.split('/'))
                .take_while(|(a, b)| a == b);
            same.map(|(part, _)| part).collect::<Vec<_>>().join("/")
        })
    };
    let root = marked.min_by_key(String::len).unwrap_or_else(common);
    if root.is_empty() {
        return files;
    }
    let inside = |(path, bytes): (String, Vec<u8>)| {
        let path = path.strip_prefix(&root)?.strip_prefix('/')?;
        Some((path.to_owned(), bytes))
    };
    files.into_iter().filter_map(inside).collect()
}
