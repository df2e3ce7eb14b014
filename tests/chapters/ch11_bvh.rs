//! Chapter 11: the bounding volume hierarchy.

mod agreement;
mod builders;
mod scenes;
mod search;

use raybook::accel::bvh::build::Method;

/// All builders.
pub(crate) const METHODS: [Method; 6] = [
    Method::Median,
    Method::Middle,
    Method::Sweep,
    Method::Binned,
    Method::Fine,
    Method::BottomUp,
];
