//! Chapter 8: grids.

use crate::alternatives::polygon::clipped;
use crate::alternatives::student::{Alternative, Answer, Question, Ray};
use glam::{DVec3, dvec3};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "grid_resolution",
        method: "from the longest side on, as many axes as are thick, in f64",
        answer: |q| {
            let (extents, shapes, density) = (q.vector().to_array(), q.number(), q.number());
            let mut axes = [0, 1, 2];
            axes.sort_by(|&a, &b| extents[b].total_cmp(&extents[a]));
            let mut cells = [1.0; 3];
            for count in (1..=3).rev() {
                let thick = &axes[..count];
                let content: f64 = thick.iter().map(|&a| extents[a]).product();
                let side = (content / (density * shapes)).powf(1.0 / count as f64);
                // 0/0 is not enough either.
                if extents[thick[count - 1]] / side >= 1.0 {
                    for &a in thick {
                        cells[a] = (extents[a] / side).round();
                    }
                    break;
                }
            }
            Some(cells.to_vec())
        },
    },
    Alternative {
        exercise: "voxels_of_triangle",
        method: "the triangle clipped by the planes of every cell, in f64",
        answer: |q| {
            let (min, cell, n) = lattice(q);
            let margin = q.number();
            let triangle = [(); 3].map(|()| q.vector()).to_vec();
            let found = cells(n).filter(|&c| {
                let low = min + c * cell - margin;
                let high = min + (c + 1.0) * cell + margin;
                let mut polygon = triangle.clone();
                for axis in 0..3 {
                    polygon = clipped(&polygon, |p| p[axis] - low[axis]);
                    polygon = clipped(&polygon, |p| high[axis] - p[axis]);
                }
                !polygon.is_empty()
            });
            let found: Vec<_> = found.collect();
            let mut numbers = vec![found.len() as f64];
            numbers.extend(found.iter().rev().flat_map(DVec3::to_array));
            Some(numbers)
        },
    },
    Alternative {
        exercise: "grid_walk",
        method: "all planes' distances sorted, and the cell in the middle between two, in f64",
        answer: |q| {
            let (min, cell, n) = lattice(q);
            let ray = q.ray();
            let Some((enter, leave)) = inside(&ray, min, min + n * cell) else {
                return visits(&[]);
            };
            let planes = (0..3).flat_map(|axis| {
                (0..=n[axis] as usize)
                    .map(move |i| (min[axis] + i as f64 * cell[axis] - ray.o[axis]) / ray.d[axis])
            });
            let mut t: Vec<_> = planes.filter(|&t| enter < t && t < leave).collect();
            t.extend([enter, leave]);
            t.sort_by(f64::total_cmp);
            let cell_at = |t: f64| {
                ((ray.o + t * ray.d - min) / cell)
                    .floor()
                    .clamp(DVec3::ZERO, n - 1.0)
            };
            let visit = |t: &[f64]| (cell_at(0.5 * (t[0] + t[1])), t[1]);
            visits(&t.windows(2).map(visit).collect::<Vec<_>>())
        },
    },
    Alternative {
        exercise: "grid_walk",
        method: "every cell's box clipped, sorted by where the ray enters, in f64",
        answer: |q| {
            let (min, cell, n) = lattice(q);
            let ray = q.ray();
            let passed = cells(n).filter_map(|c| {
                let low = min + c * cell;
                // A ray in a plane belongs to the cell behind it.
                let beside = (0..3).any(|a| ray.d[a] == 0.0 && ray.o[a] == low[a] + cell[a]);
                let (enter, leave) = inside(&ray, low, low + cell)?;
                (!beside && enter < leave).then_some((enter, c, leave))
            });
            let mut passed: Vec<_> = passed.collect();
            passed.sort_by(|a, b| a.0.total_cmp(&b.0));
            visits(
                &passed
                    .iter()
                    .map(|&(_, c, leave)| (c, leave))
                    .collect::<Vec<_>>(),
            )
        },
    },
];

/// The least corner, the extents of a cell, and the numbers of cells.
fn lattice(q: &mut Question) -> (DVec3, DVec3, DVec3) {
    (q.vector(), q.vector(), q.vector())
}

fn cells(n: DVec3) -> impl Iterator<Item = DVec3> {
    let [x, y, z] = n.to_array().map(|n| n as u32);
    (0..x).flat_map(move |x| {
        (0..y).flat_map(move |y| (0..z).map(move |z| dvec3(x.into(), y.into(), z.into())))
    })
}

/// The distances between which a ray is in a box.
pub fn inside(ray: &Ray, low: DVec3, high: DVec3) -> Option<(f64, f64)> {
    let (mut min, mut max) = (ray.min, ray.max);
    for axis in 0..3 {
        let (o, d) = (ray.o[axis], ray.d[axis]);
        if d == 0.0 {
            if o < low[axis] || o > high[axis] {
                return None;
            }
        } else {
            let (a, b) = ((low[axis] - o) / d, (high[axis] - o) / d);
            min = min.max(a.min(b));
            max = max.min(a.max(b));
        }
    }
    (min <= max).then_some((min, max))
}

/// The number of visits, and each cell with the distance at which the ray leaves it.
fn visits(visits: &[(DVec3, f64)]) -> Answer {
    let mut numbers = vec![visits.len() as f64];
    numbers.extend(
        visits
            .iter()
            .flat_map(|&(cell, leave)| [cell.x, cell.y, cell.z, leave]),
    );
    Some(numbers)
}
