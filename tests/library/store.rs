//! Files appear whole or not at all, nothing but a file is read, and nothing is read or written through a trap.

use raybook::memory::BUDGET;
use raybook::store::{self, new_folder, read, read_text, write};
use std::collections::BTreeSet;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::thread;

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).expect("the folder can be read");
    entries
        .map(|entry| entry.expect("an entry").file_name())
        .map(|name| name.to_string_lossy().into_owned())
        .collect()
}

fn named(names_of: &[&str]) -> BTreeSet<String> {
    names_of.iter().map(|&name| name.to_owned()).collect()
}

#[test]
fn a_file_is_replaced_and_its_folder_made() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("a/b/text");
    for text in ["first", "second, and longer", ""] {
        write(&path, text.as_bytes()).expect("it can be written");
        assert_eq!(read_text(&path).expect("it can be read"), text);
    }
    let folder = path.parent().expect("it has a folder");
    assert_eq!(names(folder), named(&["text"]), "and nothing else is left");
}

#[test]
fn a_long_name_and_one_without_a_folder_are_names_too() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("x".repeat(255));
    write(&path, b"text").expect("as long as names may be");
    let error = write(&home.path().join("x".repeat(256)), b"text").expect_err("longer");
    assert!(error.to_string().contains("cannot write this file"));
    assert_eq!(names(home.path()).len(), 1, "nothing is left of that");
    let error = read(Path::new("no-such-file")).expect_err("there is none");
    let start = "no-such-file: cannot read this file: ";
    assert!(error.to_string().starts_with(start), "{error}");
    assert_eq!(error.reason.kind(), ErrorKind::NotFound);
}

#[test]
fn many_writers_of_one_file_leave_one_whole_text() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("text");
    let text = |writer: u8| vec![writer; 50_000];
    thread::scope(|scope| {
        for writer in 0..12 {
            let (path, bytes) = (&path, text(writer));
            scope.spawn(move || (0..10).try_for_each(|_| write(path, &bytes)));
        }
        let whole = |bytes: Vec<u8>| bytes.len() == 50_000 && bytes.iter().all(|b| *b == bytes[0]);
        let mut seen = 0;
        while seen < 50 {
            match read(&path) {
                Ok(bytes) => {
                    assert!(whole(bytes), "one writer's, all of it");
                    seen += 1;
                }
                Err(error) => assert_eq!(error.reason.kind(), ErrorKind::NotFound, "{error}"),
            }
        }
    });
    assert_eq!(names(home.path()), named(&["text"]));
}

#[test]
fn a_file_larger_than_the_budget_is_not_read() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("huge.exr");
    // It takes no room on the disk.
    let file = fs::File::create(&path).expect("it can be made");
    file.set_len(BUDGET + 1).expect("it can be so long");
    let error = read(&path).expect_err("it is too large").to_string();
    assert!(
        error.contains("huge.exr") && error.contains("at most 1.1 GB are read"),
        "{error}"
    );
    file.set_len(1 << 40).expect("longer than any memory");
    assert!(read(&path).is_err(), "and nothing is asked for");
}

#[test]
fn a_new_folder_has_all_its_files() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let files: Vec<_> = ["src/a.rs", "src/b/c.rs", "marker"]
        .map(|path| (PathBuf::from(path), path.as_bytes().to_vec()))
        .into();
    let all_there = |folder: &Path| {
        for (path, bytes) in &files {
            assert_eq!(read(&folder.join(path)).expect("it is there"), *bytes);
        }
        assert_eq!(names(folder), named(&["src", "marker"]), "and nothing else");
    };
    let new = home.path().join("some/where/new");
    new_folder(&new, &files).expect("it can be made");
    all_there(&new);
    assert_eq!(
        names(new.parent().expect("a folder")),
        named(&["new"]),
        "nothing is left beside it"
    );

    let empty = home.path().join("empty");
    fs::create_dir(&empty).expect("it can be made");
    new_folder(&empty, &files).expect("it is empty");
    all_there(&empty);

    let error = new_folder(&new, &files).expect_err("it is there");
    assert!(error.to_string().contains("it is not empty"), "{error}");
    all_there(&new);
    let error = new_folder(&new.join("marker"), &files).expect_err("a file");
    assert!(error.to_string().contains("a file of this name"), "{error}");
}

#[test]
fn an_interrupted_folder_is_completed_and_nothing_that_is_there_is_lost() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = home.path();
    let files: Vec<_> = ["src/a.rs", "book/b.md", "marker"]
        .map(|path| (PathBuf::from(path), path.as_bytes().to_vec()))
        .into();
    // As a run leaves it that was killed after it placed the first of three.
    fs::create_dir_all(folder.join(".raybook-new.partial/book")).expect("a folder");
    fs::create_dir(folder.join("src")).expect("a folder");
    fs::write(folder.join("src/a.rs"), "already edited").expect("a file");
    new_folder(folder, &files).expect("it is completed");
    assert_eq!(names(folder), named(&["src", "book", "marker"]));
    let text = |name: &str| read_text(&folder.join(name)).expect("it is there");
    assert_eq!(text("src/a.rs"), "already edited", "that was whole");
    assert_eq!(text("book/b.md"), "book/b.md", "and this is now");
}

#[test]
fn two_new_folders_of_one_name_are_one_of_them() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for round in 0..20 {
        let folder = home.path().join(round.to_string());
        let made = thread::scope(|scope| {
            let make = |who: &'static str| {
                let files = ["a", "b", "c"].map(|name| (name.into(), who.as_bytes().to_vec()));
                let folder = &folder;
                scope.spawn(move || new_folder(folder, &files))
            };
            [make("one"), make("two")].map(|maker| maker.join().expect("no panic").is_ok())
        });
        assert_ne!(made[0], made[1], "one is first, and the other is told");
        let who = if made[0] { "one" } else { "two" };
        for name in ["a", "b", "c"] {
            assert_eq!(read_text(&folder.join(name)).expect("it is there"), who);
        }
    }
    assert_eq!(names(home.path()).len(), 20, "nothing else is left");
}

#[cfg(unix)]
mod traps {
    use super::{fs, names, read, store, write};
    use raybook::image::{Image, file, rgb::Rgb};
    use raybook::shape::mesh_file;
    use std::os::unix::fs::{FileTypeExt, symlink};
    use std::os::unix::net::UnixListener;
    use std::path::Path;
    use std::process::Command;

    fn fifo(path: &Path) {
        let made = Command::new("mkfifo").arg(path).status();
        assert!(made.is_ok_and(|status| status.success()), "a named pipe");
    }

    #[test]
    fn what_is_no_file_is_refused_at_once() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let path = |name: &str| home.path().join(name);
        fifo(&path("pipe"));
        symlink(path("pipe"), path("link to pipe")).expect("a link");
        fs::create_dir(path("folder")).expect("a folder");
        let _listener = UnixListener::bind(path("socket")).expect("a socket");
        for (name, what) in [
            (path("pipe"), "a named pipe (FIFO)"),
            (path("link to pipe"), "a named pipe (FIFO)"),
            (path("folder"), "a folder"),
            (path("socket"), "a socket"),
            ("/dev/zero".into(), "a device"),
            ("/dev/tty".into(), "a device"),
        ] {
            let error = read(&name).expect_err("it is no file").to_string();
            let expected = format!("{}: cannot read this file: it is {what}", name.display());
            assert_eq!(error, expected);
        }
        for name in ["pipe", "folder", "socket"] {
            let error = write(&path(name), b"text").expect_err("it is no file");
            assert!(error.to_string().contains(": it is a "), "{error}");
        }
        let kept = fs::symlink_metadata(path("pipe")).expect("it is there");
        assert!(kept.file_type().is_fifo(), "and it is not replaced");
        assert_eq!(names(home.path()).len(), 4, "nothing is left");
    }

    #[test]
    fn every_reader_refuses_a_pipe() {
        let home = tempfile::tempdir().expect("a temporary folder");
        for name in ["a.exr", "a.hdr", "a.png", "a.obj", "a.stl", "a.ply"] {
            let path = home.path().join(name);
            fifo(&path);
            let error = match name {
                "a.obj" | "a.stl" | "a.ply" => {
                    mesh_file::load(&path).expect_err("a pipe").to_string()
                }
                _ => file::load(&path).expect_err("a pipe").to_string(),
            };
            assert!(error.contains("it is a named pipe (FIFO)"), "{error}");
            assert!(error.contains(name), "{error}");
        }
    }

    #[test]
    fn a_link_is_replaced_and_what_it_leads_to_is_not_touched() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let victim = home.path().join("victim");
        fs::write(&victim, "mine").expect("a file");
        for target in [&victim, &home.path().join("nothing")] {
            let link = home.path().join("picture.png");
            symlink(target, &link).expect("a link");
            file::save(&link, &Image::from_fn(2, 2, |_, _| Rgb::WHITE)).expect("it is written");
            let kept = fs::symlink_metadata(&link).expect("it is there");
            assert!(kept.is_file(), "a file of its own");
            fs::remove_file(link).expect("it can be removed");
        }
        assert_eq!(store::read(&victim).expect("it is there"), b"mine");
        assert!(!home.path().join("nothing").exists());
    }

    /// The names are not foreseen, so that nobody can be there before; those that one could foresee are not used.
    #[test]
    fn what_waits_at_a_name_that_could_be_foreseen_is_not_touched() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let victim = home.path().join("victim");
        fs::write(&victim, "mine").expect("a file");
        for trap in ["text.partial", "text.tmp", ".text.partial", "text~"] {
            symlink(&victim, home.path().join(trap)).expect("a link");
        }
        for _ in 0..100 {
            write(&home.path().join("text"), b"yours").expect("it is written");
        }
        assert_eq!(store::read(&victim).expect("it is there"), b"mine");
        assert_eq!(names(home.path()).len(), 6, "nothing else is left");
    }
}
