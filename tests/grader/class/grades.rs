//! Points, by the rules of the course.

use raybook_grader::class::course::Course;
use raybook_grader::class::grades::{Grade, Known, Sheet, points};
use raybook_grader::class::record::{Marked, Standing};
use raybook_grader::class::when::Timestamp;
use std::collections::BTreeSet;
use std::path::Path;

const COURSE: &str = "
    partial = 0.5
    [late]
    grace_minutes = 10
    per_day = 0.1
    at_most = 0.3
    [solve]
    costs = 0.75
    [[chapter]]
    chapter = 'ch01'
    weight = 2
    due = 2026-11-01T00:00:00Z
    exercises = { ray_at = 3 }
    bonus = { camera_ray = 1 }
    [[chapter]]
    chapter = 'ch04'";

fn grade(course: &str, came: i64, taken: &[&str], results: &[(&str, Standing, [u64; 2])]) -> Grade {
    let course = Course::read(Path::new("course.toml"), course).expect("it is right");
    let mut known = Known::new();
    for (exercise, standing, right) in results {
        let mut result = Marked::without_cases(*standing, "");
        result.right = *right;
        known.insert(("print".to_owned(), (*exercise).to_owned()), result);
    }
    let due: Timestamp = "2026-11-01T00:00:00Z".parse().expect("an instant");
    let sheet = Sheet {
        student: "eve".to_owned(),
        print: Ok("print".to_owned()),
        language: "python".to_owned(),
        taken: taken.iter().map(|&name| name.to_owned()).collect(),
        tries: BTreeSet::new(),
        notes: Vec::new(),
        handed_in: Some(Timestamp::utc(due.seconds + came)),
    };
    Grade::of(&course, sheet, &known)
}

#[test]
fn points_follow_the_rules() {
    use Standing::{NotGraded, NotStarted, Right, Wrong};
    let all = |ray_at, right| {
        vec![
            ("ray_at", ray_at, right),
            ("camera_ray", Right, [40, 40]),
            ("plane_hit", NotStarted, [0, 40]),
        ]
    };
    for (what, came, taken, results, expected) in [
        (
            "in time, with a bonus",
            0,
            &[][..],
            all(Right, [40, 40]),
            8.0,
        ),
        (
            "half of the cases count half of the half",
            0,
            &[],
            all(Wrong, [20, 40]),
            2.0 * (0.75 + 1.0),
        ),
        ("within the grace", 600, &[], all(Right, [40, 40]), 8.0),
        ("a day begun", 601, &[], all(Right, [40, 40]), 7.2),
        (
            "no more than the most is lost",
            30 * 86400,
            &[],
            all(Right, [40, 40]),
            8.0 * 0.7,
        ),
        (
            "a reference costs",
            0,
            &["ray_at"],
            all(Right, [40, 40]),
            2.0 * (0.75 + 1.0),
        ),
        (
            "what is not graded is no zero, but nothing yet",
            0,
            &[],
            all(NotGraded, [0, 0]),
            2.0,
        ),
    ] {
        let grade = grade(COURSE, came, taken, &results);
        assert!(
            (grade.points() - expected).abs() < 1e-9,
            "{what}: {}",
            grade.points()
        );
        assert!(
            (grade.of_points() - 7.0).abs() < 1e-9,
            "{what}: a bonus is on top"
        );
        assert_eq!(grade.is_complete(), results[0].1 != NotGraded, "{what}");
    }
}

#[test]
fn each_day_begun_counts() {
    let course = COURSE.replace("grace_minutes = 10", "grace_minutes = 1");
    for (seconds, days) in [
        (-5, 0),
        (0, 0),
        (60, 0),
        (61, 1),
        (86400, 1),
        (86401, 2),
        (172_800, 2),
    ] {
        let grade = grade(&course, seconds, &[], &[]);
        assert_eq!(grade.chapters[0].days_late, days, "{seconds} s");
    }
    assert_eq!(
        ["1", "0.33", "2.5", "0"].map(str::to_owned),
        [1.0, 1.0 / 3.0, 2.5, -0.001].map(points)
    );
}
