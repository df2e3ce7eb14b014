//! Listings, whose lines are as long as a page is wide.

use raybook_grader::book::WIDEST;
use raybook_grader::cases;
use raybook_grader::inside::book::fit;
use raybook_grader::starter::python;

#[test]
fn long_lines_are_broken_and_nothing_is_lost() {
    let words = "word ".repeat(40);
    for start in ["    /// ", "    let x = ", "# "] {
        let text = format!("{start}{words}\n");
        let fitted = fit(&text);
        assert!(
            fitted.lines().all(|line| line.chars().count() <= WIDEST),
            "every line fits: {fitted}"
        );
        assert!(fitted.lines().count() > 2, "it was too long");
        assert_eq!(fitted.matches("word").count(), 40, "no word is lost");
    }
}

#[test]
fn what_is_left_of_a_comments_line_is_filled_up_from_the_next() {
    let words = "word ".repeat(20);
    let text = format!("    /// {words}\n    /// and on.\n    /// - {words}\n    fn f() {{}}\n");
    let full = format!("/// {}", "word ".repeat(16));
    let full = full.trim_end();
    assert_eq!(
        fit(&text),
        format!(
            "{full}\n/// word word word word and on.\n/// - {}\n/// word word word word\nfn f() {{}}\n",
            "word ".repeat(16).trim_end()
        )
    );
}

#[test]
fn a_comment_at_the_end_of_a_line_stays_a_comment() {
    let code = "within: within.min(1.0 - f32::EPSILON / 2.0),";
    let comment = "// it may have been rounded up to the next whole number";
    assert_eq!(
        fit(&format!("    {code} {comment}\n")),
        format!("{code}\n        {comment}\n")
    );
}

#[test]
fn code_is_broken_after_a_comma() {
    let parameters = "first: Vec3, second: Vec3, third: Vec3, fourth: f64";
    assert_eq!(
        fit(&format!(
            "def sphere_hit({parameters}, fifth: f64) -> f64 | None:\n"
        )),
        format!("def sphere_hit({parameters},\n        fifth: f64) -> f64 | None:\n"),
        "Python goes on in the next line within parentheses only"
    );
}

#[test]
fn a_string_is_not_broken() {
    let text = format!("    let x = \"{}\";\n", "word ".repeat(40));
    assert_eq!(fit(&text), text.trim_start(), "a space in a string counts");
}

#[test]
fn a_signature_in_python_goes_on_within_parentheses_only() {
    let mut broken = 0;
    for examiner in cases::all() {
        let signature = fit(&python::signature(examiner.asked()));
        let mut open = 0;
        for line in signature.lines() {
            open += line.matches('(').count();
            open -= line.matches(')').count();
            broken += usize::from(open > 0);
            assert!(open > 0 || line.ends_with(':'), "no Python: {signature}");
        }
    }
    assert!(broken > 10, "{broken} lines go on");
}
