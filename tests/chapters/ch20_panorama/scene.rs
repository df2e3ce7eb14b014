//! The pavilion and its summer day.

use crate::ch20_panorama::{direction, seen};
use glam::{Vec3, vec3};
use raybook::light::Light;
use raybook::math::{basis::Basis, dir3::Dir3, pcg, ray::Ray};
use raybook_chapters::ch20_panorama::pavilion::{self, BEAMS, EYE};
use raybook_chapters::ch20_panorama::summer::{self, SUN_RADIUS};
use std::f64::consts::TAU;

#[test]
fn the_sun_that_is_seen_is_the_sun_that_shines() {
    let basis = Basis::around(summer::toward_sun());
    let rings = 200;
    let reach = 1.2 * f64::from(SUN_RADIUS);
    let mut arriving = 0.0;
    for ring in 0..rings {
        let theta = reach * (f64::from(ring) + 0.5) / f64::from(rings);
        let solid_angle = TAU * theta.sin() * reach / f64::from(rings);
        for i in 0..16 {
            let turn = TAU * f64::from(i) / 16.0;
            let off = glam::dvec3(
                theta.sin() * turn.cos(),
                theta.sin() * turn.sin(),
                theta.cos(),
            );
            let toward = Dir3::new_or(basis.to_world(off.as_vec3()), Dir3::Y);
            let radiance = summer::outdoors(&Ray::new(Vec3::ZERO, toward)).g;
            arriving += f64::from(radiance) * solid_angle / 16.0;
        }
    }
    let sun = summer::sun().sample(Vec3::ZERO, glam::Vec2::ZERO);
    let expected = f64::from(sun.expect("it shines").arriving.g);
    // The sky around and in front of it adds a few thousandths.
    let ratio = arriving / expected;
    assert!((0.995..1.01).contains(&ratio), "{arriving}, not {expected}");
}

#[test]
fn there_is_light_in_every_direction() {
    let scene = pavilion::scene();
    let mut rng = pcg::stream(205, 0);
    let (mut above, mut below) = (0, 0);
    for _ in 0..5000 {
        let ray = Ray::new(EYE, direction(&mut rng));
        let light = seen(&scene, &ray);
        let fine = |v: &f32| v.is_finite() && *v > 0.0;
        assert!(light.channels().iter().all(fine), "{ray:?}: {light:?}");
        let meets = scene.closest(&ray).is_some();
        above += i32::from(meets && ray.direction.y > 0.3);
        below += i32::from(meets && ray.direction.y < 0.0);
    }
    assert!(above > 300, "there are things above too: {above}");
    assert!(below > 2000, "there is ground everywhere below: {below}");
}

#[test]
fn the_beams_edges_are_where_the_figure_draws_them() {
    let scene = pavilion::scene();
    for (name, [a, b]) in BEAMS {
        // At a post the edge is hidden; between them, the beam is above it and the distance below.
        for part in [0.22, 0.5, 0.78] {
            let edge = a.lerp(b, part);
            let distance = |aside: f32| {
                let toward = edge + vec3(0.0, aside, 0.0) - EYE;
                let ray = Ray::new(EYE, Dir3::new(toward).expect("not zero"));
                scene.closest(&ray).map_or(f32::INFINITY, |seen| seen.t)
            };
            let (above, below) = (distance(0.02), distance(-0.05));
            let expected = edge.distance(EYE);
            assert!(
                (above - expected).abs() < 0.05,
                "{name}: just above {edge} is the beam, {above} m away, not {expected}"
            );
            assert!(below > expected + 0.1, "{name}: and below it, {below} m");
        }
    }
}
