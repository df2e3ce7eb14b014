//! A student's first hour in Python and in C++, without Rust: new, check, write, check, hint, solve.

use super::{WITHOUT_RUST, new, there_is};
use crate::common::command::raybook_with;
use raybook_grader::cases;
use raybook_grader::language::Language;
use raybook_grader::starter::reference_file;
use std::fs;
use std::path::Path;

/// A wrong `sphere_hit`, which prints, in the place of its stub.
struct Far {
    stub: &'static str,
    body: &'static str,
}

const PYTHON: Far = Far {
    stub: "raise NotImplementedError(\"sphere_hit\")",
    body: "import math
    print('radius', radius)
    o = ray.origin - center
    b = o.dot(ray.direction)
    under = b * b - o.dot(o) + radius * radius
    t = -b + math.sqrt(under) if under >= 0 else math.inf
    return t if within.min < t < within.max else None",
};

const CPP: Far = Far {
    stub: "todo(\"sphere_hit\", ray, within, center, radius);",
    body: "std::cerr << \"radius \" << radius << std::endl;
    const Vec3 o = ray.origin - center;
    const double b = dot(o, ray.direction);
    const double under = b * b - dot(o, o) + radius * radius;
    const double t = -b + std::sqrt(under);
    if (under >= 0 && within.min < t && t < within.max) return t;
    return std::nullopt;",
};

#[test]
fn the_first_hour_in_python() {
    if there_is("python3") {
        first_hour(Language::Python, "py", &PYTHON);
    }
}

#[test]
fn the_first_hour_in_cpp() {
    if there_is("make") && there_is("g++") {
        first_hour(Language::Cpp, "cpp", &CPP);
    }
}

fn first_hour(language: Language, extension: &str, far: &Far) {
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "my-rays", language);
    let say = |arguments: &[&str]| raybook_with(&folder, arguments, &[WITHOUT_RUST]);
    let file = |chapter: &str| format!("{chapter}.{extension}");

    let (code, said) = say(&["check", "--plain"]);
    let none = format!("0 of {}", cases::all().len());
    assert!(
        code == 1 && said.contains(&none) && !said.contains("wrong "),
        "nothing is started: {said}"
    );
    let next = format!("Next: write ray_at in {}", file("ch01_rays"));
    assert!(said.contains(&next), "and the next step is said: {said}");

    let rays = file("ch01_rays");
    let solution = reference_file(language, &rays).expect("there is a solution");
    fs::write(folder.join(&rays), solution).expect("it can be written");
    let (code, said) = say(&["check", "ray_at", "camera_ray"]);
    assert_eq!(code, 0, "chapter 1 is right: {said}");
    assert!(
        folder.join(".raybook/camera_ray.png").is_file(),
        "and a picture is made of the answers"
    );

    write(&folder.join(file("ch03_sphere")), far);
    let (code, said) = say(&["check", "sphere_hit", "--plain"]);
    assert_eq!(code, 1, "it is wrong: {said}");
    for part in [
        "takes the far root",
        "| radius 1",
        "sphere_hit.png",
        "--case 1",
    ] {
        assert!(said.contains(part), "the feedback tells `{part}`: {said}");
    }
    let (_, said) = say(&["hint", "sphere_hit"]);
    assert!(
        said.contains("which of the two does the eye see"),
        "the hint is the mistake's: {said}"
    );
    let (code, said) = say(&[]);
    assert!(
        code == 0 && said.contains("wrong: sphere_hit"),
        "progress is kept: {said}"
    );

    let (code, said) = say(&["solve", "ch03"]);
    assert_eq!(code, 0, "{said}");
    let kept = folder.join(".raybook/yours").join(file("ch03_sphere"));
    assert!(kept.is_file(), "the student's own file is kept: {said}");
    let (code, said) = say(&["check", "3"]);
    assert_eq!(code, 0, "the reference is right: {said}");

    fs::write(folder.join(&rays), "def broken(").expect("the file can be written");
    let (code, said) = say(&["check", "ch01"]);
    assert!(
        code != 0 && said.contains(&format!("{rays}:1")),
        "the error's place is told: {code} {said}"
    );
}

/// Writes the function in the place of its stub.
fn write(path: &Path, far: &Far) {
    let text = fs::read_to_string(path).expect("the file is there");
    assert!(text.contains(far.stub), "it is not written yet");
    fs::write(path, text.replace(far.stub, far.body)).expect("the file can be written");
}
