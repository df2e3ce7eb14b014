//! Frames of an animation: the teapot turns, and is built once. `frame_00.png` to `frame_07.png`

use glam::Mat3;
use raybook::prelude::*;
use raybook::shape::teapot;
use std::error::Error;
use std::f32::consts::TAU;
use std::sync::Arc;

fn main() -> Result<(), Box<dyn Error>> {
    const FRAMES: usize = 8;
    let pot: Arc<dyn Shape> = Arc::new(Meshed::new(teapot::mesh(8), WideBvh::new));
    let film = Film::new(320, 240, 16);
    let camera = Pinhole::look_at(
        vec3(0.0, 4.0, 10.0),
        vec3(0.0, 1.4, 0.0),
        Vec3::Y,
        0.035,
        film.aspect(),
    )?;
    let path = Path {
        depth: 3,
        roulette_after: 3,
        strategy: Strategy::Surface,
    };
    for frame in 0..FRAMES {
        let turned = Instance {
            shape: pot.clone(),
            scale: 1.0,
            rotation: Mat3::from_rotation_y(TAU * frame as f32 / FRAMES as f32),
            translation: Vec3::ZERO,
        };
        let clay = Lambert {
            albedo: Rgb::new(0.7, 0.4, 0.25),
        };
        let scene = Scene::new(vec![Thing::new(turned, clay)], vec![])
            .surrounded_by(Rgb::BLACK, |ray| Rgb::gray(0.7 + 0.3 * ray.direction.y));
        let picture = film.render(&camera, &Sampler::Even, &path, &scene);
        let name = format!("frame_{frame:02}.png");
        file::save(name.as_ref(), &picture)?;
        println!("wrote {name}");
    }
    Ok(())
}
