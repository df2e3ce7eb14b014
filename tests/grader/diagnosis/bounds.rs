//! Numbers of a question that are read in another convention, or kept within bounds that nobody asked for.

use super::function::{camera, diagnosed};
use raybook_grader::cases;

/// The direction through a place of the film from −1 to 1, with y upwards.
#[test]
fn a_film_in_device_coordinates_is_named() {
    let found = diagnosed("camera_ray", |q| {
        let ([from, forward, right, up], [f, wide, high, x, y]) = camera(q);
        let v = f * forward + 0.5 * x * wide * right + 0.5 * y * high * up;
        Some([from.to_array(), v.normalize().to_array()].concat())
    });
    let told = "takes film as from −1 to 1 in both directions, and y upwards";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_number_that_is_kept_within_bounds_is_named() {
    let right = cases::find("panorama_ray").expect("an exercise").asked();
    let found = diagnosed("panorama_ray", |q| {
        let mut kept = q.to_vec();
        let y = kept.last_mut().expect("film.y");
        *y = y.clamp(0.02, 0.98);
        Some((right.call)(&kept))
    });
    let told = "keeps film.y between 0.02 and 0.98";
    assert_eq!(found.name, told);
}
