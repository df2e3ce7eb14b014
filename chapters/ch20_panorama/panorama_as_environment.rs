//! Uses of a panorama as an environment map: the panorama shows its scene again, and it lights other scenes.

use super::all_around::wide;
use crate::kit::plate;
use crate::kit::sheet::sheet;
use glam::{Vec3, vec3};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::{Image, rgb::Rgb, tone};
use raybook::light::environment::Environment;
use raybook::render::clamped::Clamped;
use raybook::render::film::Film;
use raybook::render::mis::Strategy;
use raybook::render::path::Path;
use raybook::render::sampler::Sampler;
use raybook_scenes::gallery;
use raybook_scenes::wrong::TextError;
use std::error::Error;

/// The directions of the looks, by their names.
const LOOKS: [(&str, Vec3); 3] = [
    ("ahead", vec3(0.0, -0.2, -1.0)),
    ("right", vec3(1.0, -0.12, 0.15)),
    ("up and back", vec3(-0.25, 0.75, 0.6)),
];

/// Three looks from the point where the panorama was taken, side by side: as a pin-hole camera takes them, below as the
/// environment shows them, and below that how they differ.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn looks(
    film: &Film,
    from: Vec3,
    environment: &Environment,
    photograph: impl Fn(&Film, &dyn Camera) -> Image,
) -> Result<Image, Box<dyn Error>> {
    let [mut rendered, mut cut, mut off] = [Vec::new(), Vec::new(), Vec::new()];
    for (name, toward) in LOOKS {
        let camera = wide(from, toward, 85.0, film.aspect())?;
        let real = photograph(film, &camera);
        let seen = plate::surroundings(film, &camera, |toward| environment.radiance(toward));
        off.push(("difference × 4", difference(&real, &seen)));
        rendered.push((name, real));
        cut.push(("cut out of the panorama", seen));
    }
    sheet(3, &[rendered, cut, off].concat())
}

/// White where two pictures are the same on a display, darker where they differ: four times the difference.
fn difference(a: &Image, b: &Image) -> Image {
    Image::from_fn(a.width(), a.height(), |x, y| {
        let [a, b] = [a, b].map(|image| tone::clamp(image.at(x, y)));
        let off = a + b * -1.0;
        off.map(|v| 1.0 - (4.0 * v.abs()).min(1.0))
    })
}

/// The still life in the light of the panorama alone: as it is, and with all radiance cut off at white. Behind it is the plate, a
/// photograph of the same directions: the camera sees so small a part of the panorama that a texel is as large as four pixels.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn lit(
    film: &Film,
    from: Vec3,
    panorama: &Environment,
    photograph: impl Fn(&Film, &dyn Camera) -> Image,
) -> Result<Image, Box<dyn Error>> {
    // Nearer than in chapter 18, so that more of the panorama is seen.
    let (eye, to) = (vec3(0.5, 1.2, 4.3), vec3(0.0, 0.66, 0.0));
    let at = |eye, to| Pinhole::look_at(eye, to, Vec3::Y, 0.024, film.aspect());
    let (camera, photograph) = (at(eye, to)?, photograph(film, &at(from, from + to - eye)?));
    let shapes = gallery::STILL_LIFE.shot(film.width)?.scene;
    let guides = film.guides(&camera, &shapes);
    let open = plate::open(film, &camera, &shapes);
    let path = Path {
        depth: 4,
        roulette_after: 2,
        strategy: Strategy::Both,
    };
    // Few paths find the sun by way of the metal: each of them would be a white dot.
    let path = Clamped {
        integrator: path,
        brightest: 8.0,
    };
    let tile = |shown: fn(Rgb) -> Rgb| -> Result<Image, TextError> {
        let light = Environment::new(panorama.map().map(shown));
        let seen = plate::surroundings(film, &camera, |toward| light.radiance(toward));
        let scene = gallery::STILL_LIFE
            .under(Box::new(light), film.width)?
            .scene;
        let lit = film.denoised(&guides, |film| {
            film.render(&camera, &Sampler::Even, &path, &scene)
        });
        Ok(plate::before(&photograph.map(shown), &seen, &open, &lit))
    };
    let tiles = [
        ("the panorama", tile(|radiance| radiance)?),
        ("cut off at white", tile(tone::clamp)?),
    ];
    sheet(2, &tiles)
}
