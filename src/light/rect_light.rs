//! The rectangular light.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let lamp = RectLight::new(vec3(-1.0, 3.0, -0.5), vec3(2.0, 0.0, 0.0), vec3(0.0, 0.0, 1.0), Rgb::WHITE);
//! assert_eq!(lamp.area(), 2.0);
//! assert!(lamp.sample(Vec3::ZERO, vec2(0.5, 0.5)).is_some()); // it shines downwards
//! assert!(lamp.sample(vec3(0.0, 5.0, 0.0), vec2(0.5, 0.5)).is_none()); // its back is dark
//! ```

use crate::image::rgb::Rgb;
use crate::light::extent::{LightSampling, emit, per_steradian, shine};
use crate::light::{Emitted, Light, LightHit, LightSample};
use crate::math::{dir3::Dir3, interval::Interval, ray::Ray};
use glam::{DVec3, Vec2, Vec3};

/// A rectangle that shines to the side where its normal a × b points, with the same radiance from all points in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectLight {
    corner: Vec3,
    a: Vec3,
    b: Vec3,
    normal: Dir3,
    area: f32,
    sides: Option<Sides>,
    radiance: Rgb,
    choose: LightSampling,
}

/// The axes and side lengths of a rectangle, which do not depend on the viewer; a rectangle without area has none.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sides {
    /// Unit vectors along a, along b, and along the normal of the dark side.
    axes: [DVec3; 3],
    /// |a| and |b|, in metres.
    lengths: [f64; 2],
}

/// The smallest solid angle, in steradians, over which points are chosen. A smaller one, as a sum of four terms, has lost more
/// than 8 of its 16 digits; but then the rectangle looks so small that choosing by area is as good.
const LEAST: f64 = 1e-8;

impl RectLight {
    /// A rectangle from a corner and two sides, in metres, of the given `radiance`, in W·m⁻²·sr⁻¹; only the part of `b` that is
    /// perpendicular to `a` counts. Points are chosen by area.
    ///
    /// A rectangle without area sheds no light.
    pub fn new(corner: Vec3, a: Vec3, b: Vec3, radiance: Rgb) -> Self {
        let b = b - b.project_onto_normalized(a.normalize_or_zero());
        Self {
            corner,
            a,
            b,
            normal: Dir3::new_or(a.cross(b), Dir3::Y),
            area: a.length() * b.length(),
            sides: Sides::of(a.as_dvec3(), b.as_dvec3()),
            radiance,
            choose: LightSampling::ByArea,
        }
    }

    /// The same light, with its points chosen by `choose`.
    #[must_use]
    pub fn choosing(self, choose: LightSampling) -> Self {
        Self { choose, ..self }
    }

    /// The point corner + u.x·a + u.y·b, for u in [0, 1]².
    pub fn point(&self, u: Vec2) -> Vec3 {
        self.corner + u.x * self.a + u.y * self.b
    }

    /// |a|·|b|, in square metres.
    pub fn area(&self) -> f32 {
        self.area
    }

    // ANCHOR: sample_rect
    /// The point p = corner + u.x·a + u.y·b, uniform over the area A = |a|·|b|: the density per area is 1/A.
    ///
    /// `None` if `at` is behind the light or in its plane.
    fn sample_area(&self, at: Vec3, u: Vec2) -> Option<LightSample> {
        let r = self.corner + u.x * self.a + u.y * self.b - at;
        let pdf = per_steradian(1.0 / self.area, r, self.normal);
        shine(Dir3::new(r)?, r.length(), self.radiance, pdf)
    }
    // ANCHOR_END: sample_rect

    /// The rectangle as seen from `at`, for points chosen by solid angle; `None` if they are chosen by area.
    fn view(&self, at: Vec3) -> Option<View> {
        let by_solid_angle = self.choose == LightSampling::BySolidAngle;
        let view = by_solid_angle.then(|| View::from(self, at)).flatten();
        view.filter(|view| view.solid_angle >= LEAST)
    }
}

impl Light for RectLight {
    fn sample(&self, at: Vec3, u: Vec2) -> Option<LightSample> {
        let Some(view) = self.view(at) else {
            return self.sample_area(at, u);
        };
        let r = view.sample(u).as_vec3();
        let pdf = 1.0 / view.solid_angle as f32;
        shine(Dir3::new(r)?, r.length(), self.radiance, pdf)
    }

    fn seen(&self, ray: &Ray, farthest: f32) -> Option<LightHit> {
        let cosine = -ray.direction.dot(*self.normal);
        let t = (ray.origin - self.corner).dot(*self.normal) / cosine;
        if cosine <= 0.0 || !Interval::AHEAD.contains(t) || t > farthest {
            return None;
        }
        let p = ray.at(t) - self.corner;
        let inside = |side: Vec3| (0.0..=side.length_squared()).contains(&p.dot(side));
        if !(inside(self.a) && inside(self.b)) {
            return None;
        }
        let pdf = self.view(ray.origin).map_or_else(
            || per_steradian(1.0 / self.area, t * *ray.direction, self.normal),
            |view| 1.0 / view.solid_angle as f32,
        );
        Some(LightHit {
            t,
            radiance: self.radiance,
            pdf,
        })
    }

    /// From a point that is uniform over the area, by [`emit`]; `None` if there is no area.
    fn emit(&self, place: Vec2, direction: Vec2) -> Option<Emitted> {
        let at = self.point(place);
        let photon = emit(at, self.normal, self.area, self.radiance, direction);
        (self.area > 0.0).then_some(photon)
    }
}

impl Sides {
    fn of(a: DVec3, b: DVec3) -> Option<Self> {
        let (along, across) = (a.try_normalize()?, b.try_normalize()?);
        Some(Self {
            axes: [along, across, -along.cross(across)],
            lengths: [a.length(), b.length()],
        })
    }
}

/// A rectangle in coordinates with the viewer at the origin: x and y run along the sides, and the rectangle's plane is z = h.
///
/// Numbers are `f64`, because the solid angle of a small rectangle is a small difference of angles. Below, the plumb line is the
/// perpendicular from the viewer to the plane, h long.
struct View {
    axes: [DVec3; 3],
    x: [f64; 2],
    y: [f64; 2],
    h: f64,
    /// s(y) of both sides across: s₀ and s₁.
    sines: [f64; 2],
    /// The signed solid angle of the strip from the plumb line to the side at `x[0]`.
    before: f64,
    /// Ω, in steradians.
    solid_angle: f64,
}

impl View {
    /// `None` if `at` is behind the light or in its plane, or if the rectangle has no area.
    fn from(light: &RectLight, at: Vec3) -> Option<Self> {
        let Sides { axes, lengths } = light.sides?;
        let corner = (light.corner - at).as_dvec3();
        let (x, y, h) = (
            corner.dot(axes[0]),
            corner.dot(axes[1]),
            corner.dot(axes[2]),
        );
        if h <= 0.0 || h.is_nan() {
            return None;
        }
        let (x, y) = ([x, x + lengths[0]], [y, y + lengths[1]]);
        let sines = [sine(y[0], h), sine(y[1], h)];
        let before = strip(sine(x[0], h), sines);
        Some(Self {
            axes,
            x,
            y,
            h,
            sines,
            before,
            solid_angle: strip(sine(x[1], h), sines) - before,
        })
    }

    /// The vector to a point of the rectangle, uniform over the solid angle Ω (Ureña, Fajardo and King, "An area-preserving
    /// parametrization for spherical rectangles", 2013).
    ///
    /// First, x is chosen so that the part of the rectangle up to x has the solid angle u.x·Ω. With φ the solid angle from the
    /// plumb line to x, the equation asin(s·s₁) − asin(s·s₀) = φ has the solution s = sin φ/√(s₀² − 2 s₀ s₁ cos φ + s₁²). Here
    /// s = s(x), and s₀ and s₁ are the sines of the sides across. Then y is chosen on the line at x, at the distance
    /// d = √(x² + h²): there the sine of the angle is uniform.
    fn sample(&self, u: Vec2) -> DVec3 {
        let back = |s: f64, d: f64| d * s / (1.0 - s * s).max(0.0).sqrt();
        let (u, [s0, s1]) = (u.as_dvec2(), self.sines);
        let phi = self.before + u.x * self.solid_angle;
        let s = phi.sin() / (s0 * s0 - 2.0 * s0 * s1 * phi.cos() + s1 * s1).sqrt();
        let x = back(s, self.h).clamp(self.x[0], self.x[1]);
        let d = (x * x + self.h * self.h).sqrt();
        let (low, high) = (sine(self.y[0], d), sine(self.y[1], d));
        let y = back(low + u.y * (high - low), d).clamp(self.y[0], self.y[1]);
        x * self.axes[0] + y * self.axes[1] + self.h * self.axes[2]
    }
}

// ANCHOR: rect_solid_angle
/// s(v) = v/√(v² + h²): the sine of the angle between the plumb line, h long, and the line from the viewer to v.
fn sine(v: f64, h: f64) -> f64 {
    v / (v * v + h * h).sqrt()
}

/// The solid angle, in steradians, of the strip between the plumb line and x, from the sines of x and of the sides across.
///
/// The rectangle from the foot of the plumb line to (x, y) has the solid angle asin(s(x)·s(y)). The strip is the difference of
/// two such rectangles, and the whole light is the difference of two strips.
fn strip(x: f64, [low, high]: [f64; 2]) -> f64 {
    (x * high).asin() - (x * low).asin()
}
// ANCHOR_END: rect_solid_angle
