//! What everybody may choose, how far off the surface a ray starts, hides no mistake in the rest.

use super::operations::diagnosed;
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
