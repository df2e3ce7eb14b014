//! A picture that is right is drawn once, and again as soon as something is wrong with it, with its file, or with the function.

use super::{new, there_is};
use crate::common::command::raybook_with;
use raybook_common::project;
use raybook_grader::cases;
use raybook_grader::language::Language;
use std::fs;
use std::path::Path;

/// Counts the questions that a workbook's program is asked.
const COUNTING: &str = "language = \"python\"\nrun = \"sh counting\"\n";

/// As [`COUNTING`] runs it.
const SCRIPT: &str = "tee -a questions | exec python3 answer.py\n";

/// How many questions there were since the last time.
fn asked(folder: &Path) -> usize {
    let file = folder.join("questions");
    let questions = fs::read_to_string(&file).expect("the program was asked");
    fs::remove_file(file).expect("it is there");
    questions.lines().count()
}

#[test]
fn a_picture_that_is_right_is_not_drawn_again() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let put = |file: &str, text: &[u8]| fs::write(folder.join(file), text).expect("it is written");
    put("raybook.toml", COUNTING.as_bytes());
    put("counting", SCRIPT.as_bytes());
    let solution = project("tests/solutions/python/ch03_sphere.py");
    let solution = fs::read_to_string(solution).expect("it is there");
    put("ch03_sphere.py", solution.as_bytes());
    let check = |more: &[&str]| {
        let words = [&["check", "sphere_hit", "--plain"], more].concat();
        let (code, said) = raybook_with(&folder, &words, &[]);
        (code, said, asked(&folder))
    };
    let picture = || fs::read(folder.join(".raybook/sphere_hit.png")).expect("it is drawn");
    let size = cases::find("sphere_hit").and_then(|one| one.picture(0));
    let size = size.expect("it has a picture");
    let pixels = (size.width * size.height) as usize;

    let (code, said, all) = check(&[]);
    assert!(code == 0 && !said.contains("drawn before"), "{said}");
    let right = picture();
    let (code, said, some) = check(&[]);
    assert!(code == 0 && said.contains("png, drawn before"), "{said}");
    assert_eq!(right, picture(), "it is as it was");
    let left_out = all - some;
    assert!(
        10 * left_out > 9 * pixels && left_out < pixels,
        "a few of {pixels} pixels are asked: {left_out} are not"
    );

    let (code, said, with_scores) = check(&["--json"]);
    assert!(
        code == 0 && said.contains("\"passed\": true"),
        "{said:.300}"
    );
    assert_eq!(with_scores, all, "whoever asks for points has them");

    // Right in every case: only the picture's rays start here.
    let wrong = solution.replace(
        "def sphere_hit(",
        "def sphere_hit(ray, *others):
    here = tuple(ray.origin) == (0, 0, 3) and ray.direction.x > 0.1
    return None if here else right(ray, *others)


def right(",
    );
    put("ch03_sphere.py", wrong.as_bytes());
    let (code, said, _) = check(&[]);
    assert!(
        code == 1 && said.contains("the cases are right, the picture is not"),
        "{said}"
    );
    assert_ne!(right, picture(), "the wrong picture is shown");
    put("ch03_sphere.py", solution.as_bytes());
    let (code, said, again) = check(&[]);
    assert!(code == 0 && !said.contains("drawn before"), "{said}");
    assert_eq!((again, picture()), (all, right.clone()), "all are asked");

    put(".raybook/sphere_hit.png", b"another picture");
    let (_, _, again) = check(&[]);
    assert_eq!(
        (again, picture()),
        (all, right),
        "the file was not that one"
    );
}
