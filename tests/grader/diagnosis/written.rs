//! Numbers that are written into a program, the order of things, a value times a number; and what all answers tell together.

use super::function::{diagnosed, right, told};
use glam::{DVec2, DVec3, IVec2};
use raybook_grader::cases;
use raybook_grader::examine::{Case, visible_rng};
use raybook_grader::together::Bounds;
use std::collections::VecDeque;
use std::f64::consts::TAU;

/// A binary tree made wide, with this number of children at most.
fn collapsed(q: &[f64], most: usize) -> Vec<f64> {
    let nodes: Vec<_> = q[1..].chunks_exact(8).collect();
    let is_branch = |i: &usize| nodes[*i][7] == 0.0;
    let below = |i: usize| [nodes[i][6] as usize, nodes[i][6] as usize + 1];
    let area = |i: &usize| {
        let size = DVec3::from_slice(&nodes[*i][3..]) - DVec3::from_slice(nodes[*i]);
        size.dot(DVec3::new(size.y, size.z, size.x))
    };
    let mut due: Vec<_> = (0..nodes.len().min(1)).filter(is_branch).collect();
    let (mut families, mut count) = (Vec::new(), 0.0);
    while let Some(branch) = due.pop() {
        let mut family = below(branch).to_vec();
        while family.len() < most {
            let branches = family.iter().copied().filter(is_branch);
            let Some(opened) = branches.max_by(|a, b| area(a).total_cmp(&area(b))) else {
                break;
            };
            family.retain(|i| *i != opened);
            family.extend(below(opened));
        }
        due.extend(family.iter().copied().filter(is_branch));
        families.extend([branch as f64, family.len() as f64]);
        families.extend(family.iter().map(|i| *i as f64));
        count += 1.0;
    }
    [vec![count], families].concat()
}

#[test]
fn a_number_in_the_program_is_named() {
    let found = diagnosed("collapse", |q| Some(collapsed(q, 5)));
    let told = "takes 5 for the most children of a branch, which is 8";
    assert_eq!(found.name, told);
}

#[test]
fn what_the_steps_call_a_mistake_of_the_list_is_no_rival_of_it() {
    let found = diagnosed("collapse", |q| Some(collapsed(q, 7)));
    let told = "stops at seven children";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_leaf_of_two_where_a_cut_pays_is_named() {
    let found = diagnosed("bvh_build", |q| {
        // Where a leaf may hold two, branches of two single boxes are leaves.
        let [rows, order] = again(&told("bvh_build", q), false, q[0] >= 2.0);
        Some(tree_of(&rows, &order))
    });
    let told = "lets a branch cost two tests, one for each child's box";
    assert_eq!(found.name, told);
}

#[test]
fn a_tree_that_is_built_level_by_level_is_followed_too() {
    let found = diagnosed("bvh_build", |q| {
        let [mut rows, order] = again(&told("bvh_build", q), true, false);
        let leaves = rows.chunks_exact_mut(8).filter(|row| row[7] > 0.0);
        leaves.for_each(|row| row[7] += 1.0);
        Some(tree_of(&rows, &order))
    });
    let told = "goes wrong at the step “the number of a leaf's boxes”: takes the value plus 1";
    assert_eq!(found.name, told);
}

/// A tree from the rows of its nodes and its order.
fn tree_of(rows: &[f64], order: &[f64]) -> Vec<f64> {
    let counts = [rows.len() as f64 / 8.0, order.len() as f64];
    [&counts[..1], rows, &counts[1..], order].concat()
}

/// The same tree, level by level or depth first: the rows of its nodes, and its order. Branches of two single boxes may be made leaves.
fn again(tree: &[f64], by_levels: bool, joins: bool) -> [Vec<f64>; 2] {
    let count = tree[0] as usize;
    let nodes: Vec<_> = tree[1..=8 * count].chunks_exact(8).collect();
    let order = &tree[8 * count + 2..];
    let (mut rows, mut names) = (nodes.get(..1).unwrap_or(&[]).concat(), Vec::new());
    let mut due = VecDeque::from_iter((count > 0).then_some((0, 0)));
    while let Some((from, to)) = due.pop_front() {
        let (row, last) = (nodes[from], rows.len() / 8);
        rows[8 * to..8 * to + 8].copy_from_slice(row);
        let [first, size] = [row[6] as usize, row[7] as usize];
        let below = [first, first + 1];
        let boxes = if size > 0 {
            order[first..first + size].to_vec()
        } else if joins && below.iter().all(|i| nodes[*i][7] == 1.0) {
            below.map(|i| order[nodes[i][6] as usize]).to_vec()
        } else {
            rows[8 * to + 6] = last as f64;
            rows.extend([0.0; 16]);
            let children = [(first, last), (first + 1, last + 1)].into_iter();
            if by_levels {
                due.extend(children);
            } else {
                children.rev().for_each(|child| due.push_front(child));
            }
            continue;
        };
        rows[8 * to + 6] = names.len() as f64;
        rows[8 * to + 7] = boxes.len() as f64;
        names.extend(boxes);
    }
    [rows, names]
}

#[test]
fn an_order_that_is_wrong_in_one_direction_is_named() {
    let found = diagnosed("two_level_walk", |q| {
        let (mut first, mut begins) = (0.0, Vec::new());
        for n in q[18..].chunks_exact(3) {
            begins.push(first);
            first += n[0] * n[1] * n[2];
        }
        let coarse = |place: &f64| begins.iter().rposition(|begin| begin <= place);
        let mut places = told("two_level_walk", q).split_off(1);
        if q[3] < 0.0 {
            let cells = places.chunk_by(|a, b| coarse(a) == coarse(b));
            let cells: Vec<_> = cells.map(<[f64]>::to_vec).collect();
            places = cells.into_iter().rev().flatten().collect();
        }
        places.insert(0, places.len() as f64);
        Some(places)
    });
    let told = "goes through the coarse cells on the ray's way backwards, but only where `direction` goes down along x";
    assert_eq!(found.name, told);
}

#[test]
fn a_vector_that_is_turned_upwards_is_named() {
    let found = diagnosed("vertex_normals", |q| {
        let count = q[0] as usize;
        let points: Vec<_> = q[1..=3 * count]
            .chunks_exact(3)
            .map(DVec3::from_slice)
            .collect();
        let mut sums = vec![DVec3::ZERO; count];
        for corners in q[3 * count + 2..].chunks_exact(3) {
            let corners = [
                corners[0] as usize,
                corners[1] as usize,
                corners[2] as usize,
            ];
            let [p0, p1, p2] = corners.map(|i| points[i]);
            let normal = (p1 - p0).cross(p2 - p0);
            let up = if normal.z < 0.0 { -normal } else { normal };
            for i in corners {
                sums[i] += up;
            }
        }
        let normals = sums.iter().map(|sum| sum.normalize_or(DVec3::Y).to_array());
        Some([vec![count as f64], normals.flatten().collect()].concat())
    });
    assert!(
        found.name.ends_with("turns it round where z is negative"),
        "{}",
        found.name
    );
}

#[test]
fn a_factor_that_nobody_thought_of_is_fitted() {
    let found = diagnosed("sphere_normal", |q| {
        let [center, p] = [0, 4].map(|at| DVec3::from_slice(&q[at..]));
        Some((p - 0.97 * center).normalize().to_array().to_vec())
    });
    assert_eq!(found.name, "takes 0.97 times center");
}

#[test]
fn no_number_is_fitted_with_which_answers_are_endless() {
    // Turned by arctan 2 clockwise, a right angle too far: the same lattice elsewhere, to which no factor of the spacing leads, but another
    // offset.
    let found = diagnosed("rotated_grid", |q| {
        let (spacing, offset) = (q[0], DVec2::new(q[1], q[2]));
        let turned = |v: DVec2| DVec2::new(v.x + 2.0 * v.y, v.y - 2.0 * v.x) / 5.0_f64.sqrt();
        let reach = (2.0 / spacing) as i32 + 2;
        let steps = (-reach..=reach).flat_map(|i| (-reach..=reach).map(move |j| [i, j]));
        let points =
            steps.map(|step| 0.5 + spacing * turned(IVec2::from(step).as_dvec2() + offset));
        let inside = |p: &DVec2| p.cmpge(DVec2::ZERO).all() && p.cmplt(DVec2::ONE).all();
        let points: Vec<_> = points.filter(inside).map(|p| p.to_array()).collect();
        Some([vec![points.len() as f64], points.concat()].concat())
    });
    assert_eq!(found.name, "exchanges offset.x and offset.y");
    let then: Vec<_> = found.also.iter().map(|also| &*also.name).collect();
    assert_eq!(then[0], "has the sign of offset.y wrong");
    assert!(
        then[1] == "puts the lattice in the wrong place",
        "{found:?}"
    );
}

#[test]
fn a_part_of_the_question_times_any_number_is_named() {
    let found = diagnosed("circle_of_confusion", |q| {
        let mut near = q.to_vec();
        near[2] *= 0.87;
        Some(right("circle_of_confusion", &near))
    });
    assert_eq!(found.name, "takes 0.87 times focus");
}

#[test]
fn children_that_are_numbered_from_one_more_are_named() {
    let found = diagnosed("octree_build", |q| {
        let mut tree = right("octree_build", q);
        let count = tree[0] as usize;
        let nodes = tree[1..=3 * count].chunks_exact_mut(3);
        nodes
            .filter(|node| node[0] == 1.0)
            .for_each(|node| node[1] += 1.0);
        Some(tree)
    });
    let told =
        "goes wrong at the step “the number of a cell's first child”: takes the value plus 1";
    assert_eq!(found.name, told);
}

/// Directions around a normal, with a density of this power of the cosine.
fn around(normal: DVec3, n: u32, power: f64) -> Vec<f64> {
    let x = normal.any_orthonormal_vector();
    let y = normal.cross(x);
    let toward = |i: u32| {
        let u = (f64::from(i) + 0.5) / f64::from(n);
        let phi = TAU * 0.618_034 * (f64::from(i) + 0.5);
        let cosine = (1.0 - u).powf(1.0 / (power + 1.0));
        let sine = (1.0 - cosine * cosine).sqrt();
        (sine * (phi.cos() * x + phi.sin() * y) + cosine * normal).to_array()
    };
    (0..n).flat_map(toward).collect()
}

#[test]
fn a_power_of_the_cosine_that_is_nearly_1_is_wrong() {
    let examiner = cases::find("cosine_hemisphere").expect("it exists");
    let cases = examiner.cases(&mut visible_rng("cosine_hemisphere")).cases;
    let question = |case: &Case| examiner.asked().read_question(&case.question);
    for power in [0.9, 1.0, 1.1] {
        let answered = |case: &Case| {
            let q = question(case).expect("a question");
            let all = around(DVec3::from_slice(&q), q[3] as u32, power);
            let answer = [vec![q[3]], all].concat();
            (q, answer)
        };
        let answers: Vec<_> = cases.iter().map(answered).collect();
        let verdict = examiner.compare_together(&answers, Bounds::CHANCE);
        assert_eq!(verdict.is_ok(), power == 1.0, "{power}: {verdict:?}");
    }
}
