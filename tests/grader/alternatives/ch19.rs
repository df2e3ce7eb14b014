//! Chapter 19: discs, lenses and blur.

use crate::alternatives::ch17::concentric;
use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::{FRAC_PI_4, TAU};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "concentric_disk",
        method: "the concentric map in f64",
        answer: |q| disc(q, concentric),
    },
    Alternative {
        exercise: "concentric_disk",
        method: "by the way around the square, clockwise, from below",
        answer: |q| {
            disc(q, |u| {
                let p = 2.0 * u - 1.0;
                let r = p.abs().max_element();
                // 0 to 8 along the square of half side 1, from its lower left corner.
                let around = if p.y == -r {
                    1.0 + p.x / r
                } else if p.x == r {
                    3.0 + p.y / r
                } else if p.y == r {
                    5.0 - p.x / r
                } else {
                    7.0 - p.y / r
                };
                r * DVec2::from_angle(-FRAC_PI_4 * if r > 0.0 { around } else { 0.0 })
            })
        },
    },
    Alternative {
        exercise: "concentric_disk",
        method: "rings: the root of u.x and an angle",
        answer: |q| disc(q, |u| u.x.sqrt() * DVec2::from_angle(TAU * u.y)),
    },
    Alternative {
        exercise: "concentric_disk",
        method: "rings by u.y from the edge inwards",
        answer: |q| {
            disc(q, |u| {
                (1.0 - u.y).sqrt() * DVec2::from_angle(2.0 - TAU * u.x)
            })
        },
    },
    Alternative {
        exercise: "thin_lens_ray",
        method: "the lens bends the film's ray: its slope changes by the height over f, in f64",
        answer: |q| {
            lens(q, |at, on_film, lens| {
                let slope = (lens + on_film) / at.film - lens / at.f;
                slope.extend(1.0)
            })
        },
    },
    Alternative {
        exercise: "thin_lens_ray",
        method: "to the sharp image's original, by similar triangles, in f64",
        answer: |q| {
            lens(q, |at, on_film, lens| {
                let original = (on_film / at.film * at.s).extend(at.s);
                original - lens.extend(0.0)
            })
        },
    },
    Alternative {
        exercise: "circle_of_confusion",
        method: "the cone behind the lens, cut by the film, in f64",
        answer: |q| {
            let [f, n, s, x] = [(); 4].map(|()| q.number());
            let sharp = |x: f64| 1.0 / (1.0 / f - 1.0 / x);
            Some(vec![f / n * (sharp(s) - sharp(x)).abs() / sharp(x)])
        },
    },
    Alternative {
        exercise: "circle_of_confusion",
        method: "dioptres, in f64",
        answer: |q| {
            let [f, n, s, x] = [(); 4].map(|()| q.number());
            Some(vec![
                f / n * (1.0 / s - 1.0 / x).abs() / (1.0 / f - 1.0 / s),
            ])
        },
    },
    Alternative {
        exercise: "circle_of_confusion",
        method: "where the lens' edge shows the point, by rounded steps in f32",
        answer: |q| {
            let [f, n, s, x] = [(); 4].map(|()| q.number() as f32);
            let sharp = |x: f32| {
                if x.is_finite() { f * x / (x - f) } else { f }
            };
            let (film, tip) = (sharp(s), sharp(x));
            Some(vec![f64::from((f / n) * (film / tip - 1.0).abs())])
        },
    },
];

fn disc(q: &mut Question, map: fn(DVec2) -> DVec2) -> Answer {
    let (n, shift) = (q.whole(), q.pair());
    let points = (0..n).map(|i| {
        let i = i as f64 + 0.5;
        let u = shift + dvec2(i / n as f64, 0.618_034 * i);
        map(u - u.floor())
    });
    let numbers = points.flat_map(|p| p.to_array());
    Some(std::iter::once(n as f64).chain(numbers).collect())
}

/// A lens and its film.
struct At {
    f: f64,
    s: f64,
    film: f64,
}

/// The ray whose direction in the camera's coordinates follows from the lens, the place in metres on the upright film, and
/// the place in metres on the lens.
fn lens(q: &mut Question, toward: fn(&At, DVec2, DVec2) -> DVec3) -> Answer {
    let [middle, forward, right, up] = [(); 4].map(|()| q.vector());
    let [f, n, s] = [(); 3].map(|()| q.number());
    let [plane, film, on_lens] = [(); 3].map(|()| q.pair());
    let at = At {
        f,
        s,
        film: f * s / (s - f),
    };
    let on_film = dvec2(film.x - 0.5, 0.5 - film.y) * plane;
    let on_lens = on_lens * (0.5 * f / n);
    let world = |v: DVec3| v.x * right + v.y * up + v.z * forward;
    let direction = world(toward(&at, on_film, on_lens)).normalize();
    let origin = middle + world(on_lens.extend(0.0));
    Some([origin.to_array(), direction.to_array()].concat())
}
