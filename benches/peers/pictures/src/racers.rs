//! Those who race: raybook's path tracer, and that of the crate `rpt`, each with the same scene and camera.

use crate::room::{Quad, by_colour, degrees};
use raybook::prelude::*;
use raybook::scene::cornell::{EYE, LAMP};
use rpt::{SceneAdd, glm};
use std::error::Error;

/// Edge of the picture, in pixels.
pub(crate) const EDGE: u32 = 96;
/// Number of surfaces over which light is followed.
pub(crate) const DEPTH: u32 = 6;
/// The exponent that both encode a channel with.
const GAMMA: f32 = 1.0 / 2.2;

/// raybook's path tracer.
pub(crate) struct Ours {
    scene: Scene,
    camera: Pinhole,
}

impl Ours {
    pub(crate) fn new(quads: &[Quad], lamp: [Vec3; 4]) -> Self {
        let things = by_colour(quads).map(|(albedo, quads)| {
            let triangles = (0..quads.len() as u32).flat_map(|i| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|corner| 4 * i + corner);
                [[a, b, c], [a, c, d]]
            });
            let mesh = Mesh::new(quads.concat(), triangles.collect(), None, None);
            let mesh = mesh.expect("the box is a mesh");
            Thing::new(Meshed::new(mesh, WideBvh::new), Lambert { albedo })
        });
        let [a, b, _, d] = lamp;
        let lamp = RectLight::new(a, b - a, d - a, LAMP);
        let camera = Pinhole::look_at(EYE, EYE + Vec3::Z, Vec3::Y, focal_length(degrees()), 1.0);
        Self {
            scene: Scene::new(things.into(), vec![Box::new(lamp)]),
            camera: camera.expect("it looks along z"),
        }
    }

    pub(crate) fn draw(&self, samples: u32, seed: u64) -> Vec<f32> {
        let film = Film {
            threads: 1,
            seed,
            ..Film::new(EDGE as usize, EDGE as usize, samples as usize)
        };
        let path = Path {
            depth: DEPTH,
            ..Path::WHOLE
        };
        let picture = film.render(&self.camera, &Sampler::Even, &path, &self.scene);
        picture
            .pixels()
            .iter()
            .flat_map(|pixel| pixel.channels().map(encoded))
            .collect()
    }
}

/// The path tracer of the crate `rpt`.
pub(crate) struct Theirs {
    scene: rpt::Scene,
    camera: rpt::Camera,
    threads: rayon::ThreadPool,
}

impl Theirs {
    pub(crate) fn new(quads: &[Quad], lamp: [Vec3; 4]) -> Result<Self, Box<dyn Error>> {
        let at = |p: Vec3| glm::vec3(f64::from(p.x), f64::from(p.y), f64::from(p.z));
        let colour = |c: Rgb| glm::vec3(f64::from(c.r), f64::from(c.g), f64::from(c.b));
        let mut scene = rpt::Scene::new();
        for (albedo, quads) in by_colour(quads) {
            let triangles = quads.iter().flat_map(|quad| {
                let [a, b, c, d] = quad.map(at);
                [[a, b, c], [a, c, d]].map(|[a, b, c]| rpt::Triangle::from_vertices(a, b, c))
            });
            // Without a coat: its index is that of air.
            let matte = rpt::Material {
                index: 1.0,
                ..rpt::Material::diffuse(colour(albedo))
            };
            scene.add(rpt::Object::new(rpt::Mesh::new(triangles.collect())).material(matte));
        }
        let shine = rpt::Material::light(colour(LAMP), 1.0);
        let lamp = rpt::Object::new(rpt::polygon(&lamp.map(at))).material(shine);
        scene.add(rpt::Light::Object(lamp));
        let fov = f64::from(degrees()).to_radians();
        let camera = rpt::Camera::look_at(at(EYE), at(EYE + Vec3::Z), at(Vec3::Y), fov);
        let threads = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
        Ok(Self {
            scene,
            camera,
            threads,
        })
    }

    pub(crate) fn draw(&self, samples: u32) -> Vec<f32> {
        let renderer = rpt::Renderer::new(&self.scene, self.camera)
            .width(EDGE)
            .height(EDGE)
            .max_bounces(DEPTH - 1)
            .num_samples(samples);
        let picture = self.threads.install(|| renderer.render());
        picture
            .into_raw()
            .iter()
            .map(|v| f32::from(*v) / 255.0)
            .collect()
    }
}

/// A channel as both encode it.
fn encoded(v: f32) -> f32 {
    (v.clamp(0.0, 1.0).powf(GAMMA) * 255.0).floor() / 255.0
}
