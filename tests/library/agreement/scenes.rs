//! Scenes that structures dislike: degenerate, coplanar, equal, huge, tiny and no shapes, at scales from 1e-6 to 1e6.

use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;
use raybook::shape::{Hit, Shape, Surface, cuboid::Cuboid, plane::Plane, sphere::Sphere};

/// Shapes, and how large the scene is: its coordinates are a few times `scale` from `center`.
#[derive(Clone, Debug)]
pub(super) struct Scene<S> {
    pub shapes: Vec<S>,
    pub scale: f32,
    pub center: Vec3,
}

impl<S: Shape> Scene<S> {
    /// The largest coordinate of all.
    pub(super) fn largest(&self) -> f32 {
        let of_shape = |shape: &S| {
            let Aabb { min, max } = shape.bounds();
            min.abs().max(max.abs()).max_element()
        };
        let coordinates = self.shapes.iter().map(of_shape);
        coordinates
            .filter(|largest| largest.is_finite())
            .fold(self.scale, f32::max)
    }
}

/// Points of a small lattice: shapes made of them share corners, edges and planes, or have no area.
pub(super) fn lattice_point() -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-2_i8..=2).prop_map(|p| Vec3::from(p.map(f32::from)))
}

pub(super) fn point() -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-2.5_f32..2.5).prop_map(Vec3::from)
}

fn triangle() -> impl Strategy<Value = [Vec3; 3]> {
    let sized = |size: f32| {
        (point(), prop::array::uniform3(point()))
            .prop_map(move |(p, corners)| corners.map(|corner| p + size * corner))
    };
    prop_oneof![
        4 => prop::array::uniform3(lattice_point()),
        3 => prop::array::uniform3(point()),
        2 => sized(0.05),
        1 => sized(1e-5),
        1 => sized(100.0),
        // A sliver: as long as the scene, a ten-thousandth as wide.
        1 => (point(), point(), point()).prop_map(|(p, q, r)| [p, q, q + 1e-4 * r]),
        // No area: a point, a line.
        1 => lattice_point().prop_map(|p| [p; 3]),
        1 => (lattice_point(), lattice_point()).prop_map(|(p, q)| [p, q, 0.5 * (p + q)]),
    ]
}

/// What is done to all triangles together.
#[derive(Clone, Copy, Debug)]
enum Twist {
    Nothing,
    /// All in the plane z = 0.
    Flat,
    /// Each of them many times.
    Repeated,
}

fn triangles() -> impl Strategy<Value = Vec<[Vec3; 3]>> {
    let twist = prop_oneof![
        6 => Just(Twist::Nothing),
        1 => Just(Twist::Flat),
        1 => Just(Twist::Repeated),
    ];
    let few = prop_oneof![
        1 => prop::collection::vec(triangle(), 0..3),
        4 => prop::collection::vec(triangle(), 3..30),
        2 => prop::collection::vec(triangle(), 30..150),
    ];
    (few, twist).prop_map(|(triangles, twist)| match twist {
        Twist::Nothing => triangles,
        Twist::Flat => triangles
            .into_iter()
            .map(|corners| corners.map(|p| p * vec3(1.0, 1.0, 0.0)))
            .collect(),
        Twist::Repeated => triangles
            .iter()
            .copied()
            .cycle()
            .take(12 * triangles.len())
            .collect(),
    })
}

/// Scale and centre: mostly around 0, sometimes up to ten sizes away from it.
fn place() -> impl Strategy<Value = (f32, Vec3)> {
    let scale = (-6_i8..=6).prop_map(|power| 10.0_f32.powi(power.into()));
    let center = prop_oneof![3 => Just(Vec3::ZERO), 1 => point().prop_map(|p| 4.0 * p)];
    (scale, center).prop_map(|(scale, center)| (scale, scale * center))
}

/// Triangles.
pub(super) fn facets() -> impl Strategy<Value = Scene<Facet>> {
    (triangles(), place()).prop_map(|(triangles, (scale, center))| Scene {
        shapes: placed(&triangles, scale, center),
        scale,
        center,
    })
}

fn placed(triangles: &[[Vec3; 3]], scale: f32, center: Vec3) -> Vec<Facet> {
    let facet = |(corners, id): (&[Vec3; 3], u32)| Facet {
        corners: corners.map(|p| scale * p + center),
        id,
    };
    triangles.iter().zip(0..).map(facet).collect()
}

/// A shape of any kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Thing {
    Facet(Facet),
    Ball(Sphere),
    Box(Cuboid),
    /// Without bounds.
    Plane(Plane),
}

impl Thing {
    fn shape(&self) -> &dyn Shape {
        match self {
            Self::Facet(facet) => facet,
            Self::Ball(ball) => ball,
            Self::Box(cuboid) => cuboid,
            Self::Plane(plane) => plane,
        }
    }
}

impl Shape for Thing {
    fn bounds(&self) -> Aabb {
        self.shape().bounds()
    }

    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.shape().hit(ray, within)
    }

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.shape().surface(ray, hit)
    }
}

/// Shapes of all kinds.
pub(super) fn things() -> impl Strategy<Value = Scene<Thing>> {
    let thing = prop_oneof![
        4 => triangle().prop_map(|corners| Thing::Facet(Facet { corners, id: 0 })),
        3 => (point(), prop_oneof![0.05_f32..1.0, Just(1e-9), Just(20.0), Just(1.0)])
            .prop_map(|(center, radius)| Thing::Ball(Sphere::new(center, radius))),
        3 => (lattice_point(), lattice_point()).prop_map(|(p, q)| Thing::Box(Cuboid::between(p, q))),
        1 => (point(), lattice_point())
            .prop_map(|(p, n)| Thing::Plane(Plane::through(p, Dir3::new_or(n, Dir3::Y)))),
    ];
    let things = prop_oneof![
        1 => prop::collection::vec(thing.clone(), 0..3),
        4 => prop::collection::vec(thing, 3..40),
    ];
    (things, place()).prop_map(|(things, (scale, center))| Scene {
        shapes: things
            .iter()
            .map(|thing| moved(thing, scale, center))
            .collect(),
        scale,
        center,
    })
}

fn moved(thing: &Thing, scale: f32, center: Vec3) -> Thing {
    let at = |p: Vec3| scale * p + center;
    match *thing {
        Thing::Facet(facet) => Thing::Facet(Facet {
            corners: facet.corners.map(at),
            ..facet
        }),
        Thing::Ball(ball) => Thing::Ball(Sphere::new(at(ball.center), scale * ball.radius)),
        Thing::Box(cuboid) => Thing::Box(Cuboid::between(
            at(cuboid.bounds.min),
            at(cuboid.bounds.max),
        )),
        Thing::Plane(plane) => Thing::Plane(Plane::through(
            at(plane.offset * *plane.normal),
            plane.normal,
        )),
    }
}
