//! Hand-ins that are nearly identical, found by winnowing (Schleimer, Wilkerson and Aiken, "Winnowing: Local Algorithms for
//! Document Fingerprinting", 2003).
//!
//! Every run of `RUN` tokens has a number. Of each `WINDOW` numbers in a row the smallest is kept, the last of equal ones. Whatever two
//! hand-ins have in common that is at least `RUN + WINDOW - 1` tokens long has a kept number in common. Names do not count, so that
//! renaming changes nothing. What every student was given, the starter, and the references are taken out.

use super::hand_in::HandIn;
use super::tokens::{Token, tokens};
use crate::language::Language;
use crate::reader::{cpp, python};
use crate::starter::StarterFile;
use crate::{cases, library, starter};
use raybook_workbook::exercise::Asked;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

/// Tokens in a run. What is shorter is everybody's: a loop over three axes is about as long.
const RUN: usize = 20;

/// Numbers of which one is kept.
const WINDOW: usize = 16;

/// The numbers that are kept of a hand-in.
pub type Prints = BTreeSet<u64>;

/// Hand-ins with fewer numbers are too short to compare.
const FEWEST: usize = 8;

/// At least so large a part of the smaller hand-in must be in the other.
pub const ALIKE: f64 = 0.5;

/// Two hand-ins that are alike.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// The students.
    pub students: [String; 2],
    /// How much of the smaller hand-in's own part is in the other: 1 is all of it.
    pub share: f64,
}

/// The numbers that are kept of the tokens of a hand-in, without those of the starter and the references.
pub fn prints(language: Language, handed_in: &[Token]) -> Prints {
    let given = given(language);
    let mut prints = winnow(handed_in);
    prints.retain(|print| !given.contains(print));
    prints
}

/// Pairs of hand-ins that are alike, the most alike first.
pub fn pairs(hand_ins: &[HandIn]) -> Vec<Pair> {
    let contents: Vec<_> = hand_ins
        .iter()
        .filter_map(|hand_in| Some((&hand_in.student, hand_in.content.as_ref().ok()?)))
        .collect();
    // A number that many have is common knowledge: it would also make the work grow with the square of the class.
    let most = contents.len() / 4 + 5;
    let mut having: BTreeMap<u64, Vec<usize>> = BTreeMap::new();
    for (i, (_, content)) in contents.iter().enumerate() {
        for print in &content.similar {
            having.entry(*print).or_default().push(i);
        }
    }
    having.retain(|_, who| who.len() <= most);
    let mut own = vec![0_usize; contents.len()];
    let mut common: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for who in having.values() {
        for (at, &a) in who.iter().enumerate() {
            own[a] += 1;
            for &b in &who[at + 1..] {
                *common.entry((a, b)).or_default() += 1;
            }
        }
    }
    let of = |((a, b), common): ((usize, usize), usize)| {
        let smaller = own[a].min(own[b]);
        (smaller >= FEWEST).then(|| Pair {
            students: [a, b].map(|i| contents[i].0.clone()),
            share: common as f64 / smaller as f64,
        })
    };
    let mut pairs: Vec<_> = common
        .into_iter()
        .filter_map(of)
        .filter(|pair| pair.share >= ALIKE)
        .collect();
    pairs.sort_by(|a, b| {
        b.share
            .total_cmp(&a.share)
            .then_with(|| a.students.cmp(&b.students))
    });
    pairs
}

/// Of each window the smallest number, the last of equal ones.
fn winnow(tokens: &[Token]) -> Prints {
    let numbers: Vec<u64> = tokens
        .windows(RUN)
        .map(|run| {
            run.iter().fold(0_u64, |number, token| {
                number
                    .wrapping_mul(0x100_0000_01b3)
                    .wrapping_add(token.kind)
            })
        })
        .map(|number| number ^ (number >> 29))
        .collect();
    let window = WINDOW.min(numbers.len().max(1));
    let kept = numbers
        .windows(window)
        .filter_map(|window| window.iter().min().copied());
    kept.collect()
}

/// All runs of what students are given: starters, readers and references. Any of their numbers, kept there or not, is taken out.
fn given(language: Language) -> &'static BTreeSet<u64> {
    static GIVEN: [OnceLock<BTreeSet<u64>>; 3] = [const { OnceLock::new() }; 3];
    GIVEN[language as usize].get_or_init(|| {
        let starter = starter::given(language).unwrap_or_default();
        let texts: Vec<String> = match language {
            Language::Rust => {
                let rust = starter
                    .iter()
                    .filter(|(path, _)| path.extension().is_some_and(|e| e == "rs"));
                let starter = rust.map(|(_, bytes)| String::from_utf8_lossy(bytes).into_owned());
                let source = library::source().into_iter();
                let references =
                    source.filter_map(|file| Some(library::without_anchors(file.contents_utf8()?)));
                starter.chain(references).collect()
            }
            Language::Python => others(language, python::program, starter),
            Language::Cpp => others(language, cpp::program, starter),
        };
        let numbers = |text: String| {
            let tokens = tokens(language, &text);
            let mut all = Prints::new();
            for run in tokens.windows(RUN) {
                all.extend(winnow(run));
            }
            all
        };
        texts.into_iter().flat_map(numbers).collect()
    })
}

/// The texts of the readers, the references and the starter of another language than the course's own.
fn others(
    language: Language,
    reader: fn(&Asked) -> String,
    starter: &[StarterFile],
) -> Vec<String> {
    let all = cases::all().into_iter();
    let given = all.flat_map(|examiner| {
        let reader = reader(examiner.asked());
        let reference = starter::reference(language, examiner.name());
        [Some(reader), reference].into_iter().flatten()
    });
    let starter = starter.iter();
    given
        .chain(starter.map(|(_, bytes)| String::from_utf8_lossy(bytes).into_owned()))
        .collect()
}
