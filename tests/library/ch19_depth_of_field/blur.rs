//! What a point becomes in a picture, measured in the picture.

use crate::ch19_depth_of_field::camera;
use glam::{DVec2, Vec2, dvec2, vec2};
use raybook::camera::Camera;
use raybook::camera::aperture::Aperture;
use raybook::camera::thin_lens::ThinLens;
use raybook::image::{Image, rgb::Rgb};
use raybook::light::point::PointLight;
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::render::glints::add_glints;
use raybook::shape::{Shape, sphere::Sphere};

/// Pixels along a side of the film.
const SIDE: usize = 96;

const HEXAGON: Aperture = Aperture::Blades {
    count: 6,
    turn: 0.0,
};

/// A film that is 1.5 times as wide as the disc should be, around a point on the axis.
fn towards(depth: f32, f_number: f32, aperture: Aperture) -> ThinLens {
    let wide = |plane| camera(Vec2::splat(plane), f_number, 2.0, aperture);
    wide(1.5 * wide(1.0).lens.circle_of_confusion(depth))
}

fn film(samples: usize) -> Film<'static> {
    Film {
        seed: 19,
        threads: 2,
        ..Film::new(SIDE, SIDE, samples)
    }
}

/// A tiny ball that shines, found by rays from the camera. Its radius in the picture is a fifth of the disc's.
fn ball(camera: &ThinLens, depth: f32) -> (Image, f64) {
    let shadow = camera.lens.aperture() * (depth - 2.0).abs() / 2.0;
    let radius = 0.1 * shadow;
    let center = camera.view.focal_point + depth * *camera.view.forward;
    let sphere = Sphere::new(center, radius);
    let picture = film(256).evenly(|place, numbers| {
        let ray = camera.ray(place, numbers.pair());
        Rgb::gray(f32::from(sphere.hit(&ray, Interval::AHEAD).is_some()))
    });
    (
        picture,
        f64::from(2.0 * radius * camera.view.focal_length / depth),
    )
}

/// A point light, found from the light.
fn point(camera: &ThinLens, depth: f32) -> Image {
    let mut picture = Image::from_fn(SIDE, SIDE, |_, _| Rgb::BLACK);
    let light = PointLight {
        position: camera.view.focal_point + depth * *camera.view.forward,
        intensity: Rgb::WHITE,
    };
    add_glints(&mut picture, &film(1), camera, &[light], |_, _| true);
    picture
}

/// The mean of squared distances from the middle of the light, in m², and the light, in pixels of radiance 1.
fn spread(camera: &ThinLens, picture: &Image) -> (f64, f64) {
    let pixel = f64::from(camera.view.plane.x) / SIDE as f64;
    let (mut sum, mut square) = (0.0, 0.0);
    for (y, x) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (y, x))) {
        let p: DVec2 = dvec2(x as f64, y as f64) + 0.5 - 0.5 * SIDE as f64;
        let light = f64::from(picture.at(x, y).g);
        sum += light;
        square += light * (p * pixel).length_squared();
    }
    (square / sum - pixel * pixel / 6.0, sum) // a pixel's own extent is 1/6 of its square
}

#[test]
fn the_disc_of_a_point_of_light_is_as_wide_as_the_formula_says() {
    for f_number in [2.0, 5.6] {
        for depth in [1.0, 1.5, 3.0, 5.0, 10.0] {
            let camera = towards(depth, f_number, Aperture::Round);
            let c = f64::from(camera.lens.circle_of_confusion(depth));
            let pixel = f64::from(camera.view.plane.x) / SIDE as f64;
            // ⟨r²⟩ of a disc is an eighth of its squared diameter, and a blurred disc's is the sum of both.
            let (picture, own) = ball(&camera, depth);
            let by_camera = (8.0 * spread(&camera, &picture).0 - own * own).sqrt();
            let by_light = (8.0 * spread(&camera, &point(&camera, depth)).0).sqrt();
            for (how, measured) in [("the camera", by_camera), ("the light", by_light)] {
                assert!(
                    (measured - c).abs() < 0.5 * pixel,
                    "f/{f_number}, {depth} m, rays from {how}: {} mm, and should be {} mm",
                    1e3 * measured,
                    1e3 * c
                );
            }
        }
    }
}

#[test]
fn a_hexagonal_aperture_makes_hexagons_of_the_same_circle() {
    for depth in [1.0, 10.0] {
        let camera = towards(depth, 2.0, HEXAGON);
        let c = f64::from(camera.lens.circle_of_confusion(depth));
        let pixel = f64::from(camera.view.plane.x) / SIDE as f64;
        let picture = point(&camera, depth);
        // ⟨r²⟩ = 5/12 R² for the corners' distance R, against 1/2 for a disc.
        let measured = (spread(&camera, &picture).0 * 12.0 / 5.0).sqrt() * 2.0;
        assert!(
            (measured - c).abs() < 0.5 * pixel,
            "{measured} from corner to corner, not {c}"
        );
        let lit = |x: usize, y: usize| picture.at(x, y).g > 0.5 * picture.at(SIDE / 2, SIDE / 2).g;
        let across = (0..SIDE).filter(|&x| lit(x, SIDE / 2)).count() as f64 * pixel;
        let high = (0..SIDE).filter(|&y| lit(SIDE / 2, y)).count() as f64 * pixel;
        assert!(
            (across - c).abs() < 2.0 * pixel,
            "corners on the left and the right: {across}"
        );
        let flat = c * 0.75_f64.sqrt();
        assert!(
            (high - flat).abs() < 2.0 * pixel,
            "flat above and below: {high}, not {flat}"
        );
        let area = (0..SIDE * SIDE).filter(|i| lit(i % SIDE, i / SIDE)).count() as f64;
        let expected = 0.375 * 3_f64.sqrt() * c * c / (pixel * pixel);
        assert!(
            (area / expected - 1.0).abs() < 0.02,
            "{area} pixels, and should be {expected}"
        );
    }
}

#[test]
fn rays_from_the_light_bring_as_much_as_rays_from_the_camera_find() {
    for (depth, aperture) in [(1.2, Aperture::Round), (4.0, HEXAGON)] {
        let camera = towards(depth, 2.0, aperture);
        let (found, own) = ball(&camera, depth);
        let radius = 0.5 * own as f32 * depth / camera.view.focal_length;
        // A ball of radiance 1 sends out π r² W/sr.
        let intensity = f64::from(std::f32::consts::PI * radius * radius);
        let (found, sent) = (
            spread(&camera, &found).1,
            spread(&camera, &point(&camera, depth)).1,
        );
        let ratio = found / (sent * intensity);
        assert!(
            (ratio - 1.0).abs() < 0.02,
            "at {depth} m: {ratio} times as much"
        );
    }
}

#[test]
fn what_is_in_the_way_or_beside_the_film_brings_nothing() {
    let camera = towards(3.0, 2.0, Aperture::Round);
    let mut picture = Image::from_fn(SIDE, SIDE, |_, _| Rgb::BLACK);
    let light = |position| PointLight {
        position,
        intensity: Rgb::WHITE,
    };
    let (eye, ahead) = (camera.view.focal_point, *camera.view.forward);
    let lights = [
        light(eye - 3.0 * ahead),
        light(eye + 3.0 * ahead + *camera.view.right),
    ];
    add_glints(&mut picture, &film(1), &camera, &lights, |_, _| true);
    add_glints(
        &mut picture,
        &film(1),
        &camera,
        &[light(eye + 3.0 * ahead)],
        |_, _| false,
    );
    assert!(
        picture.pixels().iter().all(|p| *p == Rgb::BLACK),
        "nothing arrives"
    );
    let left = |ray: &raybook::math::ray::Ray| (ray.origin - eye).dot(*camera.view.right) < 0.0;
    add_glints(
        &mut picture,
        &film(1),
        &camera,
        &[light(eye + 3.0 * ahead)],
        |ray, _| left(ray),
    );
    let lit = |from, to| {
        (from..to)
            .filter(|&x| picture.at(x, SIDE / 2).g > 0.0)
            .count()
    };
    let halves = vec2(lit(0, SIDE / 2) as f32, lit(SIDE / 2, SIDE) as f32);
    assert!(
        halves.min_element() <= 1.0 && halves.max_element() > 20.0,
        "half of the lens shows half of the disc: {halves}"
    );
}
