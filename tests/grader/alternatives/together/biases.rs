//! Faults of a few percent, which no single answer shows.

use crate::alternatives::student::Question;
use crate::alternatives::{ch16, estimates};
use glam::{DVec2, Vec3, dvec2, vec3};
use rand::RngExt;
use raybook::light::environment::latlong;
use raybook::math::basis::Basis;
use raybook::math::dir3::Dir3;
use raybook::math::pcg;
use raybook_grader::cases;
use std::f64::consts::{PI, TAU};

/// A fault of a size, in words, and what it makes of the golden answer's numbers, without the count of a list, to a question's.
pub type Bias = (&'static str, fn(&[f64], Vec<f64>) -> Vec<f64>);

/// Numbers for a fault that makes points anew.
fn uniform(stream: u64, n: usize) -> Vec<f64> {
    let mut rng = pcg::stream(404, stream);
    (0..n).map(|_| rng.random()).collect()
}

/// Places in cells, shrunk by a factor.
fn shrunk(q: &[f64], points: Vec<f64>, factor: f64) -> Vec<f64> {
    let mut axis = [q[0], q[1]].into_iter().cycle();
    let shrink = |v: f64| {
        let cells = axis.next().unwrap_or(1.0);
        let cell = (v * cells).floor();
        (cell + factor * (v * cells - cell)) / cells
    };
    points.into_iter().map(shrink).collect()
}

fn times(numbers: Vec<f64>, factor: f64) -> Vec<f64> {
    numbers.into_iter().map(|v| v * factor).collect()
}

/// Numbers whose power this is; along y too, or along x only.
fn bent(mut points: Vec<f64>, power: f64, axes: usize) -> Vec<f64> {
    let step = 3 - axes;
    points
        .iter_mut()
        .step_by(step)
        .for_each(|v| *v = v.powf(power));
    points
}

/// The same of the places in cells.
fn bent_in_cells(q: &[f64], mut points: Vec<f64>, power: f64) -> Vec<f64> {
    let cells = [q[0], q[1]].into_iter().cycle();
    for (v, cells) in points.iter_mut().zip(cells) {
        let cell = (*v * cells).floor().min(cells - 1.0);
        *v = (cell + (*v * cells - cell).powf(power)) / cells;
    }
    points
}

/// A marginal with a wave of this height in its distribution.
fn waved(points: Vec<f64>, height: f64) -> Vec<f64> {
    let wave = |v: f64| (v + height * (TAU * v).sin()).clamp(0.0, 1.0);
    points.into_iter().map(wave).collect()
}

/// Points whose y follow x by this much.
fn following(points: &[f64], much: f64) -> Vec<f64> {
    let mut made = uniform(7, points.len()).into_iter();
    let follow = |p: &[f64]| {
        let follows = made.next().is_some_and(|u| u < much);
        [p[0], if follows { p[0] } else { p[1] }]
    };
    points.chunks_exact(2).flat_map(follow).collect()
}

/// Points of the disc whose radius, which should be √u, is this power of u.
fn power(points: &[f64], power: f64) -> Vec<f64> {
    let moved = points.chunks_exact(2).flat_map(|p| {
        let r = p[0].hypot(p[1]);
        let factor = if r > 0.0 {
            r.powf(2.0 * power - 1.0)
        } else {
            1.0
        };
        [p[0] * factor, p[1] * factor]
    });
    moved.collect()
}

/// Fractions of the light at other places on it, each by random numbers that follow from the question.
fn at_places(q: &[f64], place: impl Fn(DVec2) -> DVec2) -> Vec<f64> {
    let words: Vec<_> = q.iter().map(f64::to_string).collect();
    let question = &mut Question::read(&words.join(" "));
    let seed = q.iter().fold(0, |seed, v| pcg::mix(seed ^ v.to_bits()));
    let answer = ch16::by_numbers(question, seed, place);
    answer.expect("fractions")[1..].to_vec()
}

/// Fractions by this share of the samples.
fn of_samples(q: &[f64], share: f64) -> Vec<f64> {
    let mut question = q.to_vec();
    if let Some(samples) = question.last_mut() {
        *samples = (share * *samples).round();
    }
    at_places(&question, |u| u)
}

/// Directions as the angle round the normal and the height above the surface, changed.
fn round_the_normal(q: &[f64], numbers: &[f64], change: fn(f64, f64) -> (f64, f64)) -> Vec<f64> {
    let normal = vec3(q[0] as f32, q[1] as f32, q[2] as f32);
    let basis = Basis::around(Dir3::new(normal).expect("a normal"));
    let changed = directions(numbers).flat_map(|d| {
        let [x, y, z] = [basis.x, basis.y, basis.z].map(|axis| f64::from(d.dot(*axis)));
        let (turn, height) = change(y.atan2(x).rem_euclid(TAU), z);
        let r = (1.0 - height * height).max(0.0).sqrt();
        let local = dvec2(r * turn.cos(), r * turn.sin()).extend(height);
        basis.to_world(local.as_vec3()).to_array()
    });
    changed.map(f64::from).collect()
}

fn directions(numbers: &[f64]) -> impl Iterator<Item = Vec3> {
    let direction = |d: &[f64]| vec3(d[0] as f32, d[1] as f32, d[2] as f32);
    numbers.chunks_exact(3).map(direction)
}

/// Directions at other places in their texels: of the shares of its width and of its height by area.
fn in_texels(q: &[f64], numbers: &[f64], change: fn(f64, f64) -> (f64, f64)) -> Vec<f64> {
    let (width, height) = (q[0], q[1]);
    let changed = directions(numbers).flat_map(|d| {
        let place = latlong::place(Dir3::new(d).expect("a direction")).as_dvec2();
        let (x, y) = ((place.x * width).floor(), (place.y * height).floor());
        let [top, bottom] = [y, y + 1.0].map(|row| (PI * row / height).cos());
        let down = (top - f64::from(d.y)) / (top - bottom);
        let (right, down) = change(place.x * width - x, down);
        let cosine = top + (bottom - top) * down;
        latlong::toward(((x + right) / width) as f32, cosine).to_array()
    });
    changed.map(f64::from).collect()
}

/// Directions by a map whose texels weigh this much more, by column and row.
fn directions_of_map(q: &[f64], more: fn(usize, usize) -> f64) -> Vec<f64> {
    let examiner = cases::find("sample_environment").expect("it exists");
    let (width, mut heavier) = (q[0] as usize, q.to_vec());
    for (i, texel) in heavier[3..].iter_mut().enumerate() {
        *texel *= more(i % width, i / width);
    }
    let answer = (examiner.asked().call)(&heavier);
    answer[1..].to_vec()
}

/// The faults of each exercise.
pub const BIASES: &[(&str, &[Bias])] = &[
    (
        "visible_fraction",
        &[
            ("leaves out 4 % of the light along a", |q, _| {
                at_places(q, |u| dvec2(0.96 * u.x, u.y))
            }),
            ("takes the light for 4 % too large", |q, _| {
                at_places(q, |u| 1.04 * u - 0.02)
            }),
            ("has places of the power 1.1 along a", |q, _| {
                at_places(q, |u| dvec2(u.x.powf(1.1), u.y))
            }),
            ("takes a quarter of the samples", |q, _| of_samples(q, 0.25)),
            (
                "is 3 % too large, by the same numbers each time",
                |_, all| times(all, 1.03).into_iter().map(|f| f.min(1.0)).collect(),
            ),
            (
                "is 3 % too small, by the same numbers each time",
                |_, all| times(all, 0.97),
            ),
        ],
    ),
    (
        "sample_environment",
        &[
            ("weighs the first row 5 % too much", |q, _| {
                directions_of_map(q, |_, row| if row == 0 { 1.05 } else { 1.0 })
            }),
            ("weighs the first column 5 % too much", |q, _| {
                directions_of_map(q, |column, _| if column == 0 { 1.05 } else { 1.0 })
            }),
            ("fills 0.98 of a texel's width", |q, all| {
                in_texels(q, &all, |right, down| (0.98 * right, down))
            }),
            ("fills the middle 0.96 of a texel's height", |q, all| {
                in_texels(q, &all, |right, down| (right, 0.02 + 0.96 * down))
            }),
            ("has the power 1.05 in a texel's width", |q, all| {
                in_texels(q, &all, |right, down| (right.powf(1.05), down))
            }),
        ],
    ),
    (
        "cosine_hemisphere",
        &[
            ("goes 0.97 of the way round", |q, all| {
                round_the_normal(q, &all, |turn, height| (0.97 * turn, height))
            }),
            ("takes 3 for π", |q, all| {
                round_the_normal(q, &all, |turn, height| (3.0 / PI * turn, height))
            }),
            ("is never within 10° of the normal", |q, all| {
                round_the_normal(q, &all, |turn, height| {
                    (turn, 10_f64.to_radians().cos() * height)
                })
            }),
        ],
    ),
    (
        "concentric_disk",
        &[
            ("takes 3 for π in the concentric map", |_, points| {
                let pressed = points.chunks_exact(2).flat_map(|p| {
                    let (r, quarter) = (p[0].hypot(p[1]), (p[1].atan2(p[0]) / TAU * 4.0).round());
                    let turn = p[1].atan2(p[0]) - quarter * TAU / 4.0;
                    let turn = quarter * TAU / 4.0 + 3.0 / PI * turn;
                    [r * turn.cos(), r * turn.sin()]
                });
                pressed.collect()
            }),
            ("has the radius u^0.55", |_, points| power(&points, 0.55)),
            ("has the radius u^0.51", |_, points| power(&points, 0.51)),
            ("has the radius u^0.49", |_, points| power(&points, 0.49)),
            ("has 0.98 of the right angle", |_, points| {
                let turned = points.chunks_exact(2).flat_map(|p| {
                    let (r, turn) = (p[0].hypot(p[1]), p[1].atan2(p[0]).rem_euclid(TAU));
                    [r * (0.98 * turn).cos(), r * (0.98 * turn).sin()]
                });
                turned.collect()
            }),
            ("has a radius of 0.99", |_, points| times(points, 0.99)),
        ],
    ),
    (
        "random_pattern",
        &[
            ("has no x from 0.499 to 0.501", |_, points| {
                let out = |(i, v): (usize, f64)| match v {
                    0.499..0.501 if i % 2 == 0 => v + 0.1,
                    _ => v,
                };
                points.into_iter().enumerate().map(out).collect()
            }),
            ("fills 0.9 of the square's sides", |_, points| {
                times(points, 0.9)
            }),
            ("fills 0.95 of the square's sides", |_, points| {
                times(points, 0.95)
            }),
            ("fills 0.99 of the square's sides", |_, points| {
                times(points, 0.99)
            }),
            ("fills 0.997 of the square's sides", |_, points| {
                times(points, 0.997)
            }),
            ("is of the power 1.1 along x", |_, points| {
                bent(points, 1.1, 1)
            }),
            ("is of the power 1.05 along both axes", |_, points| {
                bent(points, 1.05, 2)
            }),
            ("is of the power 1.02 along both axes", |_, points| {
                bent(points, 1.02, 2)
            }),
            (
                "is of the power 1.02 along x (mean 1 % off)",
                |_, points| bent(points, 1.02, 1),
            ),
            (
                "is of the power 1.01 along x (mean 0.5 % off)",
                |_, points| bent(points, 1.01, 1),
            ),
            ("has a wave of 1 % in its marginals", |_, points| {
                waved(points, 0.01)
            }),
            ("has y = x in 5 % of the points", |_, points| {
                following(&points, 0.05)
            }),
            ("has y = x in 2 % of the points", |_, points| {
                following(&points, 0.02)
            }),
            ("is a seventh seed's (seed mod 7)", |q, points| {
                uniform((q[1] % 7.0) as u64, points.len())
            }),
            ("ignores the seed", |_, points| uniform(0, points.len())),
            (
                "mirrors every other point (antithetic pairs)",
                |q, points| {
                    let mut made = uniform(q[1] as u64, points.len());
                    for two in made.chunks_exact_mut(4) {
                        (two[2], two[3]) = (1.0 - two[0], 1.0 - two[1]);
                    }
                    made
                },
            ),
        ],
    ),
    (
        "jittered",
        &[
            (
                "has no jitter from 0.499 to 0.501 along x",
                |q, mut points| {
                    for v in points.iter_mut().step_by(2) {
                        let within = (*v * q[0]).fract();
                        if (0.499..0.501).contains(&within) {
                            *v += 0.1 / q[0];
                        }
                    }
                    points
                },
            ),
            ("jitters in 0.9 of a cell", |q, points| {
                shrunk(q, points, 0.9)
            }),
            ("jitters in 0.95 of a cell", |q, points| {
                shrunk(q, points, 0.95)
            }),
            ("jitters in 0.99 of a cell", |q, points| {
                shrunk(q, points, 0.99)
            }),
            ("jitters in 0.997 of a cell", |q, points| {
                shrunk(q, points, 0.997)
            }),
            ("jitters by the power 1.05", |q, points| {
                bent_in_cells(q, points, 1.05)
            }),
            ("jitters by the power 1.02 (mean 1 % off)", |q, points| {
                bent_in_cells(q, points, 1.02)
            }),
            ("is a seventh seed's (seed mod 7)", |q, points| {
                let places = uniform((q[2] % 7.0) as u64, points.len());
                let axes = [q[0], q[1]].into_iter().cycle();
                let place = |((v, u), cells): ((f64, f64), f64)| ((v * cells).floor() + u) / cells;
                points
                    .into_iter()
                    .zip(places)
                    .zip(axes)
                    .map(place)
                    .collect()
            }),
        ],
    ),
    (
        "poisson_disk",
        &[
            ("is 1.1 times as large as asked", |_, points| {
                times(points, 1.1)
            }),
            ("is 1.05 times as large as asked", |_, points| {
                times(points, 1.05)
            }),
            ("is 1.02 times as large as asked", |_, points| {
                times(points, 1.02)
            }),
            ("leaves 1 % free at each border", |_, points| {
                points.into_iter().map(|v| 0.01 + 0.98 * v).collect()
            }),
        ],
    ),
    (
        "reflected_radiance",
        &[
            ("is 2 % too bright", |q, _| {
                times(estimates::of_samples(q, 1.0), 1.02)
            }),
            ("is 1 % too bright", |q, _| {
                times(estimates::of_samples(q, 1.0), 1.01)
            }),
            ("takes half of the samples", |q, _| {
                estimates::of_samples(q, 0.5)
            }),
            ("takes a tenth of the samples", |q, _| {
                estimates::of_samples(q, 0.1)
            }),
        ],
    ),
];
