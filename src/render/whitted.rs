//! Whitted's ray tracing: what a surface shows in itself or through itself is seen by another ray.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::{See, Sight, beyond};
use crate::math::ray::Ray;
use crate::render::local::{Arrives, Local};
use crate::render::{cone::Cone, followed::Followed, sampler::Integrator};
use crate::scene::world::Scene;
use crate::shape::Surface;
use rand::Rng;

/// Follows rays from surface to surface (Whitted, "An improved illumination model for shaded display", 1980).
#[derive(Clone, Copy, Debug)]
pub struct Whitted<A = Arrives> {
    /// How light from the lights is gathered at each surface.
    pub local: Local<A>,
    /// Maximum number of surfaces in a row that are followed; what the last one would show of others is black.
    pub depth: u32,
}

/// What counts for less than this share of a picture's light is not looked at either: at a ray tree's hundreds of twigs
/// (Hall and Greenberg, "A testbed for realistic image synthesis", 1983).
const LEAST: f32 = 1.0 / 512.0;

/// A ray of the tree, and those that follow from it.
struct Twig {
    /// Number of surfaces that are still followed in a row.
    left: u32,
    /// The share of the picture's light that it counts for.
    share: f32,
    /// How wide it is.
    cone: Cone,
}

impl<A: Fn(&Scene, &Surface, &LightSample) -> bool> Whitted<A> {
    // ANCHOR: whitted
    /// What a ray sees: L = local illumination + what the material sees beyond, which asks the same question again.
    ///
    /// Two facing mirrors would ask for ever. Each question has one surface less to go, and at 0 the answer is black.
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

    /// The whole tree of rays, for a first ray as wide as this.
    fn trunk(&self, cone: Cone) -> Twig {
        Twig {
            left: self.depth,
            share: 1.0,
            cone,
        }
    }

    /// The same, for a first ray as wide as this.
    fn follow_cone(&self, scene: &Scene, ray: &Ray, cone: Cone, rng: &mut dyn Rng) -> Followed {
        let mut rays = 0;
        let sight = self.sight(scene, ray, self.trunk(cone), rng, &mut rays);
        Followed {
            radiance: sight.radiance,
            rays,
        }
    }

    /// The same, uncounted.
    pub fn radiance(&self, scene: &Scene, ray: &Ray, rng: &mut dyn Rng) -> Rgb {
        self.follow(scene, ray, rng).radiance
    }
}

impl<A: Fn(&Scene, &Surface, &LightSample) -> bool + Sync> Integrator for Whitted<A> {
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed {
        self.follow_cone(scene, ray, cone, numbers)
    }
}
