//! Floor 2: from uniform random numbers to points and directions.

pub mod hemisphere;
