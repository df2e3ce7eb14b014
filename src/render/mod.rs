//! Floor 6: from rays to a picture.
//!
//! ```
//! use raybook::prelude::*;
//!
//! // A picture of a floor under a white sky. The floor shows its albedo.
//! let floor = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Lambert { albedo: Rgb::gray(0.5) });
//! let scene = Scene::new(vec![floor], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
//! let camera = Pinhole::look_at(Vec3::Y, -Vec3::Z, Vec3::Y, focal_length(30.0), 1.0)?;
//! let picture = Film::new(4, 4, 4).render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
//! assert!(picture.pixels().iter().all(|pixel| (pixel.g - 0.5).abs() < 1e-4));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod adaptive;
pub mod budget;
pub mod caustics;
pub mod clamped;
pub mod cone;
pub mod curved;
mod disc;
pub mod film;
pub mod followed;
mod gather;
pub mod glints;
pub mod guides;
mod lobes;
pub mod local;
pub mod mis;
pub mod needs_more;
pub mod path;
pub mod photons;
pub mod refine;
pub mod reflection;
pub mod sampler;
pub mod shadow;
pub mod soft_shadow;
pub mod supersample;
pub mod trace;
pub mod whitted;
