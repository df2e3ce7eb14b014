//! Mirrors, glass and metals in a path: one scene for both ways of tracing.

use crate::ch17_rendering_equation::{ALL, direction, square, thing};
use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::sphere_light::SphereLight;
use raybook::light::{Light, extent::LightSampling};
use raybook::material::conductor::{Conductor, Metal, fresnel_conductor};
use raybook::material::fresnel::fresnel;
use raybook::material::ggx::Ggx;
use raybook::material::glass::{Glass, Medium};
use raybook::material::{Material, lambert::Lambert, mirror::Mirror, polished::Polished};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::{local::Local, mis::Strategy, path::Path, shadow, whitted::Whitted};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{plane::Plane, sphere::Sphere};
use raybook_common::statistics::Mean;

fn ball(material: impl Material + 'static) -> Thing {
    thing(Sphere::new(Vec3::ZERO, 1.0), material)
}

/// Things before a sky that tells all directions apart.
fn before_sky(things: Vec<Thing>) -> Scene {
    let sky = |ray: &Ray| Rgb::new(1.0, 0.5, 2.0) * (1.2 + ray.direction.y + 0.3 * ray.direction.x);
    Scene::new(things, vec![]).surrounded_by(Rgb::BLACK, sky)
}

fn toward_ball(x: f32, y: f32) -> Ray {
    let eye = vec3(0.0, 0.3, 4.0);
    Ray::new(eye, direction(x, y - 0.3, -4.0))
}

#[test]
fn one_of_two_rays_by_chance_is_both_of_them_in_the_mean() {
    let green = Medium {
        absorption: Rgb::new(0.9, 0.1, 0.6),
        ..Medium::GLASS
    };
    let local = Local {
        samples: 1,
        arrives: Some(shadow::lit),
    };
    let whitted = Whitted { local, depth: 20 };
    let copper = Conductor(Metal::COPPER);
    for (name, body) in [
        ("glass", ball(Glass::of(Medium::GLASS))),
        ("green glass", ball(Glass::of(green))),
        ("copper", ball(copper)),
        (
            "a mirror",
            ball(Mirror {
                share: Rgb::new(0.9, 0.5, 0.1),
            }),
        ),
    ] {
        let scene = before_sky(vec![body]);
        for (x, y) in [(0.0, 0.0), (0.4, 0.3), (-0.7, 0.5), (0.1, -0.95)] {
            let ray = toward_ball(x, y);
            let exact = whitted.radiance(&scene, &ray, &mut pcg::stream(0, 0));
            let mean = Mean::sampled(21, 4000, |rng| ALL.radiance(&scene, &ray, rng).r);
            // Whitted's way leaves out what counts for less than 1/512; a path leaves out nothing.
            let (exact, twigs) = (f64::from(exact.r), f64::from(exact.r) / 256.0);
            assert!(
                mean.mean > exact - 5.0 * mean.error - 1e-6
                    && mean.mean < exact + twigs + 5.0 * mean.error,
                "{name} at ({x}, {y}): {mean:?}, not {exact}"
            );
        }
    }
}

#[test]
fn clear_bodies_disappear_in_a_white_furnace() {
    let white = Lambert { albedo: Rgb::WHITE };
    let mirror = Mirror {
        share: Rgb::gray(0.3),
    };
    let polished = Polished {
        mirror,
        below: white,
    };
    let bubble = Glass {
        outside: Medium::GLASS,
        inside: Medium::AIR,
    };
    for (name, things) in [
        ("glass", vec![ball(Glass::of(Medium::GLASS))]),
        ("polish over white", vec![ball(polished)]),
        (
            "a bubble in glass, on polish",
            vec![
                ball(Glass::of(Medium::GLASS)),
                thing(Sphere::new(Vec3::ZERO, 0.6), bubble),
                thing(Plane::through(-1.1 * Vec3::Y, Dir3::Y), polished),
            ],
        ),
    ] {
        let scene = Scene::new(things, vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
        let mean = Mean::sampled(22, 1000, |rng| {
            let u = 2.0 * square(rng) - 1.0;
            ALL.radiance(&scene, &toward_ball(0.95 * u.x, 0.95 * u.y), rng)
                .g
        });
        mean.assert_is(1.0, name);
    }
}

/// Glass with the index of air bends nothing and mirrors nothing, but no light can be looked for through it: the ray that goes on
/// must find the lamp by itself, and neither twice nor for a share only.
#[test]
fn a_lamp_in_invisible_glass_gives_the_same_light() {
    let lamp = || -> Vec<Box<dyn Light>> {
        vec![Box::new(SphereLight {
            sphere: Sphere::new(vec3(0.0, 2.0, 0.0), 0.7),
            radiance: Rgb::gray(3.0),
            choose: LightSampling::BySolidAngle,
        })]
    };
    let floor = || {
        thing(
            Plane::through(Vec3::ZERO, Dir3::Y),
            Lambert {
                albedo: Rgb::gray(0.5),
            },
        )
    };
    let cover = thing(
        Sphere::new(vec3(0.0, 2.0, 0.0), 0.9),
        Glass::of(Medium::AIR),
    );
    let (bare, covered) = (
        Scene::new(vec![floor()], lamp()),
        Scene::new(vec![floor(), cover], lamp()),
    );
    let down = Ray::new(vec3(1.0, 1.0, 1.0), direction(0.1, -1.0, 0.0));
    for strategy in [Strategy::Surface, Strategy::Both] {
        let path = Path {
            depth: 6,
            strategy,
            ..ALL
        };
        let seen =
            |scene: &Scene| Mean::sampled(23, 20_000, |rng| path.radiance(scene, &down, rng).g);
        let (bare, covered) = (seen(&bare), seen(&covered));
        let error = bare.error.hypot(covered.error);
        assert!(
            (bare.mean - covered.mean).abs() < 5.0 * error && bare.mean > 20.0 * error,
            "{strategy:?}: {bare:?} without glass, {covered:?} with it"
        );
    }
}

#[test]
fn a_metal_without_extinction_is_glass_and_a_real_one_has_its_colour() {
    for n in [1.2, 1.5, 2.4] {
        for cosine in [0.0, 0.01, 0.2, 0.5, 0.9, 1.0] {
            let (metal, glass) = (
                fresnel_conductor(cosine, n, 0.0),
                fresnel(cosine, 1.0, n).unpolarised,
            );
            assert!(
                (metal - glass).abs() < 2e-5,
                "n = {n}, cos θ = {cosine}: {metal}, not {glass}"
            );
        }
    }
    for (metal, name) in [
        (Metal::GOLD, "gold"),
        (Metal::SILVER, "silver"),
        (Metal::COPPER, "copper"),
        (Metal::ALUMINIUM, "aluminium"),
    ] {
        let straight = metal.reflectance(1.0);
        let (n, k) = (metal.n.g, metal.k.g);
        let expected = ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
        assert!(
            (straight.g - expected).abs() < 1e-5,
            "{name}: {}, not {expected}",
            straight.g
        );
        assert_eq!(
            metal.reflectance(0.0),
            Rgb::WHITE,
            "{name}: along the surface all is mirrored"
        );
        assert!(
            straight.b > 0.3 && straight.max_channel() < 0.99,
            "{name}: {straight:?}"
        );
    }
    let (gold, copper) = (Metal::GOLD.reflectance(1.0), Metal::COPPER.reflectance(1.0));
    assert!(
        gold.r > gold.g && gold.g > gold.b + 0.3,
        "gold is yellow: {gold:?}"
    );
    assert!(
        copper.r > copper.g + 0.2 && copper.g > copper.b,
        "copper is red: {copper:?}"
    );
}

/// ∫ D (n·h) dω = 1, and of what is seen at an angle the visible facets make up just the area: ∫ G₁ D (v·h) dω = n·v.
#[test]
fn facets_cover_the_surface_as_seen_from_everywhere() {
    use crate::ch17_rendering_equation::integral;
    for alpha in [0.2, 0.5, 1.0] {
        let ggx = Ggx {
            metal: Metal::SILVER,
            alpha,
        };
        let area = integral(|h| ggx.normals(h.z) * h.z);
        assert!((area - 1.0).abs() < 2e-3, "α = {alpha}: {area}");
        for view in [direction(0.5, 0.0, 1.0), direction(2.0, 1.0, 1.0)] {
            let visible = 1.0 / (1.0 + ggx.hidden(view.z));
            let seen = integral(|h| visible * ggx.normals(h.z) * view.dot(*h).max(0.0));
            assert!(
                (seen - f64::from(view.z)).abs() < 2e-3,
                "α = {alpha}: {seen}, not {}",
                view.z
            );
        }
    }
}

#[test]
fn a_nearly_smooth_metal_is_nearly_the_smooth_one() {
    let smooth = before_sky(vec![ball(Conductor(Metal::GOLD))]);
    let rough = before_sky(vec![ball(Ggx {
        metal: Metal::GOLD,
        alpha: 0.01,
    })]);
    for (x, y) in [(0.0, 0.0), (0.5, 0.3), (-0.8, 0.2)] {
        let ray = toward_ball(x, y);
        let exact = ALL.radiance(&smooth, &ray, &mut pcg::stream(0, 0)).r;
        let mean = Mean::sampled(24, 2000, |rng| ALL.radiance(&rough, &ray, rng).r);
        assert!(
            (mean.mean - f64::from(exact)).abs() < 5.0 * mean.error + 0.01 * f64::from(exact),
            "({x}, {y}): {mean:?}, not {exact}"
        );
    }
}

/// What is lost to facets that light each other, in a white furnace of a metal that mirrors all: it grows with the roughness.
#[test]
fn the_energy_that_rough_metal_loses_is_known() {
    let perfect = Metal {
        n: Rgb::BLACK,
        k: Rgb::WHITE,
    };
    let kept = |alpha: f32| {
        let scene = Scene::new(
            vec![ball(Ggx {
                metal: perfect,
                alpha,
            })],
            vec![],
        )
        .surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
        let straight = toward_ball(0.0, 0.0);
        Mean::sampled(25, 20_000, |rng| ALL.radiance(&scene, &straight, rng).g).mean
    };
    // From straight above, ∫ f cos θ dω = 1 − ln 2 at α = 1, for there D is 1/π everywhere; the others by a quadrature.
    for (alpha, expected) in [
        (0.1, 0.98825),
        (0.5, 0.68785),
        (1.0, 1.0 - std::f64::consts::LN_2),
    ] {
        let kept = kept(alpha);
        assert!(
            (kept - expected).abs() < 0.008,
            "α = {alpha}: {kept}, not {expected}"
        );
    }
}
