//! What lamps out of focus look like through apertures of several shapes.

use super::tea_table::{EYE, dusk, lamps};
use crate::kit::sheet::sheet;
use glam::{Vec3, vec3};
use raybook::camera::aperture::Aperture;
use raybook::camera::pinhole::Pinhole;
use raybook::camera::thin_lens::ThinLens;
use raybook::image::{Image, rgb::Rgb};
use raybook::render::film::Film;
use raybook::render::glints::add_glints;
use raybook::render::path::Path;
use raybook::render::sampler::Sampler;
use raybook::scene::world::Scene;
use std::error::Error;

/// Where the lamps hang.
const AT: Vec3 = vec3(0.1, 0.62, -4.0);

/// The lamps are brighter than at the table by this factor: this lens spreads their light over larger discs.
const BRIGHTER: f32 = 1.8;

/// The focal length in metres, the f-number and the distance in focus in metres.
const LENS: (f32, f32, f32) = (0.085, 1.8, 0.9);

/// The lamps before the evening sky, once for each aperture.
///
/// # Errors
/// If the tiles' names cannot be drawn.
pub(super) fn draw(film: &Film) -> Result<Image, Box<dyn Error>> {
    let (focal_length, f_number, focus) = LENS;
    let body = Pinhole::look_at(EYE, AT, Vec3::Y, focal_length, film.aspect())?;
    let blades = |count, turn| Aperture::Blades { count, turn };
    let mut lamps = lamps();
    for lamp in &mut lamps {
        lamp.intensity = lamp.intensity * BRIGHTER;
    }
    let evening = Scene::new(vec![], vec![]).surrounded_by(Rgb::BLACK, dusk);
    let mut tiles = Vec::new();
    for (name, aperture) in [
        ("round", Aperture::Round),
        ("5 blades", blades(5, 0.3)),
        ("6 blades", blades(6, 0.0)),
        ("8 blades", blades(8, 0.2)),
    ] {
        let camera = ThinLens::new(&body, f_number, focus, aperture)?;
        let mut picture = film.denoised(&[], |film| {
            film.render(&camera, &Sampler::Even, &Path::WHOLE, &evening)
        });
        add_glints(&mut picture, film, &camera, &lamps, |_, _| true);
        tiles.push((name, picture));
    }
    sheet(4, &tiles)
}
