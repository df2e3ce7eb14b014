//! Chapter 16: `sample_rect`, `sample_sphere_light`, `visible_fraction`.

use crate::exercise::exercises;
use crate::record::row;
use glam::{Vec2, Vec3, vec2};
use raybook::image::rgb::Rgb;
use raybook::light::extent::LightSampling;
use raybook::light::rect_light::RectLight;
use raybook::light::sphere_light::SphereLight;
use raybook::light::{Light, LightSample};
use raybook::math::{dir3::Dir3, pcg};
use raybook::render::soft_shadow;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Surface, sphere::Sphere};

exercises! { ($) ch16_soft_shadows
    /// For each of the n·n pairs u = ((i + ½)/n, (j + ½)/n), return a sample of the rectangular light, uniform over its
    /// area: the direction and the distance to it, the probability density of the direction per steradian, and
    /// radiance/density. There is no answer if the light turns its back to the point.
    ///
    /// In Rust: the sample of one u, which is given.
    SampleRect: sample_rect(
        /// The point that is lit, in metres.
        at: Vec3,
        /// A corner of the light, in metres.
        corner: Vec3,
        /// One side, in metres.
        a: Vec3,
        /// The other side, in metres, perpendicular to a; a × b points to where the light shines.
        b: Vec3,
        /// The light's radiance, in W·m⁻²·sr⁻¹.
        radiance: f32,
        /// The number of points along each side of the lattice.
        n: u32,
    ) -> (
        /// The n·n samples, one for each pair u; none if the light turns its back.
        answer: Option<Vec<Chosen>>,
    ) {
        let light = RectLight::new(corner, a, b, Rgb::gray(radiance));
        choose(&light.choosing(LightSampling::ByArea), at, n)
    }

    /// For each of the n·n pairs u = ((i + ½)/n, (j + ½)/n), return a sample of the spherical light, uniform over the
    /// solid angle in which it is seen: the direction and the distance to the light, the probability density of the
    /// direction per steradian, and radiance/density.
    SampleSphereLight: sample_sphere_light(
        /// The point that is lit, in metres; it may be inside the light.
        at: Vec3,
        /// The light's centre, in metres.
        center: Vec3,
        /// The light's radius, in metres,
        radius: f32 [above 0],
        /// The light's radiance, outwards and inwards, in W·m⁻²·sr⁻¹.
        radiance: f32,
        /// The number of points along each side of the lattice.
        n: u32,
    ) -> (
        /// The n·n samples, one for each pair u; those of a light that is small and far are as exact as others.
        answer: Vec<Chosen>,
    ) {
        let light = SphereLight {
            sphere: Sphere { center, radius },
            radiance: Rgb::gray(radiance),
            choose: LightSampling::BySolidAngle,
        };
        choose(&light, at, n).unwrap_or_default()
    }

    /// For each point, estimate by the given number of random samples which fraction of the light's area is seen from
    /// there. Nothing of it is seen if the light turns its back.
    VisibleFraction: visible_fraction(
        /// A corner of the light, in metres.
        corner: Vec3,
        /// One side, in metres.
        a: Vec3,
        /// The other side, in metres, perpendicular to a; a × b points to where the light shines.
        b: Vec3,
        /// The points, in metres.
        points: Vec<Vec3>,
        /// The balls that may be in the way.
        balls: Vec<Ball>,
        /// The number of samples for each point,
        samples: u32 [1 or more],
    ) -> (
        /// In the order of the points, the fraction of the light's area that is seen from there,
        fraction: Vec<f32> [from 0 to 1],
    ) |q| {
        let (light, scene) = (q.light(), q.scene());
        let points = q.points.iter().zip(0..);
        let seen = points.map(|(&p, i)| {
            let rng = &mut pcg::stream(16, i);
            soft_shadow::visible_fraction(&scene, &surface(p), &light, q.samples, rng)
        });
        seen.collect()
    }
}

row! {
    /// A direction that was chosen towards a light.
    pub struct Chosen {
        /// From the point to the light, of length 1.
        pub toward: Vec3,
        /// The distance to the chosen point of the light, in metres.
        pub distance: f32,
        /// The density of the direction, per steradian.
        pub pdf: f32,
        /// The light's radiance over that density, in W/m².
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

row! {
    /// A ball that is in the way.
    pub struct Ball {
        /// The centre, in metres.
        pub center: Vec3,
        /// The radius, in metres,
        pub radius: f32 [above 0],
    }
}

impl VisibleFraction {
    /// The light.
    pub fn light(&self) -> RectLight {
        RectLight::new(self.corner, self.a, self.b, Rgb::WHITE)
    }

    /// The balls.
    pub fn scene(&self) -> Scene {
        let ball = |ball: &Ball| Sphere {
            center: ball.center,
            radius: ball.radius,
        };
        let things = self.balls.iter().map(|one| Thing::new(ball(one), ()));
        Scene::new(things.collect(), vec![])
    }
}

/// A point as the surface that it is on.
fn surface(position: Vec3) -> Surface {
    Surface::flat(position, 0.0, Dir3::Y)
}
