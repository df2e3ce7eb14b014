//! What is in the folder.

use crate::starter::names;
use raybook_grader::library::{place, reference};
use raybook_grader::starter::{files, stub};
use raybook_grader::{cases, own_chapters};
use raybook_workbook::anchor::functions;

#[test]
fn every_exercise_is_stubbed_once_with_its_task() {
    let files = files(&stub).expect("the library's anchors are right");
    for examiner in cases::all() {
        let todo = format!("todo!(\"{}\")", examiner.name());
        let places: Vec<_> = files
            .iter()
            .filter(|(_, bytes)| String::from_utf8_lossy(bytes).contains(&todo))
            .collect();
        assert_eq!(
            places.len(),
            1,
            "{} is stubbed in one file",
            examiner.name()
        );
        let (path, bytes) = places[0];
        assert_eq!(
            path.to_string_lossy(),
            place(examiner.name()).expect("it has a place"),
            "where the student is told"
        );
        let text = String::from_utf8_lossy(bytes);
        let comments = text
            .lines()
            .filter_map(|line| line.trim_start().strip_prefix("/// "));
        let comments = comments.collect::<Vec<_>>().join(" ");
        assert!(
            comments.contains(examiner.task()),
            "{}: the stub says what to do",
            examiner.name()
        );
    }
}

#[test]
fn the_starter_holds_no_reference_no_cases_and_no_mistakes() {
    let squeeze = |text: &str| {
        text.lines()
            .filter(|line| !line.trim_start().starts_with("//"))
            .collect::<String>()
            .replace(char::is_whitespace, "")
    };
    let files: Vec<_> = files(&stub)
        .and_then(|of_starter| Ok([of_starter, own_chapters::files()?].concat()))
        .expect("the library's anchors are right")
        .into_iter()
        .map(|(path, bytes)| (path, String::from_utf8_lossy(&bytes).into_owned()))
        .collect();
    for name in names() {
        let text = format!(
            "// ANCHOR: {name}\n{}// ANCHOR_END: {name}\n",
            reference(name).expect("every exercise has a reference")
        );
        let body = squeeze(functions(&text).expect("it is a function")[0].body);
        assert!(body.len() > 15, "{name}: a body worth hiding, not {body}");
        for (path, file) in &files {
            assert!(
                !squeeze(file).contains(&body),
                "{} gives {name} away",
                path.display()
            );
        }
    }
    for examiner in cases::all() {
        for (mistake, hint) in examiner.mistakes() {
            assert!(
                files
                    .iter()
                    .all(|(_, file)| !file.contains(&format!("\"{mistake}\""))
                        && !file.contains(hint)),
                "{}: who {mistake} is given away",
                examiner.name()
            );
        }
    }
    for word in ["Graded", "Mistake", "fn edges", "visible_rng", "ANCHOR"] {
        let found: Vec<_> = files
            .iter()
            .filter(|(_, file)| file.contains(word))
            .map(|(path, _)| path.display().to_string())
            .collect();
        assert!(
            found.is_empty() || (word == "ANCHOR" && found == ["workbook/src/anchor.rs"]),
            "{word} is in {found:?}"
        );
    }
}
