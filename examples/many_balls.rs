//! Hundreds of balls through a lens: `cargo run --release --example many_balls`. Chapter 19 draws the same scene.

use rand::RngExt;
use raybook::{math::pcg, prelude::*};
use std::error::Error;
use std::sync::Arc;

/// The material of a small ball, by chance.
fn any_material(random: &mut pcg::Pcg) -> Arc<dyn Material> {
    let [r, g, b] = random.random::<[f32; 3]>().map(|v| 0.05 + 0.75 * v * v);
    let albedo = Rgb::new(r, g, b);
    match random.random_range(0..10) {
        0..4 => Arc::new(Lambert { albedo }),
        4..8 => Arc::new(Plastic::new(albedo, 1.5)),
        8 => Arc::new(Conductor(Metal::SILVER)),
        _ => Arc::new(Glass::of(Medium::GLASS)),
    }
}

/// The balls, and the lens that is focused on the three large ones, for a picture of this width over its height.
pub(crate) fn balls(aspect: f32) -> Result<(Scene, ThinLens), Box<dyn Error>> {
    let ball = |x: f32, z: f32, radius: f32| Sphere::new(vec3(x, radius, z), radius);
    let (albedo, red) = (Rgb::gray(0.2), Rgb::new(0.6, 0.08, 0.03));
    let mut things = vec![
        Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Lambert { albedo }),
        Thing::new(ball(-3.2, -0.6, 1.0), Plastic::new(red, 1.5)),
        Thing::new(ball(0.0, 0.0, 1.0), Glass::of(Medium::GLASS)),
        Thing::new(ball(3.2, 0.6, 1.0), Conductor(Metal::GOLD)),
    ];
    let mut random = pcg::stream(7, 0);
    for (row, column) in (-14..14).flat_map(|row| (-25..11).map(move |column| (row, column))) {
        let place = vec2(row as f32, column as f32) + 0.8 * Vec2::from(random.random::<[f32; 2]>());
        let large = [vec2(-3.2, -0.6), Vec2::ZERO, vec2(3.2, 0.6)];
        if large.iter().all(|middle| place.distance(*middle) > 1.25) {
            let shape = Arc::new(ball(place.x, place.y, 0.2));
            let material = any_material(&mut random);
            things.push(Thing { shape, material });
        }
    }
    let sun = SphereLight {
        sphere: Sphere::new(vec3(30.0, 50.0, 30.0), 6.0),
        radiance: Rgb::new(85.0, 78.0, 65.0),
        choose: LightSampling::BySolidAngle,
    };
    let (pale, blue) = (Rgb::new(0.7, 0.75, 0.8), Rgb::new(0.1, 0.25, 0.6));
    let sky = move |ray: &Ray| pale.lerp(blue, ray.direction.y.abs());
    let scene = Scene::new(things, vec![Box::new(sun)]).surrounded_by(Rgb::BLACK, sky);
    let view = Pinhole::look_at(vec3(2.5, 2.8, 12.0), 0.1 * Vec3::Y, Vec3::Y, 0.0565, aspect)?;
    let camera = ThinLens::with_view(&view, 0.15, 11.8, Aperture::Round)?;
    Ok((scene, camera))
}

fn main() -> Result<(), Box<dyn Error>> {
    let film = Film::new(800, 450, 64);
    let (scene, camera) = balls(film.aspect())?;
    let draw = |film: &Film| film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
    let picture = film.denoised(&[], draw).map(tone::aces);
    Ok(file::save("many_balls.png".as_ref(), &picture)?)
}
