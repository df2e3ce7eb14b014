//! A comparison of other numbers than the right ones is named by what it decides.

use super::function::diagnosed;
use glam::{DVec2, DVec3};

#[test]
fn a_comparison_with_another_number_is_named() {
    let found = diagnosed("pixel_average", |q| {
        let (mut sum, mut weights) = (DVec3::ZERO, 0.0);
        for seen in q[2..].chunks(5) {
            let factors = 1.0 - DVec2::from_slice(seen).abs() / q[0];
            let is_far = factors.min_element() < 0.5;
            let weight = if is_far {
                0.0
            } else {
                factors.element_product()
            };
            sum += weight * DVec3::from_slice(&seen[2..]);
            weights += weight;
        }
        let average = if weights > 0.0 {
            sum / weights
        } else {
            DVec3::ZERO
        };
        Some(average.to_array().to_vec())
    });
    let told = "compares with ½ more when it decides whether a factor is negative";
    assert_eq!(found.name, told, "{found:?}");
}

#[test]
fn a_loop_that_ends_after_the_second_is_named() {
    let found = diagnosed("pixel_average", |q| {
        let call = raybook_grader::cases::find("pixel_average")?.asked().call;
        let two = q[2..].chunks(5).take(2).flatten().copied();
        let count = q[1].min(2.0);
        Some(call(
            &[q[0], count].into_iter().chain(two).collect::<Vec<_>>(),
        ))
    });
    let told = "ends after the second of the samples";
    assert_eq!(found.name, told, "{found:?}");
}
