//! Figures, as pixels and as vectors.

use plotters::prelude::{Color, Rectangle};
use raybook::image::rgb::Rgb;
use raybook_chapters::kit::figure::{CENTRE, figure, text, write};
use raybook_chapters::kit::palette::BLUE;

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
        !figure.svg.contains("stroke"),
        "a filled rectangle has no line: {}",
        figure.svg
    );
    assert_eq!(
        figure.svg.matches("#0072B2").count(),
        1,
        "a pixel is no vector"
    );
}
