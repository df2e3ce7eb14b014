//! Slips in structures, of which many answers are right.

use super::function::{diagnosed, told};

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
fn a_condition_that_is_not_asked_is_told_before_a_value_with_which_it_never_holds() {
    let found = diagnosed("bvh_build", |q| {
        let mut free = q.to_vec();
        free[0] = 6.0;
        Some(told("bvh_build", &free))
    });
    let told = "never takes it into account when a leaf would have more boxes than `most`";
    assert_eq!(found.name, told);
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

#[test]
fn an_end_that_is_ignored_is_named() {
    let found = diagnosed("bvh_closest", |q| {
        let mut endless = q.to_vec();
        endless[7] = f64::INFINITY;
        Some(told("bvh_closest", &endless))
    });
    assert_eq!(found.name, "ignores the interval's max");
}
