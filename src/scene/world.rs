//! A scene: things, which are shapes with materials, and lights.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ball = Thing::new(Sphere::new(Vec3::ZERO, 1.0), Mirror { share: Rgb::WHITE });
//! let scene = Scene::new(vec![ball], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::new(0.2, 0.4, 0.8));
//! let ray = |y| Ray::new(vec3(0.0, y, 5.0), -Dir3::Z);
//! assert_eq!(scene.closest(&ray(0.0)).map(|seen| seen.t), Some(4.0));
//! assert!(scene.closest(&ray(2.0)).is_none()); // it passes above the ball, and finds the backdrop
//! assert_eq!(scene.behind_everything(&ray(2.0)).b, 0.8);
//! ```

use crate::accel::Accel;
use crate::accel::bvh::{Bvh, build::Method};
use crate::image::rgb::Rgb;
use crate::light::Light;
use crate::material::Material;
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape, Surface};
use std::fmt;
use std::sync::Arc;

/// A scene of things and lights, for every integrator.
pub struct Scene {
    things: Bvh<Thing>,
    /// The lights. An environment is a light at infinity.
    pub lights: Vec<Box<dyn Light>>,
    /// i_a: the ambient light, in W·m⁻²·sr⁻¹. Integrators for local illumination use it in place of indirect light.
    pub ambient: Rgb,
    /// The radiance for rays that meet nothing; lights at infinity are added to it.
    pub backdrop: Backdrop,
}

/// The radiance that comes along a ray that meets nothing.
pub type Backdrop = Box<dyn Fn(&Ray) -> Rgb + Send + Sync>;

/// A shape and its material. Several things may share a shape or a material.
#[derive(Clone)]
pub struct Thing {
    /// The shape.
    pub shape: Arc<dyn Shape>,
    /// The material.
    pub material: Arc<dyn Material>,
}

/// The first surface along a ray.
pub struct Seen<'a> {
    /// The distance of the surface, in metres.
    pub t: f32,
    /// The surface.
    pub surface: Surface,
    /// The surface's material.
    pub material: &'a dyn Material,
}

impl fmt::Debug for Scene {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Scene")
            .field("lights", &self.lights.len())
            .field("ambient", &self.ambient)
            .finish_non_exhaustive()
    }
}

impl fmt::Debug for Thing {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Thing")
            .field("bounds", &self.shape.bounds())
            .finish_non_exhaustive()
    }
}

impl fmt::Debug for Seen<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Seen")
            .field("t", &self.t)
            .field("surface", &self.surface)
            .finish_non_exhaustive()
    }
}

impl Scene {
    /// A scene of things and lights, without ambient light, with a black backdrop.
    ///
    /// There are few things, so the tree over them is built by the slowest method, which gives the best tree.
    pub fn new(things: Vec<Thing>, lights: Vec<Box<dyn Light>>) -> Self {
        Self {
            things: Bvh::build(things, Method::BottomUp),
            lights,
            ambient: Rgb::BLACK,
            backdrop: Box::new(|_| Rgb::BLACK),
        }
    }

    /// The scene with this ambient light and this backdrop.
    #[must_use]
    pub fn surrounded_by(
        self,
        ambient: Rgb,
        backdrop: impl Fn(&Ray) -> Rgb + Send + Sync + 'static,
    ) -> Self {
        Self {
            ambient,
            backdrop: Box::new(backdrop),
            ..self
        }
    }

    /// The first surface along a ray; `None` if the ray meets nothing.
    pub fn closest(&self, ray: &Ray) -> Option<Seen<'_>> {
        let (thing, hit) = self.things.closest(ray, Interval::AHEAD)?;
        Some(Seen {
            t: hit.t,
            surface: thing.shape.surface(ray, &hit).seen_along(ray, hit.t),
            material: &*thing.material,
        })
    }

    /// The tree over the things.
    pub(crate) fn things(&self) -> &Bvh<Thing> {
        &self.things
    }

    /// Whether a thing is hit within an interval of a ray.
    pub fn blocks(&self, ray: &Ray, within: Interval) -> bool {
        self.things.any(ray, within)
    }

    /// The radiance for a ray that meets nothing: that of the backdrop plus that of lights at infinity.
    pub fn behind_everything(&self, ray: &Ray) -> Rgb {
        let lights = self.lights.iter();
        let far = lights.filter_map(|light| light.seen(ray, f32::INFINITY));
        let far = far.filter(|hit| hit.t == f32::INFINITY);
        (self.backdrop)(ray) + far.map(|hit| hit.radiance).sum::<Rgb>()
    }
}

impl Thing {
    /// A thing of this shape and this material.
    pub fn new(shape: impl Shape + 'static, material: impl Material + 'static) -> Self {
        Self {
            shape: Arc::new(shape),
            material: Arc::new(material),
        }
    }
}

impl Shape for Thing {
    fn bounds(&self) -> Aabb {
        self.shape.bounds()
    }

    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.shape.hit(ray, within)
    }

    fn blocks(&self, ray: &Ray, within: Interval) -> bool {
        self.shape.blocks(ray, within)
    }

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.shape.surface(ray, hit)
    }
}
