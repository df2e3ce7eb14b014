//! What everybody may choose, how far off the surface a ray starts, hides no mistake in the rest.

use super::function::diagnosed;
use glam::DVec3;

#[test]
fn a_wrong_end_is_named_whatever_the_start() {
    let found = diagnosed("shadow_ray", |q| {
        let [p, n, toward] = [0, 4, 7].map(|from| DVec3::from_slice(&q[from..]));
        let (error, distance) = (q[3], q[10]);
        let origin = p + 2.0 * error * n.dot(toward).signum() * n;
        let within = [0.0, distance * distance];
        Some([&origin.to_array()[..], &toward.to_array(), &within].concat())
    });
    let told = "ends the interval at the square of the light's distance";
    assert_eq!((&*found.name, found.certain), (told, true), "{found:?}");
}

#[test]
fn an_end_that_is_always_the_same_is_no_sign() {
    let found = diagnosed("shadow_ray", |q| {
        let [p, n, toward] = [0, 4, 7].map(|from| DVec3::from_slice(&q[from..]));
        let origin = p + 2.0 * q[3] * n.dot(toward).signum() * n;
        Some([&origin.to_array()[..], &toward.to_array(), &[0.0, 1.0]].concat())
    });
    let told = "ends the interval at 1, wherever the light is";
    assert_eq!(found.name, told);
}

#[test]
fn a_few_places_along_y_are_as_wrong_as_along_x() {
    let found = diagnosed("random_pattern", |q| {
        let call = raybook_grader::cases::find("random_pattern")?.asked().call;
        let mut points = call(q);
        for y in points[1..].iter_mut().skip(1).step_by(2) {
            *y = (100.0 * *y).floor() / 100.0;
        }
        Some(points)
    });
    assert_eq!(found.name, "chooses from a few places only", "{found:?}");
}
