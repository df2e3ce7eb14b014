//! Slips in one operation are named by what goes into a step; and where no mistake gives the same answers, or there are none, the
//! branch of the calculation is told.

use raybook_grader::cases;
use raybook_grader::diagnose::{Diagnosis, diagnose};
use raybook_grader::examine::visible_rng;
use raybook_workbook::row;

/// The diagnosis of a function from the numbers of a question to those of an answer; `None` gives no answer.
pub fn diagnosed(exercise: &str, function: impl Fn(&[f64]) -> Option<Vec<f64>>) -> Diagnosis {
    let examiner = cases::find(exercise).expect("the exercise exists");
    let asked = examiner.asked();
    let cases = examiner.cases(&mut visible_rng(exercise)).cases;
    let answers: Vec<_> = cases
        .iter()
        .map(|case| {
            let question = asked.read_question(&case.question).expect("a question");
            let Some(answer) = function(&question) else {
                return (None, false);
            };
            let answer = row::format(asked.answer.kind, &answer);
            let verdict = examiner.judge(&case.question, &case.answers, &answer);
            (Some(answer), verdict.is_ok())
        })
        .collect();
    diagnose(examiner, &cases, &answers).expect("it has a name")
}

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
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_case_without_an_answer_is_told_by_its_branch() {
    let found = diagnosed("fresnel", |q| {
        fresnel(q, |n2, cos1| n2 * cos1).map(Vec::from)
    });
    let told = "gives no answer when cos²θ₂ is not positive, and only then";
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
