//! The loop from a scene to a picture, and its samplers: the number of samples of each pixel, and their places.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::{adaptive::Limits, needs_more::StoppingRule};
//!
//! let scene = Scene::new(vec![], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::gray(0.5));
//! let camera = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, focal_length(40.0), 1.0)?;
//! let adaptive = Sampler::Adaptive(Limits { first: 2, most: 8 }, StoppingRule::BY_CONTRAST);
//! // Samplers differ in their noise and in their time, not in what they estimate.
//! for sampler in [Sampler::Even, Sampler::Refined, Sampler::Budget { first: 2 }, adaptive] {
//!     let picture = Film::new(2, 2, 4).render(&camera, &sampler, &Path::WHOLE, &scene);
//!     assert_eq!(picture.at(1, 1), Rgb::gray(0.5));
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::camera::Camera;
use crate::image::Image;
use crate::math::ray::Ray;
use crate::render::adaptive::{Limits, adaptive, by_budget};
use crate::render::needs_more::StoppingRule;
use crate::render::supersample::{Points, supersample};
use crate::render::{cone::Cone, film::Film, followed::Followed};
use crate::scene::world::Scene;
use glam::{Vec2, vec2};
use rand::{Rng, RngExt};
use std::fmt;

// ANCHOR: integrator
/// An integrator: a method to estimate the radiance that comes along a ray through a scene.
pub trait Integrator: Sync {
    /// An estimate of the radiance, and the number of rays that were followed for it. The average of the estimate over all random
    /// numbers is the result of the integrator.
    ///
    /// `cone` is the width of the ray, over which textures are averaged.
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed;
}
// ANCHOR_END: integrator

/// The number of samples of each pixel, and their random numbers: a pair for the place in the pixel, and one for each further
/// choice, as the point on the lens. All numbers of a pixel follow from the film's seed and the pixel's place.
#[derive(Clone, Copy, Default)]
pub enum Sampler<'a> {
    /// All samples of the film, with Owen-scrambled Sobol points for every random choice of a sample ([`Film::evenly`]).
    #[default]
    Even,
    /// The same points, but fewer samples where they are similar ([`Film::refine`]): for pictures without noise.
    Refined,
    /// All samples, with the points of a [`Pattern`](crate::sample::pattern::Pattern), or of a function, for every random choice
    /// ([`supersample`]).
    Pattern(&'a dyn Points),
    /// Within limits, as many samples as a pixel needs ([`adaptive`]).
    Adaptive(Limits, StoppingRule),
    /// The film's samples per pixel on average, distributed by the deviation of the first samples of each pixel ([`by_budget`]).
    Budget {
        /// Number of first samples of each pixel; at least 2.
        first: usize,
    },
}

impl fmt::Debug for Sampler<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Even => write!(f, "Even"),
            Self::Refined => write!(f, "Refined"),
            Self::Pattern(_) => write!(f, "Pattern"),
            Self::Adaptive(limits, rule) => write!(f, "Adaptive({limits:?}, {rule:?})"),
            Self::Budget { first } => write!(f, "Budget {{ first: {first} }}"),
        }
    }
}

impl Film<'_> {
    // ANCHOR: render
    /// The picture that a camera takes of a scene: the mean radiance over the samples of each pixel, weighted by the film's filter.
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
        // A pin-hole camera needs no numbers for a lens: making them would cost time.
        let see = |place: Vec2, numbers: &mut dyn Rng| {
            if !camera.sees(place) {
                return Followed::default();
            }
            let ray = if camera.has_lens() {
                camera.ray(place, vec2(numbers.random(), numbers.random()))
            } else {
                camera.central_ray(place)
            };
            integrator.follow(scene, &ray, cone, numbers)
        };
        match *sampler {
            Sampler::Even => self.evenly(|place, numbers| see(place, numbers)),
            Sampler::Refined => self.refine(|place, numbers| see(place, numbers)),
            Sampler::Pattern(pattern) => supersample(self, pattern, see),
            Sampler::Adaptive(limits, enough) => adaptive(self, limits, &enough, see).picture,
            Sampler::Budget { first } => by_budget(self, first, self.samples, see).picture,
        }
    }
    // ANCHOR_END: render
}
