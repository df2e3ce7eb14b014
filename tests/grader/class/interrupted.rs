//! Graders that are killed, that meet a full disk, and that meet each other.

use super::{Course, GRADE, RIGHT, text, wrong_sign};
use rand::RngExt;
use raybook::math::pcg;
use raybook_common::thorough;
use raybook_grader::class::journal;
use raybook_grader::class::record::Record;
use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

const COURSE: &str = "[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at', 'camera_ray']\n[[chapter]]\nchapter = 'ch04'\nexercises = ['plane_hit']\n";

/// A class of different hand-ins, every third of them wrong.
fn class(hand_ins: usize) -> Course {
    let course = Course::new(COURSE);
    for i in 0..hand_ins {
        let program = if i % 3 == 0 {
            wrong_sign()
        } else {
            RIGHT.to_owned()
        };
        course.hand_in(&format!("student{i}.py"), &format!("# {i}\n{program}"));
    }
    course
}

/// How often each exercise of each hand-in is in the journal.
fn counts(course: &Course) -> BTreeMap<(String, String), usize> {
    let told = journal::read(&course.path("results")).expect("the journal can be read");
    let mut counts = BTreeMap::new();
    for record in told.records.iter().filter_map(Record::from_json) {
        *counts.entry((record.hand_in, record.exercise)).or_default() += 1;
    }
    counts
}

#[test]
fn killed_many_times_everything_is_graded_once_and_the_same() {
    const HAND_INS: usize = 40;
    let wanted = thorough(100);
    let course = class(HAND_INS);
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    let grades = text(&course.path("results/grades.csv"));
    let mut rng = pcg::stream(7, 7);
    let (mut kills, mut while_grading) = (0, 0);
    fs::remove_dir_all(course.path("results")).expect("it is removed");
    while kills < wanted {
        let before = counts_or_none(&course);
        let mut grader = course.start_grading();
        // Not by the clock, which is another on a busy machine: after so many more bytes of the journal, and a moment.
        let enough = length(&course) + rng.random_range(0..1500);
        let mut killed = true;
        while length(&course) < enough && killed {
            // A grader that has ended is none to kill: it starts anew.
            killed = grader.try_wait().expect("it can be waited for").is_none();
            sleep(Duration::from_millis(1));
        }
        sleep(Duration::from_micros(rng.random_range(0..3000)));
        grader.kill().expect("it is killed");
        grader.wait().expect("it ends");
        let after = counts_or_none(&course);
        kills += u32::from(killed);
        while_grading += u32::from(killed && after > before);
        if !killed || after == HAND_INS * 3 {
            check(&course, HAND_INS);
            fs::remove_dir_all(course.path("results")).expect("it is removed");
        }
    }
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    check(&course, HAND_INS);
    assert_eq!(
        text(&course.path("results/grades.csv")),
        grades,
        "the same grades"
    );
    assert!(
        10 * while_grading > wanted,
        "many were killed while they graded: {while_grading}"
    );
}

/// Bytes of the journal.
fn length(course: &Course) -> u64 {
    fs::metadata(course.path("results/run.jsonl")).map_or(0, |file| file.len())
}

fn counts_or_none(course: &Course) -> usize {
    if course.path("results").is_dir() {
        counts(course).len()
    } else {
        0
    }
}

fn check(course: &Course, hand_ins: usize) {
    let counts = counts(course);
    assert_eq!(counts.len(), hand_ins * 3, "all exercises of all hand-ins");
    let twice: Vec<_> = counts.iter().filter(|(_, count)| **count != 1).collect();
    assert!(twice.is_empty(), "each once: {twice:?}");
}

#[test]
fn a_full_disk_is_said_and_the_journal_is_whole() {
    let course = class(12);
    // The limit of a file's length, in blocks of 512 bytes: what a full disk does to the journal.
    let limited = "ulimit -f 3; trap '' XFSZ; exec \"$0\" \"$@\"";
    let output = Command::new("sh")
        .args(["-c", limited, env!("CARGO_BIN_EXE_raybook")])
        .args(GRADE)
        .current_dir(course.home.path())
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(
        said.contains("run.jsonl: cannot add to this journal, which is whole up to here,"),
        "{said}"
    );
    let some = counts(&course).len();
    assert!(0 < some && some < 36, "some of it is there: {some}");
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "with room it goes on: {said}");
    check(&course, 12);
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let course = class(1);
    fs::create_dir_all(course.path("results/run.jsonl")).expect("a folder in the way");
    let (code, said) = course.grade(&[]);
    assert!(
        code == Some(2) && said.contains("results/run.jsonl: cannot write this journal"),
        "{said}"
    );
    fs::write(course.path("file"), "").expect("a file in the way");
    let (code, said) = course.grade(&["--out", "file/results"]);
    assert!(code == Some(2) && said.contains("file/results"), "{said}");
    fs::create_dir(course.path("locked")).expect("a folder");
    fs::set_permissions(course.path("locked"), fs::Permissions::from_mode(0o500))
        .expect("its rights");
    // Root writes wherever it likes.
    if fs::write(course.path("locked/try"), "").is_err() {
        let (code, said) = course.grade(&["--out", "locked"]);
        assert!(
            code == Some(2) && said.contains("locked/run.jsonl"),
            "{said}"
        );
    }
}

#[test]
fn what_fails_beside_the_hand_in_is_no_zero_and_is_tried_again() {
    let course = class(2);
    // There is no Python for a while.
    let mut grader = course.command(&GRADE);
    let output = grader
        .env("PATH", "/nonexistent")
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(
        output.status.code(),
        Some(1),
        "not everything is graded: {said}"
    );
    assert!(
        said.contains("there is no python3 here") && said.contains("no zeros"),
        "{said}"
    );
    assert!(
        course.student("student1")["chapters"][0]["exercises"][0]["points"].is_null(),
        "no zero"
    );
    let moodle = text(&course.path("results/moodle.csv"));
    assert!(
        moodle.contains("student1,,"),
        "an empty field, which platforms leave alone: {moodle}"
    );
    let (code, said) = course.grade(&[]);
    assert!(
        code == Some(1) && said.contains("regrade"),
        "grades change: {said}"
    );
    let (code, said) = course.say(&["regrade", "results", "--course", "course.toml", "--write"]);
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(course.points("student1"), 1.0);
}

#[test]
fn two_graders_exclude_each_other() {
    let course = class(20);
    let mut first = course.start_grading();
    let (code, said) = course.grade(&[]);
    first.wait().expect("it ends");
    // Who comes second waits, and not for ever.
    assert!(
        code == Some(0) || said.contains("another raybook command has kept it"),
        "{said}"
    );
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    check(&course, 20);
}
