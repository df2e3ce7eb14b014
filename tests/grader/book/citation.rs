//! Citations, which lead to the bibliography.

use super::{book, expanded};
use std::path::Path;

#[test]
fn a_citation_leads_to_its_work() {
    let works = "- Timothy L. Kay and James T. Kajiya, 1986: \"Slabs\".\n- James T. Kajiya, 1986: \"The rendering equation\".\n\
        - Eric Veach and Leonidas J. Guibas, 1995: \"Optimally\".";
    let book = book(Path::new(""), &[("bibliography.md", works)]);
    for (text, linked) in [
        (
            "emits (Kajiya 1986):",
            "emits ([Kajiya 1986](bibliography.md#the-rendering-equation)):",
        ),
        (
            "As Kajiya (1986) says",
            "As [Kajiya (1986)](bibliography.md#the-rendering-equation) says",
        ),
        (
            "(Kajiya 1986, Veach and Guibas 1995)",
            "([Kajiya 1986](bibliography.md#the-rendering-equation), [Veach and Guibas 1995](bibliography.md#optimally))",
        ),
        (
            "(Kay and Kajiya 1986)",
            "([Kay and Kajiya 1986](bibliography.md#slabs))",
        ),
        (
            "by Eric Veach and Leonidas J. Guibas (1995).",
            "by [Eric Veach and Leonidas J. Guibas (1995)](bibliography.md#optimally).",
        ),
        (
            "Kajiya and others 1986",
            "[Kajiya and others 1986](bibliography.md#the-rendering-equation)",
        ),
        ("in 1986, Kajiya 1987", "in 1986, Kajiya 1987"),
    ] {
        assert_eq!(expanded(&book, "why.md", text).as_deref(), Ok(linked));
    }
    let work = expanded(&book, "bibliography.md", "- Archimedes, 1986: *On x*");
    let with_place = "- <a id=\"on-x\"></a>Archimedes, 1986: *On x*";
    assert_eq!(work.as_deref(), Ok(with_place));
}
