//! Workbooks in Rust: each is built by itself, and of what is handed in only the library's sources count.

use super::{Course, text};
use raybook_grader::starter::{files, stub};
use raybook_workbook::anchor::Anchored;
use std::path::Path;

const COURSE: &str = "[solve]\ncosts = 0.5\n[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at']\n[[chapter]]\nchapter = 'ch03'\nexercises = ['sphere_hit']\n";

/// Hands in a workbook whose functions are rewritten so.
pub fn workbook(course: &Course, student: &str, rewrite: &dyn Fn(&Anchored<'_>) -> Option<String>) {
    for (path, bytes) in files(rewrite).expect("the anchors are right") {
        let text = String::from_utf8_lossy(&bytes);
        course.hand_in(&format!("{student}/my-rays/{}", path.display()), &text);
    }
}

/// The starter with the references of these functions.
pub fn with<'a>(names: &'a [&str]) -> impl Fn(&Anchored<'_>) -> Option<String> + 'a {
    move |function| {
        if names.contains(&function.name) {
            None
        } else {
            stub(function)
        }
    }
}

#[test]
fn workbooks_of_one_name_do_not_mix_and_what_else_is_handed_in_does_nothing() {
    let course = Course::new(COURSE);
    workbook(&course, "right", &with(&["ray_at"]));
    workbook(&course, "starter", &with(&[]));
    workbook(
        &course,
        "reference",
        &with(&["ray_at", "solve_quadratic", "sphere_hit"]),
    );
    course.hand_in("reference/my-rays/references-taken.txt", "ray_at\n");
    workbook(&course, "peeks", &with(&["ray_at"]));
    let lib = text(&course.path("hand-ins/peeks/my-rays/src/lib.rs"));
    course.hand_in(
        "peeks/my-rays/src/lib.rs",
        &format!("{lib}\n#[doc = include_str!(\"/etc/passwd\")]\npub mod nothing {{}}\n"),
    );
    // What would run while it is built, and what would answer for it.
    workbook(&course, "attacks", &with(&["ray_at"]));
    let forged = course.path("FORGED").display().to_string();
    let script = format!("fn main() {{ let _ = std::fs::write({forged:?}, \"x\"); panic!(); }}");
    for (path, text) in [
        ("build.rs", script.as_str()),
        (
            ".cargo/config.toml",
            "[build]\nrustc-wrapper = '/bin/false'\n",
        ),
        (
            "Cargo.toml",
            "[package]\nname = 'raybook'\nbuild = 'build.rs'\n[dependencies]\nserde = { git = 'https://example.org/x' }\n",
        ),
        ("rust-toolchain.toml", "[toolchain]\nchannel = 'nightly'\n"),
        (
            "workbook/src/bin/answer.rs",
            "fn main() { loop { println!(\"= 0 0 0\"); } }",
        ),
        ("workbook/src/lib.rs", "compile_error!(\"mine\");"),
    ] {
        course.hand_in(&format!("attacks/my-rays/{path}"), text);
    }
    // A folder where a file of ours lies.
    let table = "attacks/my-rays/src/shape/teapot.txt";
    std::fs::remove_file(course.path("hand-ins").join(table)).expect("it was given out");
    course.hand_in(&format!("{table}/x.rs"), "");
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    for (student, ray_at, sphere_hit, points) in [
        ("right", "right", "not started", 1.0),
        ("starter", "not started", "not started", 0.0),
        ("reference", "right", "right", 1.0), // both were taken: one is in the record, the other found
        ("attacks", "right", "not started", 1.0),
        ("peeks", "does not compile", "does not compile", 0.0),
    ] {
        let standings = (
            course.standing(student, "ray_at"),
            course.standing(student, "sphere_hit"),
        );
        assert_eq!(
            standings,
            (ray_at.to_owned(), sphere_hit.to_owned()),
            "{student}: {:#}",
            course.student(student)
        );
        assert_eq!(course.points(student), points, "{student}");
    }
    assert!(!Path::new(&forged).exists(), "no build script ran");
    let page = text(&course.path("results/students/peeks/index.html"));
    assert!(
        page.contains("include_str") && !page.contains("root:"),
        "{page}"
    );
    assert!(
        !page.contains(&course.home.path().display().to_string()),
        "nor where it was built"
    );
}

#[test]
fn references_are_given_out_as_the_course_says_and_recorded() {
    let course = Course::new(COURSE);
    let (code, said) = course.say(&["new", "mine"]);
    assert_eq!(code, Some(0), "{said}");
    std::fs::write(
        course.path("mine/course.toml"),
        COURSE.replace("costs", "allowed = false\ncosts"),
    )
    .expect("it is written");
    let (code, said) = course.say(&["solve", "ch01", "mine"]);
    assert!(
        code == Some(2) && said.contains("gives no references out"),
        "{said}"
    );
    assert!(!course.path("mine/references-taken.txt").exists());
    std::fs::write(course.path("mine/course.toml"), COURSE).expect("it is written");
    for _ in 0..2 {
        let (code, said) = course.say(&["solve", "ch01", "mine"]);
        assert_eq!(code, Some(0), "{said}");
        assert_eq!(
            text(&course.path("mine/references-taken.txt")),
            "camera_ray\nray_at\n"
        );
    }
}
