//! View factors: the share of a square's light that reaches another one, known in closed form (Howell's catalogue).

use crate::ch17_rendering_equation::{ALL, square, thing};
use glam::{Vec2, Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{extent::LightSampling, rect_light::RectLight};
use raybook::material::lambert::Lambert;
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook::render::{mis::Strategy, path::Path};
use raybook::scene::world::Scene;
use raybook::shape::plane::Plane;
use raybook_common::statistics::Mean;

/// The mean radiance of the unit square of the floor, white, under a lamp of radiance 1: E/π = F for a square of area 1.
fn floor(lamp: RectLight, strategy: Strategy, samples: u32) -> Mean {
    let albedo = Rgb::WHITE;
    let things = vec![thing(
        Plane::through(Vec3::ZERO, Dir3::Y),
        Lambert { albedo },
    )];
    let scene = Scene::new(things, vec![Box::new(lamp)]);
    let path = Path {
        strategy,
        depth: 1,
        ..ALL
    };
    Mean::sampled(21, samples, |rng| {
        let Vec2 { x, y } = square(rng);
        // From just above: a ray from farther away would have to pass the lamp.
        let ray = Ray::new(vec3(x, 1e-3, y), -Dir3::Y);
        path.radiance(&scene, &ray, rng).g
    })
}

#[test]
fn the_view_factors_of_two_squares_are_as_published() {
    let opposed = RectLight::new(vec3(0.0, 1.0, 0.0), Vec3::X, Vec3::Z, Rgb::WHITE);
    let corner = RectLight::new(Vec3::ZERO, Vec3::Y, Vec3::Z, Rgb::WHITE);
    let turned = RectLight::new(Vec3::ZERO, Vec3::Z, Vec3::Y, Rgb::WHITE);
    for choose in [LightSampling::ByArea, LightSampling::BySolidAngle] {
        for (strategy, samples) in [
            (Strategy::Light, 4000),
            (Strategy::Both, 4000),
            (Strategy::Surface, 20_000),
        ] {
            let name = format!("{choose:?}, {strategy:?}");
            floor(opposed.choosing(choose), strategy, samples).assert_is(0.199_824_9, &name);
            let [one, other] =
                [corner, turned].map(|lamp| floor(lamp.choosing(choose), strategy, samples));
            let lit = if one.mean > other.mean { one } else { other };
            if choose == LightSampling::BySolidAngle || strategy != Strategy::Light {
                lit.assert_is(0.200_043_8, &format!("perpendicular, {name}"));
            }
            let dark = one.mean.min(other.mean);
            assert_eq!(dark, 0.0, "{name}: the back of the lamp is dark");
        }
    }
}
