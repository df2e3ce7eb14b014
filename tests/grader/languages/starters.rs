//! The starters in Python and C++: all is to be written, nothing is given away, nothing is complained of.

use super::{WITHOUT_RUST, new, succeeds, there_is};
use crate::common::command::raybook_with;
use raybook_grader::cases;
use raybook_grader::language::Language;
use raybook_grader::starter::{StarterFile, cpp, place, python};
use raybook_workbook::curriculum::CHAPTERS;
use std::fs;
use std::path::Path;
use std::process::Command;

fn text(file: &StarterFile) -> String {
    String::from_utf8(file.1.clone()).expect("it is text")
}

#[test]
fn every_exercise_is_stubbed_in_its_chapter_and_nothing_is_given_away() {
    for (language, files, todo) in [
        (
            Language::Python,
            python::files(),
            "raise NotImplementedError(\"NAME\")",
        ),
        (Language::Cpp, cpp::files(), "todo(\"NAME\", "),
    ] {
        for examiner in cases::all() {
            let name = examiner.name();
            let todo = todo.replace("NAME", name);
            let stubbed = files.iter().filter(|file| text(file).contains(&todo));
            let stubbed: Vec<_> = stubbed.map(|(path, _)| path.as_path()).collect();
            let place = place(language, name).expect("it has a place");
            assert_eq!(stubbed, [Path::new(&place)], "{name}");
            let golden = examiner.cases(&mut raybook_grader::examine::visible_rng(name));
            for file in &files {
                let text = text(file);
                // A question shorter than that is like any other text.
                let given = golden.cases.iter().map(|case| case.question.as_str());
                let mut given = given.filter(|question| question.len() > 40);
                assert!(given.all(|case| !text.contains(case)), "{name}: a case");
                for (mistake, hint) in examiner.mistakes() {
                    assert!(!text.contains(hint), "{name}: the hint of who {mistake}");
                }
            }
        }
    }
}

/// The folder is checked with the system's programs only: no cargo.
fn is_all_to_do(folder: &Path) {
    let (code, said) = raybook_with(folder, &["check", "--plain"], &[WITHOUT_RUST]);
    assert_eq!(code, 1, "{said}");
    let exercises = cases::all().len();
    let not_started = said
        .lines()
        .filter(|line| line.starts_with("  not started "))
        .count();
    assert_eq!(not_started, exercises, "{said}");
    assert!(
        said.contains(&format!("0 of {exercises} exercises are right"))
            && said.contains("Next: write ray_at in ch01_rays."),
        "{said}"
    );
}

#[test]
fn a_new_folder_in_python_is_all_to_do() {
    if !there_is("/usr/bin/python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    is_all_to_do(&folder);

    // An error in a chapter is told, and leaves the other chapters be.
    fs::write(folder.join("ch03_sphere.py"), "def sphere_hit(:\n").expect("it can be written");
    let variables = [WITHOUT_RUST];
    let (_, said) = raybook_with(&folder, &["check", "3", "4", "--plain"], &variables);
    assert!(
        said.contains("SyntaxError") && said.contains("not started plane_hit"),
        "{said}"
    );
}

/// Writes the body of `ray_at` in place of its stub.
fn write_ray_at(folder: &Path, body: &str) {
    let file = folder.join("ch01_rays.py");
    let text = fs::read_to_string(&file).expect("it can be read");
    let stub = "    raise NotImplementedError(\"ray_at\")";
    assert!(text.contains(stub), "{text}");
    fs::write(&file, text.replace(stub, body)).expect("it can be written");
}

#[test]
fn a_loop_that_never_ends_is_found_in_a_folder_in_python() {
    if !there_is("/usr/bin/python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let text = fs::read_to_string(folder.join("ch01_rays.py")).expect("it can be read");
    write_ray_at(&folder, "    while True:\n        t += 1  # and again");
    let line = 1 + text
        .lines()
        .position(|line| line.contains("\"ray_at\""))
        .expect("a line");
    let arguments = ["check", "ray_at", "--plain", "--time-limit", "0.2"];
    let (code, said) = raybook_with(&folder, &arguments, &[WITHOUT_RUST]);
    assert!(
        code == 1
            && said.contains("does a loop never end?")
            && [line, line + 1]
                .iter()
                .any(|line| said.contains(&format!("line {line}, in ray_at"))),
        "the place is told: {said}"
    );
}

#[test]
fn who_keeps_something_between_questions_is_told() {
    if !there_is("/usr/bin/python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let told = "In a program that is asked nothing else, this case is right. Does your function keep something";
    for (name, body, keeps) in [
        (
            "growing",
            "    kept.append(1)\n    t += len(kept) - 1",
            true,
        ),
        ("wrong", "    t = abs(t)", false),
    ] {
        let folder = new(home.path(), name, Language::Python);
        let body = format!("{body}\n    return ray.origin + t * ray.direction\n\n\nkept = []");
        write_ray_at(&folder, &body);
        let words = ["check", "ray_at", "--plain"];
        let (code, said) = raybook_with(&folder, &words, &[WITHOUT_RUST]);
        assert!(code == 1 && said.contains(told) == keeps, "{name}: {said}");
    }
}

#[test]
fn a_list_is_a_vector_in_python_where_a_vector_is_asked_for() {
    if !there_is("/usr/bin/python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    // As an array of numpy does, which need not be there.
    let array = "    class Array:\n        def tolist(self):\n            return [p.x, p.y, p.z]";
    let values = ["[p.x, p.y, p.z]", "(p.x, p.y, p.z)", "Array()"];
    for (name, value) in ["list", "tuple", "array"].into_iter().zip(values) {
        let folder = new(home.path(), name, Language::Python);
        let body = format!("    p = ray.origin + t * ray.direction\n{array}\n    return {value}");
        write_ray_at(&folder, &body);
        let (code, said) = raybook_with(&folder, &["check", "ray_at"], &[WITHOUT_RUST]);
        assert!(
            code == 0 && said.contains("40 of 40 cases right"),
            "{value}: {said}"
        );
    }
}

#[test]
fn a_new_folder_in_python_has_sound_types() {
    // A shell finds it where a user has it; the tests need it no further.
    if !there_is("mypy") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let said = succeeds(Command::new("mypy").arg(".").current_dir(&folder));
    assert!(said.contains("no issues found in"), "{said}");
}

#[test]
fn a_new_folder_in_cpp_is_all_to_do_and_compiles_without_a_warning() {
    if !there_is("make") || !there_is("g++") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Cpp);
    is_all_to_do(&folder); // and `new` has seen that the compiler said nothing

    let (file, stub) = (folder.join("ch01_rays.cpp"), "todo(\"ray_at\", ray, t);");
    let text = fs::read_to_string(&file).expect("it can be read");
    let forgotten = text.replace(stub, "ray.origin + t * ray.direction;");
    fs::write(&file, forgotten).expect("it can be written");
    let (code, said) = raybook_with(&folder, &["check", "ray_at"], &[WITHOUT_RUST]);
    assert!(
        text.contains(stub) && code == 2 && said.contains("return-type"),
        "a forgotten `return` does not end in the next function: {said}"
    );

    let common = "std::clamp(5.0, 0.0, 1.0) * std::max({0.5, 2 * abs(-0.5)})";
    let right = format!("return ray.origin + t * {common} * ray.direction;");
    fs::write(&file, text.replace(stub, &right)).expect("it can be written");
    let (code, said) = raybook_with(&folder, &["check", "ray_at"], &[WITHOUT_RUST]);
    assert_eq!(
        code, 0,
        "common functions are there, and abs is that of numbers: {said}"
    );

    fs::write(file, "int broken(\n").expect("it can be written");
    let (code, said) = raybook_with(&folder, &["check"], &[WITHOUT_RUST]);
    assert!(
        code == 2 && said.contains("ch01_rays.cpp:1:") && said.contains("does not compile"),
        "the compiler is heard: {said}"
    );
}

/// Memory beyond the end of a list is often 0, which would be taken for another mistake.
#[test]
fn an_index_beyond_the_end_stops_the_program_in_cpp() {
    if !there_is("make") || !there_is("g++") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Cpp);
    let file = folder.join("ch05_box.cpp");
    let text = fs::read_to_string(&file).expect("it can be read");
    let stub = "todo(\"bounds_of\", points);";
    assert!(text.contains(stub), "{text}");
    for (point, told) in [
        (
            "points[points.size()]",
            &["signal 6 (abort", "Assertion '__n < this->size()' failed."][..],
        ),
        (
            "Vec3{points.at(0)[3], 0, 0}",
            &[
                "the axes of a Vec3 are 0, 1 and 2",
                "takes something from a list that is not in it",
            ],
        ),
    ] {
        let body = format!("return {{{point}, {point}}};");
        fs::write(&file, text.replace(stub, &body)).expect("it can be written");
        let words = ["check", "bounds_of", "--plain"];
        let (code, said) = raybook_with(&folder, &words, &[WITHOUT_RUST]);
        assert!(
            code == 1 && told.iter().all(|told| said.contains(told)),
            "{point}: {said}"
        );
    }
}

#[test]
fn a_stub_tells_what_would_be_looked_up() {
    const MEMBERS: &str = "Members: Ray { origin, direction }, Interval { min, max }, TriangleHitAnswer { t, b1, b2 }.\n";
    let in_cpp = "// Where there is none: `return std::nullopt;`.\n";
    for (files, name, parts) in [
        (cpp::files(), "ch06_triangle.cpp", &[MEMBERS, in_cpp][..]),
        (python::files(), "ch06_triangle.py", &[MEMBERS]),
    ] {
        let chapter = files.iter().find(|(path, _)| path == Path::new(name));
        let text = text(chapter.expect("a chapter"));
        for part in parts {
            assert!(text.contains(part), "{part}{text}");
        }
    }
}

#[test]
fn cmake_takes_the_folder_in_cpp() {
    if !there_is("cmake") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Cpp);
    succeeds(
        Command::new("cmake")
            .args(["--preset", "default"])
            .current_dir(&folder),
    );
    let commands = fs::read_to_string(folder.join("build/cmake/compile_commands.json"));
    let commands = commands.expect("editors have their file");
    assert_eq!(
        commands.matches("\"file\"").count(),
        CHAPTERS.len() + 2,
        "the chapters, the table and the loop"
    );
}

#[cfg(unix)]
#[test]
fn who_ends_by_a_signal_in_cpp_is_told_how_to_find_the_line() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (code, said) = raybook_with(home.path(), &["new", "rays", "--language", "C++"], &[]);
    assert_eq!(code, 0, "{said}");
    let folder = home.path().join("rays");
    fs::write(folder.join("ends.sh"), "read -r line; kill -SEGV $$\n").expect("it can be written");
    let toml = "language = \"cpp\"\nrun = \"sh ends.sh\"\n";
    fs::write(folder.join("raybook.toml"), toml).expect("it can be written");
    let (code, said) = raybook_with(&folder, &["check", "ray_at"], &[]);
    assert!(
        code == 1 && said.contains("make -j4 debug && raybook check ray_at --case 1 --program build/debug/answer --trust"),
        "{said}"
    );
}

#[test]
fn a_chapter_that_was_missed_is_solved_in_the_workbooks_language() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let said = |words: &[&str]| raybook_with(&folder, words, &[WITHOUT_RUST]);
    let (code, first) = said(&["explain", "--plain"]);
    assert!(
        code == 1 && first.starts_with("ray_at, case 1"),
        "what is next is explained: {first}"
    );

    let before = fs::read(folder.join("ch02_hdr.py")).expect("it is there");
    let (code, alone) = said(&["solve", "expose"]);
    assert!(
        code == 0 && alone.contains("def expose(") && !alone.contains("def encode_srgb("),
        "{alone}"
    );
    assert!(
        alone.contains("ch02_hdr.py is as it was, for it has your tone_map, encode_srgb too"),
        "{alone}"
    );
    assert_eq!(
        fs::read(folder.join("ch02_hdr.py")).expect("it is there"),
        before
    );
    let taken = fs::read_to_string(folder.join("references-taken.txt"));
    assert_eq!(taken.expect("it is recorded"), "expose\n");

    let (code, solved) = said(&["solve", "ch01", "ch02"]);
    assert!(
        code == 0 && solved.contains("ch02_hdr.py is now the reference; yours is kept in"),
        "{solved}"
    );
    let (code, checked) = said(&["check", "ch01", "ch02"]);
    assert!(
        code == 0 && checked.contains(".raybook/ch01_rays_reference.py"),
        "{checked}"
    );
    let taken = fs::read_to_string(folder.join("references-taken.txt"));
    assert_eq!(
        taken.expect("it is recorded"),
        "camera_ray\nencode_srgb\nexpose\nray_at\ntone_map\n"
    );
    let (code, nothing) = said(&["explain", "ch01", "--plain"]);
    assert!(
        code == 0 && nothing.contains("Nothing to explain"),
        "{nothing}"
    );

    fs::remove_file(folder.join("ch04_plane.py")).expect("it was there");
    let (code, gone) = said(&["check", "ch04"]);
    assert!(
        code == 1 && gone.contains("Next: ch04_plane.py is gone: bring it back"),
        "{gone}"
    );

    let toml = "language = \"perl\"\nrun = \"perl answer.pl\"\n";
    fs::write(folder.join("raybook.toml"), toml).expect("it can be written");
    let (code, refused) = said(&["solve", "ch03"]);
    assert!(
        code == 2 && refused.contains("`raybook book` has those"),
        "{refused}"
    );
}
