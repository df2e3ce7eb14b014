//! Means of estimates of the reflected radiance, as integrals: the right one, and those of wrong estimates. A wrong estimate may choose
//! directions by one density and divide by another.

use crate::cases::ch16_soft_shadows;
use crate::cases::ch17_rendering_equation::{at_height, farthest};
use crate::upon::changed;
use glam::Vec3;
use raybook::image::rgb::Rgb;
use raybook::material::mirror;
use raybook::math::{basis::Basis, dir3::Dir3};
use raybook::sample::hemisphere;
use raybook_workbook::exercises::ch17_rendering_equation::ReflectedRadiance;
use std::f32::consts::{PI, TAU};
use std::sync::LazyLock;

/// The integral's cells from the horizon up, and round the normal.
const RINGS: u32 = 48;
const SECTORS: u32 = 40;

/// The middles of the cells, around +z: an explanation is tried by a thousand integrals, which share them.
static MIDDLES: LazyLock<Vec<Vec3>> = LazyLock::new(|| {
    let middle = |i: u32| {
        let z = ((i / SECTORS) as f32 + 0.5) / RINGS as f32;
        at_height(z, TAU * ((i % SECTORS) as f32 + 0.5) / SECTORS as f32)
    };
    (0..RINGS * SECTORS).map(middle).collect()
});

/// ∫ g dω over the hemisphere around the normal, of several g, by the middles of cells of equal solid angle.
pub(super) fn integral<const N: usize>(normal: Dir3, g: impl Fn(Dir3) -> [Rgb; N]) -> [Rgb; N] {
    let basis = Basis::around(normal);
    let mut sums = [Rgb::BLACK; N];
    for middle in MIDDLES.iter() {
        let d = Dir3::new_or(basis.to_world(*middle), normal);
        for (sum, value) in sums.iter_mut().zip(g(d)) {
            *sum += value * (TAU / (RINGS * SECTORS) as f32);
        }
    }
    sums
}

/// What is integrated: the parts of the BRDF, the light, and weights.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// A factor of the matte part.
    pub(super) matte: f32,
    /// A factor of the highlight.
    pub(super) gloss: fn(n: f32) -> f32,
    /// The cosine of the highlight to the power of its exponent.
    pub(super) shine: fn(&ReflectedRadiance, Dir3) -> f32,
    pub(super) sky: fn(&ReflectedRadiance, Dir3) -> Rgb,
    /// Each is the density of the directions that are chosen over that by which is divided.
    pub(super) weights: [Weight; 2],
}

/// What makes a direction count more than it should, or less.
pub(super) type Weight = fn(&ReflectedRadiance, Dir3) -> f32;

/// ∫ f L_i cos θ · weights dω, as a wrong estimate would have it in the mean: with a change.
pub(super) fn integrated(q: &ReflectedRadiance, change: impl FnOnce(&mut How)) -> Rgb {
    let right = How {
        matte: 1.0,
        gloss: |_| 1.0,
        shine: |q, d| d.dot(*mirrored(q)).max(0.0).powf(q.exponent),
        sky: ReflectedRadiance::sky,
        weights: [|_, _| 1.0; 2],
    };
    whole(q, &changed(right, change))
}

fn whole(q: &ReflectedRadiance, how: &How) -> Rgb {
    let n = q.exponent;
    let matte = q.diffuse * (how.matte / PI);
    let gloss = q.specular * ((how.gloss)(n) * (n + 2.0) / TAU);
    let [sum] = integral(q.normal, |d| {
        let [one, other] = how.weights.map(|weight| weight(q, d));
        let brdf = matte + gloss * (how.shine)(q, d);
        [brdf * (how.sky)(q, d) * (cosine(q, d) * one * other)]
    });
    sum
}

/// The weight of a direction of either kind that is divided by its own density, in the place of the density of both: the highlight's
/// reach no direction beyond 90° from its axis.
pub(super) fn by_own_density(q: &ReflectedRadiance, d: Dir3) -> f32 {
    let is_reached = highlight(q, q.exponent, d) > 0.0;
    if is_reached { 1.0 } else { 0.5 }
}

/// The integral with a weight, or with one more.
pub(super) fn estimated(q: &ReflectedRadiance, weight: Weight) -> Rgb {
    integrated(q, |how| how.weights = [weight, how.weights[0]])
}

/// The same with another light.
pub(super) fn under(q: &ReflectedRadiance, sky: fn(&ReflectedRadiance, Dir3) -> Rgb) -> Rgb {
    integrated(q, |how| how.sky = sky)
}

/// The cosine of the angle between a direction and the normal.
pub(super) fn cosine(q: &ReflectedRadiance, d: Dir3) -> f32 {
    d.dot(*q.normal)
}

/// The density (n + 1)/2π · cosⁿ α around an axis.
pub(super) fn lobe(axis: Vec3, n: f32, d: Dir3) -> f32 {
    (n + 1.0) / TAU * d.dot(axis).max(0.0).powf(n)
}

/// The density of the cosine.
pub(super) fn matte(q: &ReflectedRadiance, d: Dir3) -> f32 {
    lobe(*q.normal, 1.0, d)
}

/// The density of the highlight's lobe, of this exponent, around the mirrored viewer.
pub(super) fn highlight(q: &ReflectedRadiance, n: f32, d: Dir3) -> f32 {
    lobe(*mirrored(q), n, d)
}

/// The density of directions of which half are chosen by the cosine and half by the highlight.
pub(super) fn both(q: &ReflectedRadiance, d: Dir3) -> f32 {
    0.5 * (matte(q, d) + highlight(q, q.exponent, d))
}

/// The weight of a direction, of which this share is chosen by the cosine and the rest by the highlight, that is divided by the density of
/// half and half.
pub(super) fn uneven(q: &ReflectedRadiance, by_cosine: f32, d: Dir3) -> f32 {
    let gloss = highlight(q, q.exponent, d);
    (by_cosine * matte(q, d) + (1.0 - by_cosine) * gloss) / both(q, d)
}

/// The weight of a direction of this density that is divided by `least` where the density is less.
pub(super) fn raised(least: f32, density: f32) -> f32 {
    density / density.max(least)
}

/// The mean of samples of this density, each channel of which is at most 1.
pub(super) fn clamped(q: &ReflectedRadiance, density: fn(&ReflectedRadiance, Dir3) -> f32) -> Rgb {
    let [sum] = integral(q.normal, |d| {
        let light = q.brdf().value(q.normal, q.view, d) * q.sky(d) * cosine(q, d);
        let most = density(q, d);
        [light.map(|v| v.min(most))]
    });
    sum
}

/// The mean of samples of cosine and highlight, of which the light over the density, for a sky of radiance 1 at its zenith, is at most `limit`.
pub(super) fn clamped_light(q: &ReflectedRadiance, limit: f32) -> Rgb {
    let [sum] = integral(q.normal, |d| {
        let light = (0.5 + 0.5 * d.dot(*q.zenith)) * cosine(q, d);
        let kept = light.min(limit * both(q, d));
        [q.brdf().value(q.normal, q.view, d) * q.radiance * kept]
    });
    sum
}

/// The axes and exponents of the two lobes of which half of the directions are each: that of the cosine, and the highlight's.
pub(super) fn lobes(q: &ReflectedRadiance) -> [(Dir3, f32); 2] {
    [(q.normal, 1.0), (mirrored(q), q.exponent)]
}

/// The axes beside a direction that the library builds.
pub(super) fn built(z: Dir3) -> [Vec3; 2] {
    let Basis { x, y, .. } = Basis::around(z);
    [*x, *y]
}

/// The axes beside a direction that are cross products with the world's axis farthest from it.
pub(super) fn crossed(z: Dir3) -> [Vec3; 2] {
    ch16_soft_shadows::crossed(z, -farthest(z)).map(Vec3::normalize_or_zero)
}

/// The mean of samples of such lobes, as many of each, if one number makes both angles of a direction: the directions are on a curve, by the axes
/// beside that of the lobe. `height` is the power n + 1 of the cosine of a direction of the exponent n.
pub(super) fn on_curve(
    q: &ReflectedRadiance,
    lobes: &[(Dir3, f32)],
    axes: fn(Dir3) -> [Vec3; 2],
    height: fn(f32) -> f32,
) -> Rgb {
    const STEPS: u32 = 1000;
    let count = lobes.len() as f32;
    let mut sum = Rgb::BLACK;
    for (axis, n) in lobes {
        let [x, y] = axes(*axis);
        for step in 0..STEPS {
            let u = (step as f32 + 0.5) / STEPS as f32;
            let d = at_height(height(u).powf(1.0 / (n + 1.0)), TAU * u);
            let d = Dir3::new_or(d.x * x + d.y * y + d.z * **axis, *axis);
            let sum_of_densities: f32 = lobes.iter().map(|(axis, n)| lobe(**axis, *n, d)).sum();
            let weight = count * cosine(q, d).max(0.0) / sum_of_densities.max(1e-9);
            sum += q.brdf().value(q.normal, q.view, d) * q.sky(d) * weight;
        }
    }
    sum / (STEPS as f32 * count)
}

/// The viewer's mirror direction.
pub(super) fn mirrored(q: &ReflectedRadiance) -> Dir3 {
    -mirror::reflect(q.view, q.normal)
}

/// 1/sin θ, which is infinite at the pole: its mean over a ring of the integral's.
pub(super) fn inverse_sine(cosine: f32) -> f32 {
    let half = 0.5 / RINGS as f32;
    let [upper, lower] = [cosine + half, cosine - half].map(|z| z.clamp(0.0, 1.0).asin());
    RINGS as f32 * (upper - lower)
}

/// The density of directions at all heights alike, from an axis to 90° from it.
pub(super) fn half_sphere(axis: Vec3, d: Dir3) -> f32 {
    if d.dot(axis) > 0.0 {
        hemisphere::UNIFORM
    } else {
        0.0
    }
}

/// What the highlight's directions below the surface bring with a weight, if their cosine counts as positive and the BRDF goes on
/// there.
pub(super) fn from_below(
    q: &ReflectedRadiance,
    weight: fn(&ReflectedRadiance, Dir3) -> f32,
) -> Rgb {
    let n = q.exponent;
    let [sum] = integral(-q.normal, |d| {
        let shine = (n + 2.0) / TAU * d.dot(*mirrored(q)).max(0.0).powf(n);
        let brdf = q.diffuse * (1.0 / PI) + q.specular * shine;
        [brdf * q.sky(d) * -cosine(q, d) * weight(q, d)]
    });
    sum
}
