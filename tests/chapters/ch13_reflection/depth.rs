//! Mirrors that face each other, and where it ends.

use crate::ch13_reflection::rays::ray;
use crate::ch13_reflection::see;
use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::material::{Delta, Material, mirror::Mirror, phong::Phong};
use raybook::math::dir3::Dir3;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Surface, plane::Plane, sphere::Sphere};
use raybook_chapters::ch13_reflection::kissing_balls;

const SHARE: f32 = 0.5;

/// Two mirrors that face each other, at x = 0 and x = 1, in ambient light of 1; nothing else can be seen between them.
///
/// Each also sends on a tenth of the ambient light.
fn corridor() -> Scene {
    let mirror =
        |x: f32, normal| -> Thing { Thing::new(Plane::through(x * Vec3::X, normal), Dusty) };
    let mirrors = vec![mirror(0.0, Dir3::X), mirror(1.0, -Dir3::X)];
    Scene::new(mirrors, Vec::new()).surrounded_by(Rgb::WHITE, |_| Rgb::gray(f32::NAN))
}

/// A mirror with dust on it.
struct Dusty;

impl Material for Dusty {
    fn ambient(&self, _: &Surface) -> Rgb {
        Rgb::gray(0.1)
    }

    fn delta_lobes(&self, at: &Surface, view: Dir3, visit: &mut dyn FnMut(Delta)) {
        let share = Rgb::gray(SHARE);
        Mirror { share }.delta_lobes(at, view, visit);
    }
}

#[test]
fn so_many_surfaces_are_followed_and_the_rest_is_black() {
    let scene = corridor();
    let along = ray(vec3(0.5, 0.0, 0.0), vec3(1.0, 0.01, 0.02));
    for depth in 0..20 {
        // 0.1·(1 + s + … + s^(depth − 1)).
        let expected = 0.1 * (1.0 - SHARE.powi(depth)) / (1.0 - SHARE);
        let seen = see(&scene, &along, depth as u32).r;
        assert!(
            (seen - expected).abs() < 1e-6,
            "{depth} surfaces: {seen}, not {expected}"
        );
    }
}

#[test]
fn mirrors_that_face_each_other_end_at_the_limit_however_deep() {
    let seen = see(&corridor(), &ray(vec3(0.5, 0.0, 0.0), Vec3::X), 500).r;
    assert!(
        (seen - 0.2).abs() < 1e-6,
        "the whole series: 0.1/(1 − s), not {seen}"
    );
}

#[test]
fn what_the_limit_takes_away_shrinks_with_the_share_of_every_mirror() {
    let scene = kissing_balls::scene();
    let mut black = Vec::new();
    for depth in [1, 2, 4, 8, 16] {
        let mut count = 0;
        for y in -20..=20 {
            for x in -20..=20 {
                let toward = vec3(0.03 * x as f32, 0.03 * y as f32, -5.2);
                count += u32::from(
                    see(&scene, &ray(kissing_balls::VIEW[0], toward), depth) == Rgb::BLACK,
                );
            }
        }
        black.push(count);
    }
    assert!(
        black[0] > 900,
        "without reflections the balls are black: {black:?}"
    );
    assert!(
        black.windows(2).all(|pair| pair[1] < pair[0]),
        "and less so with each: {black:?}"
    );
}

#[test]
fn a_ray_that_meets_no_mirror_needs_one_surface() {
    let ambient = Rgb::new(0.1, 0.2, 0.3);
    let matte = Phong {
        ambient,
        diffuse: Rgb::BLACK,
        specular: Rgb::BLACK,
        exponent: 1.0,
    };
    let ball = Thing::new(Sphere::new(-5.0 * Vec3::Z, 1.0), matte);
    let scene = Scene::new(vec![ball], vec![]).surrounded_by(Rgb::WHITE, |_| Rgb::gray(7.0));
    for depth in [1, 2, 9] {
        let ball = see(&scene, &ray(Vec3::ZERO, Vec3::NEG_Z), depth);
        assert_eq!(ball, ambient, "its ambient light at depth {depth}");
        let backdrop = see(&scene, &ray(Vec3::ZERO, Vec3::Z), depth);
        assert_eq!(backdrop, Rgb::gray(7.0), "the backdrop at depth {depth}");
    }
    assert_eq!(
        see(&scene, &ray(Vec3::ZERO, Vec3::Z), 0),
        Rgb::BLACK,
        "no question, no answer"
    );
}
