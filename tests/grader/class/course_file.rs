//! The course file: what is wrong in it is said with its place.

use super::{Course, text};
use raybook_grader::cases;
use raybook_grader::class::course::{Course as Plan, template};
use std::path::Path;

#[test]
fn a_new_course_file_grades_everything() {
    let course = Course::new("");
    let (code, said) = course.say(&["course", "new", "new.toml"]);
    assert_eq!(code, Some(0), "{said}");
    let plan =
        Plan::read(Path::new("new.toml"), &text(&course.path("new.toml"))).expect("it is right");
    assert_eq!(
        plan.examiners().len(),
        cases::all().len(),
        "all exercises count"
    );
    assert_eq!(plan.reachable(), cases::all().len() as f64, "a point each");
    let (code, said) = course.say(&["course", "new", "new.toml"]);
    assert!(code == Some(2) && said.contains("there already"), "{said}");
    let (code, said) = course.say(&["course", "show", "new.toml"]);
    assert!(code == Some(0) && said.contains("sphere_hit"), "{said}");
    // What the file says of settings that are missing is true.
    let whole = template();
    let bare = whole
        .lines()
        .filter(|line| line.starts_with("[[chapter]]") || line.starts_with("chapter ="))
        .collect::<Vec<_>>();
    let bare = Plan::read(Path::new("bare.toml"), &bare.join("\n")).expect("it is right");
    assert_eq!(
        (
            plan.partial,
            plan.late,
            plan.solve,
            plan.limits,
            plan.languages
        ),
        (
            bare.partial,
            bare.late,
            bare.solve,
            bare.limits,
            bare.languages
        )
    );
}

#[test]
fn what_is_wrong_is_said_with_its_place() {
    for (text, place, words) in [
        ("", "1:1", "nothing is graded"),
        ("points = ", "1:", "string values must be quoted"),
        ("title = 3", "1:9", "`title` must be a text in quotes"),
        ("partial = 1.5", "1:11", "a number from 0 to 1"),
        (
            "[[chapter]]\nchapter = 32",
            "2:11",
            "a whole number from 1 to",
        ),
        ("points = nan", "1:10", "a number from 0"),
        ("languages = ['pyton']", "1:14", "did you mean `python`"),
        (
            "[late]\nper_dya = 0.1\n[[chapter]]\nchapter='1'",
            "2:1",
            "did you mean `per_day`",
        ),
        (
            "[[chapter]]\nchapter = 'ch03_spher'",
            "2:11",
            "did you mean `ch03_sphere`",
        ),
        ("[[chapter]]\nweight = 2", "1:1", "which chapter?"),
        (
            "[[chapter]]\nchapter = 'ch03'\nexercises = ['sphere_hti']",
            "3:14",
            "did you mean `sphere_hit`",
        ),
        (
            "[[chapter]]\nchapter = 'ch01'\nexercises = ['sphere_hit']",
            "3:14",
            "exercise in ch01_rays",
        ),
        (
            "[[chapter]]\nchapter = 'ch01'\nexercises = { ray_at = -1 }",
            "3:24",
            "`ray_at` must be a number",
        ),
        (
            "[[chapter]]\nchapter = 'ch01'\nexercises = 'ray_at'",
            "3:13",
            "a list of names",
        ),
        (
            "[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at']\nbonus = ['ray_at']",
            "4:10",
            "ray_at counts already",
        ),
        (
            "[[chapter]]\nchapter = 'ch01'\n[[chapter]]\nchapter = true",
            "4:11",
            "a text in quotes",
        ),
        (
            "[[chapter]]\nchapter = 'ch01'\n[[chapter]]\nchapter = 'rays'",
            "3:1",
            "graded twice",
        ),
        (
            "[[chapter]]\nchapter = 'ch01'\ndue = 2026-11-30",
            "3:7",
            "an offset from UTC",
        ),
        (
            "[[chapter]]\nchapter = 'ch01'\ndeu = 2026-11-30",
            "3:1",
            "did you mean `due`",
        ),
        ("chapter = 'ch01'", "1:11", "a list of tables"),
        (
            "titel = 'x'\n[[chapter]]\nchapter='1'",
            "1:1",
            "did you mean `title`",
        ),
    ] {
        let error = Plan::read(Path::new("course.toml"), text)
            .expect_err(text)
            .to_string();
        assert!(
            error.starts_with(&format!("course.toml:{place}")) && error.contains(words),
            "{text}: {error}"
        );
    }
}

#[test]
fn no_text_makes_it_panic() {
    let whole = template();
    for cut in 0..whole.len() {
        if let Some(part) = whole.get(..cut) {
            let _ = Plan::read(Path::new("course.toml"), part);
        }
    }
    for deep in [
        "[".repeat(100_000),
        "a = ".to_owned() + &"{a=".repeat(100_000),
    ] {
        assert!(Plan::read(Path::new("course.toml"), &deep).is_err());
    }
}
