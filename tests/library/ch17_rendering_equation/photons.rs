//! The caustic photon map: what lights emit, and what paths with photons see beside paths without.

use crate::ch17_rendering_equation::{ALL, square, thing};
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, extent::LightSampling};
use raybook::light::{point::PointLight, rect_light::RectLight, sphere_light::SphereLight};
use raybook::material::glass::{Glass, Medium};
use raybook::material::{lambert::Lambert, mirror::Mirror, polished::Polished};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::photons::Photons;
use raybook::render::{caustics::Caustics, cone::Cone, path::Path, sampler::Integrator};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{cuboid::Cuboid, plane::Plane, sphere::Sphere, triangle::Triangle};
use raybook_common::statistics::Mean;
use raybook_common::thorough;
use std::f32::consts::PI;

const WHITE: Lambert = Lambert { albedo: Rgb::WHITE };
const SILVERED: Mirror = Mirror {
    share: Rgb::new(0.9, 0.8, 0.7),
};

/// A lamp of 1 m × 0.6 m, 2.5 m above the floor.
fn lamp() -> RectLight {
    let corner = vec3(-0.5, 2.5, -0.3);
    RectLight::new(corner, Vec3::X, 0.6 * Vec3::Z, Rgb::new(8.0, 6.0, 4.0))
}

fn ball_of_light(center: Vec3, radius: f32) -> SphereLight {
    SphereLight {
        sphere: Sphere::new(center, radius),
        radiance: Rgb::gray(2.0),
        choose: LightSampling::BySolidAngle,
    }
}

fn point(position: Vec3) -> PointLight {
    PointLight {
        position,
        intensity: Rgb::new(3.0, 2.0, 1.0),
    }
}

fn floor() -> Thing {
    let albedo = Rgb::new(0.8, 0.7, 0.6);
    thing(Plane::through(Vec3::ZERO, Dir3::Y), Lambert { albedo })
}

fn wall(material: impl raybook::material::Material + 'static) -> Thing {
    thing(Plane::through(1.2 * Vec3::X, -Dir3::X), material)
}

fn ball(medium: Medium) -> Thing {
    thing(Sphere::new(vec3(0.0, 0.75, 0.0), 0.5), Glass::of(medium))
}

/// A glass ball above the floor, under the lamp.
fn burning_glass() -> Scene {
    Scene::new(vec![floor(), ball(Medium::GLASS)], vec![Box::new(lamp())])
}

#[test]
fn the_mean_power_of_photons_is_the_flux_of_the_light() {
    let sphere = ball_of_light(Vec3::Y, 0.3);
    let both_sides = 2.0 * 4.0 * PI * 0.3 * 0.3;
    let lights: [(&dyn Light, f32); 3] = [
        (&lamp(), 8.0 * PI * 0.6),
        (&sphere, 2.0 * PI * both_sides),
        (&point(Vec3::Y), 3.0 * 4.0 * PI),
    ];
    for (light, flux) in lights {
        let mean = Mean::sampled(40, 1000, |rng| {
            let photon = light.emit(square(rng), square(rng));
            photon.expect("it shines").power.r
        });
        mean.assert_is(f64::from(flux), "the flux");
    }
}

/// The irradiance of a square of the plane y = 0, in W/m², by photons and by samples of the light.
fn irradiances(light: &dyn Light, middle: Vec2, side: f32) -> [Mean; 2] {
    let by_photons = Mean::sampled(41, thorough(400_000), |rng| {
        let photon = light.emit(square(rng), square(rng)).expect("it shines");
        let t = -photon.ray.origin.y / photon.ray.direction.y;
        let at = photon.ray.at(t);
        let from_middle = (vec2(at.x, at.z) - middle).abs().max_element();
        let back = Ray::new(at, -photon.ray.direction);
        let arrives = t > 0.0 && from_middle < 0.5 * side && light.seen(&back, 0.999 * t).is_none();
        let power = if arrives { photon.power.r } else { 0.0 };
        power / (side * side)
    });
    let by_samples = Mean::sampled(42, thorough(40_000), |rng| {
        let place = middle + side * (square(rng) - 0.5);
        let sample = light.sample(vec3(place.x, 0.0, place.y), square(rng));
        // Light from below arrives too.
        sample.map_or(0.0, |sample| sample.arriving.r * sample.toward.y.abs())
    });
    [by_photons, by_samples]
}

#[test]
fn photons_arrive_where_samples_of_the_light_tell() {
    let tilted = RectLight::new(
        vec3(-1.0, 1.5, 0.0),
        Vec3::X,
        vec3(0.0, 0.5, 0.8),
        Rgb::WHITE,
    );
    let (above, around) = (
        ball_of_light(vec3(0.3, 1.0, 0.0), 0.4),
        ball_of_light(vec3(0.3, 0.2, 0.0), 3.0),
    );
    let lights: [(&str, &dyn Light); 5] = [
        ("a rectangle", &lamp()),
        ("a tilted one", &tilted),
        ("a sphere", &above),
        ("a sphere from inside", &around),
        ("a point", &point(vec3(0.3, 1.0, 0.0))),
    ];
    for (name, light) in lights {
        for middle in [Vec2::ZERO, vec2(1.0, 0.0), vec2(-0.5, 1.2)] {
            let [photons, samples] = irradiances(light, middle, 0.6);
            let error = photons.error.hypot(samples.error);
            assert!(
                (photons.mean - samples.mean).abs() < 5.0 * error && samples.mean > 20.0 * error,
                "{name} at {middle}: {photons:?} by photons, {samples:?} by samples"
            );
        }
    }
}

/// A surface of glass that bends and reflects nothing: photons land behind it, where direct light would arrive if it were not there.
fn film(height: f32) -> Thing {
    thing(
        Plane::through(height * Vec3::Y, Dir3::Y),
        Glass::of(Medium::AIR),
    )
}

/// The irradiance of the surface below a point of a white scene, by photons, in W/m². The radiosity of a white surface is its irradiance: π L.
fn irradiance(scene: &Scene, photons: &Photons, above: Vec3) -> f32 {
    let down = Ray::new(above, -Dir3::Y);
    let seen = scene.closest(&down).expect("a surface");
    PI * photons.reflected(scene, &seen, Dir3::Y, u32::MAX).r
}

#[test]
fn photons_of_a_point_light_bring_its_irradiance_through_a_clear_surface() {
    let (lamp, floor) = (
        point(vec3(0.2, 2.0, 0.0)),
        thing(Plane::through(Vec3::ZERO, Dir3::Y), WHITE),
    );
    let scene = Scene::new(vec![floor, film(1.0)], vec![Box::new(lamp)]);
    let photons = Photons::shot(&scene, 500_000, 0.1, 2);
    for (x, z) in [(0.2, 0.0), (-0.8, 0.3), (1.0, 1.5)] {
        // Of all places of a small square: at one place, few photons tell little.
        let (mut brought, mut direct) = (0.0, 0.0);
        for i in 0..100 {
            let at = vec3(x + 0.1 * (i % 10) as f32, 0.0, z + 0.1 * (i / 10) as f32);
            brought += irradiance(&scene, &photons, at + 0.5 * Vec3::Y);
            let sample = lamp.sample(at, Vec2::ZERO).expect("it shines");
            direct += sample.arriving.r * sample.toward.y; // I cos θ/r²
        }
        assert!(
            (brought / direct - 1.0).abs() < 0.01,
            "around {x}, {z}: {brought} by photons, {direct} by direct light"
        );
    }
}

/// A lit place on a thing: name, things, place, the direction in which its neighbours are alike, and by which part the light may be off.
type Place = (&'static str, Vec<Thing>, Vec3, Vec3, f32);

/// Places near edges, where photons light points within `radius`. The first edge is at x = 0.4 m.
fn places_near_edges(radius: f32) -> Vec<Place> {
    let facet = |a, b, c| Thing::new(Triangle::new(a, b, c), WHITE);
    let glass = |a, b, c| Thing::new(Triangle::new(a, b, c), Glass::of(Medium::GLASS));
    let (x, z) = (0.4 * Vec3::X, 0.4 * Vec3::Z);
    let floor = || thing(Plane::through(Vec3::ZERO, Dir3::Y), WHITE);
    let beside = |radii: f32| vec3(0.4 - radii * radius, 0.0, 0.0);
    let corner = |radii: f32| vec3(0.4 - radii * radius, 0.0, 0.4 - radii * radius);
    let plate = || vec![facet(-x - z, x - z, x + z), facet(-x - z, x + z, z - x)];
    let tile = || [plate(), vec![glass(x - z, 5.0 * x - z, x + z)]].concat();
    let block = Cuboid::between(vec3(0.4, 0.0, -1.0), vec3(1.0, 1.0, 1.0));
    let ball = Sphere::new(-4.0 * radius * Vec3::Y, 4.0 * radius);
    let along = Vec3::Z;
    vec![
        ("at a plate's edge", plate(), beside(0.02), along, 0.03),
        ("near its edge", plate(), beside(0.3), along, 0.03),
        ("further from it", plate(), beside(0.8), along, 0.03),
        ("at its corner", plate(), corner(0.02), Vec3::ZERO, 0.08),
        ("near its corner", plate(), corner(0.3), Vec3::ZERO, 0.04),
        ("a tile beside glass", tile(), beside(0.1), along, 0.03),
        (
            "the foot of a wall",
            vec![floor(), thing(Plane::through(x, -Dir3::X), WHITE)],
            beside(0.1),
            along,
            0.03,
        ),
        (
            "the foot of a block",
            vec![floor(), thing(block, WHITE)],
            beside(0.1),
            along,
            0.03,
        ),
        (
            "a floor in shallow water",
            vec![floor(), film(0.05 * radius)],
            beside(0.1),
            along,
            0.03,
        ),
        (
            "the top of a small ball",
            vec![thing(ball, WHITE)],
            Vec3::ZERO,
            Vec3::ZERO,
            0.04,
        ),
    ]
}

#[test]
fn photons_bring_as_much_light_near_an_edge_as_elsewhere() {
    const RADIUS: f32 = 0.1;
    for (name, things, place, along, off) in places_near_edges(RADIUS) {
        // Straight above, so that there is as much light on one side of the place as on the other.
        let lamp = point(place + Vec3::Y);
        let things = [things, vec![film(0.5)]].concat();
        let scene = Scene::new(things, vec![Box::new(lamp)]);
        let (mut brought, mut direct) = (0.0, 0.0);
        let seeds = if along == Vec3::ZERO { 8 } else { 2 };
        for seed in 0..seeds {
            let photons = Photons::shot(&scene, 300_000, RADIUS, seed);
            for i in -100..=100 {
                // A little aside too: the rays that look for the edge are others.
                let at = place + 1e-3 * i as f32 * along - 1e-6 * i as f32 * Vec3::X;
                brought += irradiance(&scene, &photons, at + 0.004 * Vec3::Y);
                let sample = lamp.sample(at, Vec2::ZERO).expect("it shines");
                direct += sample.arriving.r * sample.toward.y;
            }
        }
        println!("{name}: {:.3} of the light", brought / direct);
        assert!(
            (brought / direct - 1.0).abs() < off,
            "{name}: {brought} by photons, {direct} by direct light"
        );
    }
}

#[test]
fn a_caustic_has_all_the_power_that_a_point_light_sends_into_clear_glass() {
    let (lamp, middle, radius) = (point(vec3(0.0, 2.0, 0.0)), vec3(0.0, 0.75, 0.0), 0.5);
    let glass = thing(Sphere::new(middle, radius), Glass::of(Medium::GLASS));
    let room = thing(Sphere::new(Vec3::Y, 5.0), WHITE);
    let scene = Scene::new(vec![glass, room], vec![Box::new(lamp)]);
    let photons = Photons::shot(&scene, 200_000, 0.1, 4);
    assert!(photons.come_from(0));
    let landed: f64 = photons.all().iter().map(|p| f64::from(p.power.r)).sum();
    // The ball is seen in a cone with the solid angle 2π(1 − cos α), sin α = radius/distance, and takes no light away.
    let sine = f64::from(radius / middle.distance(lamp.position));
    let sent = 3.0 * f64::from(2.0 * PI) * (1.0 - (1.0 - sine * sine).sqrt());
    assert!(
        (landed / sent - 1.0).abs() < 0.003,
        "{sent} W are sent into the ball, and {landed} W have landed"
    );
}

#[test]
fn a_point_light_has_the_caustic_of_a_tiny_ball_of_light() {
    // I = π ρ² L: at the same power, the ball of light has the same intensity to all sides.
    let (lamp, radius) = (point(vec3(0.2, 2.0, 0.0)), 1e-3);
    let tiny = SphereLight {
        radiance: lamp.intensity / (PI * radius * radius),
        ..ball_of_light(lamp.position, radius)
    };
    let [point, ball] = [Box::new(lamp) as Box<dyn Light>, Box::new(tiny)].map(|light| {
        let scene = Scene::new(vec![floor(), ball(Medium::GLASS)], vec![light]);
        let photons = with_photons(&scene, ALL);
        let below = (vec3(0.0, 0.1, 0.0), 1.0);
        seen_below(&scene, &photons, below, 10_000)
    });
    let apart = (point.mean / ball.mean - 1.0).abs();
    assert!(apart < 0.02, "{point:?} by a point, {ball:?} by a ball");
}

/// What is seen straight below a point, on average over a square around `middle` with this `side`, in metres.
fn seen_below(
    scene: &Scene,
    integrator: &dyn Integrator,
    (middle, side): Square,
    samples: u32,
) -> Mean {
    Mean::sampled(43, samples, |rng| {
        let aside = side * (square(rng) - 0.5);
        let ray = Ray::new(middle + vec3(aside.x, 0.0, aside.y), -Dir3::Y);
        integrator.follow(scene, &ray, Cone::THIN, rng).radiance.r
    })
}

fn with_photons(scene: &Scene, path: Path) -> Caustics {
    Caustics {
        path,
        photons: Photons::shot(scene, 200_000, 0.02, 7),
        brightest: f32::INFINITY,
    }
}

/// The middle of a square, and its side, in metres.
type Square = (Vec3, f32);

/// Scenes with caustics: name, scene, and squares that are looked at from above.
fn scenes() -> Vec<(&'static str, Scene, Vec<Square>)> {
    let on_floor = |x: f32, z: f32| vec3(x, 0.1, z);
    let green = Medium {
        absorption: Rgb::new(0.9, 0.1, 0.6),
        ..Medium::GLASS
    };
    let lit = |things| Scene::new(things, vec![Box::new(lamp())]);
    let water = thing(
        Plane::through(0.5 * Vec3::Y, Dir3::Y),
        Glass::of(Medium::WATER),
    );
    let polished = Polished {
        mirror: Mirror {
            share: Rgb::gray(0.4),
        },
        below: Lambert {
            albedo: Rgb::gray(0.5),
        },
    };
    let bulb = ball_of_light(vec3(0.0, 2.0, 0.0), 0.3);
    let around_bulb = |radius, glass| thing(Sphere::new(vec3(0.0, 2.0, 0.0), radius), glass);
    let shell = [
        around_bulb(0.4, Glass::of(Medium::GLASS)),
        around_bulb(
            0.35,
            Glass {
                outside: Medium::GLASS,
                inside: Medium::AIR,
            },
        ),
    ];
    vec![
        (
            "a glass ball",
            burning_glass(),
            vec![
                (on_floor(0.0, 0.0), 0.2),
                (on_floor(0.0, 0.0), 1.0),
                (on_floor(1.0, 0.5), 0.8),
            ],
        ),
        (
            "a green ball",
            lit(vec![floor(), ball(green)]),
            vec![(on_floor(0.0, 0.0), 0.4)],
        ),
        (
            "a mirror",
            lit(vec![floor(), wall(SILVERED)]),
            vec![(on_floor(0.5, 0.0), 0.5), (on_floor(-1.0, 0.6), 1.0)],
        ),
        (
            "a mirror and a ball",
            lit(vec![floor(), wall(SILVERED), ball(Medium::GLASS)]),
            vec![(on_floor(0.0, 0.0), 0.5), (on_floor(0.8, 0.0), 0.5)],
        ),
        (
            "polish on the wall",
            lit(vec![floor(), wall(polished)]),
            vec![(on_floor(0.7, 0.0), 0.6)],
        ),
        (
            "a floor under water",
            lit(vec![floor(), water]),
            vec![(vec3(0.0, 1.0, 0.0), 1.0)],
        ),
        (
            "a lamp in a shell of glass",
            Scene::new([vec![floor()], shell.into()].concat(), vec![Box::new(bulb)]),
            vec![(on_floor(0.3, 0.0), 1.0)],
        ),
    ]
}

/// The blur of the photons moves light by less than their radius, a tenth of the smallest square: less than 2 % here.
const BLUR: f64 = 0.02;

#[test]
fn paths_with_photons_see_what_paths_alone_see() {
    for (name, scene, squares) in scenes() {
        let path = Path { depth: 5, ..ALL };
        let photons = with_photons(&scene, path);
        let found = photons.photons.all().len();
        assert!(found > 1000, "{name}: {found} photons have landed");
        for square in squares {
            let alone = seen_below(&scene, &path, square, 30_000);
            let with = seen_below(&scene, &photons, square, 3000);
            let error = alone.error.hypot(with.error);
            let apart = (alone.mean - with.mean).abs();
            assert!(
                apart < 4.0 * error + BLUR * alone.mean && alone.mean > 30.0 * error,
                "{name}, {square:?}: {with:?} with photons, {alone:?} without"
            );
        }
    }
}

#[test]
fn a_short_path_sees_only_photons_of_short_ways() {
    let scene = burning_glass();
    let below = (vec3(0.0, 0.1, 0.0), 0.2);
    let [none, through] = [2, 3].map(|depth| {
        let photons = with_photons(&scene, Path { depth, ..ALL });
        seen_below(&scene, &photons, below, 2000).mean
    });
    assert_eq!(
        none, 0.0,
        "the floor and one side of the ball are two surfaces"
    );
    assert!(
        through > 1.0,
        "both sides of the ball and the floor: {through}"
    );
}

#[test]
fn a_white_floor_shows_all_the_power_that_has_landed_on_it() {
    const RADIUS: f32 = 0.05;
    /// Half of the side of the square that is looked at, in metres.
    const HALF: f32 = 1.0;
    let floor = thing(Plane::through(Vec3::ZERO, Dir3::Y), WHITE);
    let scene = Scene::new(vec![floor, ball(Medium::GLASS)], vec![Box::new(lamp())]);
    let photons = Photons::shot(&scene, 20_000, RADIUS, 3);
    let inside = |p: Vec3| p.x.abs() < HALF && p.z.abs() < HALF;
    let landed = photons
        .all()
        .iter()
        .filter(|photon| inside(photon.position));
    let landed: f32 = landed.map(|photon| photon.power.r).sum();
    let (step, n) = (RADIUS / 4.0, (2.0 * HALF / (RADIUS / 4.0)) as i32);
    let places = (0..n * n).map(|i| vec2((i % n) as f32, (i / n) as f32) + 0.5);
    let shown: f32 = places
        .map(|place| {
            let place = step * place - HALF;
            irradiance(&scene, &photons, vec3(place.x, 0.01, place.y)) * step * step
        })
        .sum();
    assert!(
        (shown / landed - 1.0).abs() < 0.01,
        "{landed} W have landed, and {shown} W are shown"
    );
}

#[test]
fn photons_land_only_after_mirrors_or_glass() {
    let bare = Scene::new(vec![floor(), wall(WHITE)], vec![Box::new(lamp())]);
    let photons = Photons::shot(&bare, 10_000, 0.1, 0);
    assert_eq!(photons.all(), [], "there is no mirror and no glass");
    for (name, scene, _) in scenes() {
        let photons = Photons::shot(&scene, 10_000, 0.1, 0);
        for photon in photons.all() {
            assert!(photon.surfaces > 0, "{name}: {photon:?}");
            let side = photon.normal.dot(*photon.toward);
            assert!(side > 0.0, "{name}, from behind: {photon:?}");
        }
    }
}

#[test]
fn photons_light_their_own_side_only() {
    // Two sheets, a hundredth of the radius apart: the upper one is lit from above, through glass of the index of air.
    let sheet = |y: f32| thing(Plane::through(y * Vec3::Y, Dir3::Y), WHITE);
    let scene = Scene::new(vec![sheet(0.0), film(1.0)], vec![Box::new(lamp())]);
    let photons = Photons::shot(&scene, 20_000, 0.2, 0);
    let look = |from: Vec3, toward: Dir3| {
        let seen = scene.closest(&Ray::new(from, toward)).expect("a sheet");
        photons.reflected(&scene, &seen, -toward, u32::MAX).r
    };
    assert!(look(0.5 * Vec3::Y, -Dir3::Y) > 0.1, "the lit side");
    assert_eq!(look(-0.5 * Vec3::Y, Dir3::Y), 0.0, "the dark side");
}

#[test]
fn a_lamp_without_delta_lobes_in_the_way_is_still_seen() {
    // Straight to the lamp, and to the lamp in a mirror: no surface has scattered, so no photon brings this light.
    let scene = Scene::new(vec![floor(), wall(SILVERED)], vec![Box::new(lamp())]);
    let photons = with_photons(&scene, ALL);
    let up = Ray::new(vec3(0.0, 1.0, 0.0), Dir3::Y);
    let image = vec3(2.4, 2.5, 0.0); // of the lamp's middle, in the mirror at x = 1.2
    let to_mirror = Dir3::new(image - up.origin).expect("a direction");
    for (ray, radiance) in [(up, 8.0), (Ray::new(up.origin, to_mirror), 8.0 * 0.9)] {
        let seen = photons.follow(&scene, &ray, Cone::THIN, &mut pcg::stream(0, 0));
        assert!(
            (seen.radiance.r - radiance).abs() < 1e-5,
            "{ray:?}: {seen:?}, not {radiance}"
        );
    }
}

#[test]
fn one_thread_shoots_the_same_photons_as_two() {
    let scene = burning_glass();
    let [one, two] = [1, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads")
            .install(|| Photons::shot(&scene, 100_000, 0.01, 5))
    });
    assert!(one.all().len() > 1000, "{one:?}");
    assert_eq!(one.all(), two.all());
    assert_ne!(
        one.all()[0],
        Photons::shot(&scene, 100_000, 0.01, 6).all()[0],
        "another seed, other photons"
    );
}
