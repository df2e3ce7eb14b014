//! Exercises of the instructor's own: texts in a folder, and a program that answers and judges.

use super::rust::{with, workbook};
use super::{Course, RIGHT, text};
use std::fs;

/// A course of one exercise of ours and two of the instructor's.
pub const COURSE: &str = "\
[[chapter]]
chapter = 'ch01'
exercises = ['ray_at']
[[own]]
folder = 'lenses'
title = 'Lenses'
program = ['python3', 'answers.py']
exercises = { lens_power = 2, toward_focus = 1 }
";

const LENS_POWER: &str = "\
task = 'The power of a thin lens in air: P = (n - 1)(1/r1 - 1/r2).'
tolerance = 1e-3
[[question]]
name = 'n'
kind = 'number'
meaning = 'index of refraction'
from = 1.3
to = 2.5
[[question]]
name = 'r1'
kind = 'number'
meaning = 'radius of the first surface, in m'
from = 0.05
to = 1.0
[[question]]
name = 'r2'
kind = 'number'
meaning = 'radius of the second surface, in m'
from = -1.0
to = -0.05
[answer]
name = 'power'
kind = 'number'
meaning = 'power, in 1/m'
";

const LENS_POWER_CASES: &str = "\
# People write these.
a magnifying glass | 1.5 0.1 -0.1
flat behind        | 1.5 0.2 -inf
";

const TOWARD_FOCUS: &str = "\
task = 'Any direction that leads upwards.'
judge = true
[[question]]
name = 'tilt'
kind = 'number'
meaning = 'anything'
[answer]
name = 'd'
kind = 'direction'
meaning = 'the direction'
";

pub const ANSWERS: &str = "\
import sys
for line in sys.stdin:
    name, *words = line.split()
    x = [float(word) for word in words]
    if name == 'lens_power':
        print('=', (x[0] - 1) * (1 / x[1] - 1 / x[2]), flush=True)
    elif name == 'toward_focus':
        print('= 0 1 0', flush=True)
    elif name == 'toward_focus.judge':
        tilt, golden, got = x[0], x[1:4], x[4:7]
        print('= right' if got[1] > 0 else '= wrong: it leads down', flush=True)
";

const LENS: &str = "\
import sys
for line in sys.stdin:
    n, r1, r2 = (float(word) for word in line.split()[1:])
    print('=', (n - 1) * (1 / r1 - 1 / r2), flush=True)
";

const UPWARDS: &str = "\
import sys
for line in sys.stdin:
    print('= 0.6 0.8 0', flush=True)
";

/// A course of this file and this program of the instructor's, without hand-ins.
pub fn course(answers: &str, file: &str) -> Course {
    let course = Course::new(file);
    fs::create_dir(course.path("lenses")).expect("a folder");
    for (file, text) in [
        ("lens_power.toml", LENS_POWER),
        ("lens_power.txt", LENS_POWER_CASES),
        ("toward_focus.toml", TOWARD_FOCUS),
        ("toward_focus.txt", "level | 0\n"),
        ("answers.py", answers),
    ] {
        fs::write(course.path("lenses").join(file), text).expect("a file");
    }
    course
}

/// The same with three students.
pub fn class(answers: &str) -> Course {
    let course = course(answers, COURSE);
    // A program for everything of ours, and a file for each exercise of the instructor's.
    course.hand_in("ann/answer.py", RIGHT);
    course.hand_in("ann/lens_power.py", LENS);
    course.hand_in("ann/toward_focus.py", UPWARDS);
    course.hand_in("bob/ch01_rays.py", RIGHT);
    course.hand_in("bob/lens_power.py", &LENS.replace("- 1 / r2", "+ 1 / r2"));
    course.hand_in("bob/toward_focus.py", &UPWARDS.replace("0.8", "-0.8"));
    // Knows the visible cases, and looks for the answers where they lie.
    let place = course.path("lenses/answers.py");
    let peeks = format!("open({:?})\n{LENS}", place.display().to_string());
    course.hand_in("eve/lens_power.py", &peeks);
    course.hand_in("eve/toward_focus.py", UPWARDS);
    course
}

/// A program in Rust that answers an exercise with the student's own library.
const LENS_IN_RUST: &str = "\
use raybook::math::interval::Interval;
use std::io::BufRead;

fn main() {
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let numbers = line.split_whitespace().skip(1);
        let x: Vec<f64> = numbers.map(|word| word.parse().expect(\"a number\")).collect();
        assert!(Interval::AHEAD.contains(1.0));
        println!(\"= {}\", (x[0] - 1.0) * (1.0 / x[1] - 1.0 / x[2]));
    }
}
";

/// Writes a file of the instructor's.
fn put(course: &Course, file: &str, text: &str) {
    fs::write(course.path(file), text).expect("a file");
}

/// Removes a file of the instructor's, or a folder.
fn remove(course: &Course, path: &str) {
    let path = course.path(path);
    let removed = if path.is_dir() {
        fs::remove_dir_all(path)
    } else {
        fs::remove_file(path)
    };
    removed.expect("it was there");
}

#[test]
fn they_count_like_those_of_the_course() {
    let course = class(ANSWERS);
    let (code, said) = course.say(&["course", "show"]);
    assert_eq!(code, Some(0), "{said}");
    for words in ["Lenses", "lens_power", "4 points can be reached"] {
        assert!(said.contains(words), "{said}");
    }
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(course.points("ann"), 4.0, "{:#}", course.student("ann"));
    for (student, exercise, standing) in [
        ("ann", "lens_power", "right"),
        ("ann", "toward_focus", "right"),
        ("bob", "ray_at", "right"),
        ("bob", "lens_power", "wrong"),
        ("bob", "toward_focus", "wrong"),
        ("eve", "lens_power", "wrong"),
        ("eve", "toward_focus", "right"),
    ] {
        assert_eq!(
            course.standing(student, exercise),
            standing,
            "{student}, {exercise}"
        );
    }
    let page =
        |student: &str| text(&course.path(&format!("results/students/{student}/index.html")));
    assert!(
        page("bob").contains("a magnifying glass") && page("bob").contains("too small"),
        "the tolerance's words: {}",
        page("bob")
    );
    assert!(page("bob").contains("it leads down"), "the program's words");
    let bob = course.student("bob");
    let asked = &bob["chapters"][1]["exercises"][0]["asked"];
    assert_eq!(asked, 2 + 34, "hidden cases are drawn from the ranges");
    // What is graded is not graded again, until something in the folder changes.
    let (code, said) = course.grade(&[]);
    assert!(code == Some(0) && said.contains("0 to grade"), "{said}");
    let answers = course.path("lenses/answers.py");
    fs::write(&answers, ANSWERS.replace("got[1] > 0", "got[1] < 0")).expect("a file");
    let (code, said) = course.grade(&[]);
    assert!(code == Some(1) && said.contains("would change"), "{said}");
}

#[test]
fn a_workbook_in_rust_answers_them_in_programs_of_their_names() {
    let course = course(ANSWERS, COURSE);
    workbook(&course, "ron", &with(&["ray_at"]));
    for (name, text) in [
        ("lens_power", LENS_IN_RUST),
        ("toward_focus", "fn main() { up }"),
        // A program of another name is none of the hand-in.
        ("answer", "fn main() { loop {} }"),
    ] {
        course.hand_in(&format!("ron/my-rays/src/bin/{name}.rs"), text);
    }
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    for (exercise, standing) in [
        ("ray_at", "right"),
        ("lens_power", "right"),
        ("toward_focus", "does not compile"),
    ] {
        assert_eq!(course.standing("ron", exercise), standing, "{exercise}");
    }
    let page = text(&course.path("results/students/ron/index.html"));
    assert!(page.contains("cannot find value"), "{page}");
}

/// In C++ too: the starter of the class in `cpp.rs`.
#[test]
fn what_no_file_answers_is_not_started() {
    let course = course(ANSWERS, COURSE);
    course.hand_in_starter("python");
    course.hand_in("alone/lens_power.py", LENS);
    course.hand_in("alone/camera_ray.py", "print('= todo')\n");
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    for (student, exercise) in [
        ("python", "lens_power"),
        ("python", "toward_focus"),
        ("alone", "toward_focus"),
    ] {
        assert_eq!(
            course.standing(student, exercise),
            "not started",
            "{student}, {exercise}"
        );
    }
    let page = text(&course.path("results/students/python/index.html"));
    assert!(page.contains("no file of the hand-in answers"), "{page}");
    assert!(!page.contains("there is no exercise"), "{page}");
}

#[test]
fn a_program_that_fails_is_no_fault_of_a_hand_in() {
    let dies = ANSWERS.replace(
        "    elif name == 'toward_focus.judge':\n",
        "    elif name == 'toward_focus.judge':\n        sys.exit('out of chalk')\n",
    );
    let course = class(&dies);
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(1), "{said}");
    assert!(
        said.contains("no zeros") && said.contains("toward_focus.judge"),
        "{said}"
    );
    assert_eq!(course.standing("ann", "toward_focus"), "not graded");
    assert_eq!(course.standing("ann", "lens_power"), "right");
}

#[test]
fn what_is_wrong_with_the_folder_is_said() {
    type Change = fn(&Course);
    let changes: [(Change, &str); 9] = [
        (|c| remove(c, "lenses"), "lenses"),
        (|c| remove(c, "lenses/lens_power.txt"), "lens_power.txt"),
        (
            |c| put(c, "lenses/sphere_hit.toml", LENS_POWER),
            "`sphere_hit` already",
        ),
        (
            |c| put(c, "lenses/lens_power.txt", "a | 1 2\n"),
            "lens_power.txt: line 1, column 8",
        ),
        (
            |c| put(c, "lenses/lens_power.txt", "a | nan 1 2\n"),
            "lens_power.txt: line 1, column 5: in the question, `n` is NaN",
        ),
        (
            |c| put(c, "lenses/lens_power.toml", "task = 'x'\n"),
            "what is asked?",
        ),
        (
            |c| {
                let text = LENS_POWER.replace("'number'", "'figure'");
                put(c, "lenses/lens_power.toml", &text);
            },
            "lens_power.toml:5:8: `kind` must be",
        ),
        (
            |c| {
                let text = COURSE.replace("lens_power = 2", "lens_powr = 2");
                put(c, "course.toml", &text);
            },
            "did you mean `lens_power`",
        ),
        (
            |c| put(c, "lenses/answers.py", "import sys\nsys.exit('no chalk')\n"),
            "`python3 answers.py` has no answer to `", // of two exercises that are read at the same time
        ),
    ];
    for (change, words) in changes {
        let course = class(ANSWERS);
        change(&course);
        let (code, said) = course.grade(&[]);
        assert_eq!(code, Some(2), "{words}: {said}");
        assert!(said.contains(words), "{words}: {said}");
        assert!(!said.contains("panicked"), "{said}");
    }
    // The copy of the course file in a workbook has no folder beside it: `raybook solve` asks it all the same.
    let course = class(ANSWERS);
    remove(&course, "lenses");
    let (_, said) = course.say(&["solve", "ch03"]);
    assert!(!said.contains("lenses"), "{said}");
}
