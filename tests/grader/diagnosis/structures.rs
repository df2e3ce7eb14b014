//! Slips in structures, of which many answers are right.

use super::function::{diagnosed, right, told};

#[test]
fn places_for_numbers_in_the_order_of_a_tree_are_named() {
    let found = diagnosed("bvh_build", |q| {
        let mut tree = told("bvh_build", q);
        let boxes = q[1] as usize;
        let order = tree.len() - boxes..;
        (0..)
            .zip(&mut tree[order])
            .for_each(|(place, number)| *number = f64::from(place));
        Some(tree)
    });
    let told = "forgets to write the boxes' own numbers into the order, not places in it";
    assert_eq!((&*found.name, found.certain), (told, false));
}

#[test]
fn a_condition_that_is_not_asked_is_named() {
    let found = diagnosed("bvh_build", |q| {
        let mut free = q.to_vec();
        free[0] = 6.0;
        Some(told("bvh_build", &free))
    });
    let told = "ignores how many boxes a leaf may have";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn an_axis_along_which_nothing_is_asked_is_named() {
    let found = diagnosed("octree_build", |q| {
        let mut flat = q.to_vec();
        let (root, shapes) = flat.split_at_mut(10);
        for shape in shapes.chunks_exact_mut(6) {
            (shape[2], shape[5]) = (root[2], root[5]);
        }
        Some(told("octree_build", &flat))
    });
    let told = "leaves out the last of the axes along which a shape reaches a child";
    assert_eq!(found.name, told);
}

/// A node of an octree's answer: whether it has children, its number, where its children or names begin, and how many names it has; and the names.
type Begin = fn(inner: bool, node: f64, first: f64, count: f64, names: &[f64]) -> f64;

#[test]
fn nodes_of_an_octree_that_begin_elsewhere_are_named() {
    let behind: Begin = |inner, _, first, count, _| if inner { first } else { first + count };
    let late: Begin = |inner, _, first, count, _| {
        if !inner && count > 0.0 {
            first + 1.0
        } else {
            first
        }
    };
    let at_last: Begin = |inner, _, first, count, _| {
        if !inner && count > 0.0 {
            first + count - 1.0
        } else {
            first
        }
    };
    let at_0: Begin = |inner, _, first, _, _| if inner { first } else { 0.0 };
    let first_shape: Begin = |inner, _, first, count, names| {
        if !inner && count > 0.0 {
            names[first as usize]
        } else {
            first
        }
    };
    let number_of_node: Begin = |inner, node, first, _, _| if inner { first } else { node };
    let last_child: Begin = |inner, _, first, _, _| if inner { first + 7.0 } else { first };
    let distance: Begin = |inner, node, first, _, _| if inner { first - node } else { first };
    for (begin, told) in [
        (
            behind,
            "takes the end of a leaf's part of the list of names for its beginning",
        ),
        (late, "counts the places of the list of names from 1"),
        (
            at_last,
            "gives a leaf the place of its last name, not that of its first",
        ),
        (
            at_0,
            "lets every leaf begin at the start of the list of names",
        ),
        (
            first_shape,
            "writes the number of a leaf's first shape where that name's place in the list belongs",
        ),
        (
            number_of_node,
            "lets leaves begin at places of the list of names that are not theirs",
        ),
        (
            last_child,
            "gives a node the number of its last child, not that of its first",
        ),
        (
            distance,
            "tells how far behind a node its first child is, not its number",
        ),
    ] {
        let found = diagnosed("octree_build", |q| {
            let mut tree = right("octree_build", q);
            let count = tree[0] as usize;
            let (nodes, names) = tree.split_at_mut(1 + 3 * count);
            for (i, node) in (0..).zip(nodes[1..].chunks_exact_mut(3)) {
                node[1] = begin(node[0] == 1.0, f64::from(i), node[1], node[2], &names[1..]);
            }
            Some(tree)
        });
        // A step that goes wrong so is its cause, and told before it.
        let mut names = found.also.iter().map(|also| &*also.name);
        let is_told = found.name == told || names.any(|name| name == told);
        assert!(is_told, "{told}: {found:?}");
    }
}

#[test]
fn an_end_that_is_ignored_is_named() {
    let found = diagnosed("bvh_closest", |q| {
        let mut endless = q.to_vec();
        endless[7] = f64::INFINITY;
        Some(told("bvh_closest", &endless))
    });
    assert_eq!(found.name, "ignores the interval's max");
}

#[test]
fn cells_that_are_looked_for_in_the_plane_between_two_are_named() {
    // A visit is a cell and the distance at which the ray leaves it: 0 for the place where it enters, 1 for that where it leaves.
    for (end, told) in [
        (0, "at which the ray enters it"),
        (1, "at which the ray leaves it"),
    ] {
        let found = diagnosed("grid_walk", |q| {
            let mut visits = right("grid_walk", q);
            let leaves: Vec<_> = visits[1..].chunks(4).map(|visit| visit[3]).collect();
            for (i, visit) in visits[1..].chunks_mut(4).enumerate().skip(1) {
                let t = leaves[i - 1 + end];
                for axis in 0..3 {
                    let (min, cell, n) = (q[axis], q[3 + axis], q[6 + axis]);
                    let place = (q[9 + axis] + t * q[12 + axis] - min) / cell;
                    visit[axis] = place.floor().clamp(0.0, n - 1.0);
                }
            }
            Some(visits)
        });
        assert!(found.name.contains(told), "{}", found.name);
    }
}
