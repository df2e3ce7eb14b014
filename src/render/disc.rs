//! A disc around a point of a surface, and how much of the disc lies on the surface.

use crate::accel::Accel;
use crate::math::{basis::Basis, dir3::Dir3, interval::Interval, pcg, ray::Ray};
use crate::sample::pattern::sobol::unit;
use crate::scene::world::Scene;
use crate::shape::Surface;
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

/// Maximum distance of a place of the surface from the disc's plane, as a part of the radius.
pub(crate) const THICKNESS: f32 = 0.25;

/// Minimum cosine between the normals of the disc and of a place of the surface: behind a thin wall, and on the other wall of a corner, are
/// places of other surfaces.
pub(crate) const ALIKE: f32 = 0.8;

/// Number of places at which a disc is looked at. With 8, the mean of 1/part is right to 2 % at a straight edge, and to 6 % in a corner
/// of 90°.
const PLACES: u32 = 8;

/// The angle from one place to the next: the golden ratio's part of a full turn, so that the places are all around the middle.
const TURN: f32 = TAU * 0.618_034;

/// Number of surfaces of glass and mirrors that a ray passes on its way: more of them are seldom within a radius.
const MOST_PASSED: usize = 4;

/// A disc around a point of a surface. Nothing but the surfaces that scatter light count here: glass and mirrors are passed.
pub(crate) struct Disc<'a> {
    scene: &'a Scene,
    radius: f32,
    /// Directions of the disc, and the normal.
    basis: Basis,
    /// A point over the middle that is on this side of all surfaces over the disc, and its height.
    above: Vec3,
    height: f32,
    /// Random bits that follow from the middle.
    random: u64,
}

impl<'a> Disc<'a> {
    /// The disc with this `radius`, in metres, on the side of the surface to which the `normal` points.
    pub(crate) fn new(scene: &'a Scene, at: &Surface, normal: Dir3, radius: f32) -> Self {
        let (up, thickness) = (at.leave(normal), THICKNESS * radius);
        let free = first(scene, up, thickness).map_or(thickness, |(t, _)| 0.5 * t);
        let above = up.at(free);
        let bits = at.position.to_array().map(|x| u64::from(x.to_bits()));
        Self {
            scene,
            radius,
            basis: Basis::around(normal),
            above,
            height: (above - at.position).dot(*normal),
            random: bits.iter().fold(0, |key, bits| pcg::mix(key ^ bits)),
        }
    }

    /// Whether the surface ends within twice the radius, as far as rays all around tell.
    pub(crate) fn is_near_edge(&self) -> bool {
        let mut rim = (0..PLACES).map(|i| Vec2::from_angle(TAU * i as f32 / PLACES as f32));
        rim.any(|place| !self.goes_on(2.0 * place))
    }

    /// The part of the disc that lies on the surface, weighted by Epanechnikov's kernel 2/(π r²)·(1 − d²/r²), d being the distance from the
    /// middle: an estimate by a few places, one of them at least.
    ///
    /// The places are chosen with the density of the kernel. Within d is the share u = 1 − (1 − d²/r²)² of it, which is set equal to
    /// equally spaced numbers, and solved for d. The places are turned by a random angle, so that no direction is preferred.
    pub(crate) fn part(&self) -> f32 {
        let (turn, offset) = (
            TAU * unit(self.random as u32),
            unit((self.random >> 32) as u32),
        );
        let places = (0..PLACES).map(|i| {
            let u = (i as f32 + offset) / PLACES as f32;
            let d = (1.0 - (1.0 - u).sqrt()).sqrt();
            d * Vec2::from_angle(turn + TURN * i as f32)
        });
        let found = places.filter(|place| self.goes_on(*place)).count();
        found.max(1) as f32 / PLACES as f32
    }

    /// Whether the surface goes on up to a place of the disc, in units of the radius: whether the way over the surface is free, and the
    /// surface is below its end.
    fn goes_on(&self, place: Vec2) -> bool {
        let aside = self.basis.to_world((self.radius * place).extend(0.0));
        let Some(toward) = Dir3::new(aside) else {
            return true;
        };
        let (along, normal) = (Ray::new(self.above, toward), self.basis.z);
        if first(self.scene, along, aside.length()).is_some() {
            return false;
        }
        let down = Ray::new(self.above + aside, -normal);
        let below = first(self.scene, down, 2.0 * self.height);
        below.is_some_and(|(_, surface)| surface.normal.dot(*normal).abs() > ALIKE)
    }
}

/// The first surface that scatters light, and its distance, if that is less than `length`, in metres.
fn first(scene: &Scene, mut ray: Ray, length: f32) -> Option<(f32, Surface)> {
    let mut gone = 0.0;
    for _ in 0..MOST_PASSED {
        let within = Interval::AHEAD.before(length - gone);
        let (thing, hit) = scene.things().closest(&ray, within)?;
        let surface = thing.shape.surface(&ray, &hit);
        gone += hit.t;
        if thing.material.scatters(&surface) {
            return Some((gone, surface));
        }
        ray = surface.leave(ray.direction);
    }
    None
}
