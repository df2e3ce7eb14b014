//! Two prisms: each wavelength goes its own way through the glass, and white light leaves as a fan of colours.
//!
//! Rays that are parallel stay parallel at a plane surface, so a beam is a strip before the prism, in it and behind it, and a pixel
//! needs to know only in which strips it lies.

use crate::kit::sheet::{Sheet, sheet};
use glam::{Vec2, vec2};
use raybook::image::{Image, rgb::Rgb, spectrum};
use raybook::material::{dispersion::Sellmeier, fresnel::fresnel, refract::refract};
use raybook::math::dir3::Dir3;
use raybook::render::film::Film;

/// Wavelengths in nanometres, from violet to red, and their number.
const VISIBLE: [f32; 2] = [400.0, 700.0];
const WAVELENGTHS: u16 = 150;

/// A picture's middle and width, in sides of the prism.
const MIDDLE: Vec2 = Vec2::new(0.2, -0.3);
const WIDTH: f32 = 3.2;

/// The width of the beam, the height at which it enters the prism, and the near and far side of the white card that it falls on.
const BEAM: f32 = 0.025;
const HEIGHT: f32 = 0.04;
const CARD: [f32; 2] = [1.66, 1.8];

/// A strip with less than this share of the beam's light is not followed.
const FAINT: f32 = 0.002;

/// The radiance of a beam that nothing has spread, before the tone curve.
const EXPOSURE: f32 = 3.0;

/// A side of the prism: a point of it, and its normal, outwards.
#[derive(Clone, Copy)]
struct Side {
    at: Vec2,
    normal: Vec2,
}

/// A beam of parallel rays on its way.
#[derive(Clone, Copy)]
struct Strip {
    /// A point on its middle line.
    at: Vec2,
    toward: Vec2,
    width: f32,
    /// How much of the light it carries.
    power: f32,
    /// The side that the strip comes to or from, if it is outside the prism; `None` inside.
    outside: Option<usize>,
}

/// Strips, each in the colour of its wavelength.
type Beams = Vec<(Strip, Rgb)>;

/// A prism of crown glass and a prism of flint glass, with this angle at the top, in degrees; the beam passes with the least
/// deviation.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn prisms(film: &Film<'_>, degrees: f32) -> Sheet {
    let glasses = [
        ("crown glass, N-BK7", Sellmeier::BK7),
        ("dense flint glass, N-SF11", Sellmeier::SF11),
    ];
    let tiles = glasses.map(|(name, glass)| (name, picture(film, glass, degrees.to_radians())));
    sheet(2, &tiles)
}

/// One prism in the dark, seen from its side, of a glass and with the angle `apex` at its top, in radians.
pub fn picture(film: &Film<'_>, glass: Sellmeier, apex: f32) -> Image {
    let sides = prism(apex);
    let (inside, outside): (Beams, Beams) = beams(glass, apex, &sides)
        .into_iter()
        .partition(|(strip, _)| strip.outside.is_none());
    let size = vec2(film.width as f32, film.height as f32);
    let pixel = WIDTH / size.x;
    let light = |p: Vec2| {
        let depth = depth(&sides, p);
        let beams = if depth < 0.0 { &inside } else { &outside };
        let seen = beams.iter().filter(|(strip, _)| strip.reaches(&sides, p));
        let light = seen.fold(Rgb::BLACK, |sum, (strip, colour)| {
            sum + *colour * strip.density(p, pixel)
        });
        // The glass is a little lighter than the dark around it, and its edges more so.
        let edge = 0.1 * (1.0 - depth.abs() / (1.5 * pixel)).max(0.0);
        let glass = if depth < 0.0 { 0.012 } else { 0.003 };
        light * EXPOSURE + Rgb::WHITE * (edge + glass)
    };
    film.render_pixels(|x, y, _| {
        let from_middle = vec2(x as f32, y as f32) + 0.5 - 0.5 * size;
        let p = MIDDLE + pixel * from_middle * vec2(1.0, -1.0);
        // A card shows, over all of its width, what arrives at its front.
        let is_card = (CARD[0]..CARD[1]).contains(&p.x);
        let seen = if is_card {
            light(vec2(CARD[0], p.y)) * 2.0 + Rgb::WHITE * 0.05
        } else if p.x > CARD[1] {
            Rgb::WHITE * 0.003
        } else {
            light(p)
        };
        seen.map(|v| 1.0 - (-v.max(0.0)).exp())
    })
}

/// The sides of a prism, the left, the right and the base; they meet in the corners of an isosceles triangle around the origin.
fn prism(apex: f32) -> [Side; 3] {
    let (sine, cosine) = (0.5 * apex).sin_cos();
    let top = vec2(0.0, 0.5 * cosine);
    [
        Side {
            at: top,
            normal: vec2(-cosine, sine),
        },
        Side {
            at: top,
            normal: vec2(cosine, sine),
        },
        Side {
            at: -top,
            normal: vec2(0.0, -1.0),
        },
    ]
}

/// How far a point is outside of the prism; negative inside.
fn depth(sides: &[Side; 3], p: Vec2) -> f32 {
    let above = sides.map(|side| (p - side.at).dot(side.normal));
    above.into_iter().fold(f32::NEG_INFINITY, f32::max)
}

/// All strips of all wavelengths. The beam comes from the lower left, so that yellow light runs level in the glass.
fn beams(glass: Sellmeier, apex: f32, sides: &[Side; 3]) -> Beams {
    let step = (VISIBLE[1] - VISIBLE[0]) / f32::from(WAVELENGTHS);
    let all = (0..WAVELENGTHS).map(|i| VISIBLE[0] + (f32::from(i) + 0.5) * step);
    let colours: Vec<_> = all
        .map(|wavelength| (wavelength, spectrum::rgb(wavelength)))
        .collect();
    let white = colours
        .iter()
        .fold(Rgb::BLACK, |sum, (_, colour)| sum + *colour);
    // Least deviation: the ray makes the same angle with both sides (Snell's law, with A/2 inside).
    let incidence = (glass.index(587.6) * (0.5 * apex).sin()).asin();
    let toward = Vec2::from_angle(incidence - 0.5 * apex);
    let start = Strip {
        at: vec2((HEIGHT - sides[0].at.y) * (0.5 * apex).tan(), HEIGHT),
        toward,
        width: BEAM,
        power: 1.0,
        outside: Some(0),
    };
    let mut beams = vec![(start, Rgb::WHITE)];
    for (wavelength, colour) in colours {
        let index = glass.index(wavelength);
        let colour = Rgb::new(colour.r / white.r, colour.g / white.g, colour.b / white.b);
        let mut open = vec![(start, 0)];
        while let Some((strip, side)) = open.pop() {
            for next in strip.splits(sides[side], index) {
                let Some(mut next) = next.filter(|next| next.power > FAINT) else {
                    continue;
                };
                if depth(sides, next.at + 1e-3 * next.toward) > 0.0 {
                    next.outside = Some(side);
                } else if let Some(to) = next.ahead(sides, side) {
                    next.outside = None;
                    let at = next.meets(sides[to]);
                    open.push((Strip { at, ..next }, to));
                }
                beams.push((next, colour));
            }
        }
    }
    beams
}

impl Strip {
    /// Where its middle line meets a side.
    fn meets(&self, side: Side) -> Vec2 {
        let t = (side.at - self.at).dot(side.normal) / self.toward.dot(side.normal);
        self.at + t * self.toward
    }

    /// The side that it comes to inside, other than the one it comes from.
    fn ahead(&self, sides: &[Side; 3], from: usize) -> Option<usize> {
        let distance = |side: usize| (self.meets(sides[side]) - self.at).dot(self.toward);
        let others = (0..3).filter(|&side| side != from);
        let ahead = others.filter(|&side| self.toward.dot(sides[side].normal) > 0.0);
        ahead.min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
    }

    /// What is reflected at a side, and what goes through.
    fn splits(&self, side: Side, index: f32) -> [Option<Self>; 2] {
        let (toward, normal) = (self.toward, side.normal);
        let cosine = toward.dot(normal);
        let (here, there) = if cosine < 0.0 {
            (1.0, index)
        } else {
            (index, 1.0)
        };
        let share = fresnel(cosine.abs(), here, there).unpolarised;
        let mirrored = Self {
            toward: toward - 2.0 * cosine * normal,
            power: share * self.power,
            ..*self
        };
        let flat = |v: Vec2| Dir3::new_or(v.extend(0.0), Dir3::X);
        let through = refract(flat(toward), flat(normal), 1.0, index).map(|refracted| {
            let refracted = refracted.truncate();
            Self {
                toward: refracted,
                width: self.width * (refracted.dot(normal) / cosine).abs(),
                power: (1.0 - share) * self.power,
                ..*self
            }
        });
        [Some(mirrored), through]
    }

    /// Whether a point may lie in the strip, if both are outside the prism or both inside. Outside, the point must be on the
    /// outer side of the strip's side.
    fn reaches(&self, sides: &[Side; 3], p: Vec2) -> bool {
        self.outside
            .is_none_or(|side| (p - sides[side].at).dot(sides[side].normal) >= 0.0)
    }

    /// The light at a point, where 1 is the light of the first beam; the edge of a strip is blurred over a pixel.
    fn density(&self, p: Vec2, pixel: f32) -> f32 {
        let beside = (p - self.at).perp_dot(self.toward).abs();
        let inside = ((0.5 * self.width - beside) / pixel + 0.5).clamp(0.0, 1.0);
        self.power * BEAM / self.width * inside
    }
}
