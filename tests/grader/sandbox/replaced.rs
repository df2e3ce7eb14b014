//! A program that another build has replaced since.

use raybook_grader::inside::sandbox::as_it_was;
use std::path::Path;

#[test]
fn a_program_that_was_replaced_is_hidden_where_it_was() {
    for (said, place) in [
        ("/bin/raybook", "/bin/raybook"),
        ("/bin/raybook (deleted)", "/bin/raybook"),
    ] {
        assert_eq!(as_it_was(said.into()), Path::new(place));
    }
}
