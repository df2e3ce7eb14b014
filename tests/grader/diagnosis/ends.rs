//! What is made of the ends of an interval: one that is not asked, and a distance that is moved to one.

use super::function::diagnosed;
use glam::DVec3;

/// The numbers of vectors that begin at these places of a question.
fn vectors<const N: usize>(q: &[f64], from: [usize; N]) -> [DVec3; N] {
    from.map(|from| DVec3::from_slice(&q[from..]))
}

/// A distance as an answer, or none.
fn answer(t: Option<f64>) -> Vec<f64> {
    t.map_or(vec![0.0], |t| vec![1.0, t])
}

#[test]
fn an_end_that_is_not_asked_of_one_root_is_named() {
    let found = diagnosed("sphere_hit", |q| {
        let [o, d, center] = vectors(q, [0, 3, 8]);
        let s = (center - o).dot(d);
        let half = (q[11] * q[11] - (o + s * d - center).length_squared()).sqrt();
        let [near, far] = [s - half, s + half];
        let near = Some(near).filter(|t| q[6] < *t && *t < q[7]);
        Some(answer(near.or(Some(far).filter(|t| q[6] < *t))))
    });
    let told = "always goes on as if the larger root is smaller than max";
    assert_eq!(found.name, told);
}

/// The distance to a plane.
fn to_plane(q: &[f64]) -> f64 {
    let [o, d, n] = vectors(q, [0, 3, 8]);
    (q[11] - n.dot(o)) / n.dot(d)
}

#[test]
fn a_distance_that_is_moved_to_the_end_of_the_interval_is_named() {
    let found = diagnosed("plane_hit", |q| {
        let t = to_plane(q);
        Some(answer(Some(t.clamp(q[6], q[7])).filter(|_| t.is_finite())))
    });
    let told = "moves a distance outside of the interval to its end, where there is no answer";
    assert_eq!(found.name, told);
}

#[test]
fn who_answers_too_often_and_otherwise_than_a_mistake_is_not_told_it_for_certain() {
    let found = diagnosed("plane_hit", |q| {
        let t = to_plane(q);
        let counts = q[6] < t && t < q[7];
        let t = if counts { t } else { 20.0 + (9.0 * t).sin() };
        Some(answer(Some(t).filter(|t| t.is_finite())))
    });
    assert!(!found.certain, "{found:?}");
}
