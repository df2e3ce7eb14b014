//! Floor 2: from uniform random numbers to points and directions.

pub mod disk;
pub mod even;
pub mod filter;
pub mod hemisphere;
pub mod pattern;
pub mod polygon;
