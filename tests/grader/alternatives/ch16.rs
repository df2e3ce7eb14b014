//! Chapter 16: samples of lights, spread in other ways.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DVec2, DVec3, dvec2};
use raybook_grader::cases;
use raybook_grader::examine::visible_rng;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};
use std::sync::atomic::{AtomicU64, Ordering};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "sample_rect",
        method: "u.y along the first side, in f64",
        answer: |q| rect(q, |u| dvec2(u.y, u.x)),
    },
    Alternative {
        exercise: "sample_rect",
        method: "from the opposite corner",
        answer: |q| rect(q, |u| 1.0 - u),
    },
    Alternative {
        exercise: "sample_rect",
        method: "shifted, and wrapped round",
        answer: |q| rect(q, |u| (u + dvec2(0.3, 0.71)).fract()),
    },
    Alternative {
        exercise: "sample_sphere_light",
        method: "around the axis by u.x, in f64",
        answer: |q| sphere(q, |u| (u.y, TAU * u.x)),
    },
    Alternative {
        exercise: "sample_sphere_light",
        method: "the rim first, the other way round",
        answer: |q| sphere(q, |u| (1.0 - u.x, -TAU * u.y + 1.0)),
    },
    Alternative {
        exercise: "sample_sphere_light",
        method: "by a concentric disc (Shirley and Chiu 1997)",
        answer: |q| {
            sphere(q, |u| {
                let p = 2.0 * u - 1.0;
                let (r, phi) = if p.x.abs() > p.y.abs() {
                    (p.x, FRAC_PI_4 * p.y / p.x)
                } else {
                    (p.y, FRAC_PI_2 - FRAC_PI_4 * p.x / p.y)
                };
                (r * r, if r < 0.0 { phi + PI } else { phi })
            })
        },
    },
    Alternative {
        exercise: "visible_fraction",
        method: "stratified, in f64",
        answer: |q| {
            let mut state = 1_u64;
            visible(q, |i, n| {
                let side = f64::from(n).sqrt().floor() as u32;
                let cell = dvec2(f64::from(i % side), f64::from(i / side % side));
                (cell + dvec2(random(&mut state), random(&mut state))) / f64::from(side)
            })
        },
    },
    Alternative {
        exercise: "visible_fraction",
        method: "by random numbers that never come again",
        answer: by_new_numbers,
    },
    Alternative {
        exercise: "visible_fraction",
        method: "by other random numbers, in f64",
        answer: |q| {
            let mut state = 2024_u64;
            visible(q, |_, _| dvec2(random(&mut state), random(&mut state)))
        },
    },
];

/// Of 1024 samples, none, one or two meet its shadow, and all of the light is seen between the points of the judge's lattice.
#[test]
fn a_ball_that_hides_between_the_points_of_a_lattice_may_be_met_by_chance() {
    let examiner = cases::find("visible_fraction").expect("it exists");
    let judged = |radius: f64, seen: f64| {
        let text = format!("-1 4 -1  2 0 0  0 0 2  1  0 0 0  1  0 2 0 {radius}  1024");
        let question = examiner.asked().read_question(&text).expect("a question");
        examiner.compare(&question, &[1.0, 1.0], &[1.0, seen / 1024.0])
    };
    for seen in [1022.0, 1023.0, 1024.0] {
        assert_eq!(judged(0.015, seen), Ok(()), "{seen}");
    }
    assert!(judged(0.9, 1.0).is_err(), "the ball hides all of the light");
}

#[test]
fn a_radius_that_is_5_percent_wrong_is_noticed() {
    let examiner = cases::find("visible_fraction").expect("it exists");
    let asked = examiner.asked();
    let cases = examiner.cases(&mut visible_rng("visible_fraction")).cases;
    for scale in [0.95, 1.05] {
        let wrong = cases.iter().filter(|case| {
            let question = asked.read_question(&case.question).expect("a question");
            let golden = asked.read_answer(&case.answers[0]).expect("an answer");
            let mut scaled = question.clone();
            let balls = 11 + 3 * question[9] as usize..question.len() - 1;
            let radii = scaled[balls].chunks_exact_mut(4);
            radii.for_each(|ball| ball[3] *= scale);
            let got = (asked.call)(&scaled);
            examiner.compare(&question, &golden, &got).is_err()
        });
        let wrong = wrong.count();
        assert!(wrong >= 2, "{scale} times the radius: {wrong} are wrong");
    }
}

/// Knuth's linear congruential generator (MMIX).
fn random(state: &mut u64) -> f64 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

fn lattice(n: usize) -> impl Iterator<Item = DVec2> {
    (0..n * n).map(move |k| (dvec2((k % n) as f64, (k / n) as f64) + 0.5) / n as f64)
}

fn rect(q: &mut Question, place: fn(DVec2) -> DVec2) -> Answer {
    let [at, corner, a, b] = [(); 4].map(|()| q.vector());
    let (radiance, n) = (q.number(), q.whole());
    let normal = a.cross(b).normalize();
    if (at - corner).dot(normal) <= 0.0 {
        return None;
    }
    let mut answer = vec![(n * n) as f64];
    for u in lattice(n) {
        let p = place(u);
        let r = corner + p.x * a + p.y * b - at;
        let cosine = -r.normalize().dot(normal);
        let pdf = r.length_squared() / (a.length() * b.length() * cosine);
        answer.extend(r.normalize().to_array());
        answer.extend([r.length(), pdf, radiance / pdf]);
    }
    Some(answer)
}

/// `place` gives the share of 1 − cos θ, and φ.
fn sphere(q: &mut Question, place: fn(DVec2) -> (f64, f64)) -> Answer {
    let [at, center] = [(); 2].map(|()| q.vector());
    let (radius, radiance, n) = (q.number(), q.number(), q.whole());
    let (c, d) = (center - at, center.distance(at));
    let least = if d > radius {
        (1.0 - (radius / d).powi(2)).sqrt()
    } else {
        -1.0
    };
    let axis = c.normalize_or(DVec3::X);
    let x = axis.any_orthonormal_vector();
    let y = axis.cross(x);
    let pdf = 1.0 / (TAU * (1.0 - least));
    let mut answer = vec![(n * n) as f64];
    for u in lattice(n) {
        let (share, phi) = place(u);
        let cosine = 1.0 - share * (1.0 - least);
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let toward = sine * (phi.cos() * x + phi.sin() * y) + cosine * axis;
        let middle = c.dot(toward);
        let half = (radius * radius - c.length_squared() + middle * middle)
            .max(0.0)
            .sqrt();
        let t = if d > radius {
            middle - half
        } else {
            middle + half
        };
        answer.extend(toward.to_array());
        answer.extend([t, pdf, radiance / pdf]);
    }
    Some(answer)
}

/// By random numbers that are others each time.
fn by_new_numbers(q: &mut Question) -> Answer {
    static STATE: AtomicU64 = AtomicU64::new(16);
    by_numbers(q, STATE.fetch_add(1, Ordering::Relaxed) << 32, |u| u)
}

/// `place` gives the place on the light for two random numbers, which follow from `state`.
pub fn by_numbers(q: &mut Question, mut state: u64, place: impl Fn(DVec2) -> DVec2) -> Answer {
    visible(q, |_, _| {
        place(dvec2(random(&mut state), random(&mut state)))
    })
}

/// `place` gives the place on the light of sample i of n.
fn visible(q: &mut Question, mut place: impl FnMut(u32, u32) -> DVec2) -> Answer {
    let [corner, a, b] = [(); 3].map(|()| q.vector());
    let points = q.list(Question::vector);
    let balls = q.list(|q| (q.vector(), q.number()));
    let samples = q.whole() as u32;
    let mut answer = vec![points.len() as f64];
    for p in points {
        let mut seen = 0.0;
        for i in 0..samples {
            let u = place(i, samples);
            let r = corner + u.x * a + u.y * b - p;
            // The closest point of the way to each centre.
            let free = |&(center, radius): &(DVec3, f64)| {
                let s = ((center - p).dot(r) / r.length_squared()).clamp(0.0, 1.0);
                (p + s * r).distance(center) > radius
            };
            if r.dot(a.cross(b)) < 0.0 && balls.iter().all(free) {
                seen += 1.0;
            }
        }
        answer.push(seen / f64::from(samples));
    }
    Some(answer)
}
