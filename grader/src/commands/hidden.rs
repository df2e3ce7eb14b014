//! Whose hidden cases are asked, and the course key that they are made from.

use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::hidden::Key;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// A key that is longer is a wrong file.
const LONGEST_KEY: u64 = 1 << 16;

/// A key of fewer bytes can be found by trying all that are as short.
const SHORTEST_KEY: usize = 16;

/// The options of hidden cases. The key is in no option: every process of this machine can read those.
#[derive(clap::Args)]
pub struct Hidden {
    /// Ask the hidden cases that belong to --student and the course key in this file; `-` reads the key from standard input
    #[arg(long, value_name = "FILE", requires = "student")]
    key_file: Option<PathBuf>,
    /// Whose hidden cases
    #[arg(long, requires = "key_file", value_parser = not_empty)]
    student: Option<String>,
    /// The term of the hidden cases
    #[arg(long, default_value = "", requires = "key_file")]
    term: String,
}

/// The name of a student.
fn not_empty(text: &str) -> Result<String, String> {
    if text.trim().is_empty() {
        return Err("it is empty".to_owned());
    }
    Ok(text.to_owned())
}

impl Hidden {
    /// The key of these cases; none if the visible ones are asked. What ends the key's line is no part of it.
    ///
    /// # Errors
    /// If the key cannot be read, or is too short.
    pub fn key(&self) -> Result<Option<Key>, String> {
        let (Some(file), Some(student)) = (&self.key_file, &self.student) else {
            return Ok(None);
        };
        Ok(Some(Key {
            course: read_key(file)?,
            term: self.term.clone(),
            student: student.clone(),
        }))
    }

    /// The file of the key, which no stranger's program may read.
    pub fn file(&self) -> impl Iterator<Item = &Path> {
        self.key_file
            .as_deref()
            .filter(|file| *file != Path::new("-"))
            .into_iter()
    }

    /// These options as they are typed, each word after a space.
    pub fn again(&self) -> String {
        let (Some(file), Some(student)) = (&self.key_file, &self.student) else {
            return String::new();
        };
        format!(
            " --key-file {} --term {} --student {}",
            Untrusted::from(file.as_path()).shell(),
            Untrusted::from(self.term.as_str()).shell(),
            Untrusted::from(student.as_str()).shell()
        )
    }
}

/// The course key in a file, or on standard input where that is `-`. What ends its line is no part of it.
///
/// # Errors
/// If it cannot be read, or is too short.
pub fn read_key(file: &Path) -> Result<String, String> {
    let wrong = |why: &str| format!("--key-file {}: {why}", Untrusted::from(file));
    let mut course = String::new();
    let read = if file == Path::new("-") {
        io::stdin()
            .take(LONGEST_KEY + 1)
            .read_to_string(&mut course)
    } else {
        File::open(file).and_then(|file| file.take(LONGEST_KEY + 1).read_to_string(&mut course))
    };
    let bytes = read.map_err(|error| wrong(&error.to_string()))?;
    if bytes as u64 > LONGEST_KEY {
        return Err(wrong("it is longer than 64 kB: is it the right file?"));
    }
    let course = course.trim_end_matches(['\n', '\r']);
    let what = match course.trim().len() {
        0 => "empty".to_owned(),
        bytes if bytes < SHORTEST_KEY => format!("shorter than {SHORTEST_KEY} bytes"),
        _ => return Ok(course.to_owned()),
    };
    Err(wrong(&format!(
        "it is {what}, so that anybody could foresee the hidden cases. This makes a good key: head -c 32 /dev/urandom | base64 > course.key"
    )))
}
