//! The command used otherwise than in the first hour.

use crate::common::command::raybook;
use raybook_grader::library::reference;
use std::fs;

#[test]
fn wrong_usage_is_explained() {
    let home = tempfile::tempdir().expect("a temporary folder");
    fs::create_dir(home.path().join("full")).expect("a folder");
    for (file, text) in [
        ("full/file", ""),
        ("blank", ""),
        ("line", " \n"),
        ("short", "fifteen letters\n"),
    ] {
        fs::write(home.path().join(file), text).expect("a file");
    }
    for (arguments, part) in [
        (&["new", "full"][..], "not empty"),
        (&["check"], "raybook new"),
        (&["check", "sphere_hitt"], "sphere_hit"),
        (&["check", "--case", "0"], "--case"),
        (&["check", "--case", "1"], "one exercise"),
        (&["check", "--time-limit", "0"], "seconds"),
        (&["check", "--key-file", "blank"], "--student"),
        (&["check", "--key-file", "none", "--student", "7"], "none: "),
        (
            &["check", "--key-file", "blank", "--student", "7"],
            "it is empty",
        ),
        (
            &["check", "--key-file", "line", "--student", "7"],
            "it is empty",
        ),
        (
            &["check", "--key-file", "short", "--student", "7"],
            "shorter than 16 bytes, so that anybody could foresee the hidden cases. This makes a good key: head -c 32",
        ),
        (
            &["check", "--key-file", "-", "--student", "7"],
            "it is empty",
        ),
        (
            &["check", "--key-file", "blank", "--student", ""],
            "it is empty",
        ),
        (&["check", "--key", "secret"], "--key-file"),
        (
            &["check", "--program", "no/such/program"],
            "no/such/program",
        ),
        (&["solve"], "raybook new"),
        (&["bless"], "golden"),
        (&["exercise", "nothing"], "neither a chapter"),
        (&["new", "rays", "--language", "java"], "check --program"),
        (&["tour", "--seed", "-1"], "a whole number from 0 to"),
        (&["samplers", "--points", "-4"], "-4 is not in 1..=4096"),
    ] {
        let (code, said) = raybook(home.path(), arguments);
        assert!(
            code == 2 && said.contains(part),
            "{arguments:?} says `{part}`: {code} {said}"
        );
    }
}

#[test]
fn any_program_can_be_asked() {
    let (_, said) = raybook(&raybook_common::project(""), &["exercise", "ray_at"]);
    assert!(
        said.contains("ray_at origin.x origin.y origin.z direction.x")
            && said.contains("= point.x point.y point.z"),
        "{said}"
    );
    assert!(
        reference("ray_at").is_some(),
        "the reference is in the command"
    );
    #[cfg(unix)]
    {
        let home = tempfile::tempdir().expect("a temporary folder");
        let program = home.path().join("answers");
        crate::common::executable::script(
            &program,
            "#!/bin/sh\nwhile read -r name x y z rest; do echo \"= $x $y $z\"; done\n",
        );
        let (code, said) = raybook(home.path(), &["check", "ray_at", "--program", "answers"]);
        assert!(
            code == 1 && said.contains("1 of 40 cases right"),
            "only t = 0 is right: {said}"
        );
        assert!(
            said.contains("takes 0 for t"),
            "and it says what is wrong: {said}"
        );
        assert!(
            said.contains("Next: mend ray_at.\n"),
            "where, only the student knows: {said}"
        );
        let (code, said) = raybook(home.path(), &["hint", "ray_at", "--program", "answers"]);
        assert!(
            code == 0 && said.starts_with("ray_at: ") && !said.contains("src/"),
            "the program is asked, and a hint given: {said}"
        );
    }
}

#[cfg(unix)]
#[test]
fn what_keeps_a_program_from_answering_is_said() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(home.path().join(name), text).expect("a file");
    let script =
        |name: &str, text: &str| crate::common::executable::script(&home.path().join(name), text);
    script(
        "no-sign",
        "#!/bin/sh\nwhile read -r question; do echo 1 2 3; done\n",
    );
    write("not-executable", "#!/bin/sh\necho = 1 2 3\n");
    script("no-interpreter", "#!/no/such/python\n");
    for (program, part, expected) in [
        ("no-sign", "begin its line with `= `", 1),
        ("not-executable", "chmod +x", 2),
        ("no-interpreter", "its first line names", 2),
        ("not-there", "not-there: cannot be run", 2),
    ] {
        let (code, said) = raybook(home.path(), &["check", "ray_at", "--program", program]);
        assert!(code == expected && said.contains(part), "{program}: {said}");
    }
}
