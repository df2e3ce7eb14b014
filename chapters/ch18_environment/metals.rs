//! Metals, from smooth to rough, under one sky.

use glam::{Vec3, vec2, vec3};
use rand::RngExt;
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::image::Image;
use raybook::light::Light;
use raybook::material::Material;
use raybook::material::conductor::{Conductor, Metal};
use raybook::material::ggx::Ggx;
use raybook::math::dir3::Dir3;
use raybook::math::pcg;
use raybook::render::film::Film;
use raybook::render::mis::Strategy;
use raybook::render::path::Path;
use raybook::render::sampler::Sampler;
use raybook::sample::hemisphere::cosine_hemisphere;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::Surface;
use raybook::shape::sphere::Sphere;

/// The columns, from left to right.
const METALS: [(&str, Metal); 4] = [
    ("gold", Metal::GOLD),
    ("copper", Metal::COPPER),
    ("silver", Metal::SILVER),
    ("aluminium", Metal::ALUMINIUM),
];
/// α of the row in the middle; the row above is smooth.
const ROUGH: f32 = 0.15;

/// Balls of four metals in three rows: smooth, rough, and with this α.
///
/// # Errors
/// If there is no such camera.
pub(super) fn draw(film: &Film, sky: Box<dyn Light>, alpha: f32) -> Result<Image, LookAtError> {
    /// Between the middles of two balls of radius 1, in metres.
    const STEP: f32 = 3.1;
    let ball = |column: usize, row: usize| {
        let (x, y) = (column as f32 - 1.5, 1.0 - row as f32);
        Sphere::new(STEP * vec3(x, y, 0.0), 1.0)
    };
    let mut things = Vec::new();
    for (column, (_, metal)) in METALS.into_iter().enumerate() {
        things.push(Thing::new(ball(column, 0), Conductor(metal)));
        for (row, alpha) in (1..).zip([ROUGH, alpha]) {
            things.push(Thing::new(ball(column, row), Ggx { metal, alpha }));
        }
    }
    let scene = Scene::new(things, vec![sky]);
    let eye = vec3(0.0, 0.0, 21.0);
    let camera = Pinhole::look_at(eye, Vec3::ZERO, Vec3::Y, 0.0541, film.aspect())?;
    let path = Path {
        depth: 3,
        roulette_after: 3,
        strategy: Strategy::Both,
    };
    Ok(film.denoised(&film.guides(&camera, &scene), |film| {
        film.render(&camera, &Sampler::Even, &path, &scene)
    }))
}

/// The picture cut into a tile for each ball, with its metal's name in the first row and its roughness below.
pub(super) fn named(picture: &Image, alpha: f32) -> Vec<(String, Image)> {
    let (width, height) = (picture.width() / 4, picture.height() / 3);
    let tile = |i: usize| {
        let name = match i / 4 {
            0 => METALS[i].0.to_owned(),
            1 => format!("α = {ROUGH}"),
            _ => format!("α = {alpha}"),
        };
        let pixel = |x, y| picture.at(i % 4 * width + x, i / 4 * height + y);
        (name, Image::from_fn(width, height, pixel))
    };
    (0..12).map(tile).collect()
}

/// The light that rough silver of this α reflects, as a share of the light that nearly smooth silver (α = 0.01) reflects, seen
/// from all sides under an even sky.
pub(super) fn kept(alpha: f32) -> f64 {
    let sent = |alpha| {
        let metal = Metal::SILVER;
        let (rough, mut numbers) = (Ggx { metal, alpha }, pcg::stream(18, 2));
        let at = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
        let mut two = || vec2(numbers.random(), numbers.random());
        let estimates = (0..20_000).map(|_| {
            let view = -cosine_hemisphere(Dir3::Y, two());
            rough.scatter(&at, view, two()).map_or(0.0, |scattered| {
                let cosine = scattered.toward.dot(Vec3::Y);
                f64::from(scattered.f.luminance() * cosine / scattered.pdf)
            })
        });
        estimates.sum::<f64>()
    };
    sent(alpha) / sent(0.01)
}
