//! Path tracing: the rendering equation, by following one path of light at a time from the eye.

use crate::image::rgb::Rgb;
use crate::material::{Delta, Scatter, glass::Medium};
use crate::math::{dir3::Dir3, ray::Ray};
use crate::render::{cone::Cone, followed::Followed, mis::Strategy, sampler::Integrator, shadow};
use crate::scene::world::{Scene, Seen};
use glam::vec2;
use rand::{Rng, RngExt};

/// Follows light from surface to surface (Kajiya, "The rendering equation", 1986).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Maximum number of bounces over which light is followed: 1 is light straight from the lights, [`u32::MAX`] is all there is.
    pub depth: u32,
    /// Number of bounces after which Russian roulette may end the path.
    pub roulette_after: u32,
    /// How directions are chosen in which light may come straight from a light.
    pub strategy: Strategy,
}

/// The highest probability with which a path goes on in Russian roulette: between white walls it must end some day too.
const LUCKIEST: f32 = 0.95;

impl Path {
    /// All the light there is, the directions chosen in both ways; from the fourth surface on, Russian roulette.
    pub const WHOLE: Self = Self {
        depth: u32::MAX,
        roulette_after: 3,
        strategy: Strategy::Both,
    };

    // ANCHOR: path
    /// An estimate of what a ray sees: L_o = L_e + ∫ f L_i cos θ dω, where L_i asks the same question of the next surface.
    ///
    /// `weight` is the product of f cos θ/p so far. Light straight from a light is looked for twice: towards the light (next
    /// event estimation) and by the ray that goes on; the strategy shares it out. L_i of the rest is followed by one ray. In a
    /// mirror or through glass no light can be looked for: only the ray that goes on finds it.
    /// The mean over all random numbers is exact, but for what `depth` cuts off.
    pub fn follow(&self, scene: &Scene, ray: &Ray, rng: &mut dyn Rng) -> Followed {
        self.follow_cone(scene, ray, Cone::THIN, rng)
    }

    fn follow_cone(&self, scene: &Scene, ray: &Ray, mut cone: Cone, rng: &mut dyn Rng) -> Followed {
        let (mut ray, mut pdf) = (*ray, f32::INFINITY);
        let (mut sum, mut weight) = (Followed::default(), Rgb::WHITE);
        let (mut surfaces, mut medium) = (0, Medium::AIR);
        loop {
            sum.rays += 1;
            let seen = scene.closest(&ray);
            let found = self.found(scene, &ray, seen.as_ref().map(|seen| seen.t), pdf);
            let (Some(mut seen), None) = (seen, found) else {
                let (t, radiance) = found.unwrap_or((f32::INFINITY, Rgb::BLACK));
                sum.radiance += weight * medium.transmittance(t) * radiance;
                return sum;
            };
            weight = weight * medium.transmittance(seen.t);
            let view = -ray.direction;
            cone = cone.after(seen.t);
            cone.cover(&mut seen.surface, view);
            sum.radiance += weight * seen.material.emitted(&seen.surface, view);
            if surfaces == self.depth {
                return sum;
            }
            surfaces += 1;
            let lobes = Lobes::of(&seen, view);
            if lobes.scatters {
                let direct = self.next_event(scene, &seen, view, lobes.to_scatter(), rng);
                sum.radiance += weight * direct.radiance;
                sum.rays += direct.rays;
            }
            let Some(next) = lobes.sample(&seen, view, rng) else {
                return sum;
            };
            weight = weight * next.weight;
            if surfaces > self.roulette_after {
                let Some(survivor) = roulette(weight, rng) else {
                    return sum;
                };
                weight = survivor;
            }
            (ray, pdf) = match next.medium {
                Some(_) => (seen.surface.leave(next.toward), next.pdf),
                None => (seen.surface.leave_smooth(next.toward), next.pdf),
            };
            medium = next.medium.unwrap_or(medium);
        }
    }
    // ANCHOR_END: path

    /// The same, uncounted.
    pub fn radiance(&self, scene: &Scene, ray: &Ray, rng: &mut dyn Rng) -> Rgb {
        self.follow(scene, ray, rng).radiance
    }

    // ANCHOR: next_event
    /// The radiance towards the viewer of light that comes straight from the lights: a place on each is asked.
    ///
    /// `to_scatter` is the probability with which the path goes on by f, so that its ray may find the same light.
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

    /// How far away is the light that a ray finds before it meets a surface at t, and our share of its radiance; else `None`.
    ///
    /// A ray that meets no surface always finds something: the backdrop, and all lights at infinity.
    fn found(&self, scene: &Scene, ray: &Ray, t: Option<f32>, pdf: f32) -> Option<(f32, Rgb)> {
        let mut nearest = t.unwrap_or(f32::INFINITY);
        let mut found = t.is_none().then(|| (scene.backdrop)(ray));
        for light in &scene.lights {
            if let Some(hit) = light.seen(ray, nearest) {
                let share = self.strategy.of_surface(pdf, hit.pdf);
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
        self.follow_cone(scene, ray, cone, numbers)
    }
}

/// Where a path goes on.
struct Next {
    toward: Dir3,
    /// p, in 1/sr; ∞ for a lobe of one direction.
    pdf: f32,
    /// f cos θ/p.
    weight: Rgb,
    /// What it goes through from here on, if that is something else.
    medium: Option<Medium>,
}

/// The lobes of a surface, one of which a path follows, each about as often as it has light to send.
struct Lobes {
    scatters: bool,
    /// The shares of the lobes of one direction, added up.
    deltas: f32,
    /// The share that is left to f; of what it really sends, nothing is known here.
    rest: f32,
}

impl Lobes {
    /// A share below which f is not asked less often: it may send more than what the others leave.
    const LEAST: f32 = 0.1;

    fn of(seen: &Seen, view: Dir3) -> Self {
        let (mut deltas, scatters) = (0.0, seen.material.scatters(&seen.surface));
        let mut add = |lobe: Delta| deltas += lobe.share.max_channel();
        seen.material.deltas(&seen.surface, view, &mut add);
        let rest = if scatters {
            (1.0 - deltas).max(Self::LEAST)
        } else {
            0.0
        };
        Self {
            scatters,
            deltas,
            rest,
        }
    }

    /// The probability with which f is followed.
    fn to_scatter(&self) -> f32 {
        self.rest / (self.deltas + self.rest)
    }

    /// A direction of one of the lobes; `None` where it leads nowhere.
    fn sample(&self, seen: &Seen, view: Dir3, rng: &mut dyn Rng) -> Option<Next> {
        if self.deltas == 0.0 {
            return self.scatter(seen, view, rng);
        }
        let all = self.deltas + self.rest;
        let (mut left, mut next) = (rng.random::<f32>() * all, None);
        seen.material.deltas(&seen.surface, view, &mut |lobe| {
            let share = lobe.share.max_channel();
            if next.is_none() && left < share {
                next = Some(Next {
                    toward: lobe.toward,
                    pdf: f32::INFINITY,
                    weight: lobe.share * (all / share),
                    medium: Some(lobe.medium),
                });
            }
            left -= share;
        });
        if next.is_some() || !self.scatters {
            return next;
        }
        self.scatter(seen, view, rng)
    }

    /// A direction that f chooses.
    fn scatter(&self, seen: &Seen, view: Dir3, rng: &mut dyn Rng) -> Option<Next> {
        let (at, u) = (&seen.surface, vec2(rng.random(), rng.random()));
        let Scatter { toward, pdf, f } = seen.material.scatter(at, view, u)?;
        let pdf = pdf * self.to_scatter();
        let cosine = at.facing(view).dot(*toward);
        let weight = f * (cosine / pdf);
        (pdf > 0.0 && weight != Rgb::BLACK).then_some(Next {
            toward,
            pdf,
            weight,
            medium: None,
        })
    }
}

// ANCHOR: roulette
/// Ends a path with a probability 1 − q and divides what survives by q: right in the mean, and less work for little light
/// (Arvo and Kirk, "Particle transport and image synthesis", 1990).
fn roulette(weight: Rgb, rng: &mut dyn Rng) -> Option<Rgb> {
    let [r, g, b] = weight.channels();
    let q = r.max(g).max(b).min(LUCKIEST);
    (rng.random::<f32>() < q).then(|| weight / q)
}
// ANCHOR_END: roulette
