//! Slips in lists: too short, wrong at an end, one of several alike, numbers of the element before; and what is wrong for some questions
//! only.

use super::function::{diagnosed, right};
use raybook_grader::diagnose::Diagnosis;

/// The diagnosis of right lists of elements of this many numbers, changed.
fn changed(exercise: &str, size: usize, change: impl Fn(&[f64], &mut Vec<Vec<f64>>)) -> Diagnosis {
    diagnosed(exercise, |q| {
        let mut elements = elements(&right(exercise, q)[1..], size);
        change(q, &mut elements);
        let count = elements.len() as f64;
        Some([vec![count], elements.concat()].concat())
    })
}

/// The elements of a list, of this many numbers each.
fn elements(numbers: &[f64], size: usize) -> Vec<Vec<f64>> {
    numbers.chunks(size).map(<[f64]>::to_vec).collect()
}

#[test]
fn a_list_of_a_greatest_length_is_named() {
    let found = changed("two_level_walk", 1, |_, cells| cells.truncate(3));
    assert_eq!(found.name, "returns the first 3 of the list at most");
}

#[test]
fn a_list_without_the_last_along_each_axis_is_named() {
    let found = changed("voxels_of_triangle", 3, |q, cells| {
        cells.retain(|cell| (0..3).all(|axis| cell[axis] + 1.0 < q[6 + axis]));
    });
    let told = "leaves out of the list what is the last along x, y, z";
    assert_eq!(found.name, told);
}

#[test]
fn one_of_several_that_differ_in_one_number_is_named() {
    let found = diagnosed("refine_cell", |q| {
        let right = right("refine_cell", q);
        let mut entries = elements(&right[4..], 4);
        entries.sort_by(|a, b| a.partial_cmp(b).expect("there are no NaNs"));
        entries.dedup_by(|a, b| a[..3] == b[..3]);
        let count = entries.len() as f64;
        Some([&right[..3], &[count], &entries.concat()].concat())
    });
    let told = "returns the first only of those in the list that differ in shape alone";
    assert_eq!(found.name, told);
}

#[test]
fn a_first_element_that_is_always_the_same_is_named() {
    let found = changed("vertex_normals", 3, |_, normals| {
        if let Some(first) = normals.first_mut() {
            *first = vec![0.0, 1.0, 0.0];
        }
    });
    let told = "returns 0 1 0 for the first of the list, whatever it is";
    assert_eq!(found.name, told);
}

#[test]
fn numbers_of_the_element_before_are_named() {
    let found = changed("vertex_normals", 3, |_, normals| {
        let last = normals.pop();
        if let Some(first) = normals.first().cloned() {
            normals.insert(0, first);
        } else {
            normals.extend(last);
        }
    });
    let told = "returns for normal what belongs to the element before";
    assert_eq!(found.name, told);
}

#[test]
fn differences_from_the_element_before_are_named() {
    let found = changed("grid_walk", 4, |_, visits| {
        for i in (1..visits.len()).rev() {
            visits[i][3] -= visits[i - 1][3];
        }
    });
    let told = "returns for leave the difference from the element before";
    assert_eq!(found.name, told);
}

#[test]
fn sums_of_all_elements_are_named() {
    let found = changed("spend_budget", 1, |_, counts| {
        for i in 1..counts.len() {
            counts[i][0] += counts[i - 1][0];
        }
    });
    let told = "returns for count the sum of all elements up to it";
    assert_eq!(found.name, told);
}

#[test]
fn a_list_without_the_last_shape_is_named() {
    let found = diagnosed("refine_cell", |q| {
        let right = right("refine_cell", q);
        let mut entries = elements(&right[4..], 4);
        entries.retain(|entry| entry[3] + 1.0 < q[7]);
        let count = entries.len() as f64;
        Some([&right[..3], &[count], &entries.concat()].concat())
    });
    let told = "leaves out of the list what belongs to the last of all: shape";
    assert_eq!(found.name, told);
}

/// The leaves below a node, if of each node's children that the ray passes through only this number count.
fn leaves(q: &[f64], node: usize, cell: [[f64; 3]; 2], most: usize, found: &mut Vec<f64>) {
    let [inner, first, count] = [0, 1, 2].map(|k| q[15 + 3 * node + k]);
    if inner == 0.0 {
        found.extend((count > 0.0).then_some(node as f64));
        return;
    }
    let child = |i: usize| {
        let halves = |axis: usize| {
            let [low, high] = [0, 1].map(|end: usize| cell[end][axis]);
            let middle = 0.5 * (low + high);
            if i >> axis & 1 == 1 {
                [middle, high]
            } else {
                [low, middle]
            }
        };
        let [x, y, z] = [0, 1, 2].map(halves);
        let cell = [0, 1].map(|end: usize| [x[end], y[end], z[end]]);
        let (mut enter, mut leave) = (q[6], q[7]);
        for axis in 0..3 {
            let [one, other] = [0, 1].map(|end: usize| {
                let ahead = cell[end][axis] - q[axis];
                if q[3 + axis] == 0.0 {
                    ahead * f64::INFINITY
                } else {
                    ahead / q[3 + axis]
                }
            });
            (enter, leave) = (enter.max(one.min(other)), leave.min(one.max(other)));
        }
        (leave - enter > 1e-9).then_some((enter, first as usize + i, cell))
    };
    let mut met: Vec<_> = (0..8).filter_map(child).collect();
    met.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, child, cell) in met.into_iter().take(most) {
        leaves(q, child, cell, most, found);
    }
}

#[test]
fn rounds_of_the_children_that_are_met_are_named() {
    let found = diagnosed("octree_walk", |q| {
        let mut found = Vec::new();
        let cell = [8, 11].map(|from| [q[from], q[from + 1], q[from + 2]]);
        leaves(q, 0, cell, 2, &mut found);
        Some([vec![found.len() as f64], found].concat())
    });
    let told = "visits at most two children of a node";
    assert_eq!(found.name, told);
}

#[test]
fn what_is_wrong_where_the_ray_goes_down_is_told_so() {
    let found = changed("octree_walk", 1, |q, leaves| {
        if q[4] < 0.0 {
            leaves.reverse();
        }
    });
    let told = "visits the leaves from back to front, but only where `direction` goes down along y";
    assert_eq!((&*found.name, found.certain), (told, false));
}

#[test]
fn a_choice_that_leaves_one_out_is_named() {
    let found = diagnosed("direction_to_cube", |q| {
        let [x, y, z] = [q[0], q[1], q[2]];
        let axis = if x.abs() > z.abs() { 0 } else { 2 };
        let m = q[axis];
        let across = match (axis, m > 0.0) {
            (0, true) => z,
            (0, false) => -z,
            (_, true) => -x,
            (_, false) => x,
        };
        let face = 2 * axis + usize::from(m <= 0.0);
        let [u, v] = [across, -y].map(|along| 0.5 + 0.5 * along / m.abs());
        Some(vec![face as f64, u, v])
    });
    let told = "leaves out the second of all when it chooses the axis of the greatest component";
    assert_eq!(found.name, told);
}

#[test]
fn a_value_that_is_rounded_is_no_certainty() {
    let found = diagnosed("environment_pdf", |q| {
        let theta = q[1].clamp(-1.0, 1.0).acos();
        // The row is found by a power of the place.
        let row = (theta / std::f64::consts::PI).powf(1.3) * std::f64::consts::PI;
        let across = q[0].hypot(q[2]).max(1e-9);
        let [x, z] = [q[0], q[2]].map(|v| v / across);
        let seen = [row.sin() * x, row.cos(), row.sin() * z];
        Some(right("environment_pdf", &[&seen, &q[3..]].concat()))
    });
    assert!(!found.certain, "{found:?}");
}
