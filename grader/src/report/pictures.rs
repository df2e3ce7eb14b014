//! Three pictures of the same pixels: side by side, or one at a time in the same place, where a difference jumps to the eye.

use crate::triple::Triple;
use maud::{Markup, html};
use raybook::image::{Image, file};
use raybook_chapters::kit::html::data_uri;

/// The choice of what is seen. The style of the page hides the others, so no script is needed, and the arrow keys choose.
const CHOICES: [(&str, &str); 4] = [
    ("all", "all three"),
    ("yours", "yours"),
    ("right", "the right one"),
    ("difference", "the difference"),
];

/// Picture `number` of an exercise.
pub fn of(exercise: &str, number: usize, picture: &Triple) -> Markup {
    let name = format!("{exercise}-{number}");
    let (wrong, of) = (picture.score.wrong(), picture.score.of);
    let yours = format!("{}: yours, {wrong} of {of} pixels are wrong.", picture.alt);
    let right = format!("{}: the right one.", picture.alt);
    let difference = format!("{}: yours minus the right one.", picture.alt);
    html! { fieldset class="pictures" {
        legend { "The picture " code { (picture.name) } ": " (of - wrong) " of " (of) " pixels are right" }
        p { @for (value, label) in CHOICES { label {
            input type="radio" id={ (name) "-" (value) } name=(name) value=(value) checked[value == "all"]; " " (label)
        } " " } }
        div {
            (one("yours", &picture.yours, &yours, "Yours"))
            (one("right", &picture.golden, &right, "The right one"))
            (one("difference", &picture.difference, &difference, "The difference: orange where yours is too bright, blue where it is too dark"))
        }
    } }
}

fn one(class: &str, picture: &Image, alt: &str, caption: &str) -> Markup {
    // A picture of an exercise has pixels; without, its text stands in its place.
    let png = file::to_png(picture).unwrap_or_default();
    html! { figure class=(class) {
        img src=(data_uri("image/png", &png)) alt=(alt);
        figcaption { (caption) }
    } }
}
