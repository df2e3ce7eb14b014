//! Rays at a target, of five kinds.

use crate::patch::{Patch, direction, size_of};
use glam::Vec3;
use rand::RngExt;
use raybook::math::{basis::Basis, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_common::oracle::target::{Solid, Target};

/// A kind of rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// From one eye, side by side.
    Coherent,
    /// From anywhere around, most of them towards the shape.
    Random,
    /// Nearly along the surface; past a sphere, nearly touching it.
    Grazing,
    /// From the surface: away by the rule of `Surface::leave`; from there straight back; and away with a far beginning.
    FromSurface,
    /// Along an axis, with zeros of both signs.
    AxisParallel,
}

impl Kind {
    /// The name in recordings and tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Coherent => "coherent",
            Self::Random => "random",
            Self::Grazing => "grazing",
            Self::FromSurface => "from_surface",
            Self::AxisParallel => "axis_parallel",
        }
    }
}

/// All kinds.
pub const KINDS: [Kind; 5] = [
    Kind::Coherent,
    Kind::Random,
    Kind::Grazing,
    Kind::FromSurface,
    Kind::AxisParallel,
];

/// Number of rays, in each direction, that see a patch side by side.
const SIDE: u32 = 10;

/// n rays of a kind, and for each the interval that counts.
pub fn rays(kind: Kind, target: &Target, n: usize, rng: &mut Pcg) -> Vec<(Ray, Interval)> {
    let mut rays = Vec::with_capacity(n);
    while rays.len() < n {
        match kind {
            Kind::Coherent => rays.extend(coherent(target, rng).map(|ray| (ray, Interval::AHEAD))),
            Kind::Random => rays.push((random(target, rng), Interval::AHEAD)),
            Kind::Grazing => rays.push((grazing(target, rng), Interval::AHEAD)),
            Kind::FromSurface => rays.push(from_surface(target, rng)),
            Kind::AxisParallel => rays.push((axis_parallel(target, rng), Interval::AHEAD)),
        }
    }
    rays.truncate(n);
    for (i, (_, within)) in rays.iter_mut().enumerate() {
        // Every eighth ray looks at a stretch only.
        if i % 8 == 7 && *within == Interval::AHEAD && kind != Kind::FromSurface {
            within.min = size_of(target) * rng.random_range(0.0..1.5);
            within.max = within.min + size_of(target) * rng.random_range(0.0..3.0);
        }
        within.max = within.max.min(target.far);
    }
    rays
}

fn coherent(target: &Target, rng: &mut Pcg) -> impl Iterator<Item = Ray> + use<> {
    let patch = Patch::of(target, rng);
    let eye = around(patch.at(0.5, 0.5), target, rng);
    // Shifted by chance, lest rows and columns run along the edges.
    let shift: [f32; 2] = rng.random();
    (0..SIDE * SIDE).map(move |i| {
        let [x, y] = [i % SIDE, i / SIDE];
        let at = |i: u32, shift: f32| (i as f32 + shift) / SIDE as f32;
        let toward = patch.at(at(x, shift[0]), at(y, shift[1])) - eye;
        Ray::new(eye, Dir3::new_or(toward, patch.normal))
    })
}

fn random(target: &Target, rng: &mut Pcg) -> Ray {
    let patch = Patch::of(target, rng);
    let origin = around(patch.inside, target, rng);
    let any = direction(rng);
    let direction = match rng.random_range(0..4) {
        0 => any,
        1 => Dir3::new_or(patch.inside - origin, any),
        _ => Dir3::new_or(patch.at(rng.random(), rng.random()) - origin, any),
    };
    Ray::new(origin, direction)
}

fn grazing(target: &Target, rng: &mut Pcg) -> Ray {
    let patch = Patch::of(target, rng);
    let basis = Basis::around(patch.normal);
    let turn = direction(rng);
    let along = Dir3::new_or(turn.x * *basis.x + turn.y * *basis.y, basis.x);
    let small = [0.1, 0.03, 0.01, 0.003, 0.001][rng.random_range(0..5)] * sign(rng);
    let (through, direction) = match &target.solid {
        Solid::Triangles(_) => (
            patch.inside,
            Dir3::new_or(*along + small * *patch.normal, along),
        ),
        Solid::Sphere(sphere) => (patch.inside + small * sphere.radius * *patch.normal, along),
    };
    let back = size_of(target) * rng.random::<f32>();
    Ray::new(through - back * *direction, direction)
}

fn from_surface(target: &Target, rng: &mut Pcg) -> (Ray, Interval) {
    let patch = Patch::of(target, rng);
    let away = direction(rng);
    let eye = around(patch.inside, target, rng);
    let seeking = Ray::new(eye, Dir3::new_or(patch.inside - eye, away));
    let Some(hit) = target.shape.hit(&seeking, Interval::new(0.0, target.far)) else {
        return (seeking, Interval::AHEAD);
    };
    let surface = target.shape.surface(&seeking, &hit);
    let leaving = surface.leave(away);
    match rng.random_range(0..3) {
        0 => (leaving, Interval::AHEAD),
        1 => (Ray::new(leaving.origin, -away), Interval::AHEAD),
        _ => (
            Ray::new(surface.position, away),
            Interval::new(1e-3 * size_of(target), f32::INFINITY),
        ),
    }
}

fn axis_parallel(target: &Target, rng: &mut Pcg) -> Ray {
    let patch = Patch::of(target, rng);
    let mut through = patch.at(rng.random(), rng.random());
    let axis = [Dir3::X, Dir3::Y, Dir3::Z][rng.random_range(0..3)];
    if axis.dot(*patch.normal) == 0.0 {
        // In a face there is no right answer (`tests/facts.rs`): move off it, into the box.
        through -= size_of(target) * rng.random_range(0.05..0.5_f32) * *patch.normal;
    }
    let direction = if rng.random() { axis } else { -axis };
    let back = size_of(target) * rng.random_range(-0.2..1.0_f32);
    Ray::new(through - back * *direction, direction)
}

/// A point at most about two sizes of the target away.
fn around(p: Vec3, target: &Target, rng: &mut Pcg) -> Vec3 {
    p + size_of(target) * rng.random_range(0.2..2.0_f32) * *direction(rng)
}

fn sign(rng: &mut Pcg) -> f32 {
    if rng.random() { 1.0 } else { -1.0 }
}
