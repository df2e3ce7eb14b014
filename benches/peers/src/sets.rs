//! The sets of rays.

use crate::meshes::{Scene, ball};
use crate::racer::{Query, Question};
use crate::racers::embree::Embree;
use glam::{Vec3, vec2, vec3};
use rand::RngExt;
use raybook::camera::Camera;
use raybook::math::basis::Basis;
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::Surface;
use std::f32::consts::TAU;

/// Rays of one kind, and what is asked of them.
pub(crate) struct Set {
    /// The name in tables.
    pub name: &'static str,
    /// What is asked; of incoherent rays, the nearest hits also in batches.
    pub queries: &'static [Query],
    /// The rays.
    pub questions: Vec<Question>,
}

/// How far a ray of ambient occlusion looks: this part of the mesh's radius.
const NEARBY: f32 = 0.1;

/// All sets at a mesh: of primary rays side², of the others `count`.
///
/// The later sets begin where the primary rays of Embree end: at visible points, in the order of the pixels.
pub(crate) fn sets(scene: &Scene, embree: &Embree, side: usize, count: usize) -> Vec<Set> {
    let primary: Vec<_> = (0..side * side)
        .map(|i| through_pixel(scene, side, i))
        .collect();
    let seen: Vec<Surface> = primary
        .iter()
        .filter_map(|question| {
            let hit = embree.hit(question)?;
            Some(scene.mesh.surface(&question.0, &hit))
        })
        .collect();
    let from_seen = |kind: u64, leave: &dyn Fn(&Surface, &mut Pcg) -> Option<Question>| {
        let mut rng = pcg::stream(3, kind);
        // Evenly over the picture, and again from the start if there are too few.
        let place = |i: usize| (i * seen.len() / count.min(seen.len()).max(1)) % seen.len().max(1);
        let points = (0..2 * count).map_while(|i| seen.get(place(i)));
        points
            .filter_map(|surface| leave(surface, &mut rng))
            .take(count)
            .collect()
    };
    let (center, radius) = ball(&scene.mesh);
    let mut rng = pcg::stream(3, 0);
    let random = (0..count)
        .map(|_| through_ball(center, radius, &mut rng))
        .collect();
    let bounce =
        |surface: &Surface, rng: &mut Pcg| Some((cosine_ray(surface, scene, rng), Interval::AHEAD));
    let shadow = |surface: &Surface, rng: &mut Pcg| {
        let light = center
            + radius
                * vec3(
                    0.3 + 0.1 * rng.random::<f32>(),
                    1.5,
                    0.5 + 0.1 * rng.random::<f32>(),
                );
        let toward = Dir3::new(light - surface.position)?;
        let ray = facing(surface, scene).leave(toward);
        Some((ray, Interval::new(0.0, light.distance(ray.origin))))
    };
    let occlusion = |surface: &Surface, rng: &mut Pcg| {
        Some((
            cosine_ray(surface, scene, rng),
            Interval::new(0.0, NEARBY * radius),
        ))
    };
    let both: &[Query] = &[Query::Closest, Query::ClosestMany];
    let set = |name, queries, questions| Set {
        name,
        queries,
        questions,
    };
    vec![
        set("random", both, random),
        set("diffuse", both, from_seen(1, &bounce)),
        set("shadow", &[Query::Any], from_seen(2, &shadow)),
        set("occlusion", &[Query::Any], from_seen(3, &occlusion)),
        set("primary", &[Query::Closest], primary),
    ]
}

fn through_pixel(scene: &Scene, side: usize, i: usize) -> Question {
    let [x, y] = [i % side, i / side].map(|i| (i as f32 + 0.5) / side as f32);
    (scene.camera.central_ray(vec2(x, y)), Interval::AHEAD)
}

/// From a point of the sphere around the mesh to another one.
fn through_ball(center: Vec3, radius: f32, rng: &mut Pcg) -> Question {
    let [from, to] = [(); 2].map(|()| center + radius * *direction(rng));
    let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
    (ray, Interval::AHEAD)
}

/// The surface as its viewer sees it: the normal on his side.
fn facing(surface: &Surface, scene: &Scene) -> Surface {
    let toward_viewer = scene.camera.focal_point - surface.position;
    let normal = if surface.normal.dot(toward_viewer) < 0.0 {
        -surface.normal
    } else {
        surface.normal
    };
    Surface { normal, ..*surface }
}

/// A direction around the normal, as likely as its cosine is large.
fn cosine_ray(surface: &Surface, scene: &Scene, rng: &mut Pcg) -> Ray {
    let surface = facing(surface, scene);
    let (r2, angle) = (rng.random::<f32>(), TAU * rng.random::<f32>());
    let (r, up) = (r2.sqrt(), (1.0 - r2).sqrt());
    let toward = Basis::around(surface.normal).to_world(vec3(r * angle.cos(), r * angle.sin(), up));
    surface.leave(Dir3::new_or(toward, surface.normal))
}

/// A direction, each as likely as any other.
fn direction(rng: &mut Pcg) -> Dir3 {
    let (z, angle) = (2.0 * rng.random::<f32>() - 1.0, TAU * rng.random::<f32>());
    let r = (1.0 - z * z).sqrt();
    Dir3::new_or(vec3(r * angle.cos(), r * angle.sin(), z), Dir3::Z)
}
