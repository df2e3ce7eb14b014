//! The tokens of a source text.

use raybook_grader::class::tokens::{Token, tokens};
use raybook_grader::language::Language;

#[test]
fn comments_spaces_and_names_do_not_count() {
    let kinds_in = |language, text: &str| {
        let tokens = tokens(language, text);
        tokens
            .iter()
            .map(|token: &Token| token.kind)
            .collect::<Vec<_>>()
    };
    let kinds = |text: &str| kinds_in(Language::Cpp, text);
    let one = "let t = a.dot(b); // the distance\nreturn \"a \\\" b\";";
    let two = "let distance=origin.dot( direction ) ;/* */ return \"c\";";
    assert_eq!(kinds(one), kinds(two));
    assert_ne!(kinds(one), kinds("let t = a.dot(b) + 1;"));
    assert_eq!(
        kinds_in(
            Language::Python,
            "x = 1 # a comment\n\"\"\"a\nlong one\"\"\"\n'''b'''"
        ),
        kinds_in(Language::Python, "y = 22.5")
    );
    assert_ne!(
        kinds_in(Language::Python, "x = 7 // 2; y = x * x"),
        kinds_in(Language::Python, "x = 7 // 3"),
        "two slashes divide"
    );
    assert_eq!(
        tokens(Language::Cpp, "a\u{e9} ' \" open").len(),
        3,
        "nothing makes it panic"
    );
}
