//! Chapter 15: the way to a light.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::DVec3;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "shadow_ray",
        method: "two bounds off the surface, and three before the light",
        answer: |q| {
            let at = Point::read(q);
            let side = at.normal.dot(at.toward).signum() * at.normal;
            way(
                at.position + 2.0 * at.error * side,
                at.toward,
                0.0,
                at.distance - 3.0 * at.error,
            )
        },
    },
    Alternative {
        exercise: "shadow_ray",
        method: "from the point, but counted from where the ray is clear of the surface",
        answer: |q| {
            let at = Point::read(q);
            let step = at.error * at.normal.abs().element_sum();
            let clear = 1.01 * step / at.normal.dot(at.toward).abs();
            way(at.position, at.toward, clear, at.distance - 0.1 * at.error)
        },
    },
    Alternative {
        exercise: "shadow_ray",
        method: "aimed anew at the lamp, from where the ray starts",
        answer: |q| {
            let at = Point::read(q);
            let origin = at.leave();
            if at.distance.is_infinite() {
                return way(origin, at.toward, 0.0, at.distance);
            }
            let to_lamp = at.position + at.distance * at.toward - origin;
            way(
                origin,
                to_lamp.normalize(),
                0.0,
                to_lamp.length() - 0.1 * at.error,
            )
        },
    },
    Alternative {
        exercise: "lit",
        method: "how near the way comes to each centre, in f64",
        answer: |q| {
            let at = Point::read(q);
            let from = at.leave();
            let blocked = at.balls.iter().any(|(center, radius)| {
                let along = (center - from)
                    .dot(at.toward)
                    .clamp(0.0, at.distance - at.error);
                (from + along * at.toward).distance(*center) < *radius
            });
            Some(vec![f64::from(u8::from(!blocked))])
        },
    },
    Alternative {
        exercise: "lit",
        method: "by the schoolbook's quadratic formula, in f64",
        answer: |q| {
            let at = Point::read(q);
            let from = at.leave();
            let blocked = at.balls.iter().any(|(center, radius)| {
                let b = 2.0 * (from - center).dot(at.toward);
                let c = (from - center).length_squared() - radius * radius;
                let root = (b * b - 4.0 * c).sqrt();
                let counts = |t: f64| t > 0.0 && t < at.distance;
                counts(0.5 * (-b - root)) || counts(0.5 * (-b + root))
            });
            Some(vec![f64::from(u8::from(!blocked))])
        },
    },
];

fn way(origin: DVec3, direction: DVec3, min: f64, max: f64) -> Answer {
    Some([&origin.to_array()[..], &direction.to_array(), &[min, max]].concat())
}

/// A point, a light, and what may be in the way.
struct Point {
    position: DVec3,
    error: f64,
    normal: DVec3,
    toward: DVec3,
    distance: f64,
    balls: Vec<(DVec3, f64)>,
}

impl Point {
    /// The list of balls is there for `lit` only.
    fn read(q: &mut Question) -> Self {
        Self {
            position: q.vector(),
            error: q.number(),
            normal: q.vector(),
            toward: q.vector(),
            distance: q.number(),
            balls: if q.is_empty() {
                Vec::new()
            } else {
                q.list(|q| (q.vector(), q.number()))
            },
        }
    }

    /// A start that is clear of the surface.
    fn leave(&self) -> DVec3 {
        let side = self.normal.dot(self.toward).signum() * self.normal;
        self.position + 1.8 * self.error * side
    }
}
