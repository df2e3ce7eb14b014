//! View factors: the share of a rectangle's light that reaches another one. Howell, *A Catalog of Radiation Heat Transfer Configuration
//! Factors*, has them in closed form.

use glam::{Vec3, vec2, vec3};
use rand::RngExt;
use raybook::light::extent::LightSampling;
use raybook::prelude::*;
use raybook_common::statistics::Mean;

/// The mean radiance of a white rectangle of the floor, from the origin to (width, depth), under a lamp of radiance 1: E/π, which is the
/// share of the rectangle's own light that reaches the lamp.
fn floor([width, depth]: [f32; 2], lamp: RectLight, strategy: Strategy, samples: u32) -> Mean {
    let albedo = Rgb::WHITE;
    let plane = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Lambert { albedo });
    let scene = Scene::new(vec![plane], vec![Box::new(lamp)]);
    let path = Path {
        strategy,
        depth: 1,
        ..Path::WHOLE
    };
    Mean::sampled(21, samples, |rng| {
        let place = vec2(width, depth) * vec2(rng.random(), rng.random());
        // From just above: a ray from farther away would have to pass the lamp.
        let ray = Ray::new(vec3(place.x, 1e-3, place.y), -Dir3::Y);
        path.radiance(&scene, &ray, rng).g
    })
}

/// A lamp that looks down on the whole of the rectangle.
fn opposed([width, depth]: [f32; 2], height: f32) -> RectLight {
    let corner = height * Vec3::Y;
    RectLight::new(corner, width * Vec3::X, depth * Vec3::Z, Rgb::WHITE)
}

/// A lamp that stands on the rectangle's edge along z and faces it.
fn standing([_, depth]: [f32; 2], height: f32) -> RectLight {
    RectLight::new(Vec3::ZERO, height * Vec3::Y, depth * Vec3::Z, Rgb::WHITE)
}

/// The rectangle's width and depth, the lamp's height above the rectangle, and the view factor: C-11, in double precision.
const OPPOSED: [([f32; 2], f32, f64); 4] = [
    ([1.0, 1.0], 1.0, 0.199_824_9),
    ([1.0, 1.0], 0.5, 0.415_253_3),
    ([1.0, 1.0], 2.0, 0.068_589_6),
    ([1.0, 1.5], 0.5, 0.475_576_4),
];

/// The rectangle's width and depth, the height of the lamp along the depth, and the view factor: C-14, in double precision.
const STANDING: [([f32; 2], f32, f64); 3] = [
    ([1.0, 1.0], 1.0, 0.200_043_8),
    ([1.0, 1.0], 2.0, 0.232_852_6),
    ([2.0, 1.0], 1.0, 0.116_426_3),
];

#[test]
fn rectangles_have_the_published_view_factors() {
    let both = |size, lamp, published, name: &str| {
        floor(size, lamp, Strategy::Both, 4000).assert_is(published, name);
    };
    for (size, height, published) in OPPOSED {
        let name = format!("{size:?}, opposed, {height} m away");
        both(size, opposed(size, height), published, &name);
    }
    for (size, height, published) in STANDING {
        let name = format!("{size:?}, perpendicular, {height} m high");
        both(size, standing(size, height), published, &name);
    }
}

#[test]
fn every_strategy_gives_the_published_view_factors_of_squares() {
    let (size, opposite, beside) = (OPPOSED[0].0, OPPOSED[0].2, STANDING[0].2);
    let turned = RectLight::new(Vec3::ZERO, Vec3::Z, Vec3::Y, Rgb::WHITE);
    for choose in [LightSampling::ByArea, LightSampling::BySolidAngle] {
        for (strategy, samples) in [
            (Strategy::Light, 4000),
            (Strategy::Both, 4000),
            (Strategy::Surface, 20_000),
        ] {
            let name = format!("{choose:?}, {strategy:?}");
            let lit = |lamp: RectLight| floor(size, lamp.choosing(choose), strategy, samples);
            lit(opposed(size, 1.0)).assert_is(opposite, &name);
            // Points of the lamp's area may be as near as one likes: their light has no finite variance.
            if choose == LightSampling::BySolidAngle || strategy != Strategy::Light {
                lit(standing(size, 1.0)).assert_is(beside, &format!("perpendicular, {name}"));
            }
            let dark = lit(turned).mean;
            assert_eq!(dark, 0.0, "{name}: the back of the lamp is dark");
        }
    }
}
