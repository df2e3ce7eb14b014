//! Programs that attack the grader: none has an effect, and none is right; honest ones are.

#![cfg(target_os = "linux")] // elsewhere no stranger's program is started

pub mod attacks;
mod build;
mod honest;
mod probes;
mod programs;

use raybook_common::project;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A course key that is written nowhere else.
pub const KEY: &str = "kf4-course-key-Zq81";

/// An instructor's machine: a folder with a hand-in, and beside it what hand-ins must not touch.
pub struct Desk {
    home: tempfile::TempDir,
}

/// What became of a check.
struct Checked {
    code: Option<i32>,
    said: String,
}

impl Desk {
    pub fn new() -> Self {
        let desk = Self {
            home: tempfile::tempdir().expect("a temporary folder"),
        };
        for folder in ["hand-in", "home", "course"] {
            fs::create_dir(desk.path(folder)).expect("a folder");
        }
        fs::write(desk.path("course/key"), format!("{KEY}\n")).expect("the key");
        fs::write(desk.path("course/grades.csv"), "eve,0\n").expect("grades");
        let golden = project("golden/ch01_rays");
        fs::create_dir(desk.path("course/golden")).expect("a folder");
        let copied = Command::new("cp")
            .arg("-r")
            .args([golden, desk.path("course/golden")])
            .status();
        assert!(
            copied.is_ok_and(|status| status.success()),
            "golden answers are copied"
        );
        desk
    }

    pub fn path(&self, path: &str) -> PathBuf {
        self.home.path().join(path)
    }

    /// Checks a program of the hand-in's folder with hidden cases; the key comes on standard input.
    fn check(&self, program: &str, time_limit: &str, options: &[&str]) -> Checked {
        let mut grader = Command::new(env!("CARGO_BIN_EXE_raybook"))
            .args([
                "check",
                "ray_at",
                "--plain",
                "--student",
                "eve",
                "--key-file",
                "-",
            ])
            .args(["--golden", "course/golden", "--time-limit", time_limit])
            .args(options)
            .arg("--program")
            .arg(self.path("hand-in").join(program))
            .current_dir(self.home.path())
            .env("RAYBOOK_TEST_SECRET", "env-secret-7Tk")
            .env("HOME", self.path("home"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let mut stdin = grader.stdin.take().expect("it is piped");
        stdin.write_all(KEY.as_bytes()).expect("it reads its key");
        drop(stdin);
        let output = grader.wait_with_output().expect("it ends");
        Checked {
            code: output.status.code(),
            said: [output.stdout, output.stderr]
                .map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
                .concat(),
        }
    }

    /// Every file and folder: its content, rights, owner, and when it was changed.
    pub fn files(&self) -> BTreeMap<PathBuf, String> {
        let mut files = BTreeMap::new();
        collect(self.home.path(), &mut files);
        files
    }

    /// The processes whose command line or present folder is of this desk.
    pub fn processes(&self) -> Vec<String> {
        let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
        let of_desk = |entry: &fs::DirEntry| {
            let folder = fs::read_link(entry.path().join("cwd")).ok()?;
            folder.starts_with(self.home.path()).then(|| {
                let command = fs::read(entry.path().join("cmdline")).unwrap_or_default();
                String::from_utf8_lossy(&command).replace('\0', " ")
            })
        };
        entries.filter_map(|entry| of_desk(&entry)).collect()
    }
}

fn collect(path: &Path, files: &mut BTreeMap<PathBuf, String>) {
    let kind = path.symlink_metadata().expect("it is there");
    let content = if kind.is_file() {
        fs::read(path).unwrap_or_default()
    } else {
        Vec::new()
    };
    let state = format!(
        "{:o} {} {} {:?} {}",
        kind.mode(),
        kind.uid(),
        kind.len(),
        kind.modified().ok(),
        String::from_utf8_lossy(&content)
    );
    files.insert(path.to_owned(), state);
    if kind.is_dir() {
        for entry in fs::read_dir(path).expect("it can be listed") {
            collect(&entry.expect("an entry").path(), files);
        }
    }
}

/// Whether there is this program; else the test says so.
pub fn there_is(program: &str) -> bool {
    let there = Command::new(program)
        .arg("--version")
        .output()
        .is_ok_and(|output| output.status.success());
    if !there {
        println!("there is no {program} here: its programs are not tried");
    }
    there
}
