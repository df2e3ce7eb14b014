//! Light from a picture of all directions: `cargo run --release --example environment -- sky.hdr` (latitude and longitude)

use raybook::prelude::*;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let map = match std::env::args_os().nth(1) {
        Some(file) => file::load(file.as_ref())?,
        None => Image::from_fn(64, 32, |x, y| {
            // A lamp in a blue sky, above grey ground.
            let lamp = (20..24).contains(&x) && (6..9).contains(&y);
            if lamp {
                Rgb::gray(60.0)
            } else if y < 16 {
                Rgb::new(0.3, 0.5, 0.8)
            } else {
                Rgb::gray(0.2)
            }
        }),
    };
    let ball = |x: f32| Sphere::new(vec3(x, 1.0, 0.0), 1.0);
    let things = vec![
        Thing::new(
            Plane::through(Vec3::ZERO, Dir3::Y),
            Lambert {
                albedo: Rgb::gray(0.5),
            },
        ),
        Thing::new(ball(-2.2), Conductor(Metal::SILVER)),
        Thing::new(ball(0.0), Glass::of(Medium::GLASS)),
        Thing::new(
            ball(2.2),
            Ggx {
                metal: Metal::COPPER,
                alpha: 0.3,
            },
        ),
    ];
    let scene = Scene::new(things, vec![Box::new(Environment::new(map))]);
    let film = Film::new(600, 300, 64);
    let camera = Pinhole::look_at(
        vec3(0.0, 2.0, 9.0),
        vec3(0.0, 0.9, 0.0),
        Vec3::Y,
        0.045,
        film.aspect(),
    )?;
    let picture = film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
    file::save("environment.png".as_ref(), &picture.map(tone::aces))?;
    println!("wrote environment.png");
    Ok(())
}
