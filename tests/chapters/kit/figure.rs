//! Figures, as pixels and as vectors.

use glam::{Vec2, Vec3};
use plotters::prelude::{Color, Rectangle, WHITE};
use raybook::image::rgb::Rgb;
use raybook_chapters::kit::figure::{CENTRE, figure, text, write};
use raybook_chapters::kit::palette::BLUE;
use raybook_chapters::kit::sketch::{flat, xy};

#[test]
fn what_is_drawn_is_in_the_pixels_and_in_the_vectors() {
    let figure = figure(40, 20, |canvas| {
        canvas.draw(&Rectangle::new([(0, 0), (40, 40)], BLUE.filled()))?;
        canvas.draw_pixel((60, 20), &BLUE)?;
        write(canvas, "a < b", (60, 20), text(20).pos(CENTRE))
    });
    let figure = figure.expect("it is drawn");
    assert!(figure.pixels.at(5, 5) != Rgb::WHITE && figure.pixels.at(39, 1) == Rgb::WHITE);
    for part in [
        "<svg width=\"40\" height=\"20\" viewBox=\"0 0 80 40\"",
        "fill=\"#0072B2\"",
        "a &lt; b",
        "</svg>",
    ] {
        assert!(figure.svg.contains(part), "{part} is in {}", figure.svg);
    }
    assert!(
        !figure.svg.contains("stroke=\"#"),
        "a filled rectangle has no line: {}",
        figure.svg
    );
    assert_eq!(
        figure.svg.matches("#0072B2").count(),
        1,
        "a pixel is no vector"
    );
}

#[test]
fn in_vectors_words_have_one_rim_and_lines_are_not_filled() {
    let figure = flat((40, 20), Vec3::ZERO, 2.0, |sketch| {
        sketch.line(&[xy(-1.0, 0.0), xy(1.0, 0.0), xy(1.0, 1.0)], BLUE, 4)?;
        sketch.label(Vec3::ZERO, Vec2::ZERO, "n", BLUE)?;
        sketch.label(Vec3::X, Vec2::ZERO, "n", WHITE)
    });
    let svg = figure.expect("it is drawn").svg;
    assert!(svg.contains("<style>path{fill:none}</style>"), "{svg}");
    assert!(
        svg.contains("<path stroke=\"#0072B2\" stroke-width=\"4\" d=\"M20,20l40,0 0,-20\"/>"),
        "{svg}"
    );
    assert_eq!(
        svg.matches("<text stroke=\"#FFF\" stroke-width=\"8\"")
            .count(),
        2,
        "{svg}"
    );
    assert_eq!(
        svg.matches("<text").count(),
        2,
        "white words have a rim, too: {svg}"
    );
}
