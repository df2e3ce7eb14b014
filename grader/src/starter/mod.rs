//! The student's folder. In Rust it is a copy of the library in which the exercises are still to be written; in other languages a
//! file per chapter with a stub for each exercise.

pub mod cpp;
pub mod lesson;
pub mod python;
mod stub;

use crate::book::BookError;
use crate::language::Language;
use crate::library::{self, MANIFEST};
use crate::{cases, manifest};
use include_dir::File;
use raybook::store::{self, StoreError};
use raybook_workbook::anchor::{self, AnchorError, Anchored};
use raybook_workbook::curriculum::{self, CHAPTERS, Chapter};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// The versions of all packages, those of the course among them: cargo leaves out what is not used.
pub const LOCK: &str = include_str!("../../../Cargo.lock");

/// Other ways to what an exercise asks, by their anchors: in the student's copy they call what the student writes.
const OTHER_WAYS: &[(&str, &str)] = &[
    (
        "hit_by_plane",
        "crate::shape::Shape::hit(triangle, ray, within)",
    ),
    (
        "hit_by_determinants",
        "crate::shape::Shape::hit(triangle, ray, within)",
    ),
    (
        "hit_watertight",
        "let [p0, p1, p2] = *corners;\n    crate::shape::Shape::hit(&crate::shape::triangle::Triangle::new(p0, p1, p2), ray, within)",
    ),
];

/// The file by which a student's folder is known.
pub const MARKER: &str = "raybook.toml";

/// A file of the starter: its path in the student's folder, and its bytes.
pub type StarterFile = (PathBuf, Vec<u8>);

/// Why a folder cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum StarterError {
    /// There is something already, or the system refused.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A page of the book is wrong; a test sees to it that none is.
    #[error(transparent)]
    Page(#[from] BookError),
    /// The library itself is wrong; a test sees to it that it is not.
    #[error("{0}: {1}")]
    Anchor(String, AnchorError),
}

/// Makes a student's folder, whole or not at all; the marker is its last file.
///
/// # Errors
/// If there is something already, or a file cannot be written.
pub fn create(folder: &Path, language: Language) -> Result<(), StarterError> {
    let mut files = of(language)?;
    files.extend(lesson::files()?);
    let tasks = include_bytes!("tasks.json").to_vec();
    files.insert(0, (PathBuf::from(".vscode/tasks.json"), tasks));
    Ok(store::new_folder(folder, &files)?)
}

fn of(language: Language) -> Result<Vec<StarterFile>, StarterError> {
    Ok(match language {
        Language::Rust => files(&stub)?,
        Language::Python => python::files(),
        Language::Cpp => cpp::files(),
    })
}

/// The starter as students are given it, but for its lessons: made once, and kept for a class.
///
/// # Errors
/// If the library itself is wrong.
pub fn given(language: Language) -> Result<&'static [StarterFile], &'static StarterError> {
    static GIVEN: [OnceLock<Result<Vec<StarterFile>, StarterError>>; 3] =
        [const { OnceLock::new() }; 3];
    let given = GIVEN[language as usize].get_or_init(|| of(language));
    given.as_deref()
}

/// The file in which a student writes an exercise, in a language that has a starter.
pub fn place(language: Language, exercise: &str) -> Option<String> {
    let ending = match language {
        Language::Rust => return library::place(exercise),
        Language::Python => "py",
        Language::Cpp => "cpp",
    };
    let chapter = curriculum::of_exercise(exercise)?;
    Some(format!("{}.{ending}", chapter.name))
}

/// The file at this place of a workbook, with nothing left to write: in Rust the library's, in other languages a solution that mostly takes
/// another way than the library. An exercise that has no solution in this language is still a stub there.
pub fn reference_file(language: Language, place: &str) -> Option<String> {
    let solved = match language {
        Language::Rust => return library::reference_file(place),
        Language::Python | Language::Cpp => library::solution(language.name(), place)?,
    };
    let chapter = curriculum::find(place.split_once('.')?.0)?;
    let unsolved = chapter.exercises().iter();
    let unsolved = unsolved.filter(|asked| reference(language, asked.name).is_none());
    Some(match language {
        Language::Cpp => {
            let stubs: String = unsolved.map(cpp::stub).collect();
            format!("{}{stubs}{}", solved.strip_suffix(cpp::END)?, cpp::END)
        }
        _ => unsolved
            .map(python::stub)
            .fold(solved.to_owned(), |text, stub| text + &stub),
    })
}

/// The reference's function of an exercise: in Rust the library's, in other languages that of the solution, if there is one.
pub fn reference(language: Language, exercise: &str) -> Option<String> {
    if language == Language::Rust {
        return library::reference(exercise).map(str::to_owned);
    }
    let text = library::solution(language.name(), &place(language, exercise)?)?;
    let called = format!(" {exercise}(");
    let is_outside = |line: &str| !line.starts_with([' ', '/']);
    let lines = text
        .lines()
        .skip_while(|line| !(is_outside(line) && line.contains(&called)));
    // A function ends with a brace in the first column, or where the next thing begins there.
    let mut function = String::new();
    for (i, line) in lines.enumerate() {
        if i > 0 && line.starts_with(|c: char| !c.is_whitespace() && !")}".contains(c)) {
            break;
        }
        function.extend([line, "\n"]);
        if line.starts_with('}') {
            break;
        }
    }
    Some(function).filter(|function| !function.is_empty())
}

/// The reference of an exercise with what it calls, and without the other exercises: in Rust what it calls is the workbook's already.
pub fn reference_alone(language: Language, exercise: &str) -> Option<String> {
    if language == Language::Rust {
        return reference(language, exercise);
    }
    let others = curriculum::of_exercise(exercise)?.exercises().iter();
    let others = others.filter(|asked| asked.name != exercise);
    reference(language, exercise)?;
    let mut text = library::solution(language.name(), &place(language, exercise)?)?.to_owned();
    for other in others.filter_map(|asked| reference(language, asked.name)) {
        if let Some((before, after)) = text.split_once(&other) {
            let comment = |line: &&str| line.starts_with("//") || line.starts_with('#');
            let comment = before.lines().rev().take_while(comment);
            let comment: usize = comment.map(|line| line.len() + 1).sum();
            text = before[..before.len() - comment].to_owned() + after.trim_start();
        }
    }
    Some(text.trim_end().to_owned() + "\n")
}

/// The text of a README, with the files of the chapters after it.
fn readme(text: &str, file: impl Fn(&str) -> String) -> String {
    let line = |chapter: &Chapter| {
        let names: Vec<_> = chapter.exercises().iter().map(|e| e.name).collect();
        let file = file(chapter.name);
        format!("    {file:<28} {}\n", names.join(", "))
    };
    let lines: String = CHAPTERS.iter().map(line).collect();
    format!("{text}\n## The course\n\n{lines}")
}

/// The student's version of an anchored function: its task, its signature, and `todo!`; `None` if it is no exercise.
pub fn stub(function: &Anchored<'_>) -> Option<String> {
    if let Some((_, answer)) = OTHER_WAYS.iter().find(|(name, _)| *name == function.name) {
        return Some(format!("{} {{\n    {answer}\n}}\n", function.signature));
    }
    let asked = cases::find(function.name)?.asked();
    let indent =
        &function.signature[..function.signature.len() - function.signature.trim_start().len()];
    let comment = format!("{indent}/// ");
    let mut task = stub::wrapped(asked.task, &comment, &comment);
    if !asked.in_rust.is_empty() {
        task += &stub::wrapped(&format!("In Rust: {}", asked.in_rust), &comment, &comment);
    }
    Some(format!(
        "{task}{} {{\n{indent}    todo!(\"{}\")\n{indent}}}\n{indent}",
        function.signature, function.name
    ))
}

/// All files of a starter; `rewrite` gives the anchored functions their new text.
///
/// # Errors
/// If an anchor in the library is wrong.
pub fn files(
    rewrite: &dyn Fn(&Anchored<'_>) -> Option<String>,
) -> Result<Vec<StarterFile>, StarterError> {
    let mut files = copies("src", library::source(), rewrite)?;
    files.extend(copies("workbook", library::workbook(), rewrite)?);
    let readme = format!(
        "{}\n## The course\n\n{}",
        include_str!("README.md"),
        course_map()
    );
    for (path, text) in [
        ("Cargo.toml", manifest::root().as_str()),
        ("Cargo.lock", LOCK),
        ("workbook/Cargo.toml", manifest::workbook().as_str()),
        ("workbook/src/bin/answer.rs", include_str!("answer.rs.txt")),
        ("README.md", readme.as_str()),
        (".gitignore", "/target\n/out\n/.raybook\n"),
        (
            MARKER,
            "# This folder is a raybook workbook: `raybook check` grades it.\nlanguage = \"rust\"\n",
        ),
    ] {
        files.push((PathBuf::from(path), text.as_bytes().to_vec()));
    }
    Ok(files)
}

/// Copies of the course's sources, without its anchors and manifests; `rewrite` gives the anchored functions their new text.
///
/// # Errors
/// If an anchor is wrong.
pub fn copies(
    folder: &str,
    originals: Vec<&File<'_>>,
    rewrite: &dyn Fn(&Anchored<'_>) -> Option<String>,
) -> Result<Vec<StarterFile>, StarterError> {
    let mut files = Vec::new();
    for file in originals {
        let path = library::slashes(file);
        if file.path().file_name().is_some_and(|name| name == MANIFEST) {
            continue;
        }
        let bytes = match file.contents_utf8() {
            Some(text) if file.path().extension().is_some_and(|e| e == "rs") => {
                let text = anchor::rewrite(text, rewrite)
                    .map_err(|error| StarterError::Anchor(format!("{folder}/{path}"), error))?;
                library::without_anchors(&text).into_bytes()
            }
            _ => file.contents().to_vec(),
        };
        files.push((Path::new(folder).join(path), bytes));
    }
    Ok(files)
}

/// A line per chapter: its number, its title and its exercises.
pub fn course_map() -> String {
    let line = |chapter: &Chapter| {
        let names: Vec<_> = chapter
            .exercises()
            .iter()
            .map(|exercise| exercise.name)
            .collect();
        format!(
            "    {:2}  {:<25} {}\n",
            chapter.number(),
            chapter.title,
            names.join(", ")
        )
    };
    CHAPTERS.iter().map(line).collect()
}
