//! A scene: things of some material, and lights.

use crate::accel::Accel;
use crate::accel::bvh::{Bvh, build::Method};
use crate::image::rgb::Rgb;
use crate::light::Light;
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape, Surface};
use std::fmt;

/// Things and lights; M is what the things are made of: `dyn Material` for Whitted's way of tracing.
pub struct Scene<M: ?Sized> {
    things: Bvh<Thing<M>>,
    /// What shines.
    pub lights: Vec<Box<dyn Light>>,
    /// i_a: light from everywhere, in W·m⁻²·sr⁻¹: what the lights do not account for.
    pub ambient: Rgb,
    /// What a ray that meets nothing sees.
    pub backdrop: fn(&Ray) -> Rgb,
}

/// A shape and what it is made of.
pub struct Thing<M: ?Sized> {
    /// The shape.
    pub shape: Box<dyn Shape>,
    /// The material.
    pub material: Box<M>,
}

/// What a ray sees first.
pub struct Seen<'a, M: ?Sized> {
    /// How far away it is, in metres.
    pub t: f32,
    /// The surface.
    pub surface: Surface,
    /// What it is made of.
    pub material: &'a M,
}

impl<M: ?Sized + Send + Sync> fmt::Debug for Scene<M> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Scene")
            .field("lights", &self.lights.len())
            .field("ambient", &self.ambient)
            .finish_non_exhaustive()
    }
}

impl<M: ?Sized> fmt::Debug for Thing<M> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Thing")
            .field("bounds", &self.shape.bounds())
            .finish_non_exhaustive()
    }
}

impl<M: ?Sized> fmt::Debug for Seen<'_, M> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Seen")
            .field("t", &self.t)
            .field("surface", &self.surface)
            .finish_non_exhaustive()
    }
}

impl<M: ?Sized + Send + Sync> Scene<M> {
    /// A scene of things and lights, without ambient light, before a black backdrop.
    ///
    /// Things are few, so that the tree over them may be built by the method that takes longest and gives the best one.
    pub fn new(things: Vec<Thing<M>>, lights: Vec<Box<dyn Light>>) -> Self {
        Self {
            things: Bvh::build(things, Method::BottomUp),
            lights,
            ambient: Rgb::BLACK,
            backdrop: |_| Rgb::BLACK,
        }
    }

    /// The scene in ambient light, before a backdrop.
    #[must_use]
    pub fn surrounded_by(self, ambient: Rgb, backdrop: fn(&Ray) -> Rgb) -> Self {
        Self {
            ambient,
            backdrop,
            ..self
        }
    }

    /// The first surface along a ray.
    pub fn closest(&self, ray: &Ray) -> Option<Seen<'_, M>> {
        let (thing, hit) = self.things.closest(ray, Interval::AHEAD)?;
        Some(Seen {
            t: hit.t,
            surface: thing.shape.surface(ray, &hit),
            material: &*thing.material,
        })
    }

    /// Whether anything is in the way on a stretch of a ray.
    pub fn blocks(&self, ray: &Ray, within: Interval) -> bool {
        self.things.any(ray, within)
    }
}

impl<M: ?Sized> Thing<M> {
    /// A shape of a material.
    pub fn new(shape: impl Shape + 'static, material: Box<M>) -> Self {
        Self {
            shape: Box::new(shape),
            material,
        }
    }
}

impl<M: ?Sized + Send + Sync> Shape for Thing<M> {
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
