//! # Environment
//!
//! Light from all around, kept in a picture of all directions: every pixel of it is a light, and the bright ones are asked
//! more often.
//!
//! New: math/piecewise.rs light/environment/mod.rs light/environment/latlong.rs light/environment/cube.rs
//! New: light/environment/angular.rs light/environment/convert.rs
fn main() {}
