//! Workbooks in C++: what is as it was given out is compiled once for the class.

use super::{Course, own, text};
use crate::hostile::there_is;
use raybook_grader::language::Language;
use raybook_grader::starter::{cpp, reference_file};

const LIMITS: &str = "[limits]\nanswer_seconds = 1\nexercise_seconds = 2\n";

/// Hands in the starter, with these files in the place of its own.
fn workbook(course: &Course, student: &str, changed: &[(&str, &str)]) {
    for (path, bytes) in cpp::files() {
        let own = changed.iter().find(|(name, _)| path.as_os_str() == *name);
        let given = String::from_utf8_lossy(&bytes);
        let text = own.map_or(&*given, |(_, text)| text);
        course.hand_in(&format!("{student}/my-rays/{}", path.display()), text);
    }
}

#[test]
fn what_was_given_out_is_linked_and_what_was_changed_is_compiled() {
    if !there_is("g++") {
        return;
    }
    // With exercises of the instructor's own, which no workbook here answers.
    let course = own::course(own::ANSWERS, &format!("{LIMITS}{}", own::COURSE));
    let solved = reference_file(Language::Cpp, "ch01_rays.cpp").expect("there is a solution");
    let wrong = solved.replace(
        "ray_at(const Ray& ray, double t) {",
        "ray_at(const Ray& ray, double t) { t = -t;",
    );
    assert_ne!(solved, wrong, "the sign is changed");
    let answers = "int main() { for (;;) {} }\n";
    let broken = "#error my own\n";
    workbook(&course, "starter", &[]);
    workbook(&course, "solved", &[("ch01_rays.cpp", &solved)]);
    workbook(&course, "wrong", &[("ch01_rays.cpp", &wrong)]);
    workbook(
        &course,
        "elsewhere",
        &[("ch01_rays.cpp", &solved), ("ch02_hdr.cpp", broken)],
    );
    // What a compiler says that the system ended.
    let words =
        "#error Killed signal terminated program cc1plus: No space left on device, signal: 9\n";
    workbook(&course, "pretends", &[("ch01_rays.cpp", words)]);
    let embeds = "asm(\".data\\nt: .incbin \\\"/etc/passwd\\\"\\n.text\");\n";
    workbook(&course, "embeds", &[("ch01_rays.cpp", embeds)]);
    workbook(
        &course,
        "main",
        &[("ch01_rays.cpp", &solved), ("raybook/answer.cpp", answers)],
    );
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    for (student, standing) in [
        ("starter", "not started"),
        ("solved", "right"),
        ("wrong", "wrong"),
        ("elsewhere", "does not compile"),
        ("pretends", "does not compile"),
        ("embeds", "does not compile"),
        ("main", "wrong"),
    ] {
        assert_eq!(
            course.standing(student, "ray_at"),
            standing,
            "{student}: {:#}",
            course.student(student)
        );
    }
    assert_eq!(course.standing("starter", "lens_power"), "not started");
    let page = text(&course.path("results/students/starter/index.html"));
    assert!(page.contains("no file of the hand-in answers"), "{page}");
}
