//! The evening behind the window: its range, and its independence of last bits.

use glam::{Vec2, Vec3, vec3};
use rand::RngExt;
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::Image;
use raybook::image::compare::{Tolerance, compare};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::film::Film;
use raybook::scene::noise;
use raybook_chapters::ch02_hdr::{evening, window};

fn look_out(width: usize, jiggle: f32) -> Image {
    let film = Film {
        seed: 1,
        threads: 2,
        ..Film::new(width, width * 9 / 16, 4)
    };
    let camera = Pinhole::look_at(window::EYE, window::MIDDLE, Vec3::Y, 0.024, film.aspect())
        .expect("it can");
    film.sample(|place, rng| {
        let ray = camera.central_ray(place);
        let off = jiggle * (vec3(rng.random(), rng.random(), rng.random()) - 0.5);
        window::radiance(&Ray::new(
            ray.origin,
            Dir3::new_or(*ray.direction + off, ray.direction),
        ))
    })
}

#[test]
fn the_scene_spans_more_than_five_orders_of_magnitude() {
    for width in [64, 96, 320] {
        let picture = look_out(width, 0.0);
        let luminances = || picture.pixels().iter().map(|p| p.luminance());
        let (least, most) = (
            luminances().fold(f32::INFINITY, f32::min),
            luminances().fold(0.0, f32::max),
        );
        assert!(least > 0.0, "no pixel is black: the ratio has a meaning");
        assert!(
            most / least > 1e5,
            "from {least} to {most} at {width} pixels"
        );
        assert!(
            picture
                .pixels()
                .iter()
                .flat_map(|p| p.channels())
                .all(|v| v.is_finite() && v >= 0.0),
            "all is light"
        );
    }
}

#[test]
fn the_scene_does_not_hang_on_last_bits() {
    // Directions moved by an ulp, as another processor's `sin` or `exp` might: the golden comparison must not notice.
    let compared = compare(
        &look_out(96, 0.0),
        &look_out(96, 1.2e-7),
        &Tolerance::RENDERED_AGAIN,
    );
    assert_eq!(compared, Ok(()), "the picture is stable");
}

#[test]
fn rays_in_every_direction_find_light() {
    for i in 0..2000 {
        let mut rng = pcg::stream(5, i);
        let d = Vec3::from_array([rng.random(), rng.random(), rng.random()]) * 2.0 - 1.0;
        let direction = Dir3::new_or(d, Dir3::Y);
        let (inside, outside) = (
            window::radiance(&Ray::new(window::EYE, direction)),
            evening::radiance(direction),
        );
        for v in inside.channels().into_iter().chain(outside.channels()) {
            assert!(v.is_finite() && v > 0.0, "{direction:?} sees {v}");
        }
    }
    for axis in [Dir3::X, Dir3::Y, Dir3::Z, -Dir3::X, -Dir3::Y, -Dir3::Z] {
        let seen = window::radiance(&Ray::new(window::EYE, axis)).luminance();
        assert!(seen.is_finite() && seen > 0.0, "{axis:?} sees {seen}");
    }
}

#[test]
fn the_sun_sends_what_its_disc_adds_up_to() {
    // The integral of the radiance over the disc, minus the sky's, in rings and sectors around the sun's middle.
    let sun = evening::toward_sun();
    let right = Dir3::new_or(sun.cross(Vec3::Y), Dir3::X);
    let up = right.cross(*sun);
    let (rings, sectors) = (400, 24);
    let mut sum = [0.0_f64; 3];
    for ring in 0..rings {
        let angle = evening::SUN_RADIUS * 1.0001 * (ring as f32 + 0.5) / rings as f32;
        for sector in 0..sectors {
            let around = std::f32::consts::TAU * sector as f32 / sectors as f32;
            let off = around.cos() * *right + around.sin() * up;
            let d = Dir3::new_or(angle.cos() * *sun + angle.sin() * off, sun);
            let solid_angle = f64::from(angle.sin() * evening::SUN_RADIUS * 1.0001 / rings as f32)
                * std::f64::consts::TAU
                / f64::from(sectors);
            for (sum, v) in sum.iter_mut().zip(evening::radiance(d).channels()) {
                *sum += f64::from(v) * solid_angle;
            }
        }
    }
    for (sum, stated) in sum.into_iter().zip(evening::sunlight().channels()) {
        // The sky around the sun adds about 2e-3.
        let ratio = sum / f64::from(stated);
        assert!(
            (ratio - 1.0).abs() < 5e-3,
            "the disc sends {ratio} of what is stated"
        );
    }
}

#[test]
fn noise_stays_in_its_range_and_has_no_steps() {
    let mut largest_step: f32 = 0.0;
    for i in 0..4000 {
        let p = Vec2::new(i as f32 * 0.013 - 20.0, 7.3 - i as f32 * 0.007);
        for v in [noise::noise(p), noise::layers(p, 5)] {
            assert!((0.0..=1.0).contains(&v), "noise at {p} is {v}");
        }
        largest_step = largest_step.max((noise::noise(p + 0.001) - noise::noise(p)).abs());
    }
    // The blend's slope is 1.5 at most, in two directions.
    assert!(
        largest_step < 0.004,
        "a step of {largest_step} over a thousandth"
    );
}
