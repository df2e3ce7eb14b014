//! The chapters drawn by a student's own functions.

use crate::common::command::raybook_with;
use crate::common::starter::write;
use raybook_grader::starter::stub;
use raybook_workbook::anchor::Anchored;
use raybook_workbook::curriculum::CHAPTERS;

/// Pictures of 64 columns are drawn sooner than they are compiled.
const UNOPTIMISED: (&str, &str) = ("CARGO_PROFILE_RELEASE_OPT_LEVEL", "0");

/// A library in which environment variables say what is not written, and what is wrong: for all tests it compiles once.
fn switched(function: &Anchored<'_>) -> Option<String> {
    let Anchored {
        name, text, body, ..
    } = *function;
    let switch = match name {
        "sphere_normal" => {
            "if std::env::var_os(\"RAYBOOK_INWARDS\").is_some() { return Dir3::new_or(self.center - p, Dir3::Z); }".to_owned()
        }
        _ if CHAPTERS[0].exercises().iter().any(|asked| asked.name == name) => return None,
        _ => format!("if std::env::var_os(\"RAYBOOK_FIRST\").is_some() {{ todo!(\"{name}\") }}"),
    };
    stub(function).map(|_| text.replacen(body, &format!("\n{switch}\n{body}"), 1))
}

#[test]
fn the_chapters_are_drawn_by_the_students_functions() {
    let written = write(&|function| switched(function));
    let out = tempfile::tempdir().expect("a temporary folder");
    let out = out.path().to_str().expect("the name is text");
    let draw = |chapter: &str, switch: &str| {
        let small = ["--width", "64", "--samples", "1", "--out", out];
        let arguments = [&["draw", chapter][..], &small].concat();
        raybook_with(&written.folder, &arguments, &[(switch, "yes"), UNOPTIMISED])
    };
    let picture = |chapter: &str| {
        let file = std::path::Path::new(out).join(chapter).join("picture.exr");
        raybook::image::file::load(&file).expect("the picture is written")
    };

    let (code, said) = draw("ch03", "RAYBOOK_NOTHING");
    assert_eq!(code, 0, "the student's chapter draws: {said}");
    let right = picture("ch03_sphere");
    let (code, said) = draw("sphere", "RAYBOOK_INWARDS");
    assert_eq!(code, 0, "{said}");
    assert!(
        right != picture("ch03_sphere"),
        "a normal that points inwards is seen in the chapter's picture"
    );

    let (code, said) = draw("1", "RAYBOOK_FIRST");
    assert_eq!(
        code, 0,
        "the first chapter needs nothing of those to come: {said}"
    );
    let (code, said) = draw("ch03", "RAYBOOK_FIRST");
    assert_eq!(code, 1, "the third does: {said}");
    assert!(
        said.contains("error: this chapter's pictures need ")
            && said.contains("src/")
            && !said.contains("panicked"),
        "it says what is to be written, and where: {said}"
    );

    let stale = written.folder.join(".raybook/chapters/ch99_old.rs");
    std::fs::write(&stale, "what an older command left").expect("the file can be written");
    let (code, said) = draw("ch03", "RAYBOOK_NOTHING");
    assert!(code == 0 && !stale.exists(), "it is removed: {said}");
    assert!(
        !said.contains("Compiling"),
        "and what is there already is not compiled again: {said}"
    );
}
