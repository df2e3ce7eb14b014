//! Described scenes as rows.

use crate::record::{choice_of, row_of};
use glam::Vec3;
use raybook::image::rgb::Rgb;
use raybook::light::point::PointLight;
use raybook::material::{mirror::Mirror, phong::Phong};
use raybook::math::dir3::Dir3;
use raybook::scene::description::{Backdrop, Clear, Corners, Description, Form, Matter, Object};
use raybook::shape::{plane::Plane, sphere::Sphere};

row_of!(Description {
    /// i_a: the light that arrives from everywhere, radiance in W·m⁻²·sr⁻¹.
    ambient: Rgb,
    /// What a ray sees that meets nothing.
    backdrop: Backdrop,
    /// The point lights.
    lamps: Vec<PointLight>,
    /// The things.
    objects: Vec<Object>,
});

row_of!(Backdrop {
    /// The radiance straight below, direction −y, in W·m⁻²·sr⁻¹.
    below: Rgb,
    /// The radiance straight above, direction +y, in W·m⁻²·sr⁻¹; in between it follows the direction's y evenly.
    above: Rgb,
});

row_of!(PointLight {
    /// The position, in metres.
    position: Vec3,
    /// I: the radiant intensity, in W/sr.
    intensity: Rgb,
});

row_of!(Object {
    /// The shape.
    form: Form,
    /// The material.
    matter: Matter,
});

choice_of!(Form {
    "sphere": Sphere(Sphere),
    "plane": Plane(Plane),
    "triangle": Triangle(Corners),
});

row_of!(Sphere {
    /// The centre, in metres.
    center: Vec3,
    /// The radius, in metres.
    radius: f32,
});

row_of!(Plane {
    /// n: perpendicular to the plane, to its outside.
    normal: Dir3,
    /// The plane holds all p with n·p = offset, in metres.
    offset: f32,
});

row_of!(Corners {
    /// The first corner, in metres.
    p0: Vec3,
    /// The second corner, in metres.
    p1: Vec3,
    /// The third corner, in metres; seen from outside the three run counter-clockwise.
    p2: Vec3,
});

choice_of!(Matter {
    "phong": Phong(Phong),
    "mirror": Mirror(Mirror),
    "glass": Glass(Clear),
});

row_of!(Phong {
    /// k_a: the share of the ambient light that is reflected, without a unit.
    ambient: Rgb,
    /// k_d: the diffuse coefficient, per steradian.
    diffuse: Rgb,
    /// k_s: the specular coefficient, per steradian.
    specular: Rgb,
    /// α: the highlight's exponent, without a unit.
    exponent: f32,
});

row_of!(Mirror {
    /// The share of the light that is reflected, without a unit.
    share: Rgb,
});

row_of!(Clear {
    /// n: the index of refraction, without a unit.
    index: f32,
});
