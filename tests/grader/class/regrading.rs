//! What is graded again: by other hidden cases, or by other rules, of which a preview tells who changes.

use super::{Course, KEY, RIGHT, text, wrong_sign};
use std::fs;

const COURSE: &str = "term = 'now'\npartial = 0.5\n[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at', 'camera_ray']\n";

#[test]
fn other_hidden_cases_for_another_term_or_key() {
    let course = Course::new(COURSE);
    course.hand_in("right/answer.py", RIGHT);
    let asked = |said: &str| said.contains(", 1 to grade");
    assert!(asked(&course.grade(&[]).1), "at first");
    assert!(!asked(&course.grade(&[]).1), "known");
    fs::write(course.path("key"), "another key of a course").expect("it is written");
    let files = || {
        ["run.jsonl", "class.json", "grades.csv"]
            .map(|file| text(&course.path("results").join(file)))
    };
    let before = files();
    let (code, said) = course.grade(&[]);
    assert!(
        code == Some(2) && said.contains("another course key") && said.contains("--out"),
        "{said}"
    );
    assert_eq!(files(), before, "nothing of it changes");
    fs::remove_file(course.path("results/class.json")).expect("it was there");
    let (code, said) = course.grade(&[]);
    assert!(
        code == Some(2) && said.contains("another course key"),
        "the journal knows, where the first run was interrupted or was a part: {said}"
    );
    assert!(asked(&course.grade(&["--out", "others"]).1), "another key");
    fs::remove_dir_all(course.path("results")).expect("it was there");
    assert!(asked(&course.grade(&[]).1), "everything, as is said");
    fs::write(course.path("course.toml"), COURSE.replace("now", "later")).expect("it is written");
    assert!(asked(&course.grade(&[]).1), "another term");
    for (file, text, words) in [
        ("key", "\n", "it is empty"),
        ("course.toml", "x = 1", "no field `x`"),
    ] {
        fs::write(course.path(file), text).expect("it is written");
        let (code, said) = course.grade(&[]);
        assert!(code == Some(2) && said.contains(words), "{said}");
        fs::write(course.path("key"), KEY).expect("it is written");
    }
}

#[test]
fn regrading_previews_who_changes_and_why() {
    let course = Course::new(COURSE);
    course.hand_in("right/answer.py", RIGHT);
    course.hand_in("wrong/answer.py", &wrong_sign());
    fs::write(course.path("times.csv"), "student,time\nright,2026-11-02T00:00:01Z\nwrong,2026-10-01T00:00:00Z\nnobody,2026-10-01T00:00:00Z\n").expect("times");
    let (code, said) = course.grade(&["--times", "times.csv"]);
    assert!(
        code == Some(0) && said.contains("nobody, of whom there is no hand-in"),
        "{said}"
    );
    let grades = || text(&course.path("results/grades.csv"));
    let before = grades();

    let other = "term = 'now'\npartial = 0\n[late]\nper_day = 0.25\n[[chapter]]\nchapter = 'ch01'\ndue = 2026-11-01T00:00:00Z\nexercises = { ray_at = 4, camera_ray = 1 }\n";
    fs::write(course.path("other.toml"), other).expect("it is written");
    let (code, said) = course.say(&["regrade", "results", "--course", "other.toml"]);
    assert_eq!(code, Some(0), "{said}");
    // Two days begun cost half of four points.
    for words in [
        "right: 1 of 2 → 2 of 5",
        "ray_at: 1 → 4",
        "days late of ch01_rays: nothing → 2",
        "→ 0 of 5",
        "2 students have other points",
        "Nothing is written",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    assert_eq!(grades(), before, "a preview writes nothing");
    let (code, said) = course.say(&["regrade", "results", "--course", "other.toml", "--write"]);
    assert_eq!(code, Some(0), "{said}");
    assert_eq!((course.points("right"), course.points("wrong")), (2.0, 0.0));
    let (_, said) = course.say(&["regrade", "results", "--course", "other.toml"]);
    assert!(said.contains("no grade changes"), "{said}");

    // Grading does not change what was written, either.
    let written = grades();
    let (code, said) = course.grade(&["--times", "times.csv"]);
    assert!(
        code == Some(1)
            && said.contains("right: 2 of 5 → 1 of 2")
            && said.contains("nothing is written"),
        "{said}"
    );
    assert_eq!(grades(), written);
    let (code, said) = course.say(&["regrade", "nowhere", "--course", "other.toml"]);
    assert!(code == Some(2) && said.contains("no such folder"), "{said}");
    fs::write(course.path("times.csv"), "student,time\nright,soon\n").expect("times");
    let (code, said) = course.grade(&["--times", "times.csv"]);
    assert!(
        code == Some(2) && said.contains("times.csv:2: this must be a date"),
        "{said}"
    );
}
