//! The answer program in Python: how it writes what a function returns, and where it says that an error is.

use super::{WITHOUT_RUST, new, succeeds, there_is};
use crate::common::command::raybook_with;
use raybook_grader::language::Language;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Values as people return them, the type that is declared, and the words; or a part of the error.
const WORDS: &[(&str, &str, &str)] = &[
    ("Vec2(1, 2)", "Vec2", "1 2"),
    ("[1, 2]", "Vec2 | None", "1 2"),
    ("(k for k in (1, 2))", "Vec2", "1 2"),
    ("Array([1, 2])", "Vec2", "1 2"),
    ("None", "Vec2 | None", "none"),
    ("True", "int", "1"),
    ("[3, 4]", "list[int]", "2 3 4"),
    ("(3, 4)", "list[int]", "2 3 4"),
    ("{3}", "list[int]", "1 3"),
    ("map(abs, [-3, 4])", "list[int]", "2 3 4"),
    ("[[1, 2], Vec2(3, 4)]", "list[Vec2]", "2 1 2 3 4"),
    ("Array([[1, 2], [3, 4]])", "list[Vec2]", "2 1 2 3 4"),
    ("Both([1, 2], [3])", "Both", "1 2 1 3"),
    ("(Array([1, 2]), (3, 4))", "Both", "1 2 2 3 4"),
    ("(1, 2, [3])", "Both", "1 2 1 3"),
    ("{1, 2}", "Vec2", "TypeError: an answer has no set in it"),
    (
        "{1: 2}",
        "list[int]",
        "TypeError: an answer has no dict in it",
    ),
    (
        "len",
        "float",
        "TypeError: an answer has no builtin_function",
    ),
    ("(-1.0) ** 0.5", "float", "ValueError: math domain error"),
];

/// What the values are made of, and how their words are found.
const ASKING: &str = "
import sys
from dataclasses import dataclass
from raybook.vec import Vec2
from raybook.words import words_of

class Array:
    def __init__(self, rows):
        self.rows = rows
    def tolist(self):
        return self.rows

@dataclass
class Both:
    place: 'Vec2'
    names: 'list[int]'

_, value, declared = sys.argv
try:
    print(words_of(eval(value), declared, globals()))
except (TypeError, ValueError) as error:
    print(f'{type(error).__name__}: {error}')
";

#[test]
fn a_list_is_counted_where_one_is_declared_and_is_a_row_elsewhere() {
    if !there_is("/usr/bin/python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    for (value, declared, words) in WORDS {
        let mut python = Command::new("/usr/bin/python3");
        python.args(["-c", ASKING, value, declared]);
        let said = succeeds(python.current_dir(&folder));
        let is_error = words.contains("Error");
        assert!(
            said.trim() == *words || is_error && said.starts_with(words),
            "{value} where {declared} is declared: {said}"
        );
    }
}

/// What a check says when this is the body of `ray_at`, in line 17 of its file.
fn check(folder: &Path, body: &str) -> String {
    let file = folder.join("ch01_rays.py");
    let text = fs::read_to_string(&file).expect("it can be read");
    let stub = "    raise NotImplementedError(\"ray_at\")  # write it here";
    assert!(text.contains(stub), "{text}");
    fs::write(&file, text.replace(stub, body)).expect("it can be written");
    raybook_with(folder, &["check", "ray_at", "--plain"], &[WITHOUT_RUST]).1
}

#[test]
fn an_error_is_told_where_the_student_wrote_it() {
    if !there_is("/usr/bin/python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    for (name, body, error) in [
        (
            "sum",
            "    return ray.origin + t",
            "unsupported operand type(s) for +: 'Vec3' and 'float'",
        ),
        (
            "product",
            "    return ray.origin * ray.direction",
            "unsupported operand type(s) for *: 'Vec3' and 'Vec3'",
        ),
        (
            "unit",
            "    return (ray.origin - ray.origin).unit()",
            "division by zero",
        ),
        (
            "recursion",
            "    return abs(ray.direction.length()) * ray_at(ray, t)",
            "recursion depth exceeded",
        ),
    ] {
        let folder = new(home.path(), name, Language::Python);
        let said = check(&folder, body);
        assert!(
            said.contains(error) && said.contains("in ch01_rays.py:17."),
            "{body}: {said}"
        );
        assert!(!said.contains("vec.py"), "a file of the course: {said}");
    }
}

#[test]
fn a_function_for_batches_is_not_right_for_single_questions_only() {
    let has_numpy = Command::new("python3")
        .args(["-c", "import numpy"])
        .status();
    if !has_numpy.is_ok_and(|status| status.success()) {
        println!("there is no numpy here: functions for batches are not tried");
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    for (name, sum, code) in [("each", "sum(axis=1)", 0), ("all", "sum()", 1)] {
        let folder = new(home.path(), name, Language::Python);
        let batch = format!(
            "

def ray_at_batch(ray, t):
    length = ((ray.direction * ray.direction).{sum} ** 0.5).reshape(-1, 1)
    return ray.origin + t.reshape(-1, 1) * ray.direction / length
"
        );
        let file = folder.join("ch01_rays.py");
        let text = fs::read_to_string(&file).expect("it can be read");
        fs::write(&file, text + &batch).expect("it can be written");
        let (said_code, said) = raybook_with(&folder, &["check", "ray_at", "--plain"], &[]);
        assert_eq!(said_code, code, "{sum}: {said}");
    }
}
