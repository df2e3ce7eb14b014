//! The race of the three ways to hit a triangle.

use super::race;
use crate::kit::{
    bars::{Bars, bars},
    figure::Figure,
};
use glam::vec3;
use rand::RngExt;
use raybook::math::{dir3::Dir3, interval::Interval, pcg, pcg::Pcg, ray::Ray};
use raybook::shape::{Hit, Shape, triangle::Triangle, triangle_by_determinants, triangle_by_plane};

/// A triangle and a ray.
pub type Question = (Triangle, Ray);

/// A way to answer.
pub type Way = fn(&Question) -> Option<Hit>;

/// The contestants: each hits the triangle in its own way.
pub const WAYS: [(&str, Way); 3] = [
    ("plane, then inside", |(triangle, ray)| {
        triangle_by_plane::hit(triangle, ray, Interval::AHEAD)
    }),
    ("Cramer's rule", |(triangle, ray)| {
        triangle_by_determinants::hit(triangle, ray, Interval::AHEAD)
    }),
    ("Möller and Trumbore", |(triangle, ray)| {
        triangle.hit(ray, Interval::AHEAD)
    }),
];

/// `count` random triangles, and for each a ray that hits it with a probability of ½.
pub fn questions(count: usize, rng: &mut Pcg) -> Vec<Question> {
    let mut vector = || {
        let mut x = || 2.0 * rng.random::<f32>() - 1.0;
        vec3(x(), x(), x())
    };
    let mut question = || {
        let [p0, p1, p2, origin, b] = [(); 5].map(|()| vector());
        let triangle = Triangle::new(p0, p1, p2);
        // In the parallelogram of e₁ and e₂, of which the triangle is one half.
        let target = p0 + b.x.abs() * triangle.e1 + b.y.abs() * triangle.e2;
        Some((
            triangle,
            Ray::new(3.0 * origin, Dir3::new(target - 3.0 * origin)?),
        ))
    };
    std::iter::repeat_with(&mut question)
        .flatten()
        .take(count)
        .collect()
}

/// Runs the race and draws its outcome.
///
/// # Errors
/// What plotters reports.
pub fn figure() -> Figure {
    let questions = questions(10_000, &mut pcg::stream(6, 0));
    let times = race::nanoseconds(&questions, &WAYS.map(|way| way.1));
    let rows: Vec<_> = WAYS.iter().map(|way| way.0).zip(times).collect();
    let answers: Vec<_> = questions
        .iter()
        .map(|question| WAYS.map(|way| way.1(question)))
        .collect();
    let hits = answers.iter().filter(|[a, ..]| a.is_some()).count();
    let same = answers
        .iter()
        .filter(|[a, b, c]| same(*a, *b) && same(*a, *c))
        .count();
    let note = format!(
        "{same} of {} answers agree, {hits} of them hits",
        questions.len()
    );
    bars(&[Bars {
        title: "Time to test a ray against a triangle, measured in this run",
        unit: "ns",
        rows: &rows,
        note: &note,
    }])
}

/// The share of rays that seem to hit a triangle without area, if the determinant is not compared with its rounding errors. The
/// triangle has e₁ = e₂, and each ray is aimed at this side.
pub fn false_hits() -> f64 {
    let questions = questions(100_000, &mut pcg::stream(6, 1));
    let mut along = pcg::stream(6, 2);
    let is_hit = |(triangle, ray): &&Question| {
        let (p0, e1, e2) = (triangle.p0, triangle.e1, triangle.e1);
        let target = p0 + along.random::<f32>() * e1;
        let Some(direction) = Dir3::new(target - ray.origin) else {
            return false;
        };
        let (s1, s) = (direction.cross(e2), ray.origin - p0);
        let (s2, determinant) = (s.cross(e1), s1.dot(e1));
        let t = s2.dot(e2) / determinant;
        let b1 = s1.dot(s) / determinant;
        let b2 = s2.dot(*direction) / determinant;
        b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0 && Interval::AHEAD.contains(t)
    };
    let hits = questions.iter().filter(is_hit);
    hits.count() as f64 / questions.len() as f64
}

/// Whether two answers are the same, but for rounding.
fn same(a: Option<Hit>, b: Option<Hit>) -> bool {
    /// Relative: a triangle that the ray grazes loses a few digits.
    const TOLERANCE: f32 = 1e-3;
    match (a, b) {
        (Some(a), Some(b)) => (a.t - b.t).abs() <= TOLERANCE * a.t,
        (None, None) => true,
        _ => false,
    }
}
