//! The lobes of a surface, of which a path or a photon follows one, chosen by chance.

use crate::image::rgb::Rgb;
use crate::material::{Delta, Scatter, glass::Medium};
use crate::math::dir3::Dir3;
use crate::scene::world::Seen;
use glam::vec2;
use rand::{Rng, RngExt};

/// The direction in which a path is continued.
pub(crate) struct Next {
    pub(crate) toward: Dir3,
    /// p, in 1/sr; ∞ for a delta lobe.
    pub(crate) pdf: f32,
    /// f cos θ/p.
    pub(crate) weight: Rgb,
    /// The medium that the ray goes through, for a delta lobe; `None` if the medium stays the same.
    pub(crate) medium: Option<Medium>,
}

/// The lobes of a surface. A path follows one of them, with a probability about proportional to the light that the lobe brings.
pub(crate) struct Lobes {
    /// Whether the surface scatters light.
    pub(crate) scatters: bool,
    /// The sum of the delta lobes' shares.
    delta_share: f32,
    /// The share that is left for f: an upper bound if the material conserves energy.
    rest: f32,
}

impl Lobes {
    /// Minimum of `rest` for a surface that scatters, because f may reflect more than the delta lobes leave.
    const LEAST: f32 = 0.1;

    pub(crate) fn of(seen: &Seen, view: Dir3) -> Self {
        let (mut delta_share, scatters) = (0.0, seen.material.scatters(&seen.surface));
        let mut add = |lobe: Delta| delta_share += lobe.share.max_channel();
        seen.material.delta_lobes(&seen.surface, view, &mut add);
        let rest = if scatters {
            (1.0 - delta_share).max(Self::LEAST)
        } else {
            0.0
        };
        Self {
            scatters,
            delta_share,
            rest,
        }
    }

    /// The probability with which the path is continued by f.
    pub(crate) fn to_scatter(&self) -> f32 {
        self.rest / (self.delta_share + self.rest)
    }

    /// A direction of one of the lobes; `None` ends the path.
    pub(crate) fn sample(&self, seen: &Seen, view: Dir3, rng: &mut dyn Rng) -> Option<Next> {
        let next = self.sample_delta(seen, view, rng);
        if next.is_some() || !(self.scatters || self.delta_share == 0.0) {
            return next;
        }
        self.scatter(seen, view, rng)
    }

    /// The direction of one of the delta lobes; `None` if the light is scattered or absorbed instead.
    pub(crate) fn sample_delta(&self, seen: &Seen, view: Dir3, rng: &mut dyn Rng) -> Option<Next> {
        if self.delta_share == 0.0 {
            return None;
        }
        let all = self.delta_share + self.rest;
        let (mut left, mut next) = (choice(rng) * all, None);
        seen.material.delta_lobes(&seen.surface, view, &mut |lobe| {
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
        next
    }

    /// A direction chosen by f.
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

/// A number for a choice. Numbers come in pairs, whose points are evenly spread ([`Even`](crate::sample::even::Even)): the second one is left
/// out, so that the next two are a pair again.
pub(crate) fn choice(rng: &mut dyn Rng) -> f32 {
    let [number, _]: [f32; 2] = rng.random();
    number
}
