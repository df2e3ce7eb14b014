//! Plastic: nothing is gained, nothing is lost but what the ground absorbs, and both ways are one.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::material::plastic::Plastic;
use raybook::math::pcg;
use raybook::prelude::*;
use raybook_common::statistics::Mean;

/// A point of the plane y = 0.
fn flat() -> Surface {
    Surface::flat(Vec3::ZERO, 0.0, Dir3::Y)
}

fn slanted(x: f32, z: f32) -> Dir3 {
    Dir3::new(vec3(x, 1.0, z)).expect("not 0")
}

#[test]
fn white_plastic_disappears_in_a_white_furnace_from_every_angle() {
    for index in [1.0, 1.3, 1.5, 2.5] {
        let plane = Thing::new(
            Plane::through(Vec3::ZERO, Dir3::Y),
            Plastic::new(Rgb::WHITE, index),
        );
        let scene = Scene::new(vec![plane], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
        for slant in [0.0, 1.0, 5.0] {
            let toward = -slanted(slant, 0.0);
            let ray = Ray::new(*toward * -1.0, toward);
            let mean = Mean::sampled(21, 3000, |rng| Path::WHOLE.radiance(&scene, &ray, rng).g);
            mean.assert_is(1.0, &format!("n = {index}, slant {slant}"));
        }
    }
}

#[test]
fn it_is_reciprocal_and_black_plastic_only_mirrors() {
    let red = Plastic::new(Rgb::new(0.8, 0.1, 0.0), 1.5);
    let (a, b) = (slanted(0.3, 0.1), slanted(-2.0, 1.0));
    let (there, back) = (red.eval(&flat(), a, b), red.eval(&flat(), b, a));
    assert!(there.r > 0.05 && there.b == 0.0, "{there:?}");
    assert!((there.r - back.r).abs() < 1e-6, "{there:?} and {back:?}");
    let below = Dir3::new(vec3(0.3, -1.0, 0.0)).expect("not 0");
    assert_eq!(red.eval(&flat(), a, below), Rgb::BLACK);
    // Straight down a coat of n = 1.5 mirrors ((n − 1)/(n + 1))² = 4 %.
    let mut share = Rgb::BLACK;
    red.delta_lobes(&flat(), Dir3::Y, &mut |lobe| share = lobe.share);
    assert!((share.g - 0.04).abs() < 1e-5, "{share:?}");
}

#[test]
fn light_finds_its_way_through_the_coat_as_a_walk_says() {
    // A photon at the ground is absorbed or sent up, mirrored back or let out: its chance to leave, against f.
    let (albedo, index) = (0.6, 1.5);
    let plastic = Plastic::new(Rgb::gray(albedo), index);
    let mut numbers = pcg::stream(5, 0);
    let f = Mean::sampled(22, 4000, |rng| {
        let u = vec2(rng.random(), rng.random());
        let toward = plastic.sample(&flat(), Dir3::Y, u).expect("above");
        plastic.eval(&flat(), Dir3::Y, toward).g * toward.y / plastic.pdf(&flat(), Dir3::Y, toward)
    });
    let walk = || {
        // It came straight down, through 96 % of the coat.
        if numbers.random::<f32>() < 0.04 {
            return 0.0;
        }
        loop {
            if numbers.random::<f32>() >= albedo {
                return 0.0;
            }
            let cosine = numbers.random::<f32>().sqrt();
            let mirrored = raybook::material::fresnel::fresnel(cosine, index, 1.0).unpolarised;
            if numbers.random::<f32>() >= mirrored {
                return 1.0;
            }
        }
    };
    let walks: Vec<f64> = std::iter::repeat_with(walk).take(40_000).collect();
    f.assert_same(&Mean::of(&walks), "the share that leaves");
}
