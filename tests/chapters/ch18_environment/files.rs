//! Maps from files, by the chapter's binary as a person calls it.

use assert_cmd::Command;
use raybook::image::{Image, file, rgb::Rgb};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Runs the chapter with this map, and returns whether it went well and what was said of errors.
fn run(map: &Path, more: &[&str], out: &TempDir) -> (bool, String) {
    let output = Command::cargo_bin("ch18_environment")
        .expect("the chapter is built")
        .args(["--width", "24", "--samples", "1", "--out"])
        .arg(out.path())
        .arg("--environment")
        .arg(map)
        .args(more)
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!said.contains("panicked"), "{}: {said}", map.display());
    (output.status.success(), said)
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn picture(out: &TempDir) -> Image {
    let path = out.path().join("ch18_environment/picture.exr");
    file::load(&path).expect("the picture is there")
}

#[test]
fn maps_of_any_size_and_both_formats_light_the_scene() {
    for extension in ["exr", "hdr"] {
        for (width, height) in [(1, 1), (1, 7), (5, 1), (64, 32), (33, 100)] {
            let out = folder();
            let map = out.path().join("map").with_extension(extension);
            let white = Image::from_fn(width, height, |_, _| Rgb::WHITE);
            file::save(&map, &white).expect("it can be written");
            for layout in ["latlong", "cross", "angular"] {
                let (well, said) = run(&map, &["--layout", layout], &out);
                assert!(well, "{width} × {height} {extension}, {layout}: {said}");
                let top_left = picture(&out).at(0, 0).g;
                assert!(
                    (0.0..=1.01).contains(&top_left),
                    "{layout}: the sky is white, or not in the layout: {top_left}"
                );
                assert!(
                    layout != "latlong" || (top_left - 1.0).abs() < 0.01,
                    "{width} × {height} {extension}: the sky is white, not {top_left}"
                );
            }
        }
    }
}

#[test]
fn a_black_map_makes_a_black_picture() {
    let out = folder();
    let map = out.path().join("night.exr");
    file::save(&map, &Image::from_fn(8, 4, |_, _| Rgb::BLACK)).expect("it can be written");
    let (well, said) = run(&map, &[], &out);
    assert!(well, "{said}");
    let black = |pixel: &Rgb| *pixel == Rgb::BLACK;
    assert!(picture(&out).pixels().iter().all(black), "all is dark");
}

#[test]
fn a_map_that_holds_no_numbers_makes_a_picture_that_does() {
    let out = folder();
    let map = out.path().join("wild.exr");
    let wild = [f32::NAN, f32::INFINITY, -1.0, 1.0];
    let texels = Image::from_fn(8, 4, |x, y| Rgb::gray(wild[(x + y) % 4]));
    file::save(&map, &texels).expect("it can be written");
    let (well, said) = run(&map, &[], &out);
    assert!(well, "{said}");
    let finite = |pixel: &Rgb| pixel.channels().iter().all(|v| v.is_finite() && *v >= 0.0);
    assert!(picture(&out).pixels().iter().all(finite), "every pixel");
}

#[test]
fn bad_files_are_errors_for_people() {
    let out = folder();
    let good = out.path().join("good.hdr");
    file::save(&good, &Image::from_fn(16, 8, |_, _| Rgb::WHITE)).expect("it can be written");
    let bytes = fs::read(&good).expect("it can be read");
    let nothing: &[u8] = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 0\n";
    let huge: &[u8] = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4000000000 +X 4000000000\n";
    let cases = [
        ("cut off.hdr", &bytes[..bytes.len() / 2]),
        ("empty.hdr", b""),
        ("no texels.hdr", nothing),
        ("too large.hdr", huge),
        ("not a picture.exr", b"hello"),
        ("another format.exr", &bytes),
        ("a letter.txt", b"Dear reader"),
    ];
    for (name, bytes) in cases {
        let map = out.path().join(name);
        fs::write(&map, bytes).expect("it can be written");
        let (well, said) = run(&map, &[], &out);
        assert!(!well, "{name} is no map");
        assert!(
            said.starts_with("error: ") && said.contains(name),
            "{name}: the message names the file: {said}"
        );
    }
    let missing = out.path().join("missing.exr");
    let (well, said) = run(&missing, &[], &out);
    assert!(!well && said.contains("missing.exr"), "{said}");
}
