//! What most programs that draw a picture use: `use raybook::prelude::*;`.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ball = Thing::new(Sphere::new(Vec3::ZERO, 1.0), Lambert { albedo: Rgb::gray(0.5) });
//! let sky = Environment::new(Image::from_fn(2, 1, |_, _| Rgb::WHITE));
//! let scene = Scene::new(vec![ball], vec![Box::new(sky)]);
//! let camera = Pinhole::look_at(vec3(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y, focal_length(20.0), 1.0)?;
//! let picture = Film::new(3, 3, 64).render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
//! assert!((picture.at(1, 1).g - 0.5).abs() < 0.01); // under a white sky, a surface shows its albedo
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use crate::accel::{Accel, Meshed, bvh::Bvh, list::List, wide_bvh::WideBvh};
pub use crate::camera::aperture::Aperture;
pub use crate::camera::pinhole::{Pinhole, focal_length};
pub use crate::camera::{Camera, thin_lens::ThinLens};
pub use crate::image::{Image, file, mip::MipMap, rgb::Rgb, tone};
pub use crate::light::{Light, directional::DirectionalLight, environment::Environment};
pub use crate::light::{
    extent::LightSampling, point::PointLight, rect_light::RectLight, sphere_light::SphereLight,
};
pub use crate::material::conductor::{Conductor, Metal};
pub use crate::material::glass::{Glass, Medium};
pub use crate::material::image_texture::ImageTexture;
pub use crate::material::{
    Material, ggx::Ggx, lambert::Lambert, mirror::Mirror, phong::Phong, plastic::Plastic,
};
pub use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
pub use crate::render::clamped::Clamped;
pub use crate::render::sampler::{Integrator, Sampler};
pub use crate::render::{film::Film, mis::Strategy, path::Path, whitted::Whitted};
pub use crate::scene::world::{Scene, Thing};
pub use crate::shape::{Hit, Shape, Surface, cuboid::Cuboid, instance::Instance, mesh::Mesh};
pub use crate::shape::{plane::Plane, sphere::Sphere, triangle::Triangle};
pub use glam::{Vec2, Vec3, vec2, vec3};
