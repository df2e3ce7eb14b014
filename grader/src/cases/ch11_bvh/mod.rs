//! Chapter 11: `sah_cost`, `sah_split`, `bvh_build`, `bvh_closest`.

use crate::{Verdict, sample};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::{COST, Cost, build};
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercises::ch11_bvh::BvhBuildAnswer;
use raybook_workbook::tree_rows::{BoxRow, to_rows};

mod builders;
mod bvh_tree;

raybook_workbook::ch11_bvh!(graded);

pub use bvh_closest::question;

fn area(min: Vec3, max: Vec3) -> f32 {
    let size = max - min;
    2.0 * (size.x * size.y + size.y * size.z + size.z * size.x)
}

/// The area of a box of this size without the faces across an axis.
fn without_faces(size: Vec3, axis: usize) -> f32 {
    let [across, along, upwards] = [0, 1, 2].map(|i| size[(axis + i) % 3]);
    2.0 * across * (along + upwards)
}

/// The cost of two sides, if the right one had what the left one lacks of the area of the box around both.
fn whole_less_left(boxes: &[BoxRow], left: &[u32], right: &[u32]) -> f32 {
    let area_of = |side: &[u32]| {
        let Aabb { min, max } = around(boxes, side);
        area(min, max)
    };
    let of_left = area_of(left);
    let rest = area_of(&[left, right].concat()) - of_left;
    of_left * left.len() as f32 + rest * right.len() as f32
}

fn around(boxes: &[BoxRow], which: &[u32]) -> Aabb {
    let corners = which.iter().filter_map(|&i| boxes.get(i as usize));
    Aabb::of(corners.flat_map(|row| [row.min, row.max]))
}

fn cube(center: Vec3, half: f32) -> BoxRow {
    BoxRow {
        min: center - half,
        max: center + half,
    }
}

/// Boxes of different sizes in a few heaps of different numbers: what a split by number alone gets wrong.
fn heaps(rng: &mut Pcg) -> Vec<BoxRow> {
    let mut boxes = Vec::new();
    for count in [1, 2, 5] {
        let center = sample::point(rng, 8.0);
        for _ in 0..count + rng.random_range(0..2) {
            let half = vec3(
                sample::number(rng, 0.1, 0.8),
                sample::number(rng, 0.1, 0.8),
                sample::number(rng, 0.1, 0.8),
            );
            let at = center + sample::point(rng, 1.5);
            boxes.push(BoxRow {
                min: at - half,
                max: at + half,
            });
        }
    }
    boxes
}

/// This number of boxes in heaps: sticks, plates and blocks.
fn crowd(rng: &mut Pcg, count: usize) -> Vec<BoxRow> {
    let heaps: Vec<_> = (0..count.div_ceil(12))
        .map(|_| sample::point(rng, 8.0))
        .collect();
    let stick = |rng: &mut Pcg| 0.03 * 40.0_f32.powf(sample::number(rng, 0.0, 1.0));
    let boxes = (0..count).map(|_| {
        let at = heaps[rng.random_range(0..heaps.len())] + sample::point(rng, 1.5);
        let half = vec3(stick(rng), stick(rng), stick(rng));
        BoxRow {
            min: at - half,
            max: at + half,
        }
    });
    boxes.collect()
}

/// The tree over boxes by a method, with leaves of at most `most` shapes.
fn tree(boxes: &[BoxRow], method: Method, most: u32) -> BvhBuildAnswer {
    let boxes: Vec<_> = boxes.iter().map(Aabb::from).collect();
    let flat = build(&boxes, method, &Cost { most, ..COST });
    BvhBuildAnswer {
        nodes: to_rows(&flat),
        order: flat.order,
    }
}

fn center(row: &BoxRow) -> Vec3 {
    0.5 * (row.min + row.max)
}

/// A cost that may exceed the reference's by some part of it.
fn no_dearer(what: &str, got: f32, reference: f32, part: f32) -> Verdict {
    let times = got / reference;
    if got <= reference * (1.0 + part) {
        Ok(())
    } else if times < 3.0 {
        Err(format!(
            "{what} costs {got:.3}, {:.0} % more than {reference:.3}",
            100.0 * (times - 1.0)
        ))
    } else {
        Err(format!(
            "{what} costs {got:.3}, {times:.0} times as much as {reference:.3}"
        ))
    }
}
