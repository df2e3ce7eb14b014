//! What `phong` and `blinn_phong` share: the questions, the picture, and the judge.

use super::channels;
use crate::upon::changed;
use crate::{Verdict, sample};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch12_phong::Highlight;

/// R.
pub(super) fn mirrored(q: &Highlight) -> Vec3 {
    2.0 * q.toward.dot(*q.normal) * *q.normal - *q.toward
}

/// H.
pub(super) fn half(q: &Highlight) -> Vec3 {
    (*q.toward + *q.view).normalize_or_zero()
}

/// Both terms, of a number in the place of the highlight's (R·V)^α or (N·H)^α.
type Terms = fn(&Highlight, f32) -> Rgb;

/// Both terms of a light above the surface, with this number in the place of the highlight's (R·V)^α or (N·H)^α.
pub(super) fn with_highlight(q: &Highlight, highlight: f32) -> Rgb {
    let terms = changed(from_above as Terms, |_| {});
    terms(q, highlight)
}

/// The same, but with other terms.
pub(super) fn with_terms(q: &Highlight, highlight: f32, other: Terms) -> Rgb {
    let terms = changed(from_above as Terms, |terms| *terms = other);
    terms(q, highlight)
}

/// Nothing from a light below the surface.
pub(super) fn from_above(q: &Highlight, highlight: f32) -> Rgb {
    let cosine = q.toward.dot(*q.normal);
    if cosine > 0.0 {
        (q.diffuse * cosine + q.specular * highlight) * q.arriving
    } else {
        Rgb::BLACK
    }
}

/// The highlight shines through from a light below the surface.
pub(super) fn shining_through(q: &Highlight, highlight: f32) -> Rgb {
    let diffuse = q.diffuse * q.toward.dot(*q.normal).max(0.0);
    (diffuse + q.specular * highlight) * q.arriving
}

/// Both terms, but what arrives is forgotten in the highlight, which has this number in the place of its power.
pub(super) fn highlight_without_light(q: &Highlight, highlight: f32) -> Rgb {
    let matte = from_above(q, 0.0);
    if q.toward.dot(*q.normal) > 0.0 {
        matte + q.specular * highlight
    } else {
        matte
    }
}

/// Both terms, but the diffuse one is as bright as if the light stood above.
pub(super) fn matte_without_cosine(q: &Highlight, highlight: f32) -> Rgb {
    if q.toward.dot(*q.normal) > 0.0 {
        (q.diffuse + q.specular * highlight) * q.arriving
    } else {
        Rgb::BLACK
    }
}

/// Both terms, but the power is taken of more than the highlight's cosine: of each channel's k_s times it, or of the whole sum.
pub(super) fn power_of_more(q: &Highlight, cosine: f32, whole_sum: bool) -> Rgb {
    let lambert = q.toward.dot(*q.normal);
    if lambert <= 0.0 {
        return Rgb::BLACK;
    }
    let matte = q.diffuse * lambert;
    let shine = q.specular * cosine.max(0.0);
    let power = |colour: Rgb| colour.map(|v| v.powf(q.exponent));
    let sum = if whole_sum {
        power(matte + shine)
    } else {
        matte + power(shine)
    };
    sum * q.arriving
}

/// Both terms, but the power is taken of each channel's k_s, and not of the highlight's cosine.
pub(super) fn power_of_colour(q: &Highlight, cosine: f32) -> Rgb {
    let lambert = q.toward.dot(*q.normal);
    if lambert <= 0.0 {
        return Rgb::BLACK;
    }
    let shine = q.specular.map(|v| v.powf(q.exponent)) * cosine.max(0.0);
    (q.diffuse * lambert + shine) * q.arriving
}

/// The greater of both terms in each channel.
pub(super) fn greater_term(q: &Highlight, highlight: f32) -> Rgb {
    let lambert = q.toward.dot(*q.normal);
    if lambert <= 0.0 {
        return Rgb::BLACK;
    }
    let [matte, shine] = [q.diffuse * lambert, q.specular * highlight].map(Rgb::channels);
    let [r, g, b] = [0, 1, 2].map(|i| matte[i].max(shine[i]));
    Rgb::new(r, g, b) * q.arriving
}

/// A tenth of the light in the matte part's colour, from all sides.
pub(super) fn ambient(q: &Highlight) -> Rgb {
    q.diffuse * 0.1 * q.arriving
}

/// The light that would reach the matte part from below the surface.
pub(super) fn matte_from_below(q: &Highlight) -> Rgb {
    q.diffuse * (-q.toward.dot(*q.normal)).max(0.0) * q.arriving
}

pub(super) fn power(cosine: f32, q: &Highlight) -> f32 {
    cosine.max(0.0).powf(q.exponent)
}

/// A viewer above the surface, and a light, most often near enough to the viewer's mirror direction for a highlight.
pub(super) fn random(rng: &mut Pcg) -> Highlight {
    let (normal, view) = loop {
        let (normal, view) = (sample::direction(rng), sample::direction(rng));
        if normal.dot(*view) > 0.1 {
            break (normal, view);
        }
    };
    let toward = if rng.random_bool(0.15) {
        sample::direction(rng)
    } else {
        let near = *view + rng.random_range(0.1..0.5) * *sample::direction(rng);
        Dir3::new_or(2.0 * near.dot(*normal) * *normal - near, normal)
    };
    let mut colour = |least, most| {
        let mut channel = || sample::number(rng, least, most);
        Rgb::new(channel(), channel(), channel())
    };
    let (arriving, diffuse, specular) = (colour(0.5, 4.0), colour(0.02, 0.3), colour(0.1, 0.5));
    Highlight {
        normal,
        view,
        toward,
        arriving,
        diffuse,
        specular,
        exponent: sample::number(rng, 0.0, 4.5).exp2(),
    }
}

/// What the picture of both shows.
pub(super) const BALL: &str =
    "A shiny clay ball before a wall of the same material, lit from the upper left";

/// A pixel of the ball, or of the wall behind it.
pub(super) fn on_ball(x: u32, y: u32) -> Highlight {
    let place = |i: u32| (i as f32 + 0.5) / 29.0 - 32.0 / 29.0;
    let (x, y) = (place(x), -place(y));
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    let normal = if z > 0.0 { vec3(x, y, z) } else { Vec3::Z };
    Highlight {
        normal: Dir3::new_or(normal, Dir3::Z),
        view: Dir3::Z,
        toward: Dir3::new_or(vec3(-0.5, 0.6, 0.6), Dir3::Z),
        arriving: Rgb::gray(3.0),
        diffuse: Rgb::new(0.25, 0.07, 0.016),
        specular: Rgb::gray(0.25),
        exponent: 20.0,
    }
}

pub(super) fn radiance(golden: Rgb, got: Rgb) -> Verdict {
    channels(golden, got, 0.01)
}
