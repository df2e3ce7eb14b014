//! Scenes for path tracing, each with its camera, and the error of a strategy's pictures.

use crate::kit::sheet::sheet;
use glam::Vec3;
use raybook::camera::Camera;
use raybook::camera::pinhole::{LookAtError, PLANE_HEIGHT, Pinhole};
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use raybook::render::film::Film;
use raybook::render::mis::Strategy;
use raybook::render::path::Path;
use raybook::scene::world::Scene;
use raybook::scene::{cornell, plates};
use raybook_scenes::gallery;
use std::error::Error;
use std::f64::consts::FRAC_1_SQRT_2;

/// The strategies, and what they are called.
pub(super) const STRATEGIES: [(Strategy, &str); 3] = [
    (Strategy::Surface, "by the surface"),
    (Strategy::Light, "by the light"),
    (Strategy::Both, "both, weighted"),
];

/// A scene, a camera, and how its radiance is displayed.
pub(super) struct View {
    /// The scene.
    pub scene: Scene,
    /// The camera.
    pub camera: Pinhole,
    /// Factor from radiance to the light of a display.
    pub exposure: Rgb,
}

impl View {
    /// The Cornell box from where it was photographed.
    ///
    /// The lamp is yellow, and so would be the picture; the exposure takes off most of the yellow, as eyes and cameras do.
    ///
    /// # Errors
    /// If there is no such camera.
    pub(super) fn cornell_box() -> Result<Self, LookAtError> {
        /// How much of the lamp's colour is taken off, and how much brighter the whole becomes.
        const ADAPTED: f32 = 0.75;
        const BRIGHTER: f32 = 3.4;
        let (eye, zoom) = (cornell::EYE, cornell::ZOOM * PLANE_HEIGHT);
        let lamp = cornell::LAMP / cornell::LAMP.luminance();
        Ok(Self {
            scene: cornell::cornell_box(),
            camera: Pinhole::look_at(eye, eye + Vec3::Z, Vec3::Y, zoom, 1.0)?,
            exposure: lamp.map(|v| BRIGHTER * v.powf(-ADAPTED)),
        })
    }

    /// The box with a mirror ball and a glass one, from the same place.
    ///
    /// # Errors
    /// If there is no such camera or scene.
    pub(super) fn with_balls() -> Result<Self, Box<dyn Error>> {
        Ok(Self {
            scene: gallery::CORNELL.shot(1)?.scene,
            ..Self::cornell_box()?
        })
    }

    /// The plates under their lamps.
    ///
    /// # Errors
    /// If there is no such camera.
    pub(super) fn plates(aspect: f32) -> Result<Self, LookAtError> {
        Ok(Self {
            scene: plates::plates(),
            camera: Pinhole::look_at(plates::EYE, plates::AT, Vec3::Y, 0.042, aspect)?,
            exposure: Rgb::gray(1.8),
        })
    }

    /// A path-traced picture with its noise, ready to be displayed.
    fn roll(&self, film: &Film, path: Path) -> Image {
        let ray = |place| self.camera.central_ray(place);
        let picture = film.sample(|at, rng| path.follow(&self.scene, &ray(at), rng));
        picture.map(|v| v * self.exposure)
    }

    /// The mean of two pictures with different seeds, and the relative RMS error of one of them: half of the mean square
    /// difference between the two is the mean square error of either. The error is relative to the mean value; values are those
    /// that a display shows, at most 1.
    pub(super) fn scatter(&self, film: &Film, path: Path) -> (Image, f64) {
        let other = Film {
            seed: !film.seed,
            ..*film
        };
        let [one, other] = [film, &other].map(|film| self.roll(film, path));
        let shown = |picture: &Image| -> Vec<f64> {
            let channels = picture.pixels().iter().flat_map(|p| p.channels());
            channels.map(|v| f64::from(v.min(1.0))).collect()
        };
        let (a, b) = (shown(&one), shown(&other));
        let squares: f64 = a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum();
        let (count, sum) = (a.len() as f64, a.iter().sum::<f64>());
        let mean = Image::from_fn(film.width, film.height, |x, y| {
            one.at(x, y).lerp(other.at(x, y), 0.5)
        });
        (mean, (0.5 * squares / count).sqrt() / (sum / count))
    }
}

/// The plates by the three strategies, with the same number of samples, and the error of each picture.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn figure(film: &Film) -> Result<Image, Box<dyn Error>> {
    let view = View::plates(film.aspect())?;
    let half = film.halved();
    let mut tiles = Vec::new();
    for (strategy, name) in STRATEGIES {
        let path = Path {
            depth: 1,
            roulette_after: 1,
            strategy,
        };
        let (picture, of_half) = view.scatter(&half, path);
        // Two independent halves are √2 times as good as either.
        let error = of_half * FRAC_1_SQRT_2;
        tiles.push((format!("{name}: error {:.0} %", 100.0 * error), picture));
    }
    sheet(STRATEGIES.len(), &tiles)
}
