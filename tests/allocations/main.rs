//! No integrator allocates per ray: an allocator counts.

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, environment::Environment};
use raybook::math::{pcg, pcg::Pcg, ray::Ray};
use raybook::render::local::{Local, NO_SHADOWS, Visibility};
use raybook::render::sampler::Integrator as _;
use raybook::render::{caustics::Caustics, cone::Cone, photons::Photons};
use raybook::render::{mis::Strategy, path::Path, shadow, whitted::Whitted};
use raybook::scene::{cornell, plates, world::Scene};
use raybook_chapters::ch13_reflection::kissing_balls;
use raybook_chapters::ch14_refraction::glassware::{self, Stuff};
use raybook_chapters::ch16_soft_shadows::posts;
use raybook_chapters::ch18_environment::skies;
use raybook_chapters::ch18_environment::uniform_environment::UniformEnvironment;
use raybook_common::counting::{Counting, allocations};
use raybook_common::rays::{random_direction, ray};
use raybook_scenes::gallery;
use std::hint::black_box;

#[global_allocator]
static COUNTING: Counting = Counting;

/// What the glass of the chapter's pictures is made of.
const STUFF: Stuff = Stuff {
    index: 1.5,
    liquid: 1.333,
    absorption: 1.0,
};

/// Number of rays that are followed, each with all that it asks.
const RAYS: u32 = 3000;

/// What a ray sees.
type Integrator = Box<dyn Fn(&Ray, &mut Pcg) -> Rgb>;

/// Whitted's ray tracing of a scene, with a number of samples of each light.
fn whitted(scene: Scene, depth: u32, (samples, arrives): (u32, Option<Visibility>)) -> Integrator {
    let local = Local { samples, arrives };
    let whitted = Whitted { local, depth };
    Box::new(move |ray, rng| whitted.radiance(&scene, ray, rng))
}

/// Path tracing of a scene, over many surfaces, by one strategy.
fn path(scene: Scene, strategy: Strategy) -> Integrator {
    let path = Path {
        depth: 8,
        roulette_after: 3,
        strategy,
    };
    Box::new(move |ray, rng| path.radiance(&scene, ray, rng))
}

/// Path tracing of the Cornell box with a mirror ball and a glass ball, whose caustics photons bring.
fn with_photons() -> Integrator {
    let scene = gallery::CORNELL.shot(96).expect("a scene").scene;
    let caustics = Caustics {
        path: Path::WHOLE,
        photons: Photons::shot(&scene, 20_000, 0.01, 0),
        brightest: f32::INFINITY,
    };
    Box::new(move |ray, rng| caustics.follow(&scene, ray, Cone::THIN, rng).radiance)
}

/// The clear day, in a small map.
fn sky() -> Environment {
    Environment::new(skies::map(skies::clear_day, 64))
}

/// The marbles of chapters 13 and 15.
fn marbles() -> Scene {
    gallery::MARBLES.shot(96).expect("a scene").scene
}

/// The posts of chapter 16 under a light.
fn posts_under(light: Box<dyn Light>) -> Scene {
    gallery::POSTS.under(light, 96).expect("a scene").scene
}

/// The still life of chapter 18 under a light.
fn still_life(light: Box<dyn Light>) -> Scene {
    gallery::STILL_LIFE.under(light, 96).expect("a scene").scene
}

/// Every integrator, by name, with where to look from.
fn integrators() -> Vec<(&'static str, Vec3, Integrator)> {
    let (bare, shadows, soft) = (
        (1, NO_SHADOWS),
        (1, Some(shadow::lit as Visibility)),
        (8, Some(shadow::lit as Visibility)),
    );
    let above = vec3(0.4, 4.3, 7.2);
    let (inside, before) = (vec3(0.28, 0.27, 0.1), vec3(0.8, 1.6, 8.8));
    let mirrors = kissing_balls::scene();
    vec![
        ("lamps without shadows", above, whitted(marbles(), 1, bare)),
        ("mirrors", above, whitted(marbles(), 8, bare)),
        (
            "mirrors that touch",
            kissing_balls::VIEW[0],
            whitted(mirrors, 12, bare),
        ),
        (
            "glass",
            above,
            whitted(glassware::still_life(STUFF), 12, bare),
        ),
        ("shadows", above, whitted(marbles(), 8, shadows)),
        (
            "soft shadows of a square",
            above,
            whitted(posts_under(posts::square(1.4)), 1, soft),
        ),
        (
            "soft shadows of a sphere",
            above,
            whitted(posts_under(posts::sphere(0.7)), 1, soft),
        ),
        (
            "paths by the surface",
            inside,
            path(cornell::cornell_box(), Strategy::Surface),
        ),
        (
            "paths by the light",
            inside,
            path(cornell::cornell_box(), Strategy::Light),
        ),
        ("paths with photons", inside, with_photons()),
        (
            "paths by both",
            plates::EYE,
            path(plates::plates(), Strategy::Both),
        ),
        (
            "paths under a sky",
            before,
            path(still_life(Box::new(sky())), Strategy::Both),
        ),
        (
            "paths under a sky that is asked everywhere",
            before,
            path(
                still_life(Box::new(UniformEnvironment(sky()))),
                Strategy::Light,
            ),
        ),
    ]
}

#[test]
fn following_rays_allocates_nothing() {
    for (name, from, radiance) in integrators() {
        let mut rng = pcg::stream(12, 0);
        let (count, sum) = allocations(|| {
            let mut sum = Rgb::BLACK;
            for _ in 0..RAYS {
                let toward = -from + 2.5 * *random_direction(&mut rng);
                sum += radiance(&ray(from, toward), &mut rng);
            }
            sum
        });
        assert!(
            sum.g > 0.05 * RAYS as f32,
            "{name}: the rays see something, not {sum:?}"
        );
        assert_eq!(
            count, 0,
            "{name}: allocations for {RAYS} rays and all that they ask"
        );
    }
}

#[test]
fn an_allocation_is_counted() {
    let (count, _) = allocations(|| black_box(Box::new(1)));
    assert_eq!(count, 1, "one box");
}
