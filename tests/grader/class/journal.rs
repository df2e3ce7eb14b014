//! The journal of a run, cut off, changed and merged.

use raybook_grader::class::journal::{FILE, Journal, read};
use serde_json::json;
use std::fs;

#[test]
fn whatever_is_cut_off_the_rest_is_whole() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(FILE);
    let mut journal = Journal::open(folder.path()).expect("it is made");
    for i in 0..3 {
        journal
            .add(&json!({ "i": i, "text": "\n\u{e9}" }))
            .expect("it is added");
    }
    let whole = fs::read(&path).expect("it is there");
    for end in 0..=whole.len() {
        fs::write(&path, &whole[..end]).expect("it is cut");
        let cut = read(folder.path()).expect("it is read");
        assert!(cut.records.len() <= 3 && cut.damaged <= 1, "{end}");
        let mut journal = Journal::open(folder.path()).expect("it is opened again");
        journal.add(&json!("after")).expect("it is added");
        let told = read(folder.path()).expect("it is read");
        assert_eq!(
            told.records.len(),
            cut.records.len() + 1,
            "{end}: what is added is whole"
        );
        assert_eq!(told.damaged, cut.damaged, "{end}");
    }
}

#[test]
fn a_changed_byte_is_noticed() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(FILE);
    let mut journal = Journal::open(folder.path()).expect("it is made");
    journal.add(&json!({ "grade": 1 })).expect("it is added");
    let text = fs::read_to_string(&path).expect("it is there");
    fs::write(&path, text.replace(":1", ":9")).expect("it is forged");
    let told = read(folder.path()).expect("it is read");
    assert_eq!((told.records.len(), told.damaged), (0, 1));
}

#[test]
fn journals_are_merged_by_concatenation() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(FILE);
    let mut journal = Journal::open(folder.path()).expect("it is made");
    journal.add(&json!(1)).expect("it is added");
    let whole = fs::read(&path).expect("it is there");
    // The first was cut in the middle of its second record.
    let cut = [&whole[..], &whole[..whole.len() - 5], &whole[..]].concat();
    fs::write(&path, cut).expect("it is merged");
    let told = read(folder.path()).expect("it is read");
    assert_eq!((told.records.len(), told.damaged), (2, 1));
}
