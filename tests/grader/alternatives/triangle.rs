//! Chapter 6: methods that find t, b₁ and b₂ of a triangle, without the interval.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DMat3, DVec3, Vec3};

pub type Corners = [DVec3; 3];

/// t, b₁ and b₂ where the line o + t·d meets the triangle.
pub type Method = fn(o: DVec3, d: DVec3, corners: Corners) -> Option<[f64; 3]>;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "triangle_hit",
        method: "the plane first, then the three edges, in f64",
        answer: |q| hit(q, plane_then_inside),
    },
    Alternative {
        exercise: "triangle_hit",
        method: "Cramer's rule, in f32 (Möller and Trumbore 1997)",
        answer: |q| hit(q, by_determinants),
    },
    Alternative {
        exercise: "triangle_hit",
        method: "the volumes of tetrahedra, in f64",
        answer: |q| hit(q, volumes),
    },
    Alternative {
        exercise: "triangle_hit",
        method: "Plücker coordinates, in f64",
        answer: |q| hit(q, pluecker),
    },
    Alternative {
        exercise: "triangle_hit",
        method: "a linear system, by the inverse matrix in f64",
        answer: |q| hit(q, linear_system),
    },
    Alternative {
        exercise: "triangle_hit",
        method: "watertight, in f32 (Woop, Benthin and Wald 2013)",
        answer: |q| hit(q, watertight),
    },
    Alternative {
        exercise: "triangle_normal",
        method: "from the edges at the third corner, in f64",
        answer: |q| normal(q, |[p0, p1, p2]| (p0 - p2).cross(p1 - p2)),
    },
    Alternative {
        exercise: "triangle_normal",
        method: "from the edges at the second corner, in f32",
        answer: |q| {
            normal(q, |corners| {
                let [p0, p1, p2] = corners.map(DVec3::as_vec3);
                (p2 - p1).cross(p0 - p1).as_dvec3()
            })
        },
    },
    Alternative {
        exercise: "triangle_normal",
        method: "by Newell's sums, in f64",
        answer: |q| normal(q, newell),
    },
];

/// Twice the area, as a vector along the normal (Newell; Sutherland, Sproull and Schumacker 1974).
pub fn newell(corners: Corners) -> DVec3 {
    let sides = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (corners[i], corners[j]));
    let side = |(a, b): (DVec3, DVec3)| {
        DVec3::new(
            (a.y - b.y) * (a.z + b.z),
            (a.z - b.z) * (a.x + b.x),
            (a.x - b.x) * (a.y + b.y),
        )
    };
    sides.into_iter().map(side).sum()
}

fn hit(q: &mut Question, method: Method) -> Answer {
    let (ray, corners) = (q.ray(), [(); 3].map(|()| q.vector()));
    let answer = method(ray.o, ray.d, corners)?;
    ray.counts(answer[0]).then(|| answer.to_vec())
}

fn normal(q: &mut Question, twice_area: fn(Corners) -> DVec3) -> Answer {
    let n = twice_area([(); 3].map(|()| q.vector()));
    (n.length() > 0.0).then(|| n.normalize().to_array().to_vec())
}

pub fn plane_then_inside(o: DVec3, d: DVec3, [p0, p1, p2]: Corners) -> Option<[f64; 3]> {
    let n = (p1 - p0).cross(p2 - p0);
    if n.dot(d) == 0.0 {
        return None;
    }
    let t = n.dot(p0 - o) / n.dot(d);
    let p = o + t * d;
    // Each edge's part of the area, twice and signed.
    let parts = [(p1, p2), (p2, p0), (p0, p1)].map(|(a, b)| (b - a).cross(p - a).dot(n));
    let inside = parts.iter().all(|&part| part >= 0.0);
    inside.then(|| [t, parts[1] / n.dot(n), parts[2] / n.dot(n)])
}

pub fn volumes(o: DVec3, d: DVec3, [p0, p1, p2]: Corners) -> Option<[f64; 3]> {
    let volume = |a: DVec3, b: DVec3, c: DVec3, d: DVec3| (b - a).cross(c - a).dot(d - a);
    let [v0, v1, v2] = [(p1, p2), (p2, p0), (p0, p1)].map(|(a, b)| volume(o, o + d, a, b));
    let same_side = v0 >= 0.0 && v1 >= 0.0 && v2 >= 0.0 || v0 <= 0.0 && v1 <= 0.0 && v2 <= 0.0;
    let all = v0 + v1 + v2;
    let [start, end] = [o, o + d].map(|p| volume(p0, p1, p2, p));
    (same_side && all != 0.0).then(|| [start / (start - end), v1 / all, v2 / all])
}

fn pluecker(o: DVec3, d: DVec3, corners: Corners) -> Option<[f64; 3]> {
    let line = |a: DVec3, along: DVec3| (along, a.cross(along));
    let side = |(d1, m1): (DVec3, DVec3), (d2, m2): (DVec3, DVec3)| d1.dot(m2) + d2.dot(m1);
    let ray = line(o, d);
    let [s0, s1, s2] =
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| side(ray, line(corners[i], corners[j] - corners[i])));
    let all = s0 + s1 + s2;
    let [b0, b1, b2] = [s0, s1, s2].map(|s| s / all);
    if all == 0.0 || b0 < 0.0 || b1 < 0.0 || b2 < 0.0 {
        return None;
    }
    let p = b0 * corners[0] + b1 * corners[1] + b2 * corners[2];
    Some([(p - o).dot(d) / d.dot(d), b1, b2])
}

fn by_determinants(o: DVec3, d: DVec3, corners: Corners) -> Option<[f64; 3]> {
    let [o, d, p0, p1, p2] = [o, d, corners[0], corners[1], corners[2]].map(DVec3::as_vec3);
    let (a, b, from) = (p1 - p0, p2 - p0, o - p0);
    let (p, q) = (d.cross(b), from.cross(a));
    let whole = a.dot(p);
    let [t, b1, b2] = [b.dot(q), from.dot(p), d.dot(q)].map(|part| part / whole);
    let inside = whole != 0.0 && b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
    inside.then(|| [t, b1, b2].map(f64::from))
}

fn linear_system(o: DVec3, d: DVec3, [p0, p1, p2]: Corners) -> Option<[f64; 3]> {
    let matrix = DMat3::from_cols(-d, p1 - p0, p2 - p0);
    if matrix.determinant() == 0.0 {
        return None; // numpy: LinAlgError, singular matrix
    }
    let [t, b1, b2] = (matrix.inverse() * (o - p0)).to_array();
    (b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0).then_some([t, b1, b2])
}

pub fn watertight(o: DVec3, d: DVec3, corners: Corners) -> Option<[f64; 3]> {
    let (o, d) = (o.as_vec3(), d.as_vec3());
    // The ray becomes the axis z, its largest; the others in order, so that the triangle is not mirrored.
    let z = d.abs().max_position();
    let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
    if d[z] < 0.0 {
        (x, y) = (y, x);
    }
    let [a, b, c] = corners.map(|p| {
        let p = p.as_vec3() - o;
        Vec3::new(
            p[x] - d[x] / d[z] * p[z],
            p[y] - d[y] / d[z] * p[z],
            p[z] / d[z],
        )
    });
    let area = |p: Vec3, q: Vec3| f64::from(p.x) * f64::from(q.y) - f64::from(p.y) * f64::from(q.x);
    let (u, v, w) = (area(c, b), area(a, c), area(b, a));
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return None;
    }
    let all = u + v + w;
    let t = (u * f64::from(a.z) + v * f64::from(b.z) + w * f64::from(c.z)) / all;
    (all != 0.0).then(|| [t, v / all, w / all])
}
