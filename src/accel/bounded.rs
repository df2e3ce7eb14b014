//! Which shapes a cell or a node can hold.

use crate::accel::list::List;
use crate::math::{aabb::Aabb, domain::LARGEST};
use crate::shape::Shape;

/// Splits the shapes in two. Those with a box within the [domain](crate::math::domain) are for a structure to sort; all others,
/// such as planes, are in a list, which is searched beside the structure.
pub(super) fn bounded<S: Shape>(shapes: Vec<S>) -> (Vec<S>, List<S>) {
    let (bounded, unbounded) = shapes
        .into_iter()
        .partition(|shape| is_bounded(&shape.bounds()));
    (bounded, List::new(unbounded))
}

/// Whether a box is within the domain.
pub(super) fn is_bounded(bounds: &Aabb) -> bool {
    let Aabb { min, max } = *bounds;
    min.cmple(max).all() && min.min_element() >= -LARGEST && max.max_element() <= LARGEST
}
