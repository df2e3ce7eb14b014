//! One picture of a chapter at several values of a knob: a labelled strip, or an animation.

use crate::kit::knobs::{self, Knob};
use crate::kit::options::Options;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Output, Stage, progress_bar};
use crate::lesson::Lesson;
use clap::{Args, Command};
use raybook::image::{Image, file, rgb::Rgb, tone};
use raybook::store;
use std::error::Error;
use std::path::Path;

/// What is varied, and what is made of it.
#[derive(Args, Debug)]
pub struct Vary {
    /// Draw the picture that a knob changes at several values of this knob, side by side; --vary samples=1,4,16 works, too
    #[arg(id = "vary", long, value_name = "KNOB=A,B,…", value_parser = varied)]
    knobs: Vec<Varied>,
    /// Draw only the picture with this file's name; with --vary, vary this picture
    #[arg(long)]
    pub picture: Option<String>,
    /// Make an animation (APNG) of these pictures, two pictures a second
    #[arg(long, requires = "vary")]
    pub animate: bool,
}

/// A knob's name, and the values that it takes one after the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Varied {
    name: String,
    values: Vec<String>,
}

impl Vary {
    /// What is varied, if anything is.
    ///
    /// # Errors
    /// If several knobs are: the error says what to write instead.
    pub fn one(&self) -> Result<Option<&Varied>, String> {
        match &self.knobs[..] {
            [] => Ok(None),
            [one] => Ok(Some(one)),
            [one, other, ..] if one.name == other.name => Err(format!(
                "--vary is there twice: write all values of {0} behind one --vary, as in --vary {0}={1},{2}",
                one.name, one.values[0], other.values[0]
            )),
            [one, other, ..] => Err(format!(
                "--vary is there twice, and varies one knob: vary {0}, and give {1} one value with --{1} {2}",
                one.name, other.name, other.values[0]
            )),
        }
    }
}

/// Width of the whole strip, in pixels, if no width is asked for.
const STRIP: u32 = 1600;

/// Maximum number of pictures in a row.
const COLUMNS: usize = 4;

/// Maximum number of values: more are a typing error, which must not cost an hour of drawing.
const MOST: usize = 64;

fn varied(text: &str) -> Result<Varied, String> {
    let example = "a knob and its values: exponent=1,8,64";
    let (name, values) = text.split_once('=').ok_or(example)?;
    let values: Vec<_> = values
        .split(',')
        .map(|value| value.trim().to_owned())
        .collect();
    if values.iter().any(String::is_empty) || values.len() > MOST {
        return Err(format!("{example}; from one to {MOST} of them"));
    }
    let name = name.trim_start_matches('-').to_owned();
    Ok(Varied { name, values })
}

/// Options beside the knobs that can be varied, too.
const OPTIONS: [&str; 2] = ["samples", "seed"];

/// Draws a chapter's picture at each value, with its other knobs as they are turned. Each picture is kept in a folder of its own;
/// the strip or the animation lies beside these folders.
///
/// # Errors
/// If there is no such knob or picture, a value is out of range, or a picture cannot be drawn or written.
pub fn draw(
    lesson: &Lesson,
    options: &Options,
    turned: &[String],
    what: &Varied,
    vary: &Vary,
) -> Result<Output, Box<dyn Error>> {
    let knob = find(lesson, &what.name)?;
    let name = vary.picture.as_ref().unwrap_or(&knob.picture);
    // As few rows as possible, all of the same length: six values are two rows of three.
    let rows = what.values.len().div_ceil(COLUMNS);
    let columns = what.values.len().div_ceil(rows);
    let width = options.width.unwrap_or(STRIP / columns as u32);
    let options = Options {
        width: Some(width),
        ..options.clone()
    };
    let turn = format!("--{}=", what.name);
    let arguments = |value: &String| {
        let (mut options, word) = (options.clone(), format!("{turn}{value}"));
        let others = turned.iter().filter(|word| !word.starts_with(&turn));
        let mut words: Vec<_> = others.cloned().collect();
        if OPTIONS.contains(&what.name.as_str()) {
            options.turn(&word)?;
        } else {
            words.push(word);
        }
        Ok::<_, clap::Error>((options, lesson.turn(&words)?))
    };
    // All values are checked before the first picture is drawn.
    let knobs = what
        .values
        .iter()
        .map(|value| arguments(value).map_err(|error| knobs::sentence(&error)))
        .collect::<Result<Vec<_>, _>>()?;
    let folder = options.out.join(lesson.name);
    let mut tiles = Vec::new();
    for (value, (options, knobs)) in what.values.iter().zip(knobs) {
        let stage = Stage::new(lesson.name, options, false, progress_bar());
        let own = folder.join(format!("{}_{}", what.name, value.replace(['/', '\\'], "_")));
        let stage = stage.in_folder(own).until(name);
        lesson.draw_turned(&stage, &knobs)?;
        tiles.push((knob.label(value), picture(stage, name)?));
    }
    let png = folder.join(format!("vary_{}.png", what.name));
    let tiles = as_large(&tiles);
    let shown = if vary.animate {
        let frames = tiles.chunks(1).map(|tile| sheet(1, tile));
        let frames = frames.collect::<Result<Vec<_>, _>>()?;
        store::write(&png, &animation(&frames)?)?;
        frames.into_iter().next()
    } else {
        let strip = sheet(columns, &tiles)?;
        file::save(&png, &strip)?;
        Some(strip)
    };
    let caption = format!("{} at several values.", knob.help);
    Ok(Output {
        png,
        exr: None,
        svg: None,
        size: shown.map_or((0, 0), |shown| (shown.width(), shown.height())),
        caption,
        rays: None,
    })
}

fn find(lesson: &Lesson, name: &str) -> Result<Knob, String> {
    let mut knobs = knobs::of(&lesson.knobs());
    let options = knobs::of(&Options::augment_args(Command::new("options")));
    let varied = options.into_iter();
    knobs.extend(varied.filter(|option| OPTIONS.contains(&option.name.as_str())));
    let names: Vec<_> = knobs.iter().map(|knob| knob.name.clone()).collect();
    let found = knobs.into_iter().find(|knob| knob.name == name);
    found.ok_or_else(|| {
        format!(
            "--vary {name}: {} has no such knob; it has {}",
            lesson.name,
            names.join(", ")
        )
    })
}

/// The picture of this name, as it was written for a display.
fn picture(stage: Stage, name: &str) -> Result<Image, Box<dyn Error>> {
    let one = only(stage, name)?;
    Ok(file::load(&one.png)?)
}

/// The picture of this name, of a stage on which drawing ended with it.
///
/// # Errors
/// If the chapter has no such picture: the error says which it has.
pub fn only(stage: Stage, name: &str) -> Result<Output, String> {
    let names = stage.passed();
    let is_it = |path: &Path| path.file_stem().is_some_and(|stem| stem == name);
    let mut outputs = stage.into_outputs().into_iter();
    outputs.find(|output| is_it(&output.png)).ok_or_else(|| {
        format!(
            "--picture {name}: there is no such picture; there are {}",
            names.join(", ")
        )
    })
}

/// The same pictures on white, all as wide and high as the widest and the highest.
fn as_large(tiles: &[(String, Image)]) -> Vec<(String, Image)> {
    let most =
        |size: fn(&Image) -> usize| tiles.iter().map(|(_, tile)| size(tile)).max().unwrap_or(0);
    let (width, height) = (most(Image::width), most(Image::height));
    let on_white = |tile: &Image| {
        Image::from_fn(width, height, |x, y| {
            let inside = x < tile.width() && y < tile.height();
            if inside { tile.at(x, y) } else { Rgb::WHITE }
        })
    };
    tiles
        .iter()
        .map(|(label, tile)| (label.clone(), on_white(tile)))
        .collect()
}

/// Pictures one after the other, for ever, half a second each, as an animated PNG.
fn animation(frames: &[Image]) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let (width, height) = frames
        .first()
        .map_or((1, 1), |f| (f.width() as u32, f.height() as u32));
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_animated(frames.len() as u32, 0)?;
    encoder.set_frame_delay(1, 2)?;
    let mut writer = encoder.write_header()?;
    for frame in frames {
        writer.write_image_data(&tone::to_bytes(frame))?;
    }
    writer.finish()?;
    Ok(bytes)
}
