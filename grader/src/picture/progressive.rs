//! A picture that a student's program draws: its pixels are asked, coarse first, so that there is soon something to look at.

use crate::ask::{Asker, Said};
use crate::examine::Examiner;
use crate::picture::triple::PictureSize;
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use std::io;

/// The sides of the blocks of the passes, in pixels: each pass asks what the one before left out.
const BLOCKS: [u32; 4] = [8, 4, 2, 1];

/// The passes over a picture: the side of their blocks, and the pixels at the blocks' top left corners that no pass before has.
pub fn passes(width: u32, height: u32) -> Vec<(u32, Vec<(u32, u32)>)> {
    let pass = |block: u32| {
        let is_corner = |(x, y): (u32, u32), block: u32| x % block == 0 && y % block == 0;
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let new = |pixel: &(u32, u32)| {
            let mut before = BLOCKS.iter().filter(|before| **before > block);
            is_corner(*pixel, block) && !before.any(|before| is_corner(*pixel, *before))
        };
        (block, pixels.filter(new).collect())
    };
    BLOCKS.map(pass).into()
}

/// A picture in which each block of this side has the colour of its top left pixel.
pub fn spread(picture: &Image, block: u32) -> Image {
    let block = block as usize;
    Image::from_fn(picture.width(), picture.height(), |x, y| {
        picture.at(x / block * block, y / block * block)
    })
}

/// Where there is no answer.
pub(crate) const MISSING: Rgb = Rgb::new(0.8, 0.0, 0.8);

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
    /// Each pixel has an answer.
    Whole,
    /// This number of pixels has no answer that can be read, the first of them for this reason.
    Holes(usize, String),
    /// No pixel of the first pass has an answer, for this reason; nothing is shown.
    Nothing(String),
    /// This function is not written yet.
    NotWritten(String),
}

/// Asks all pixels of picture number `picture`, and shows the picture after each pass, if there is anything to be seen.
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
    let exercise = examiner.asked();
    let question = |x: u32, y: u32| examiner.pixel_numbers(picture, x, y);
    let colour = |question: &[f64], answer: &[f64]| {
        let colour = examiner.colour(picture, question, answer);
        colour.unwrap_or(MISSING)
    };
    let golden = Image::from_fn(width as usize, height as usize, |x, y| {
        let question = question(x as u32, y as u32);
        colour(&question, &(exercise.call)(&question))
    });
    let mut yours = golden.map(|_| MISSING);
    let mut stage = Stage {
        name: size.name,
        yours: yours.clone(),
        golden,
        block: 0,
    };
    let (mut missing, mut first_why) = (0, None);
    for (block, pixels) in passes(width, height) {
        let line = |&(x, y): &(u32, u32)| {
            let question = examiner.pixel_question(picture, x, y);
            format!("{} {question}", exercise.name)
        };
        let asked: Vec<_> = pixels.iter().map(line).collect();
        for ((x, y), reply) in pixels.into_iter().zip(asker.ask_many(&asked)?) {
            let answer = match &reply.said {
                Said::Todo(name) => return Ok(Drawn::NotWritten(name.unescaped().to_owned())),
                Said::Answer(answer) => exercise
                    .read_answer(answer.unescaped())
                    .map_err(|error| error.to_string()),
                said => Err(said.why_none().unwrap_or_default() + said.help()),
            };
            match answer {
                Ok(answer) => yours.set(x as usize, y as usize, colour(&question(x, y), &answer)),
                Err(why) => {
                    missing += 1;
                    first_why.get_or_insert(why);
                }
            }
        }
        if let Some(why) = &first_why
            && missing == asked.len()
        {
            return Ok(Drawn::Nothing(why.clone()));
        }
        stage.block = block;
        stage.yours = spread(&yours, block);
        show(&stage)?;
    }
    Ok(first_why.map_or(Drawn::Whole, |why| Drawn::Holes(missing, why)))
}
