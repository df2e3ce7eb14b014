//! The library's public items, as they are read from its files.

use raybook_grader::inside::book::{Item, section};

#[test]
fn a_file_tells_its_public_items() {
    let text = "//! Balls.\n//!\n//! More.\n\n/// A ball, as [`Ball::new`] makes it,\n/// and [a page](https://x.y).\n///\n/// More.\n#[derive(Debug)]\npub struct Ball {\n    pub radius: f32,\n}\n\n\
        impl<T: Fn(f32) -> bool> Ball {\n    /// A [`Ray`](crate::math::Ray).\n    pub const fn new(\n        radius: f32,\n    ) -> Self {\n        radius.into()\n    }\n    fn hidden() {}\n}\n\n\
        impl Shape for Ball {\n    fn hit(&self) {}\n}\n\npub trait Shape {\n    /// Hits.\n    fn hit(&self) -> bool;\n}\n\n\
        /// Rolls.\npub fn roll<T>(ball: T) {\n}\n\npub const LARGEST: f32 = 1.0;\n\npub mod x;\n";
    let found = section("src/shape/ball.rs".to_owned(), text);
    assert_eq!(found.says, "Balls.");
    let expected = [
        (
            "Ball",
            "pub struct Ball",
            "A ball, as `Ball::new` makes it, and [a page](https://x.y).",
        ),
        (
            "Ball::new",
            "pub const fn Ball::new(radius: f32) -> Self",
            "A `Ray`.",
        ),
        ("Shape", "pub trait Shape", ""),
        ("Shape::hit", "fn Shape::hit(&self) -> bool", "Hits."),
        ("ball::roll", "pub fn roll<T>(ball: T)", "Rolls."),
        ("LARGEST", "pub const LARGEST: f32", ""),
    ];
    let expected = expected.map(|(name, declaration, says)| Item {
        name: name.to_owned(),
        declaration: declaration.to_owned(),
        says: says.to_owned(),
    });
    assert_eq!(found.items, expected);
}
