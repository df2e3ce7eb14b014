//! What a camera sees without noise: the guides of the denoiser.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let floor = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Lambert { albedo: Rgb::gray(0.5) });
//! let scene = Scene::new(vec![floor], vec![]);
//! let camera = Pinhole::look_at(vec3(0.0, 2.0, 0.0), Vec3::ZERO, Vec3::Z, focal_length(1.0), 1.0)?;
//! let guides = Film::new(1, 1, 4).guides(&camera, &scene);
//! assert!((guides[0].nearness - 0.5).abs() < 1e-3); // 1/(2 m)
//! assert!((guides[0].colour.g - 0.5).abs() < 1e-3 && guides[0].normal.y > 0.999);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::camera::Camera;
use crate::image::{denoise::Guide, rgb::Rgb};
use crate::material::Delta;
use crate::math::ray::Ray;
use crate::render::film::{Done, Film, place_in_pixel};
use crate::scene::world::Scene;
use glam::{Vec2, Vec3};

/// Number of samples per pixel. There is no noise but at edges, where they tell how much of the pixel each surface covers.
const SAMPLES: usize = 8;

/// Maximum number of mirrors and panes of glass through which a ray goes to a surface.
const PANES: u32 = 4;

impl Film<'_> {
    /// What the camera sees in each pixel, row by row, through the middle of its lens. Where it looks into a smooth mirror or through
    /// smooth glass, this is what is seen there.
    pub fn guides(&self, camera: &dyn Camera, scene: &Scene) -> Vec<Guide> {
        let aside = Film {
            progress: &|done| (self.progress)(Done { pixels: 0, ..done }),
            ..*self
        };
        aside.each_pixel(&|x, y, rng| {
            let places = place_in_pixel(SAMPLES, rng);
            let mut sum = Guide::default();
            for i in 0..SAMPLES {
                let place = self.place([x, y], places(i));
                if camera.sees(place) {
                    sum += seen(scene, &camera.central_ray(place));
                }
            }
            (sum / SAMPLES as f32, SAMPLES as u64)
        })
    }
}

/// What is seen along a ray.
fn seen(scene: &Scene, ray: &Ray) -> Guide {
    let (mut ray, mut distance) = (*ray, 0.0);
    for _ in 0..=PANES {
        let Some(seen) = scene.closest(&ray) else {
            break;
        };
        distance += seen.t;
        let (at, view) = (&seen.surface, -ray.direction);
        let mut lobe: Option<Delta> = None;
        seen.material.delta_lobes(at, view, &mut |other| {
            let share = |lobe: &Delta| lobe.share.max_channel();
            if lobe.is_none_or(|lobe| share(&other) > share(&lobe)) {
                lobe = Some(other);
            }
        });
        match lobe {
            Some(lobe) if !seen.material.scatters(at) => ray = at.leave(lobe.toward),
            _ => {
                // For matte paint this is its albedo; for any other material it is at least typical of its colour.
                let reflected = seen.material.scatter(at, view, Vec2::splat(0.5));
                let reflected = reflected.map_or(Rgb::BLACK, |scattered| {
                    scattered.f * (at.facing(view).dot(*scattered.toward) / scattered.pdf)
                });
                return Guide {
                    colour: seen.material.emitted(at, view) + reflected,
                    normal: *at.facing(view),
                    nearness: 1.0 / distance,
                };
            }
        }
    }
    Guide {
        colour: scene.behind_everything(&ray),
        normal: Vec3::ZERO,
        nearness: 0.0,
    }
}
