//! What the text of an exercise leaves open, found out: what occurs in its questions, which answers are right where one would ask,
//! and how exactly they are compared. Said of the cases themselves and by the judge itself, so it cannot be out of date.

use crate::examine::{Case, Examiner};
use crate::further::FIRST_EIGHTHS;
use crate::jump::{Jump, is_interval, jumps};
use crate::layout::{Layout, Part, layout, lists, parts};
use crate::leeway::{LONG, Leeway, leeways};
use crate::rare::{Depth, smallest_region};
use raybook_workbook::kind::Kind;

/// In how many cases it is measured how far an answer may be off, where answers take long.
const MEASURED: usize = 16;

/// The effort of an answer that takes long.
const SLOW: usize = 100;

/// A row of a case.
struct Row<'a> {
    case: &'a Case,
    numbers: Vec<f64>,
    layout: Layout,
}

impl Row<'_> {
    /// The numbers of each value of a part.
    fn values(&self, part: usize) -> impl Iterator<Item = &[f64]> {
        let leaves = self.layout.of_part(part);
        leaves.map(|leaf| &self.numbers[leaf.range()])
    }
}

/// Sentences about an exercise, of which these are cases.
pub fn limits(examiner: &dyn Examiner, cases: &[Case]) -> Vec<String> {
    let asked = examiner.asked();
    let rows = |kind: &'static Kind, read: &dyn Fn(&Case) -> Option<Vec<f64>>| -> Vec<Row<'_>> {
        let row = |case| {
            let numbers = read(case)?;
            let layout = layout(kind, &numbers);
            Some(Row {
                case,
                numbers,
                layout,
            })
        };
        cases.iter().filter_map(row).collect()
    };
    let questions = rows(asked.question, &|case| {
        asked.read_question(&case.question).ok()
    });
    let answer = asked.answer.kind;
    let answers = rows(answer, &|case| asked.read_answer(&case.answers[0]).ok());
    let mut said = of_questions(asked.question, &questions);
    said.extend(of_nothing(answer, asked.answer.name, &answers));
    said.extend(of_jumps(examiner, cases));
    said.push(of_several(cases));
    said.extend(of_comparing(examiner, &questions, &answers));
    said.extend(Some(examiner.allows().to_owned()).filter(|allows| !allows.is_empty()));
    said.extend(of_names(cases));
    said.extend(of_crowds(examiner, cases));
    said.extend(of_further(examiner, cases));
    said
}

/// What occurs in questions: unit vectors, lists that are empty, infinities.
fn of_questions(kind: &'static Kind, rows: &[Row<'_>]) -> Vec<String> {
    let parts = parts(kind, "question");
    let all = |i: usize| rows.iter().flat_map(move |row| row.values(i));
    let chosen = |choose: &dyn Fn(usize, &Part) -> bool| -> Vec<String> {
        let chosen = parts
            .iter()
            .enumerate()
            .filter(|(i, part)| choose(*i, part));
        chosen.map(|(_, part)| part.name.clone()).collect()
    };
    let is_unit = |v: &[f64]| (v.iter().map(|v| v * v).sum::<f64>().sqrt() - 1.0).abs() < 1e-4;
    let units = chosen(&|i, part| is_vector(part.kind) && all(i).all(is_unit));
    let infinite = chosen(&|i, _| all(i).flatten().any(|v| v.is_infinite()));
    let names = lists(kind, "question");
    let length_0 = |list: usize| {
        let spans = rows.iter().flat_map(|row| &row.layout.lists);
        let mut spans = spans.filter(|span| span.list == list);
        spans.any(|span| span.elements.is_empty())
    };
    let (empty, filled): (Vec<_>, Vec<_>) = (0..names.len()).partition(|&list| length_0(list));
    let named = |which: Vec<usize>| which.iter().map(|&i| names[i].clone()).collect::<Vec<_>>();
    let mut said = of_ranges(&parts);
    let found = [
        ("Of length 1 in every question", units),
        ("May be infinite in a question", infinite),
        ("May be empty in a question", named(empty)),
        ("Never empty in a question", named(filled)),
    ];
    for (what, names) in found {
        if !names.is_empty() {
            said.push(format!("{what}: {}.", quoted(&names)));
        }
    }
    said
}

/// The ranges that the declarations of fields state, each with its fields.
fn of_ranges(parts: &[Part]) -> Vec<String> {
    let mut stated: Vec<(&str, Vec<String>)> = Vec::new();
    for part in parts {
        let Some(range) = part.range else { continue };
        let name = part.name.clone();
        match stated.iter_mut().find(|(words, _)| *words == range.words) {
            Some((_, names)) => names.push(name),
            None => stated.push((range.words, vec![name])),
        }
    }
    let said = |(words, names): &(&str, Vec<String>)| {
        format!("Always {words} in a question: {}.", quoted(names))
    };
    stated.iter().map(said).collect()
}

/// Where the right answer is `none`, an infinity or an empty list.
fn of_nothing(kind: &'static Kind, name: &str, rows: &[Row<'_>]) -> Vec<String> {
    let is_none = |row: &Row<'_>| matches!(kind, Kind::Optional(_)) && row.numbers[0] == 0.0;
    let is_infinite = |row: &Row<'_>| row.numbers.iter().any(|v| v.is_infinite());
    let names = lists(kind, name);
    let mut said = vec![
        occurrence(rows, "`none`", is_none),
        occurrence(rows, "an infinity", is_infinite),
    ];
    for (i, name) in names.iter().enumerate() {
        let is_empty = |row: &Row<'_>| {
            let mut spans = row.layout.lists.iter().filter(|span| span.list == i);
            spans.any(|span| span.elements.is_empty())
        };
        said.push(occurrence(
            rows,
            &format!("an empty list of `{name}`"),
            is_empty,
        ));
    }
    said.into_iter().flatten().collect()
}

/// In how many cases something is part of the right answer, and the first of them.
fn occurrence(rows: &[Row<'_>], what: &str, is_so: impl Fn(&Row<'_>) -> bool) -> Option<String> {
    let such: Vec<_> = rows.iter().filter(|row| is_so(row)).collect();
    let first = such.first()?;
    let (number, all, name) = (such.len(), rows.len(), &first.case.name);
    Some(format!(
        "The right answer is or holds {what} in {number} of {all} cases, such as \"{name}\"."
    ))
}

/// Whether the ends of intervals are asked, and other places where last digits decide.
fn of_jumps(examiner: &dyn Examiner, cases: &[Case]) -> Vec<String> {
    let named = cases.iter().filter(|case| !case.is_random());
    let found: Vec<_> = named.map(|case| (case, jumps(examiner, case))).collect();
    let names = |is_so: &dyn Fn(&[Jump]) -> bool| -> Vec<String> {
        let such = found.iter().filter(|(_, jumps)| is_so(jumps));
        such.map(|(case, _)| format!("\"{}\"", case.name)).collect()
    };
    let mut said = Vec::new();
    let parts = parts(examiner.asked().question, "question");
    for (part, Part { name, .. }) in parts.iter().enumerate().filter(|(_, p)| is_interval(p)) {
        let ends = [true, false]
            .map(|excluded| names(&|jumps| jumps.contains(&Jump::End { part, excluded })));
        for (names, counts) in ends.iter().zip(["does not count", "counts"]) {
            if !names.is_empty() {
                let names = names.join(", ");
                said.push(format!(
                    "What lies just at an end of `{name}` is asked, and {counts}: {names}."
                ));
            }
        }
        if ends.iter().all(Vec::is_empty) {
            said.push(format!(
                "Nothing is asked that hangs on whether an end of `{name}` counts."
            ));
        }
    }
    let others =
        names(&|jumps| !jumps.is_empty() && jumps.iter().all(|jump| *jump == Jump::Elsewhere));
    if !others.is_empty() {
        let others = others.join(", ");
        said.push(format!(
            "Asked just at a threshold, where last digits of the question decide: {others}."
        ));
    }
    said
}

/// Cases with more than one right answer.
fn of_several(cases: &[Case]) -> String {
    let several = cases.iter().filter(|case| case.answers.len() > 1);
    let names: Vec<_> = several.map(|case| format!("\"{}\"", case.name)).collect();
    if names.is_empty() {
        return "One right answer to each case is on file; where a text leaves a choice, the judge takes the others, too.".to_owned();
    }
    format!(
        "Ties, where more than one answer is right, are asked: {}.",
        names.join(", ")
    )
}

/// The large questions, and which faults are none there.
fn of_crowds(examiner: &dyn Examiner, cases: &[Case]) -> Option<String> {
    let followers = examiner.followers(cases);
    let large = followers.iter().filter(|one| one.is_long);
    let names: Vec<_> = large.map(|one| one.case.name.as_str()).collect();
    (!names.is_empty()).then(|| {
        let names = names.join(" and ");
        format!("Who is right in all cases is asked large cases, too, {names}: no answer in time is no fault there, but an error is one.")
    })
}

/// What is asked of who is right in the cases.
fn of_further(examiner: &dyn Examiner, cases: &[Case]) -> Vec<String> {
    let [check, grade] =
        [Depth::Check, Depth::Grade].map(|depth| examiner.rare_count(cases, depth));
    let random = cases.iter().filter(|case| case.is_random()).count();
    let region = 100.0 * smallest_region(random + grade);
    let together = examiner.further_questions(cases).len();
    let mut said = Vec::new();
    if together > 0 {
        let first = together * FIRST_EIGHTHS / 8;
        said.push(format!(
            "All answers are judged together, too; who is right so far is asked {first} questions for it, and up to {together} as long as there is doubt."
        ));
    }
    let further = match (check, grade) {
        (_, 0) if together > 0 => return said,
        (_, 0) => "No further random questions are asked".to_owned(),
        (0, _) => format!(
            "Who is right in all cases is asked {grade} further random questions where a class is graded"
        ),
        _ => format!(
            "Who is right in all cases is asked {check} further random questions, and {grade} where a class is graded"
        ),
    };
    said.push(format!(
        "{further}: a fault in {region:.1} % of all questions is then met with 95 %."
    ));
    said
}

/// How answers are compared: whether order and length count, and how far numbers may be off.
fn of_comparing(
    examiner: &dyn Examiner,
    questions: &[Row<'_>],
    answers: &[Row<'_>],
) -> Vec<String> {
    let answer = &examiner.asked().answer;
    let both = || questions.iter().zip(answers);
    let mut said = Vec::new();
    for (list, name) in lists(answer.kind, answer.name).iter().enumerate() {
        let turned = both().filter_map(|(question, row)| {
            let turned = row
                .layout
                .rearranged(&row.numbers, list, &|n| (0..n).rev().collect());
            let differs = turned != row.numbers;
            let compared = || examiner.compare(&question.numbers, &row.numbers, &turned);
            differs.then(|| compared().is_ok())
        });
        let turned: Vec<_> = turned.collect();
        if !turned.is_empty() {
            let any = turned.iter().all(|&right| right);
            let counts = if any { "does not count" } else { "counts" };
            said.push(format!("The order of `{name}` {counts}."));
            if any && are_samples(examiner, questions, answers) {
                said.push(format!(
                    "`{name}`: not compared one by one, but by what all of them have in common."
                ));
                return said;
            }
        }
    }
    let step = if examiner.limits().effort < SLOW {
        1
    } else {
        answers.len().div_ceil(MEASURED).max(1)
    };
    for (i, part) in parts(answer.kind, answer.name).iter().enumerate() {
        let measured = both()
            .step_by(step)
            .flat_map(|(question, row)| leeways(examiner, &question.numbers, &row.numbers, i));
        let measured: Vec<_> = measured.collect();
        let together = answers
            .iter()
            .any(|row| row.layout.of_part(i).count() > LONG);
        said.extend(of_leeways(&part.name, &measured, together));
    }
    said
}

/// Whether an answer is points or directions of which only the distribution is compared.
fn are_samples(examiner: &dyn Examiner, questions: &[Row<'_>], answers: &[Row<'_>]) -> bool {
    let have_traits = |(question, answer): (&Row<'_>, &Row<'_>)| {
        let traits = examiner.traits(&question.numbers, &answer.numbers);
        !traits.is_empty()
    };
    let kind = examiner.asked().answer.kind;
    matches!(kind, Kind::List(Kind::Numbers(_))) && questions.iter().zip(answers).any(have_traits)
}

/// How far the values of a part may be off, in a sentence: in both directions, or where that is nothing, in each. Where any other value is
/// wrong, another answer as a whole may still be right.
fn of_leeways(name: &str, measured: &[[Leeway; 2]], together: bool) -> Option<String> {
    if measured.is_empty() {
        return None;
    }
    if measured.iter().flatten().all(|off| *off == Leeway::Free) {
        return Some(format!("`{name}`: not compared by value."));
    }
    let error = |leeway: Leeway| match leeway {
        Leeway::Exact => 0.0,
        Leeway::Within(error) => error,
        Leeway::Free => f64::INFINITY,
    };
    let how = |off: &str, choose: &dyn Fn([f64; 2]) -> f64| {
        let errors = measured.iter().map(|both| choose(both.map(error)));
        how_far(errors.collect(), off)
    };
    let both = how("off", &|[above, below]| above.min(below));
    // A value that may be off by anything in one direction is a yes or a no.
    let some = |error: f64| if error.is_finite() { error } else { 0.0 };
    let above = || how("larger", &|[above, _]| some(above));
    let below = || how("smaller", &|[_, below]| some(below));
    let how = both.or_else(|| match (above(), below()) {
        (None, None) => None,
        (Some(above), None) => Some(format!("{above}; a smaller value is wrong")),
        (None, Some(below)) => Some(format!("{below}; a larger value is wrong")),
        (Some(above), Some(below)) => Some(format!("{above}; {below}")),
    });
    let always = measured.iter().flatten().all(|off| *off == Leeway::Exact);
    let often = if always { "" } else { " in most cases" };
    let how = how.unwrap_or_else(|| format!("no other value is right{often}"));
    let together = if together {
        "all of them together, "
    } else {
        ""
    };
    Some(format!("`{name}`: {together}{how}."))
}

/// How far values may be off that were measured; none if mostly by nothing.
fn how_far(mut errors: Vec<f64>, off: &str) -> Option<String> {
    errors.sort_by(f64::total_cmp);
    let (least, middle) = (*errors.first()?, errors[errors.len() / 2]);
    let amount = |error: f64| match error {
        1.0..1e4 => format!("{error:.0}"),
        _ => format!("{error:.0e}"),
    };
    let (by_least, by_middle) = (amount(least), amount(middle));
    Some(match (least, middle) {
        (_, 0.0) => return None,
        (0.0, middle) if middle.is_infinite() => format!("may be {off} by anything in most cases"),
        (0.0, _) => format!("may typically be {off} by {by_middle}, in some cases by nothing"),
        (least, _) if least.is_infinite() => format!("may be {off} by anything"),
        (least, middle) if middle < 4.0 * least => format!("may be {off} by {by_least}"),
        (_, middle) if middle.is_infinite() => format!("may be {off} by at least {by_least}"),
        _ => format!("may be {off} by {by_least} at the least, typically by {by_middle}"),
    })
}

/// The names of the cases that are not random.
fn of_names(cases: &[Case]) -> Option<String> {
    let named = cases.iter().filter(|case| !case.is_random());
    let names: Vec<_> = named.map(|case| case.name.as_str()).collect();
    let others = cases.len() - names.len();
    (!names.is_empty()).then(|| {
        format!(
            "Asked by name: {}; and {others} random cases.",
            names.join("; ")
        )
    })
}

fn is_vector(kind: &Kind) -> bool {
    matches!(kind, Kind::Direction) || matches!(kind, Kind::Numbers(parts) if parts.name == "Vec3")
}

fn quoted(names: &[String]) -> String {
    let quoted: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}
