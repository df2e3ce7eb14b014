//! Fractions of a light that are seen, as students misread the question: each ball alone, balls of other radii, the light's other side.

use crate::Graded;
use raybook_workbook::exercises::ch16_soft_shadows::{Ball, VisibleFraction};

/// The fractions made of what each point sees past no ball, and past each of the balls alone.
pub(super) fn past_each(q: &VisibleFraction, made: fn(f32, &[f32]) -> f32) -> Vec<f32> {
    let past = |balls: &[Ball]| VisibleFraction::misread(q, |q| q.balls = balls.to_vec());
    let alone: Vec<_> = q.balls.chunks(1).map(past).collect();
    let of_point = |(i, free)| {
        let alone: Vec<f32> = alone.iter().map(|fractions| fractions[i]).collect();
        made(free, &alone)
    };
    past(&[]).into_iter().enumerate().map(of_point).collect()
}

/// A fraction less what each ball alone would hide of it.
pub(super) fn less_each(free: f32, alone: &[f32]) -> f32 {
    free - alone.iter().map(|one| free - one).sum::<f32>()
}

/// The answer for balls of other radii.
pub(super) fn by_balls(q: &VisibleFraction, radius: fn(f32) -> f32) -> Vec<f32> {
    VisibleFraction::misread(q, |q| {
        for ball in &mut q.balls {
            ball.radius = radius(ball.radius);
        }
    })
}

/// The question of the same light, which shines to the other side.
pub(super) fn turned(q: &VisibleFraction) -> VisibleFraction {
    VisibleFraction {
        corner: q.corner + q.a,
        a: -q.a,
        ..q.clone()
    }
}
