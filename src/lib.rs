//! raybook: a ray-tracing course that you can run.
//!
//! Each lecture topic is a chapter: a small binary in `chapters/`, a page of the book, and a few files of this library.
//!
//! # Conventions
//!
//! The world is right-handed, y points up, lengths are metres, numbers are `f32`. A [`Dir3`](math::dir3::Dir3) has
//! length 1, so a ray's parameter t is a distance. A miss is `None`. Radiance is an [`Rgb`](image::rgb::Rgb), linear and
//! without an upper limit. Every random number follows from a seed: the same seed gives the same picture, bit for bit,
//! whatever the number of threads. A path names its file: `shape::sphere::Sphere` is in `src/shape/sphere.rs`.
//!
//! # The map of floors
//!
//! A module uses only modules on lower floors, or to its left on its own (`tests/architecture.rs` reads this table and
//! checks).
//!
//! | floor | modules |
//! |---|---|
//! | 0 | threads, math |
//! | 1 | image |
//! | 2 | shape, sample |
//! | 3 | accel |
//! | 4 | light, material, scene |
//! | 5 | camera |
//! | 6 | render |

#![warn(unreachable_pub, missing_debug_implementations)]

pub mod accel;
pub mod camera;
pub mod image;
pub mod inside;
pub mod light;
pub mod material;
pub mod math;
pub mod render;
pub mod sample;
pub mod scene;
pub mod shape;
mod threads;
