//! What is only guessed: a guess says so, says what is likeliest first, and is not made where chance would do as well.

use super::function::{diagnosed, found, right};
use glam::DVec3;
use raybook_grader::cases;
use raybook_grader::diagnose::{Beside, Diagnosis};
use std::cell::Cell;

fn names(found: &Diagnosis) -> Vec<&str> {
    let also = found.also.iter().map(|also| also.name.as_str());
    [found.name.as_str()].into_iter().chain(also).collect()
}

/// A number that follows no rule a person would make.
fn strange(question: &[f64]) -> f64 {
    let sum = question.iter().filter(|v| v.is_finite()).sum::<f64>();
    0.4 + 0.1 * (9.0 * sum).sin()
}

#[test]
fn a_branch_that_nearly_all_questions_take_is_not_told() {
    let found = found("environment_pdf", |q| {
        let right = right("environment_pdf", q);
        Some(if right == [0.0] {
            right
        } else {
            vec![strange(q)]
        })
    });
    let is_told = |found: &Diagnosis| found.name.contains("the map is black");
    assert!(
        !found.as_ref().is_some_and(is_told),
        "most are wrong: {found:?}"
    );
}

#[test]
fn a_yes_for_a_no_is_told_by_its_decision() {
    let found = diagnosed("lit", |q| {
        let right = right("lit", q);
        Some(if right == [0.0] { vec![1.0] } else { right })
    });
    assert!(
        !found.name.starts_with("returns 1 "),
        "of two answers a wrong one is always the other: {found:?}"
    );
}

#[test]
fn one_value_of_a_number_is_no_function() {
    // 4 is the square of 2, and all else is right.
    let found = diagnosed("octree_child", |q| {
        let right = right("octree_child", q);
        Some(if right == [2.0] { vec![4.0] } else { right })
    });
    assert!(!found.name.contains("square"), "{found:?}");
}

#[test]
fn numbers_that_are_nearly_right_are_in_no_other_order() {
    let found = diagnosed("geodesic_step", |q| {
        let (x, v, step) = (DVec3::from_slice(q), DVec3::from_slice(&q[3..]), q[6]);
        let h2 = x.cross(v.normalize()).length_squared();
        let pull = |x: DVec3| -1.5 * h2 / x.length().powi(5) * x;
        let half = v + 0.5 * step * pull(x);
        let after = x + step * half;
        let v = half + 0.5 * step * pull(after);
        Some([after.to_array(), v.to_array()].concat())
    });
    let told = names(&found).join(", ");
    assert!(!told.contains("in another order"), "{told}");
    let normalised = "goes wrong at the step “v, in x × v”: normalises the value";
    assert!(told.contains(normalised), "{told}");
}

#[test]
fn a_mistake_that_halves_an_estimate_is_not_told_from_any_other_half() {
    let found = diagnosed("reflected_radiance", |q| {
        let half = right("reflected_radiance", q).into_iter().map(|v| 0.5 * v);
        Some(half.collect())
    });
    assert!(!found.certain, "{found:?}");
    let halves = |one: &Diagnosis| {
        one.beside == Beside::Instead && one.name.starts_with("returns 0.5 (a half) times")
    };
    assert!(found.also.iter().any(halves), "{found:?}");
}

#[test]
fn the_case_that_is_told_is_one_that_the_mistake_explains() {
    let examiner = cases::find("sphere_hit").expect("the exercise exists");
    let mut mistakes = examiner.mistakes().into_iter();
    let mistake = mistakes.position(|(name, _)| name == "forgets to divide by 2");
    let mistake = mistake.expect("it is on the list");
    // Something else comes out in the first case that is wrong.
    let (number, wrong) = (Cell::new(0), Cell::new(None));
    let found = diagnosed("sphere_hit", |q| {
        let place = number.replace(number.get() + 1);
        let answer = examiner.mistake_answers(mistake, q)?;
        if answer == right("sphere_hit", q) || wrong.get().is_some() {
            return Some(answer);
        }
        wrong.set(Some(place));
        Some(vec![1.0, strange(q)])
    });
    assert_eq!(found.name, "forgets to divide by 2");
    assert!(found.explained < found.wrong, "{found:?}");
    assert!(found.shown > wrong.get(), "{found:?}");
}

#[test]
fn a_hit_behind_the_point_is_told_before_what_can_be_seen() {
    let found = diagnosed("sample_sphere_light", |q| {
        let mut answer = right("sample_sphere_light", q);
        let [at, center] = [&q[..3], &q[3..6]].map(DVec3::from_slice);
        let (way, radius) = (center - at, q[6]);
        if way.length() <= radius {
            for sample in answer[1..].chunks_mut(6) {
                let foot = way.dot(DVec3::from_slice(sample));
                let square = radius * radius - way.length_squared() + foot * foot;
                sample[3] = foot - square.max(0.0).sqrt();
            }
        }
        Some(answer)
    });
    let told = "returns the distance of the nearer hit from inside too, which is behind the point";
    assert_eq!(names(&found), [told]);
}

#[test]
fn a_mistake_that_misses_the_light_is_told_before_what_can_be_seen() {
    let found = diagnosed("sample_sphere_light", |q| {
        let [at, center] = [&q[..3], &q[3..6]].map(DVec3::from_slice);
        let (way, radius, n) = (center - at, q[6], q[8]);
        let far = way.length();
        if far <= radius {
            return Some(right("sample_sphere_light", q));
        }
        // The root of 1 − r/d, without the squares.
        let height = 1.0 - (1.0 - radius / far).sqrt();
        let pdf = 1.0 / (std::f64::consts::TAU * height);
        let z = way / far;
        let x = z.any_orthonormal_vector();
        let mut answer = vec![n * n];
        for k in 0..(n * n) as u32 {
            let (u, v) = (f64::from(k) % n, (f64::from(k) / n).floor());
            let (u, v) = ((u + 0.5) / n, (v + 0.5) / n);
            let cos = 1.0 - u * height;
            let around = (std::f64::consts::TAU * v).cos() * x
                + (std::f64::consts::TAU * v).sin() * z.cross(x);
            let toward = (1.0 - cos * cos).sqrt() * around + cos * z;
            let foot = far * cos;
            let half = (radius * radius - far * far + foot * foot).max(0.0).sqrt();
            answer.extend(toward.to_array());
            answer.extend([foot - half, pdf, q[7] / pdf]);
        }
        Some(answer)
    });
    let told = "forgets to square the radius over the distance for the cosine of the cone";
    assert_eq!((&*found.name, found.certain), (told, true), "{found:?}");
}

#[test]
fn a_decision_that_is_turned_round_is_told_of_samples_too() {
    let found = diagnosed("sample_rect", |q| {
        let [at, corner, a, b] = [0, 3, 6, 9].map(|from| DVec3::from_slice(&q[from..]));
        let (radiance, n) = (q[12], q[13]);
        let area = a.cross(b);
        let mut answer = vec![1.0, n * n];
        for k in 0..(n * n) as u32 {
            let (u, v) = (f64::from(k) % n, (f64::from(k) / n).floor());
            let way = corner + (u + 0.5) / n * a + (v + 0.5) / n * b - at;
            let solid = -way.dot(area) / way.length().powi(3);
            if solid > 0.0 {
                return Some(vec![0.0]);
            }
            answer.extend(way.normalize().to_array());
            answer.extend([way.length(), 1.0 / solid, radiance * solid]);
        }
        Some(answer)
    });
    let told = "decides the other way round whether the light turns its back to the point";
    assert_eq!(found.name, told);
}

#[test]
fn a_square_for_a_sine_is_named() {
    let found = diagnosed("refract", |q| {
        let (i, normal) = (DVec3::from_slice(q), DVec3::from_slice(&q[3..]));
        let (mut n, mut ratio) = (normal, q[6] / q[7]);
        if i.dot(normal) > 0.0 {
            (n, ratio) = (-normal, q[7] / q[6]);
        }
        let along = i - i.dot(n) * n;
        let sine = along.length_squared() * ratio;
        if sine > 1.0 {
            return Some(vec![0.0]);
        }
        let v = sine * along.normalize_or_zero() - (1.0 - sine * sine).sqrt() * n;
        Some([&[1.0], &v.to_array()[..]].concat())
    });
    let told = "goes wrong at the step “sin θ₁, its length”: takes the square of the value";
    assert!(found.name.starts_with(told), "{found:?}");
}

#[test]
fn the_texel_beside_the_right_one_is_named() {
    let found = diagnosed("environment_pdf", |q| {
        let (width, height) = (q[3] as usize, q[4] as usize);
        let golden = right("environment_pdf", q);
        let texels = &q[6..];
        let sum = |y: usize| {
            let edge = |y: usize| (std::f64::consts::PI * y as f64 / height as f64).cos();
            let zone = std::f64::consts::TAU * (edge(y) - edge(y + 1)) / width as f64;
            texels[y * width..][..width].iter().sum::<f64>() * zone
        };
        let all: f64 = (0..height).map(sum).sum();
        if all == 0.0 {
            return Some(golden);
        }
        let place = right("direction_to_latlong", &q[..3]);
        let x = ((place[0] * width as f64) as usize).min(width - 1);
        let y = ((place[1] * height as f64) as usize).min(height - 1);
        Some(vec![texels[y.saturating_sub(1) * width + x] / all])
    });
    assert_eq!(found.name, "is one row too high");
}

#[test]
fn a_cosine_that_is_not_divided_is_named() {
    let found = diagnosed("direction_to_latlong", |q| {
        let phi = (-q[2]).clamp(-1.0, 1.0).acos().copysign(q[0]);
        let theta = q[0].hypot(q[2]).atan2(q[1]);
        let turn = 0.5 + phi / std::f64::consts::TAU;
        Some(vec![turn, theta / std::f64::consts::PI])
    });
    let told = "takes the arc cosine of −z itself for the angle around";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_value_that_comes_later_can_stand_for_one_before() {
    let found = diagnosed("fresnel", |q| {
        let [cos1, n1, n2] = [q[0], q[1], q[2]];
        let cos2 = (1.0 - (n1 / n2).powi(2) * (1.0 - cos1 * cos1))
            .max(0.0)
            .sqrt();
        if n1 == n2 || cos2 == 0.0 {
            return Some(right("fresnel", q));
        }
        let rs = ((n1 * cos1 - n2 * cos1) / (n1 * cos1 + n2 * cos2)).powi(2);
        let rp = ((n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1)).powi(2);
        Some(vec![rs, rp, 0.5 * (rs + rp)])
    });
    let told = "takes the value of “n₂ cos θ₁ above the line” where that of “n₂ cos θ₂ above the line” belongs";
    assert_eq!(found.name, told);
}

#[test]
fn a_value_of_the_round_before_is_named() {
    let found = diagnosed("vertex_normals", |q| {
        let count = q[0] as usize;
        let positions: Vec<_> = q[1..]
            .chunks(3)
            .take(count)
            .map(DVec3::from_slice)
            .collect();
        let mut sums = vec![DVec3::ZERO; count];
        let mut before = None;
        for triangle in q[2 + 3 * count..].chunks(3) {
            let corners = [0, 1, 2].map(|k| triangle[k] as usize);
            let [p0, p1, p2] = corners.map(|k| positions[k]);
            let area = (p1 - p0).cross(p2 - p0);
            for k in corners {
                sums[k] += before.unwrap_or(area);
            }
            before = Some(area);
        }
        let normals = sums
            .iter()
            .map(|sum| sum.try_normalize().unwrap_or(DVec3::Y));
        let normals = normals.flat_map(|normal| normal.to_array());
        Some([q[0]].into_iter().chain(normals).collect())
    });
    let told = "takes for “what a triangle gives to its vertices” the value of the round before";
    assert!(names(&found).contains(&told), "{found:?}");
}

#[test]
fn a_mean_for_a_sum_is_told() {
    let found = diagnosed("sah_cost", |q| {
        let nodes = q[2];
        let cost = right("sah_cost", q);
        Some(cost.iter().map(|v| v / nodes).collect())
    });
    let told = "divides by the length of the list, as for a mean";
    assert_eq!(names(&found), [told]);
}

#[test]
fn a_mistake_in_one_channel_only_is_told() {
    let found = diagnosed("tone_map", |q| {
        let mut mapped = right("tone_map", q);
        mapped[1] = q[1] / (1.0 + q[1]);
        Some(mapped)
    });
    let told = "maps each channel by itself, in g only";
    assert!(names(&found).contains(&told), "{found:?}");
}

#[test]
fn an_answer_that_is_rounded_in_one_branch_is_told() {
    let found = diagnosed("encode_srgb", |q| {
        let v = q[0];
        let curve = 1.055 * v.max(0.0).powf(1.0 / 2.4) - 0.055;
        let rounded = (curve * 1e3).round() / 1e3;
        let code = if v <= 0.0 {
            0.0
        } else if v >= 1.0 {
            1.0
        } else if v <= 0.003_130_8 {
            12.92 * v
        } else {
            rounded
        };
        Some(vec![code])
    });
    let told = "rounds the answer to 3 digits behind the decimal point";
    assert_eq!(found.name, told);
}

#[test]
fn a_rare_slip_that_explains_a_part_only_is_not_told() {
    // Of four answers three are those of a function that weighs red like green.
    let found = found("tone_map", |q| {
        let weight = if (9e3 * strange(q)).rem_euclid(4.0) < 3.0 {
            0.7152
        } else {
            1.0 + strange(q)
        };
        let light = weight * q[0] + 0.7152 * q[1] + 0.0722 * q[2];
        Some(q.iter().map(|v| v / (1.0 + light)).collect())
    });
    let names = found.as_ref().map(names).unwrap_or_default();
    assert!(
        !names.iter().any(|name| name.contains("takes y for x")),
        "{names:?}"
    );
}
