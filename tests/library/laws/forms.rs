//! Random shapes, as data: to be built, aimed at, moved, and measured in `f64`.

use glam::{DMat3, DVec3, Mat3, Vec3, vec3};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raybook::accel::{Meshed, list::List};
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook::shape::instance::Instance;
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::{Shape, cuboid::Cuboid, plane::Plane, sphere::Sphere, triangle::Triangle};
use raybook_common::thorough;
use std::sync::Arc;

/// A number of cases, always the same ones.
pub(crate) fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases: thorough(cases),
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(6),
        ..ProptestConfig::default()
    }
}

/// A shape as data.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Form {
    /// Its centre and radius.
    Sphere(Vec3, f32),
    /// A point of it, and its normal.
    Plane(Vec3, Dir3),
    /// Two opposite corners.
    Cuboid(Vec3, Vec3),
    /// Its corners.
    Triangle([Vec3; 3]),
    /// The corners of a tetrahedron: a mesh of four triangles in a list.
    Mesh([Vec3; 4]),
    /// The corners of a tetrahedron that was made elsewhere, smaller and turned, and is placed here.
    Instance([Vec3; 4]),
}

/// p ↦ turn·(scale·p) + shift.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    pub scale: f32,
    pub turn: Mat3,
    pub shift: Vec3,
}

impl Motion {
    pub(crate) fn point(&self, p: Vec3) -> Vec3 {
        self.turn * (self.scale * p) + self.shift
    }

    pub(crate) fn direction(&self, d: Dir3) -> Dir3 {
        Dir3::new(self.turn * *d).expect("a turned direction is one")
    }
}

impl Form {
    pub(crate) fn build(&self) -> Box<dyn Shape> {
        match *self {
            Self::Sphere(center, radius) => Box::new(Sphere::new(center, radius)),
            Self::Plane(point, normal) => Box::new(Plane::through(point, normal)),
            Self::Cuboid(a, b) => Box::new(Cuboid::between(a, b)),
            Self::Triangle([p0, p1, p2]) => Box::new(Triangle::new(p0, p1, p2)),
            Self::Mesh(corners) => Box::new(tetrahedron(corners)),
            Self::Instance(corners) => {
                let (scale, turn) = (
                    2.5,
                    DMat3::from_rotation_x(1.1) * DMat3::from_rotation_y(0.7),
                );
                let to = corners[0].as_dvec3();
                let made = |p: Vec3| (turn.transpose() * (p.as_dvec3() - to) / scale).as_vec3();
                Box::new(Instance {
                    shape: Arc::new(tetrahedron(corners.map(made))),
                    scale: scale as f32,
                    rotation: turn.as_mat3(),
                    translation: corners[0],
                })
            }
        }
    }

    /// The form moved; a cuboid only where the motion leaves its faces square to the axes.
    pub(crate) fn moved(&self, motion: &Motion) -> Self {
        let point = |p| motion.point(p);
        match *self {
            Self::Sphere(center, radius) => Self::Sphere(point(center), motion.scale * radius),
            Self::Plane(p, normal) => Self::Plane(point(p), motion.direction(normal)),
            Self::Cuboid(a, b) => Self::Cuboid(point(a), point(b)),
            Self::Triangle(corners) => Self::Triangle(corners.map(point)),
            Self::Mesh(corners) => Self::Mesh(corners.map(point)),
            Self::Instance(corners) => Self::Instance(corners.map(point)),
        }
    }

    /// A point well inside the shape, for each u in [−1, 1]³; larger ones lead outside.
    pub(crate) fn target(&self, u: Vec3) -> Vec3 {
        match *self {
            Self::Sphere(center, radius) => center + 0.5 * radius * u,
            Self::Plane(point, normal) => point + u - normal.dot(u) * *normal,
            Self::Cuboid(a, b) => 0.5 * (a + b) + 0.45 * (b - a) * u,
            Self::Triangle([p0, p1, p2]) => {
                let b = 1.0 / 3.0 + 0.16 * (u - u.element_sum() / 3.0);
                b.x * p0 + b.y * p1 + b.z * p2
            }
            Self::Mesh([p0, p1, p2, p3]) | Self::Instance([p0, p1, p2, p3]) => {
                let b = 0.25 + 0.08 * u;
                b.x * p0 + b.y * p1 + b.z * p2 + (1.0 - b.element_sum()) * p3
            }
        }
    }

    /// How squarely a ray in this direction meets a flat form: the sine of its angle to it; 1 for a solid one.
    fn squareness(&self, d: Dir3) -> f32 {
        match *self {
            Self::Plane(_, normal) => normal.dot(*d).abs(),
            Self::Triangle([p0, p1, p2]) => (p1 - p0).cross(p2 - p0).normalize().dot(*d).abs(),
            _ => 1.0,
        }
    }

    /// The distance from the point to the shape's surface, in `f64`.
    pub(crate) fn distance(&self, p: Vec3) -> f64 {
        let p = p.as_dvec3();
        match *self {
            Self::Sphere(center, radius) => {
                (p.distance(center.as_dvec3()) - f64::from(radius)).abs()
            }
            Self::Plane(point, n) => {
                let n = n.as_dvec3();
                (n.dot(p - point.as_dvec3()) / n.length()).abs()
            }
            Self::Cuboid(a, b) => {
                let (min, max) = (a.min(b).as_dvec3(), a.max(b).as_dvec3());
                let outside = (min - p).max(p - max);
                let largest = outside.max_element();
                if largest < 0.0 {
                    -largest
                } else {
                    outside.max(DVec3::ZERO).length()
                }
            }
            Self::Triangle([p0, p1, p2]) => to_triangle(p, &Triangle::new(p0, p1, p2)),
            Self::Mesh([p0, p1, p2, p3]) | Self::Instance([p0, p1, p2, p3]) => {
                [[p0, p1, p2], [p0, p2, p3], [p0, p3, p1], [p1, p3, p2]]
                    .map(|[a, b, c]| to_triangle(p, &Triangle::new(a, b, c)))
                    .into_iter()
                    .fold(f64::INFINITY, f64::min)
            }
        }
    }
}

/// Four triangles in a list.
fn tetrahedron(corners: [Vec3; 4]) -> Meshed<List<Facet>> {
    let faces = vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
    let mesh = Mesh::new(corners.to_vec(), faces, None, None).expect("finite corners");
    Meshed::new(mesh, List::new)
}

/// The distance from p to a triangle: to its plane over its inside, else to the nearest edge.
fn to_triangle(p: DVec3, triangle: &Triangle) -> f64 {
    let (e1, e2) = (triangle.e1.as_dvec3(), triangle.e2.as_dvec3());
    let (q, n) = (p - triangle.p0.as_dvec3(), e1.cross(e2));
    let b1 = q.cross(e2).dot(n) / n.length_squared();
    let b2 = e1.cross(q).dot(n) / n.length_squared();
    if b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0 {
        return (q.dot(n) / n.length()).abs();
    }
    let to_edge = |from: DVec3, edge: DVec3| {
        let along = ((q - from).dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        q.distance(from + along * edge)
    };
    to_edge(DVec3::ZERO, e1)
        .min(to_edge(DVec3::ZERO, e2))
        .min(to_edge(e1, e2 - e1))
}

/// A vector in [−1, 1]³.
pub(crate) fn vector() -> impl Strategy<Value = Vec3> {
    let x = || -1.0_f32..=1.0;
    (x(), x(), x()).prop_map(|(x, y, z)| vec3(x, y, z))
}

/// A direction.
pub(crate) fn direction() -> impl Strategy<Value = Dir3> {
    vector().prop_filter_map("no direction", Dir3::new)
}

/// A form of size 1 from where its middle is, four points of [−1, 1]³ around there, and a direction; `None` if it is too thin.
type Made = fn(Vec3, [Vec3; 4], Dir3) -> Option<Form>;

/// One of each.
const FORMS: &[Made] = &[
    |center, [a, ..], _| Some(Form::Sphere(center, 0.1 + a.x.abs())),
    |center, _, normal| Some(Form::Plane(center, normal)),
    |center, [a, b, ..], _| {
        let thick = (b - a).abs().min_element() > 0.05;
        thick.then_some(Form::Cuboid(center + a, center + b))
    },
    |center, [a, b, c, _], _| {
        let thick = (b - a).cross(c - a).length() > 0.05;
        thick.then_some(Form::Triangle([a, b, c].map(|p| center + p)))
    },
    |center, points, _| is_thick(points).then_some(Form::Mesh(points.map(|p| center + p))),
    |center, points, _| is_thick(points).then_some(Form::Instance(points.map(|p| center + p))),
];

/// Whether the tetrahedron is not too thin.
fn is_thick([a, b, c, d]: [Vec3; 4]) -> bool {
    (b - a).cross(c - a).dot(d - a).abs() > 0.05
}

/// A form of size 1, at most 10 from the origin, not too thin.
pub(crate) fn form() -> impl Strategy<Value = Form> {
    let points = [vector(), vector(), vector(), vector()];
    let parts = (prop::sample::select(FORMS), vector(), points, direction());
    parts.prop_filter_map("too thin", |(made, center, points, normal)| {
        made(10.0 * center, points, normal)
    })
}

/// A form and a ray towards its target for a u in [−reach, reach]³, not too grazing.
pub(crate) fn aimed(reach: f32) -> impl Strategy<Value = (Form, Ray)> {
    (form(), vector(), direction(), 0.1_f32..20.0).prop_filter_map(
        "too grazing",
        move |(form, u, away, distance)| {
            let target = form.target(reach * u);
            let origin = target + distance * *away;
            let direction = Dir3::new(target - origin)?;
            (form.squareness(direction) > 0.02).then_some((form, Ray::new(origin, direction)))
        },
    )
}
