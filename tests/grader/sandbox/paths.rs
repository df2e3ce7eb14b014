//! Which files a program may read.

use raybook_grader::sandbox::paths::{Readable, less, own};
use std::fs;
use std::path::Path;

#[test]
fn what_is_hidden_is_in_no_rule() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let root = home.path().canonicalize().expect("it is there");
    fs::create_dir_all(root.join("a/golden")).expect("folders");
    for file in ["a/mine", "a/golden/answers", "key", "other"] {
        fs::write(root.join(file), "").expect("a file");
    }
    std::os::unix::fs::symlink(root.join("key"), root.join("a/link")).expect("a link");
    let mut rules = less(&root, &[root.join("a/golden"), root.join("key")]);
    rules.sort();
    assert_eq!(
        rules,
        [
            Readable::All(root.join("a/mine")),
            Readable::All(root.join("other")),
            Readable::Names(root.clone()),
            Readable::Names(root.join("a")),
        ],
        "neither what is hidden, nor the link to it"
    );
    assert_eq!(
        less(&root, std::slice::from_ref(&root)),
        [],
        "all of it is hidden"
    );
    assert_eq!(
        less(&root, &[]),
        [Readable::All(root.clone())],
        "nothing is hidden: one rule"
    );
}

#[test]
fn a_file_in_a_shared_folder_is_alone() {
    let shared = std::env::temp_dir().join("raybook-alone");
    fs::write(&shared, "").expect("a file");
    let alone = own(&shared);
    fs::remove_file(&shared).expect("it is removed");
    assert_eq!(alone, Some(shared.canonicalize().unwrap_or(shared)));
    assert_eq!(
        own(Path::new("/usr/bin/env")),
        Path::new("/usr/bin").canonicalize().ok()
    );
}
