//! Chapter 11: the bounding volume hierarchy.

#[path = "ch11_bvh/agreement.rs"]
mod agreement;
#[path = "ch11_bvh/builders.rs"]
mod builders;
#[path = "ch11_bvh/scenes.rs"]
mod scenes;
#[path = "ch11_bvh/search.rs"]
mod search;

use raybook::accel::bvh::build::Method;

/// All builders.
pub const METHODS: [Method; 6] = [
    Method::Median,
    Method::Middle,
    Method::Sweep,
    Method::Binned,
    Method::Fine,
    Method::BottomUp,
];
