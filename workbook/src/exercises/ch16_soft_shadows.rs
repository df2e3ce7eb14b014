//! Chapter 16: `sample_rect`, `sample_sphere_light`, `visible_fraction`.

use raybook::image::rgb::Rgb;
use raybook::light::extent::Choose;
use raybook::light::rect_light::RectLight;
use raybook::light::sphere_light::SphereLight;
use raybook::light::{Light, LightSample};
use raybook::math::{dir3::Dir3, pcg};
use raybook::render::soft_shadow;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Surface, sphere::Sphere};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::{Vec2, Vec3, vec2};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&SampleRect, &SampleSphereLight, &VisibleFraction];

row! {
    /// A direction that was chosen towards a light.
    pub struct Chosen {
        /// From the point to the light.
        pub toward: Vec3,
        /// How far the chosen point of the light is.
        pub distance: f32,
        /// The density of the direction, per steradian.
        pub pdf: f32,
        /// The light's radiance over that density.
        pub arriving: f32,
    }
}

/// The middles of the cells of an n × n lattice of the unit square: ((i + ½)/n, (j + ½)/n), with i running fastest.
fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |k| (vec2((k % n) as f32, (k / n) as f32) + 0.5) / n as f32)
}

/// What a light makes of the points of a lattice; none if from anywhere nothing comes.
fn choose(light: &dyn Light, at: Vec3, n: u32) -> Option<Vec<Chosen>> {
    let chosen = |sample: LightSample| Chosen {
        toward: *sample.toward,
        distance: sample.distance,
        pdf: sample.pdf,
        arriving: sample.arriving.g,
    };
    lattice(n)
        .map(|u| light.sample(at, u).map(chosen))
        .collect()
}

/// See [`Exercise::TASK`].
pub struct SampleRect;

row! {
    /// A rectangle that shines, a point, and how fine a lattice.
    pub struct SampleRectQuestion {
        /// The point that is lit.
        pub at: Vec3,
        /// A corner of the light.
        pub corner: Vec3,
        /// One side.
        pub a: Vec3,
        /// The other side, square to a; a × b points to where the light shines.
        pub b: Vec3,
        /// The radiance.
        pub radiance: f32,
        /// How many points along each side of the lattice.
        pub n: u32,
    }
}

impl Exercise for SampleRect {
    type Question = SampleRectQuestion;
    type Answer = Option<Vec<Chosen>>;
    const NAME: &'static str = "sample_rect";
    const TASK: &'static str = "For each of the n·n numbers u = ((i + ½)/n, (j + ½)/n), return the direction and the distance to a point of the rectangular light, uniform over its area, the density of the direction per steradian, and radiance/density; or None if the light turns its back.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let light = RectLight::new(q.corner, q.a, q.b, Rgb::gray(q.radiance));
        choose(&light.choosing(Choose::ByArea), q.at, q.n)
    }
}

/// See [`Exercise::TASK`].
pub struct SampleSphereLight;

row! {
    /// A sphere that shines, a point, and how fine a lattice.
    pub struct SampleSphereLightQuestion {
        /// The point that is lit.
        pub at: Vec3,
        /// The light's centre.
        pub center: Vec3,
        /// Its radius.
        pub radius: f32,
        /// Its radiance, outwards and inwards.
        pub radiance: f32,
        /// How many points along each side of the lattice.
        pub n: u32,
    }
}

impl Exercise for SampleSphereLight {
    type Question = SampleSphereLightQuestion;
    type Answer = Vec<Chosen>;
    const NAME: &'static str = "sample_sphere_light";
    const TASK: &'static str = "For each of the n·n numbers u = ((i + ½)/n, (j + ½)/n), return a direction uniform over the solid angle in which the spherical light is seen, the distance to the light, the density of the direction per steradian, and radiance/density; the point may be inside.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let light = SphereLight {
            sphere: Sphere::new(q.center, q.radius),
            radiance: Rgb::gray(q.radiance),
            choose: Choose::BySolidAngle,
        };
        choose(&light, q.at, q.n).unwrap_or_default()
    }
}

/// See [`Exercise::TASK`].
pub struct VisibleFraction;

row! {
    /// A ball that is in the way.
    pub struct Ball {
        /// Its centre.
        pub center: Vec3,
        /// Its radius.
        pub radius: f32,
    }
}

row! {
    /// Points, a light, and what is in between.
    pub struct VisibleFractionQuestion {
        /// A corner of the light.
        pub corner: Vec3,
        /// One side.
        pub a: Vec3,
        /// The other side, square to a; a × b points to where the light shines.
        pub b: Vec3,
        /// The points.
        pub points: Vec<Vec3>,
        /// The balls that may be in the way.
        pub balls: Vec<Ball>,
        /// How many samples for each point.
        pub samples: u32,
    }
}

impl VisibleFractionQuestion {
    /// The light.
    pub fn light(&self) -> RectLight {
        RectLight::new(self.corner, self.a, self.b, Rgb::WHITE)
    }

    /// The balls.
    pub fn scene(&self) -> Scene<()> {
        let things = self.balls.iter().map(|ball| Thing {
            shape: Box::new(Sphere::new(ball.center, ball.radius)) as _,
            material: Box::new(()),
        });
        Scene::new(things.collect(), vec![])
    }
}

/// A point as the surface that it is on.
fn surface(position: Vec3) -> Surface {
    Surface {
        position,
        error: 0.0,
        normal: Dir3::Y,
        shading_normal: Dir3::Y,
        texture: Vec2::ZERO,
    }
}

impl Exercise for VisibleFraction {
    type Question = VisibleFractionQuestion;
    type Answer = Vec<f32>;
    const NAME: &'static str = "visible_fraction";
    const ANSWER: &'static str = "fraction";
    const TASK: &'static str = "For each point, estimate by so many random samples which fraction of the light's area is seen from there; none of it is, if the light turns its back.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let (light, scene) = (q.light(), q.scene());
        let points = q.points.iter().zip(0..);
        let seen = points.map(|(&p, i)| {
            let rng = &mut pcg::stream(16, i);
            soft_shadow::visible_fraction(&scene, &surface(p), &light, q.samples, rng)
        });
        seen.collect()
    }
}
