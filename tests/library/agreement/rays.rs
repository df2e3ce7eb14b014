//! Rays that structures dislike: from inside, on faces, along edges and axes, with zeros of both signs.

use crate::agreement::scenes::{Scene, lattice_point, point};
use glam::{Vec3, vec3};
use proptest::prelude::*;
use proptest::sample::Index;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::Shape;

/// A ray in the scene's own measure.
#[derive(Clone, Debug)]
pub(super) enum RayRecipe {
    /// From a place to a place.
    Between(Vec3, Vec3, Stretch),
    /// Along an axis, with zeros of these signs.
    Axis(Vec3, usize, [bool; 3], Stretch),
    /// From a place to the middle of the bounds of one of the shapes, or to a corner of them.
    At(Vec3, Index, Vec3, Stretch),
    /// From the middle of the bounds of one shape to that of another.
    From(Index, Index, Stretch),
}

/// Which part of the ray counts.
#[derive(Clone, Copy, Debug)]
pub(super) enum Stretch {
    Ahead,
    Between(f32, f32),
    Backwards,
}

pub(super) fn recipe() -> impl Strategy<Value = RayRecipe> {
    let stretch = || {
        prop_oneof![
            6 => Just(Stretch::Ahead),
            2 => (0.0_f32..3.0, 0.0_f32..4.0).prop_map(|(min, length)| Stretch::Between(min, min + length)),
            1 => Just(Stretch::Backwards),
        ]
    };
    let any_place = || prop_oneof![lattice_point(), point(), point().prop_map(|p| 8.0 * p)];
    let of_a_corner = prop_oneof![
        Just(Vec3::ZERO),
        lattice_point().prop_map(glam::Vec3::signum),
        point().prop_map(|p| 0.4 * p)
    ];
    prop_oneof![
        2 => (lattice_point(), lattice_point(), stretch()).prop_map(|(p, q, s)| RayRecipe::Between(p, q, s)),
        1 => (any_place(), any_place(), stretch()).prop_map(|(p, q, s)| RayRecipe::Between(p, q, s)),
        2 => (any_place(), 0..3_usize, any::<[bool; 3]>(), stretch())
            .prop_map(|(p, axis, signs, s)| RayRecipe::Axis(p, axis, signs, s)),
        4 => (any_place(), any::<Index>(), of_a_corner, stretch()).prop_map(|(p, i, q, s)| RayRecipe::At(p, i, q, s)),
        1 => (any::<Index>(), any::<Index>(), stretch()).prop_map(|(i, j, s)| RayRecipe::From(i, j, s)),
    ]
}

impl RayRecipe {
    /// The ray, and the interval that counts.
    pub(super) fn in_scene<S: Shape>(&self, scene: &Scene<S>) -> (Ray, Interval) {
        let at = |p: Vec3| scene.scale * p + scene.center;
        let bounds = |i: &Index| {
            let bounds = i.get(&scene.shapes).bounds();
            Some(bounds).filter(|b| b.min.is_finite() && b.max.is_finite())
        };
        let of_shape = |i: &Index, part: Vec3| {
            if scene.shapes.is_empty() {
                return scene.center;
            }
            bounds(i).map_or(scene.center, |b| b.center() + 0.5 * part * b.size())
        };
        let (origin, toward, stretch) = match self {
            Self::Between(p, q, stretch) => (at(*p), at(*q) - at(*p), stretch),
            Self::Axis(p, axis, signs, stretch) => {
                let zero = |negative: bool| if negative { -0.0 } else { 0.0 };
                let mut toward = signs.map(zero);
                toward[*axis] = if signs[*axis] { -1.0 } else { 1.0 };
                (at(*p), Vec3::from(toward), stretch)
            }
            Self::At(p, i, part, stretch) => (at(*p), of_shape(i, *part) - at(*p), stretch),
            Self::From(i, j, stretch) => {
                let (p, q) = (of_shape(i, Vec3::ZERO), of_shape(j, Vec3::ZERO));
                (p, q - p, stretch)
            }
        };
        let direction = Dir3::new_or(toward, Dir3::new_or(vec3(1.0, -2.0, 0.5), Dir3::X));
        let within = match *stretch {
            Stretch::Ahead => Interval::AHEAD,
            Stretch::Between(min, max) => Interval::new(scene.scale * min, scene.scale * max),
            Stretch::Backwards => Interval::new(-3.0 * scene.scale, 2.0 * scene.scale),
        };
        (Ray::new(origin, direction), within)
    }
}
