//! The lessons as text, which every starter carries, and the book.

use crate::common::command::raybook;
use raybook_grader::cases;
use raybook_grader::inside::starter::plain;
use raybook_grader::starter::lesson;
use raybook_workbook::curriculum::CHAPTERS;
use std::fs;
use std::path::Path;

#[test]
fn every_chapter_has_its_lesson_as_text() {
    let files = lesson::files().expect("the pages are right");
    assert_eq!(files.len(), CHAPTERS.len());
    let mut bytes = 0;
    for (path, text) in &files {
        let text = String::from_utf8(text.clone()).expect("it is text");
        bytes += text.len();
        let directive = text.lines().find(|line| line.starts_with("{{"));
        assert_eq!(directive, None, "{}", path.display());
        for part in [
            "figure>", "<p ", "\n\n\n", "<svg", "<path", "<details", "<summary", "<code",
            "\\origin", ".md#", "\ncargo ",
        ] {
            assert!(!text.contains(part), "{}: {part}", path.display());
        }
        assert!(
            text.starts_with("# ") && text.contains("## The derivation"),
            "{}",
            path.display()
        );
        for examiner in cases::all() {
            for (mistake, hint) in examiner.mistakes() {
                assert!(!text.contains(hint), "{}: who {mistake}", path.display());
            }
        }
    }
    assert!(bytes < 350_000, "{bytes} bytes: the starter is small");
    let rays = String::from_utf8_lossy(&files[0].1);
    let commands = "```sh\nraybook tour --only ch01\nraybook tour --only ch01 --width 64 --samples 1   # single pixels\n```";
    assert!(
        rays.contains(commands),
        "who has no cargo has the command: {rays}"
    );
    let sphere = String::from_utf8_lossy(&files[2].1);
    for part in [
        "B^2 - 4AC",
        "The case \"head on\" of `sphere_hit`",
        "    origin         0 0 -3",
        "    → t            2",
        "> Picture `letters`: A circle of centre c",
        // The care that the lesson promises, and the exercise asks for.
        "### Roots without cancellation",
        "\\frac{C}{q}",
        "**For the curious: the discriminant in double precision**",
        "Now write solve_quadratic, sphere_hit, sphere_normal.",
    ] {
        assert!(sphere.contains(part), "`{part}` is in {sphere}");
    }
}

#[test]
fn the_book_is_opened_where_it_is_built_and_else_the_lesson_is_named() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (code, said) = raybook(home.path(), &["new", "rays", "--language", "python"]);
    assert_eq!(code, 0, "{said}");
    let folder = home.path().join("rays");
    let book = |arguments: &[&str]| raybook(&folder, &[&["book", "--no-open"], arguments].concat());
    for (arguments, code, part) in [
        (&["sphere"][..], 0, "lessons/ch03_sphere.md"),
        (&[], 0, "lessons"),
        (&["nothing"], 2, "no chapter is called so"),
        (
            &["ch03", "--folder", ".."],
            2,
            "there is no ch03_sphere.html in it",
        ),
    ] {
        let (ended, said) = book(arguments);
        assert!(
            ended == code && said.contains(part),
            "{arguments:?}: {ended} {said}"
        );
    }
    let built = home.path().join("book/book");
    fs::create_dir_all(&built).expect("it can be made");
    for page in ["index.html", "ch03_sphere.html"] {
        fs::write(built.join(page), "").expect("it can be written");
    }
    let name = |page: &str| built.join(page).display().to_string();
    for (arguments, page) in [(&["3"][..], "ch03_sphere.html"), (&[], "index.html")] {
        let (code, said) = book(arguments);
        let address = format!("The book: file://{}", name(page));
        assert!(code == 0 && said.contains(&address), "{code} {said}");
    }
    assert!(Path::new(&folder.join("lessons/ch25_capstone.md")).is_file());
}

#[test]
fn links_to_lessons_stay_and_others_are_only_their_text() {
    for (line, expected) in [
        (
            "an [**interval**](glossary.md#interval) of",
            "an **interval** of",
        ),
        (
            "see [the plane](ch04_plane.md).",
            "see [the plane](ch04_plane.md).",
        ),
        ("$f(x)$ and [a](b.md), [c](d.md)", "$f(x)$ and a, c"),
        ("[1, 2](", "[1, 2]("),
        (
            "$\\origin + t\\,\\direction$",
            "${\\mathbf o} + t\\,{\\mathbf d}$",
        ),
    ] {
        assert_eq!(plain(line), expected);
    }
}
