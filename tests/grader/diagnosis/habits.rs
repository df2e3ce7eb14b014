//! Slips that people make at any comparison, loop or operation are named in every exercise whose steps have one.

use super::function::{diagnosed, found, right};
use glam::{DVec3, UVec3};

#[test]
fn less_for_less_or_equal_is_named() {
    // Coarse cells of a single fine cell are left out.
    let found = diagnosed("two_level_walk", |q| {
        let (mut first, mut alone) = (0.0, Vec::new());
        for n in q[18..].chunks_exact(3) {
            let count = n[0] * n[1] * n[2];
            if count == 1.0 {
                alone.push(first);
            }
            first += count;
        }
        let mut places = right("two_level_walk", q).split_off(1);
        places.retain(|place| !alone.contains(place));
        places.insert(0, places.len() as f64);
        Some(places)
    });
    let told = "decides wrongly where both sides are equal whether a coarse cell is empty: < stands for ≤, or ≤ for <";
    assert_eq!(found.name, told);
}

#[test]
fn a_threshold_for_0_is_named() {
    let found = diagnosed("triangle_normal", |q| {
        let [p0, p1, p2] = [0, 3, 6].map(|from| DVec3::from_slice(&q[from..]));
        let is_small = (p1 - p0).cross(p2 - p0).length() < 1e-2;
        Some(if is_small {
            vec![0.0]
        } else {
            right("triangle_normal", q)
        })
    });
    let told = "takes what is within 0.01, or about that, for equal when it decides whether the triangle has no area";
    assert_eq!(found.name, told);
}

#[test]
fn an_operation_that_is_forgotten_is_named() {
    let found = diagnosed("voxels_of_triangle", |q| Some(voxels(q)));
    let told = "forgets to take the absolute values of a direction's components";
    assert_eq!(found.name, told);
}

/// The cells that no direction parts from a triangle (Akenine-Möller 2001), with a cell's reach along a direction that is not made positive.
fn voxels(q: &[f64]) -> Vec<f64> {
    let [min, size] = [0, 3].map(|from| DVec3::from_slice(&q[from..]));
    let corners = [10, 13, 16].map(|from| DVec3::from_slice(&q[from..]));
    let half = 0.5 * size + q[9];
    let edges = [0, 1, 2].map(|i| corners[(i + 1) % 3] - corners[i]);
    let across = edges
        .iter()
        .flat_map(|e| DVec3::AXES.map(|axis| axis.cross(*e)));
    let directions = DVec3::AXES.into_iter().chain([edges[0].cross(edges[1])]);
    let directions: Vec<_> = directions.chain(across).collect();
    let mut cells = vec![0.0];
    for x in 0..q[6] as u32 {
        for y in 0..q[7] as u32 {
            for z in 0..q[8] as u32 {
                let at = UVec3::new(x, y, z).as_dvec3();
                let middle = min + (at + 0.5) * size;
                let is_parted = directions.iter().any(|along| {
                    let places = corners.map(|p| along.dot(p - middle));
                    let reach = along.dot(half);
                    places.iter().all(|v| *v > reach) || places.iter().all(|v| *v < -reach)
                });
                if !is_parted {
                    cells.extend(at.to_array());
                    cells[0] += 1.0;
                }
            }
        }
    }
    cells
}

#[test]
fn a_loop_that_ends_too_early_is_named() {
    let found = diagnosed("sah_cost", |q| {
        let nodes: Vec<_> = q[3..].chunks_exact(8).collect();
        let area = |n: &[f64]| {
            let [x, y, z] = [0, 1, 2].map(|axis| n[axis + 3] - n[axis]);
            x * y + y * z + z * x
        };
        let price = |n: &&[f64]| area(n) * if n[7] == 0.0 { q[0] } else { n[7] * q[1] };
        let sum: f64 = nodes[..nodes.len() - 1].iter().map(price).sum();
        Some(vec![sum / area(nodes[0])])
    });
    assert_eq!(found.name, "leaves out the last of the nodes");
}

#[test]
fn a_logarithm_to_another_base_is_named() {
    let found = diagnosed("expose", |q| {
        let factor = (q[3] * 2_f64.log10()).exp();
        Some(q[..3].iter().map(|v| factor * v).collect())
    });
    let told = "takes the value divided by ln 10, as of a logarithm to base 10 for one to base e";
    assert!(found.name.ends_with(told), "{}", found.name);
}

#[test]
fn of_nan_no_function_is_told() {
    let found = found("fresnel", |_| Some(vec![f64::NAN; 3])).expect("it has a name");
    assert!(found.name.contains("NaN"), "{}", found.name);
}

#[test]
fn one_coordinate_for_all_axes_is_named() {
    let found = diagnosed("box_clip", |q| {
        let [mut enter, mut leave] = [q[6], q[7]];
        for axis in 0..3 {
            let [o, d] = [q[axis], q[3 + axis]];
            let [least, greatest] = [q[8 + axis], q[11 + axis]];
            let near = (least - o) / d;
            let far = (greatest - q[0]) / d;
            if d == 0.0 {
                let is_inside = least <= o && o <= greatest;
                leave = if is_inside { leave } else { f64::NEG_INFINITY };
            } else {
                (enter, leave) = (enter.max(near.min(far)), leave.min(near.max(far)));
            }
        }
        Some(if enter <= leave {
            vec![1.0, enter, leave]
        } else {
            vec![0.0]
        })
    });
    let told = "takes for “the start's coordinate in t of the greatest plane” the value of the first round in every round, as that along x for y and z too";
    assert_eq!(found.name, told);
}

#[test]
fn a_line_that_was_copied_and_not_changed_is_named() {
    let found = diagnosed("octree_child", |q| {
        let is_upper = |axis: usize, along: usize| {
            let middle = 0.5 * (q[along] + q[3 + along]);
            f64::from(u8::from(q[6 + axis] >= middle))
        };
        Some(vec![
            is_upper(0, 0) + 2.0 * is_upper(1, 0) + 4.0 * is_upper(2, 2),
        ])
    });
    let told = "takes for “the middle along an axis” the value of the first round in the second too, as that along x for y";
    assert_eq!(found.name, told);
}

#[test]
fn a_line_that_was_copied_from_axis_to_axis_is_named() {
    // Every vector's y stands for its z too.
    let found = diagnosed("triangle_normal", |q| {
        let mut copied = q.to_vec();
        copied.chunks_exact_mut(3).for_each(|v| v[2] = v[1]);
        Some(right("triangle_normal", &copied))
    });
    let told = "takes y for z in every vector, as in a line that was copied";
    assert_eq!(found.name, told);
}

#[test]
fn the_factor_of_estimates_is_told_to_two_digits() {
    for (factor, told) in [(0.043, "returns about 0.04"), (37.3, "returns about 3")] {
        let found = diagnosed("reflected_radiance", |q| {
            let answer = right("reflected_radiance", q);
            Some(answer.into_iter().map(|v| v * factor).collect())
        });
        assert!(found.name.starts_with(told), "{factor}: {}", found.name);
    }
}

#[test]
fn estimates_a_little_too_small_are_of_no_mistake_that_changes_them_less() {
    let found = diagnosed("visible_fraction", |q| {
        let mut answer = right("visible_fraction", q);
        answer[1..].iter_mut().for_each(|v| *v *= 0.97);
        Some(answer)
    });
    assert_eq!(found.name, "returns 0.97 times the answer");
}
