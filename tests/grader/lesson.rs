//! The lessons of the course book: each has the same parts in the same order, and every directive in it can be expanded.

use clap::Command;
use raybook_common::project;
use raybook_grader::book::{Book, BookError, Page, WIDEST};
use raybook_grader::capstone::PARTS;
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The headings of a lesson.
const FRAME: [&str; 11] = [
    "The question",
    "The idea",
    "The derivation",
    "With numbers",
    "Your turn",
    "The reference",
    "What it looks like when …",
    "In practice",
    "Predict before you run",
    "What your tracer now draws",
    "Further reading",
];

#[test]
fn every_lesson_has_the_parts_of_a_lesson() {
    for chapter in CHAPTERS {
        let found = wrong_parts(chapter, &text(chapter));
        assert!(
            found.is_empty(),
            "book/src/{}.md:\n  {}",
            chapter.name,
            found.join("\n  ")
        );
    }
}

#[test]
fn a_lesson_that_lacks_a_part_is_noticed() {
    let chapter = &CHAPTERS[2];
    let whole = text(chapter);
    assert!(wrong_parts(chapter, &whole).is_empty(), "it is whole");
    for part in [
        "## With numbers",
        "{{turn}}",
        "{{reference}}",
        "{{mistakes}}",
        "{{example ",
        "{{figure picture",
        "{{figure letters",
        "$$",
        "<details><summary>Answer</summary>",
        "raybook draw ch03",
        "raybook picture",
        "doi.org",
    ] {
        let without = whole.replace(part, "");
        assert_ne!(without, whole, "{part} is in it");
        assert!(
            !wrong_parts(chapter, &without).is_empty(),
            "without {part} it is not whole"
        );
    }
}

#[test]
fn every_directive_can_be_expanded_and_every_listing_fits() {
    let pictures = tempfile::tempdir().expect("a folder");
    let mut listings = 0;
    let read = |name: String| {
        let text = fs::read_to_string(project("book/src").join(&name)).expect("a page is text");
        Page { name, text }
    };
    let book = Book {
        pictures: pictures.path().to_owned(),
        pages: pages().into_iter().map(read).collect(),
        command: Command::new("raybook"),
    };
    for Page { name: page, text } in &book.pages {
        let source = without_galleries(text);
        let expanded = book.expand(page, &source);
        let expanded = expanded.unwrap_or_else(|error| panic!("{error}"));
        assert!(!expanded.contains("{{turn"), "{page} is expanded");
        let mut fenced = false;
        for line in expanded.lines() {
            fenced ^= line.starts_with("```");
            listings += usize::from(fenced && line.starts_with("```"));
            assert!(
                !fenced || line.chars().count() <= WIDEST,
                "{page}: a listing's line is longer than {WIDEST} characters: {line}"
            );
        }
    }
    assert!(listings >= 20, "the listings were seen: {listings}");
}

#[test]
fn what_a_page_becomes_is_the_courses_own() {
    let pictures = tempfile::tempdir().expect("a folder");
    let expanded = |line: &str| {
        let text = book(pictures.path()).expand("ch03_sphere.md", line);
        text.unwrap_or_else(|error| panic!("{error}"))
    };
    let example = expanded("{{example sphere_hit | from inside, off the centre}}");
    assert!(
        example.contains("<b>0.5</b>"),
        "the golden answer: {example}"
    );
    for directive in ["example", "turn"] {
        let fields = expanded(&format!("{{{{{directive} camera_ray}}}}"));
        for meaning in [
            "Where the ray starts, in metres.",
            "Where the ray goes, of length 1.",
        ] {
            assert!(fields.contains(meaning), "each field's own: {fields}");
        }
    }
    let turn = expanded("{{turn sphere_hit}}");
    for part in [
        r#"<a href="library.html#Interval">Interval</a>) -&gt; Option&lt;<a href="library.html#Hit">Hit</a>&gt; {"#,
        "std::optional<double> sphere_hit(",
        "def sphere_hit(",
        "May be infinite in a question: `within`.",
        "function sphere_hit(",
        "raybook check sphere_hit",
    ] {
        assert!(turn.contains(part), "{part} is in {turn}");
    }
    let meaning = expanded("{{turn shadow_ray}}");
    assert!(
        meaning.contains("wrong by up to <code>error</code>.") && !meaning.contains("`error`"),
        "names in a parameter's meaning are code: {meaning}"
    );
    let reference = expanded("{{reference sphere_hit}}");
    for part in [
        r#"ray: &amp;<a href="library.html#Ray">Ray</a>"#,
        r#"<a href="library.html#quadratic.solve">quadratic::solve</a>("#,
    ] {
        assert!(reference.contains(part), "{part} is in {reference}");
    }
    let mistakes = expanded("{{mistakes sphere_hit}}");
    assert!(
        mistakes.contains("takes the far root") && mistakes.contains("t is 2.0000 m too large"),
        "name and message: {mistakes}"
    );
    let head = expanded("# Sphere\n\n## Your turn\n");
    assert!(
        head.contains("minutes to read") && head.contains(r#"<a href="ch01_rays.html">Rays</a>"#),
        "how long, and what comes before: {head}"
    );
    let picture = pictures.path().join("mistakes/sphere_hit_1.png");
    assert!(picture.is_file(), "the mistake's picture is drawn");
}

#[test]
fn a_gallery_has_no_picture_twice() {
    let pictures = tempfile::tempdir().expect("a folder");
    // Some of its mistakes change less than a display can show, and some draw the same picture.
    let gallery = "{{mistakes blinn_phong}}";
    let expanded = book(pictures.path()).expand("ch12_phong.md", gallery);
    let expanded = expanded.expect("it is a gallery");
    let files = fs::read_dir(pictures.path().join("mistakes")).expect("pictures were drawn");
    let pngs: Vec<_> = files
        .filter_map(|file| Some(file.ok()?.path()))
        .filter(|file| file.extension().is_some_and(|form| form == "png"))
        .map(|file| fs::read(file).expect("a picture"))
        .collect();
    let distinct: BTreeSet<_> = pngs.iter().collect();
    assert!(pngs.len() > 3, "{} pictures were drawn", pngs.len());
    assert_eq!(distinct.len(), pngs.len(), "no two are equal");
    let right = expanded.matches("blinn_phong_right.png").count();
    assert_eq!(right, 1, "no mistake shows the right picture");
}

#[test]
fn a_wrong_directive_is_an_error_with_its_line() {
    for (line, said) in [
        ("{{turn sphere_hitt}}", "no exercise `sphere_hitt`"),
        ("{{example sphere_hit | at noon}}", "no case `at noon`"),
        ("{{sing sphere_hit}}", "no directive `sing`"),
        ("{{figure}}", "a word and a name"),
        ("a {{turn sphere_hit}}", "alone on its line"),
        ("{{turn sphere_hit", "alone on its line"),
        ("{{figure roots}}", "cannot see it"),
        ("{{listing src/none.rs:a}}", "no file src/none.rs"),
        ("{{listing src/shape/mod.rs:none}}", "no `// ANCHOR: none`"),
        ("{{reference nothing}}", "no exercise"),
        ("{{measured nothing}}", "golden/measured has biases"),
        ("{{path 1 12}}", "chapter 12 (Phong) needs chapter 2"),
        ("{{index words.md}}", "no page words.md"),
        ("{{library sources}}", "no files in `sources`"),
        ("{{commands ray}}", "not `ray`"),
    ] {
        let error =
            book(Path::new("nowhere")).expand("ch03_sphere.md", &format!("one\ntwo\n{line}"));
        let BookError { page, line, what } = error.expect_err("it is wrong");
        assert_eq!((page.as_str(), line), ("ch03_sphere.md", 3));
        assert!(what.contains(said), "{what} says {said}");
    }
}

/// A book without pages, which has its pictures in this folder.
fn book(pictures: &Path) -> Book {
    Book {
        pictures: pictures.to_owned(),
        pages: Vec::new(),
        command: Command::new("raybook"),
    }
}

/// A page without its galleries of mistakes: to draw them all takes a minute, and `book/build` does it. That an exercise has its gallery
/// is a part of the lesson's template, and `what_a_page_becomes_is_the_courses_own` draws one.
fn without_galleries(source: &str) -> String {
    let lines = source.lines().filter(|line| *line != "{{mistakes}}");
    lines.collect::<Vec<_>>().join("\n")
}

/// What is wrong with a lesson's parts.
fn wrong_parts(chapter: &Chapter, text: &str) -> Vec<String> {
    let headings: Vec<_> = text.lines().filter_map(|l| l.strip_prefix("## ")).collect();
    let mut wrong = Vec::new();
    if headings != FRAME {
        wrong.push(format!(
            "its headings must be {FRAME:?}, and are {headings:?}"
        ));
    }
    let part = |heading: &str| {
        let mut parts = text.split("\n## ");
        let part = parts.find(|part| part.starts_with(heading));
        part.unwrap_or("").to_owned()
    };
    let start = text.split("\n## ").next().unwrap_or("");
    let run = format!("cargo run --release --bin {}", chapter.name);
    let draw = format!("raybook draw {}", &chapter.name[..4]);
    let mut needed = vec![
        (start.to_owned(), "{{figure picture | ".to_owned()),
        (start.to_owned(), run),
        (part("The idea"), "{{figure letters | ".to_owned()),
        (part("The derivation"), "$$".to_owned()),
        (part("With numbers"), "{{example ".to_owned()),
        (part("What your tracer"), draw),
        (part("Further reading"), "https://doi.org/".to_owned()),
    ];
    // Nothing is seen of the growing picture before there are balls.
    let grows = |name: &str| PARTS[1..].iter().any(|part| part.exercise == name);
    if chapter.exercises().iter().any(|asked| grows(asked.name)) {
        needed.push((part("What your tracer"), "raybook picture".to_owned()));
        needed.push((
            part("What your tracer"),
            format!("{{{{scene {} | ", chapter.name),
        ));
    }
    for (heading, word) in [
        ("Your turn", "{{turn}}"),
        ("The reference", "{{reference}}"),
        ("What it looks", "{{mistakes}}"),
    ] {
        needed.push((part(heading), word.to_owned()));
    }
    for (part, what) in needed {
        if !part.contains(&what) {
            let heading = part.lines().next().unwrap_or("the part that is missing");
            wrong.push(format!("`{heading}` lacks {what}"));
        }
    }
    let asked = part("Predict");
    let is_question = |line: &&str| line.starts_with(|c: char| c.is_ascii_digit());
    let questions = asked.lines().filter(is_question).count();
    let answers = asked.matches("<details><summary>Answer</summary>").count();
    if questions < 2 || answers != questions {
        wrong.push(format!(
            "{questions} questions have {answers} folded answers"
        ));
    }
    if text.contains("{{#include") {
        wrong.push(
            "an {{#include}} may show a solution: use {{reference}} or {{listing}}".to_owned(),
        );
    }
    wrong
}

/// The text of a chapter's page.
fn text(chapter: &Chapter) -> String {
    let path = project("book/src").join(format!("{}.md", chapter.name));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The files of the book's pages.
fn pages() -> Vec<String> {
    let entries = fs::read_dir(project("book/src")).expect("book/src is there");
    let names = entries
        .flatten()
        .map(|entry| entry.file_name().to_string_lossy().into_owned());
    let is_page = |name: &String| Path::new(name).extension().is_some_and(|end| end == "md");
    let pages: Vec<_> = names.filter(is_page).collect();
    assert!(pages.len() > CHAPTERS.len(), "all pages are seen");
    pages
}
