//! Whitted's ray tracing: mirrors and glass show what further rays see.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::prelude::*;
//! use raybook::render::{local::Local, shadow::lit};
//!
//! let floor = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Mirror { share: Rgb::gray(0.9) });
//! let scene = Scene::new(vec![floor], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
//! let whitted = Whitted { local: Local { samples: 1, arrives: Some(lit) }, depth: 4 };
//! let seen = whitted.radiance(&scene, &Ray::new(Vec3::Y, -Dir3::Y), &mut pcg::stream(0, 0));
//! assert_eq!(seen, Rgb::gray(0.9)); // what the mirrored ray sees, times the mirror's share
//! ```

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::{See, Sight, beyond};
use crate::math::ray::Ray;
use crate::render::local::{Local, Visibility};
use crate::render::{cone::Cone, followed::Followed, sampler::Integrator};
use crate::scene::world::Scene;
use crate::shape::Surface;
use rand::Rng;

/// Recursive ray tracing (Whitted, "An improved illumination model for shaded display", 1980).
#[derive(Clone, Copy, Debug)]
pub struct Whitted<A = Visibility> {
    /// The local illumination at each surface.
    pub local: Local<A>,
    /// Maximum number of surfaces in a row; what a mirror or glass would show after the last one is black.
    pub depth: u32,
}

/// Rays whose contribution to the pixel is below this share are not traced (adaptive tree-depth control: Hall and Greenberg, "A
/// testbed for realistic image synthesis", 1983).
const LEAST: f32 = 1.0 / 512.0;

/// A ray of the tree of rays, with its limits.
struct Twig {
    /// Number of surfaces in a row that may still be met.
    left: u32,
    /// The ray's share of the pixel's radiance, from 0 to 1.
    share: f32,
    /// The width of the ray.
    cone: Cone,
}

impl<A: Fn(&Scene, &Surface, &LightSample) -> bool> Whitted<A> {
    // ANCHOR: whitted
    /// The radiance that a ray sees: L = local illumination + the radiance of the mirrored and refracted rays ([`beyond`]), which
    /// are followed in the same way.
    ///
    /// Between two facing mirrors this would never end. So each further ray has one surface less left, and at 0 it is black.
    pub fn follow(&self, scene: &Scene, ray: &Ray, rng: &mut dyn Rng) -> Followed {
        self.follow_cone(scene, ray, Cone::THIN, rng)
    }

    fn sight(
        &self,
        scene: &Scene,
        ray: &Ray,
        Twig { left, share, cone }: Twig,
        rng: &mut dyn Rng,
        rays: &mut u64,
    ) -> Sight {
        let nothing = |radiance| Sight {
            radiance,
            distance: f32::INFINITY,
        };
        if left == 0 || share < LEAST {
            return nothing(Rgb::BLACK);
        }
        *rays += 1;
        let Some(mut seen) = scene.closest(ray) else {
            return nothing(scene.behind_everything(ray));
        };
        let (view, cone) = (-ray.direction, cone.after(seen.t));
        cone.cover(&mut seen.surface, view);
        let local = self.local.follow(scene, &seen, view, rng);
        *rays += local.rays;
        let see: &mut See = &mut |ray, of_it| {
            let twig = Twig {
                left: left - 1,
                share: of_it * share,
                cone,
            };
            self.sight(scene, ray, twig, rng, rays)
        };
        Sight {
            radiance: local.radiance + beyond(seen.material, &seen.surface, view, see),
            distance: seen.t,
        }
    }
    // ANCHOR_END: whitted

    /// The root of the tree of rays, with a first ray of this width.
    fn trunk(&self, cone: Cone) -> Twig {
        Twig {
            left: self.depth,
            share: 1.0,
            cone,
        }
    }

    /// As [`Whitted::follow`], with a first ray of this width.
    fn follow_cone(&self, scene: &Scene, ray: &Ray, cone: Cone, rng: &mut dyn Rng) -> Followed {
        let mut rays = 0;
        let sight = self.sight(scene, ray, self.trunk(cone), rng, &mut rays);
        Followed {
            radiance: sight.radiance,
            rays,
        }
    }

    /// The radiance of [`Whitted::follow`], without the number of rays.
    pub fn radiance(&self, scene: &Scene, ray: &Ray, rng: &mut dyn Rng) -> Rgb {
        self.follow(scene, ray, rng).radiance
    }
}

impl<A: Fn(&Scene, &Surface, &LightSample) -> bool + Sync> Integrator for Whitted<A> {
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed {
        self.follow_cone(scene, ray, cone, numbers)
    }
}
