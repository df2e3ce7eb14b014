//! The page: pictures that are not scaled, captions, a table that is sorted, slides.

use super::samplers;
use std::fs;

/// A small page.
fn page(options: &[&str]) -> (tempfile::TempDir, String) {
    let out = tempfile::tempdir().expect("a temporary folder");
    let small = [
        "--patterns",
        "jittered,halton",
        "--points",
        "25",
        "--samples",
        "1,4",
        "--realisations",
        "6",
        "--width",
        "20",
    ];
    samplers(out.path(), &[options, &small].concat()).success();
    let page = fs::read_to_string(out.path().join("index.html")).expect("the page is there");
    (out, page)
}

#[test]
fn a_caption_says_how_many_points_how_often_by_which_seed_and_by_which_command() {
    let (_out, page) = page(&["--seeds", "5"]);
    let captions: Vec<_> = page.split("<figcaption>").skip(1).collect();
    assert!(captions.len() > 12, "many figures: {}", captions.len());
    for caption in captions {
        let caption = caption.split("</figcaption>").next().expect("its text");
        for words in [
            "seed 5",
            "raybook samplers --seeds 5 --patterns jittered,halton",
        ] {
            assert!(caption.contains(words), "{words}: {caption}");
        }
        assert!(caption.contains("realisation"), "{caption}");
    }
    assert!(!page.contains("http"), "nothing is fetched from elsewhere");
}

#[test]
fn pictures_have_one_pixel_of_the_screen_for_each_of_theirs_and_can_be_flipped() {
    let (out, page) = page(&[]);
    assert!(
        page.contains("image-rendering: pixelated"),
        "they are not smoothed"
    );
    for target in ["zone-plate", "checkered-plane", "slanted-edge"] {
        for pattern in ["jittered", "halton"] {
            for samples in [1, 4] {
                let name = format!("{target}_{pattern}_{samples}.png");
                let picture = fs::read(out.path().join(&name)).expect("it is there");
                let width =
                    u32::from_be_bytes([picture[16], picture[17], picture[18], picture[19]]);
                assert_eq!(width, 20, "{name}");
                let shown = format!("src=\"{name}\"");
                let (_, element) = page
                    .split_once(&shown)
                    .unwrap_or_else(|| panic!("{name} is shown"));
                let element = element.split('>').next().expect("its attributes");
                assert!(
                    element.contains("width=\"20\" height=\"20\""),
                    "{name}: {element}"
                );
            }
        }
    }
    let (_, flip) = page
        .split_once("class=\"flip\"")
        .expect("there is a comparison");
    assert_eq!(
        flip.matches("<select>").count(),
        4,
        "picture, samples, A, B"
    );
    assert_eq!(flip.matches("value=\"halton\"").count(), 2, "as A and as B");
}

#[test]
fn the_table_is_sorted_by_buttons_that_a_keyboard_reaches() {
    let (_out, page) = page(&[]);
    let headings = page.matches("<th scope=\"col\" aria-sort=\"none\"><button type=\"button\">");
    assert_eq!(headings.count(), 11, "the pattern and ten numbers");
    assert!(
        page.contains("effective Nyquist") && page.contains("pixel to pixel"),
        "new columns"
    );
}

#[test]
fn slides_have_a_screen_for_each_figure() {
    let (_out, usual) = page(&[]);
    let (_out, slides) = page(&["--slides"]);
    assert!(
        !usual.contains("<body class=\"slides\">"),
        "a page is a page"
    );
    assert!(
        slides.contains("<body class=\"slides\">"),
        "slides are slides"
    );
    let figures = slides.matches("<figure>").count();
    let screens = slides.matches("<section class=\"screen\">").count();
    assert!(screens > figures, "a screen each: {screens} for {figures}");
}

#[test]
fn a_drawing_is_as_wide_as_its_figure_and_its_letters_are_large_enough() {
    let (out, _page) = page(&[]);
    let drawings = fs::read_dir(out.path())
        .expect("the folder is there")
        .flatten();
    let mut looked_at = 0;
    for file in drawings.filter(|file| file.path().extension().is_some_and(|e| e == "svg")) {
        let text = fs::read_to_string(file.path()).expect("text");
        let drawing = roxmltree::Document::parse(&text).expect("XML");
        let root = drawing.root_element();
        let number =
            |text: Option<&str>| -> f64 { text.and_then(|v| v.parse().ok()).unwrap_or(f64::NAN) };
        let canvas = root
            .attribute("viewBox")
            .and_then(|all| all.split(' ').nth(2));
        let scale = number(root.attribute("width")) / number(canvas);
        assert!(
            (scale - 0.5).abs() < 1e-9,
            "{:?}: {scale}",
            file.file_name()
        );
        for letters in drawing
            .descendants()
            .filter(|node| node.has_tag_name("text"))
        {
            let size = number(letters.attribute("font-size")) * scale;
            assert!(
                size >= 12.0,
                "{:?}: {size} px: {:?}",
                file.file_name(),
                letters.text()
            );
            looked_at += 1;
        }
        assert!(
            text.len() < 150_000,
            "{:?}: {} bytes",
            file.file_name(),
            text.len()
        );
    }
    assert!(looked_at > 200, "letters: {looked_at}");
}

#[test]
fn the_page_tells_of_further_patterns_and_shows_many_curves_one_by_one() {
    let (out, page) = page(&[]);
    assert!(page.contains("raybook samplers --patterns all"), "{page}");
    assert!(!out.path().join("error_smooth_one_by_one.svg").exists());
    let out = tempfile::tempdir().expect("a temporary folder");
    let all = ["--patterns", "all", "--quick", "--realisations", "2"];
    let small = ["--points", "16", "--samples", "1", "--width", "8"];
    samplers(out.path(), &[&all[..], &small].concat()).success();
    let read = |name: &str| fs::read_to_string(out.path().join(name)).expect("it is there");
    assert!(
        !read("index.html").contains("raybook samplers --patterns all</code> shows"),
        "nothing is left out"
    );
    let panels = read("error_smooth_one_by_one.svg");
    for name in ["regular grid", "Halton", "best candidate", "blue noise"] {
        assert!(panels.contains(name), "a panel for {name}");
    }
}
