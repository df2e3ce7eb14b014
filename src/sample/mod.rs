//! Floor 2: from uniform random numbers to points and directions.
//!
//! ```
//! use glam::{Vec2, vec2};
//! use raybook::math::pcg;
//! use raybook::sample::{disk::concentric_disk, pattern::jittered::jittered};
//!
//! // The mean of |p|² over a disc is 1/2. An even pattern of the square is an even pattern of the disc.
//! let points = jittered(16, 16, &mut pcg::stream(1, 0));
//! let mean = points.iter().map(|u| concentric_disk(*u).length_squared()).sum::<f32>() / 256.0;
//! assert!((mean - 0.5).abs() < 0.01);
//! ```

pub mod disk;
pub mod even;
pub mod filter;
pub mod hemisphere;
pub mod padded;
pub mod pattern;
pub mod polygon;
