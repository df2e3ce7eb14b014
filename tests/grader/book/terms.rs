//! The terms of the glossary.

use super::{book, expanded};
use std::path::Path;

#[test]
fn each_term_is_a_heading_below_its_letter() {
    let book = book(Path::new(""), &[]);
    let written = "albedo\n: A share.\naliasing\n: A fault.\nA paragraph.\n\nBRDF\n: A function.\n";
    let built = "## A\n\n### albedo\n\nA share.\n### aliasing\n\nA fault.\nA paragraph.\n\n## B\n\n### BRDF\n\nA function.";
    let expanded = expanded(&book, "glossary.md", written);
    assert_eq!(expanded.as_deref(), Ok(built));
}
