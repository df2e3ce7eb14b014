//! What the race's programs share, and what of it needs no Embree: the cost of trees, and pictures of ratios.

pub mod plot;
pub mod sah;
pub mod trees;
