//! Path tracing: the rendering equation, by following one path of light at a time from the eye.

use crate::image::rgb::Rgb;
use crate::material::brdf::Brdf;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::render::{followed::Followed, mis::Strategy, shadow};
use crate::scene::world::{Scene, Seen};
use glam::vec2;
use rand::{Rng, RngExt};

/// Follows light from surface to surface (Kajiya, "The rendering equation", 1986).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Light is followed over at most so many surfaces: 1 is light straight from the lights, [`u32::MAX`] is all there is.
    pub depth: u32,
    /// Over so many surfaces it is followed in any case; from then on Russian roulette may end the path.
    pub sure: u32,
    /// How directions are chosen in which light may come straight from a light.
    pub strategy: Strategy,
}

/// The highest probability with which a path goes on in Russian roulette: between white walls it must end some day too.
const LUCKIEST: f32 = 0.95;

impl Path {
    // ANCHOR: path
    /// An estimate of what a ray sees: L_o = L_e + ∫ f L_i cos θ dω, where L_i asks the same question of the next surface.
    ///
    /// `weight` is the product of f cos θ/p so far. Light straight from a light is looked for twice: towards the light (next
    /// event estimation) and by the ray that goes on; the strategy shares it out. L_i of the rest is followed by one ray.
    /// The mean over all random numbers is exact, but for what `depth` cuts off.
    pub fn follow(&self, scene: &Scene<dyn Brdf>, ray: &Ray, rng: &mut impl Rng) -> Followed {
        let (mut ray, mut pdf) = (*ray, f32::INFINITY);
        let (mut sum, mut weight) = (Followed::default(), Rgb::WHITE);
        let mut surfaces = 0;
        loop {
            sum.rays += 1;
            let seen = scene.closest(&ray);
            let found = self.found(scene, &ray, seen.as_ref().map(|seen| seen.t), pdf);
            let (Some(seen), None) = (seen, found) else {
                sum.radiance += weight * found.unwrap_or(Rgb::BLACK);
                return sum;
            };
            let view = -ray.direction;
            sum.radiance += weight * seen.material.emitted(&seen.surface, view);
            if surfaces == self.depth {
                return sum;
            }
            surfaces += 1;
            let direct = self.next_event(scene, &seen, view, rng);
            sum.radiance += weight * direct.radiance;
            sum.rays += direct.rays;
            let Some(next) = Next::sample(&seen, view, rng) else {
                return sum;
            };
            weight = weight * next.weight;
            if surfaces > self.sure {
                let Some(survivor) = roulette(weight, rng) else {
                    return sum;
                };
                weight = survivor;
            }
            (ray, pdf) = (seen.surface.leave(next.toward), next.pdf);
        }
    }
    // ANCHOR_END: path

    /// The same, uncounted.
    pub fn radiance(&self, scene: &Scene<dyn Brdf>, ray: &Ray, rng: &mut impl Rng) -> Rgb {
        self.follow(scene, ray, rng).radiance
    }

    // ANCHOR: next_event
    /// The radiance towards the viewer of light that comes straight from the lights: a place on each is asked.
    fn next_event(
        &self,
        scene: &Scene<dyn Brdf>,
        seen: &Seen<dyn Brdf>,
        view: Dir3,
        rng: &mut impl Rng,
    ) -> Followed {
        let mut sum = Followed::default();
        for light in &scene.lights {
            let u = vec2(rng.random(), rng.random());
            let Some(sample) = light.sample(seen.surface.position, u) else {
                continue;
            };
            let surface = seen.material.pdf(&seen.surface, view, sample.toward);
            let share = self.strategy.of_light(sample.pdf, surface);
            let light = seen.material.reflect(&seen.surface, view, &sample) * share;
            // The shadow ray costs more than all the rest: only for light that would count.
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

    /// The radiance, and our share of it, of the light that a ray finds before it meets a surface at t; else `None`.
    ///
    /// A ray that meets no surface always finds something: the backdrop, and all lights at infinity.
    fn found(&self, scene: &Scene<dyn Brdf>, ray: &Ray, t: Option<f32>, pdf: f32) -> Option<Rgb> {
        let mut nearest = t.unwrap_or(f32::INFINITY);
        let mut found = t.is_none().then(|| (scene.backdrop)(ray));
        for light in &scene.lights {
            if let Some((t, radiance)) = light.seen(ray).filter(|(t, _)| *t <= nearest) {
                let share = self
                    .strategy
                    .of_surface(pdf, light.pdf(ray.origin, ray.direction));
                let behind = found.filter(|_| t == nearest).unwrap_or(Rgb::BLACK);
                found = Some(behind + radiance * share);
                nearest = t;
            }
        }
        found
    }
}

/// Where a path goes on.
struct Next {
    toward: Dir3,
    /// p, in 1/sr.
    pdf: f32,
    /// f cos θ/p.
    weight: Rgb,
}

impl Next {
    /// A direction that the surface chooses; `None` where it leads nowhere.
    fn sample(seen: &Seen<dyn Brdf>, view: Dir3, rng: &mut impl Rng) -> Option<Self> {
        let (at, u) = (&seen.surface, vec2(rng.random(), rng.random()));
        let toward = seen.material.sample(at, view, u)?;
        let pdf = seen.material.pdf(at, view, toward);
        let cosine = at.facing(view).dot(*toward);
        let weight = seen.material.eval(at, view, toward) * (cosine / pdf);
        (pdf > 0.0 && weight != Rgb::BLACK).then_some(Self {
            toward,
            pdf,
            weight,
        })
    }
}

// ANCHOR: roulette
/// Ends a path with a probability 1 − q and divides what survives by q: right in the mean, and less work for little light
/// (Arvo and Kirk, "Particle transport and image synthesis", 1990).
fn roulette(weight: Rgb, rng: &mut impl Rng) -> Option<Rgb> {
    let [r, g, b] = weight.channels();
    let q = r.max(g).max(b).min(LUCKIEST);
    (rng.random::<f32>() < q).then(|| weight / q)
}
// ANCHOR_END: roulette
