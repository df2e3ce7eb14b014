//! Three ways, and a fourth in `f64`, to the same answers.

use crate::ch06_triangle::{ray, vector};
use glam::{DVec3, Vec3, dvec2};
use raybook::math::pcg;
use raybook::shape::{Hit, triangle::Triangle};
use raybook_chapters::ch06_triangle::platonic;
use raybook_chapters::ch06_triangle::{
    triangle_race::Question, triangle_race::WAYS, triangle_race::questions,
};

/// (t, b₁, b₂) in `f64` by Cramer's rule, whatever their signs; and the determinant.
fn reference((triangle, ray): &Question) -> ([f64; 3], f64) {
    let (e1, e2) = (triangle.e1.as_dvec3(), triangle.e2.as_dvec3());
    let (d, s) = (
        ray.direction.as_dvec3(),
        ray.origin.as_dvec3() - triangle.p0.as_dvec3(),
    );
    let det = |a: DVec3, b: DVec3, c: DVec3| a.cross(b).dot(c);
    let all = det(-d, e1, e2);
    (
        [
            det(s, e1, e2) / all,
            det(-d, s, e2) / all,
            det(-d, e1, s) / all,
        ],
        all,
    )
}

#[test]
fn three_ways_and_f64_agree() {
    let questions = questions(200_000, &mut pcg::stream(6, 1));
    let (mut hits, mut otherwise) = (0, 0);
    for question in &questions {
        let ([t, b1, b2], determinant) = reference(question);
        let (triangle, ray) = question;
        let lengths = [ray.origin - triangle.p0, triangle.e1, triangle.e2].map(Vec3::length);
        let longest = f64::from(lengths.into_iter().fold(0.0, f32::max));
        // A quotient's error: the sizes of its products over the determinant, times a few roundings. The way by the plane
        // finds b from the point, which the error of t displaces. At most half of these bounds was seen.
        let epsilon = 4.0 * f64::from(f32::EPSILON);
        let t_error = epsilon * longest.powi(3) / determinant.abs();
        let area = f64::from(triangle.e1.cross(triangle.e2).length());
        let b_error = epsilon * longest.powi(2) / determinant.abs() + t_error * longest / area;
        let margin = b1.min(b2).min(1.0 - b1 - b2);
        let expected = margin > 0.0 && t > 0.0;
        hits += usize::from(expected);
        for (name, way) in WAYS {
            let hit = way(question);
            if hit.is_some() != expected {
                let near_an_edge = margin.abs() <= 2.0 * b_error || t.abs() <= t_error;
                assert!(
                    near_an_edge,
                    "{name}: {hit:?}, but t = {t}, b = ({b1}, {b2}) in f64"
                );
                otherwise += 1;
            }
            if let Some(Hit { t: found, uv, .. }) = hit {
                let off = (f64::from(found) - t).abs();
                assert!(
                    off <= t_error,
                    "{name}: t is {found}, {t} in f64, {t_error} is allowed"
                );
                let off = uv.as_dvec2().distance(dvec2(b1, b2));
                assert!(
                    off <= b_error,
                    "{name}: b is {off} off, {b_error} is allowed"
                );
            }
        }
    }
    assert!(
        (90_000..110_000).contains(&hits),
        "about half of the rays hit, not {hits}"
    );
    assert!(
        otherwise <= 20,
        "{otherwise} of 600000 answers differ near an edge"
    );
}

/// The triangles are not watertight: none of the three ways computes a shared edge once for both of its triangles.
/// But the gaps are as narrow as rounding is.
#[test]
fn hardly_any_ray_slips_between_the_triangles_of_a_closed_solid() {
    let faces: Vec<Triangle> = platonic::icosahedron(1.0, Vec3::ONE, 0.4);
    assert_eq!(faces.len(), 20, "an icosahedron has 20 faces");
    let mut rng = pcg::stream(6, 2);
    let mut odd = [0; 3];
    for _ in 0..100_000 {
        // Every ray passes through the ball that touches the faces from inside, whose radius is 0.79.
        let inside = Vec3::ONE + 0.45 * vector(&mut rng);
        let away = vector(&mut rng).normalize();
        let ray = ray(inside + 3.0 * away, -away);
        for (odd, (_, way)) in odd.iter_mut().zip(WAYS) {
            let crossings = faces.iter().filter(|face| way(&(**face, ray)).is_some());
            *odd += usize::from(crossings.count() != 2);
        }
    }
    assert!(
        odd.iter().all(|&n| n <= 2),
        "{odd:?} of 100000 rays do not go in once and out once"
    );
}
