//! What the denoiser is told of a picture.

use glam::{Vec3, vec3};
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::material::{lambert::Lambert, mirror::Mirror};
use raybook::math::dir3::Dir3;
use raybook::render::film::Film;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{plane::Plane, sphere::Sphere};

#[test]
fn a_guide_is_what_is_seen_also_in_a_mirror() {
    let blue = Rgb::new(0.1, 0.2, 0.7);
    let sky = Rgb::new(0.5, 0.6, 0.9);
    // The camera looks down at a mirror, and in it up at a ball in the sky.
    let scene = Scene::new(
        vec![
            Thing::new(
                Plane::through(Vec3::ZERO, Dir3::Y),
                Mirror { share: Rgb::WHITE },
            ),
            Thing::new(
                Sphere::new(vec3(0.0, 12.0, 0.0), 1.0),
                Lambert { albedo: blue },
            ),
        ],
        vec![],
    )
    .surrounded_by(Rgb::BLACK, move |_| sky);
    let eye = vec3(0.0, 5.0, 0.0);
    let camera = Pinhole::look_at(eye, Vec3::ZERO, Vec3::Z, 0.05, 1.0).unwrap();
    let film = Film::new(33, 33, 1);
    let guides = film.guides(&camera, &scene);
    assert_eq!(guides.len(), 33 * 33);
    let (middle, corner) = (guides[16 * 33 + 16], guides[0]);
    let near = |a: f32, b: f32| (a - b).abs() < 0.01;
    let same = |a: Rgb, b: Rgb| (0..3).all(|i| near(a.channels()[i], b.channels()[i]));
    assert!(same(middle.colour, blue), "{middle:?}");
    assert!(middle.normal.distance(-Vec3::Y) < 0.1, "{middle:?}");
    assert!(
        near(middle.nearness, 1.0 / 16.0),
        "5 m down and 11 m up: {middle:?}"
    );
    assert!(same(corner.colour, sky), "{corner:?}");
    assert!(
        corner.normal == Vec3::ZERO && corner.nearness == 0.0,
        "{corner:?}"
    );
}
