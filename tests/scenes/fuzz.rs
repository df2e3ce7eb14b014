//! Nothing makes the reader panic, nor the picture that it reads: the gallery with bytes, numbers and lines changed.

use crate::parse;
use proptest::prelude::*;
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::render::film::Film;
use raybook_common::project;
use std::fs;

fn gallery() -> Vec<String> {
    let files = fs::read_dir(project("chapters/scenes/gallery")).expect("the gallery");
    let paths = files.map(|entry| entry.expect("an entry").path());
    let scenes = paths.filter(|path| path.extension().is_some_and(|e| e == "toml"));
    let mut texts: Vec<_> = scenes
        .map(|path| fs::read_to_string(path).expect("a text"))
        // A few photons instead of millions, which take a second.
        .map(|text| text.replace("photons = 2_000_000", "photons = 2_000"))
        .collect();
    texts.push(OTHERS.to_owned());
    texts.extend(CAMERAS.map(|camera| format!("{camera}{BALL}")));
    texts.sort();
    texts
}

/// Cameras and integrators that neither the gallery nor [`OTHERS`] has: a scene has one.
const CAMERAS: [&str; 3] = [
    "[camera]\nkind = \"panorama\"\nfrom_m = [0, 1, 4]\nto_m = [0, 0, 0]\n",
    "[camera]\nkind = \"fisheye\"\nfrom_m = [0, 1, 4]\nto_m = [0, 0, 0]\nprojection = \"equisolid\"\nview_degrees = 200\n",
    "[camera]\nfrom_m = [0, 1, 4]\nto_m = [0, 0, 0]\n[integrator]\nkind = \"direct\"\nlight_samples = 2\n",
];

/// What they look at.
const BALL: &str = "[picture]\nwidth = 8\nheight = 8\n
[[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 0, 0]\nradius_m = 1\nmaterial = { kind = \"matte\", colour = 0.5 }\n
[[lights]]\nkind = \"directional\"\ntoward = [1, 1, 1]\nirradiance = 2\n
";

/// What the gallery has none of.
const OTHERS: &str = "ambient = 0.2
[picture]\nwidth = 8\nheight = 8\n
[camera]\nfrom_m = [0, 1, 4]\nto_m = [0, 0, 0]\nup = [0, 1, 0]\nfocal_length_mm = 35\nf_number = 2.8\nfocus_m = 4\nblades = 5\n
[integrator]\nkind = \"whitted\"\ndepth = 6\nshadows = true\nlight_samples = 2\n
[sampler]\nkind = \"adaptive\"\nfirst = 2\nmost = 8\nerror = 0.1\n
[environment]\nfile = \"china.png\"\nscale = 2\n
[[shapes]]\nkind = \"box\"\ncorner_m = [-1, -1, -1]\nopposite_m = [1, 0, 1]\nscale = 0.5\nturn_degrees = [10, 20, 30]\nmove_m = [0, 0.1, 0]\nmaterial = { kind = \"phong\", colour = { file = \"china.png\", repeat = 2 }, specular = 0.3, exponent = 40 }\n
[[shapes]]\nkind = \"rectangle\"\ncorner_m = [-2, -1, -2]\na_m = [4, 0, 0]\nb_m = [0, 4, 0]\nmaterial = { kind = \"mirror\", share = 0.9 }\n
[[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 0, 0]\nradius_m = 0.4\nmaterial = { kind = \"glass\", index = 1, outside_index = 1.5 }\n
[[shapes]]\nkind = \"sphere\"\ncenter_m = [1, 0, 0]\nradius_m = 0.4\nmaterial = { kind = \"blinn-phong\", colour = 0.8, specular = 0.2, exponent = 90 }\n
[[lights]]\nkind = \"point\"\nposition_m = [1, 2, 3]\nintensity = [9, 8, 7]\n
[[lights]]\nkind = \"directional\"\ntoward = [1, 1, 1]\nirradiance = 2\n
";

/// Reads it, and draws a few pixels of what can be read.
fn survive(text: &str) -> bool {
    let Ok(shot) = parse(text) else {
        return false;
    };
    shot.render(&Film {
        threads: 1,
        ..Film::new(3, 2, 2)
    });
    true
}

/// Numbers at the ends of what there is, and beyond.
const NUMBERS: [&str; 16] = [
    "0",
    "-0.0",
    "-1",
    "1e-45",
    "1e-30",
    "1e-9",
    "1e9",
    "1e10",
    "3.4e38",
    "1e39",
    "inf",
    "-inf",
    "nan",
    "0x7fffffffffffffff",
    "8192",
    "1e-6",
];

/// The text with another number in place of one of its numbers.
fn other_number(text: &str, rng: &mut Pcg) -> String {
    let is_number = |c: char| c.is_ascii_digit() || c == '.';
    let starts: Vec<_> = text
        .char_indices()
        .filter(|(i, c)| is_number(*c) && !text[..*i].ends_with(is_number))
        .map(|(i, _)| i)
        .collect();
    let start = starts[rng.random_range(0..starts.len())];
    let end = text[start..]
        .find(|c| !is_number(c))
        .map_or(text.len(), |n| start + n);
    let number = NUMBERS[rng.random_range(0..NUMBERS.len())];
    format!("{}{number}{}", &text[..start], &text[end..])
}

#[test]
fn no_number_makes_a_scene_panic() {
    let (mut read, mut refused) = (0, 0);
    let mut rng = pcg::stream(12, 0);
    for text in gallery() {
        for _ in 0..200 {
            let mut changed = other_number(&text, &mut rng);
            if rng.random() {
                changed = other_number(&changed, &mut rng);
            }
            if survive(&changed) {
                read += 1;
            } else {
                refused += 1;
            }
        }
    }
    assert!(
        read > 100 && refused > 100,
        "{read} were scenes, {refused} were not"
    );
}

#[test]
fn a_scene_that_ends_early_is_read_or_refused() {
    for text in gallery() {
        for end in (0..text.len())
            .step_by(7)
            .filter(|&end| text.is_char_boundary(end))
        {
            let _ = parse(&text[..end]);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn no_bytes_make_a_scene_panic(
        which in any::<prop::sample::Index>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let gallery = gallery();
        let mut bytes = which.get(&gallery).clone().into_bytes();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        survive(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn no_lines_in_another_order_make_a_scene_panic(
        which in any::<prop::sample::Index>(),
        swaps in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..6),
    ) {
        let gallery = gallery();
        let mut lines: Vec<&str> = which.get(&gallery).lines().collect();
        for (a, b) in swaps {
            let (a, b) = (a.index(lines.len()), b.index(lines.len()));
            lines.swap(a, b);
        }
        survive(&lines.join("\n"));
    }
}
