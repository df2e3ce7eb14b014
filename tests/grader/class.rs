//! Grading a class: its parts, and the command as an instructor runs it.

#![cfg(target_os = "linux")] // elsewhere no stranger's program is started

mod archives;
mod beside;
mod course_file;
mod cpp;
mod drawn;
mod exports;
mod grades;
mod grading;
mod hostile;
mod interrupted;
mod journal;
mod own;
mod packed;
mod pages;
mod prebuilt;
mod reaches;
mod regrading;
mod roll;
mod rust;
mod similar;
mod taken;
mod tokens;
mod when;

use raybook_common::project;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// A course key that is written nowhere else.
pub const KEY: &str = "class-key-9Xw3-Lq52";

/// A program in Python that answers an exercise rightly, and the others not yet.
pub const RIGHT: &str = "\
import sys
for line in sys.stdin:
    name, *words = line.split()
    n = [float(word) for word in words]
    if name == 'ray_at':
        print('=', *[n[i] + n[6] * n[3 + i] for i in range(3)], flush=True)
    else:
        print('= todo', name, flush=True)
";

/// The same with a sign that is wrong.
pub fn wrong_sign() -> String {
    RIGHT.replace("n[i] + n[6]", "n[i] - n[6]")
}

/// Answers the visible cases, which anybody can read, and nothing else.
pub fn visible_only() -> String {
    let golden = text(&project("golden/ch01_rays/ray_at.txt"));
    format!(
        "import sys
GOLDEN = {{}}
for line in {golden:?}.splitlines():
    if '|' in line and '=' in line and not line.startswith('#'):
        question, answer = line.split('|')[1].split('=')[:2]
        GOLDEN[tuple(float(word) for word in question.split())] = answer.strip()
for line in sys.stdin:
    print('=', GOLDEN.get(tuple(float(word) for word in line.split()[1:]), '0 0 0'), flush=True)
"
    )
}

/// An instructor's folder.
pub struct Course {
    pub home: tempfile::TempDir,
}

/// Grades a class, in its folder.
pub const GRADE: [&str; 6] = [
    "grade",
    "hand-ins",
    "--course",
    "course.toml",
    "--key-file",
    "key",
];

impl Course {
    /// With the key, and a course file of these lines.
    pub fn new(course: &str) -> Self {
        let new = Self {
            home: tempfile::tempdir().expect("a temporary folder"),
        };
        fs::create_dir(new.path("hand-ins")).expect("a folder");
        fs::write(new.path("key"), format!("{KEY}\n")).expect("the key");
        fs::write(new.path("course.toml"), course).expect("the course");
        new
    }

    pub fn path(&self, path: &str) -> PathBuf {
        self.home.path().join(path)
    }

    /// Writes a file of a hand-in.
    pub fn hand_in(&self, path: &str, text: &str) {
        let path = self.path("hand-ins").join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("folders");
        fs::write(path, text).expect("a file");
    }

    /// Hands in what students of a language are given, under its name.
    pub fn hand_in_starter(&self, language: &str) {
        let folder = format!("hand-ins/{language}");
        let (code, said) = self.say(&["new", &folder, "--language", language]);
        assert_eq!(code, Some(0), "{said}");
    }

    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raybook"));
        command.args(arguments).current_dir(self.home.path());
        command
    }

    pub fn say(&self, arguments: &[&str]) -> (Option<i32>, String) {
        let output = self.command(arguments).output().expect("the command runs");
        let said = [output.stdout, output.stderr]
            .map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
            .concat();
        (output.status.code(), said)
    }

    /// Grades the class.
    pub fn grade(&self, options: &[&str]) -> (Option<i32>, String) {
        self.say(&[&GRADE, options].concat())
    }

    /// A grader of the class, which is running and says nothing.
    pub fn start_grading(&self) -> Child {
        let mut grader = self.command(&GRADE);
        let grader = grader.stdout(Stdio::null()).stderr(Stdio::null());
        grader.spawn().expect("it starts")
    }

    pub fn json(&self, path: &str) -> Value {
        let text = fs::read(self.path(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        serde_json::from_slice(&text).expect("it is JSON")
    }

    /// A student's grade.
    pub fn student(&self, student: &str) -> Value {
        self.json(&format!("results/students/{student}/grade.json"))
    }

    pub fn points(&self, student: &str) -> f64 {
        self.student(student)["points"].as_f64().expect("a number")
    }

    /// How an exercise of a student stands.
    pub fn standing(&self, student: &str, exercise: &str) -> String {
        let grade = self.student(student);
        let chapters = grade["chapters"].as_array().expect("chapters").iter();
        let mut exercises =
            chapters.flat_map(|chapter| chapter["exercises"].as_array().expect("exercises"));
        let found = exercises
            .find(|of| of["exercise"] == exercise)
            .expect("it is in the course");
        found["standing"].as_str().unwrap_or("nothing").to_owned()
    }
}

/// The text of a file.
pub fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
