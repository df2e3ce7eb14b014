//! The rays of a thin lens.

use crate::ch19_depth_of_field::camera;
use glam::{Vec2, vec2};
use proptest::prelude::*;
use raybook::camera::Camera;
use raybook::camera::aperture::Aperture;
use raybook::camera::thin_lens::ThinLens;

const PLANE: Vec2 = vec2(0.036, 0.024);

fn at(f_number: f32, focus: f32) -> ThinLens {
    camera(PLANE, f_number, focus, Aperture::Round)
}

#[test]
fn a_tiny_hole_sees_what_the_pin_hole_sees() {
    let pinhole = at(f32::INFINITY, 2.0);
    for film in [vec2(0.5, 0.5), vec2(0.0, 0.0), vec2(0.9, 0.2)] {
        for lens in [vec2(0.1, 0.9), vec2(0.7, 0.7)] {
            let (ray, expected) = (pinhole.ray(film, lens), pinhole.view.central_ray(film));
            assert_eq!(ray.origin, expected.origin, "it starts in the hole");
            assert!(
                ray.direction.distance(*expected.direction) < 1e-6,
                "{film}: {ray:?}, and should be {expected:?}"
            );
        }
    }
}

#[test]
fn the_central_ray_is_that_of_the_pin_hole_whatever_the_aperture() {
    let blades = Aperture::Blades {
        count: 5,
        turn: 0.3,
    };
    for aperture in [Aperture::Round, blades] {
        let camera = camera(PLANE, 1.4, 2.0, aperture);
        for film in [vec2(0.5, 0.5), vec2(0.0, 0.0), vec2(0.9, 0.2)] {
            let (central, pinhole) = (camera.central_ray(film), camera.view.central_ray(film));
            assert_eq!(central, pinhole, "{aperture:?} at {film}");
        }
    }
}

#[test]
fn the_film_moves_back_when_the_focus_comes_nearer() {
    let height = |focus| {
        let top = at(2.0, focus).refracted(vec2(0.5, 0.0), Vec2::ZERO);
        top.direction.y / -top.direction.z
    };
    assert!(
        (height(1e6) - 0.012 / 0.05).abs() < 1e-5,
        "far away: the view of a pin-hole of 50 mm"
    );
    assert!(
        (height(0.1) - 0.012 / 0.1).abs() < 1e-5,
        "at twice the focal length the film is at twice the focal length too"
    );
}

proptest! {
    #[test]
    fn all_rays_of_a_place_on_the_film_meet_in_the_plane_in_focus(
        x in 0.0_f32..1.0, y in 0.0_f32..1.0, u in 0.0_f32..1.0, v in 0.0_f32..1.0,
        focus in 0.06_f32..100.0, f_number in 0.8_f32..32.0,
    ) {
        let camera = at(f_number, focus);
        let film = vec2(x, y);
        let (ray, central) = (camera.ray(film, vec2(u, v)), camera.central_ray(film));
        let on_plane = |ray: raybook::math::ray::Ray| ray.at(focus / ray.direction.dot(*camera.view.forward));
        let (a, b) = (on_plane(ray), on_plane(central));
        let off = ray.origin - camera.view.focal_point;
        prop_assert!(a.distance(b) < 2e-6 * (1.0 + focus), "{a} and {b} are {} apart", a.distance(b));
        prop_assert!(off.dot(*camera.view.forward).abs() < 1e-6, "the ray starts in the lens");
        prop_assert!(off.length() <= 0.5 * camera.lens.aperture() + 1e-6, "within its radius: {off}");
        prop_assert!((ray.direction.length() - 1.0).abs() < 1e-6, "the direction has length 1");
    }

    #[test]
    fn light_goes_back_to_the_place_from_which_the_ray_came(
        x in 0.0_f32..1.0, y in 0.0_f32..1.0, u in 0.0_f32..1.0, v in 0.0_f32..1.0,
        focus in 0.1_f32..20.0, t in 0.2_f32..50.0,
    ) {
        let camera = at(1.4, focus);
        let (film, on_lens) = (vec2(x, y), camera.aperture.point(vec2(u, v)));
        let ray = camera.refracted(film, on_lens);
        let back = camera.arrival(ray.at(t), on_lens).expect("it is in front");
        prop_assert!(back.film.distance(film) < 1e-4, "{film} went to {}", back.film);
        prop_assert!(back.ray.origin == ray.origin, "from the same point of the lens");
        prop_assert!((back.distance / t - 1.0).abs() < 1e-4, "{} m, and not {t} m", back.distance);
        prop_assert!(camera.arrival(ray.at(-t), on_lens).is_none(), "nothing arrives from behind");
    }

    #[test]
    fn the_rim_of_the_lens_shows_a_point_as_the_circle_of_confusion(
        a in -1.0_f32..1.0, b in -1.0_f32..1.0, depth in 0.3_f32..30.0, focus in 0.3_f32..30.0,
        angle in 0.0_f32..7.0,
    ) {
        let camera = at(2.0, focus);
        let view = &camera.view;
        let p = view.focal_point + depth * (*view.forward + 0.3 * a * *view.right + 0.2 * b * *view.up);
        let rim = Vec2::from_angle(angle);
        let [one, other] = [rim, -rim].map(|on_lens| camera.arrival(p, on_lens).expect("ahead"));
        let c = ((one.film - other.film) * PLANE).length();
        let expected = camera.lens.circle_of_confusion(depth);
        prop_assert!((c - expected).abs() < 1e-3 * expected + 2e-8, "{c} m, and should be {expected} m");
    }
}
