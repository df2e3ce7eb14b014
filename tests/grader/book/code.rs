//! Listings, in which the names of the library are links.

use clap::Command;
use maud::html;
use raybook_grader::inside::book::{self, Names};

/// What stands between the tags, with its links written `[place|name]`; it stands in `src/shape/sphere.rs`.
fn links(listing: &str) -> String {
    let names = Names::of(&[], &Command::new("raybook"));
    let html = book::html(listing, "src/shape/sphere.rs", &names);
    let inside = html
        .strip_prefix("<pre><code class=\"language-rust noplayground\">")
        .and_then(|html| html.strip_suffix("</code></pre>\n"));
    inside
        .expect("a listing")
        .replace("<a href=\"library.html#", "[")
        .replace("\">", "|")
        .replace("</a>", "]")
}

#[test]
fn names_of_the_library_are_links_wherever_they_stand_in_the_code() {
    for (listing, expected) in [
        (
            "fn hit(ray: &Ray) -> Option<Interval>",
            "fn hit(ray: &amp;[Ray|Ray]) -&gt; Option&lt;[Interval|Interval]&gt;",
        ),
        (
            "let Interval { min, max } = within",
            "let [Interval|Interval] { min, max } = within",
        ),
        ("Interval::AHEAD", "[Interval.AHEAD|Interval::AHEAD]"),
        ("crate::math::Ray { t }", "crate::math::[Ray|Ray] { t }"),
        ("Ray::nothing()", "[Ray|Ray]::nothing()"),
        ("slab::clip(a, b)", "[slab.clip|slab::clip](a, b)"),
        (
            "within.before(hit.before)",
            "within.[Interval.before|before](hit.before)",
        ),
        ("0..Ray", "0..[Ray|Ray]"),
        ("Vec::<Ray>::new()", "Vec::&lt;[Ray|Ray]&gt;::new()"),
    ] {
        assert_eq!(links(listing), expected);
    }
}

#[test]
fn what_only_looks_like_a_name_is_no_link() {
    for listing in [
        "// A Ray that hits.\n",
        "let text = 'x'; \"a Ray, \\\" a Ray\"",
        "struct Ray",
        "radius.ray, ray.Ray, 1Ray, unknown(1), a.map(b)",
        "clip(a, b), Cuboid", // of other files, and not imported here
    ] {
        let shown = html! { (listing) }.into_string();
        assert_eq!(links(listing), shown);
    }
    assert_eq!(links("$x"), "&#36;x");
}
