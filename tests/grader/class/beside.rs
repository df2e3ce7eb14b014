//! Which folders of an instructor's own exercises are packed with a course file.

use raybook_grader::class::course::Course;
use raybook_grader::class::pack::beside::beside;
use std::fs;
use std::path::Path;

#[test]
fn a_folder_is_packed_under_a_name_of_its_own() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for (path, packed) in [
        ("own", true),
        ("exercises/lenses", true),
        ("", false),
        (".", false),
        ("..", false),
        ("../own", false),
        ("own/../..", false),
        ("/own", false),
        ("raybook", false),
        (".github/workflows", false),
    ] {
        let file = home.path().join("course.toml");
        let mut course =
            Course::read(&file, "[[chapter]]\nchapter = 'ch01'\n").expect("it is right");
        let folder = home.path().join(path);
        if packed {
            fs::create_dir_all(&folder).expect("a folder");
            fs::write(folder.join("lens.toml"), "").expect("a file");
        }
        course.own.folders = vec![folder];
        let beside = beside(&course, &file).map(|files| files.into_iter().map(|file| file.path));
        match beside {
            Ok(paths) => {
                assert!(packed, "{path}");
                let whole = [Path::new(path).join("lens.toml")];
                assert_eq!(paths.collect::<Vec<_>>(), whole, "{path}");
            }
            Err(why) => assert!(
                !packed && why.contains("only if it lies beside"),
                "{path}: {why}"
            ),
        }
    }
}
