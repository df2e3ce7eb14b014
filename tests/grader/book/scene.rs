//! The scene that grows.

use super::{book, expanded};
use raybook::image::file;

#[test]
fn the_scene_grows_from_chapter_to_chapter() {
    let pictures = tempfile::tempdir().expect("a folder");
    let book = book(pictures.path(), &[]);
    let scene = |name: &str| {
        let directive = format!("{{{{scene {name} | a scene}}}}");
        let text = expanded(&book, "why.md", &directive).expect("it can be drawn");
        let png = pictures.path().join(format!("scene/{name}.png"));
        (text, file::load(&png).expect("it is written"))
    };
    let (text, balls) = scene("ch03_sphere");
    assert!(
        text.contains("chapters 1 to 3. New here: balls, "),
        "{text}"
    );
    assert_eq!((balls.width(), balls.height()), (480, 270));
    let (text, floor) = scene("ch04_plane");
    assert!(text.contains("New here: a floor."), "{text}");
    assert_ne!(balls, floor);
}

#[test]
fn a_scene_has_a_chapter_and_words() {
    let pictures = tempfile::tempdir().expect("a folder");
    let book = book(pictures.path(), &[]);
    for (name, alt, words) in [
        ("ch03_sphere", "", "cannot see it"),
        ("ch99_nothing", "a scene", "no chapter `ch99_nothing`"),
    ] {
        let directive = format!("{{{{scene {name} | {alt}}}}}");
        let error = expanded(&book, "why.md", &directive).expect_err("it is wrong");
        assert!(error.contains(words), "{error}");
    }
}
