//! Pictures in the terminal.

use raybook::image::{Image, rgb::Rgb};
use raybook_chapters::kit::terminal::{characters, why_colourless};
use std::ffi::OsStr;
use std::process::Command;

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

#[test]
fn only_a_terminal_with_colours_is_drawn_on() {
    let why = |is_terminal, no_color: Option<&str>, term: Option<&str>| {
        why_colourless(is_terminal, no_color.map(OsStr::new), term.map(OsStr::new))
    };
    assert_eq!(why(true, None, Some("xterm-256color")), None);
    assert_eq!(why(true, Some(""), None), None, "empty counts as not set");
    let refusals = [
        (why(false, None, Some("xterm")), "not a terminal"),
        (why(true, Some("1"), Some("xterm")), "NO_COLOR"),
        (why(true, None, Some("dumb")), "dumb"),
    ];
    for (refusal, part) in refusals {
        let refusal = refusal.expect("nothing can be shown");
        assert!(refusal.contains(part), "{refusal}");
    }
}

#[test]
fn a_pipe_is_told_so_and_gets_no_colours() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let output = Command::new(env!("CARGO_BIN_EXE_ch05_box"))
        .args(["--show", "--width", "16", "--samples", "1", "--out"])
        .arg(out.path())
        .env("TERM", "xterm-256color")
        .output()
        .expect("the chapter runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(
        said.contains("--show shows nothing, because standard output is not a terminal"),
        "{said}"
    );
    assert!(!output.stdout.contains(&0x1b), "no escapes");
    assert!(output.stdout.starts_with(b"wrote "), "but the files");
}

#[test]
fn a_width_that_is_refused_says_what_memory_it_takes() {
    for (width, part) in [
        (
            "16384",
            "a square picture of this width takes 3.2 GB of memory, and a picture may take 1.1 GB: at most 8192 pixels, 0.8 GB",
        ),
        ("8193", "at most 8192 pixels"),
        ("99999999999999999999", "from 8 to 8192"),
        ("7", "at least 8 pixels"),
        ("wide", "from 8 to 8192"),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_ch05_box"))
            .args(["--width", width])
            .output()
            .expect("the chapter runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.code() == Some(2) && said.contains(part),
            "{said}"
        );
    }
}
