//! Chapter 13: mirrors, and rays that ask rays.

mod depth;
use raybook_common::rays;
mod tree;

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::material::{
    Material, Sight, beyond,
    mirror::{Mirror, reflect},
    phong::Phong,
    polished::Polished,
};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::local::{Local, NO_SHADOWS};
use raybook::render::whitted::Whitted;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Surface, plane::Plane};
use rays::{random_direction, ray};

fn whitted(depth: u32) -> Whitted {
    let local = Local {
        samples: 1,
        arrives: NO_SHADOWS,
    };
    Whitted { local, depth }
}

/// What a ray sees of a scene.
fn see(scene: &Scene, ray: &Ray, depth: u32) -> Rgb {
    whitted(depth).radiance(scene, ray, &mut pcg::stream(0, 0))
}

/// A mirror in the xz plane with this share, before a backdrop whose brightness is 1 + the height of the direction.
fn floor_mirror(material: impl Material + 'static) -> Scene {
    let floor = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), material);
    Scene::new(vec![floor], Vec::new())
        .surrounded_by(Rgb::gray(0.5), |ray| Rgb::gray(1.0 + ray.direction.y))
}

#[test]
fn reflection_turns_round_what_is_square_to_the_mirror_and_keeps_the_rest() {
    let mut rng = pcg::stream(13, 0);
    for _ in 0..10_000 {
        let [i, n] = [(); 2].map(|()| random_direction(&mut rng));
        let r = reflect(i, n);
        // A few roundings of numbers up to 2.
        assert!((r.length() - 1.0).abs() < 1e-6, "{i:?} {n:?}: a direction");
        assert!(
            (r.dot(*n) + i.dot(*n)).abs() < 1e-6,
            "{i:?} {n:?}: square to the mirror"
        );
        assert!(
            (r.cross(*n) - i.cross(*n)).length() < 1e-6,
            "{i:?} {n:?}: along the mirror"
        );
        assert!(
            r.distance(*reflect(i, -n)) < 1e-6,
            "{i:?} {n:?}: a mirror has two equal sides"
        );
        assert!(
            reflect(r, n).distance(*i) < 1e-6,
            "{i:?} {n:?}: twice is not at all"
        );
    }
}

#[test]
fn a_mirror_shows_what_is_above_it_below_it() {
    let scene = floor_mirror(Mirror {
        share: Rgb::new(1.0, 0.5, 0.0),
    });
    for down in [
        vec3(0.0, -1.0, 0.0),
        vec3(3.0, -4.0, 0.0),
        vec3(1.0, -0.001, 0.0),
    ] {
        let seen = see(&scene, &ray(vec3(0.0, 2.0, 0.0), down), 2);
        let sky = 1.0 - down.normalize().y;
        assert!(
            (seen.r - sky).abs() < 1e-6,
            "{down}: the sky at the mirrored height, not {seen:?}"
        );
        assert_eq!(
            (seen.g, seen.b),
            (0.5 * seen.r, 0.0),
            "{down}: the mirror's share of each channel"
        );
    }
}

#[test]
fn both_sides_of_a_mirror_reflect() {
    let scene = floor_mirror(Mirror { share: Rgb::WHITE });
    let seen = see(&scene, &ray(vec3(0.0, -2.0, 0.0), vec3(3.0, 4.0, 0.0)), 2);
    assert!(
        (seen.r - 0.2).abs() < 1e-6,
        "from below, the ground is seen: 1 − 0.8, not {seen:?}"
    );
}

#[test]
fn polish_reflects_its_share_and_lets_the_rest_through() {
    let below = Phong {
        ambient: Rgb::gray(0.6),
        diffuse: Rgb::BLACK,
        specular: Rgb::BLACK,
        exponent: 1.0,
    };
    let down = ray(vec3(0.0, 2.0, 0.0), Vec3::NEG_Y);
    for (share, expected) in [(0.0, 0.3), (0.25, 0.25 * 2.0 + 0.75 * 0.3), (1.0, 2.0)] {
        let mirror = Mirror {
            share: Rgb::gray(share),
        };
        let seen = see(&floor_mirror(Polished { mirror, below }), &down, 2);
        assert!(
            (seen.r - expected).abs() < 1e-6,
            "{share} of the sky: {expected}, not {seen:?}"
        );
    }
}

#[test]
fn an_interpolated_normal_never_sends_a_ray_below_the_surface() {
    let mut rng = pcg::stream(13, 1);
    let mirror = Mirror { share: Rgb::WHITE };
    let mut corrected = 0;
    for _ in 0..10_000 {
        let [normal, bend, view] = [(); 3].map(|()| random_direction(&mut rng));
        let shading_normal = Dir3::new_or(*normal + 0.7 * *bend, normal);
        let at = Surface {
            shading_normal,
            ..Surface::flat(Vec3::ZERO, 1e-6, normal)
        };
        let side = |d: Dir3| normal.dot(*d) < 0.0;
        beyond(&mirror, &at, view, &mut |onward, _| {
            assert_eq!(
                side(onward.direction),
                side(view),
                "{at:?}, seen from {view:?}: {onward:?}"
            );
            assert_eq!(
                side(Dir3::new_or(onward.origin, view)),
                side(view),
                "it starts there too"
            );
            Sight {
                radiance: Rgb::BLACK,
                distance: f32::INFINITY,
            }
        });
        corrected += u32::from(side(reflect(-view, shading_normal)) != side(view));
    }
    assert!(
        corrected > 500,
        "only {corrected} would have gone below: the test tries too little"
    );
}
