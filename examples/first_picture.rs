//! A first picture: a ball of gold on a matte floor, under a lamp. `cargo run --release --example first_picture`

use raybook::prelude::*;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let albedo = Rgb::gray(0.6);
    let floor = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Lambert { albedo });
    let (metal, alpha) = (Metal::GOLD, 0.15);
    let ball = Thing::new(Sphere::new(Vec3::Y, 1.0), Ggx { metal, alpha });
    // A lamp of 2 m × 2 m that shines down from 4 m above the floor.
    let corner = vec3(-1.0, 4.0, -1.0);
    let lamp = RectLight::new(corner, 2.0 * Vec3::X, 2.0 * Vec3::Z, Rgb::gray(12.0));
    let sky = |ray: &Ray| Rgb::new(0.5, 0.6, 0.8) * (0.3 + 0.5 * ray.direction.y.abs());
    let scene = Scene::new(vec![floor, ball], vec![Box::new(lamp)]).surrounded_by(Rgb::BLACK, sky);

    let film = Film::new(480, 320, 64);
    let (eye, middle) = (vec3(2.0, 2.2, 6.0), vec3(0.0, 0.9, 0.0));
    let camera = Pinhole::look_at(eye, middle, Vec3::Y, focal_length(38.0), film.aspect())?;
    let picture = film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
    file::save("first_picture.png".as_ref(), &picture.map(tone::aces))?;
    println!("wrote first_picture.png");
    Ok(())
}
