//! Three pictures of the same pixels, or two if no difference is seen: side by side, or one at a time in the same place, where a difference jumps to the eye.

use crate::picture::triple::Triple;
use maud::{Markup, html};
use raybook::image::{Image, file};
use raybook_chapters::kit::address;

/// The choice of what is seen. The style of the page hides the others, so no script is needed, and the arrow keys choose.
const CHOICES: [(&str, &str); 4] = [
    ("all", "all"),
    ("yours", "yours"),
    ("right", "the right one"),
    ("difference", "the difference"),
];

/// Picture `number` of an exercise.
pub fn of(exercise: &str, number: usize, picture: &Triple) -> Markup {
    let name = format!("{exercise}-{number}");
    let differs = picture.differs();
    let (wrong, of) = (picture.score.wrong(), picture.score.of);
    let yours = format!("{}: yours, {wrong} of {of} pixels are wrong.", picture.alt);
    let right = format!("{}: the right one.", picture.alt);
    let difference = format!("{}: yours minus the right one.", picture.alt);
    // The page of a watch has a pixel looked at: first the one that is wrong, or else the middle.
    let (width, height) = (picture.golden.width(), picture.golden.height());
    let first = picture.first_bad.as_ref().map(|bad| (bad.x, bad.y));
    let (x, y) = first.unwrap_or((width / 2, height / 2));
    html! { fieldset class="pictures" id=(name) data-exercise=(exercise) data-explained[number == 0]
            data-width=(width) data-height=(height) data-x=(x) data-y=(y) {
        legend { "The picture " code { (picture.name) } ": " (of - wrong) " of " (of) " pixels are right" @if !differs { "; no difference is seen" } }
        p { @for (value, label) in CHOICES.into_iter().filter(|(value, _)| differs || *value != "difference") { label {
            input type="radio" id={ (name) "-" (value) } name={ (name) "-shown" } value=(value) checked[value == "all"]; " " (label)
        } " " } }
        div class="row" {
            (one("yours", &picture.yours, &yours, "Yours"))
            (one("right", &picture.golden, &right, "The right one"))
            @if differs {
                (one("difference", &picture.difference, &difference, "The difference: orange where yours is too bright, blue where it is too dark"))
            }
        }
    } }
}

fn one(class: &str, picture: &Image, alt: &str, caption: &str) -> Markup {
    // A picture of an exercise has pixels; without, its text stands in its place.
    let png = file::to_png(picture).unwrap_or_default();
    html! { figure class=(class) {
        span class="picture" { img src=(address::of_bytes("image/png", &png)) alt=(alt); }
        figcaption { (caption) }
    } }
}
