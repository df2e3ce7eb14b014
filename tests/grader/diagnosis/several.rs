//! Two mistakes in one function, each of which shows in other cases: both are named, as who begins makes them.

use super::function::{camera, diagnosed, right};
use glam::vec3;
use raybook::math::basis::Basis;
use raybook::math::dir3::Dir3;
use raybook_grader::cases;
use raybook_grader::diagnose::{Beside, Diagnosis};

fn names(found: &Diagnosis) -> Vec<&str> {
    let also = found.also.iter().map(|also| also.name.as_str());
    [found.name.as_str()].into_iter().chain(also).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn cross(a: &[f64], b: &[f64]) -> Vec<f64> {
    let part = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    vec![part(1, 2), part(2, 0), part(0, 1)]
}

#[test]
fn who_takes_the_near_root_only_and_forgets_the_end_of_the_interval_is_told_both() {
    let found = diagnosed("sphere_hit", |q| {
        let (from, d, radius) = (minus(&q[..3], &q[8..11]), &q[3..6], q[11]);
        let b = dot(&from, d);
        let root = (b * b - dot(&from, &from) + radius * radius).sqrt();
        let t = -b - root;
        Some(if t > q[6] { vec![1.0, t] } else { vec![0.0] })
    });
    let both = [
        "gives up when the near root does not count",
        "only asks for t > min",
    ];
    assert_eq!(names(&found), both);
}

#[test]
fn who_forgets_a_weight_and_asks_nothing_of_a_flat_triangle_is_told_the_weight() {
    let found = diagnosed("triangle_hit", |q| {
        let (origin, d, p0) = (&q[..3], &q[3..6], &q[8..11]);
        let (e1, e2) = (minus(&q[11..14], p0), minus(&q[14..17], p0));
        let (s1, s) = (cross(d, &e2), minus(origin, p0));
        let s2 = cross(&s, &e1);
        let determinant = dot(&s1, &e1);
        let [b1, b2, t] = [dot(&s1, &s), dot(&s2, d), dot(&s2, &e2)].map(|v| v / determinant);
        let misses = b1 < 0.0 || b2 < 0.0 || b1 > 1.0 || b2 > 1.0 || t < q[6];
        Some(if misses {
            vec![0.0]
        } else {
            vec![1.0, t, b1, b2]
        })
    });
    let told = names(&found);
    assert!(told.contains(&"forgets b1 + b2 <= 1"), "{told:?}");
}

#[test]
fn a_mistake_in_each_of_two_parts_is_told_in_its_part() {
    let found = diagnosed("camera_ray", |q| {
        let ([start, forward, right, up], [f, wide, high, x, y]) = camera(q);
        let v = f * forward - (x - 0.5) * wide * right + (0.5 - y) * high * up;
        Some([(-start).to_array(), v.normalize().to_array()].concat())
    });
    let told: Vec<_> = [&found]
        .into_iter()
        .chain(&found.also)
        .map(|one| (one.part.as_deref(), one.name.as_str()))
        .collect();
    let both = [
        (Some("origin"), "has the sign of origin wrong"),
        (Some("direction"), "draws the picture mirrored"),
    ];
    assert_eq!(told, both);
}

#[test]
fn what_shows_of_a_mistake_is_no_second_one() {
    let asked = cases::find("cosine_hemisphere")
        .expect("an exercise")
        .asked();
    // A frame around normals that go down whose first axis has a sign wrong.
    let found = diagnosed("cosine_hemisphere", |q| {
        let right = (asked.call)(q);
        if q[2] >= 0.0 {
            return Some(right);
        }
        let normal = vec3(q[0] as f32, q[1] as f32, q[2] as f32);
        let basis = Basis::around(Dir3::new(normal)?);
        let askew = |d: &[f64]| {
            let along = f64::from(basis.x.dot(vec3(d[0] as f32, d[1] as f32, d[2] as f32)));
            [d[0], d[1], d[2] - 2.0 * along * f64::from(basis.x.z)]
        };
        let (count, directions) = right.split_at(right.len() % 3);
        let directions = directions.chunks_exact(3).flat_map(askew);
        Some(count.iter().copied().chain(directions).collect())
    });
    assert!(found.name.contains("sign of z wrong"), "{found:?}");
    let beside = found.also.iter().map(|one| (one.beside, one.name.as_str()));
    let shown = (Beside::Shown, "does not return directions of length 1");
    assert_eq!(beside.collect::<Vec<_>>(), [shown]);
}

/// Both mistakes, which only together explain all answers.
fn together(found: &Diagnosis) -> [&str; 2] {
    let then = found.also.first().expect("a second mistake");
    assert_eq!(then.beside, Beside::Together, "{found:?}");
    [&found.name, &then.name]
}

#[test]
fn who_counts_from_1_and_forgets_the_limit_is_told_both_though_the_second_shows_in_one_case() {
    let asked = cases::find("refine_cell").expect("an exercise");
    let forgets = |(name, _): &(&str, &str)| name.contains("255");
    let forgets = asked.mistakes().iter().position(forgets);
    let forgets = forgets.expect("it is on the list");
    let found = diagnosed("refine_cell", |q| {
        let mut answer = asked.mistake_answers(forgets, q)?;
        answer[4..]
            .iter_mut()
            .skip(3)
            .step_by(4)
            .for_each(|shape| *shape += 1.0);
        Some(answer)
    });
    let [first, second] = together(&found);
    assert_eq!(first, "counts shape from 1 instead of 0: one too much");
    assert!(second.contains("255"), "{second}");
}

#[test]
fn who_takes_the_near_root_only_and_counts_the_ends_is_told_both() {
    let found = diagnosed("sphere_hit", |q| {
        let (from, d, radius) = (minus(&q[..3], &q[8..11]), &q[3..6], q[11]);
        let b = dot(&from, d);
        let t = -b - (b * b - dot(&from, &from) + radius * radius).sqrt();
        let counts = q[6] <= t && t <= q[7];
        Some(if counts { vec![1.0, t] } else { vec![0.0] })
    });
    let both = [
        "gives up when the near root does not count",
        "takes both ends of within to be inside the interval",
    ];
    assert_eq!(names(&found), both);
    assert!(!found.certain, "a question may be misread in many ways");
}

#[test]
fn a_question_that_most_cases_do_not_show_to_be_misread_is_told_after_the_mistake_that_all_show() {
    // In most cases the end of the interval is infinite.
    let found = diagnosed("grid_walk", |q| {
        let mut question = q.to_vec();
        let end = question.len() - 1;
        question[end] = f64::INFINITY;
        let mut visits = right("grid_walk", &question);
        if visits[0] > 0.0 {
            visits[0] -= 1.0;
            visits.drain(1..5);
        }
        Some(visits)
    });
    assert_eq!(
        together(&found),
        ["skips the first cell", "goes on beyond the interval's max"]
    );
}

#[test]
fn a_question_that_is_misread_and_a_step_that_goes_wrong_are_told_together() {
    let found = diagnosed("interpolate_texture", |q| {
        let (b1, b2) = (q[6], q[7]);
        let weights = [b1 + b2, b2, b1];
        let along = |axis: usize| (0..3).map(|i| weights[i] * q[2 * i + axis]).sum();
        Some(vec![along(0), along(1)])
    });
    let [first, second] = together(&found);
    assert_eq!(first, "exchanges t1 and t2");
    assert!(second.contains("b₀ = 1 − b₁ − b₂"), "{second}");
}

/// Both names, in whichever order they are told.
fn both_of(found: &Diagnosis) -> [&str; 2] {
    let mut both = together(found);
    both.sort_unstable();
    both
}

#[test]
fn two_mistakes_in_one_sum_are_told_though_no_case_shows_one_of_them_alone() {
    let found = diagnosed("pixel_average", |q| {
        let (radius, samples) = (q[0], q[2..].chunks(5));
        let n = samples.len().max(1) as f64;
        let mut mean = [0.0; 3];
        for sample in samples {
            let weight = (1.0 - sample[0].hypot(sample[1]) / radius).max(0.0);
            for (mean, radiance) in mean.iter_mut().zip(&sample[2..]) {
                *mean += weight * radiance / n;
            }
        }
        Some(mean.to_vec())
    });
    let both = [
        "divides by the number of samples",
        "makes a cone instead of a tent",
    ];
    assert_eq!(both_of(&found), both);
}

#[test]
fn two_mistakes_in_one_distribution_are_told_by_what_they_have_in_common_with_the_students() {
    let found = diagnosed("cosine_hemisphere", |q| {
        let (normal, n) = (glam::DVec3::from_slice(q), q[3] as u32);
        let (x, y) = normal.any_orthonormal_pair();
        let direction = |i: u32| {
            let (u, v) = (0.618_034 * f64::from(i) % 1.0, (f64::from(i) + 0.5) / q[3]);
            let (cosine, turn) = (1.0 - u, std::f64::consts::PI * v);
            let sine = (1.0 - cosine * cosine).sqrt();
            sine * (turn.cos() * x + turn.sin() * y) + cosine * normal
        };
        let directions = (0..n).flat_map(|i| direction(i).to_array());
        Some([f64::from(n)].into_iter().chain(directions).collect())
    });
    let both = [
        "goes only half way round",
        "takes all directions for equally likely",
    ];
    assert_eq!(both_of(&found), both);
}

/// The deflection in degrees, but none of rays that pass at less than a limit.
fn in_degrees(q: &[f64], limit: f64) -> Vec<f64> {
    if q[0] < limit {
        return vec![0.0];
    }
    let answer = right("deflection_angle", q);
    let degrees = answer[1..].iter().map(|v| v.to_degrees());
    answer[..1].iter().copied().chain(degrees).collect()
}

#[test]
fn a_branch_that_begins_too_late_and_a_unit_are_told_together() {
    let found = diagnosed("deflection_angle", |q| Some(in_degrees(q, 3.0)));
    let told: Vec<_> = [&found].into_iter().chain(&found.also).collect();
    let names: Vec<_> = told.iter().map(|one| &*one.name).collect();
    let both = ["returns degrees", "lets rays fall in up to b = 3"];
    assert_eq!(names, both);
    assert!(told.iter().all(|one| one.certain), "{found:?}");
}

#[test]
fn a_mistake_that_would_spoil_the_answers_of_another_is_not_certain() {
    // Between 4.5 and 5.2, who takes 1 for the hole's mass answers none.
    let found = diagnosed("deflection_angle", |q| Some(in_degrees(q, 4.5)));
    let mut told = [&found].into_iter().chain(&found.also);
    assert!(
        told.all(|one| !one.certain || one.name == "returns degrees"),
        "{found:?}"
    );
}

#[test]
fn a_mistake_is_made_upon_another_if_it_is_made_of_the_right_answer() {
    let asked = cases::find("sphere_normal").expect("an exercise");
    let number = |told: &str| {
        let mut mistakes = asked.mistakes().into_iter();
        mistakes.position(|(name, _)| name == told).expect(told)
    };
    let inwards = number("points inwards");
    let at_origin = number("takes the sphere to be at the origin");
    let question = [2.0, 2.0, 3.0, 1.0, 2.0, 2.0, 1.5];
    let alone = asked.mistake_answers(at_origin, &question);
    let turned = alone.map(|v| v.iter().map(|v| -v).collect::<Vec<_>>());
    let both = asked.mistakes_answer(inwards, at_origin, &question);
    assert_eq!(both, turned.map(|turned| (turned, true)));
    // Who forgets to normalise has calculated all by himself.
    let long = number("forgets to normalise");
    let both = asked.mistakes_answer(long, inwards, &question);
    let alone = asked.mistake_answers(long, &question);
    assert_eq!(both, alone.map(|alone| (alone, false)));
}

#[test]
fn two_settings_are_changed_in_either_order_and_nothing_stays_changed() {
    let asked = cases::find("wide_closest").expect("an exercise");
    let cases = asked
        .cases(&mut raybook_grader::examine::visible_rng("wide_closest"))
        .cases;
    let number = |told: &str| {
        let mut mistakes = asked.mistakes().into_iter();
        mistakes.position(|(name, _)| name == told).expect(told)
    };
    let all = number("opens every child");
    let four = number("looks at four of eight children only");
    for case in &cases {
        let question = asked
            .asked()
            .read_question(&case.question)
            .expect("a question");
        let before = asked.mistake_answers(all, &question);
        let both = asked.mistakes_answer(all, four, &question);
        assert_eq!(both, asked.mistakes_answer(four, all, &question));
        assert!(both.is_some_and(|(_, is_made_of_it)| is_made_of_it));
        assert_eq!(asked.mistake_answers(all, &question), before);
    }
}

#[test]
fn a_seed_that_is_ignored_is_told_beside_another_mistake() {
    let asked = cases::find("random_pattern").expect("an exercise").asked();
    let found = diagnosed("random_pattern", |q| {
        let all = (asked.call)(&[q[0], 7.0]);
        let last = all.len().saturating_sub(2).max(1);
        Some([&[(last / 2) as f64], &all[1..last]].concat())
    });
    assert_eq!(
        names(&found),
        [
            "makes another number of points than asked",
            "ignores the seed"
        ]
    );
    // Who draws none ignores none.
    let examiner = cases::find("jittered").expect("an exercise");
    for (i, (name, _)) in examiner.mistakes().into_iter().enumerate() {
        let found = diagnosed("jittered", |q| examiner.mistake_answers(i, q));
        assert_eq!(names(&found)[0], name);
        assert!(!names(&found).contains(&"ignores the seed"), "{name}");
    }
}
