//! The choice of a direction for a surface with a matte part and a highlight.

use crate::image::rgb::Rgb;
use crate::math::dir3::Dir3;
use crate::sample::hemisphere::{cosine_hemisphere, cosine_pdf};
use glam::{Vec2, vec2};

/// Which of the two parts a direction is chosen from.
pub(super) struct MatteAndGlossy {
    /// The probability of the highlight: ρ_s/(ρ_d + ρ_s), by luminance, its share of the reflected light.
    glossy: f32,
}

impl MatteAndGlossy {
    /// For the shares ρ_d and ρ_s of the light that leave in the two parts.
    pub(super) fn of(diffuse: Rgb, specular: Rgb) -> Self {
        let [matte, glossy] = [diffuse, specular].map(Rgb::luminance);
        Self {
            glossy: glossy / (matte + glossy).max(f32::MIN_POSITIVE),
        }
    }

    /// A direction of one of the two parts; `None` if it is not above the surface. `highlight` chooses from the highlight.
    ///
    /// u.x chooses the part; what is left of u.x is scaled to [0, 1), where it is uniform again.
    pub(super) fn sample(
        &self,
        normal: Dir3,
        u: Vec2,
        highlight: impl FnOnce(Vec2) -> Dir3,
    ) -> Option<Dir3> {
        let toward = if u.x < self.glossy {
            highlight(vec2(u.x / self.glossy, u.y))
        } else {
            let rest = vec2((u.x - self.glossy) / (1.0 - self.glossy), u.y);
            cosine_hemisphere(normal, rest)
        };
        (toward.dot(*normal) > 0.0).then_some(toward)
    }

    /// The weighted sum of both parts' densities, because the same direction may be chosen from either. `highlight` is the density of
    /// the highlight, in 1/sr.
    pub(super) fn pdf(&self, normal: Dir3, toward: Dir3, highlight: impl FnOnce() -> f32) -> f32 {
        let cosine = normal.dot(*toward);
        if cosine <= 0.0 {
            return 0.0;
        }
        self.glossy * highlight() + (1.0 - self.glossy) * cosine_pdf(cosine)
    }
}
