//! The caustic photon map: where the light lands that mirrors and glass have gathered.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::photons::Photons;
//!
//! // A mirror throws the light of a lamp up to a ceiling; the floor gets none from the mirror.
//! let lamp = RectLight::new(vec3(-0.5, 1.0, -0.5), Vec3::X, Vec3::Z, Rgb::WHITE);
//! let ceiling = Thing::new(Plane::through(3.0 * Vec3::Y, Dir3::Y), Lambert { albedo: Rgb::gray(0.5) });
//! let mirror = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Mirror { share: Rgb::WHITE });
//! let scene = Scene::new(vec![ceiling, mirror], vec![Box::new(lamp)]);
//! let photons = Photons::shot(&scene, 1000, 0.1, 0);
//! assert!(photons.all().iter().all(|photon| photon.position.y > 2.99));
//! let power = photons.all().iter().map(|photon| photon.power.g).sum::<f32>();
//! assert!((power / std::f32::consts::PI - 1.0).abs() < 0.01); // the flux of the lamp, π A L, is all there
//! ```

use crate::image::rgb::Rgb;
use crate::light::{Emitted, Light};
use crate::material::glass::Medium;
use crate::math::{dir3::Dir3, pcg, ray::Ray, whole::below};
use crate::render::disc::{ALIKE, Disc, THICKNESS};
use crate::render::{lobes::Lobes, path::roulette};
use crate::sample::even::Even;
use crate::scene::world::{Scene, Seen};
use crate::threads;
use glam::{Vec2, Vec3};
use std::f32::consts::PI;
use std::fmt;

/// Number of surfaces after which Russian roulette may end the way of a photon.
const ROULETTE_AFTER: u32 = 8;

/// Number of photons that are followed before those that have landed are collected: their list takes a few megabytes.
const TOGETHER: usize = 1 << 16;

/// Width of a cell in radii: wide enough that a point is seldom near several cells, and narrow enough that it is near few photons of its
/// cell that do not light it.
const WIDTH: f32 = 4.0;

/// The last part of the way of a photon, seen backwards, that may not hold a lamp: the photon has come from a lamp there.
const BEFORE_LIGHT: f32 = 1e-4;

/// A photon: a small part of a lamp's light, where it has landed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon {
    /// Where it has landed.
    pub position: Vec3,
    /// The direction from which it came, as a vector that points away from the surface.
    pub toward: Dir3,
    /// The surface's normal, on the side from which the photon came.
    pub normal: Dir3,
    /// Its power Φ, in W. In a medium of the index n it is divided by n², as [`Glass`](crate::material::glass::Glass) leaves this factor out.
    pub power: Rgb,
    /// Number of mirrors and surfaces of glass that it has met on its way.
    pub surfaces: u32,
    /// Whether the surface ends within twice the radius within which the photon lights points. If not, the surface goes on for a radius
    /// around each of these points.
    near_edge: bool,
}

/// Photons that have come from the lights by mirrors and through glass, and by no other surfaces, to surfaces that scatter light (Jensen,
/// "Global illumination using photon maps", 1996).
///
/// To find the photons near a point, space is cut into cells. The cells are numbered, and photons in cells with the same number, a
/// bucket, lie side by side in memory. There are more cells than buckets: cells far apart may share a bucket.
pub struct Photons {
    /// Sorted by their buckets.
    landed: Vec<Photon>,
    /// The place of each bucket's first photon, and the number of all photons.
    starts: Vec<u32>,
    /// r: photons within this distance light a point, in metres.
    radius: f32,
    /// The cells, and their buckets.
    grid: Grid,
    /// Whether the light of this number has emitted photons.
    emitters: Vec<bool>,
}

impl fmt::Debug for Photons {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Photons")
            .field("photons", &self.landed.len())
            .field("radius", &self.radius)
            .field("emitters", &self.emitters)
            .finish_non_exhaustive()
    }
}

impl Photons {
    // ANCHOR: shot
    /// The photons that have landed, of `count` from each light. All follow from the scene and from the `seed`, whatever the number of
    /// threads.
    ///
    /// `radius`, in metres, above 0, is the distance up to which photons light a point: a large radius blurs the light, and with a small one
    /// single photons are seen. `count` is at most 2³¹.
    pub fn shot(scene: &Scene, count: usize, radius: f32, seed: u64) -> Self {
        let mut landed = Vec::new();
        for (light, i) in scene.lights.iter().zip(0..) {
            let key = pcg::mix(seed ^ pcg::mix(i));
            for first in (0..count).step_by(TOGETHER) {
                let photons = threads::list(TOGETHER.min(count - first), |i| {
                    let mut numbers = Even::new(key, first + i, count);
                    landing(scene, &**light, radius, &mut numbers)
                });
                landed.extend(photons.into_iter().flatten());
            }
        }
        for photon in &mut landed {
            photon.power = photon.power / count as f32;
        }
        let emitters = scene.lights.iter();
        let emitters = emitters.map(|light| count > 0 && emits(&**light));
        Self::of(landed, radius, emitters.collect())
    }
    // ANCHOR_END: shot

    /// These photons, sorted by their buckets.
    fn of(mut photons: Vec<Photon>, radius: f32, emitters: Vec<bool>) -> Self {
        let grid = Grid::new(radius, photons.len());
        let bucket = |photon: &Photon| grid.bucket(grid.cell(photon.position));
        threads::sort_by_cached_key(&mut photons, |photon| bucket(photon) as u64);
        let mut starts = vec![0; grid.buckets + 1];
        for photon in &photons {
            starts[bucket(photon) + 1] += 1;
        }
        for i in 0..grid.buckets {
            starts[i + 1] += starts[i];
        }
        Self {
            landed: photons,
            starts,
            radius,
            grid,
            emitters,
        }
    }

    /// All photons that have landed.
    pub fn all(&self) -> &[Photon] {
        &self.landed
    }

    /// Whether the scene's light number `light` has emitted photons.
    pub fn come_from(&self, light: usize) -> bool {
        self.emitters.get(light).is_some_and(|emits| *emits)
    }

    // ANCHOR: reflected
    /// The radiance that a surface reflects to the viewer of the light that the photons bring: Σ f Φ K(d)/F over the photons around it.
    ///
    /// K(d) = 2/(π r²)·(1 − d²/r²), in 1/m², is the density with which a photon's power is spread over the surface, at the distance d from
    /// where it has landed (Epanechnikov's kernel). The integral of K over the disc with the radius r is 1: no power is lost. Only photons
    /// count that have landed in a thin disc around the point, on the same side, after at most `most` mirrors and surfaces of glass. The
    /// light is blurred by r.
    ///
    /// F is the integral of K over the part of the disc that lies on the surface: no photon can land on the rest. It is 1, but near an
    /// edge of the surface: if all these photons are, a few rays in the `scene` estimate F.
    pub fn reflected(&self, scene: &Scene, seen: &Seen, view: Dir3, most: u32) -> Rgb {
        if self.landed.is_empty() {
            return Rgb::BLACK;
        }
        let (at, r) = (&seen.surface, self.radius);
        let normal = facing(at.normal, view);
        let (mut sum, mut near_edge) = (Rgb::BLACK, true);
        for cell in self.cells_around(at.position) {
            for photon in self.sharing(cell) {
                let apart = photon.position - at.position;
                let height = apart.dot(*normal);
                let squared = apart.length_squared() - height * height;
                let near = squared < r * r && height.abs() < THICKNESS * r;
                if near
                    && photon.normal.dot(*normal) > ALIKE
                    && photon.surfaces <= most
                    && self.grid.cell(photon.position) == cell
                {
                    let f = seen.material.eval(at, view, photon.toward);
                    sum += f * photon.power * (1.0 - squared / (r * r));
                    near_edge &= photon.near_edge;
                }
            }
        }
        if near_edge && sum != Rgb::BLACK {
            sum = sum / Disc::new(scene, at, normal, r).part();
        }
        sum * (2.0 / (PI * r * r))
    }
    // ANCHOR_END: reflected

    /// The cells that the ball with the radius r around a point reaches: two on average, and eight at most.
    fn cells_around(&self, position: Vec3) -> impl Iterator<Item = [i32; 3]> + use<> {
        let [from, to] = [-self.radius, self.radius].map(|r| self.grid.cell(position + r));
        (from[0]..=to[0]).flat_map(move |x| {
            (from[1]..=to[1]).flat_map(move |y| (from[2]..=to[2]).map(move |z| [x, y, z]))
        })
    }

    /// The photons of all cells that share the bucket of this one.
    fn sharing(&self, cell: [i32; 3]) -> &[Photon] {
        let bucket = self.grid.bucket(cell);
        &self.landed[self.starts[bucket] as usize..self.starts[bucket + 1] as usize]
    }
}

/// Cubes without end in all directions, and the buckets in which they are kept.
#[derive(Clone, Copy)]
struct Grid {
    /// Number of cells per metre.
    per_metre: f32,
    /// Number of buckets, a power of two.
    buckets: usize,
}

impl Grid {
    /// A grid for about as many photons within this `radius`.
    fn new(radius: f32, photons: usize) -> Self {
        Self {
            per_metre: 1.0 / (WIDTH * radius),
            buckets: 2 * photons.next_power_of_two(),
        }
    }

    /// The cell that holds a point.
    fn cell(&self, position: Vec3) -> [i32; 3] {
        (position * self.per_metre).to_array().map(below)
    }

    /// The number of a cell's bucket: the first digits of the fraction of x/g + y/g² + z/g³, where g⁴ = g + 1. So cells side by side have
    /// buckets far apart, and all buckets are used about equally.
    fn bucket(&self, cell: [i32; 3]) -> usize {
        /// 2³² over g, g² and g³.
        const PARTS: [u32; 3] = [0xd1b5_4a33, 0xabc9_8389, 0x8cb9_2ba7];
        let terms = cell.iter().zip(PARTS);
        let fraction = terms.fold(0_u32, |sum, (v, part)| {
            sum.wrapping_add(part.wrapping_mul(*v as u32))
        });
        ((u64::from(fraction) * self.buckets as u64) >> 32) as usize
    }
}

/// Whether a light emits photons.
fn emits(light: &dyn Light) -> bool {
    let middle = Vec2::splat(0.5);
    light.emit(middle, middle).is_some()
}

// ANCHOR: landing
/// A photon of this light where it lands, with the power of the whole light; `None` if it lands nowhere, or has met no mirror or glass. The
/// photon is to light points within the `radius`.
///
/// A photon goes the way of a path, backwards: where a path counts the light that goes from one lamp by delta lobes to a surface, the
/// photons bring it. The lamp is in air, as [`Glass`](crate::material::glass::Glass) assumes. At a surface that scatters and also has
/// delta lobes, chance decides whether the photon lands or goes on.
fn landing(scene: &Scene, light: &dyn Light, radius: f32, numbers: &mut Even) -> Option<Photon> {
    let Emitted { mut ray, power } = light.emit(numbers.pair(), numbers.pair())?;
    let (mut weight, mut medium, mut surfaces) = (Rgb::WHITE, Medium::AIR, 0);
    loop {
        let seen = scene.closest(&ray)?;
        let toward = -ray.direction;
        let lobes = Lobes::of(&seen, toward);
        weight = weight * medium.transmittance(seen.t);
        let next = lobes.sample_delta(&seen, toward, numbers);
        if next.is_none() && (surfaces == 0 || !lobes.scatters) {
            return None;
        }
        if lamp_between(scene, &ray, seen.t) {
            return None;
        }
        let Some(next) = next else {
            let (at, narrowing) = (&seen.surface, medium.index * medium.index);
            let normal = facing(at.normal, toward);
            return Some(Photon {
                position: at.position,
                toward,
                normal,
                power: power * weight / (lobes.to_scatter() * narrowing),
                surfaces,
                near_edge: Disc::new(scene, at, normal, radius).is_near_edge(),
            });
        };
        weight = weight * next.weight;
        surfaces += 1;
        if surfaces > ROULETTE_AFTER {
            weight = roulette(weight, numbers)?;
        }
        ray = seen.surface.leave(next.toward);
        medium = next.medium.unwrap_or(medium);
    }
}
// ANCHOR_END: landing

/// Whether a ray meets a lamp before the distance t. A path that goes the same way backwards would see that lamp, and end there.
fn lamp_between(scene: &Scene, ray: &Ray, t: f32) -> bool {
    let back = Ray::new(ray.at(t), -ray.direction);
    let mut lights = scene.lights.iter();
    lights.any(|light| light.seen(&back, t * (1.0 - BEFORE_LIGHT)).is_some())
}

/// The normal, turned to the side of a direction.
fn facing(normal: Dir3, toward: Dir3) -> Dir3 {
    if normal.dot(*toward) < 0.0 {
        -normal
    } else {
        normal
    }
}
