//! Chapter 17: what is known about the rendering equation without solving it, and path tracing held against it.

mod brdf;
mod cells;
mod cornell;
mod delta_lobes;
mod furnace;
mod hemisphere;
mod integrators;
mod materials;
mod mis;
mod photons;
mod strategies;

use glam::{Vec2, Vec3, vec2};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::material::Material;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook::render::{mis::Strategy, path::Path};
use raybook::scene::world::Thing;
use raybook::shape::{Shape, Surface};

/// Paths without end, by the best strategy.
const ALL: Path = Path {
    depth: u32::MAX,
    roulette_after: 3,
    strategy: Strategy::Both,
};

fn direction(x: f32, y: f32, z: f32) -> Dir3 {
    Dir3::new(Vec3::new(x, y, z)).expect("a direction")
}

/// A surface at the origin.
fn surface(normal: Dir3) -> Surface {
    Surface::flat(Vec3::ZERO, 0.0, normal)
}

fn thing(shape: impl Shape + 'static, material: impl Material + 'static) -> Thing {
    Thing::new(shape, material)
}

fn square(rng: &mut Pcg) -> Vec2 {
    vec2(rng.random(), rng.random())
}

/// ∫ f dω over the hemisphere around +z, by the midpoints of rings of equal height: for smooth f.
fn integral(f: impl Fn(Dir3) -> f32) -> f64 {
    const RINGS: u32 = 400;
    const SECTORS: u32 = 200;
    let piece = std::f64::consts::TAU / f64::from(RINGS * SECTORS);
    let cells = (0..RINGS).flat_map(|i| (0..SECTORS).map(move |j| (i, j)));
    let values = cells.map(|(i, j)| {
        let z = (i as f32 + 0.5) / RINGS as f32;
        let phi = std::f32::consts::TAU * (j as f32 + 0.5) / SECTORS as f32;
        let r = (1.0 - z * z).sqrt();
        f64::from(f(direction(r * phi.cos(), r * phi.sin(), z)))
    });
    piece * values.sum::<f64>()
}

/// What a surface emits on top of what it reflects.
struct Glowing<B> {
    brdf: B,
    emission: Rgb,
}

impl<B: Material> Material for Glowing<B> {
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        self.brdf.eval(at, view, toward)
    }

    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        self.brdf.sample(at, view, u)
    }

    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        self.brdf.pdf(at, view, toward)
    }

    fn emitted(&self, _at: &Surface, _view: Dir3) -> Rgb {
        self.emission
    }
}
