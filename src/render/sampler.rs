//! The one loop from a scene to a picture, and its samplers: how many samples each pixel gets, and where they are.

use crate::camera::Camera;
use crate::image::Image;
use crate::math::{pcg::Pcg, ray::Ray};
use crate::render::adaptive::{Limits, adaptive, by_budget};
use crate::render::{cone::Cone, film::Film, followed::Followed};
use crate::render::{needs_more::Enough, supersample::supersample};
use crate::sample::pattern::Pattern;
use crate::scene::world::Scene;
use glam::{Vec2, vec2};
use rand::{Rng, RngExt};

// ANCHOR: integrator
/// A way to find the radiance that comes along a ray through a scene.
pub trait Integrator: Sync {
    /// An estimate of the radiance, whose mean over all random numbers counts, and the rays that were followed for it.
    ///
    /// `cone` says how wide the ray is meant to be: textures are averaged over that.
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed;
}
// ANCHOR_END: integrator

/// How many samples each pixel gets, and where they are. The numbers of a pixel follow from the film's seed and its place.
#[derive(Clone, Copy, Debug, Default)]
pub enum Sampler<'a> {
    /// All samples of the film, by Sobol's points as Owen scrambles them, for every choice of a sample ([`Film::evenly`]).
    #[default]
    Even,
    /// The same numbers, but fewer samples where they are alike ([`Film::refine`]): for light that does not come by chance.
    Refined,
    /// All samples, at places of the pixel that a pattern chooses; all else is left to chance ([`supersample`]).
    Pattern(&'a Pattern),
    /// Samples until they are enough, within limits ([`adaptive`]).
    Adaptive(Limits, Enough),
    /// All samples of the film on average, shared out by what the first few of each pixel say ([`by_budget`]).
    Budget {
        /// The first few of each pixel.
        first: usize,
    },
}

impl Film<'_> {
    // ANCHOR: render
    /// The picture that a camera takes of a scene: the mean of what the rays of each pixel's samples bring.
    ///
    /// ```
    /// use raybook::prelude::*;
    ///
    /// let ball = Thing::new(Sphere::new(Vec3::ZERO, 1.0), Lambert { albedo: Rgb::gray(0.5) });
    /// let scene = Scene::new(vec![ball], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
    /// let film = Film::new(9, 9, 4);
    /// let camera = Pinhole::look_at(vec3(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y, focal_length(40.0), 1.0)?;
    /// let picture = film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
    /// assert!((picture.at(4, 4).g - 0.5).abs() < 1e-4, "half of the white around is sent on");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn render(
        &self,
        camera: &dyn Camera,
        sampler: &Sampler,
        integrator: &dyn Integrator,
        scene: &Scene,
    ) -> Image {
        let cone = Cone::of_sample(camera, self);
        // A pin-hole takes no number for its lens: of Sobol's points, the first ones are the most even.
        let see = |place: Vec2, numbers: &mut dyn Rng| {
            let lens = if camera.has_lens() {
                vec2(numbers.random(), numbers.random())
            } else {
                Vec2::splat(0.5)
            };
            integrator.follow(scene, &camera.ray(place, lens), cone, numbers)
        };
        let by_chance = |place: Vec2, numbers: &mut Pcg| see(place, numbers);
        match *sampler {
            Sampler::Even => self.evenly(|place, numbers| see(place, numbers)),
            Sampler::Refined => self.refine(|place, numbers| see(place, numbers)),
            Sampler::Pattern(pattern) => supersample(self, pattern, by_chance),
            Sampler::Adaptive(limits, enough) => adaptive(self, limits, &enough, by_chance).picture,
            Sampler::Budget { first } => by_budget(self, first, self.samples, by_chance).picture,
        }
    }
    // ANCHOR_END: render
}
