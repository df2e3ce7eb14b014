//! Which shapes a cell or a node can hold.

use crate::accel::list::List;
use crate::math::aabb::Aabb;
use crate::shape::Shape;

/// The largest coordinate of a box that a structure works with, in metres: its products, such as areas, stay below the
/// largest `f32`, 3.4e38.
const LARGEST: f32 = 1e18;

/// The shapes with a finite box, for a structure to sort, and all others, such as planes, in a list to be searched beside it.
pub(super) fn bounded<S: Shape>(shapes: Vec<S>) -> (Vec<S>, List<S>) {
    let (bounded, unbounded) = shapes
        .into_iter()
        .partition(|shape| is_bounded(&shape.bounds()));
    (bounded, List::new(unbounded))
}

fn is_bounded(bounds: &Aabb) -> bool {
    let Aabb { min, max } = *bounds;
    min.cmple(max).all() && min.min_element() >= -LARGEST && max.max_element() <= LARGEST
}
