//! Every chapter draws the picture that was once looked at and kept, and all its pictures, byte for byte, on one thread as
//! on two.
//!
//! `RAYBOOK_BLESS=1 cargo test --test chapters golden` keeps the pictures of today where they differ; look at them before you commit them.

use raybook::image::compare::{Tolerance, compare};
use raybook::image::file;
use raybook::image::{Image, rgb::Rgb, tone};
use raybook_chapters::kit::figure::SCALE;
use raybook_chapters::kit::options::Options;
use raybook_chapters::kit::stage::{Stage, progress_bar};
use raybook_chapters::lesson::Lesson;
use raybook_chapters::{LESSONS, MEASURED};
use raybook_common::{check_all, project};
use std::fs;
use std::path::{Path, PathBuf};

/// Small, so that all chapters' golden pictures weigh less than a photograph.
const WIDTH: u32 = 96;

/// Enough that no pixel is a matter of luck.
const SAMPLES: u32 = 4;

/// Contrast that large letters have at least with their paper: WCAG 2.2, success criterion 1.4.3.
const CONTRAST: f32 = 3.0;

/// Room that `raybook present` has for a picture on a projector with 1280 × 720 pixels, beside the knobs and above a caption of three lines.
const ROOM: (f64, f64) = (955.0, 515.0);

/// Height of the smallest letters that are allowed there, in pixels.
const LETTER: f64 = 12.0;

#[test]
fn every_chapter_draws_its_golden_picture_on_one_thread_and_on_two() {
    check_all(LESSONS, draws_its_golden_picture);
}

/// A sample that is drawn in seconds, also unoptimised: spheres, triangles, Phong's reflection of lamps, shadows. Paths, lenses and
/// hierarchies take longer, and are in the test of all chapters only.
#[test]
fn a_sample_of_chapters_draws_its_golden_pictures() {
    let sample = ["ch03_sphere", "ch06_triangle", "ch12_phong", "ch15_shadows"];
    let lessons: Vec<_> = LESSONS
        .iter()
        .filter(|lesson| sample.contains(&lesson.name))
        .collect();
    assert_eq!(
        lessons.len(),
        sample.len(),
        "the sample's chapters are there"
    );
    check_all(lessons, draws_its_golden_picture);
}

fn draws_its_golden_picture(lesson: &Lesson) {
    let out = tempfile::tempdir().expect("a temporary folder");
    let [one, two] = [1, 2].map(|threads| {
        let out = out.path().join(threads.to_string());
        draw(lesson, &out, threads);
        out.join(lesson.name)
    });
    assert_same_files(&one, &two);
    assert_golden(lesson.name, &one.join("picture.exr"));
    for (file, text) in drawings(&one) {
        assert_large_letters(&file, &text);
        assert_known_letters(&file, &text);
        assert_dark_letters(&file, &text);
    }
}

/// The drawings in a folder, with their texts.
fn drawings(folder: &Path) -> Vec<(PathBuf, String)> {
    let files = fs::read_dir(folder).expect("the chapter has made its folder");
    let files = files.map(|file| file.expect("the folder can be read").path());
    let drawings = files.filter(|file| file.extension().is_some_and(|e| e == "svg"));
    let read = |file: PathBuf| {
        let text = fs::read_to_string(&file).expect("text");
        (file, text)
    };
    drawings.map(read).collect()
}

/// No letter is drawn as nothing.
fn assert_known_letters(file: &Path, text: &str) {
    let font = fs::read(project("chapters/kit/fonts/DejaVuSans.ttf")).expect("the font is there");
    let font = ttf_parser::Face::parse(&font, 0).expect("a font");
    for part in text.split("<text").skip(1) {
        let (_, words) = part.split_once('>').expect("an element ends");
        let (words, _) = words.split_once("</text>").expect("a text ends");
        let unknown = words
            .trim()
            .chars()
            .find(|c| font.glyph_index(*c).is_none());
        let file = file.display();
        assert!(
            unknown.is_none(),
            "{file}: no letter {unknown:?} in the font: {words}"
        );
    }
}

/// Who sits in the last row reads every drawing.
fn assert_large_letters(file: &Path, text: &str) {
    let numbers = |name: &str| {
        let begin = format!(" {name}=\"");
        let number = |rest: &str| rest.split('"').next()?.parse::<f64>().ok();
        let values = text.split(&begin).skip(1);
        values
            .map(|rest| number(rest).expect("a number"))
            .collect::<Vec<_>>()
    };
    let shown = (ROOM.0 / numbers("width")[0]).min(ROOM.1 / numbers("height")[0]);
    for size in numbers("font-size") {
        let size = size / f64::from(SCALE) * shown;
        assert!(
            size >= LETTER,
            "{}: a letter of {size} pixels",
            file.display()
        );
    }
}

/// Words are not as light as an orange or a pale grey, which areas and lines may be. White words stand on what is dark.
fn assert_dark_letters(file: &Path, text: &str) {
    for part in text.split("<text").skip(1) {
        let (_, fill) = part.split_once(" fill=\"#").expect("words have a colour");
        let (fill, _) = fill.split_once('"').expect("a value ends");
        if fill == "FFF" {
            continue;
        }
        let channel = |i: usize| {
            let code = u8::from_str_radix(&fill[2 * i..2 * i + 2], 16).expect("six digits");
            tone::decode_srgb(f32::from(code) / 255.0)
        };
        let luminance = Rgb::new(channel(0), channel(1), channel(2)).luminance();
        let contrast = (1.0 + 0.05) / (luminance + 0.05);
        let file = file.display();
        assert!(
            contrast >= CONTRAST,
            "{file}: words of #{fill} have a contrast of {contrast:.1} with white: {part:.80}"
        );
    }
}

/// The seed alone decides, in every figure.
fn assert_same_files(one: &Path, two: &Path) {
    for file in fs::read_dir(one).expect("the chapter has made its folder") {
        let file = file.expect("the folder can be read").path();
        let other = two.join(file.file_name().expect("a file has a name"));
        let bytes = |path: &Path| fs::read(path).expect("both have made it");
        assert!(
            MEASURED
                .iter()
                .any(|measured| file.with_extension("png").ends_with(measured))
                || bytes(&file) == bytes(&other),
            "{} depends on the number of threads",
            file.display()
        );
    }
}

/// The picture is the one that is kept; or it is kept now.
fn assert_golden(chapter: &str, drawn: &Path) {
    let golden = project("golden").join(chapter).join("picture.exr");
    let actual = file::load(drawn).unwrap_or_else(|e| panic!("{chapter}: {e}"));
    let differs = |kept: &Image| compare(kept, &actual, &Tolerance::RENDERED_AGAIN).is_err();
    let bless = std::env::var_os("RAYBOOK_BLESS").is_some();
    // What is the same but for its last digits is not kept anew: who adds a chapter keeps one picture.
    if bless && file::load(&golden).map_or(true, |kept| differs(&kept)) {
        fs::create_dir_all(golden.parent().expect("it has a folder"))
            .expect("the folder can be made");
        fs::copy(drawn, &golden).expect("the picture can be kept");
    }
    let expected = file::load(&golden).unwrap_or_else(|e| panic!("{e}; RAYBOOK_BLESS=1 makes it"));
    compare(&expected, &actual, &Tolerance::RENDERED_AGAIN).unwrap_or_else(|difference| {
        panic!("{chapter}: {difference}; if the change is meant, look at the picture and run RAYBOOK_BLESS=1")
    });
}

/// Draws a chapter as its binary does, but small.
fn draw(lesson: &Lesson, out: &Path, threads: u32) {
    let options = Options {
        width: Some(WIDTH),
        samples: Some(SAMPLES),
        seed: 1,
        threads: Some(threads),
        out: out.to_owned(),
    };
    let stage = Stage::new(lesson.name, options, false, progress_bar());
    lesson
        .draw(&stage)
        .unwrap_or_else(|error| panic!("{}: {error}", lesson.name));
}
