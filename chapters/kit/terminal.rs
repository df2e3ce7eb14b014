//! A picture in the terminal: two pixels a character, in 24-bit colour.

use console::Term;
use raybook::image::{Image, rgb::Rgb, tone};
use std::env;
use std::ffi::OsStr;
use std::io::{self, IsTerminal, Write};

/// Why standard output cannot show colours; `None` if it can.
pub fn colourless() -> Option<&'static str> {
    let variable = |name| env::var_os(name);
    why_colourless(
        io::stdout().is_terminal(),
        variable("NO_COLOR").as_deref(),
        variable("TERM").as_deref(),
    )
}

/// As [`colourless`], for an output that is a terminal or not, and the variables `NO_COLOR` and `TERM`.
pub fn why_colourless(
    is_terminal: bool,
    no_color: Option<&OsStr>,
    term: Option<&OsStr>,
) -> Option<&'static str> {
    if !is_terminal {
        Some("standard output is not a terminal")
    } else if no_color.is_some_and(|value| !value.is_empty()) {
        Some("NO_COLOR is set")
    } else if term.is_some_and(|kind| kind == "dumb") {
        Some("the terminal has no colours (TERM is dumb)")
    } else {
        None
    }
}

/// Prints the picture as wide as the terminal, or in its own width if that is smaller.
///
/// # Errors
/// If it cannot be printed.
pub fn print(picture: &Image) -> io::Result<()> {
    let columns = usize::from(Term::stdout().size().1);
    let mut out = io::stdout().lock();
    out.write_all(characters(picture, columns).as_bytes())?;
    out.flush()
}

/// The picture as lines of at most `columns` characters: each is an upper half block, whose foreground is the pixel above, and
/// whose background the one below.
pub fn characters(picture: &Image, columns: usize) -> String {
    let width = picture.width().min(columns).max(1);
    let height = (picture.height() * width / picture.width()).max(1);
    let pixel = |x: usize, y: usize| {
        let [r, g, b] = mean(picture, [x, y], [width, height])
            .channels()
            .map(tone::to_byte);
        format!("{r};{g};{b}")
    };
    let mut text = String::new();
    for y in (0..height).step_by(2) {
        for x in 0..width {
            text.extend(["\x1b[38;2;", &pixel(x, y), "m"]);
            if y + 1 < height {
                text.extend(["\x1b[48;2;", &pixel(x, y + 1), "m"]);
            }
            text.push('▀');
        }
        text += "\x1b[0m\n";
    }
    text
}

/// The mean of the part of the picture that falls on a pixel when the picture is reduced to this size.
fn mean(picture: &Image, pixel: [usize; 2], size: [usize; 2]) -> Rgb {
    let of = [picture.width(), picture.height()];
    let part = |axis: usize| {
        let first = pixel[axis] * of[axis] / size[axis];
        let end = (pixel[axis] + 1) * of[axis] / size[axis];
        first..end.max(first + 1)
    };
    let all = part(1).flat_map(|y| part(0).map(move |x| picture.at(x, y)));
    let count = part(0).len() * part(1).len();
    all.fold(Rgb::BLACK, |sum, colour| sum + colour) * (1.0 / count as f32)
}
