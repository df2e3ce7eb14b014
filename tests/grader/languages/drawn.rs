//! Pictures of chapters by the student's functions: asked pixel by pixel, coarse first, and said so where there is nothing to draw.

use super::{WITHOUT_RUST, new, there_is};
use crate::common::command::raybook_with;
use raybook_common::project;
use raybook_grader::ask::Asker;
use raybook_grader::cases;
use raybook_grader::converse::Limits;
use raybook_grader::language::Language;
use raybook_grader::picture::progressive::{Drawn, draw};
use raybook_grader::student;
use std::fs;
use std::time::Duration;

#[test]
fn a_chapter_is_drawn_by_asking_the_program() {
    if !there_is("/usr/bin/python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let draw = |chapter: &str| raybook_with(&folder, &["draw", chapter], &[WITHOUT_RUST]);
    let (code, said) = draw("ch04");
    assert!(
        code == 1 && said.contains("write plane_hit first in ch04_plane.py"),
        "{code} {said}"
    );
    let solution = project("tests/solutions/python/ch04_plane.py");
    fs::copy(solution, folder.join("ch04_plane.py")).expect("it can be copied");
    let (code, said) = draw("ch04");
    let drawn = folder.join("out/ch04_plane/plane_hit.png");
    assert!(code == 0 && drawn.is_file(), "{code} {said}");
    let (code, said) = draw("ch10");
    assert!(
        code == 0 && said.contains("no picture of their answers"),
        "{code} {said}"
    );
    let (code, said) = raybook_with(&folder, &["draw", "ch04", "--width", "9"], &[]);
    assert!(
        code == 2 && said.contains("sizes of their own"),
        "{code} {said}"
    );
}

#[test]
fn a_picture_tells_of_pixels_without_an_answer() {
    if !there_is("/usr/bin/python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let said = |program: &str, words: &[&str]| {
        fs::write(folder.join("answer.py"), program).expect("it can be written");
        raybook_with(&folder, words, &[WITHOUT_RUST])
    };
    let dead = "import sys\nsys.exit(3)\n";
    let why = "your program ended without an answer: exit code 3.";
    let (code, drawn) = said(dead, &["draw", "ch04"]);
    assert!(
        code == 1 && drawn.contains(&format!("plane_hit is not drawn: {why}")),
        "{code} {drawn}"
    );
    assert!(!folder.join("out/ch04_plane").exists(), "nothing is kept");
    let (code, picture) = said(dead, &["picture"]);
    assert!(
        code == 1 && picture.contains(&format!("of sphere_hit in ch03_sphere.py, {why}")),
        "{code} {picture}"
    );

    let odd = "import sys
for i, _ in enumerate(sys.stdin):
    print('= panic odd' if i % 2 else '= none', flush=True)
";
    let (code, drawn) = said(odd, &["draw", "ch04"]);
    let told = "2592 pixels are magenta, since they have no answer; the first: your function stopped with an error: odd";
    assert!(
        code == 1 && drawn.contains("plane_hit.png") && drawn.contains(told),
        "{code} {drawn}"
    );
}

/// The last pass is the picture that the check judges, and every pass before it has the pixels of its blocks.
#[test]
fn a_picture_gets_finer_pass_by_pass() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let solution = project("tests/solutions/python/ch04_plane.py");
    fs::copy(solution, folder.join("ch04_plane.py")).expect("it can be copied");
    let program = student::build(&folder).expect("nothing is to be built");
    let mut asker = Asker::new(&program, Limits::of(Duration::from_secs(60)));
    let examiner = cases::find("plane_hit").expect("an exercise");
    let mut passes = Vec::new();
    let drawn = draw(&mut asker, examiner, 0, &mut |stage| {
        passes.push((stage.block, stage.yours.clone(), stage.golden.clone()));
        Ok(())
    });
    assert_eq!(drawn.expect("the program runs"), Drawn::Whole);
    let blocks: Vec<_> = passes.iter().map(|(block, ..)| *block).collect();
    assert_eq!(blocks, [8, 4, 2, 1]);
    let (_, whole, golden) = passes.last().expect("four passes");
    let near = whole.pixels().iter().zip(golden.pixels());
    let near = near.filter(|(a, b)| (a.luminance() - b.luminance()).abs() < 0.01);
    assert!(
        near.count() > whole.pixels().len() * 99 / 100,
        "as the reference"
    );
    for (block, coarse, _) in &passes {
        let block = *block as usize;
        for y in 0..whole.height() {
            for x in 0..whole.width() {
                let asked = whole.at(x / block * block, y / block * block);
                assert_eq!(coarse.at(x, y), asked, "({x}, {y}) of blocks of {block}");
            }
        }
    }
}
