//! What goes wrong within a formula is named: brackets, powers, one component, a value that does not belong there, one of several things.

use super::function::diagnosed;
use super::phong::{Phong, phong};
use glam::DVec3;
use raybook_grader::cases;

#[test]
fn brackets_that_are_too_many_are_named() {
    let found = diagnosed("camera_ray", |q| {
        let v = |at: usize| glam::DVec3::from_slice(&q[at..]);
        let (length, plane, film) = (q[12], &q[13..15], &q[15..17]);
        let across = (film[0] - 0.5) * plane[0] * v(6);
        let along = length * (v(3) + across) + (0.5 - film[1]) * plane[1] * v(9);
        Some([v(0).to_array(), along.normalize().to_array()].concat())
    });
    let told = "adds “x·right” before multiplying by “focal_length”, as with brackets";
    assert!(found.name.ends_with(told), "{}", found.name);
    assert!(found.certain);
}

#[test]
fn brackets_that_are_forgotten_are_named() {
    let found = diagnosed("plane_hit", |q| {
        let v = |at: usize| glam::DVec3::from_slice(&q[at..]);
        let (o, d, n, offset) = (v(0), v(3), v(8), q[11]);
        let t = offset - n.dot(o) / n.dot(d);
        let counts = n.dot(d) != 0.0 && q[6] < t && t < q[7];
        Some(if counts { vec![1.0, t] } else { vec![0.0] })
    });
    assert!(
        found.name.ends_with("as without brackets"),
        "{}",
        found.name
    );
}

#[test]
fn a_power_that_is_no_power_is_named() {
    let found = diagnosed("expose", |q| {
        Some(q[..3].iter().map(|v| v * 2.0 * q[3]).collect())
    });
    let told = "multiplies by twice the number of stops";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_factor_that_belongs_inside_of_a_power_is_named() {
    // Which axes are cut follows from the same wrong number of cells.
    let found = diagnosed("grid_resolution", |q| {
        let (extents, shapes, density) = (&q[..3], q[3], q[4]);
        let mut thick: Vec<_> = (0..3).filter(|&axis| extents[axis] > 0.0).collect();
        let mut cells = [1.0; 3];
        while !thick.is_empty() {
            let volume: f64 = thick.iter().map(|&axis| extents[axis]).product();
            let per_metre = density * (shapes / volume).powf(1.0 / thick.len() as f64);
            let before = thick.len();
            thick.retain(|&axis| extents[axis] * per_metre >= 1.0);
            if thick.len() == before {
                for &axis in &thick {
                    cells[axis] = (extents[axis] * per_metre).round();
                }
                break;
            }
        }
        Some(cells.to_vec())
    });
    let told = "writes “density” outside of the power “the root of cells/volume”";
    assert_eq!(found.name, told);
}

#[test]
fn twice_a_value_for_its_square_is_named() {
    let found = diagnosed("solve_quadratic", |q| {
        let [a, b, c] = [q[0], q[1], q[2]];
        let square = 2.0 * b - 4.0 * a * c;
        if a == 0.0 || square < 0.0 {
            return Some(vec![0.0]);
        }
        let root = -0.5 * (b + square.sqrt().copysign(b));
        if root == 0.0 {
            return Some(vec![1.0, 0.0, 0.0]);
        }
        let (s, t) = (root / a, c / root);
        Some(vec![1.0, s.min(t), s.max(t)])
    });
    let told = "goes wrong at the step “B²”: takes twice “B” instead of its square";
    assert_eq!(found.name, told);
}

/// A reflected direction, of the products that i·n adds up and of the twofold part along n.
fn reflected(q: &[f64], products: DVec3, taken: impl Fn(DVec3) -> DVec3) -> Vec<f64> {
    let [i, n] = [0, 3].map(|from| DVec3::from_slice(&q[from..]));
    let cosine = (i * n * products).element_sum();
    let reflected = i - taken(2.0 * cosine * n);
    reflected.normalize().to_array().to_vec()
}

#[test]
fn a_dot_product_of_two_components_is_named() {
    let found = diagnosed("reflect", |q| {
        Some(reflected(q, DVec3::new(1.0, 1.0, 0.0), |part| part))
    });
    let told = "goes wrong at the step “the products that i·n adds up”: takes 0 for z";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn one_slip_that_explains_nearly_all_is_told_before_two() {
    let found = diagnosed("reflect", |q| {
        Some(reflected(q, DVec3::ONE, |part| part.with_x(0.0)))
    });
    let told = "takes 0 for x";
    assert!(found.name.ends_with(told), "{found:?}");
}

#[test]
fn a_power_that_does_not_belong_there_is_named() {
    let found = diagnosed("phong", |q| {
        let matte = |height: f64| height.powf(q[18]);
        let slip = |at: Phong| at.k_d * matte(at.height) + at.k_s * at.shine;
        Some(phong(q, slip))
    });
    let told = "goes wrong at the step “L·N in the diffuse part”: raises to the power of “α” too";
    assert_eq!(found.name, told);
}

#[test]
fn a_factor_that_does_not_belong_there_is_named() {
    let found = diagnosed("phong", |q| {
        let slip = |at: Phong| at.k_d * at.height + at.k_s * at.shine * at.i;
        Some(phong(q, slip))
    });
    let told = "goes wrong at the step “specular: k_s times that”: multiplies by “i” too";
    assert_eq!(found.name, told);
}

#[test]
fn a_sine_that_is_taken_for_its_angle_is_named() {
    let found = diagnosed("refract", |q| {
        let [i, n] = [0, 3].map(|from| DVec3::from_slice(&q[from..]));
        let leaves = i.dot(n) > 0.0;
        let (n, eta) = if leaves {
            (-n, q[7] / q[6])
        } else {
            (n, q[6] / q[7])
        };
        let along = eta * (i - i.dot(n) * n);
        let sine = along.length();
        let refracted = along - sine.cos() * n;
        Some(if sine > 1.0 {
            vec![0.0]
        } else {
            [&[1.0], &refracted.to_array()[..]].concat()
        })
    });
    let told = "as if the sine were the angle";
    assert!(found.name.ends_with(told), "{found:?}");
}

#[test]
fn who_lets_the_last_of_several_decide_is_told_so_before_two_mistakes() {
    let call = cases::find("lit").expect("it exists").asked().call;
    let found = diagnosed("lit", |q| {
        let last = &q[q.len() - 4..];
        Some(call(&[&q[..11], &[1.0], last].concat()))
    });
    let told = "keeps the answer for the last sphere only";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn who_wants_all_where_one_is_enough_is_told_so() {
    let call = cases::find("lit").expect("it exists").asked().call;
    let found = diagnosed("lit", |q| {
        let mut spheres = q[12..].chunks(4);
        let hides = |sphere: &[f64]| call(&[&q[..11], &[1.0], sphere].concat()) == [0.0];
        Some(vec![f64::from(u8::from(!spheres.all(hides)))])
    });
    let told = "wants all, where one is enough, when it decides whether a sphere is in the way";
    assert_eq!(found.name, told, "{found:?}");
}
