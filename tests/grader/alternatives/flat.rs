//! Chapters 4 and 5: planes and boxes.

use crate::alternatives::student::{Alternative, Answer, Question, Ray};
use glam::DVec3;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "plane_hit",
        method: "in f64",
        answer: |q| {
            let (ray, n, offset) = plane(q);
            ray.first(&[(offset - n.dot(ray.o)) / n.dot(ray.d)])
        },
    },
    Alternative {
        exercise: "plane_hit",
        method: "by a point of the plane, in f32",
        answer: |q| {
            let (ray, n, offset) = plane(q);
            let (o, d, n) = (ray.o.as_vec3(), ray.d.as_vec3(), n.as_vec3());
            let (p0, toward) = (n * offset as f32, n.dot(d));
            if toward == 0.0 {
                return None;
            }
            ray.first(&[f64::from(n.dot(p0 - o) / toward)])
        },
    },
    Alternative {
        exercise: "plane_hit",
        method: "by how much closer a metre along the ray is, in f64",
        answer: |q| {
            let (ray, n, offset) = plane(q);
            let [here, there] = [ray.o, ray.o + ray.d].map(|p| n.dot(p) - offset);
            ray.first(&[here / (here - there)])
        },
    },
    Alternative {
        exercise: "box_clip",
        method: "three slabs in f64, axes without motion apart",
        answer: |q| {
            let (ray, low, high) = cuboid(q);
            let (mut enter, mut leave) = (ray.min, ray.max);
            for i in 0..3 {
                if ray.d[i] == 0.0 {
                    if ray.o[i] < low[i] || ray.o[i] > high[i] {
                        return None;
                    }
                } else {
                    let (a, b) = (
                        (low[i] - ray.o[i]) / ray.d[i],
                        (high[i] - ray.o[i]) / ray.d[i],
                    );
                    enter = enter.max(a.min(b));
                    leave = leave.min(a.max(b));
                }
            }
            between(enter, leave)
        },
    },
    Alternative {
        exercise: "box_clip",
        method: "face by face, and whether the ends are inside, in f64",
        answer: |q| {
            let (ray, low, high) = cuboid(q);
            let inside = |p: DVec3, without: Option<usize>| {
                (0..3).all(|i| Some(i) == without || low[i] <= p[i] && p[i] <= high[i])
            };
            let mut met: Vec<_> = [ray.min, ray.max]
                .into_iter()
                .filter(|t| t.is_finite() && inside(ray.o + *t * ray.d, None))
                .collect();
            for i in 0..3 {
                for face in [low[i], high[i]] {
                    let t = (face - ray.o[i]) / ray.d[i];
                    if ray.min <= t && t <= ray.max && inside(ray.o + t * ray.d, Some(i)) {
                        met.push(t);
                    }
                }
            }
            met.sort_by(f64::total_cmp);
            between(*met.first()?, *met.last()?)
        },
    },
    Alternative {
        exercise: "box_clip",
        method: "in f32, times the reciprocal, planes by the sign (Williams et al. 2005)",
        answer: |q| {
            let (ray, low, high) = cuboid(q);
            let (low, high) = (low.as_vec3(), high.as_vec3());
            let (mut enter, mut leave) = (ray.min as f32, ray.max as f32);
            for i in 0..3 {
                let (o, reciprocal) = (ray.o[i] as f32, 1.0 / ray.d[i] as f32);
                let planes = [low[i], high[i]].map(|plane| (plane - o) * reciprocal);
                let backwards = usize::from(reciprocal < 0.0);
                // f32::max and C's fmaxf drop a NaN.
                enter = enter.max(planes[backwards]);
                leave = leave.min(planes[1 - backwards]);
            }
            between(f64::from(enter), f64::from(leave))
        },
    },
    Alternative {
        exercise: "bounds_of",
        method: "by sorting each coordinate",
        answer: |q| {
            let points = q.list(Question::vector);
            let mut corners = [vec![], vec![]];
            for i in 0..3 {
                let mut sorted: Vec<_> = points.iter().map(|p| p[i]).collect();
                sorted.sort_by(f64::total_cmp);
                corners[0].push(*sorted.first().unwrap_or(&f64::INFINITY));
                corners[1].push(*sorted.last().unwrap_or(&f64::NEG_INFINITY));
            }
            Some(corners.concat())
        },
    },
    Alternative {
        exercise: "bounds_of",
        method: "by comparing, point by point",
        answer: |q| {
            let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
            for p in q.list(Question::vector) {
                for i in 0..3 {
                    if p[i] < bounds[0][i] {
                        bounds[0][i] = p[i];
                    }
                    if p[i] > bounds[1][i] {
                        bounds[1][i] = p[i];
                    }
                }
            }
            Some(bounds.concat())
        },
    },
];

fn plane(q: &mut Question) -> (Ray, DVec3, f64) {
    (q.ray(), q.vector(), q.number())
}

fn cuboid(q: &mut Question) -> (Ray, DVec3, DVec3) {
    (q.ray(), q.vector(), q.vector())
}

fn between(enter: f64, leave: f64) -> Answer {
    (enter <= leave).then(|| vec![enter, leave])
}
