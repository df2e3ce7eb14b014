//! The page "Scene files" of the book names everything that a scene file may say.

use crate::{CAMERA, error};
use raybook_common::source::read;

/// Texts that end where the reader wants one of its words.
const ASKS: [&str; 9] = [
    "kind",
    "[integrator]\nkind",
    "[sampler]\nkind",
    "[picture]\nfilter",
    "[picture]\ntone",
    "[materials.a]\nkind",
    "[[shapes]]\nkind",
    "[[lights]]\nkind",
    "kind = 'fisheye'\nprojection",
];

#[test]
fn the_page_names_every_word_that_the_reader_knows() {
    let page = read("book/src/scene_files.md");
    let patterns = "a pattern of chapter 22";
    assert!(page.contains(patterns));
    for ask in ASKS {
        let error = error(&format!("{CAMERA}{ask} = '?'\n"));
        let (_, known) = error
            .split_once("is none of ")
            .unwrap_or_else(|| panic!("{ask}: {error}"));
        let words: Vec<_> = known.split('`').skip(1).step_by(2).collect();
        assert!(words.len() >= 2, "{ask}: {error}");
        for word in words {
            let is_pattern = raybook::sample::pattern::find(word).is_some();
            assert!(
                is_pattern || page.contains(&format!("`\"{word}\"`")),
                "{ask}: the page does not name \"{word}\""
            );
        }
    }
}
