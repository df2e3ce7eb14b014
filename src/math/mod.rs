//! Floor 0: directions, rays, intervals, boxes, and the few equations they need.
//!
//! Vectors are glam's [`Vec2`](glam::Vec2) and [`Vec3`](glam::Vec3), in `f32`. Lengths are metres.

pub mod aabb;
pub mod basis;
pub mod dir3;
pub mod domain;
pub mod interval;
pub mod pcg;
pub mod piecewise;
pub mod quadratic;
pub mod ray;
pub mod slab;
