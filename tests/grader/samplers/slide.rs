//! Rotated grid, jittered and Poisson disk on one slide.

use super::samplers;
use std::fs;

#[test]
fn the_slide_is_a_picture_a_drawing_and_numbers_that_say_who_wins() {
    let out = tempfile::tempdir().expect("a temporary folder");
    samplers(out.path(), &["--slide", "--quick"]).success();
    let read = |name: &str| fs::read(out.path().join(name)).expect("it is there");
    let png = read("slide.png");
    // The header of a PNG has the width at byte 16 and the height at byte 20.
    let at = |i: usize| u32::from_be_bytes([png[i], png[i + 1], png[i + 2], png[i + 3]]);
    assert_eq!(
        (at(16), at(20)),
        (3840, 2160),
        "16:9, at twice the resolution"
    );
    let svg = String::from_utf8(read("slide.svg")).expect("text");
    let drawing = roxmltree::Document::parse(&svg).expect("XML");
    let root = drawing.root_element();
    assert_eq!(
        root.attribute("width"),
        Some("100%"),
        "as wide as any screen"
    );
    assert_eq!(root.attribute("viewBox"), Some("0 0 3840 2160"), "16:9");
    let images = drawing
        .descendants()
        .filter(|node| node.has_tag_name("image"));
    assert_eq!(images.count(), 6, "rings and spectra of three patterns");
    assert!(svg.len() < 1_500_000, "small: {}", svg.len());
    let sizes = drawing
        .descendants()
        .filter_map(|node| node.attribute("font-size"));
    let least = sizes.map(|size| size.parse::<f64>().expect("a number"));
    let least = least.fold(f64::INFINITY, f64::min);
    assert!(
        (12.0..30.0).contains(&(least / 3.0)),
        "on a projector of 720 lines the smallest letters have {} pixels",
        least / 3.0
    );
    let csv = String::from_utf8(read("slide.csv")).expect("text");
    let numbers = |measure: &str| -> Vec<f64> {
        let line = csv.lines().find(|line| line.contains(measure));
        let line = line.unwrap_or_else(|| panic!("{measure}: {csv}"));
        let (_, numbers) = line.rsplit_once("\",").expect("numbers behind a name");
        numbers
            .split(',')
            .map(|v| v.parse().expect("a number"))
            .collect()
    };
    let axes = numbers("4 samples, along the axes");
    assert!(
        axes[0] < 0.7 * axes[1],
        "the rotated grid wins along the axes: {axes:?}"
    );
    let alias = numbers("highest alias");
    assert!(alias[0] > 10.0 * alias[1], "and has aliases: {alias:?}");
    let noise = numbers("coarse noise");
    assert!(
        noise[2] < 0.5 * noise[1],
        "the disk is quieter than jittered points: {noise:?}"
    );
}
