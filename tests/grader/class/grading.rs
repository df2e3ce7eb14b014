//! A class from hand-ins to grades.

use super::{Course, KEY, RIGHT, text, visible_only, wrong_sign};
use raybook_grader::class::journal;
use raybook_grader::class::record::{Record, Standing};
use std::fs;

const COURSE: &str = "term = 'now'\npartial = 0.5\n[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at', 'camera_ray']\n";

const CPP: &str = r#"
#include "beside.hpp"
#include <iostream>
int main() {
    std::string name, word;
    while (std::cin >> name) {
        if (name != "ray_at") { std::getline(std::cin, word); std::cout << "= todo " << name << std::endl; continue; }
        double x[7];
        for (double& number : x) { std::cin >> word; number = std::stod(word); }
        std::cout << "= " << at(x, 0) << ' ' << at(x, 1) << ' ' << at(x, 2) << std::endl;
    }
}
"#;
const BESIDE: &str = "#include <string>\ndouble at(const double* x, int i);\n";
const BESIDE_CPP: &str = "#include \"beside.hpp\"\ndouble at(const double* x, int i) { return x[i] + x[6] * x[i + 3]; }\n";

/// In a folder within the hand-in, and with all that depends on how Python is started.
const WITHIN: &str = "\
from __future__ import annotations
assert 'sys' not in globals()
import dataclasses, pickle, sys
import above
@dataclasses.dataclass
class Point:
    x: float
assert pickle.loads(pickle.dumps(Point(1.0))) == Point(1.0)
assert sys.argv == [__file__] and __name__ == '__main__'
import beside
";

/// A class of every kind of hand-in.
fn class() -> Course {
    let course = Course::new(COURSE);
    course.hand_in("right/answer.py", RIGHT);
    course.hand_in("equal/answer.py", RIGHT);
    course.hand_in("module/main.py", "from beside import *\n");
    course.hand_in("module/beside.py", RIGHT);
    course.hand_in("within/src/main.py", WITHIN);
    course.hand_in("within/src/beside.py", &format!("# beside\n{RIGHT}"));
    course.hand_in("within/above.py", "");
    course.hand_in("lone.py", &format!("# alone\n{RIGHT}"));
    course.hand_in("wrong/answer.py", &wrong_sign());
    course.hand_in("memory/answer.py", &visible_only());
    course.hand_in("syntax/answer.py", "def x(:\n");
    course.hand_in("empty/notes.txt", "nothing");
    course.hand_in("cpp/main.cpp", CPP);
    course.hand_in("cpp/beside.hpp", BESIDE);
    course.hand_in("cpp/beside.cpp", BESIDE_CPP);
    course.hand_in(
        "broken/main.cpp",
        "int main() { return undeclared_name; }\n",
    );
    course.hand_in("peeks/main.cpp", &CPP.replace("beside.hpp", "/etc/passwd"));
    course.hand_in("each/ray_at.py", RIGHT);
    course.hand_in("each/camera_ray.py", "print('= todo')\n");
    course
}

#[test]
fn hand_ins_are_graded_at_the_same_time() {
    for (slow, fast) in [("a", "b"), ("b", "a")] {
        let course = Course::new(COURSE);
        let sleeps = format!("import time\ntime.sleep(2)\n{RIGHT}");
        course.hand_in(&format!("{slow}/answer.py"), &sleeps);
        course.hand_in(&format!("{fast}/answer.py"), &wrong_sign());
        let (code, said) = course.grade(&["--jobs", "2"]);
        assert_eq!(code, Some(0), "{said}");
        let told = journal::read(&course.path("results")).expect("the journal");
        let records = told.records.iter().filter_map(Record::from_json);
        let standings = records.map(|record| record.result.standing);
        let ended = standings.filter(|&standing| standing != Standing::NotStarted);
        assert_eq!(
            ended.collect::<Vec<_>>(),
            [Standing::Wrong, Standing::Right],
            "the fast one, {fast}, does not wait for the slow one"
        );
    }
}

#[test]
fn a_class_is_graded() {
    let course = class();
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    // A right one of two exercises, each a point.
    for student in ["right", "equal", "module", "within", "lone", "cpp", "each"] {
        assert_eq!(
            course.points(student),
            1.0,
            "{student}: {:#}",
            course.student(student)
        );
        assert_eq!(course.standing(student, "ray_at"), "right", "{student}");
        assert_eq!(
            course.standing(student, "camera_ray"),
            "not started",
            "{student}: {:#}",
            course.student(student)
        );
    }
    for (student, standing) in [
        ("wrong", "wrong"),
        ("memory", "wrong"),
        ("syntax", "wrong"),
        ("broken", "does not compile"),
        ("peeks", "does not compile"),
        ("empty", "nothing"),
    ] {
        assert_eq!(course.standing(student, "ray_at"), standing, "{student}");
        assert!(
            course.points(student) < 0.5,
            "{student} has a part at the most"
        );
    }
    assert_eq!(
        course.points("memory"),
        0.0,
        "nothing for answers that were to be read"
    );
    let page =
        |student: &str| text(&course.path(&format!("results/students/{student}/index.html")));
    assert!(
        page("memory").contains("right on the visible cases only"),
        "{}",
        page("memory")
    );
    assert!(
        page("wrong").contains("It seems that your function"),
        "the mistake is recognised"
    );
    let is_drawn = |student: &str| {
        let page = page(student);
        page.contains("data:image/svg+xml")
            && page.contains("<code>ray_at</code>: the wrong case that is told")
    };
    assert!(is_drawn("wrong"), "the first wrong visible case is drawn");
    assert!(!is_drawn("memory"), "a hidden case never");
    assert!(page("wrong").len() < 64 << 10, "and takes little room");
    assert!(
        page("broken").contains("undeclared_name"),
        "what the compiler said"
    );
    assert!(
        page("empty").contains("refused") && !page("empty").contains("not graded"),
        "a refused hand-in has no points, and not none yet"
    );
    assert!(
        !page("peeks").contains("root:"),
        "and not what it must not read"
    );
    // What students see tells nothing of hidden cases.
    for student in ["wrong", "memory"] {
        for file in ["index.html", "grade.json", "results.json"] {
            let told = text(&course.path(&format!("results/students/{student}/{file}")));
            assert!(
                !told.contains("random "),
                "{student}: {file} tells of a hidden case"
            );
            assert!(!told.contains(KEY), "and never of the key");
        }
    }
    let told = journal::read(&course.path("results")).expect("the journal");
    assert_eq!(told.damaged, 0);
    let hand_ins = 11; // of 13, two are equal and one is refused
    assert_eq!(
        told.records.len(),
        1 + 2 * hand_ins,
        "the key, and each exercise of each hand-in once"
    );
    assert!(
        !course.path("results/stage").exists(),
        "nothing of the hand-ins stays"
    );

    // Again: nothing is asked.
    let (code, said) = course.grade(&[]);
    assert!(code == Some(0) && said.contains(" 0 to grade"), "{said}");
    let again = journal::read(&course.path("results")).expect("the journal");
    assert_eq!(told, again);
}

#[test]
fn grades_are_the_same_in_parts_merged_by_concatenation() {
    let course = class();
    let (code, said) = course.grade(&["--jobs", "1"]);
    assert_eq!(code, Some(0), "{said}");
    let mut merged = Vec::new();
    for part in 1..=3 {
        let (code, said) = course.grade(&[
            "--shard",
            &format!("{part}/3"),
            "--out",
            &format!("part{part}"),
        ]);
        assert_eq!(code, Some(0), "{said}");
        assert!(
            !course.path(&format!("part{part}/grades.csv")).exists(),
            "a part writes its journal alone"
        );
        merged
            .extend(fs::read(course.path(&format!("part{part}/run.jsonl"))).expect("its journal"));
    }
    fs::create_dir(course.path("merged")).expect("a folder");
    fs::write(course.path("merged/run.jsonl"), merged).expect("it is merged");
    let (code, said) = course.grade(&["--out", "merged"]);
    assert!(
        code == Some(0) && said.contains(" 0 to grade"),
        "all is known: {said}"
    );
    assert_eq!(
        text(&course.path("merged/grades.csv")),
        text(&course.path("results/grades.csv"))
    );
    for wrong in ["0/3", "4/3", "1", "a/b"] {
        let (code, _) = course.grade(&["--shard", wrong]);
        assert_eq!(code, Some(2), "{wrong}");
    }
}

/// Those in C++ and in Rust, which take a while to compile, are in tests of their own.
#[test]
fn workbooks_in_python_are_graded() {
    let course = Course::new(COURSE);
    course.hand_in_starter("python");
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    let standing = course.standing("python", "ray_at");
    assert_eq!(standing, "not started", "{:#}", course.student("python"));
}
