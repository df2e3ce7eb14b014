//! A mistake that shows only where a question is special is told with what is special there.

use super::function::diagnosed;
use glam::DVec3;
use raybook_grader::cases;

/// Two axes made with a direction that is always the same: they are 0 where `z` is parallel to it.
fn axes(z: DVec3, fixed: DVec3) -> [DVec3; 2] {
    let x = z.cross(fixed).normalize_or_zero();
    [x, z.cross(x)]
}

#[test]
fn axes_from_a_fixed_direction_are_told_where_they_are_none() {
    for (fixed, axis) in [(DVec3::Y, "y"), (DVec3::Z, "z")] {
        let found = diagnosed("cosine_hemisphere", |q| {
            let (normal, n) = (DVec3::from_slice(q), q[3]);
            let [x, y] = axes(normal, fixed);
            let mut answer = vec![n];
            for i in 0..n as u32 {
                let u = (f64::from(i) + 0.5) / n;
                let phi = 0.618_034 * (f64::from(i) + 0.5) * std::f64::consts::TAU;
                let on_disc = u.sqrt() * (phi.cos() * x + phi.sin() * y);
                answer.extend((on_disc + (1.0 - u).sqrt() * normal).to_array());
            }
            Some(answer)
        });
        let told = format!("but only where `normal` is parallel to the {axis} axis");
        assert!(found.name.ends_with(&told), "{}", found.name);
    }
}

#[test]
fn a_way_between_two_points_can_be_special() {
    let call = cases::find("sample_sphere_light")
        .expect("it exists")
        .asked()
        .call;
    let found = diagnosed("sample_sphere_light", |q| {
        let mut answer = call(q);
        let [at, center] = [&q[..3], &q[3..6]].map(DVec3::from_slice);
        let way = center - at;
        if way != DVec3::ZERO && way.cross(DVec3::Y) == DVec3::ZERO {
            answer[1..4].fill(0.0);
        }
        Some(answer)
    });
    let told = "the way from `at` to `center` is parallel to the y axis";
    assert!(found.name.ends_with(told), "{}", found.name);
}

#[test]
fn what_no_mistake_explains_is_told_by_where_it_happens() {
    let call = cases::find("solve_quadratic")
        .expect("it exists")
        .asked()
        .call;
    let found = diagnosed("solve_quadratic", |q| {
        Some(if q[1] == 0.0 {
            vec![1.0, 0.3, 0.7]
        } else {
            call(q)
        })
    });
    assert_eq!(
        (&*found.name, found.certain),
        ("is wrong where `b` is 0, and only there", false)
    );
}
