//! A first picture: a ball of gold on a matte floor, under a lamp. `cargo run --release --example first_picture`

use raybook::prelude::*;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let matte = Lambert {
        albedo: Rgb::gray(0.6),
    };
    let gold = Ggx {
        metal: Metal::GOLD,
        alpha: 0.15,
    };
    let things = vec![
        Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), matte),
        Thing::new(Sphere::new(vec3(0.0, 1.0, 0.0), 1.0), gold),
    ];
    // A lamp of 2 m × 2 m that shines down from 4 m above the floor.
    let lamp = RectLight::new(
        vec3(-1.0, 4.0, -1.0),
        2.0 * Vec3::X,
        2.0 * Vec3::Z,
        Rgb::gray(12.0),
    );
    let sky = |ray: &Ray| Rgb::new(0.5, 0.6, 0.8) * (0.3 + 0.5 * ray.direction.y.abs());
    let scene = Scene::new(things, vec![Box::new(lamp)]).surrounded_by(Rgb::BLACK, sky);

    let film = Film::new(480, 320, 64);
    let camera = Pinhole::look_at(
        vec3(2.0, 2.2, 6.0),
        vec3(0.0, 0.9, 0.0),
        Vec3::Y,
        focal_length(38.0),
        film.aspect(),
    )?;
    let picture = film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
    file::save("first_picture.png".as_ref(), &picture.map(tone::aces))?;
    println!("wrote first_picture.png");
    Ok(())
}
