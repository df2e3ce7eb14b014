//! Bodies of glass, water and air, seen by Whitted's ray tracing.

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::material::Material;
use raybook::material::glass::{Glass, Medium};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::local::{Local, NO_SHADOWS};
use raybook::render::whitted::Whitted;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Shape, cuboid::Cuboid, sphere::Sphere};

fn whitted(depth: u32) -> Whitted {
    let local = Local {
        samples: 1,
        arrives: NO_SHADOWS,
    };
    Whitted { local, depth }
}

pub(super) fn thing(shape: impl Shape + 'static, material: impl Material + 'static) -> Thing {
    Thing::new(shape, material)
}

/// Things before a backdrop.
pub(super) fn scene(things: Vec<Thing>, backdrop: fn(&Ray) -> Rgb) -> Scene {
    let mut scene = Scene::new(things, vec![]);
    scene.backdrop = Box::new(backdrop);
    scene
}

pub(super) fn look(scene: &Scene, origin: Vec3, toward: Vec3, depth: u32) -> Rgb {
    let ray = Ray::new(origin, Dir3::new(toward).expect("a direction"));
    whitted(depth).radiance(scene, &ray, &mut pcg::stream(14, 0))
}

/// A sphere around the origin.
fn ball(radius: f32, outside: Medium, inside: Medium) -> Thing {
    let glass = Glass { outside, inside };
    thing(Sphere::new(Vec3::ZERO, radius), glass)
}

/// Each place from the middle of a ball to its rim, as a share of its radius: the closer, the nearer the rim.
fn to_the_rim() -> impl Iterator<Item = f32> {
    (0..=300).map(|i| 1.0 - (1.0 - i as f32 / 300.0).powi(3))
}

/// Makes the things of a scene.
type Build = Box<dyn Fn() -> Vec<Thing>>;

#[test]
fn clear_glass_in_a_white_room_is_white_up_to_its_rim() {
    let (air, water, glass) = (Medium::AIR, Medium::WATER, Medium::GLASS);
    let bodies: [(&str, Build); 5] = [
        (
            "a ball of glass",
            Box::new(move || vec![ball(1.0, air, glass)]),
        ),
        (
            "a ball with a bubble",
            Box::new(move || vec![ball(1.0, air, glass), ball(0.9, glass, air)]),
        ),
        (
            "a ball of glass in one of water",
            Box::new(move || vec![ball(1.0, air, water), ball(0.6, water, glass)]),
        ),
        (
            "a ball of diamond",
            Box::new(move || vec![ball(1.0, air, Medium::clear(2.417))]),
        ),
        (
            "a plate",
            Box::new(move || {
                let plate = Cuboid::between(vec3(-1.0, -1.0, -0.1), vec3(1.0, 1.0, 0.1));
                vec![thing(plate, Glass::of(glass))]
            }),
        ),
    ];
    for (name, build) in bodies {
        let scene = scene(build(), |_| Rgb::WHITE);
        let mut least = f32::INFINITY;
        for off in to_the_rim() {
            let seen = look(&scene, vec3(off, 0.0, 5.0), Vec3::NEG_Z, 40).g;
            assert!(
                seen < 1.001,
                "{name}, {off} from the middle, shines: {seen}"
            );
            least = least.min(seen);
        }
        // What counts for less than 1/512 is not looked at: a few hundredths where light goes round and round.
        assert!(
            least > 0.93,
            "{name} loses light: {least} is left somewhere"
        );
    }
}

#[test]
fn a_ball_of_what_is_around_it_is_invisible() {
    let backdrop = |ray: &Ray| {
        let d = *ray.direction;
        Rgb::new(d.x.abs(), d.y.abs(), d.z.abs())
    };
    let empty = scene(vec![], backdrop);
    let full = scene(vec![ball(1.0, Medium::GLASS, Medium::GLASS)], backdrop);
    for off in to_the_rim() {
        let (origin, toward) = (vec3(off, 0.3, 4.0), vec3(0.05, -0.1, -1.0));
        let [with, without] = [&full, &empty].map(|scene| look(scene, origin, toward, 5));
        let difference = (with.r - without.r).abs() + (with.g - without.g).abs();
        assert!(difference < 1e-4, "{with:?} is not {without:?}");
    }
}

/// Where a ray goes behind a body, as the backdrop tells: only what is ahead shines, so that no mirrored ray counts.
fn direction_behind(things: Vec<Thing>, off: f32) -> f32 {
    let slope = scene(things, |ray| {
        let ahead = f32::from(u8::from(ray.direction.z < -0.9));
        Rgb::new(ahead * (0.5 + ray.direction.x), ahead, 0.0)
    });
    // Three surfaces in a row, with the backdrop: the ball is entered and left, and no more.
    let seen = look(&slope, vec3(off, 0.0, 5.0), Vec3::NEG_Z, 3);
    seen.r / seen.g - 0.5
}

#[test]
fn a_ball_is_the_lens_that_its_indices_make_it() {
    // Near the axis a ball of index m, relative to what is around it, bends a ray at height h by 2 (m − 1) h/(m r).
    let off = 0.02_f32;
    for (name, outside, inside) in [
        ("glass in air", Medium::AIR, Medium::GLASS),
        ("air in glass", Medium::GLASS, Medium::AIR),
        ("glass in water", Medium::WATER, Medium::GLASS),
    ] {
        let m = inside.index / outside.index;
        let exact = -2.0 * (m - 1.0) / m * off;
        let got = direction_behind(vec![ball(1.0, outside, inside)], off);
        assert!(
            (got / exact - 1.0).abs() < 0.02,
            "{name}: the ray is bent by {got} rad, not by {exact}"
        );
    }
}
