//! Ray tracing in steps that each ask one function about all rays at once: what they hit, where, under which light.

use super::functions::Functions;
use super::nearest::Reach;
use super::scene::{Made, Shape, Thing, camera, sky, things};
use super::teapot::Teapot;
use glam::{Vec2, Vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook_workbook::exercises::{
    ch01_rays::CameraRay, ch03_sphere::SphereHit, ch04_plane::PlaneHit, ch05_box::BoxClip,
    ch06_triangle::TriangleHit, ch07_mesh::MeshHit, ch13_reflection::Reflect,
    ch14_refraction::Refract,
};
use std::io;

/// How often light is mirrored or refracted on its way.
const BOUNCES: u32 = 5;
/// How far a ray starts from the surface that it leaves, in metres.
const LIFT: f32 = 1e-3;
/// The share of the light that the mirror reflects, and its colour gives the rest.
const MIRRORED: f32 = 0.7;

/// Where a ray arrives.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// Which of the rays.
    pub(super) ray: usize,
    pub(super) thing: Thing,
    /// Which of the thing's triangles, if it is a mesh.
    pub(super) part: u32,
    pub(super) position: Vec3,
    /// Where the ray came from.
    pub(super) incoming: Dir3,
    /// The outward normal.
    pub(super) normal: Dir3,
}

impl Place {
    /// The normal on the side from which the ray came.
    pub(super) fn facing(&self) -> Dir3 {
        if self.normal.dot(*self.incoming) > 0.0 {
            -self.normal
        } else {
            self.normal
        }
    }

    /// A ray that leaves in this direction.
    pub(super) fn leave(&self, direction: Dir3) -> Ray {
        let side = LIFT.copysign(direction.dot(*self.normal));
        Ray::new(self.position + side * *self.normal, direction)
    }
}

/// Traces rays through the scene by asking.
pub struct Tracer<'a, 'b> {
    pub(super) functions: &'a mut Functions<'b>,
    pub(super) things: Vec<Thing>,
    pub(super) teapot: Teapot,
}

impl<'a, 'b> Tracer<'a, 'b> {
    /// Of everything whose hit function is written.
    pub fn new(functions: &'a mut Functions<'b>) -> Self {
        let mut things = things();
        things.retain(|thing| match thing.shape {
            Shape::Ball { .. } => functions.has::<SphereHit>(),
            Shape::Floor => functions.has::<PlaneHit>(),
            Shape::Block(_) => functions.has::<BoxClip>(),
            Shape::Triangle(_) => functions.has::<TriangleHit>(),
            Shape::Teapot => functions.has::<MeshHit>(),
        });
        Self {
            functions,
            things,
            teapot: Teapot::new(),
        }
    }

    /// What is seen through places on the film.
    pub fn seen(&mut self, film: &[Vec2]) -> io::Result<Vec<Rgb>> {
        let questions: Vec<CameraRay> = film.iter().map(|film| camera(*film)).collect();
        let answers = self.functions.ask_or_answer(&questions)?;
        let rays = answers.iter().zip(&questions).map(|(ray, question)| {
            Ray::new(ray.origin, Dir3::new_or(ray.direction, question.forward))
        });
        self.radiance(&rays.collect::<Vec<_>>(), BOUNCES)
    }

    /// The radiance that comes along each ray.
    fn radiance(&mut self, rays: &[Ray], bounces: u32) -> io::Result<Vec<Rgb>> {
        let mut colours: Vec<_> = rays.iter().map(|ray| sky(*ray.direction)).collect();
        let (clear, solid): (Vec<_>, Vec<_>) = self
            .places(rays)?
            .into_iter()
            .partition(|place| place.thing.made == Made::Glass && self.functions.has::<Refract>());
        for (place, colour) in solid.iter().zip(self.scattered(&solid)?) {
            colours[place.ray] = colour;
        }
        let mirrors = solid
            .iter()
            .filter(|place| place.thing.made == Made::Mirror);
        let mirrors: Vec<_> = mirrors.copied().collect();
        if bounces > 0 && self.functions.has::<Reflect>() && !mirrors.is_empty() {
            let onward = self.mirrored(&mirrors)?;
            for (place, colour) in mirrors.iter().zip(self.radiance(&onward, bounces - 1)?) {
                let own = &mut colours[place.ray];
                *own = own.lerp(colour, MIRRORED);
            }
        }
        if bounces > 0 && !clear.is_empty() {
            let onward = self.refracted(&clear)?;
            for (place, colour) in clear.iter().zip(self.radiance(&onward, bounces - 1)?) {
                colours[place.ray] = colour;
            }
        }
        Ok(colours)
    }

    /// The nearest place where each ray arrives.
    fn places(&mut self, rays: &[Ray]) -> io::Result<Vec<Place>> {
        let reaches: Vec<Reach> = rays.iter().map(|ray| (*ray, Interval::AHEAD)).collect();
        let hits = self.nearest(&reaches)?.into_iter().enumerate();
        let hits = hits.filter_map(|(i, hit)| Some((i, hit?)));
        let mut places: Vec<_> = hits
            .map(|(ray, hit)| Place {
                ray,
                thing: self.things[hit.thing],
                part: hit.part,
                position: rays[ray].at(hit.t),
                incoming: rays[ray].direction,
                normal: Dir3::Y,
            })
            .collect();
        self.find_normals(&mut places)?;
        Ok(places)
    }
}
