//! `{{mistakes sphere_hit}}`: what it looks like when a function is wrong, by the grader's own mistakes.

use super::{example::short, kept};
use crate::examine::{Case, Examiner, visible_rng};
use maud::{Markup, html};
use raybook::image::{Image, file};
use raybook::store;
use raybook_chapters::kit::palette;
use raybook_workbook::row;
use rayon::prelude::{IntoParallelIterator, ParallelIterator};
use std::collections::HashMap;
use std::path::Path;

/// The number of mistakes that a gallery shows: the first of the list, which are the most common.
const SHOWN: usize = 20;

/// The answer of a mistake to the first case that shows it.
struct Shown<'a> {
    case: &'a Case,
    got: String,
    why: String,
}

/// The gallery of an exercise's mistakes, below the sentence that each of them ends; their pictures are written into the folder `mistakes` of
/// `pictures`. What this very program drew there before is not drawn again. The gallery's text is kept beside its pictures; mdBook does not
/// copy a file `*.md` into the book.
///
/// # Errors
/// If a picture cannot be written.
pub(super) fn expand(examiner: &dyn Examiner, pictures: &Path) -> Result<String, String> {
    let file = pictures.join(format!("mistakes/{}.md", examiner.name()));
    let gallery = kept::or_make(&file, || drawn(examiner, pictures))?;
    let name = examiner.name();
    let begins = match examiner.pictures()[..] {
        [] => format!("A function `{name}` answers wrongly if …"),
        _ => format!(
            "A function `{name}` draws the first picture if it is right, and answers wrongly if …"
        ),
    };
    Ok(format!("{begins}\n\n{gallery}"))
}

/// The gallery, drawn.
fn drawn(examiner: &dyn Examiner, pictures: &Path) -> Result<String, String> {
    let name = examiner.name();
    let cases = examiner.cases(&mut visible_rng(name)).cases;
    let right = picture(examiner, |question| Some((examiner.asked().call)(question)))?;
    let (mut cards, mut unseen) = (Vec::new(), Vec::new());
    let mut saved = Saved::new(pictures);
    if let Some(right) = &right {
        let alt = examiner.pictures()[0].alt;
        let file = saved.address(&format!("{name}_right"), right)?;
        cards.push(html! {
            figure class="right" { img src=(file) alt=(alt) loading="lazy"; figcaption { b { "Right." } } }
        });
    }
    let mistakes = examiner.mistakes();
    let further = mistakes.len().saturating_sub(SHOWN);
    for (i, (mistake, hint)) in mistakes.into_iter().take(SHOWN).enumerate() {
        let printed = |answer: Vec<f64>| row::format(examiner.asked().answer.kind, &answer);
        let wrong = picture(examiner, |question| {
            let answer = examiner.mistake_answers(i, question).map(printed)?;
            examiner.asked().read_answer(&answer).ok() // what no program could print has no colour
        })?;
        let seen = wrong.filter(|wrong| right.as_ref() != Some(wrong));
        let image = match &seen {
            Some(wrong) => Some(saved.address(&format!("{name}_{}", i + 1), wrong)?),
            None => None,
        };
        let alt = format!("What is drawn by a function that {mistake}");
        let shown = first_shown(examiner, i, &cases);
        let card = html! {
            figure {
                @if let Some(image) = image { img src=(image) alt=(alt) loading="lazy"; }
                figcaption {
                    b { "… it " (mistake) "." }
                    @if let Some(shown) = shown { " " (told(&shown)) }
                    details { summary { "Hint" } (hint) }
                }
            }
        };
        if seen.is_some() {
            cards.push(card);
        } else {
            unseen.push(card); // the pictures stand together, and first
        }
    }
    cards.extend(unseen);
    let gallery = html! {
        div class="gallery" { @for card in cards { (card) } }
        @if further > 0 {
            p { code { "raybook check " (name) } " knows " (further) " more, and says which one's answers are yours." }
        }
    };
    Ok(gallery.into_string())
}

/// The case, the wrong answer beside the right one where both are short, and what the grader says.
fn told(shown: &Shown<'_>) -> Markup {
    let right = &shown.case.answers[0];
    let (got, right) = (short(&shown.got), short(right));
    html! {
        "Case “" (shown.case.name) "”: " code { (got) } " instead of " code { (right) } ". "
        q { (shown.why) }
    }
}

/// The first case whose answer is wrong.
fn first_shown<'a>(examiner: &dyn Examiner, i: usize, cases: &'a [Case]) -> Option<Shown<'a>> {
    cases.iter().find_map(|case| {
        let got = examiner.mistaken(i, &case.question)?;
        let why = examiner.judge(&case.question, &case.answers, &got).err()?;
        Some(Shown { case, got, why })
    })
}

/// The exercise's first picture by these answers, if it has one: the PNG, since pictures are alike if a display shows them alike.
fn picture(
    examiner: &dyn Examiner,
    answer: impl Fn(&[f64]) -> Option<Vec<f64>> + Sync,
) -> Result<Option<Vec<u8>>, String> {
    let Some(&size) = examiner.pictures().first() else {
        return Ok(None);
    };
    let colour = |i: u32| {
        let question = examiner.pixel(0, i % size.width, i / size.width)?;
        examiner.colour(0, &question, &answer(&question)?)
    };
    let pixels = (0..size.width * size.height).into_par_iter();
    let pixels: Vec<_> = pixels.map(colour).collect();
    let picture = Image::from_fn(size.width as usize, size.height as usize, |x, y| {
        pixels[y * size.width as usize + x].unwrap_or(palette::linear(palette::INK))
    });
    let png = file::to_png(&picture).map_err(|error| error.to_string())?;
    Ok(Some(png))
}

/// The pictures of a gallery that are written already.
struct Saved<'a> {
    folder: &'a Path,
    pictures: HashMap<Vec<u8>, String>,
}

impl<'a> Saved<'a> {
    fn new(folder: &'a Path) -> Self {
        Self {
            folder,
            pictures: HashMap::new(),
        }
    }

    /// The address in the book of a picture. It is written under this name, unless an equal picture is there.
    fn address(&mut self, name: &str, png: &[u8]) -> Result<String, String> {
        if let Some(address) = self.pictures.get(png) {
            return Ok(address.clone());
        }
        let path = format!("mistakes/{name}.png");
        store::write(&self.folder.join(&path), png).map_err(|error| error.to_string())?;
        let address = format!("pictures/{path}");
        self.pictures.insert(png.to_vec(), address.clone());
        Ok(address)
    }
}
