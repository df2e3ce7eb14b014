//! A teapot in a heap of confetti, in the light of the sky: many small triangles, and many rays for each pixel.
//!
//! The book's live picture is made of this very file (`book/live`): it uses nothing that a browser has not.

use crate::kit::okabe_ito::{BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, linear};
use crate::shared::outdoors;
use glam::{Vec3, vec2, vec3};
use rand::{Rng, RngExt};
use raybook::accel::Accel;
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::math::dir3::Dir3;
use raybook::math::interval::Interval;
use raybook::math::pcg;
use raybook::math::ray::Ray;
use raybook::render::followed::Followed;
use raybook::sample::hemisphere::cosine_hemisphere;
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::plane::Plane;
use raybook::shape::{Hit, Shape, Surface, teapot};
use std::f32::consts::TAU;

/// A teapot, and pieces of paper on and around it.
pub(super) struct Confetti {
    /// The teapot and all pieces, in metres; the floor is at y = 0.
    pub mesh: Mesh,
    /// Facets with a lower number belong to the teapot.
    teapot: u32,
    /// The colours of the paper.
    paper: [Rgb; 6],
}

impl Confetti {
    /// A heap of n pieces, and a few still in the air.
    pub(super) fn new(n: u32) -> Self {
        let teapot = teapot::mesh(24);
        let bounds = teapot.bounds();
        let size = bounds.size().max_element();
        let ground = bounds.center().with_y(bounds.min.y);
        let place = |p: &Vec3| (p - ground) / size;
        let mut positions: Vec<_> = teapot.positions().iter().map(place).collect();
        let mut triangles = teapot.triangles().to_vec();
        let mut normals = teapot.normals().to_vec();
        let mut rng = pcg::stream(24, 0);
        for i in 0..n + n / 60 {
            let at = if i < n {
                let far = 2.6 * rng.random::<f32>().sqrt();
                let heap = 0.16 * (-far * far).exp() + 0.012;
                let turn = TAU * rng.random::<f32>();
                let up = heap * rng.random::<f32>();
                vec3(far * turn.cos(), up, far * turn.sin())
            } else {
                let wide = |rng: &mut pcg::Pcg| 2.0 * (rng.random::<f32>() - 0.5);
                vec3(wide(&mut rng), 1.5 * rng.random::<f32>(), wide(&mut rng))
            };
            let flat = if i < n { 0.35 } else { 1.0 };
            let first = positions.len() as u32;
            for _ in 0..3 {
                let d = Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>() - 0.5));
                positions.push((at + 0.024 * d * vec3(1.0, flat, 1.0)).max(vec3(-9.0, 0.0, -9.0)));
                normals.push(Dir3::Y);
            }
            triangles.push([first, first + 1, first + 2]);
        }
        Self {
            mesh: Mesh::new(positions, triangles, Some(normals), None)
                .unwrap_or_else(|error| unreachable!("confetti is finite: {error}")),
            teapot: teapot.triangles().len() as u32,
            paper: [BLUE, ORANGE, GREEN, VERMILION, PURPLE, SKY].map(linear),
        }
    }

    /// What a ray sees: paper, porcelain or floor, in the light of the sun and of `sky_rays` rays towards the sky; and the number
    /// of rays that were needed.
    pub(super) fn follow(
        &self,
        ray: &Ray,
        accel: &impl Accel<Facet>,
        sky_rays: u16,
        rng: &mut impl Rng,
    ) -> Followed {
        let floor = Plane::through(Vec3::ZERO, Dir3::Y);
        let (colour, at) = match accel.closest(ray, Interval::AHEAD) {
            Some((_, hit)) => (self.colour(&hit), self.mesh.surface(ray, &hit)),
            None => match floor.hit(ray, Interval::AHEAD) {
                Some(hit) => (Rgb::new(0.42, 0.40, 0.38), floor.surface(ray, &hit)),
                None => {
                    return Followed {
                        radiance: outdoors::sky(ray.direction),
                        rays: 1,
                    };
                }
            },
        };
        let inward = at.normal.dot(*ray.direction) > 0.0;
        let normal = if inward { -at.normal } else { at.normal };
        let open = |toward: Dir3| !accel.any(&at.leave(toward), Interval::AHEAD);
        let mut light = Rgb::BLACK;
        // Evenly in one number, and by the golden section in the other: more even than random numbers.
        let (first, turn): (f32, f32) = (rng.random(), rng.random());
        for i in (0..sky_rays).map(f32::from) {
            let u = vec2(
                (i + first) / f32::from(sky_rays),
                (turn + 0.618_034 * i).fract(),
            );
            let toward = cosine_hemisphere(normal, u);
            if toward.y > 0.0 && open(toward) {
                light += Rgb::new(0.52, 0.61, 0.74) / f32::from(sky_rays);
            }
        }
        let sun = Dir3::new_or(vec3(-0.55, 0.8, 0.45), Dir3::Y);
        let facing = shading(&at, inward).dot(*sun).max(0.0);
        if facing > 0.0 && open(sun) {
            light += Rgb::new(0.95, 0.84, 0.66) * facing;
        }
        let distance = (at.position - ray.origin).length();
        let far = (-(distance / 9.0).powi(4)).exp();
        let seen = outdoors::sky(Dir3::new_or(ray.direction.with_y(0.0), Dir3::Y));
        Followed {
            radiance: seen.lerp(colour * light, far),
            rays: 2 + u64::from(sky_rays),
        }
    }

    fn colour(&self, hit: &Hit) -> Rgb {
        if hit.id < self.teapot {
            return Rgb::new(0.50, 0.56, 0.55);
        }
        self.paper[(hit.id.wrapping_mul(2_654_435_761) >> 16) as usize % self.paper.len()]
    }
}

fn shading(at: &Surface, inward: bool) -> Dir3 {
    // The corners of paper have no normals of their own: all of them point up.
    let smooth = if at.shading_normal == Dir3::Y {
        at.normal
    } else {
        at.shading_normal
    };
    if inward { -smooth } else { smooth }
}

/// Where the camera of the picture is, above the front of the heap.
pub(super) const EYE: Vec3 = vec3(0.5, 0.62, 1.35);

/// Where a camera looks.
pub(super) const MIDDLE: Vec3 = vec3(0.02, 0.2, 0.0);

/// Looks at the middle of the heap, from any place but straight above or below.
pub(super) fn camera(eye: Vec3, aspect: f32) -> Pinhole {
    Pinhole::look_at(eye, MIDDLE, Vec3::Y, 0.045, aspect)
        .unwrap_or_else(|error| unreachable!("the direction is not upright: {error}"))
}
