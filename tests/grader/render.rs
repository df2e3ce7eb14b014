//! `raybook render`: a scene file becomes a picture, or a sentence that says what is wrong.

use crate::common::command::raybook;
use raybook::image::file;
use std::fs;
use std::path::Path;

pub(crate) const SCENE: &str = "[picture]\nwidth = 20\nheight = 10\nsamples = 4\n
[camera]\nfrom_m = [0, 1, 4]\nto_m = [0, 1, 0]\n
[[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 1, 0]\nradius_m = 1\nmaterial = { kind = \"matte\", colour = 0.5 }\n
[backdrop]\nhorizon = 1\nabove = 1\nbelow = 1\n";

pub(crate) fn folder(scene: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("scene.toml"), scene).expect("written");
    folder
}

/// What is said of the model in [`folder_with_remark`].
pub(crate) const REMARK: &str =
    "remark: a.mtl: not used: `bump`; bumps must be a normal map, which `norm` names";

/// A scene with a model, of whose files not all is used.
pub(crate) fn folder_with_remark() -> tempfile::TempDir {
    let folder = folder(&format!(
        "{SCENE}[[shapes]]\nkind = \"mesh\"\nfile = \"a.obj\"\n"
    ));
    let triangle = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    let material = "newmtl a\nbump heights.png\n";
    for (name, text) in [("a.obj", triangle), ("a.mtl", material)] {
        fs::write(folder.path().join(name), text).expect("written");
    }
    folder
}

fn files(folder: &Path) -> Vec<String> {
    let entries = folder.read_dir().expect("the folder");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<_> = names
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn a_scene_file_becomes_a_picture_and_the_number_of_threads_is_no_matter() {
    let folder = folder(SCENE);
    for (threads, out) in [("1", "one.exr"), ("3", "three.exr")] {
        let arguments = ["render", "scene.toml", "--out", out, "--threads", threads];
        let (code, said) = raybook(folder.path(), &arguments);
        assert_eq!(code, 0, "{said}");
        assert!(
            said.starts_with(&format!("wrote {out}: 20 × 10 pixels, 4 samples, ")),
            "{said}"
        );
    }
    let [one, three] =
        ["one.exr", "three.exr"].map(|name| fs::read(folder.path().join(name)).expect("written"));
    assert!(one == three, "byte for byte");
    let picture = file::load(&folder.path().join("one.exr")).expect("a picture");
    let (ball, sky) = (picture.at(10, 5).g, picture.at(0, 0).g);
    assert!(
        (ball - 0.5).abs() < 1e-3 && (sky - 1.0).abs() < 1e-6,
        "{ball} before {sky}"
    );
    let smaller = [
        "render",
        "scene.toml",
        "--width",
        "8",
        "--samples",
        "1",
        "--out",
        "new/small.png",
    ];
    let (code, said) = raybook(folder.path(), &smaller);
    assert!(
        code == 0
            && said.contains("8 × 4 pixels, 1 samples")
            && said.contains("there is no folder new; it is made"),
        "{code} {said}"
    );
    let small = file::load(&folder.path().join("new/small.png")).expect("a picture");
    assert_eq!((small.width(), small.height()), (8, 4));
}

#[test]
fn what_a_models_files_have_and_the_picture_has_not_is_remarked() {
    let folder = folder_with_remark();
    let (code, said) = raybook(folder.path(), &["render", "scene.toml"]);
    assert!(
        code == 0 && said.contains(&format!("{REMARK}\n")),
        "{code} {said}"
    );
}

#[test]
fn what_is_wrong_is_said_at_once_and_nothing_is_written() {
    let misspelt = SCENE.replace("radius_m", "radios_m");
    for (scene, arguments, part) in [
        (
            &*misspelt,
            &["render", "scene.toml"][..],
            "error: scene.toml:13:1: a shape of the kind `sphere` needs `radius_m`: is it meant by `radios_m`?",
        ),
        (
            SCENE,
            &["render", "scene.toml", "--out", "picture.jpg"],
            "picture.jpg: a picture's name must end in .exr, .hdr or .png",
        ),
        (
            SCENE,
            &["render", "none.toml"],
            "none.toml: cannot read this file",
        ),
        (SCENE, &["render", "."], "it is a folder"),
        (SCENE, &["render", "scene.toml", "--width", "9000"], "9000"),
        (SCENE, &["render"], "<SCENE>"),
    ] {
        let folder = folder(scene);
        let (code, said) = raybook(folder.path(), arguments);
        assert!(
            code == 2 && said.contains(part),
            "{arguments:?}: {code} {said}"
        );
        assert_eq!(files(folder.path()), ["scene.toml"], "{arguments:?}");
    }
}
