//! Golden files are edited by people: `bless` completes them, and says what is wrong where.

use crate::common::command::raybook;
use raybook_common::project;
use raybook_grader::examine::visible_rng;
use raybook_grader::{cases, golden};
use std::fs;
use std::path::{Path, PathBuf};

const FILE: &str = "golden/ch03_sphere/sphere_hit.txt";

/// A lecturer's folder with the golden file of an exercise, in which a line was changed or added.
fn lecturer(line: &str) -> (tempfile::TempDir, PathBuf) {
    let home = tempfile::tempdir().expect("a temporary folder");
    let file = home.path().join(FILE);
    let kept = fs::read_to_string(project(FILE)).expect("the golden file is there");
    let (head, rest) = kept.split_once("head on").expect("the first case");
    fs::create_dir_all(file.parent().expect("a folder")).expect("it can be made");
    fs::write(&file, format!("{head}{line}\nhead on{rest}")).expect("it can be written");
    (home, file)
}

fn bless(home: &Path, options: &[&str]) -> (i32, String) {
    raybook(home, &[&["bless", "sphere_hit"], options].concat())
}

#[test]
fn a_named_case_without_an_answer_is_completed_and_asked() {
    let (home, file) = lecturer("through a pea | 0 0 -3  0 0 1  0 inf  0 0 0  0.5");
    let before = fs::read_to_string(&file).expect("it is there");
    let (code, said) = bless(home.path(), &["--check"]);
    assert!(
        code == 1 && said.contains("not complete, from line 5 on"),
        "{said}"
    );
    assert_eq!(
        fs::read_to_string(&file).expect("it is there"),
        before,
        "--check writes nothing"
    );
    let (code, said) = bless(home.path(), &[]);
    let examiner = cases::find("sphere_hit").expect("an exercise");
    let given = examiner.cases(&mut visible_rng("sphere_hit")).cases.len();
    let cases = format!("{} cases", given + 1);
    assert!(code == 0 && said.contains(&cases), "{said}");
    let after = fs::read_to_string(&file).expect("it is there");
    let line = after.lines().nth(4).expect("a line");
    assert!(
        line.starts_with("through a pea  ")
            && line.ends_with("| 0 0 -3  0 0 1  0 inf  0 0 0  0.5 = 2.5"),
        "{line}"
    );
    assert_eq!(
        after.lines().count(),
        before.lines().count(),
        "the others stay"
    );
    assert_eq!(bless(home.path(), &["--check"]).0, 0, "now it is complete");
    let (code, all) = raybook(home.path(), &["bless", "--check"]);
    assert!(
        code == 0 && all.lines().count() == 1,
        "without a name, the files that are there: {all}"
    );

    let golden = home.path().join("golden");
    let golden = golden.to_str().expect("it is text");
    let (_, said) = raybook(home.path(), &["exercise", "sphere_hit", "--golden", golden]);
    assert!(
        said.contains(&format!("{cases} are visible")) && said.contains("(through a pea)"),
        "{said}"
    );
    #[cfg(unix)]
    {
        let program = home.path().join("answers");
        crate::common::executable::script(
            &program,
            "#!/bin/sh\nwhile read -r line; do echo '= 2.5'; done\n",
        );
        let options = [
            "check",
            "sphere_hit",
            "--program",
            "answers",
            "--golden",
            golden,
        ];
        let (code, said) = raybook(home.path(), &[&options[..], &["--case", "1"]].concat());
        assert!(
            code == 0 && said.contains("case 1: through a pea"),
            "{said}"
        );
    }
    let (code, said) = raybook(home.path(), &["exercise", "plane_hit", "--golden", golden]);
    assert!(code == 2 && said.contains("no golden file here"), "{said}");
}

#[test]
fn other_right_answers_stay_and_a_wrong_first_one_is_corrected() {
    let (home, file) = lecturer("two answers | 0 0 -3  0 0 1  0 inf  0 0 0  1 = 5 = 2.0 = none");
    assert_eq!(bless(home.path(), &[]).0, 0);
    let after = fs::read_to_string(&file).expect("it is there");
    assert!(after.contains("0 0 0  1 = 2 = 2 = none\n"), "{after}");
}

#[test]
fn what_is_wrong_is_said_with_its_line_and_column() {
    for (line, parts) in [
        (
            "a typo | 0 0 -3  0 0 1  0 inf  0 0 zero  1",
            &[
                "line 5, column 36",
                "word 11",
                "`center.z`, a number, but is `zero`",
                "origin.x origin.y",
            ][..],
        ),
        (
            "cut off | 0 0 -3  0 0 1 = 2",
            &["line 5, column 24", "word 7, `within.min`, is missing"],
        ),
        (
            "the answer | 0 0 -3  0 0 1  0 inf  0 0 0  1 = two",
            &[
                "line 5, column 47",
                "in the answer, word 1 should be `t`, a number, but is `two`",
            ],
        ),
        (
            "inside out | 0 0 -3  0 0 1  0 inf  0 0 0  -1",
            &["line 5, column 43", "`radius` is -1, and should be above 0"],
        ),
        (
            "nowhere | 0 0 -3  0 0 1  0 nan  0 0 0  1",
            &["line 5, column 28", "`within` is NaN"],
        ),
        (
            "too long | 0 0 -3  0 0 2  0 inf  0 0 0  1",
            &[
                "line 5, column 20",
                "`direction` has length 2.0000, and should have length 1",
            ],
        ),
        ("no bar", &["line 5, column 1", "name | question"]),
        (
            "random hit | 0 0 -3  0 0 1  0 inf  0 0 0  1",
            &["line 5", "names that begin with `random `"],
        ),
        (
            "from the centre | 0 0 -3  0 0 1  0 inf  0 0 0  1",
            &["line 7", "another name"],
        ),
    ] {
        let (home, file) = lecturer(line);
        let before = fs::read_to_string(&file).expect("it is there");
        let (code, said) = bless(home.path(), &[]);
        assert_eq!(code, 2, "{line}: {said}");
        assert!(said.contains("sphere_hit.txt"), "the file is named: {said}");
        for part in parts {
            assert!(said.contains(part), "{line} says `{part}`: {said}");
        }
        assert_eq!(
            fs::read_to_string(&file).expect("it is there"),
            before,
            "nothing is written"
        );
    }
}

#[test]
fn every_golden_file_that_the_command_carries_can_be_read() {
    for examiner in cases::all() {
        assert!(
            examiner
                .golden()
                .starts_with(&format!("# {}: ", examiner.name())),
            "{}: its own file",
            examiner.name()
        );
        let named = golden::named(examiner.asked(), examiner.golden());
        assert!(
            named.is_ok_and(|named| named.len() >= 6),
            "{}",
            examiner.name()
        );
    }
}
