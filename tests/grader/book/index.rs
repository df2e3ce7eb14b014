//! The index of the book.

use super::{book, expanded};
use std::path::Path;

#[test]
fn a_term_leads_to_the_page_that_explains_it_and_to_all_that_mention_it() {
    let pages = [
        (
            "ch03_sphere.md",
            "# Sphere\n\nNo shadow, no ray!\n\n```\nshadow ray\n```\n",
        ),
        ("ch15_shadows.md", "# Shadows\n\nA shadow ray.\n"),
        ("why.md", "# Why: rays\n\n**Shadow\nrays** are rays.\n"),
        (
            "glossary.md",
            "# Glossary\n\nshadow ray\n: A ray to a lamp. [Shadows](ch15_shadows.md#the-idea)\n",
        ),
        ("teach.md", "# Teach\n\nA shadow ray.\n"),
    ];
    let book = book(Path::new(""), &pages);
    let index = |page: &str| expanded(&book, "index.md", &format!("{{{{index {page}}}}}"));
    let of_glossary = index("glossary.md").expect("it has a term");
    for part in [
        r#"<a href="glossary.html#shadow-ray">shadow ray</a>"#,
        r#"<b><a href="ch15_shadows.html#the-idea">15</a></b>"#,
        r#", <a href="why.html">Why</a>"#,
    ] {
        assert!(of_glossary.contains(part), "{part} is in {of_glossary}");
    }
    for absent in ["ch03", "teach"] {
        assert!(
            !of_glossary.contains(absent),
            "neither a listing nor what comes after the glossary is mentioned: {of_glossary}"
        );
    }
    assert!(index("words.md").is_err(), "no such page");
}
