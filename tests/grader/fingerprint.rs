//! Fingerprints.

use raybook_grader::fingerprint::of;

#[test]
fn parts_do_not_run_into_each_other() {
    let print = |parts: &[&str]| of(parts.iter().map(|part| part.as_bytes()), 16);
    assert_eq!(print(&["ab", "c"]).len(), 16);
    assert_eq!(print(&["ab", "c"]), print(&["ab", "c"]));
    assert_ne!(print(&["ab", "c"]), print(&["a", "bc"]));
    assert_ne!(print(&["ab", ""]), print(&["ab"]));
}
