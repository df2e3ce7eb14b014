//! Path tracing: the rendering equation, estimated by following one path of light at a time from the eye.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::prelude::*;
//!
//! // A ball under a white sky: with one bounce, it shows the sky times its albedo.
//! let ball = Thing::new(Sphere::new(Vec3::ZERO, 1.0), Lambert { albedo: Rgb::gray(0.25) });
//! let scene = Scene::new(vec![ball], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
//! let ray = Ray::new(vec3(0.0, 0.0, 3.0), -Dir3::Z);
//! let seen = |depth| Path { depth, ..Path::WHOLE }.radiance(&scene, &ray, &mut pcg::stream(1, 0)).g;
//! assert_eq!(seen(0), 0.0); // the ball emits nothing
//! assert!((seen(1) - 0.25).abs() < 1e-5);
//! ```

use crate::image::rgb::Rgb;
use crate::material::glass::Medium;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::render::lobes::{Lobes, choice};
use crate::render::photons::Photons;
use crate::render::{cone::Cone, followed::Followed, mis::Strategy, sampler::Integrator, shadow};
use crate::scene::world::{Scene, Seen};
use glam::vec2;
use rand::{Rng, RngExt};

/// A path tracer (Kajiya, "The rendering equation", 1986).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Maximum number of bounces: 0 shows emitted light only, 1 adds direct light, and [`u32::MAX`] shows all light.
    pub depth: u32,
    /// Number of bounces after which Russian roulette may end the path.
    pub roulette_after: u32,
    /// How directions are chosen for direct light.
    pub strategy: Strategy,
}

/// Maximum probability with which a path survives Russian roulette: so it also ends between white walls.
const MAX_SURVIVAL: f32 = 0.95;

impl Path {
    /// All light, by both strategies, with Russian roulette from the fourth bounce on.
    pub const WHOLE: Self = Self {
        depth: u32::MAX,
        roulette_after: 3,
        strategy: Strategy::Both,
    };

    // ANCHOR: path
    /// An estimate of the radiance that a ray sees: L_o = L_e + ∫ f L_i cos θ dω, where L_i is the L_o of the next surface.
    ///
    /// `weight` is the product of f cos θ/p, and of the media's transmittance, along the path up to the ray. Direct light is estimated
    /// in two ways: by a shadow ray towards the light (next event estimation), and by the ray that continues the path; the
    /// strategy weights the two. All other light is estimated by the ray that continues the path, and so is all light in a mirror
    /// or through glass. The estimate is unbiased, except for the light that `depth` cuts off.
    pub fn follow(&self, scene: &Scene, ray: &Ray, rng: &mut dyn Rng) -> Followed {
        let (sum, _) = self.follow_with(None, scene, ray, Cone::THIN, rng);
        sum
    }

    /// The same estimate, and beside it the radiance of the caustics that `photons` bring, if there are any
    /// ([`Caustics`](crate::render::caustics::Caustics)). Each surface that scatters is then lit by the photons around it, and no longer
    /// by a lamp that the path finds by delta lobes only.
    pub(crate) fn follow_with(
        &self,
        photons: Option<&Photons>,
        scene: &Scene,
        ray: &Ray,
        mut cone: Cone,
        rng: &mut dyn Rng,
    ) -> (Followed, Rgb) {
        let (mut ray, mut pdf) = (*ray, f32::INFINITY);
        let (mut sum, mut weight) = (Followed::default(), Rgb::WHITE);
        let (mut surfaces, mut medium) = (0, Medium::AIR);
        let (mut caustics, mut has_scattered) = (Rgb::BLACK, false);
        loop {
            sum.rays += 1;
            let seen = scene.closest(&ray);
            let t = seen.as_ref().map(|seen| seen.t);
            let brought = photons.filter(|_| has_scattered && pdf == f32::INFINITY);
            let found = self.found(scene, &ray, t, pdf, brought);
            let (Some(mut seen), None) = (seen, found) else {
                let (t, radiance) = found.unwrap_or((f32::INFINITY, Rgb::BLACK));
                sum.radiance += weight * medium.transmittance(t) * radiance;
                break;
            };
            weight = weight * medium.transmittance(seen.t);
            let view = -ray.direction;
            cone = cone.after(seen.t);
            cone.cover(&mut seen.surface, view);
            sum.radiance += weight * seen.material.emitted(&seen.surface, view);
            if surfaces == self.depth {
                break;
            }
            surfaces += 1;
            let lobes = Lobes::of(&seen, view);
            if lobes.scatters {
                let direct = self.next_event(scene, &seen, view, lobes.to_scatter(), rng);
                sum.radiance += weight * direct.radiance;
                sum.rays += direct.rays;
                if let Some(photons) = photons {
                    let most = self.depth - surfaces;
                    caustics += weight * photons.reflected(scene, &seen, view, most);
                }
            }
            let Some(next) = lobes.sample(&seen, view, rng) else {
                break;
            };
            weight = weight * next.weight;
            if surfaces > self.roulette_after {
                let Some(survivor) = roulette(weight, rng) else {
                    break;
                };
                weight = survivor;
            }
            (ray, pdf) = match next.medium {
                Some(_) => (seen.surface.leave(next.toward), next.pdf),
                None => (seen.surface.leave_smooth(next.toward), next.pdf),
            };
            has_scattered |= next.medium.is_none();
            medium = next.medium.unwrap_or(medium);
        }
        (sum, caustics)
    }
    // ANCHOR_END: path

    /// The radiance of [`Path::follow`], without the number of rays.
    pub fn radiance(&self, scene: &Scene, ray: &Ray, rng: &mut dyn Rng) -> Rgb {
        self.follow(scene, ray, rng).radiance
    }

    // ANCHOR: next_event
    /// Next event estimation: an estimate of the direct light that is reflected to the viewer, by one sample of each light.
    ///
    /// `to_scatter` is the probability with which the path is continued by f, so that its ray may find the same light.
    fn next_event(
        &self,
        scene: &Scene,
        seen: &Seen,
        view: Dir3,
        to_scatter: f32,
        rng: &mut dyn Rng,
    ) -> Followed {
        let mut sum = Followed::default();
        for light in &scene.lights {
            let u = vec2(rng.random(), rng.random());
            let Some(sample) = light.sample(seen.surface.position, u) else {
                continue;
            };
            let all = seen.material.lit(&seen.surface, view, &sample);
            if all == Rgb::BLACK {
                continue;
            }
            let surface = seen.material.pdf(&seen.surface, view, sample.toward) * to_scatter;
            let light = all * self.strategy.of_light(sample.pdf, surface);
            // The shadow ray costs more than everything else, so it is only followed for light that counts.
            if light == Rgb::BLACK {
                continue;
            }
            sum.rays += 1;
            if shadow::lit(scene, &seen.surface, &sample) {
                sum.radiance += light;
            }
        }
        sum
    }
    // ANCHOR_END: next_event

    /// The distance of the light that a ray meets before a surface at the distance t, and the light's radiance times its weight;
    /// `None` if it meets the surface first.
    ///
    /// A ray that meets no surface always finds light: the backdrop, and all lights at infinity. If photons have `brought` the light
    /// that the ray might find, the lights that emitted them are black.
    fn found(
        &self,
        scene: &Scene,
        ray: &Ray,
        t: Option<f32>,
        pdf: f32,
        brought: Option<&Photons>,
    ) -> Option<(f32, Rgb)> {
        let mut nearest = t.unwrap_or(f32::INFINITY);
        let mut found = t.is_none().then(|| (scene.backdrop)(ray));
        for (i, light) in scene.lights.iter().enumerate() {
            if let Some(hit) = light.seen(ray, nearest) {
                let share = match brought {
                    Some(photons) if photons.come_from(i) => 0.0,
                    _ => self.strategy.of_surface(pdf, hit.pdf),
                };
                let behind = found.filter(|_| hit.t == nearest).unwrap_or(Rgb::BLACK);
                found = Some(behind + hit.radiance * share);
                nearest = hit.t;
            }
        }
        found.map(|radiance| (nearest, radiance))
    }
}

impl Integrator for Path {
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed {
        let (sum, _) = self.follow_with(None, scene, ray, cone, numbers);
        sum
    }
}

// ANCHOR: roulette
/// Russian roulette: ends a path with the probability 1 − q, and divides the weight of a survivor by q. The estimate stays
/// unbiased, and less work is spent on little light (Arvo and Kirk, "Particle transport and image synthesis", 1990). q is the
/// largest channel of the weight, at most [`MAX_SURVIVAL`].
pub(crate) fn roulette(weight: Rgb, rng: &mut dyn Rng) -> Option<Rgb> {
    let [r, g, b] = weight.channels();
    let q = r.max(g).max(b).min(MAX_SURVIVAL);
    (choice(rng) < q).then(|| weight / q)
}
// ANCHOR_END: roulette
