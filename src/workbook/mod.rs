//! Floor 7: the curriculum.

pub mod curriculum;
