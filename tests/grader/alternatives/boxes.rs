//! Boxes, cuts and trees of them, in f64.

use crate::alternatives::student::{Answer, Question, Ray};
use glam::DVec3;

#[derive(Clone, Copy)]
pub struct Bounds {
    pub min: DVec3,
    pub max: DVec3,
}

impl Bounds {
    pub fn area(&self) -> f64 {
        let s = self.max - self.min;
        2.0 * (s.x * s.y + s.y * s.z + s.z * s.x)
    }

    /// Where the ray is inside, from when to when.
    pub fn clip(&self, ray: &Ray) -> Option<(f64, f64)> {
        let (mut enter, mut leave) = (ray.min, ray.max);
        for i in 0..3 {
            if ray.d[i] == 0.0 {
                if ray.o[i] < self.min[i] || ray.o[i] > self.max[i] {
                    return None;
                }
                continue;
            }
            let (a, b) = (
                (self.min[i] - ray.o[i]) / ray.d[i],
                (self.max[i] - ray.o[i]) / ray.d[i],
            );
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (enter <= leave + 1e-6 * leave.abs()).then_some((enter, leave))
    }
}

pub fn bounds(q: &mut Question) -> Bounds {
    Bounds {
        min: q.vector(),
        max: q.vector(),
    }
}

pub fn around(boxes: &[Bounds], which: &[usize]) -> Bounds {
    let mut all = boxes[which[0]];
    for &i in which {
        all.min = all.min.min(boxes[i].min);
        all.max = all.max.max(boxes[i].max);
    }
    all
}

/// The left and the right side of the best cut, and its cost.
pub fn best_cut(boxes: &[Bounds], which: &[usize]) -> (Vec<usize>, Vec<usize>, f64) {
    cheapest_cut(boxes, which, Bounds::area, |b| b.min + b.max)
}

/// The best cut by the area of a box, in rows by the place of a box.
pub fn cheapest_cut(
    boxes: &[Bounds],
    which: &[usize],
    area: fn(&Bounds) -> f64,
    place: fn(&Bounds) -> DVec3,
) -> (Vec<usize>, Vec<usize>, f64) {
    let mut best = (Vec::new(), Vec::new(), f64::INFINITY);
    for axis in 0..3 {
        let mut order = which.to_vec();
        order.sort_by(|&a, &b| {
            let place = |i: usize| place(&boxes[i])[axis];
            place(a).total_cmp(&place(b))
        });
        for at in 1..order.len() {
            let (left, right) = order.split_at(at);
            let side = |side: &[usize]| area(&around(boxes, side)) * side.len() as f64;
            let cost = side(left) + side(right);
            if cost < best.2 {
                best = (left.to_vec(), right.to_vec(), cost);
            }
        }
    }
    best
}

pub fn list(numbers: &[usize]) -> Vec<f64> {
    let numbers = numbers.iter().map(|&i| i as f64);
    std::iter::once(numbers.len() as f64)
        .chain(numbers)
        .collect()
}

pub type Split<'a> = &'a dyn Fn(&[Bounds], &[usize]) -> Option<(Vec<usize>, Vec<usize>)>;

/// The nodes by breadth first, then the order.
pub fn build(q: &mut Question, split: Split) -> Answer {
    let boxes = q.list(bounds);
    let mut nodes = vec![(0..boxes.len()).collect::<Vec<_>>()];
    let (mut rows, mut order) = (Vec::new(), Vec::new());
    let mut next = 0;
    while next < nodes.len() {
        let which = nodes[next].clone();
        let all = around(&boxes, &which);
        rows.extend(all.min.to_array().into_iter().chain(all.max.to_array()));
        let sides = (which.len() > 1).then(|| split(&boxes, &which)).flatten();
        if let Some((left, right)) = sides {
            rows.extend([nodes.len() as f64, 0.0]);
            nodes.extend([left, right]);
        } else {
            rows.extend([order.len() as f64, which.len() as f64]);
            order.extend(which);
        }
        next += 1;
    }
    let mut answer = vec![nodes.len() as f64];
    answer.extend(rows);
    answer.extend(list(&order));
    Some(answer)
}
