//! A panorama lights what was never there as the scene itself would.

use crate::ch20_panorama::{film, panorama, seen};
use glam::Vec3;
use raybook::camera::Camera;
use raybook::camera::fisheye::{Fisheye, Projection};
use raybook::camera::pose::Pose;
use raybook::image::rgb::Rgb;
use raybook::light::environment::Environment;
use raybook::material::lambert::Lambert;
use raybook::math::{basis::Basis, dir3::Dir3, ray::Ray};
use raybook::render::{mis::Strategy, path::Path};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::sphere::Sphere;
use raybook_chapters::ch20_panorama::pavilion::{self, EYE};
use raybook_chapters::ch20_panorama::summer;
use raybook_common::statistics::Mean;
use std::f64::consts::PI;

const ALBEDO: f32 = 0.5;

/// What arrives at the eye's place on a surface with this normal: an orthographic fisheye weights every direction by its
/// cosine, so that it is π times the mean of its disc.
fn irradiance(normal: Dir3) -> f64 {
    let scene = pavilion::scene();
    let Basis { x, y, .. } = Basis::around(-normal);
    let pose = Pose {
        position: EYE,
        forward: normal,
        right: x,
        up: y,
    };
    let camera = Fisheye::new(pose, Projection::Orthographic, 180.0, 1.0).expect("half a space");
    let picture = film(600, 600).sample(|place, _| {
        if !camera.sees(place) {
            return Rgb::gray(-1.0); // a number which no radiance is
        }
        seen(&scene, &camera.central_ray(place))
    });
    let lit = picture.pixels().iter().filter(|pixel| pixel.g >= 0.0);
    let (sum, count) = lit.fold((0.0, 0.0), |(sum, count), pixel| {
        (sum + f64::from(pixel.g), count + 1.0)
    });
    PI * sum / count
}

#[test]
fn a_matt_ball_in_the_panoramas_light_is_as_bright_as_at_that_place() {
    let environment = Environment::new(panorama(&pavilion::scene(), EYE, 1024));
    let albedo = Rgb::gray(ALBEDO);
    let ball: Thing = Thing::new(Sphere::new(Vec3::ZERO, 1.0), Lambert { albedo });
    let scene = Scene::new(vec![ball], vec![Box::new(environment)]);
    let path = Path {
        depth: 3,
        roulette_after: 3,
        strategy: Strategy::Both,
    };
    let normals = [Dir3::Y, -Dir3::Y, Dir3::X, -Dir3::Z, summer::toward_sun()];
    let mut brightest = (0.0_f64, f64::MAX);
    for normal in normals {
        let expected = irradiance(normal) * f64::from(ALBEDO) / PI;
        let ray = Ray::new(5.0 * *normal, -normal);
        let ball = Mean::sampled(206, 500, |rng| path.radiance(&scene, &ray, rng).g);
        // The sun's rim is cut into pixels in both: they keep about 1 % more or less of it.
        let off = (ball.mean / expected - 1.0).abs();
        assert!(
            off < 0.03 && ball.error < 0.01 * ball.mean,
            "towards {normal:?}: {ball:?}, and {expected} is what arrives there"
        );
        brightest = (brightest.0.max(expected), brightest.1.min(expected));
    }
    assert!(
        brightest.0 > 3.0 * brightest.1,
        "the sun is not everywhere: from {} to {}",
        brightest.1,
        brightest.0
    );
}
