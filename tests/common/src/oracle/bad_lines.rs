//! What the reader of recordings says about lines that are not right.

use crate::oracle::recording::parse;

#[test]
fn a_bad_line_is_named_and_says_what_was_expected() {
    let good = "front  0 0 3  0 0 1  0 inf  sphere 0 0 0 1  = 2 0 0 0 0 0 1";
    assert!(
        parse("f", good).is_ok_and(|lines| lines.len() == 1),
        "the good line is read"
    );
    for (from, to, expected) in [
        (
            " = 2",
            " 2",
            "f:2: ` = ` is missing between question and answer",
        ),
        (
            "0 0 3 ",
            "0 x 3 ",
            "f:2: expected the ray's origin, found `x`",
        ),
        (
            "  0 0 1  0 inf",
            "  0 0 2  0 inf",
            "f:2: expected the ray's direction of length 1, found 0 0 2",
        ),
        (
            "sphere",
            "torus",
            "f:2: expected sphere, triangle, plane, cuboid or mesh, found `torus`",
        ),
        (
            "sphere 0 0 0 1",
            "sphere 0 0 0",
            "f:2: expected the radius, found the end",
        ),
        (
            "sphere 0 0 0 1",
            "sphere 0 0 0 1 1",
            "f:2: expected the end, found `1`",
        ),
        (
            "sphere 0 0 0 1",
            "mesh cow 5",
            "f:2: there is no mesh `cow`",
        ),
        (
            "sphere 0 0 0 1",
            "triangle 0 0 0 1 0 0 inf 1 0",
            "f:2: vertex 2 has a coordinate that is not a finite number",
        ),
        (
            "= 2 0",
            "= two 0",
            "f:2: expected t, or `none`, found `two`",
        ),
        (
            "0 0 0 0 0 1",
            "0 0 0 0 0",
            "f:2: expected the normal, found the end",
        ),
    ] {
        let bad = good.replacen(from, to, 1);
        let error = parse("f", &format!("# comment\n{bad}\n")).err();
        assert_eq!(error.as_deref(), Some(expected), "reading `{bad}`");
    }
}
