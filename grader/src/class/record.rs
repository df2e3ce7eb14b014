//! What is known about an exercise of a hand-in, as the journal holds it.

use super::drawn;
use super::grades::Known;
use super::stage;
use crate::ask::Said;
use crate::check::{Mark, Outcome, Report, State};
use crate::examine::Examiner;
use serde_json::{Map, Value, json};

/// What became of an exercise of a hand-in.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// The fingerprint of the hand-in.
    pub hand_in: String,
    /// The exercise.
    pub exercise: String,
    /// The fingerprint of everything else that the result depends on: version, key, term, limits and golden file.
    pub edition: String,
    /// The result.
    pub result: Marked,
}

/// How an exercise stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// All is right.
    Right,
    /// Some case is wrong, or some picture is not passed.
    Wrong,
    /// It is not written, or calls what is not.
    NotStarted,
    /// The program does not compile.
    NotBuilt,
    /// The grader could not find out; it says nothing about the hand-in, and is tried again.
    NotGraded,
}

/// A result.
#[derive(Clone, Debug, PartialEq)]
pub struct Marked {
    /// How the exercise stands.
    pub standing: Standing,
    /// Right cases, and cases.
    pub right: [u64; 2],
    /// Of these, right visible ones, and visible ones: the named cases of the golden file.
    pub visible: [u64; 2],
    /// The names of the wrong cases.
    pub wrong: Vec<String>,
    /// The mistake that explains them: what it does, and a hint.
    pub mistake: Option<[String; 2]>,
    /// Words to the student: a wrong visible case, or why there is nothing to ask. It tells nothing of hidden cases.
    pub why: String,
    /// The wrong visible case that is told, if it has an answer, to be drawn: its question and the answer.
    pub shown: Option<[String; 2]>,
    /// The first wrong picture of the answers: its text, and a PNG in base 64.
    pub picture: Option<[String; 2]>,
}

const STANDINGS: [(Standing, &str); 5] = [
    (Standing::Right, "right"),
    (Standing::Wrong, "wrong"),
    (Standing::NotStarted, "not started"),
    (Standing::NotBuilt, "does not compile"),
    (Standing::NotGraded, "not graded"),
];

impl Standing {
    /// In a word or two.
    pub fn name(self) -> &'static str {
        let found = STANDINGS.iter().find(|(standing, _)| *standing == self);
        found.map_or("", |(_, name)| name)
    }

    fn of(name: &str) -> Option<Self> {
        let found = STANDINGS.iter().find(|(_, of)| *of == name);
        found.map(|(standing, _)| *standing)
    }
}

/// A student's words, or a compiler's, are cut where nobody reads on.
const LONGEST_WHY: usize = 2000;

/// A question and an answer longer than this are not kept to be drawn.
const LONGEST_SHOWN: usize = 1000;

impl Marked {
    /// A result without cases.
    pub fn without_cases(standing: Standing, why: &str) -> Self {
        Self {
            standing,
            right: [0, 0],
            visible: [0, 0],
            wrong: Vec::new(),
            mistake: None,
            why: why.chars().take(LONGEST_WHY).collect(),
            shown: None,
            picture: None,
        }
    }

    /// The result of a report.
    pub fn of(report: &Report, examiner: &dyn Examiner) -> Self {
        if is_unknown(report) {
            let (standing, why) = stage::nothing();
            return Self::without_cases(standing, &why);
        }
        let named = examiner.named().map_or(0, |named| named.len());
        let is_right = |outcome: &&Outcome| outcome.verdict == Mark::Right;
        let visible = || {
            report
                .cases
                .iter()
                .filter(|outcome| outcome.case.number <= named)
        };
        // The case that is shown is one of the mistake that is named, if a visible one is.
        let first = visible().find(|outcome| matches!(outcome.verdict, Mark::Wrong(_)));
        let explained = report.diagnosis.as_ref().and_then(|found| found.shown);
        let explained = explained.and_then(|place| report.cases.get(place));
        let explained = explained.filter(|outcome| {
            outcome.case.number <= named && matches!(outcome.verdict, Mark::Wrong(_))
        });
        let told = explained.or(first);
        let first = told.and_then(|outcome| match &outcome.verdict {
            Mark::Wrong(why) if outcome.ended() => {
                let last_words = outcome.reply.printed.stderr.unescaped();
                Some(format!("{}: {why}\n{last_words}", outcome.case.name))
            }
            Mark::Wrong(why) => Some(format!("{}: {why}", outcome.case.name)),
            _ => None,
        });
        let state = report.state();
        let mut why = match (&state, first, report.first_failed()) {
            (State::WaitsFor(name), ..) => format!("it calls {name}, which is not written"),
            (State::Wrong, Some(why), _) => why,
            (State::Wrong, None, Some(_)) if report.right() == report.cases.len() => {
                "the cases are right, and the picture that the answers make is not".to_owned()
            }
            (State::Wrong, None, _) => {
                "right on the visible cases only: other questions of the same kind have wrong answers".to_owned()
            }
            _ => String::new(),
        };
        let elsewhere = report
            .diagnosis
            .as_ref()
            .is_some_and(|found| found.shown.is_some());
        if elsewhere && explained.is_none() && told.is_some() && !why.is_empty() {
            why += "\nWhat follows shows in other answers, and not in this one.";
        }
        let wrong = report.cases.iter().filter(|outcome| !is_right(outcome));
        let shown = told.and_then(|outcome| match &outcome.reply.said {
            Said::Answer(answer) => {
                Some([outcome.case.question.clone(), answer.unescaped().to_owned()])
            }
            _ => None,
        });
        let shown =
            shown.filter(|[question, answer]| question.len() + answer.len() <= LONGEST_SHOWN);
        Self {
            standing: match state {
                State::Right => Standing::Right,
                State::Wrong => Standing::Wrong,
                State::NotStarted | State::WaitsFor(_) => Standing::NotStarted,
            },
            right: [report.right(), report.cases.len()].map(|n| n as u64),
            visible: [visible().filter(is_right).count(), visible().count()].map(|n| n as u64),
            wrong: wrong.map(|outcome| outcome.case.name.clone()).collect(),
            mistake: report
                .diagnosis
                .as_ref()
                .map(|mistake| [mistake.name.clone(), mistake.hint.clone()]),
            why: why.chars().take(LONGEST_WHY).collect(),
            shown,
            picture: drawn::first_wrong(report),
        }
    }

    /// Whether all visible cases are right, and some hidden one is not.
    pub fn right_on_visible_only(&self) -> bool {
        let [right, visible] = self.visible;
        self.standing == Standing::Wrong
            && visible > 0
            && right == visible
            && self.right[0] < self.right[1]
    }
}

/// Whether the program knows nothing of the exercise: the answer programs of workbooks say so of one that is the instructor's own.
fn is_unknown(report: &Report) -> bool {
    let words = format!("there is no exercise `{}`", report.exercise);
    let is_said = |said: &Said| matches!(said, Said::Refused(why) if why.unescaped() == words);
    !report.cases.is_empty()
        && report
            .cases
            .iter()
            .all(|outcome| is_said(&outcome.reply.said))
}

impl Record {
    /// As a line of the journal.
    pub fn to_json(&self) -> Value {
        let Marked {
            standing,
            right,
            visible,
            wrong,
            mistake,
            why,
            shown,
            picture,
        } = &self.result;
        let mut fields = Map::new();
        let all = [
            ("hand_in", json!(self.hand_in)),
            ("exercise", json!(self.exercise)),
            ("edition", json!(self.edition)),
            ("standing", json!(standing.name())),
            ("right", json!(right)),
            ("visible", json!(visible)),
            ("wrong", json!(wrong)),
            ("mistake", json!(mistake)),
            ("why", json!(why)),
            ("shown", json!(shown)),
            ("picture", json!(picture)),
        ];
        // What is empty takes no room.
        let is_empty =
            |value: &Value| *value == json!([]) || *value == json!("") || value.is_null();
        fields.extend(
            all.into_iter()
                .filter(|(_, value)| !is_empty(value))
                .map(|(name, value)| (name.to_owned(), value)),
        );
        Value::Object(fields)
    }

    /// From a line of the journal; `None` if it is something else.
    pub fn from_json(value: &Value) -> Option<Self> {
        let text = |name: &str| value[name].as_str().map(str::to_owned);
        let two = |name: &str| Some([value[name][0].as_u64()?, value[name][1].as_u64()?]);
        let words = |name: &str| -> Vec<String> {
            let words = value[name].as_array().into_iter().flatten();
            words
                .filter_map(|word| word.as_str().map(str::to_owned))
                .collect()
        };
        Some(Self {
            hand_in: text("hand_in")?,
            exercise: text("exercise")?,
            edition: text("edition")?,
            result: Marked {
                standing: Standing::of(value["standing"].as_str()?)?,
                right: two("right")?,
                visible: two("visible")?,
                wrong: words("wrong"),
                mistake: words("mistake").try_into().ok(),
                why: text("why").unwrap_or_default(),
                shown: words("shown").try_into().ok(),
                picture: words("picture").try_into().ok(),
            },
        })
    }
}

/// What the journal tells of the hand-ins of this exam: of several records the last that is a result.
pub fn known(records: impl Iterator<Item = Record>) -> Known {
    let mut known = Known::new();
    for record in records {
        let key = (record.hand_in, record.exercise);
        let is_result = record.result.standing != Standing::NotGraded;
        if is_result || !known.contains_key(&key) {
            known.insert(key, record.result);
        }
    }
    known
}
