//! Pictures in the terminal.

use raybook::image::{Image, rgb::Rgb};
use raybook_chapters::kit::terminal::characters;

#[test]
fn a_character_shows_the_pixel_above_and_the_one_below() {
    let picture = Image::from_fn(1, 3, |_, y| Rgb::new(1.0, y as f32, 0.0));
    let foreground = |colour: &str| format!("\x1b[38;2;{colour}m");
    let expected = [
        &foreground("255;0;0"),
        "\x1b[48;2;255;255;0m▀\x1b[0m\n",
        &foreground("255;255;0"),
        "▀\x1b[0m\n",
    ];
    assert_eq!(characters(&picture, 80), expected.concat());
}

#[test]
fn a_wide_picture_is_made_as_narrow_as_the_terminal() {
    let halves = Image::from_fn(64, 32, |x, _| if x < 32 { Rgb::WHITE } else { Rgb::BLACK });
    let text = characters(&halves, 16);
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines.len(), 4, "two pixels high each");
    for line in lines {
        assert_eq!(line.matches('▀').count(), 16, "as wide as asked for");
        let white = line.matches("38;2;255;255;255m").count();
        assert_eq!(white, 8, "one half stays white");
    }
}
