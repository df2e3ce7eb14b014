//! Figures, as wide as their letters need.

use super::{book, expanded};
use raybook::store;

#[test]
fn a_drawing_is_shown_as_vectors_and_never_too_small_to_read() {
    let pictures = tempfile::tempdir().expect("a folder");
    let folder = pictures.path().join("ch03_sphere");
    let svg = r#"<svg viewBox="0 0 2000 1000"><text font-size="25">a</text><text font-size="40">b</text></svg>"#;
    store::write(&folder.join("roots.svg"), svg.as_bytes()).expect("it can be written");
    let book = book(pictures.path(), &[]);
    let figure = |name| {
        let directive = format!("{{{{figure {name} | a drawing}}}}");
        expanded(&book, "ch03_sphere.md", &directive).expect("it is a figure")
    };
    let drawing = figure("roots");
    for part in [
        "class=\"drawing\"",
        "src=\"pictures/ch03_sphere/roots.svg\"",
        "--narrowest: 880px", // where the letters of 25 are 11 pixels high
    ] {
        assert!(drawing.contains(part), "{part} is in {drawing}");
    }
    let png = [&[0; 16][..], &1000_u32.to_be_bytes()].concat();
    for name in ["picture", "sheet"] {
        store::write(&folder.join(format!("{name}.png")), &png).expect("it can be written");
    }
    let sheet = figure("sheet");
    assert!(sheet.contains("class=\"sheet\"") && sheet.contains("--narrowest: 594px"));
    store::write(
        &pictures.path().join("ch22_antialiasing/zone_plates.png"),
        &png,
    )
    .expect("it can be written");
    let rings = figure("ch22_antialiasing/zone_plates");
    assert!(rings.contains("class=\"sheet unscaled\""), "{rings}");
    let picture = figure("picture");
    assert!(
        picture.contains("src=\"pictures/ch03_sphere/picture.png\"") && !picture.contains("style")
    );
}
