//! Floor 0: directions, rays, intervals, boxes, and the few equations they need.
//!
//! Vectors are glam's [`Vec2`](glam::Vec2) and [`Vec3`](glam::Vec3), in `f32`. Lengths are metres.
//!
//! ```
//! use glam::vec3;
//! use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray, slab};
//!
//! let ray = Ray::new(vec3(0.0, 0.0, -5.0), Dir3::Z);
//! let cube = Aabb::new(vec3(-1.0, -1.0, -1.0), vec3(1.0, 1.0, 1.0));
//! assert_eq!(slab::clip(&cube, &ray, Interval::AHEAD), Some(Interval::new(4.0, 6.0)));
//! ```

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
pub mod whole;
