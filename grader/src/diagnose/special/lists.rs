//! Lists whose elements are left out, doubled, in another order, or wrong at an end.

use super::{explanation, made};
use crate::diagnose::evidence::{Evidence, Item};
use crate::diagnose::fit::{Answers, Explanation};
use crate::explain::way::words;
use crate::layout::{Layout, Leaf, Part, Span, layout, parts};
use raybook_workbook::kind::Kind;
use std::cmp::Ordering;
use std::collections::{BTreeSet, HashMap};
use std::iter;

/// What may become of a list.
struct Change {
    rank: u32,
    name: &'static str,
    hint: &'static str,
    /// Of a list of n elements, the numbers of those that are returned, in their order.
    which: fn(usize) -> Vec<usize>,
}

macro_rules! changes {
    ($($rank:literal $name:literal $hint:literal: $which:expr;)+) => {
        const CHANGES: &[Change] = &[$(Change { rank: $rank, name: $name, hint: $hint, which: $which }),+];
    };
}

changes! {
    11 "returns the list backwards" "In which order is the list wanted, and in which do you make it?": |n| (0..n).rev().collect();
    11 "leaves out the first of the list" "Where does your loop begin?": |n| (1..n).collect();
    11 "leaves out the last of the list" "Where does your loop end?": |n| (0..n.saturating_sub(1)).collect();
    12 "returns the first of the list only" "What makes your loop end?": |n| (0..n.min(1)).collect();
    12 "returns the last of the list only" "Is the list overwritten in every round?": |n| (n.saturating_sub(1)..n).collect();
    12 "returns the first half of the list only" "What makes your loop end?": |n| (0..n / 2).collect();
    12 "returns every second of the list only" "By how much does your counter grow in a round?": |n| (0..n).step_by(2).collect();
    12 "returns an empty list" "Is anything ever appended to your list?": |_| Vec::new();
    12 "returns the last of the list twice" "Where does your loop end?": |n| (0..n).chain(n.checked_sub(1)).collect();
    12 "returns the first of the list twice" "Is the first appended before the loop and in it?": |n| (0..n.min(1)).chain(0..n).collect();
    12 "returns everything in the list twice" "How often is each appended?": |n| (0..n).chain(0..n).collect();
    12 "exchanges the first two of the list" "In which order are the first two of the list wanted?":
        |n| if n < 2 { (0..n).collect() } else { [1, 0].into_iter().chain(2..n).collect() };
    12 "exchanges the last two of the list" "In which order are the last two of the list wanted?":
        |n| if n < 2 { (0..n).collect() } else { (0..n - 2).chain([n - 1, n - 2]).collect() };
    12 "leaves out the second of the list" "Where does your loop begin?": |n| (0..n).filter(|i| *i != 1).collect();
    12 "leaves out the last two of the list" "Where does your loop end?": |n| (0..n.saturating_sub(2)).collect();
    13 "begins the list with its second element, and ends it with the first" "Where does your loop begin?":
        |n| (1..n).chain(0..n.min(1)).collect();
    13 "begins the list with its last element" "Where does your loop begin?":
        |n| (n.saturating_sub(1)..n).chain(0..n.saturating_sub(1)).collect();
}

pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let lists = Lists::of(evidence, base);
    let count = lists.layouts.iter().flatten().flat_map(|of| &of.lists);
    let count = count.map(|span| span.list + 1).max();
    let mut all = Vec::new();
    for list in 0..count.unwrap_or(0) {
        for change in CHANGES {
            let answers = made(base, |i, base| {
                Some(
                    lists.layouts[i]
                        .as_ref()?
                        .rearranged(base, list, &change.which),
                )
            });
            all.push(explanation(change.rank, change.name, change.hint, answers));
        }
        all.push(lists.sorted(list));
        all.extend(lists.cut_short(list));
        all.extend(lists.one_of_each(list));
        all.extend(lists.without_an_end(list));
        all.extend(lists.without_one_of(list));
        all.extend(lists.wrong_at_an_end(list));
        all.extend(lists.moved_on(list));
    }
    all
}

/// The lists of all answers.
struct Lists<'a, 'e> {
    evidence: &'a Evidence<'e>,
    base: &'a Answers,
    /// Of each right answer.
    layouts: Vec<Option<Layout>>,
}

impl<'a, 'e> Lists<'a, 'e> {
    fn of(evidence: &'a Evidence<'e>, base: &'a Answers) -> Self {
        let kind = evidence.examiner.asked().answer.kind;
        let layouts = base.iter().map(|row| Some(layout(kind, row.as_ref()?)));
        Self {
            evidence,
            base,
            layouts: layouts.collect(),
        }
    }

    /// The wrong items.
    fn wrong(&self) -> &[Item] {
        &self.evidence.items[..self.evidence.wrong]
    }

    /// The list of this number in an item's right answer, if it is there once.
    fn span(&self, item: usize, list: usize) -> Option<&Span> {
        span(self.layouts[item].as_ref()?, list)
    }

    /// The elements that the list has in a student's answer, if it is there once.
    fn got<'i>(&self, item: &'i Item, list: usize) -> Option<Vec<&'i [f64]>> {
        let kind = self.evidence.examiner.asked().answer.kind;
        let fields = layout(kind, &item.got);
        let elements = span(&fields, list)?.elements.iter();
        Some(elements.map(|place| &item.got[place.clone()]).collect())
    }

    /// The answers with other elements in a list: `which` is given the item and the right elements, and says which of them, in which order.
    fn remade(&self, list: usize, which: impl Fn(usize, &[&[f64]]) -> Vec<usize>) -> Answers {
        made(self.base, |i, base| {
            let places = self.span(i, list)?.elements.iter();
            let elements: Vec<_> = places.map(|place| &base[place.clone()]).collect();
            let which = |_| which(i, &elements);
            Some(self.layouts[i].as_ref()?.rearranged(base, list, &which))
        })
    }

    fn sorted(&self, list: usize) -> Explanation {
        let answers = self.remade(list, |_, elements| {
            let mut order: Vec<_> = (0..elements.len()).collect();
            order.sort_by(|a, b| by_numbers(elements[*a], elements[*b]));
            order
        });
        let hint = "In which order is the list wanted?";
        explanation(13, "sorts the list", hint, answers)
    }

    /// A list that has as many elements at most as all of the wrong ones have.
    fn cut_short(&self, list: usize) -> Option<Explanation> {
        let mut most = None;
        for item in self.wrong() {
            let count = self.got(item, list)?.len();
            if count < 2 || *most.get_or_insert(count) != count {
                return None;
            }
        }
        let most = most?;
        let answers = self.remade(list, |_, all| (0..all.len().min(most)).collect());
        let name = format!("returns the first {most} of the list at most");
        let hint = "What makes your loop end, and how long may the list be?";
        Some(explanation(12, name, hint, answers))
    }

    /// Lists in which only one is left of those that have all numbers but the last in common.
    fn one_of_each(&self, list: usize) -> Vec<Explanation> {
        let parts = self.whole_parts(list).filter(|parts| parts.len() > 1);
        let Some((_, last)) = parts.as_ref().and_then(|parts| parts.last()) else {
            return Vec::new();
        };
        let explained = |(end, before): (&str, Ordering)| {
            let answers = self.remade(list, |_, elements| {
                let mut best: HashMap<Vec<u64>, usize> = HashMap::new();
                for (k, element) in elements.iter().enumerate() {
                    let Some((own, key)) = element.split_last() else {
                        continue;
                    };
                    let kept = best.entry(key.iter().map(|v| v.to_bits()).collect());
                    let kept = kept.or_insert(k);
                    if own.total_cmp(&elements[*kept][key.len()]) == before {
                        *kept = k;
                    }
                }
                let mut order: Vec<_> = best.into_values().collect();
                order.sort_unstable();
                order
            });
            let name =
                format!("returns the {end} only of those in the list that differ in {last} alone");
            let hint =
                "May there be several of these? What becomes of the others in your function?";
            explanation(12, name, hint, answers)
        };
        let ends = [("first", Ordering::Less), ("last", Ordering::Greater)];
        ends.into_iter().map(explained).collect()
    }

    /// Lists without those that name the first or the last of a list of the question.
    fn without_one_of(&self, list: usize) -> Vec<Explanation> {
        let kind = self.evidence.examiner.asked().question;
        let of = parts(kind, "question").into_iter();
        let of: BTreeSet<_> = of.filter_map(|part| part.list).collect();
        let (Some(parts), 1) = (self.whole_parts(list), of.len()) else {
            return Vec::new();
        };
        let count = |item: &Item| {
            let fields = layout(kind, &item.question);
            fields.lists.first().map_or(0, |span| span.elements.len())
        };
        let counts: Vec<_> = self.evidence.items.iter().map(count).collect();
        let mut all = Vec::new();
        for (at, name) in parts {
            for (end, is_last) in [("first", false), ("last", true)] {
                let answers = self.remade(list, |i, elements| {
                    let out = if is_last { counts[i] as f64 - 1.0 } else { 0.0 };
                    let is_in = |k: &usize| elements[*k][at] != out;
                    (0..elements.len()).filter(is_in).collect()
                });
                let name =
                    format!("leaves out of the list what belongs to the {end} of all: {name}");
                all.push(explanation(12, name, LOOP, answers));
            }
        }
        all
    }

    /// Lists without those that have the first or the last number along an axis, where the question says how many there are.
    fn without_an_end(&self, list: usize) -> Vec<Explanation> {
        let Some(axes) = self.whole_parts(list) else {
            return Vec::new();
        };
        let kind = self.evidence.examiner.asked().question;
        let counts = parts(kind, "question");
        let counts = counts.iter().enumerate();
        let counts = counts.filter(|(_, part)| part.list.is_none() && is_whole(part));
        let counts: Vec<_> = counts.collect();
        if counts.len() != axes.len() {
            return Vec::new();
        }
        // The number of the last along each axis.
        let lasts = |i: usize| {
            let question = &self.evidence.items[i].question;
            let fields = layout(kind, question);
            let count = |(part, _): &(usize, &Part)| {
                let leaf = fields.of_part(*part).next();
                leaf.map_or(0.0, |leaf| question[leaf.start] - 1.0)
            };
            counts.iter().map(count).collect::<Vec<_>>()
        };
        let lasts: Vec<_> = (0..self.evidence.items.len()).map(lasts).collect();
        let mut all = Vec::new();
        let singles = (0..axes.len()).map(|axis| axis..axis + 1);
        for along in singles.chain(iter::once(0..axes.len())) {
            let names: Vec<_> = axes[along.clone()]
                .iter()
                .map(|(_, name)| &**name)
                .collect();
            let names = names.join(", ");
            for (end, is_last) in [("first", false), ("last", true)] {
                let answers = self.remade(list, |i, elements| {
                    let is_in = |k: &usize| {
                        along.clone().all(|axis| {
                            let end = if is_last { lasts[i][axis] } else { 0.0 };
                            elements[*k][axes[axis].0] != end
                        })
                    };
                    (0..elements.len()).filter(is_in).collect()
                });
                let name = format!("leaves out of the list what is the {end} along {names}");
                all.push(explanation(12, name, LOOP, answers));
            }
        }
        all
    }

    /// Lists of which the first or the last element is the same in all wrong answers.
    fn wrong_at_an_end(&self, list: usize) -> Vec<Explanation> {
        let explained = |(end, is_last): (&str, bool)| {
            let at = |n: usize| if is_last { n - 1 } else { 0 };
            let mut all = self.wrong().iter().map(|item| {
                let elements = self.got(item, list)?;
                (!elements.is_empty()).then(|| elements[at(elements.len())])
            });
            let value = all.next()??;
            if value.is_empty() || !all.all(|other| other == Some(value)) {
                return None;
            }
            let answers = made(self.base, |i, base| {
                let elements = &self.span(i, list)?.elements;
                let mut made = base.to_vec();
                if !elements.is_empty() {
                    let place = elements[at(elements.len())].clone();
                    (place.len() == value.len()).then(|| made[place].copy_from_slice(value))?;
                }
                Some(made)
            });
            let name = format!(
                "returns {} for the {end} of the list, whatever it is",
                words(value)
            );
            let mut one = explanation(12, name, LOOP, answers);
            one.fitted = 1;
            Some(one)
        };
        let ends = [("first", false), ("last", true)];
        ends.into_iter().filter_map(explained).collect()
    }

    /// Lists with numbers that belong to the element before or after, or are counted from that before, or summed up. What stands at the
    /// end, where there is none before or after, is taken as it came.
    fn moved_on(&self, list: usize) -> Vec<Explanation> {
        /// What is made of a number, of the same one of the element before, and of what was made of that.
        type Of = fn(f64, f64, f64) -> f64;
        let ways: [(&str, bool, Of); 4] = [
            (
                "returns for {} what belongs to the element before",
                true,
                |_, before, _| before,
            ),
            (
                "returns for {} what belongs to the element after",
                false,
                |_, after, _| after,
            ),
            (
                "returns for {} the difference from the element before",
                true,
                |v, before, _| v - before,
            ),
            (
                "returns for {} the sum of all elements up to it",
                true,
                |v, _, sum| v + sum,
            ),
        ];
        let mut all = Vec::new();
        for (part, of) in self.evidence.parts.iter().enumerate() {
            if of.list != Some(list) {
                continue;
            }
            for (what, is_before, make) in ways {
                let answers = made(self.base, |i, base| {
                    let fields = self.layouts[i].as_ref()?;
                    let places: Vec<_> = fields.of_part(part).map(Leaf::range).collect();
                    let got = &self.evidence.items[i].got;
                    let mut made = base.to_vec();
                    for (k, place) in places.iter().enumerate() {
                        let other = if is_before {
                            k.checked_sub(1).map(|k| &places[k])
                        } else {
                            places.get(k + 1)
                        };
                        for (n, at) in place.clone().enumerate() {
                            made[at] = match other {
                                Some(other) => {
                                    let other = other.start + n;
                                    make(base[at], base[other], made[other])
                                }
                                None if got.len() == base.len() => got[at],
                                None => base[at],
                            };
                        }
                    }
                    Some(made)
                });
                all.push(explanation(12, what.replace("{}", &of.name), LOOP, answers));
            }
        }
        all
    }

    /// Where the numbers of a list's elements stand in these, and what they are called, if all are whole.
    fn whole_parts(&self, list: usize) -> Option<Vec<(usize, String)>> {
        let parts = self
            .evidence
            .parts
            .iter()
            .filter(|part| part.list == Some(list));
        let parts: Vec<_> = parts.collect();
        let named = parts
            .iter()
            .enumerate()
            .map(|(i, part)| (i, part.name.clone()));
        parts
            .iter()
            .all(|part| is_whole(part))
            .then(|| named.collect())
    }
}

/// What leads on from an end of a list.
const LOOP: &str = "Where does your loop begin, where does it end, and which value does it use in the first round and in the last?";

fn is_whole(part: &Part) -> bool {
    matches!(part.kind, Kind::Whole)
}

/// The list of this number, if it is there once.
fn span(of: &Layout, list: usize) -> Option<&Span> {
    let mut spans = of.lists.iter().filter(|span| span.list == list);
    let span = spans.next()?;
    spans.next().is_none().then_some(span)
}

fn by_numbers(one: &[f64], other: &[f64]) -> Ordering {
    let first = one.iter().zip(other).map(|(a, b)| a.total_cmp(b));
    first.fold(Ordering::Equal, Ordering::then)
}
