//! `raybook picture`: each function that is written adds something.

use super::{WITHOUT_RUST, new, there_is};
use crate::common::command::raybook_with;
use raybook::image::file;
use raybook_common::project;
use raybook_grader::language::Language;
use std::fs;

#[test]
fn the_picture_grows_with_the_workbook() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let draw = || raybook_with(&folder, &["picture", "--width", "16"], &[]);
    let (code, said) = draw();
    assert!(
        code == 1 && said.contains("write sphere_hit first in ch03_sphere.py"),
        "{code} {said}"
    );
    let mut before = None;
    for (chapters, next) in [
        (&["ch03_sphere"][..], "Next: camera_ray"),
        (&["ch01_rays", "ch04_plane"], "Next: box_clip"),
        (&["ch05_box", "ch06_triangle"], "Next: mesh_hit"),
        (&["ch07_mesh"], "Next: phong"),
        (&["ch12_phong"], "Next: reflect"),
        (&["ch13_reflection"], "Next: refract"),
        (&["ch14_refraction", "ch15_shadows"], "written  shadow_ray"),
    ] {
        for chapter in chapters {
            let name = format!("{chapter}.py");
            let solution = project("tests/solutions/python").join(&name);
            fs::copy(solution, folder.join(&name)).expect("it can be copied");
        }
        let (code, said) = draw();
        assert!(code == 0 && said.contains(next), "{next}: {code} {said}");
        assert!(!said.contains("had no answer"), "{said}");
        let picture = file::load(&folder.join("out/picture.png")).expect("it is drawn");
        assert_eq!([picture.width(), picture.height()], [768, 432]);
        let grown = before.is_none_or(|before: raybook::image::Image| !before.same_bits(&picture));
        assert!(grown, "{chapters:?} can be seen");
        before = Some(picture);
    }
}

/// The first hour of `book/src/how_to_read.md`.
#[test]
fn a_lit_scene_with_shadows_takes_the_functions_of_four_lessons() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let with = |chapters: &[&str]| {
        for chapter in chapters {
            let name = format!("{chapter}.py");
            let solution = project("tests/solutions/python").join(&name);
            fs::copy(solution, folder.join(&name)).expect("it can be copied");
        }
        let (code, said) = raybook_with(&folder, &["picture", "--width", "16"], &[]);
        assert_eq!(code, 0, "{said}");
        file::load(&folder.join("out/picture.png")).expect("it is drawn")
    };
    let flat = with(&["ch03_sphere", "ch04_plane"]);
    let lit = with(&["ch12_phong"]);
    let shadowed = with(&["ch15_shadows"]);
    assert!(!flat.same_bits(&lit), "there is light");
    assert!(!lit.same_bits(&shadowed), "there are shadows");
}

/// A function that answers nonsense draws what it can, and is told.
#[test]
fn a_function_that_is_wrong_ends_nothing() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let answers = "import sys
for line in sys.stdin:
    name = line.split()[0]
    known = {'sphere_hit': 'nan', 'sphere_normal': 'inf nan 0', 'plane_hit': 'no number'}
    print('=', known.get(name, 'todo'), flush=True)
";
    fs::write(folder.join("answer.py"), answers).expect("it can be written");
    let (code, said) = raybook_with(&folder, &["picture", "--width", "16"], &[WITHOUT_RUST]);
    assert!(
        code == 0 && said.contains("had no answer that can be read"),
        "{code} {said}"
    );
    assert!(
        said.contains("wrong    sphere_hit") && said.contains("`raybook check sphere_hit"),
        "{said}"
    );
}
