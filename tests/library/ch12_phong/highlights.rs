//! Highlights: Phong's and Blinn's compared, and directions at the ends of the scale.

use crate::ch12_phong::{PHONG, close, from, ground, rays::random_direction, toward};
use glam::vec3;
use proptest::prelude::{ProptestConfig, any, prop_assert, proptest};
use raybook::image::rgb::Rgb;
use raybook::material::{Material, blinn_phong::BlinnPhong, phong::Phong};
use raybook::math::{dir3::Dir3, pcg};

#[test]
fn opposite_light_and_view_have_no_half_vector_and_no_highlight() {
    let blinn = BlinnPhong(PHONG);
    // With an interpolated normal, the viewer may be below its horizon and the light above it.
    let got = blinn.reflect(
        Dir3::Y,
        toward(vec3(0.6, -0.8, 0.0)),
        &from(vec3(-0.6, 0.8, 0.0)),
    );
    close(got, PHONG.diffuse * 0.8, "the diffuse part stays");
}

#[test]
fn blinn_with_four_times_the_exponent_is_phong_in_the_plane_of_light_and_normal() {
    let mut compared = 0;
    for exponent in [8.0, 64.0, 512.0] {
        let only = |exponent| Phong {
            diffuse: Rgb::BLACK,
            specular: Rgb::WHITE,
            exponent,
            ..PHONG
        };
        for degrees in 0..60 {
            let light = from(vec3(
                -(degrees as f32).to_radians().sin(),
                (degrees as f32).to_radians().cos(),
                0.0,
            ));
            for off in -20..=20 {
                let angle = (degrees as f32 + 0.5 * off as f32).to_radians();
                let view = toward(vec3(angle.sin(), angle.cos(), 0.0));
                let phong = only(exponent).reflect(Dir3::Y, view, &light).r;
                let blinn = BlinnPhong(only(4.0 * exponent))
                    .reflect(Dir3::Y, view, &light)
                    .r;
                // cos 2δ^α and cos δ^4α differ from the fourth order on: 3.2 % of the middle at most for α = 8.
                assert!(
                    (phong - blinn).abs() < 0.28 / exponent,
                    "α = {exponent}, {degrees}°, {off}: {phong} {blinn}"
                );
                compared += u32::from(phong > 0.1);
            }
        }
    }
    assert!(compared > 1000, "{compared} were in the highlight");
}

#[test]
fn highlights_do_not_change_when_light_and_viewer_change_places() {
    let mut rng = pcg::stream(12, 1);
    for _ in 0..10_000 {
        let [normal, view, light] = [(); 3].map(|()| random_direction(&mut rng));
        if normal.dot(*view) <= 0.0 || normal.dot(*light) <= 0.0 {
            continue;
        }
        let only = Phong {
            diffuse: Rgb::BLACK,
            ..PHONG
        };
        let there = only.reflect(normal, view, &from(*light));
        close(
            only.reflect(normal, light, &from(*view)),
            there,
            "Phong: R·V is symmetrical",
        );
        let [there, back] = [(view, light), (light, view)]
            .map(|(v, l)| BlinnPhong(only).reflect(normal, v, &from(*l)));
        close(back, there, "Blinn: N·H is symmetrical");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_directions_give_negative_or_endless_light(
        numbers in proptest::array::uniform9(-2_i8..=2),
        negative_zero in any::<bool>(),
        exponent in 0.0_f32..1e4,
    ) {
        let zero = if negative_zero { -0.0 } else { 0.0 };
        let at = |i: usize| if numbers[i] == 0 { zero } else { f32::from(numbers[i]) };
        let direction = |i: usize| Dir3::new_or(vec3(at(i), at(i + 1), at(i + 2)), Dir3::Y);
        let phong = Phong { exponent, ..PHONG };
        for model in [&phong as &dyn Material, &BlinnPhong(phong)] {
            let got = model.lit(&ground(direction(0)), direction(3), &from(*direction(6)));
            prop_assert!(got.channels().iter().all(|v| (0.0..=1.0).contains(v)), "{:?}", got);
        }
    }
}
