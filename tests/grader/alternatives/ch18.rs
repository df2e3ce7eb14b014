//! Chapter 18: environments.

use crate::alternatives::student::{Alternative, Question};
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::PI;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "direction_to_cube",
        method: "the wall that is met first, its axes by cross products, in f64",
        answer: |q| {
            let d = q.vector();
            let axes = [
                (DVec3::X, DVec3::Y),
                (-DVec3::X, DVec3::Y),
                (DVec3::Y, DVec3::Z),
                (-DVec3::Y, -DVec3::Z),
                (DVec3::Z, DVec3::Y),
                (-DVec3::Z, DVec3::Y),
            ];
            let mut best = (0, f64::NEG_INFINITY);
            for (face, (forward, _)) in axes.iter().enumerate() {
                if d.dot(*forward) > best.1 {
                    best = (face, d.dot(*forward));
                }
            }
            let (forward, up) = axes[best.0];
            let (right, p) = (forward.cross(up), d / best.1);
            Some(vec![
                best.0 as f64,
                0.5 + 0.5 * p.dot(right),
                0.5 - 0.5 * p.dot(up),
            ])
        },
    },
    Alternative {
        exercise: "direction_to_latlong",
        method: "by arc cosines, in f64",
        answer: |q| {
            let d = q.vector();
            let across = dvec2(d.x, d.z).length();
            let phi = if across > 0.0 {
                (-d.z / across).clamp(-1.0, 1.0).acos().copysign(d.x)
            } else {
                0.0
            };
            Some(vec![0.5 + 0.5 * phi / PI, d.y.clamp(-1.0, 1.0).acos() / PI])
        },
    },
    Alternative {
        exercise: "sample_environment",
        method: "by columns first, from the right and from below, in f64",
        answer: |q| {
            let map = Map::read(q);
            let by_column: Vec<f64> = (0..map.width)
                .map(|x| (0..map.height).map(|y| map.light(x, y)).sum())
                .collect();
            Some(map.lattice(|u| {
                let (x, turn) = choose(&by_column, 1.0 - u.x)?;
                let of_column: Vec<f64> = (0..map.height).map(|y| map.light(x, y)).collect();
                let (y, within) = choose(&of_column, 1.0 - u.y)?;
                Some((x, turn, y, within))
            }))
        },
    },
    Alternative {
        exercise: "sample_environment",
        method: "by rows from below, the axes of u exchanged, in f64",
        answer: |q| {
            let map = Map::read(q);
            let by_row: Vec<f64> = (0..map.height)
                .map(|y| (0..map.width).map(|x| map.light(x, y)).sum())
                .collect();
            Some(map.lattice(|u| {
                let (y, within) = choose(&by_row, u.x)?;
                let of_row: Vec<f64> = (0..map.width).map(|x| map.light(x, y)).collect();
                let (x, turn) = choose(&of_row, u.y)?;
                Some((x, turn, y, within))
            }))
        },
    },
    Alternative {
        exercise: "sample_environment",
        method: "all texels in one list, in f64",
        answer: |q| {
            let map = Map::read(q);
            let cells = (0..map.height).flat_map(|y| (0..map.width).map(move |x| (x, y)));
            let all: Vec<f64> = cells.map(|(x, y)| map.light(x, y)).collect();
            Some(map.lattice(|u| {
                let (texel, turn) = choose(&all, u.x)?;
                Some((texel % map.width, turn, texel / map.width, u.y))
            }))
        },
    },
    Alternative {
        exercise: "environment_pdf",
        method: "the radiance over the integral of the map, in f64",
        answer: |q| {
            let d = q.vector();
            let map = Map::read(q);
            let x = (0.5 + d.x.atan2(-d.z) / (2.0 * PI)) * map.width as f64;
            let y = d.y.clamp(-1.0, 1.0).acos() / PI * map.height as f64;
            let (x, y) = (
                (x as usize).min(map.width - 1),
                (y as usize).min(map.height - 1),
            );
            let cells = (0..map.height).flat_map(|y| (0..map.width).map(move |x| (x, y)));
            let integral: f64 = cells.map(|(x, y)| map.light(x, y)).sum();
            let density = map.texels[y * map.width + x] / integral;
            Some(vec![if integral > 0.0 { density } else { 0.0 }])
        },
    },
];

struct Map {
    width: usize,
    height: usize,
    texels: Vec<f64>,
}

impl Map {
    fn read(q: &mut Question) -> Self {
        Self {
            width: q.whole(),
            height: q.whole(),
            texels: q.list(Question::number),
        }
    }

    fn edge(&self, y: f64) -> f64 {
        (PI * y / self.height as f64).cos()
    }

    /// A texel's radiance times its solid angle.
    fn light(&self, x: usize, y: usize) -> f64 {
        let zone = self.edge(y as f64) - self.edge(y as f64 + 1.0);
        self.texels[y * self.width + x] * 2.0 * PI * zone / self.width as f64
    }

    /// The directions of the lattice's points, from a texel's column and row and the places in it.
    fn lattice(&self, choose: impl Fn(DVec2) -> Option<(usize, f64, usize, f64)>) -> Vec<f64> {
        let points = (0..256).map(|i| f64::from(i) + 0.5);
        let points = points.map(|i| dvec2(i / 256.0, (0.618_034 * i).fract()));
        let directions: Vec<DVec3> = points
            .filter_map(|u| {
                let (x, turn, y, within) = choose(u)?;
                let phi = 2.0 * PI * ((x as f64 + turn) / self.width as f64 - 0.5);
                let (top, bottom) = (self.edge(y as f64), self.edge(y as f64 + 1.0));
                let cos = top + within * (bottom - top);
                let sin = (1.0 - cos * cos).max(0.0).sqrt();
                Some(DVec3::new(sin * phi.sin(), cos, -sin * phi.cos()))
            })
            .collect();
        let numbers = directions.iter().flat_map(DVec3::to_array);
        std::iter::once(directions.len() as f64)
            .chain(numbers)
            .collect()
    }
}

/// The cell that holds u of the weight, by walking, and where in it.
fn choose(weights: &[f64], u: f64) -> Option<(usize, f64)> {
    let mut left = u * weights.iter().sum::<f64>();
    for (cell, weight) in weights.iter().enumerate() {
        if *weight > 0.0 && left <= *weight {
            return Some((cell, left / weight));
        }
        left -= weight;
    }
    None
}
