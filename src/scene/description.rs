//! A scene described by numbers only: a list that fits on one line, in any language.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::scene::description::{Backdrop, Description, Matter, Object};
//!
//! let scene = Description {
//!     ambient: Rgb::BLACK,
//!     backdrop: Backdrop { below: Rgb::BLACK, above: Rgb::WHITE },
//!     lamps: vec![],
//!     objects: vec![Object::sphere(Vec3::ZERO, 1.0, Matter::glass(1.5))],
//! };
//! assert_eq!(scene.backdrop.seen(Dir3::X), Rgb::gray(0.5)); // on the horizon
//! let (_, hit) = scene.nearest(&Ray::new(vec3(0.0, 0.0, 4.0), -Dir3::Z)).expect("the ball");
//! assert_eq!(hit.t, 3.0);
//! ```

use crate::image::rgb::Rgb;
use crate::light::point::PointLight;
use crate::material::{mirror::Mirror, phong::Phong};
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape, Surface, plane::Plane, sphere::Sphere, triangle::Triangle};
use glam::Vec3;

/// A described scene: everything that a ray tracer must know.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// i_a: light from everywhere, in W·m⁻²·sr⁻¹.
    pub ambient: Rgb,
    /// The radiance for rays that meet nothing.
    pub backdrop: Backdrop,
    /// The point lights.
    pub lamps: Vec<PointLight>,
    /// The objects.
    pub objects: Vec<Object>,
}

/// A sky whose radiance depends only on the height of the direction, in W·m⁻²·sr⁻¹.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Backdrop {
    /// Its radiance straight below.
    pub below: Rgb,
    /// Its radiance straight above.
    pub above: Rgb,
}

/// An object: a shape and its material.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its shape.
    pub form: Form,
    /// Its material.
    pub matter: Matter,
}

/// A shape by its kind. All three kinds have an outside, and can be hit from both sides.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// All points p with |p − c| = r.
    Sphere(Sphere),
    /// All points p with n·p = c; n points to the outside.
    Plane(Plane),
    /// The points between three corners; on the outside, the corners are seen counter-clockwise.
    Triangle(Corners),
}

/// The corners of a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Corners {
    /// The first.
    pub p0: Vec3,
    /// The second.
    pub p1: Vec3,
    /// The third.
    pub p2: Vec3,
}

/// A material by its kind.
#[derive(Clone, Debug, PartialEq)]
pub enum Matter {
    /// Ambient, diffuse and specular reflection of the lamps' light.
    Phong(Phong),
    /// A mirror: what the mirrored ray sees, times the mirror's share.
    Mirror(Mirror),
    /// Glass in air: what the mirrored ray and the refracted ray see, with the shares R and 1 − R of Fresnel's equations.
    Glass(Clear),
}

/// A medium that absorbs nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clear {
    /// Index of refraction n: the speed of light in a vacuum over that in the material.
    pub index: f32,
}

impl Backdrop {
    /// The radiance below + (above − below)·(d_y + 1)/2, with d the direction of the ray.
    pub fn seen(&self, direction: Dir3) -> Rgb {
        self.below.lerp(self.above, 0.5 * (direction.y + 1.0))
    }
}

impl Object {
    /// A sphere of some material.
    pub fn sphere(center: Vec3, radius: f32, matter: Matter) -> Self {
        let form = Form::Sphere(Sphere { center, radius });
        Self { form, matter }
    }

    /// The plane n·p = offset of some material.
    pub fn plane(normal: Dir3, offset: f32, matter: Matter) -> Self {
        let form = Form::Plane(Plane { normal, offset });
        Self { form, matter }
    }

    /// A triangle of some material.
    pub fn triangle([p0, p1, p2]: [Vec3; 3], matter: Matter) -> Self {
        let form = Form::Triangle(Corners { p0, p1, p2 });
        Self { form, matter }
    }
}

impl Matter {
    /// Phong's material with k_a = k_d = `colour`, and a white highlight with k_s = `specular`.
    pub fn phong(colour: Rgb, specular: f32, exponent: f32) -> Self {
        Self::Phong(Phong {
            ambient: colour,
            diffuse: colour,
            specular: Rgb::gray(specular),
            exponent,
        })
    }

    /// A mirror.
    pub fn mirror(share: Rgb) -> Self {
        Self::Mirror(Mirror { share })
    }

    /// Glass of some index.
    pub fn glass(index: f32) -> Self {
        Self::Glass(Clear { index })
    }
}

impl Corners {
    fn triangle(&self) -> Triangle {
        Triangle::new(self.p0, self.p1, self.p2)
    }
}

impl Description {
    /// The nearest object ahead on a ray.
    pub fn nearest(&self, ray: &Ray) -> Option<(&Object, Hit)> {
        let objects = self.objects.iter();
        let hits = objects.filter_map(|o| Some((o, o.form.hit(ray, Interval::AHEAD)?)));
        hits.min_by(|(_, a), (_, b)| a.t.total_cmp(&b.t))
    }
}

impl Shape for Form {
    fn bounds(&self) -> Aabb {
        match self {
            Self::Sphere(sphere) => sphere.bounds(),
            Self::Plane(plane) => plane.bounds(),
            Self::Triangle(corners) => corners.triangle().bounds(),
        }
    }

    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        match self {
            Self::Sphere(sphere) => sphere.hit(ray, within),
            Self::Plane(plane) => plane.hit(ray, within),
            Self::Triangle(corners) => corners.triangle().hit(ray, within),
        }
    }

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        match self {
            Self::Sphere(sphere) => sphere.surface(ray, hit),
            Self::Plane(plane) => plane.surface(ray, hit),
            Self::Triangle(corners) => corners.triangle().surface(ray, hit),
        }
    }
}
