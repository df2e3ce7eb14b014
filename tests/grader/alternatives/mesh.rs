//! Chapter 7: attributes and lists of triangles.

use crate::alternatives::student::{Alternative, Answer, Question, Ray};
use crate::alternatives::triangle::{Corners, newell, plane_then_inside, volumes, watertight};
use glam::{DVec2, DVec3};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "interpolate_normal",
        method: "along the far side, then towards it, in f64",
        answer: |q| {
            let (corners, b) = ([(); 3].map(|()| q.vector()), q.pair());
            let (side, inward) = nested(b);
            let far = corners[1].lerp(corners[2], side);
            vector(corners[0].lerp(far, inward).normalize())
        },
    },
    Alternative {
        exercise: "interpolate_normal",
        method: "the first and two differences, in f32",
        answer: |q| {
            let [n0, n1, n2] = [(); 3].map(|()| q.vector().as_vec3());
            let b = q.pair().as_vec2();
            vector(
                (n0 + b.x * (n1 - n0) + b.y * (n2 - n0))
                    .normalize()
                    .as_dvec3(),
            )
        },
    },
    Alternative {
        exercise: "interpolate_texture",
        method: "along the far side, then towards it, in f64",
        answer: |q| {
            let (corners, b) = ([(); 3].map(|()| q.pair()), q.pair());
            let (side, inward) = nested(b);
            let far = corners[1].lerp(corners[2], side);
            Some(corners[0].lerp(far, inward).to_array().to_vec())
        },
    },
    Alternative {
        exercise: "interpolate_texture",
        method: "the first and two differences, in f32",
        answer: |q| {
            let [t0, t1, t2] = [(); 3].map(|()| q.pair().as_vec2());
            let b = q.pair().as_vec2();
            let texture = t0 + b.x * (t1 - t0) + b.y * (t2 - t0);
            Some(texture.as_dvec2().to_array().to_vec())
        },
    },
    Alternative {
        exercise: "vertex_normals",
        method: "unit normals times areas, in f64",
        answer: |q| {
            vertex_normals(q, |[p0, p1, p2]| {
                let n = (p1 - p0).cross(p2 - p0);
                let area = n.length() / 2.0;
                if area > 0.0 {
                    area * n.normalize()
                } else {
                    DVec3::ZERO
                }
            })
        },
    },
    Alternative {
        exercise: "vertex_normals",
        method: "by Newell's sums, in f64",
        answer: |q| vertex_normals(q, newell),
    },
    Alternative {
        exercise: "vertex_normals",
        method: "from the edges at the third corner, in f32",
        answer: |q| {
            vertex_normals(q, |corners| {
                let [p0, p1, p2] = corners.map(DVec3::as_vec3);
                (p0 - p2).cross(p1 - p2).as_dvec3()
            })
        },
    },
    Alternative {
        exercise: "mesh_hit",
        method: "all hits, then the least, in f64",
        answer: |q| {
            let (ray, triangles) = mesh(q);
            let hits = (0..triangles.len()).filter_map(|id| {
                let [t, ..] = plane_then_inside(ray.o, ray.d, triangles[id])?;
                ray.counts(t).then_some((t, id))
            });
            found(hits.min_by(|a, b| a.0.total_cmp(&b.0)))
        },
    },
    Alternative {
        exercise: "mesh_hit",
        method: "all hits of the line, sorted, then the first that counts, in f64",
        answer: |q| {
            let (ray, triangles) = mesh(q);
            let mut hits: Vec<_> = (0..triangles.len())
                .filter_map(|id| Some((volumes(ray.o, ray.d, triangles[id])?[0], id)))
                .collect();
            hits.sort_by(|a, b| a.0.total_cmp(&b.0));
            found(hits.into_iter().find(|&(t, _)| ray.counts(t)))
        },
    },
    Alternative {
        exercise: "mesh_hit",
        method: "from the end of the list, the last of equals staying, in f32",
        answer: |q| {
            let (mut ray, triangles) = mesh(q);
            let mut nearest = None;
            for (id, &corners) in triangles.iter().enumerate().rev() {
                if let Some([t, ..]) =
                    watertight(ray.o, ray.d, corners).filter(|h| ray.counts(h[0]))
                {
                    ray.max = t;
                    nearest = Some((t, id));
                }
            }
            found(nearest)
        },
    },
];

fn vector(v: DVec3) -> Answer {
    Some(v.to_array().to_vec())
}

/// How far along the side from the second corner to the third, and how far from the first corner to there.
fn nested(b: DVec2) -> (f64, f64) {
    let inward = b.x + b.y;
    let side = if inward == 0.0 { 0.0 } else { b.y / inward };
    (side, inward)
}

fn mesh(q: &mut Question) -> (Ray, Vec<Corners>) {
    (q.ray(), q.list(|q| [(); 3].map(|()| q.vector())))
}

fn found(nearest: Option<(f64, usize)>) -> Answer {
    nearest.map(|(t, id)| vec![t, id as f64])
}

/// The number of normals, and the normals.
fn vertex_normals(q: &mut Question, weighted: fn(Corners) -> DVec3) -> Answer {
    let positions = q.list(Question::vector);
    let mut sums = vec![DVec3::ZERO; positions.len()];
    for corners in q.list(|q| [(); 3].map(|()| q.whole())) {
        let n = weighted(corners.map(|i| positions[i]));
        for i in corners {
            sums[i] += n;
        }
    }
    let mut numbers = vec![sums.len() as f64];
    numbers.extend(
        sums.iter()
            .flat_map(|sum| sum.try_normalize().unwrap_or(DVec3::Y).to_array()),
    );
    Some(numbers)
}
