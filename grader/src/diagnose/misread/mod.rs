//! Questions that were misread in a way that any question can be: two fields exchanged, a sign turned, a field ignored. The right
//! answer to the misread question is what many a mistake comes down to.

mod bounded;
mod ways;

use crate::layout::{Layout, Part, layout, parts};
pub use bounded::bounded;
use raybook_workbook::kind::Kind;
use ways::{of_axes, of_list, of_pair, of_part};

/// How far a question can be misread.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// See [`crate::Graded::POSITIVE`].
    pub positive: &'static [&'static str],
    /// See [`crate::Graded::FIXED`].
    pub fixed: &'static [&'static str],
    /// See [`crate::Graded::EFFORT`].
    pub effort: usize,
}

/// A way to misread a question.
pub struct Misreading {
    /// What it does, as a verb.
    pub name: String,
    /// A question that leads on.
    pub hint: String,
    /// How common it is: small numbers come first.
    pub rank: u32,
    how: How,
    /// The parts that must stay above 0.
    positive: Vec<usize>,
    /// The parts that are whole numbers: they do not become 0 unless they are.
    wholes: Vec<usize>,
}

impl Misreading {
    fn new(name: String, hint: String, rank: u32, how: How) -> Self {
        Self {
            name,
            hint,
            rank,
            how,
            positive: Vec::new(),
            wholes: Vec::new(),
        }
    }
}

/// A part of the question times a number, for each part that is there once.
pub fn times(kind: &'static Kind) -> Vec<Box<dyn Fn(f64) -> Misreading + Sync>> {
    let parts = parts(kind, "question").into_iter().enumerate();
    let is_number = |(_, part): &(usize, Part)| {
        part.list.is_none() && matches!(part.kind, Kind::Number | Kind::Numbers(_))
    };
    let of_part = |(i, part): (usize, Part)| -> Box<dyn Fn(f64) -> Misreading + Sync> {
        Box::new(move |by| {
            let change: Change = Box::new(move |v| v.iter_mut().for_each(|v| *v *= by));
            let name = format!("takes {by} times {}", part.name);
            Misreading::new(name, TIMES.to_owned(), RARE, How::Value(i, change))
        })
    };
    parts.filter(is_number).map(of_part).collect()
}

/// Rarer than what people are known to do.
const RARE: u32 = 27;

/// What leads on from a number that something is multiplied by.
const TIMES: &str =
    "Where does this number come into your function, and what is it multiplied by before?";

/// Changes the numbers of a value.
type Change = Box<dyn Fn(&mut [f64]) + Sync + Send>;

enum How {
    Each(usize, fn(f64) -> f64),
    Value(usize, Change),
    Pair(usize, usize, fn(&mut [f64], &mut [f64])),
    List(usize, fn(usize) -> Vec<usize>),
    /// All parts of these numbers, each by itself.
    All(Vec<usize>, Change),
}

impl Misreading {
    /// The question as it was misread; none if that changes nothing.
    pub fn read(&self, kind: &Kind, question: &[f64]) -> Option<Vec<f64>> {
        let layout = layout(kind, question);
        let mut read = question.to_vec();
        match &self.how {
            How::Each(part, f) => {
                for leaf in layout.of_part(*part) {
                    read[leaf.range()].iter_mut().for_each(|v| *v = f(*v));
                }
            }
            How::Value(part, f) => {
                for leaf in layout.of_part(*part) {
                    f(&mut read[leaf.range()]);
                }
            }
            How::All(parts, f) => {
                for leaf in parts.iter().flat_map(|part| layout.of_part(*part)) {
                    f(&mut read[leaf.range()]);
                }
            }
            How::Pair(one, other, f) => pair(&layout, *one, *other, &mut read, *f)?,
            How::List(list, which) => read = layout.rearranged(question, *list, &which),
        }
        if read.len() == question.len() {
            for leaf in layout
                .leaves
                .iter()
                .filter(|leaf| self.wholes.contains(&leaf.part))
            {
                let old = question[leaf.start];
                read[leaf.start] = read[leaf.start].max(old.min(1.0));
                if read[leaf.start] > 4.0 * old + 4.0 {
                    return None; // so many would take too long
                }
            }
        }
        // It may have lost elements of lists, but the parts above 0 stand in none.
        let sound = |part: &usize| {
            layout.of_part(*part).all(|leaf| {
                let mut both = question[leaf.range()].iter().zip(&read[leaf.range()]);
                both.all(|(old, new)| {
                    *new >= 0.25 * old.min(1.0) && *new > 0.0 && *new <= 4.0 * old.max(1.0)
                })
            })
        };
        (read != question && self.positive.iter().all(sound)).then_some(read)
    }

    /// The question as it was misread, or as it is where that changes nothing.
    pub fn read_or_not(&self, kind: &Kind, question: &[f64]) -> Vec<f64> {
        self.read(kind, question)
            .unwrap_or_else(|| question.to_vec())
    }
}

/// Changes two parts together: element by element if they are in a list.
fn pair(
    layout: &Layout,
    one: usize,
    other: usize,
    read: &mut [f64],
    f: fn(&mut [f64], &mut [f64]),
) -> Option<()> {
    let (ones, others): (Vec<_>, Vec<_>) = (
        layout.of_part(one).copied().collect(),
        layout.of_part(other).copied().collect(),
    );
    for (a, b) in ones.iter().zip(&others) {
        let (first, second) = if a.start < b.start { (a, b) } else { (b, a) };
        let (left, right) = read.split_at_mut(second.start);
        let (x, y) = (left.get_mut(first.range())?, right.get_mut(..second.len)?);
        if a.start < b.start { f(x, y) } else { f(y, x) }
    }
    Some(())
}

/// The common ways to misread a question of a kind.
pub fn misreadings(kind: &'static Kind, limits: Limits) -> Vec<Misreading> {
    let Limits {
        positive,
        fixed,
        effort,
    } = limits;
    if effort > 1 {
        return Vec::new();
    }
    let parts = parts(kind, "question");
    let mut all = Vec::new();
    // Whole numbers in a list are places in another: with others nothing would fit together any more.
    let fits = |part: &Part| part.list.is_none() || !matches!(part.kind, Kind::Whole);
    let linked = !parts.iter().all(fits);
    let free = |part: &Part| fits(part) && !fixed.contains(&part.name.as_str());
    for (i, part) in parts.iter().enumerate() {
        if free(part) {
            of_part(i, part, &mut all);
        }
    }
    for (i, one) in parts.iter().enumerate() {
        for (j, other) in parts.iter().enumerate().skip(i + 1) {
            if one.kind == other.kind && one.list == other.list && free(one) && free(other) {
                of_pair((i, one), (j, other), &mut all);
            }
        }
    }
    of_axes(&parts, &free, &mut all);
    let lists = parts.iter().filter_map(|part| part.list).max();
    for list in 0..lists.map_or(0, |last| last + 1) {
        let first = parts.iter().find(|part| part.list == Some(list));
        let name = first.map_or("list", |part| part.name.as_str());
        if !linked && !fixed.contains(&name) {
            of_list(list, name, &mut all);
        }
    }
    let above_0 = |(_, part): &(usize, &Part)| positive.contains(&part.name.as_str());
    let above_0: Vec<_> = parts
        .iter()
        .enumerate()
        .filter(above_0)
        .map(|(i, _)| i)
        .collect();
    let is_whole = |(_, part): &(usize, &Part)| matches!(part.kind, Kind::Whole);
    let wholes: Vec<_> = parts
        .iter()
        .enumerate()
        .filter(is_whole)
        .map(|(i, _)| i)
        .collect();
    for reading in &mut all {
        reading.positive.clone_from(&above_0);
        reading.wholes.clone_from(&wholes);
    }
    all
}
