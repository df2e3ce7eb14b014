//! Any language: `raybook.toml` says how to build and run.

use super::{new, there_is};
use crate::common::command::raybook;
use raybook_common::project;
use raybook_grader::cases;
use raybook_grader::language::Language;
use raybook_grader::starter::reference_file;
use std::fs;
use std::path::Path;

fn write(folder: &Path, file: &str, text: &str) {
    fs::create_dir_all(folder).expect("the folder can be made");
    fs::write(folder.join(file), text).expect("it can be written");
}

/// The program that the book's page on the protocol shows, and what its folder says of it.
#[test]
fn the_books_example_in_perl_is_right() {
    if !there_is("perl") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let page = fs::read_to_string(project("book/src/any_language.md")).expect("there is a page");
    let listing = |language: &str| {
        let begins = format!("```{language}\n");
        let (_, rest) = page.split_once(&begins).expect("it has the listing");
        rest.split_once("```").expect("it ends").0
    };
    write(home.path(), "raybook.toml", listing("toml"));
    write(home.path(), "rays.pl", listing("perl"));
    assert!(listing("perl").lines().count() <= 36, "it is short");
    let (code, said) = raybook(home.path(), &["check", "--plain"]);
    assert_eq!(code, 1, "not everything is written: {said}");
    for right in ["ray_at", "plane_hit"] {
        assert!(said.contains(&format!("right       {right}")), "{said}");
    }
    assert!(said.contains("not started sphere_hit"), "{said}");
    let right = format!("2 of {} exercises are right", cases::all().len());
    assert!(said.contains(&right), "{said}");
}

#[test]
fn a_wrong_recipe_is_explained() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for (text, part) in [
        (
            "language = \"perl\"\n",
            "raybook.toml:1:1: a workbook needs `run`",
        ),
        (
            "language = perl\n",
            "raybook.toml:1:12: this is not valid TOML",
        ),
        (
            "language = \"perl\"\nrun = 3\n",
            "2:7: `run` must be a command in quotes",
        ),
        (
            "language = \"perl\"\nrum = \"perl a.pl\"\n",
            "2:1: a workbook needs `run`: is it meant by `rum`?",
        ),
        (
            "language = \"perl\"\nrun = \"perl 'a.pl\"\n",
            "2:7: `run` must be a command",
        ),
        (
            "language = \"perl\"\nrun = \"\"\n",
            "2:7: `run` must be a command",
        ),
        (
            "language = \"c\"\nbuild = \"no-such-compiler a.c\"\nrun = \"./a\"\n",
            "cannot run `no-such-compiler a.c`",
        ),
        (
            "language = \"c\"\nrun = \"no-such-program\"\n",
            "is it installed? raybook.toml says",
        ),
    ] {
        write(home.path(), "raybook.toml", text);
        let (code, said) = raybook(home.path(), &["check", "ray_at"]);
        assert!(
            code == 2 && said.contains(part),
            "{text} says `{part}`: {code} {said}"
        );
    }
}

const RAY_AT: &str = "\
for line in open(0):
    name, *words = line.split()
    if name != 'ray_at':
        print('= todo', name)
        continue
    o, d, t = [float(w) for w in words[:3]], [float(w) for w in words[3:6]], float(words[6])
    print('=', *(a + t * b for a, b in zip(o, d)))
";

#[test]
fn a_command_is_a_program_in_the_sandbox_and_without_it() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    write(&home.path().join("hand in"), "a.py", RAY_AT);
    for options in [&[][..], &["--trust"]] {
        let arguments = ["check", "ray_at", "--program", "python3 'hand in/a.py'"];
        let (code, said) = raybook(home.path(), &[&arguments, options].concat());
        assert_eq!(code, 0, "{options:?}: {said}");
        assert!(said.contains("1 of 1 exercises are right"), "{said}");
    }
    let arguments = ["check", "ray_at", "--program", "python3 none.py"];
    let (code, said) = raybook(home.path(), &arguments);
    assert!(code == 1 && said.contains("none.py"), "{code} {said}");
}

#[test]
fn a_strangers_folder_is_built_and_asked_in_the_sandbox() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for (language, tools) in [(Language::Python, "python3"), (Language::Cpp, "make")] {
        if !there_is(tools) {
            continue;
        }
        let folder = new(home.path(), language.name(), language);
        let file = place(language);
        let solution = reference_file(language, &file).expect("there is a solution");
        fs::write(folder.join(file), solution).expect("it can be written");
        let name = language.name();
        let (code, said) = raybook(home.path(), &["check", "ray_at", "--program", name]);
        assert_eq!(code, 0, "{name}: {said}");
    }
}

fn place(language: Language) -> String {
    raybook_grader::starter::place(language, "ray_at").expect("it has a place")
}
