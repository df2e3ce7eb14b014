//! A photograph behind a picture that a map lights: a texel of the map is as large as many pixels, and would be seen.

use raybook::camera::Camera;
use raybook::image::{Image, rgb::Rgb};
use raybook::math::dir3::Dir3;
use raybook::render::film::Film;
use raybook::scene::world::Scene;

/// What a camera sees of a radiance that comes from far away, from each direction.
pub fn surroundings(
    film: &Film,
    camera: &dyn Camera,
    radiance: impl Fn(Dir3) -> Rgb + Sync,
) -> Image {
    film.sample(|place, _| radiance(camera.central_ray(place).direction))
}

/// The share of each pixel in which a camera sees none of the scene's things.
pub fn open(film: &Film, camera: &dyn Camera, scene: &Scene) -> Image {
    film.sample(|place, _| match scene.closest(&camera.central_ray(place)) {
        Some(_) => Rgb::BLACK,
        None => Rgb::WHITE,
    })
}

/// A picture with a plate in the place of the map that is seen behind the things, as far as they leave it open.
pub fn before(plate: &Image, map: &Image, open: &Image, picture: &Image) -> Image {
    Image::from_fn(picture.width(), picture.height(), |x, y| {
        let [plate, map, open, seen] = [plate, map, open, picture].map(|image| image.at(x, y));
        if open == Rgb::WHITE {
            plate
        } else {
            seen + open * (plate + map * -1.0)
        }
    })
}
