//! Fractions of a light that are seen, by the points of a lattice on it: rightly, and as students mistake them.

use crate::cases::ch16_soft_shadows::lattice;
use crate::upon::changed;
use glam::{Vec2, Vec3};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, sphere::Sphere};
use raybook_workbook::exercises::ch16_soft_shadows::{Ball, VisibleFraction};

/// Points along each side of a lattice that stands for the whole light.
pub(super) const FINE: u32 = 32;

/// The fractions, by a lattice fine enough to stand for the exact value.
pub(super) fn exact(q: &VisibleFraction) -> Vec<f32> {
    seen(q, FINE, |u| u)
}

/// The fraction of point i by a lattice that reaches into the light's corners, and by balls of this scale: where it is 1 for larger balls, all of
/// the light is seen, and where it is 0 for smaller ones, nothing.
pub(super) fn to_the_corners(q: &VisibleFraction, i: usize, scale: f32) -> f32 {
    let mut scaled = q.clone();
    scaled.points = vec![q.points[i]];
    for ball in &mut scaled.balls {
        ball.radius *= scale;
    }
    let reaching = |u| 0.5 + (u - 0.5) * FINE as f32 / (FINE - 1) as f32;
    seen(&scaled, FINE, reaching)[0]
}

/// How the samples of a light are chosen, asked and counted; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// Points along each side of the lattice that stands for random places.
    pub(super) n: u32,
    /// What is made of two random numbers at once.
    pub(super) pair: fn(u: Vec2) -> Vec2,
    /// After that, what is made of each of them: of that along a, and of that along b.
    pub(super) along: [fn(u: f32) -> f32; 2],
    /// Where a shadow ray begins.
    pub(super) begin: f32,
    /// Where it ends, if the light is at this `distance`.
    pub(super) end: fn(distance: f32) -> f32,
    /// Whether a ball blocks the way `from` a point along a vector `r` that ends at the light.
    pub(super) blocks: fn(ball: &Sphere, from: Vec3, r: Vec3, within: Interval) -> bool,
    /// How much a sample counts that is seen along a vector `r`.
    pub(super) weight: fn(r: Vec3, normal: Vec3) -> f32,
    /// From which number on is counted.
    pub(super) count_from: f32,
    /// How many samples are taken if this number is asked for.
    pub(super) taken: fn(samples: f32) -> f32,
    /// By what their count is divided.
    pub(super) divisor: fn(samples: f32) -> f32,
}

/// As it should be.
const WELL: How = How {
    n: 16,
    pair: |u| u,
    along: [|u| u; 2],
    begin: 0.0,
    end: |distance| distance,
    blocks: hides,
    weight: |_, _| 1.0,
    count_from: 0.0,
    taken: |samples| samples,
    divisor: |samples| samples,
};

/// Whether a ball is in the way `from` a point along a vector.
pub(super) fn hides(ball: &Sphere, from: Vec3, r: Vec3, within: Interval) -> bool {
    Dir3::new(r).is_none_or(|d| ball.blocks(&Ray::new(from, d), within))
}

/// The fractions, rightly but for what is changed, by a lattice in place of random numbers.
pub(super) fn sampled(q: &VisibleFraction, change: impl FnOnce(&mut How)) -> Vec<f32> {
    fractions(q, &changed(WELL, change))
}

fn fractions(q: &VisibleFraction, how: &How) -> Vec<f32> {
    let samples = q.samples as f32;
    let whole =
        |share: f32| (how.count_from + share * (how.taken)(samples)) / (how.divisor)(samples);
    shares(q, how).into_iter().map(whole).collect()
}

/// The same, by a lattice fine enough to stand for the exact value.
pub(super) fn finely(q: &VisibleFraction, change: impl FnOnce(&mut How)) -> Vec<f32> {
    sampled(q, |how| {
        how.n = FINE;
        change(how);
    })
}

/// The share of the light that each point sees, by the points of the light to which an n × n lattice is mapped.
pub(super) fn seen(q: &VisibleFraction, n: u32, pair: fn(u: Vec2) -> Vec2) -> Vec<f32> {
    shares(q, &How { n, pair, ..WELL })
}

/// Of each point, which places it sees of the lattice that stands for the whole light.
pub(super) fn seen_places(q: &VisibleFraction) -> Vec<Vec<bool>> {
    let how = How { n: FINE, ..WELL };
    let is_seen = |counts: Vec<f32>| counts.into_iter().map(|count| count > 0.0).collect();
    counts(q, &how).into_iter().map(is_seen).collect()
}

/// The share of all places that each point sees.
fn shares(q: &VisibleFraction, how: &How) -> Vec<f32> {
    let share = |counts: Vec<f32>| counts.iter().sum::<f32>() / (how.n * how.n) as f32;
    counts(q, how).into_iter().map(share).collect()
}

/// Of each point, how much each place counts: not at all, where it is hidden.
fn counts(q: &VisibleFraction, how: &How) -> Vec<Vec<f32>> {
    let sphere = |ball: &Ball| Sphere::new(ball.center, ball.radius);
    let balls: Vec<_> = q.balls.iter().map(sphere).collect();
    let normal = q.a.cross(q.b);
    let count = |from: Vec3, u: Vec2| {
        let [along_a, along_b] = how.along;
        let u = (how.pair)(u);
        let r = q.corner + along_a(u.x) * q.a + along_b(u.y) * q.b - from;
        let within = Interval::new(how.begin, (how.end)(r.length()));
        let is_hidden = || balls.iter().any(|ball| (how.blocks)(ball, from, r, within));
        if r.dot(normal) < 0.0 && !is_hidden() {
            (how.weight)(r, normal)
        } else {
            0.0
        }
    };
    let of_point = |p: &Vec3| lattice(how.n).map(|u| count(*p, u)).collect();
    q.points.iter().map(of_point).collect()
}

/// The solid angle for which each place of the lattice stands at a point, as a multiple of their mean.
pub(super) fn solid_angles(q: &VisibleFraction, from: Vec3) -> Vec<f64> {
    let area = q.a.cross(q.b);
    let solid_angle = |u: Vec2| {
        let r = q.corner + u.x * q.a + u.y * q.b - from;
        f64::from((-r.dot(area)).max(0.0) / r.length().powi(3))
    };
    let angles: Vec<_> = lattice(FINE).map(solid_angle).collect();
    let sum = angles.iter().sum::<f64>().max(f64::MIN_POSITIVE);
    let count = angles.len() as f64;
    angles.iter().map(|angle| angle * count / sum).collect()
}
