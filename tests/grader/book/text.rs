//! What a text names: chapters, exercises, commands, files and items of the library.

use super::{book, expanded};
use std::path::Path;

#[test]
fn chapters_are_linked_but_for_this_one_and_those_in_code_and_links() {
    let book = book(Path::new(""), &[]);
    for (line, linked) in [
        ("as in chapter 3.", "as in [chapter 3](ch03_sphere.md)."),
        (
            "Chapter 17, chapter 4",
            "[Chapter 17](ch17_rendering_equation.md), chapter 4",
        ),
        (
            "`chapter 3` and [chapter 3](x.md)",
            "`chapter 3` and [chapter 3](x.md)",
        ),
        ("chapter 99, chapter one", "chapter 99, chapter one"),
        ("## chapter 3", "## chapter 3"),
        ("| chapter 3 |", "| [chapter 3](ch03_sphere.md) |"),
        (
            "<figcaption>Chapter 3</figcaption>",
            "<figcaption><a href=\"ch03_sphere.html\">Chapter 3</a></figcaption>",
        ),
    ] {
        assert_eq!(
            expanded(&book, "ch04_plane.md", line).as_deref(),
            Ok(linked)
        );
    }
}

#[test]
fn names_in_back_quotes_are_linked_where_the_book_tells_of_them() {
    let page = ("ch03_sphere.md", "{{turn sphere_hit}}\n");
    let book = book(Path::new(""), &[page]);
    for (line, linked) in [
        (
            "`sphere_hit`",
            "[`sphere_hit`](ch03_sphere.md#turn-sphere_hit)",
        ),
        (
            "in `Dir3::new(v)`",
            "in [`Dir3::new(v)`](library.md#Dir3.new)",
        ),
        (
            "`src/math/ray.rs`.",
            "[`src/math/ray.rs`](library.md#src/math/ray.rs).",
        ),
        (
            "`raybook check ch03`",
            "[`raybook check ch03`](commands.md#check)",
        ),
        ("[the `Ray`](x.md)", "[the `Ray`](x.md)"),
        ("`f32` and `radius`", "`f32` and `radius`"),
        ("```\n```", "```\n```"),
    ] {
        assert_eq!(expanded(&book, "why.md", line).as_deref(), Ok(linked));
    }
}
