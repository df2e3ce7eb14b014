//! What confused newcomers: words that mean two things, slips of the fingers, long lists, silence, and what comes next.

use crate::common::command::raybook;
use raybook_grader::prints::{abbreviated, first_difference};
use std::fs;
use std::path::Path;

/// In a folder that is no workbook.
fn say(arguments: &[&str]) -> (i32, String) {
    let home = tempfile::tempdir().expect("a temporary folder");
    raybook(home.path(), arguments)
}

#[test]
fn an_exercise_goes_before_a_chapter_of_its_name() {
    let (code, said) = say(&["exercise", "phong"]);
    assert!(
        code == 0 && said.starts_with("phong\n") && !said.contains("\nblinn_phong\n"),
        "{said}"
    );
    for chapter in [&["exercise", "chapter", "phong"][..], &["exercise", "ch12"]] {
        let (code, said) = say(chapter);
        assert!(
            code == 0 && said.contains("\nblinn_phong\n"),
            "{chapter:?}: {said}"
        );
    }
    for chapter in ["4", "ch4", "ch04", "plane", "ch04_plane"] {
        let (code, said) = say(&["exercise", chapter]);
        assert!(
            code == 0 && said.starts_with("plane_hit\n"),
            "{chapter}: {said}"
        );
    }
    let (code, said) = say(&["exercise", "chapter"]);
    assert!(code == 2 && said.contains("which chapter?"), "{said}");
}

#[test]
fn a_workbook_goes_before_a_chapter_of_its_name() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for name in ["rays", "mesh"] {
        let (code, said) = raybook(home.path(), &["new", name, "--language", "python"]);
        assert_eq!(code, 0, "{said}");
        // Nothing is written in it yet; but it is found.
        let (code, said) = raybook(home.path(), &["check", "ray_at", name, "--plain"]);
        assert!(code == 1 && said.contains("ray_at"), "{name}: {said}");
        let (code, said) = raybook(home.path(), &["check", "chapter", name, "--plain"]);
        let meant = "this is not a workbook";
        assert!(
            code == 2 && said.contains(meant),
            "the chapter, here: {said}"
        );
    }
    // A folder that is no workbook does not hide a chapter.
    fs::create_dir(home.path().join("sphere")).expect("a folder");
    let (code, said) = raybook(home.path(), &["exercise", "sphere"]);
    assert!(code == 0 && said.contains("sphere_hit"), "{said}");
}

#[test]
fn a_slip_of_the_fingers_is_understood() {
    for (slip, meant) in [
        ("shpere_hit", "did you mean sphere_hit?"),
        ("bvh_closet", "did you mean bvh_closest?"),
        ("ch03_shere", "did you mean ch03_sphere?"),
        ("nothing", "`raybook exercise` lists them all"),
    ] {
        let (code, said) = say(&["check", slip]);
        assert!(code == 2 && said.contains(meant), "{slip}: {said}");
    }
}

#[test]
fn exercise_alone_lists_them() {
    let (code, said) = say(&["exercise"]);
    assert_eq!(code, 0, "{said}");
    assert!(
        said.contains("wide_closest") && said.lines().count() < 40,
        "{said}"
    );
}

#[test]
fn a_long_list_is_cut_where_the_answers_part() {
    assert_eq!(
        abbreviated("3  1 2  3 4  5 6", 1),
        "3  1 2  3 4  5 6",
        "it is short"
    );
    let long = |wrong: Option<usize>| {
        let number = |i| {
            if Some(i) == wrong {
                "9.5 7".to_owned()
            } else {
                format!("{i}.25 0.5")
            }
        };
        let points: Vec<_> = (0..100).map(number).collect();
        format!("100  {}", points.join("  "))
    };
    assert_eq!(first_difference(&long(Some(40)), &long(None)), 40);
    assert_eq!(first_difference(&long(None), &long(None)), 0);
    let shown = abbreviated(&long(Some(40)), 40);
    assert_eq!(
        shown,
        "… 9.5 7  41.25 0.5  42.25 0.5  43.25 0.5  44.25 0.5  45.25 0.5 …   (100 in all, these from 40 on)"
    );
    // The last elements, and a list of another length, are shown too.
    assert!(abbreviated(&long(None), 99).starts_with("… 99.25 0.5   (100 in all"));
    assert_eq!(first_difference(&long(None), "99  1 2"), 0);
    let words = "word ".repeat(200);
    assert!(
        abbreviated(&words, 0).len() <= words.len(),
        "what is no list is no list"
    );
}

#[cfg(unix)]
fn program(folder: &Path, text: &str) {
    crate::common::executable::script(&folder.join("answers"), text);
}

#[cfg(unix)]
#[test]
fn who_ignores_what_it_does_not_know_is_told_to_say_so() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let text = |other: &str| {
        format!(
            "#!/bin/sh\nwhile read -r name rest; do case $name in ray_at) echo '= 0 0 0';; *) {other};; esac; done\n"
        )
    };
    let check = ["check", "ch01", "--program", "answers", "--plain"];
    program(home.path(), &text(":"));
    let (_, said) = raybook(home.path(), &check);
    let advice = [
        "says nothing to `camera_ray`, nor to some others: let it answer `= todo`",
        "Then nobody waits for it, and what is not written counts as not started.",
    ];
    for part in advice {
        assert!(said.contains(part), "`{part}` is in: {said}");
    }
    program(home.path(), &text("echo \"= todo $name\""));
    let (_, said) = raybook(home.path(), &check);
    assert!(!said.contains("says nothing to"), "{said}");
    assert!(said.contains("not started camera_ray"), "{said}");
}

#[cfg(unix)]
#[test]
fn a_pixel_that_asks_for_a_whole_tree_is_told_by_its_command() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let text = "#!/bin/sh\nwhile read -r question; do echo '= 0 0 none'; done\n";
    program(home.path(), text);
    let check = ["check", "bvh_closest", "--program", "answers", "--plain"];
    let (code, said) = raybook(home.path(), &[&check[..], &["--pictures", "."]].concat());
    assert_eq!(code, 1, "{said}");
    assert!(
        said.contains("in full: raybook explain bvh_closest --pixel "),
        "{said}"
    );
    let longest = said.lines().map(str::len).max();
    assert!(longest < Some(400), "nobody reads 4000 letters: {said}");
}

#[cfg(unix)]
#[test]
fn a_program_that_does_not_read_inf_is_told() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let awk = |inf: &str| {
        format!(
            "#!/bin/sh
exec awk '{{
    d = $5 * $10 + $6 * $11 + $7 * $12; max = {inf}
    t = d == 0 ? -1 : ($13 - $2 * $10 - $3 * $11 - $4 * $12) / d
    if (d != 0 && $8 < t && t < max) printf \"= %.9g\\n\", t; else print \"= none\"
    fflush()
}}'\n"
        )
    };
    let check = ["check", "plane_hit", "--program", "answers", "--plain"];
    program(home.path(), &awk("$9 == \"inf\" ? 1e30 : $9"));
    let (code, said) = raybook(home.path(), &check);
    assert_eq!(code, 0, "{said}");
    // As C++ does: what is no number is 0, and ends the reading.
    program(
        home.path(),
        &awk("$9 == \"inf\" ? -1e30 : $9").replace(
            "print \"= none\"",
            "print (max < -1e29 ? \"= 0\" : \"= none\")",
        ),
    );
    let (code, said) = raybook(home.path(), &check);
    assert!(
        code == 1 && said.contains("exactly the cases with `inf` in their question"),
        "{said}"
    );
}

/// A folder with a new workbook in Python, `rays`; none where nothing can ask it.
#[cfg(unix)]
fn new_in_python() -> Option<tempfile::TempDir> {
    use raybook_grader::language::Language;
    if !Path::new("/usr/bin/python3").exists() {
        println!("there is no python3 here: its workbook is not asked");
        return None;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    raybook_grader::starter::create(&home.path().join("rays"), Language::Python)
        .expect("the folder can be made");
    Some(home)
}

#[cfg(unix)]
#[test]
fn the_first_hint_leads_on_and_the_next_exercise_is_named() {
    let Some(home) = new_in_python() else { return };
    let folder = home.path().join("rays");
    let (code, said) = raybook(&folder, &["hint", "sphere_hit"]);
    assert_eq!(code, 0, "{said}");
    for part in [
        "do one case by hand first",
        "head on",
        "And think of this: ",
        "Chapter 3",
        "ch03_sphere.py",
    ] {
        assert!(said.contains(part), "`{part}`: {said}");
    }
    // A tree of no shape, or of one, is a leaf.
    let (_, said) = raybook(&folder, &["hint", "octree_build"]);
    assert!(said.contains("by hand first, one in each child."), "{said}");

    let task = raybook_grader::cases::find("sphere_hit")
        .expect("an exercise")
        .task();
    assert!(!said.contains(task), "not the task again: {said}");
    let (_, said) = raybook(&folder, &["exercise", "sphere_hit"]);
    assert!(said.contains("Write it in ch03_sphere.py."), "{said}");

    let solution = raybook_common::project("tests/solutions/python/ch01_rays.py");
    fs::copy(solution, folder.join("ch01_rays.py")).expect("it can be copied");
    let (code, said) = raybook(&folder, &["check", "ray_at", "camera_ray", "--plain"]);
    assert_eq!(code, 0, "{said}");
    let next = "Next: expose in ch02_hdr.py; `raybook check expose` says how it stands.";
    assert!(said.contains(next), "{said}");
}

#[cfg(unix)]
#[test]
fn the_next_step_fits_how_the_exercise_stands() {
    let Some(home) = new_in_python() else { return };
    let folder = home.path().join("rays");
    let solution = |file: &str| {
        let file = raybook_common::project("tests/solutions/python").join(file);
        fs::read_to_string(file).expect("there is a solution")
    };
    let write = |file: &str, text: &str| {
        fs::write(folder.join(file), text).expect("it can be written");
    };
    let stub = fs::read_to_string(folder.join("ch01_rays.py")).expect("there is a stub");
    let wrong = stub.replacen(
        "raise NotImplementedError(\"ray_at\")",
        "return ray.origin",
        1,
    );
    write("ch02_hdr.py", &solution("ch02_hdr.py"));
    // Another chapter is right: the next step is about what was never checked, not started, wrong, and right.
    for (text, next) in [
        (
            "",
            "Next: ray_at in ch01_rays.py; `raybook check ray_at` says how it stands.",
        ),
        (
            &stub[..],
            "Next: write ray_at in ch01_rays.py; `raybook exercise ray_at`",
        ),
        (&wrong, "Next: mend ray_at in ch01_rays.py."),
        (
            &solution("ch01_rays.py"),
            "Next: solve_quadratic in ch03_sphere.py; ",
        ),
    ] {
        if !text.is_empty() {
            write("ch01_rays.py", text);
            raybook(&folder, &["check", "ch01", "--plain"]);
        }
        let (code, said) = raybook(&folder, &["check", "ch02", "--plain"]);
        assert!(code == 0 && said.contains(next), "{next}: {said}");
        let (code, said) = raybook(&folder, &[]);
        assert!(code == 0 && said.contains(next), "and in the map: {said}");
        let state = if text == wrong {
            "wrong: ray_at; "
        } else {
            "right: expose, "
        };
        assert!(said.contains(state), "the map names states: {said}");
    }
}

#[test]
fn tasks_speak_of_mathematics() {
    for examiner in raybook_grader::cases::all() {
        let task = examiner.task();
        for rust in ["None", "Some", "Hit {", "::", "`visit`", "&", "In Rust"] {
            assert!(
                !task.contains(rust),
                "{}: `{rust}` is Rust: {task}",
                examiner.name()
            );
        }
    }
}
