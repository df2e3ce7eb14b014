//! What is kept of an earlier build of the book.

use raybook::store;
use raybook_grader::inside::book::or_make;

#[test]
fn what_this_program_made_is_not_made_again_and_anothers_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("gallery.md");
    let made = or_make(&file, || Ok("two\nlines".to_owned()));
    assert_eq!(made.as_deref(), Ok("two\nlines"));
    let again = or_make(&file, || Err("it is made again".to_owned()));
    assert_eq!(again, made);

    store::write(&file, b"another program\nold").expect("it can be written");
    let new = or_make(&file, || Ok("new".to_owned()));
    assert_eq!(new.as_deref(), Ok("new"));
}

#[test]
fn what_fails_is_not_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("gallery.md");
    assert!(or_make(&file, || Err("no".to_owned())).is_err());
    assert!(!file.exists());
}
