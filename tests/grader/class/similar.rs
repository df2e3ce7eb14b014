//! Hand-ins that are nearly the same.

use super::{Course, RIGHT, text};
use rand::RngExt;
use raybook::math::pcg;

#[test]
fn nearly_identical_hand_ins_are_found() {
    let course =
        Course::new("[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at', 'camera_ray']\n");
    // Long enough to be compared, and not what everybody was given.
    let own = |seed: u64| -> String {
        let signs = ["+", "-", "*", "/", "%", "**", "//"];
        let mut rng = pcg::stream(seed, 0);
        let mut body = String::new();
        for _ in 0..60 {
            body += "    value = other";
            for _ in 0..10 {
                let sign = signs[rng.random_range(0..signs.len())];
                let word = ["value", "3.5"][rng.random_range(0..2)];
                body.extend([" ", sign, " ", word]);
            }
            body += "\n";
        }
        format!("def own(value, other):\n{body}    return value\n{RIGHT}")
    };
    course.hand_in("ann/answer.py", &own(1));
    let renamed = own(1)
        .replace("value", "amount")
        .replace("other", "rest")
        .replace("def own", "# mine\ndef mine");
    course.hand_in("ben/answer.py", &renamed);
    course.hand_in("cem/answer.py", &own(3));
    for i in 0..6 {
        let reader = raybook_grader::reader::python::program(
            raybook_grader::cases::find("ray_at")
                .expect("it is there")
                .asked(),
        );
        course.hand_in(&format!("given{i}/answer.py"), &format!("# {i}\n{reader}"));
    }
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    let similar = text(&course.path("results/similar.csv"));
    let lines: Vec<_> = similar.lines().skip(1).collect();
    assert_eq!(
        lines.len(),
        1,
        "renaming hides nothing, and what is given is nobody's: {similar}"
    );
    assert!(lines[0].starts_with("ann,ben,"), "{similar}");
}
