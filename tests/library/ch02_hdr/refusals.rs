//! Picture files: what cannot be read or written is an error that says so, and leaves nothing behind.

use super::{lights, no_partial_file_in};
use raybook::image::file::{self, FileError};
use raybook::image::{Image, rgb::Rgb};
use std::fs;

#[test]
fn a_name_that_is_no_pictures_is_an_error_that_says_which_are() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["picture.jpg", "picture", ".exr", "picture.exr.bak", ""] {
        let path = folder.path().join(name);
        for error in [
            file::save(&path, &lights()).expect_err("not a picture's name"),
            file::load(&path).expect_err("not a picture's name"),
        ] {
            assert!(matches!(error, FileError::Format { .. }), "{name}: {error}");
            assert_eq!(
                error.to_string(),
                format!(
                    "{}: a picture's name must end in .exr, .hdr or .png",
                    path.display()
                )
            );
        }
        assert!(name.is_empty() || !path.exists(), "{name} was not written");
    }
}

#[test]
fn a_missing_file_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["a.exr", "a.hdr", "a.png"] {
        let path = folder.path().join(name);
        let error = file::load(&path)
            .expect_err("there is no such file")
            .to_string();
        assert!(
            error.starts_with(&format!("{}: cannot read this file: ", path.display())),
            "{error}"
        );
    }
}

#[test]
fn a_picture_without_pixels_is_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    for (width, height) in [(0, 0), (0, 5), (5, 0)] {
        for name in ["a.exr", "a.hdr", "a.png"] {
            let path = folder.path().join(name);
            let empty = Image::from_fn(width, height, |_, _| Rgb::WHITE);
            let error = file::save(&path, &empty)
                .expect_err("there is nothing to write")
                .to_string();
            assert!(
                error.contains(&format!("{width} × {height} pixels")),
                "{error}"
            );
            assert!(!path.exists(), "nothing was written");
        }
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let in_the_way = folder.path().join("file");
    fs::write(&in_the_way, "not a folder").expect("it can be written");
    for name in ["a.exr", "a.hdr", "a.png"] {
        let error = file::save(&in_the_way.join(name), &lights())
            .expect_err("a file is in the way")
            .to_string();
        assert!(
            error.contains("cannot write this file: the folder "),
            "{error}"
        );
        assert!(error.contains("file cannot be made: "), "{error}");
    }
    assert_eq!(
        fs::read_to_string(&in_the_way).expect("it is there"),
        "not a folder",
        "nothing was harmed"
    );
    no_partial_file_in(folder.path());
}

#[test]
fn a_write_that_fails_leaves_nothing_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture.exr");
    fs::create_dir(&path).expect("it can be made");
    fs::write(path.join("inside"), "").expect("it can be written");
    let error = file::save(&path, &lights()).expect_err("a folder with a file in it has this name");
    assert!(
        matches!(&error, FileError::Store(error) if error.doing == "write this file"),
        "{error}"
    );
    assert!(
        path.join("inside").exists(),
        "what was there is still there"
    );
    no_partial_file_in(folder.path());
}

#[test]
fn a_write_replaces_the_old_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture.exr");
    for v in [1.0, 2.0] {
        let picture = Image::from_fn(3, 2, |_, _| Rgb::gray(v));
        file::save(&path, &picture).expect("it can be written");
        assert!(
            file::load(&path)
                .expect("it can be read")
                .same_bits(&picture),
            "the last one counts"
        );
    }
    no_partial_file_in(folder.path());
}
