//! The blue-noise reference. `RAYBOOK_BLESS=1 cargo test -p raybook-chapters blue_noise` writes it anew.

use raybook_chapters::lab::blue_noise::{BLUE_NOISE, COUNT, SIDE, kept, make};
use raybook_chapters::lab::distances::relative;
use raybook_chapters::lab::nyquist::effective_nyquist;
use raybook_chapters::lab::spectrum::Spectrum;
use raybook_chapters::lab::subject::Subject;
use std::collections::BTreeSet;
use std::fmt::Write;

/// The seed of the file.
const SEED: u64 = 1;

/// The places of all points, in their order, as the file has them.
fn text() -> String {
    let mut text = String::new();
    for line in make(COUNT, SEED).chunks(16) {
        let cells: Vec<_> = line.iter().map(ToString::to_string).collect();
        let _ = writeln!(text, "{}", cells.join(" "));
    }
    text
}

#[test]
fn the_file_holds_what_the_generator_makes() {
    if std::env::var_os("RAYBOOK_BLESS").is_some() {
        let path = raybook_common::project("chapters/lab/blue_noise.txt");
        std::fs::write(path, text()).expect("the file can be written");
        return;
    }
    let cells = kept().iter().map(|p| {
        let at = *p * SIDE as f32;
        at.y as usize * SIDE + at.x as usize
    });
    let cells: Vec<_> = cells.collect();
    assert_eq!(cells.len(), COUNT, "all of it");
    let different: BTreeSet<_> = cells.iter().collect();
    assert_eq!(different.len(), COUNT, "no cell twice");
    // Elsewhere the exponential function may end in another digit, and a tie be broken otherwise.
    if cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        assert_eq!(cells[..40], make(40, SEED), "the first points");
    }
}

#[test]
fn every_prefix_is_blue_noise() {
    let blue = Subject::of(&BLUE_NOISE);
    for n in [64, 200, 256, 1024] {
        let [least, mean] = relative(&blue.points(n, 1));
        assert!(least > 0.5 && mean > 0.75, "{n}: {least}, {mean}");
    }
    let known = Spectrum::of(&blue, 256, 32, 1).radial();
    let radial: Vec<_> = known.iter().map(|k| (k.frequency, k.value)).collect();
    let disk = Spectrum::of(&super::subject("poisson-disk"), 256, 32, 50).radial();
    let low =
        |k: &[raybook_chapters::lab::spectrum::Known]| k[..6].iter().map(|k| k.value).sum::<f64>();
    assert!(
        low(&known) < low(&disk),
        "quieter than a Poisson disk: {} {}",
        low(&known),
        low(&disk)
    );
    let nyquist = effective_nyquist(&radial, 256);
    assert!(nyquist > 0.65, "{nyquist}");
}

#[test]
fn a_realisation_is_the_set_moved_over_the_edges() {
    let blue = Subject::of(&BLUE_NOISE);
    let [one, other] = [1, 2].map(|k| blue.points(100, k));
    assert_ne!(one, other, "by another distance");
    assert!(
        one.iter()
            .all(|p| p.min_element() >= 0.0 && p.max_element() < 1.0),
        "inside"
    );
    let [a, b] = [relative(&one), relative(&other)];
    assert!((a[0] - b[0]).abs() < 1e-3, "as far apart: {a:?} {b:?}");
}
