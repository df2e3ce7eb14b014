//! The algebra of bounding boxes.

use crate::laws::forms::{config, vector};
use proptest::prelude::*;
use raybook::math::aabb::Aabb;

fn bounds() -> impl Strategy<Value = Aabb> {
    prop::collection::vec(vector(), 0..4).prop_map(Aabb::of)
}

proptest! {
    #![proptest_config(config(2_000))]

    #[test]
    fn the_box_of_points_is_the_smallest_that_holds_them(points in prop::collection::vec(vector(), 1..20)) {
        let bounds = Aabb::of(points.iter().copied());
        prop_assert!(points.iter().all(|&p| bounds.contains(p)), "{bounds:?} holds not all of {points:?}");
        for axis in 0..3 {
            prop_assert!(points.iter().any(|p| p[axis] == bounds.min[axis]), "no point is as low as the box");
            prop_assert!(points.iter().any(|p| p[axis] == bounds.max[axis]), "no point is as high as the box");
        }
    }

    #[test]
    fn union_is_commutative_associative_and_holds_both(a in bounds(), b in bounds(), c in bounds(), p in vector()) {
        let union = a.union(&b);
        prop_assert_eq!(union, b.union(&a), "in either order");
        prop_assert_eq!(union.union(&c), a.union(&b.union(&c)), "whichever two come first");
        prop_assert_eq!(a.union(&a), a, "with itself");
        prop_assert_eq!(a.union(&Aabb::EMPTY), a, "the empty box adds nothing");
        prop_assert_eq!(a.union(&Aabb::EVERYTHING), Aabb::EVERYTHING, "everything is everything");
        prop_assert!(!(a.contains(p) || b.contains(p)) || union.contains(p), "{p} is in one of them");
        prop_assert!(!Aabb::EMPTY.contains(p), "nothing is in the empty box");
    }

    #[test]
    fn union_of_boxes_is_the_box_of_all_points(a in prop::collection::vec(vector(), 0..5), b in prop::collection::vec(vector(), 0..5)) {
        let both = Aabb::of(a.iter().chain(&b).copied());
        prop_assert_eq!(Aabb::of(a).union(&Aabb::of(b)), both);
    }
}
