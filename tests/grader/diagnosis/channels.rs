//! What is wrong in one channel or along one axis only is named by it; and a colour's numbers are red, green and blue.

use super::function::diagnosed;
use super::phong::{Phong, phong};
use glam::{DVec3, Vec3Swizzles as _};

#[test]
fn another_coefficient_in_one_channel_is_named() {
    let found = diagnosed("phong", |q| {
        let slip = |at: Phong| at.k_d * at.height + at.k_s.with_z(at.k_d.z) * at.shine;
        Some(phong(q, slip))
    });
    let told = "takes the value of “k_d” where that of “k_s” belongs, in blue only";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn the_numbers_of_a_colour_are_its_channels() {
    let found = diagnosed("phong", |q| {
        let slip = |at: Phong| (at.k_d * at.height + at.k_s * at.shine).zyx();
        Some(phong(q, slip))
    });
    let told = "goes wrong at the step “diffuse + specular”: exchanges red and blue";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_length_of_one_component_only_is_named() {
    let found = diagnosed("geodesic_step", |q| {
        let (x, v, step) = (DVec3::from_slice(q), DVec3::from_slice(&q[3..]), q[6]);
        let square = x.cross(v).y.powi(2);
        let pull = |x: DVec3| -1.5 * square / x.length().powi(5) * x;
        let half = v + 0.5 * step * pull(x);
        let after = x + step * half;
        let turned = half + 0.5 * step * pull(after);
        Some([after.to_array(), turned.to_array()].concat())
    });
    let told = "takes 0 for all but y";
    assert!(found.name.ends_with(told), "{found:?}");
}

#[test]
fn a_length_that_is_a_sum_is_named() {
    let found = diagnosed("point_light", |q| {
        let way = DVec3::from_slice(q) - DVec3::from_slice(&q[6..]);
        let (distance, light) = (way.abs().element_sum(), DVec3::from_slice(&q[3..]));
        if distance == 0.0 {
            return Some(vec![0.0]);
        }
        let arriving = light / way.length_squared();
        Some(
            [
                &[1.0],
                &(way / distance).to_array()[..],
                &[distance],
                &arriving.to_array(),
            ]
            .concat(),
        )
    });
    let told = "takes the sum of the absolute values for its length";
    assert!(found.name.ends_with(told), "{found:?}");
}
