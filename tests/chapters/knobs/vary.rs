//! A picture at several values of a knob.

use super::run;
use raybook::image::file;
use std::fs;

#[test]
fn a_varied_knob_makes_a_labelled_strip_or_an_animation() {
    let (code, said, out) = run(
        "ch03_sphere",
        &["--vary", "radius=0.1,0.3,0.5", "--distance", "2"],
    );
    assert_eq!(code, Some(0), "{said}");
    let folder = out.path().join("ch03_sphere");
    let strip = file::load(&folder.join("vary_radius.png")).expect("the strip is there");
    assert!(
        strip.width() > 3 * 32 && strip.height() > 18,
        "three pictures side by side"
    );
    let picture =
        |name: &str| fs::read(folder.join(name).join("picture.png")).expect("each is kept");
    assert!(
        picture("radius_0.1") != picture("radius_0.5"),
        "they differ"
    );

    let (code, said, out) = run("ch12_phong", &["--vary", "samples=1,4"]);
    assert_eq!(code, Some(0), "{said}");
    let picture = |name: &str| {
        let folder = out.path().join("ch12_phong").join(name);
        fs::read(folder.join("picture.png")).expect("each is kept")
    };
    assert!(
        picture("samples_1") != picture("samples_4"),
        "an option beside the knobs"
    );

    let (code, said, out) = run("ch03_sphere", &["--vary", "radius=0.1,0.3", "--animate"]);
    assert_eq!(code, Some(0), "{said}");
    let bytes = fs::read(out.path().join("ch03_sphere/vary_radius.png")).expect("it is there");
    let frames = bytes.windows(4).filter(|chunk| chunk == b"fcTL").count();
    assert_eq!(frames, 2, "a frame for each value");
}
