//! Scenes for path tracing, each with its camera, and how much a strategy's pictures scatter.

use raybook::camera::pinhole::{LookAtError, PLANE_HEIGHT, Pinhole};
use raybook::image::{Image, rgb::Rgb};
use crate::shared::even;
use crate::kit::sheet::sheet;
use raybook::material::brdf::Brdf;
use raybook::render::{film::Film, mis::Strategy, path::Path};
use raybook::scene::world::Scene;
use raybook::scene::{cornell, plates};
use glam::Vec3;
use std::error::Error;

/// The strategies, and what they are called.
pub const STRATEGIES: [(Strategy, &str); 3] = [
    (Strategy::Surface, "by the surface"),
    (Strategy::Light, "by the light"),
    (Strategy::Both, "both, weighted"),
];

/// A scene, a camera, and how its radiance is displayed.
pub struct View {
    scene: Scene<dyn Brdf>,
    camera: Pinhole,
    exposure: Rgb,
}

impl View {
    /// The Cornell box from where it was photographed.
    ///
    /// Its lamp is yellow, and so would be the picture; eyes and cameras take most of that off.
    ///
    /// # Errors
    /// If there is no such camera.
    pub fn cornell_box() -> Result<Self, LookAtError> {
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

    /// The plates under their lamps.
    ///
    /// # Errors
    /// If there is no such camera.
    pub fn plates(aspect: f32) -> Result<Self, LookAtError> {
        Ok(Self {
            scene: plates::plates(),
            camera: Pinhole::look_at(plates::EYE, plates::AT, Vec3::Y, 0.042, aspect)?,
            exposure: Rgb::gray(1.8),
        })
    }

    /// A picture by paths, ready to be displayed, with random numbers that are spread evenly.
    pub fn draw(&self, film: &Film, path: Path) -> Image {
        let ray = |place| self.camera.ray_through(place);
        let picture = even::render(film, |at, rng| path.follow(&self.scene, &ray(at), rng));
        picture.map(|v| v * self.exposure)
    }

    /// The same with all that chance does.
    fn roll(&self, film: &Film, path: Path) -> Image {
        let ray = |place| self.camera.ray_through(place);
        let picture = film.render(|at, rng| path.follow(&self.scene, &ray(at), rng));
        picture.map(|v| v * self.exposure)
    }

    /// A picture, and how much it scatters: half of the mean square difference between it and one with another seed is the
    /// mean square error of either. Relative to the mean, of what a display shows, which ends at 1.
    pub fn scatter(&self, film: &Film, path: Path) -> (Image, f64) {
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
        (one, (0.5 * squares / count).sqrt() / (sum / count))
    }
}

/// The plates by the three strategies, at as many samples each, with how much they scatter.
///
/// # Errors
/// If a caption cannot be drawn.
pub fn figure(film: &Film) -> Result<Image, Box<dyn Error>> {
    let view = View::plates(film.aspect())?;
    let mut tiles = Vec::new();
    for (strategy, name) in STRATEGIES {
        let path = Path {
            depth: 1,
            sure: 1,
            strategy,
        };
        let (picture, error) = view.scatter(film, path);
        tiles.push((format!("{name}: error {:.0} %", 100.0 * error), picture));
    }
    let tiles: Vec<_> = tiles
        .iter()
        .map(|(text, tile)| (text.as_str(), tile.clone()))
        .collect();
    sheet(STRATEGIES.len(), &tiles)
}
