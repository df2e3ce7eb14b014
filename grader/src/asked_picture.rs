//! A picture that a student's program draws: its pixels are asked, coarse first, so that there is soon something to look at.

use crate::ask::{Asker, Said};
use crate::examine::Examiner;
use crate::triple::PictureSize;
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use std::io;

/// The sides of the blocks of the passes, in pixels: each pass asks what the one before left out.
const BLOCKS: [u32; 4] = [8, 4, 2, 1];

/// Where there is no answer.
const MISSING: Rgb = Rgb::new(0.8, 0.0, 0.8);

/// A picture as far as it is drawn.
#[derive(Debug)]
pub struct Stage {
    /// What it is called, among an exercise's.
    pub name: &'static str,
    /// The picture of the answers that have come. A pixel that is not asked yet has the colour of its block; a pixel without an
    /// answer is magenta.
    pub yours: Image,
    /// The picture of the reference.
    pub golden: Image,
    /// The side of a block, in pixels: 1 in the last pass.
    pub block: u32,
}

/// What became of the pictures of an exercise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Drawn {
    /// They are drawn.
    Whole,
    /// This function is not written yet.
    NotWritten(String),
}

/// Asks all pixels of picture number `picture`, and shows the picture after each pass.
///
/// # Errors
/// If the program cannot be started, or what is shown cannot be kept.
pub fn draw(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    picture: usize,
    show: &mut dyn FnMut(&Stage) -> io::Result<()>,
) -> io::Result<Drawn> {
    let Some(size) = examiner.pictures().into_iter().nth(picture) else {
        return Ok(Drawn::Whole);
    };
    let PictureSize { width, height, .. } = size;
    let place = |x: u32, y: u32| (y * width + x) as usize;
    let question = |x: u32, y: u32| examiner.pixel_question(picture, x, y);
    let colour = |x, y, answer: &str| examiner.pixel_colour(picture, &question(x, y), answer);
    let golden = Image::from_fn(width as usize, height as usize, |x, y| {
        let (x, y) = (x as u32, y as u32);
        let answer = examiner.answer_line(&question(x, y)).unwrap_or_default();
        colour(x, y, &answer).unwrap_or(MISSING)
    });
    let mut colours: Vec<Option<Rgb>> = vec![None; (width * height) as usize];
    let mut stage = Stage {
        name: size.name,
        yours: golden.map(|_| MISSING),
        golden,
        block: 0,
    };
    for block in BLOCKS {
        let rows = (0..height).step_by(block as usize);
        let pixels = rows.flat_map(|y| (0..width).step_by(block as usize).map(move |x| (x, y)));
        let pixels: Vec<_> = pixels
            .filter(|&(x, y)| colours[place(x, y)].is_none())
            .collect();
        let asked = pixels.iter().map(|&(x, y)| question(x, y));
        let asked: Vec<_> = asked.map(|q| format!("{} {q}", examiner.name())).collect();
        for (&(x, y), reply) in pixels.iter().zip(asker.ask(&asked)?) {
            colours[place(x, y)] = Some(match reply.said {
                Said::Todo(name) => return Ok(Drawn::NotWritten(name.unescaped().to_owned())),
                Said::Answer(answer) => colour(x, y, answer.unescaped()).unwrap_or(MISSING),
                _ => MISSING,
            });
        }
        stage.block = block;
        stage.yours = Image::from_fn(width as usize, height as usize, |x, y| {
            let (x, y) = (x as u32 / block * block, y as u32 / block * block);
            colours[place(x, y)].unwrap_or(MISSING)
        });
        show(&stage)?;
    }
    Ok(Drawn::Whole)
}
