//! Chapter 3: quadratic equations and spheres.

use crate::alternatives::student::{Alternative, Answer, Question, Ray};
use glam::DVec3;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "solve_quadratic",
        method: "the schoolbook's formula in f64",
        answer: |q| {
            let (a, b, root) = discriminant(q)?;
            sorted((-b - root) / (2.0 * a), (-b + root) / (2.0 * a))
        },
    },
    Alternative {
        exercise: "solve_quadratic",
        method: "by completing the square, in f64",
        answer: |q| {
            let (a, b, root) = discriminant(q)?;
            let (middle, half) = (-b / (2.0 * a), (root / (2.0 * a)).abs());
            sorted(middle - half, middle + half)
        },
    },
    Alternative {
        exercise: "solve_quadratic",
        method: "2c over the schoolbook's other root, where that is larger",
        answer: |q| {
            let (a, b, c) = (q.number(), q.number(), q.number());
            let root = real(a, b, c)?;
            if b > 0.0 {
                sorted((-b - root) / (2.0 * a), 2.0 * c / (-b - root))
            } else if b < 0.0 {
                sorted((-b + root) / (2.0 * a), 2.0 * c / (-b + root))
            } else {
                sorted(-root / (2.0 * a), root / (2.0 * a))
            }
        },
    },
    Alternative {
        exercise: "solve_quadratic",
        method: "by Vieta's product, in f32",
        answer: |q| {
            let [a, b, c] = [(); 3].map(|()| q.number() as f32);
            let d = b * b - 4.0 * a * c;
            if a == 0.0 || d < 0.0 {
                return None;
            }
            let sign = if b < 0.0 { -1.0 } else { 1.0 };
            let large = (-b - sign * d.sqrt()) / (2.0 * a);
            let small = if large == 0.0 { 0.0 } else { c / a / large };
            sorted(f64::from(large), f64::from(small))
        },
    },
    Alternative {
        exercise: "sphere_hit",
        method: "the schoolbook's quadratic in f64",
        answer: |q| {
            let (ray, center, r) = sphere(q);
            let from = ray.o - center;
            let (a, b, c) = (
                ray.d.dot(ray.d),
                2.0 * from.dot(ray.d),
                from.dot(from) - r * r,
            );
            let root = real(a, b, c)?;
            ray.first(&[(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)])
        },
    },
    Alternative {
        exercise: "sphere_hit",
        method: "the centre's distance from the line, and Pythagoras, in f64",
        answer: |q| {
            let (ray, center, r) = sphere(q);
            let to = center - ray.o;
            let along = to.dot(ray.d);
            let off = (to - along * ray.d).length();
            let half = (off <= r).then(|| (r * r - off * off).sqrt())?;
            ray.first(&[along - half, along + half])
        },
    },
    Alternative {
        exercise: "sphere_hit",
        method: "in f32, by the length of a cross product",
        answer: |q| {
            let (ray, center, r) = sphere(q);
            let (to, d, r) = ((center - ray.o).as_vec3(), ray.d.as_vec3(), r as f32);
            let off = to.cross(d).length();
            let half = (off <= r).then(|| ((r - off) * (r + off)).sqrt())?;
            ray.first(&[to.dot(d) - half, to.dot(d) + half].map(f64::from))
        },
    },
    Alternative {
        exercise: "sphere_hit",
        method: "in f32, from a start that is moved close to the sphere",
        answer: |q| {
            let (ray, center, r) = sphere(q);
            let (o, d, c) = (ray.o.as_vec3(), ray.d.as_vec3(), center.as_vec3());
            let r = r as f32;
            let skipped = ((c - o).length() - 2.0 * r).max(0.0);
            let from = o + skipped * d - c;
            let b = from.dot(d);
            let root = b * b - (from.length_squared() - r * r);
            if root < 0.0 {
                return None;
            }
            ray.first(&[skipped - b - root.sqrt(), skipped - b + root.sqrt()].map(f64::from))
        },
    },
    Alternative {
        exercise: "sphere_normal",
        method: "normalised in f64",
        answer: |q| normal(q, |from_center, _| from_center.normalize()),
    },
    Alternative {
        exercise: "sphere_normal",
        method: "divided by the radius in f64",
        answer: |q| normal(q, |from_center, r| from_center / r),
    },
    Alternative {
        exercise: "sphere_normal",
        method: "the gradient of |p - c|² in f32",
        answer: |q| {
            normal(q, |from_center, _| {
                (2.0 * from_center.as_vec3()).normalize().as_dvec3()
            })
        },
    },
];

fn sphere(q: &mut Question) -> (Ray, DVec3, f64) {
    (q.ray(), q.vector(), q.number())
}

fn normal(q: &mut Question, of: fn(DVec3, f64) -> DVec3) -> Answer {
    let (center, r, p) = (q.vector(), q.number(), q.vector());
    Some(of(p - center, r).to_array().to_vec())
}

/// a, b and √(b² − 4ac), where that is real.
fn discriminant(q: &mut Question) -> Option<(f64, f64, f64)> {
    let (a, b, c) = (q.number(), q.number(), q.number());
    Some((a, b, real(a, b, c)?))
}

fn real(a: f64, b: f64, c: f64) -> Option<f64> {
    let d = b * b - 4.0 * a * c;
    (a != 0.0 && d >= 0.0).then(|| d.sqrt())
}

fn sorted(t0: f64, t1: f64) -> Answer {
    Some(if t0 < t1 { vec![t0, t1] } else { vec![t1, t0] })
}
