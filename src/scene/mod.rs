//! Floor 4: a scene, how a file describes one, and the scenes that chapters share.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::scene::cornell;
//!
//! // The published camera looks through the open front to the white back wall.
//! let scene = cornell::cornell_box();
//! let ray = Ray::new(cornell::EYE, Dir3::Z);
//! let seen = scene.closest(&ray).expect("a block or the back wall");
//! assert!(seen.t > 0.8 && seen.t < 0.8 + 0.56); // the box is 0.56 m deep, 0.8 m ahead
//! ```

pub mod accretion_disc;
pub mod backdrop;
pub mod cornell;
pub mod description;
pub mod four_scenes;
#[cfg(feature = "files")]
pub mod model;
pub mod noise;
pub mod plates;
pub mod soup;
pub mod stadium;
pub mod terrain;
pub mod world;
