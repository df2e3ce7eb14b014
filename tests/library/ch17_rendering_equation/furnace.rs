//! Furnaces: scenes whose radiance is the same everywhere, however complicated the paths are.

use crate::ch17_rendering_equation::{ALL, Glowing, direction, square, thing};
use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::material::{lambert::Lambert, modified_phong::ModifiedPhong};
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook::render::{mis::Strategy, path::Path};
use raybook::sample::hemisphere::uniform_hemisphere;
use raybook::scene::world::Scene;
use raybook::shape::{cuboid::Cuboid, plane::Plane, sphere::Sphere};
use raybook_common::statistics::Mean;

fn white() -> Lambert {
    Lambert { albedo: Rgb::WHITE }
}

/// A sphere on a plane with another beside it, all white, under a sky of radiance 1.
#[test]
fn white_things_disappear_in_a_white_furnace() {
    let things = vec![
        thing(Plane::through(Vec3::ZERO, Dir3::Y), white()),
        thing(Sphere::new(vec3(0.0, 1.0, 0.0), 1.0), white()),
        thing(Sphere::new(vec3(1.8, 0.8, 0.3), 0.8), white()),
    ];
    let mut scene = Scene::new(things, vec![]);
    scene.backdrop = Box::new(|_| Rgb::WHITE);
    for strategy in [Strategy::Surface, Strategy::Both] {
        let path = Path { strategy, ..ALL };
        let mean = Mean::sampled(11, 400, |rng| {
            let u = 2.0 * square(rng) - 1.0;
            let eye = vec3(0.5, 1.5, 6.0);
            let ray = Ray::new(eye, direction(0.3 * u.x, 0.25 * u.y - 0.1, -1.0));
            path.radiance(&scene, &ray, rng).g
        });
        mean.assert_is(1.0, &format!("{strategy:?}"));
    }
}

/// Straight down on a glossy plane all comes back; slanting, what the horizon cuts off is lost, but nothing is gained.
#[test]
fn a_glossy_plane_in_a_white_furnace_is_never_brighter_than_the_sky() {
    for exponent in [1.0, 10.0, 100.0] {
        let brdf = ModifiedPhong {
            diffuse: Rgb::gray(0.25),
            specular: Rgb::gray(0.75),
            exponent,
        };
        let plane = thing(Plane::through(Vec3::ZERO, Dir3::Y), brdf);
        let mut scene = Scene::new(vec![plane], vec![]);
        scene.backdrop = Box::new(|_| Rgb::WHITE);
        let seen = |down: f32| {
            let ray = Ray::new(vec3(0.0, 2.0, 0.0), direction(1.0, -down, 0.0));
            Mean::sampled(12, 2000, |rng| ALL.radiance(&scene, &ray, rng).g)
        };
        seen(1e4).assert_is(1.0, "straight down");
        let mut last = 1.0;
        for down in [1.0, 0.3, 0.1] {
            let mean = seen(down);
            assert!(
                mean.mean - 5.0 * mean.error < last,
                "exponent {exponent}, down {down}: {mean:?}"
            );
            last = mean.mean;
        }
        assert!(last < 0.95, "exponent {exponent}: some is lost, {last}");
    }
}

/// L = 1 + ρL, so L = 1/(1 − ρ); with at most n reflections, L = 1 + ρ + … + ρⁿ.
#[test]
fn a_grey_furnace_is_as_bright_as_its_geometric_series() {
    for (rho, samples) in [(0.2_f32, 2000), (0.5, 2000), (0.9, 2000)] {
        let glowing = || Glowing {
            brdf: Lambert {
                albedo: Rgb::gray(rho),
            },
            emission: Rgb::WHITE,
        };
        let ball = thing(Sphere::new(vec3(0.2, 0.0, 0.0), 1.0), glowing());
        let room = thing(
            Cuboid::between(vec3(-3.0, -2.0, -2.0), Vec3::splat(2.5)),
            glowing(),
        );
        for (name, scene) in [
            ("sphere", Scene::new(vec![ball], vec![])),
            ("box", Scene::new(vec![room], vec![])),
        ] {
            for depth in [0, 1, 2, 5, u32::MAX] {
                let path = Path { depth, ..ALL };
                let mean = Mean::sampled(13, samples, |rng| {
                    let ray = Ray::new(Vec3::ZERO, uniform_hemisphere(Dir3::Z, square(rng)));
                    path.radiance(&scene, &ray, rng).g
                });
                let rho = f64::from(rho);
                let rest = if depth == u32::MAX {
                    0.0
                } else {
                    rho.powi(depth as i32 + 1)
                };
                let exact = (1.0 - rest) / (1.0 - rho);
                mean.assert_is(exact, &format!("{name}, albedo {rho}, depth {depth}"));
            }
        }
    }
}

#[test]
fn russian_roulette_changes_the_work_and_not_the_mean() {
    let wall = Glowing {
        brdf: Lambert {
            albedo: Rgb::new(0.3, 0.6, 0.1),
        },
        emission: Rgb::WHITE,
    };
    let scene = Scene::new(vec![thing(Sphere::new(Vec3::ZERO, 1.0), wall)], vec![]);
    for roulette_after in [0, 1, 4, 60] {
        for (channel, rho) in [0.3, 0.6, 0.1].into_iter().enumerate() {
            let path = Path {
                roulette_after,
                depth: 80,
                ..ALL
            };
            let mean = Mean::sampled(14, 1000, |rng| {
                let ray = Ray::new(Vec3::ZERO, Dir3::X);
                path.radiance(&scene, &ray, rng).channels()[channel]
            });
            mean.assert_is(
                1.0 / (1.0 - rho),
                &format!("roulette after {roulette_after}, albedo {rho}"),
            );
        }
    }
}
