//! The tree of rays that answer for one pixel.

use glam::{Vec2, Vec3};
use raybook::image::rgb::Rgb;
use raybook::light::LightSample;
use raybook::material::{Sight, beyond};
use raybook::math::ray::Ray;
use raybook::render::whitted::Whitted;
use raybook::scene::world::{Scene, Seen};

/// How a ray came to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// From the camera.
    Camera,
    /// Mirrored at a surface.
    Reflected,
    /// Through a surface.
    Refracted,
    /// To a light.
    Light,
}

/// Where a ray ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// On a surface.
    Surface,
    /// Nowhere: it sees the backdrop.
    Backdrop,
    /// At the maximum depth.
    Limit,
    /// At a light.
    Light,
    /// Before the light: something is in the way.
    Shadow,
}

/// A ray, and the rays that it asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// How it came to be.
    pub kind: Kind,
    /// Where it starts.
    pub from: Vec3,
    /// Where it goes.
    pub direction: Vec3,
    /// How far it goes, in metres; may be infinite.
    pub distance: f32,
    /// Where it ended.
    pub end: End,
    /// The radiance that the ray sees; for a ray to a light, the light that the surface reflects.
    pub sees: Rgb,
    /// The rays that it asked for, in order.
    pub asks: Vec<Branch>,
}

/// The tree of a ray from the camera, as [`Whitted::radiance`] follows it; a light with an extent is sampled at its middle.
///
/// A material gets the radiance along further rays by a closure: here the closure keeps these rays.
pub fn grow(whitted: &Whitted, scene: &Scene, ray: &Ray) -> Branch {
    follow(whitted, scene, ray, (Kind::Camera, whitted.depth))
}

fn follow(whitted: &Whitted, scene: &Scene, ray: &Ray, (kind, left): (Kind, u32)) -> Branch {
    let branch = |distance, end, sees, asks| Branch {
        kind,
        from: ray.origin,
        direction: *ray.direction,
        distance,
        end,
        sees,
        asks,
    };
    if left == 0 {
        return branch(f32::INFINITY, End::Limit, Rgb::BLACK, Vec::new());
    }
    let Some(seen) = scene.closest(ray) else {
        let backdrop = scene.behind_everything(ray);
        return branch(f32::INFINITY, End::Backdrop, backdrop, Vec::new());
    };
    let view = -ray.direction;
    let mut asks: Vec<_> = scene
        .lights
        .iter()
        .filter_map(|light| light.sample(seen.surface.position, Vec2::splat(0.5)))
        .map(|sample| (seen.material.lit(&seen.surface, view, &sample), sample))
        .filter(|(lit, _)| *lit != Rgb::BLACK)
        .map(|(lit, sample)| {
            let arrives = whitted.local.arrives;
            let arrives = arrives.is_none_or(|arrives| arrives(scene, &seen.surface, &sample));
            toward_light(&seen, &sample, arrives.then_some(lit))
        })
        .collect();
    let lit: Rgb = asks.iter().map(|branch| branch.sees).sum();
    let mut see = |onward: &Ray, _: f32| {
        let through =
            seen.surface.normal.dot(*onward.direction) * seen.surface.normal.dot(*view) < 0.0;
        let kind = if through {
            Kind::Refracted
        } else {
            Kind::Reflected
        };
        let branch = follow(whitted, scene, onward, (kind, left - 1));
        let sight = Sight {
            radiance: branch.sees,
            distance: branch.distance,
        };
        asks.push(branch);
        sight
    };
    let beyond = beyond(seen.material, &seen.surface, view, &mut see);
    let ambient = seen.material.ambient(&seen.surface) * scene.ambient;
    branch(seen.t, End::Surface, ambient + lit + beyond, asks)
}

/// The ray to a light, and the light that the surface reflects if the light arrives.
fn toward_light(seen: &Seen, light: &LightSample, lit: Option<Rgb>) -> Branch {
    Branch {
        kind: Kind::Light,
        from: seen.surface.position,
        direction: *light.toward,
        distance: light.distance,
        end: if lit.is_some() {
            End::Light
        } else {
            End::Shadow
        },
        sees: lit.unwrap_or(Rgb::BLACK),
        asks: Vec::new(),
    }
}
