//! Mistakes that were written before anybody looked at the lists, and had no name or a wrong one.

use super::function::{answers, diagnosed, right};
use glam::{DVec2, DVec3, dvec2};
use rand::RngExt;
use raybook::math::pcg;
use raybook_grader::cases;
use raybook_grader::diagnose::diagnose;
use raybook_grader::examine::visible_rng;

#[test]
fn a_seed_of_which_a_part_is_used_is_no_dependence_on_the_point_before_nor_a_wrong_range() {
    let of_few = |n: f64, seed: f64| right("random_pattern", &[n, seed % 8.0 + 1.0]);
    let of_none = |n: f64, _| right("random_pattern", &[n, 1.0]);
    let for_y_only = |n: f64, seed: f64| {
        let (mut points, fixed) = (right("random_pattern", &[n, seed]), [n, 0.0]);
        let fixed = right("random_pattern", &fixed);
        let all_x = (1..points.len()).step_by(2);
        all_x.for_each(|i| points[i] = fixed[i]);
        points
    };
    let examiner = cases::find("random_pattern").expect("it exists");
    let cases = examiner.cases(&mut visible_rng("random_pattern")).cases;
    for (wrong, told) in [
        (
            &of_few as &dyn Fn(f64, f64) -> Vec<f64>,
            "ignores a part of the seed",
        ),
        (&of_none, "ignores the seed"),
        (&for_y_only, "ignores the seed in one coordinate"),
    ] {
        let got = answers(examiner, &cases, |q| Some(wrong(q[0], q[1])));
        // One by one they are right.
        let together: Vec<_> = got.into_iter().map(|(got, _)| (got, false)).collect();
        let found = diagnose(examiner, &cases, &together).expect("it has a name");
        assert_eq!((&*found.name, found.certain), (told, true));
    }
}

#[test]
fn a_step_along_the_ray_is_named_whatever_its_length() {
    for steps in [0.5, 1.0] {
        let found = diagnosed("shadow_ray", |q| {
            let mut way = right("shadow_ray", q);
            let [position, normal, toward] = [0, 4, 7].map(|i| DVec3::from_slice(&q[i..i + 3]));
            let step = steps * q[3] * normal.abs().element_sum();
            way[..3].copy_from_slice(&(position + step * toward).to_array());
            Some(way)
        });
        let told = "moves the start along the ray, not along the normal";
        assert_eq!((&*found.name, found.certain), (told, true));
    }
}

#[test]
fn digits_that_are_lost_in_some_other_precision_are_named() {
    let found = diagnosed("solve_quadratic", |q| {
        let [a, half, c] = [q[0], -0.5 * q[1], q[2]];
        let root = f64::from(((half * half - a * c) as f32).sqrt());
        if a == 0.0 || !root.is_finite() {
            return Some(vec![0.0]);
        }
        let roots = [(half - root) / a, (half + root) / a];
        Some(vec![1.0, roots[0].min(roots[1]), roots[0].max(roots[1])])
    });
    assert_eq!(found.name, "uses the schoolbook formula for both roots");
}

#[test]
fn a_byte_for_a_code_value_is_named() {
    let found = diagnosed("encode_srgb", |q| {
        Some(vec![(255.0 * right("encode_srgb", q)[0]).round()])
    });
    assert_eq!(found.name, "returns a whole number from 0 to 255");
}

#[test]
fn a_normal_that_is_not_turned_with_its_cosine_is_named() {
    let found = diagnosed("refract", |q| {
        let [d, n] = [0, 3].map(|i| DVec3::from_slice(&q[i..i + 3]));
        let (cosine, [outside, inside]) = (-d.dot(n), [q[6], q[7]]);
        let ratio = if cosine < 0.0 {
            inside / outside
        } else {
            outside / inside
        };
        let cosine = cosine.abs();
        let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
        if squared < 0.0 {
            return Some(vec![0.0]);
        }
        let t = ratio * d + (ratio * cosine - squared.sqrt()) * n;
        Some([vec![1.0], t.to_array().to_vec()].concat())
    });
    let told = "turns the cosine, but not the normal, where the ray leaves";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_long_answer_where_there_is_none_is_not_written_out() {
    let found = diagnosed("sample_rect", |q| {
        let right = right("sample_rect", q);
        let anything = || [vec![1.0, 64.0], vec![0.25; 6 * 64]].concat();
        Some(if right == [0.0] { anything() } else { right })
    });
    for told in std::iter::once(&found).chain(&found.also) {
        assert!(told.name.len() < 200, "{}", told.name);
    }
}

#[test]
fn a_few_percent_too_little_of_a_light_are_seen_in_a_finer_lattice() {
    let narrower = |exercise: &str, narrow: fn(&[f64]) -> Vec<f64>| {
        let examiner = cases::find(exercise).expect("it exists");
        let cases = examiner.cases(&mut visible_rng(exercise)).cases;
        let got = answers(examiner, &cases, |q| Some(narrow(q)));
        let followers = examiner.followers(&cases);
        let follow: Vec<_> = followers.into_iter().map(|one| one.case).collect();
        let further = answers(examiner, &follow, |q| Some(narrow(q)));
        let wrong = |got: &[(Option<String>, bool)]| got.iter().any(|(_, right)| !right);
        assert!(!wrong(&got), "{exercise}: a coarse lattice tells nothing");
        assert!(wrong(&further), "{exercise}: a fine lattice tells it");
        assert_eq!(diagnose(examiner, &cases, &got), None);
    };
    narrower("sample_rect", |q| {
        // The light's sides, from its middle, are 3 % shorter for the samples, but not for their density.
        let mut smaller = q.to_vec();
        for i in 0..3 {
            smaller[3 + i] += 0.015 * (q[6 + i] + q[9 + i]);
            smaller[6 + i] *= 0.97;
            smaller[9 + i] *= 0.97;
        }
        let mut samples = right("sample_rect", &smaller);
        let numbers = samples.iter_mut().skip(2).enumerate();
        for (i, number) in numbers {
            match i % 6 {
                4 => *number *= 0.97 * 0.97,
                5 => *number /= 0.97 * 0.97,
                _ => {}
            }
        }
        samples
    });
}

#[test]
fn too_few_darts_leave_room_among_many_points() {
    let examiner = cases::find("poisson_disk").expect("it exists");
    let cases = examiner.cases(&mut visible_rng("poisson_disk")).cases;
    let darts = |q: &[f64]| {
        let (least, mut rng) = (1.0001 * q[0], pcg::stream(22, q[1] as u64));
        let mut points: Vec<DVec2> = Vec::new();
        for _ in 0..(2.0 / (least * least)) as usize {
            let dart = dvec2(rng.random(), rng.random());
            if points.iter().all(|point| point.distance(dart) > least) {
                points.push(dart);
            }
        }
        points
    };
    let got = answers(examiner, &cases, |q| {
        let points = darts(q);
        let places = points.iter().flat_map(DVec2::to_array);
        Some(std::iter::once(points.len() as f64).chain(places).collect())
    });
    let is_of_many = |said: &Option<String>| {
        let count = said
            .as_ref()
            .and_then(|said| said.split_whitespace().next());
        count.is_some_and(|count| count.parse::<usize>().is_ok_and(|n| n >= 100))
    };
    let many = got.iter().filter(|(said, _)| is_of_many(said));
    let (right, wrong): (Vec<_>, Vec<_>) = many.partition(|(_, right)| *right);
    assert!(
        wrong.len() > 3 * right.len(),
        "{} right, {} wrong",
        right.len(),
        wrong.len()
    );
}
