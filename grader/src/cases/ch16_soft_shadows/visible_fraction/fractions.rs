//! Fractions of a light that are seen, by the points of a lattice on it: rightly, and as students mistake them.

use crate::cases::ch16_soft_shadows::lattice;
use glam::{Vec2, Vec3};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, sphere::Sphere};
use raybook_workbook::exercises::ch16_soft_shadows::VisibleFraction;

/// Points along each side of a lattice that stands for the whole light.
pub(super) const FINE: u32 = 32;

/// The fractions, by a lattice fine enough to stand for the exact value.
pub(super) fn exact(q: &VisibleFraction) -> Vec<f32> {
    seen(q, FINE, |u| u, [0.0, 1.0])
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
    seen(&scaled, FINE, reaching, [0.0, 1.0])[0]
}

/// The fractions by the points of the light to which an n × n lattice is mapped, and by rays that begin and end at `ends`
/// times the distance of the light.
pub(super) fn seen(
    q: &VisibleFraction,
    n: u32,
    place: fn(Vec2) -> Vec2,
    ends: [f32; 2],
) -> Vec<f32> {
    seen_past(q, n, place, between(ends))
}

/// Whether a ball blocks the way from a point along a vector that ends at the light, between `ends` times its length.
pub(super) fn between(ends: [f32; 2]) -> impl Fn(&Sphere, Vec3, Vec3) -> bool {
    move |ball, from, r| {
        let [begin, end] = ends.map(|end| end * r.length());
        let way = Interval::new(begin, end);
        Dir3::new(r).is_none_or(|d| ball.blocks(&Ray::new(from, d), way))
    }
}

/// The fractions by the points of the light to which an n × n lattice is mapped, and by whether a ball blocks the way from a
/// point along a vector that ends at the light.
pub(super) fn seen_past(
    q: &VisibleFraction,
    n: u32,
    place: fn(Vec2) -> Vec2,
    blocks: impl Fn(&Sphere, Vec3, Vec3) -> bool,
) -> Vec<f32> {
    let share = |seen: Vec<bool>| {
        let count = seen.iter().filter(|seen| **seen).count();
        count as f32 / (n * n) as f32
    };
    seen_at(q, n, place, blocks)
        .into_iter()
        .map(share)
        .collect()
}

/// The fractions by a lattice of which each place that is seen counts by its cosine at the light.
pub(super) fn by_cosine(q: &VisibleFraction) -> Vec<f32> {
    let normal = q.a.cross(q.b).normalize_or_zero();
    let of_point = |(from, seen): (&Vec3, Vec<bool>)| {
        let cosine = |u: Vec2| {
            let r = q.corner + u.x * q.a + u.y * q.b - *from;
            -r.normalize_or_zero().dot(normal)
        };
        let places = lattice(FINE).zip(seen).filter(|(_, seen)| *seen);
        let sum: f32 = places.map(|(u, _)| cosine(u)).sum();
        sum / (FINE * FINE) as f32
    };
    q.points.iter().zip(seen_places(q)).map(of_point).collect()
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

/// The fractions by a lattice of n × n places, where n is the root of the number of samples, rounded to a whole number, if the places that are
/// seen are divided by the number of samples itself.
pub(super) fn of_a_lattice(q: &VisibleFraction, round: fn(f32) -> f32) -> Vec<f32> {
    let samples = q.samples as f32;
    let share = round(samples.sqrt()).powi(2) / samples;
    exact(q).iter().map(|f| f * share).collect()
}

/// Of each point, which places it sees of the lattice that stands for the whole light.
pub(super) fn seen_places(q: &VisibleFraction) -> Vec<Vec<bool>> {
    seen_at(q, FINE, |u| u, between([0.0, 1.0]))
}

/// Of each point, which places it sees of those to which an n × n lattice is mapped.
fn seen_at(
    q: &VisibleFraction,
    n: u32,
    place: fn(Vec2) -> Vec2,
    blocks: impl Fn(&Sphere, Vec3, Vec3) -> bool,
) -> Vec<Vec<bool>> {
    let balls: Vec<_> = q
        .balls
        .iter()
        .map(|b| Sphere::new(b.center, b.radius))
        .collect();
    let arrives = |from: Vec3, u: Vec2| {
        let r = q.corner + u.x * q.a + u.y * q.b - from;
        r.dot(q.a.cross(q.b)) < 0.0 && !balls.iter().any(|ball| blocks(ball, from, r))
    };
    let seen = |p: &Vec3| lattice(n).map(|u| arrives(*p, place(u))).collect();
    q.points.iter().map(seen).collect()
}
