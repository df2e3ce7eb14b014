//! Slips in one operation are named by what goes into a step; and where no mistake gives the same answers, or there are none, the
//! branch of the calculation is told.

use super::function::{camera, diagnosed};
use raybook_grader::cases;

/// Fresnel's equations; `term` is n₂ cos θ₁ in the numerator of Rp.
fn fresnel(q: &[f64], term: impl Fn(f64, f64) -> f64) -> Option<[f64; 3]> {
    let [cos1, n1, n2] = [q[0], q[1], q[2]];
    if n1 == n2 {
        return Some([0.0; 3]);
    }
    let squared = 1.0 - (n1 / n2).powi(2) * (1.0 - cos1 * cos1);
    let cos2 = (squared > 0.0).then(|| squared.sqrt())?;
    let rs = ((n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2)).powi(2);
    let rp = ((n1 * cos2 - term(n2, cos1)) / (n1 * cos2 + n2 * cos1)).powi(2);
    Some([rs, rp, 0.5 * (rs + rp)])
}

#[test]
fn a_factor_that_divides_is_named() {
    let found = diagnosed("fresnel", |q| {
        let answer = fresnel(q, |n2, cos1| n2 / cos1).unwrap_or([1.0; 3]);
        Some(answer.to_vec())
    });
    let told = "goes wrong at the step “n₂ cos θ₁ above the line”: divides by “cos θ₁” instead of multiplying by it";
    assert_eq!(found.name, told);
}

#[test]
fn a_divisor_that_multiplies_is_named() {
    let found = diagnosed("circle_of_confusion", |q| {
        let [f, stop, s, x] = [q[0], q[1], q[2], q[3]];
        let film = 1.0 / (1.0 / f - 1.0 / s);
        Some(vec![f / stop * (1.0 - film * (f - 1.0 / x)).abs()])
    });
    let told = "goes wrong at the step “1/f at the tip”: multiplies by “focal_length” instead of dividing by it";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_summand_with_the_wrong_sign_is_named() {
    let found = diagnosed("triangle_normal", |q| {
        let p = |corner: usize| glam::DVec3::from_slice(&q[3 * corner..]);
        let across = (p(1) - p(0)).cross(p(2) + p(0));
        let length = across.length();
        let has_area = (p(1) - p(0)).cross(p(2) - p(0)).length() > 0.0;
        Some(if has_area {
            [&[1.0], &(across / length).to_array()[..]].concat()
        } else {
            vec![0.0]
        })
    });
    let told = "goes wrong at the step “e₂ = p₂ − p₀”: adds “p₀” instead of subtracting it";
    // (p₂ + p₁) × (p₀ − p₁) is the same, from the edges at the second corner.
    let other = "goes wrong at the step “p₂ − p₁”: adds “p₁” instead of subtracting it";
    assert_eq!((&*found.name, &*found.also[0].name), (told, other));
    assert!(!found.certain);
}

#[test]
fn a_step_that_is_kept_from_falling_too_low_is_named() {
    let found = diagnosed("point_light", |q| {
        let [position, intensity, at] = [0, 3, 6].map(|i| glam::DVec3::from_slice(&q[i..]));
        let way = position - at;
        let distance = way.length();
        if distance == 0.0 {
            return Some(vec![0.0]);
        }
        let arriving = intensity / distance.max(0.01).powi(2);
        let toward = (way / distance).to_array();
        Some([&[1.0], &toward[..], &[distance], &arriving.to_array()].concat())
    });
    let told =
        "goes wrong at the step “d²”: takes at least 0.0001, against numbers that are too small";
    assert!(found.name.starts_with(told) && !found.certain, "{found:?}");
}

#[test]
fn a_case_without_an_answer_is_told_by_its_branch() {
    let found = diagnosed("fresnel", |q| {
        fresnel(q, |n2, cos1| n2 * cos1).map(Vec::from)
    });
    let told = "comes to no answer when cos²θ₂ is not positive, and only then";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn answers_that_no_mistake_gives_are_told_by_their_branch_and_not_for_certain() {
    let found = diagnosed("fresnel", |q| {
        let strange = || [0.2, 0.3, 0.7].map(|part| part + 0.1 * (9.0 * q[1] + q[0]).sin());
        let answer = fresnel(q, |n2, cos1| n2 * cos1).unwrap_or_else(strange);
        Some(answer.to_vec())
    });
    let told = "is wrong when cos²θ₂ is not positive, and only then";
    assert_eq!((&*found.name, found.certain), (told, false));
}

#[test]
fn the_same_wrong_answer_in_one_branch_is_told_with_it() {
    let phong = |q: &[f64]| -> Option<Vec<f64>> {
        let asked = cases::find("phong")?.asked();
        let answer = (asked.call)(q);
        Some(if answer == [0.0; 3] {
            vec![0.0, 1.0, 0.0]
        } else {
            answer
        })
    };
    let found = diagnosed("phong", phong);
    assert!(
        found.certain && found.name.starts_with("returns 0 1 0 "),
        "{}",
        found.name
    );
}

#[test]
fn an_end_of_the_interval_that_counts_is_named_in_every_exercise() {
    for exercise in ["sphere_hit", "plane_hit", "triangle_hit", "mesh_hit"] {
        let call = cases::find(exercise).expect("it exists").asked().call;
        for (min, max, told) in [
            (
                false,
                true,
                "takes within.max itself to be inside the interval",
            ),
            (
                true,
                false,
                "takes within.min itself to be inside the interval",
            ),
            (
                true,
                true,
                "takes both ends of within to be inside the interval",
            ),
        ] {
            let found = diagnosed(exercise, |q| {
                let mut q = q.to_vec();
                if min {
                    q[6] = f64::from((q[6] as f32).next_down());
                }
                if max {
                    q[7] = f64::from((q[7] as f32).next_up());
                }
                Some(call(&q))
            });
            assert_eq!(found.name, told, "{exercise}");
        }
    }
}

#[test]
fn who_always_says_none_is_told_where_none_is_right() {
    let found = diagnosed("sphere_hit", |_| Some(vec![0.0]));
    let told = "answers every question with none";
    assert_eq!((&*found.name, found.certain), (told, true));
    let ends =
        "none where “the discriminant is negative” is true, or “the larger root counts” is false";
    assert!(found.hint.contains(ends), "{}", found.hint);
}

#[test]
fn who_always_says_zero_is_asked_what_is_returned() {
    let found = diagnosed("phong", |_| Some(vec![0.0; 3]));
    let told = "answers every question with 0 0 0";
    assert_eq!((&*found.name, found.certain), (told, true));
    let hint = "Which of its arguments does your function use? Does it return what it calculates?";
    assert_eq!(found.hint, hint);
}

#[test]
fn an_answer_that_is_nan_is_called_so_where_there_is_none() {
    // Who turns away what is outside of the interval keeps 0/0.
    let found = diagnosed("plane_hit", |q| {
        let [o, d, n] = [0, 3, 8].map(|from| glam::DVec3::from_slice(&q[from..]));
        let t = (q[11] - n.dot(o)) / n.dot(d);
        let is_outside = t <= q[6] || t >= q[7];
        Some(if is_outside { vec![0.0] } else { vec![1.0, t] })
    });
    assert_eq!(found.name, "returns NaN, which is not a number");
}

#[test]
fn a_mistake_explains_nothing_where_it_does_not_show() {
    // Both ends of the interval count; and from far away, the formula has lost its digits.
    let found = diagnosed("sphere_hit", |q| {
        let q: Vec<_> = q.iter().map(|v| *v as f32).collect();
        let [o, d, center] = [0, 3, 8].map(|from| glam::Vec3::from_slice(&q[from..]));
        let m = o - center;
        let (b, c) = (2.0 * m.dot(d), m.length_squared() - q[11] * q[11]);
        let root = (b * b - 4.0 * c).sqrt();
        let roots = [0.5 * (-b - root), 0.5 * (-b + root)];
        let t = roots.into_iter().find(|t| (q[6]..=q[7]).contains(t));
        Some(t.map_or(vec![0.0], |t| vec![1.0, t.into()]))
    });
    let names = [&*found.name, &*found.also[0].name];
    let told = [
        "computes b² − 4ac from far away",
        "takes both ends of within to be inside the interval",
    ];
    assert_eq!((names, found.certain), (told, false));
}

#[test]
fn steps_of_which_any_may_be_wrong_are_not_certain() {
    let found = diagnosed("sphere_hit", |q| {
        let [o, d, center] = [0, 3, 8].map(|from| glam::DVec3::from_slice(&q[from..]));
        let m = o - center;
        let (b, c) = (2.0 * m.dot(d), m.length_squared() - q[11] * q[11]);
        let root = (b * b - c).sqrt();
        let roots = [-b - root, -b + root].map(|t| 0.5 * t);
        let hit = roots.into_iter().find(|t| q[6] < *t && *t < q[7]);
        Some(hit.map_or(vec![0.0], |t| vec![1.0, t]))
    });
    let told = "takes a quarter of the value";
    assert!(found.name.ends_with(told) && !found.certain, "{found:?}");
    assert!(found.also[0].name.ends_with(told), "{found:?}");
}

#[test]
fn another_point_in_one_place_of_a_formula_is_named() {
    let found = diagnosed("triangle_hit", |q| {
        let [o, d, p0, p1, p2] = [0, 3, 8, 11, 14].map(|from| glam::DVec3::from_slice(&q[from..]));
        let (e1, e2) = (p1 - p0, p2 - p1);
        let (s1, s) = (d.cross(e2), o - p0);
        let (s2, determinant) = (s.cross(e1), s1.dot(e1));
        let [b1, b2, t] = [s1.dot(s), s2.dot(d), s2.dot(e2)].map(|v| v / determinant);
        let hits = b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0 && q[6] < t && t < q[7];
        Some(if hits {
            vec![1.0, t, b1, b2]
        } else {
            vec![0.0]
        })
    });
    let told = "takes the value of “p₁” where that of “p₀ in e₂” belongs";
    assert_eq!(found.name, told);
}

#[test]
fn one_slip_that_explains_all_is_told_before_two_mistakes() {
    let found = diagnosed("plane_hit", |q| {
        let [o, d, n] = [0, 3, 8].map(|from| glam::DVec3::from_slice(&q[from..]));
        let t = (n.dot(o) - q[11]) / n.dot(d).abs();
        let hits = q[6] < t && t < q[7];
        Some(if hits { vec![1.0, t] } else { vec![0.0] })
    });
    let told = "divides the origin's height above the plane by the absolute value of n·d";
    assert_eq!(found.name, told);
}

#[test]
fn a_walk_by_increments_is_followed_too() {
    let told = "goes wrong at the step “from plane to plane: cell/|d|”: takes x for all three";
    let found = diagnosed("grid_walk", |q| Some(walked(q)));
    assert_eq!(found.name, told);
}

/// A walk that adds the distance between two planes along x, whichever axis it steps along.
fn walked(q: &[f64]) -> Vec<f64> {
    let [min, size, o, d] = [0, 3, 9, 12].map(|from| glam::DVec3::from_slice(&q[from..]));
    let count = [6, 7, 8].map(|i| q[i]);
    let plane = |axis: usize, i: f64| (min[axis] + i * size[axis] - o[axis]) / d[axis];
    let (mut enter, mut end) = (q[15], q[16]);
    for (axis, count) in count.into_iter().enumerate() {
        let [a, b] = [plane(axis, 0.0), plane(axis, count)];
        (enter, end) = (enter.max(a.min(b)), end.min(a.max(b)));
    }
    if end < enter {
        return vec![0.0];
    }
    let mut cell = ((o + enter * d - min) / size).floor().to_array();
    let (mut next, mut visits) = ([f64::INFINITY; 3], Vec::new());
    for axis in 0..3 {
        cell[axis] = cell[axis].clamp(0.0, count[axis] - 1.0);
        if d[axis] != 0.0 {
            next[axis] = plane(axis, cell[axis] + f64::from(d[axis] > 0.0));
        }
    }
    let apart = (size.x / d.x.abs()).min(f64::INFINITY);
    loop {
        let axis = (0..3)
            .min_by(|&a, &b| next[a].total_cmp(&next[b]))
            .unwrap_or(0);
        let leave = next[axis].min(end);
        visits.extend([cell[0], cell[1], cell[2], leave]);
        cell[axis] += d[axis].signum();
        if leave >= end || !(0.0..count[axis]).contains(&cell[axis]) {
            return [&[visits.len() as f64 / 4.0], &visits[..]].concat();
        }
        next[axis] += apart;
    }
}

#[test]
fn a_slip_that_makes_a_lattice_endless_ends() {
    let found = diagnosed("rotated_grid", |q| {
        let (spacing, offset) = (q[0], glam::DVec2::new(q[1], q[2]));
        let turn = glam::DVec2::from_angle(std::f64::consts::FRAC_PI_4);
        let mut answer = vec![0.0];
        for (i, j) in (-40..=40).flat_map(|i| (-40..=40).map(move |j| (i, j))) {
            let step = glam::DVec2::new(f64::from(i), f64::from(j)) + offset;
            let p = 0.5 + spacing * turn.rotate(step);
            if p.min_element() >= 0.0 && p.max_element() < 1.0 {
                answer[0] += 1.0;
                answer.extend(p.to_array());
            }
        }
        Some(answer)
    });
    assert!(
        found.name.contains("rotat") || found.name.contains("turn"),
        "{found:?}"
    );
}

#[test]
fn a_box_whose_planes_are_sorted_is_followed_too() {
    let found = diagnosed("box_clip", |q| {
        let (mut enter, mut leave) = (q[6], q[7]);
        for axis in 0..3 {
            let [o, d, low, high] = [axis, 3 + axis, 8 + axis, 11 + axis].map(|i| q[i]);
            if d == 0.0 && (o < low || high < o) {
                return Some(vec![0.0]);
            } else if d != 0.0 {
                let [a, b] = [(o - low) / d, (high - o) / d];
                (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
            }
        }
        Some(if enter <= leave {
            vec![1.0, enter, leave]
        } else {
            vec![0.0]
        })
    });
    let told = "“the least plane, seen from the start”: has the sign of the value wrong";
    assert!(found.name.ends_with(told), "{found:?}");
}

#[test]
fn another_vector_in_a_product_is_named() {
    let found = diagnosed("plane_hit", |q| {
        let [o, d, n] = [0, 3, 8].map(|from| glam::DVec3::from_slice(&q[from..]));
        let t = (q[11] - n.dot(o)) / o.dot(d);
        Some(if q[6] < t && t < q[7] {
            vec![1.0, t]
        } else {
            vec![0.0]
        })
    });
    assert_eq!(
        found.name,
        "takes the value of “o” where that of “n in n·d” belongs"
    );
}

#[test]
fn another_length_in_one_place_of_the_film_is_named() {
    let found = diagnosed("camera_ray", |q| {
        let ([start, forward, right, up], [f, wide, high, x, y]) = camera(q);
        let corner = f * forward - 0.5 * high * right + 0.5 * high * up;
        let v = corner + x * wide * right - y * high * up;
        Some([start.to_array(), v.normalize().to_array()].concat())
    });
    let told = "takes the value of “plane.y” where that of “plane.x in the corner” belongs";
    assert_eq!(found.name, told);
}

#[test]
fn an_infinite_number_that_was_made_whole_is_called_so() {
    let found = diagnosed("grid_resolution", |q| {
        let mut answer = (cases::find("grid_resolution")?.asked().call)(q);
        let flat = (0..3).find(|axis| q[*axis] == 0.0);
        if let Some(axis) = flat {
            answer[axis] = u32::MAX.into();
        }
        Some(answer)
    });
    assert!(
        found
            .name
            .starts_with("returns 4294967295, the end of its type's range"),
        "{}",
        found.name
    );
}
