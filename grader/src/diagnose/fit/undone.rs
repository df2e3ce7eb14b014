//! Changes that are taken back: where many answers are right, a wrong one is no function of the golden one, but of another right one, and
//! without the change it is right again.

use super::orders::orders_of;
use super::{Answers, Explanation, FACTORS, Maker};
use crate::diagnose::evidence::{Evidence, Item};
use crate::diagnose::function::FUNCTIONS;
use crate::diagnose::number::named;
use crate::layout::{each, layout};

/// Fewer wrong answers than these are made right by one change or another by chance.
const ENOUGH: usize = 3;

/// A change of the numbers of a part.
type Change = Box<dyn Fn(&mut [f64])>;

/// A change that can be taken back.
struct Undone {
    name: String,
    hint: &'static str,
    rank: u32,
    make: Change,
    back: Change,
}

/// The explanations by a change of one part without which the wrong answers are right.
pub fn undone(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = Vec::new();
    if evidence.wrong < ENOUGH {
        return all;
    }
    for part in super::scoped(evidence) {
        let maker = Maker::new(evidence, base, part, super::called(evidence, part));
        if maker.is_whole() {
            continue;
        }
        let changes = maker.changes();
        all.extend(changes.into_iter().filter_map(|one| maker.explained(one)));
    }
    all
}

impl Maker<'_, '_> {
    /// The changes of a part that can be taken back.
    fn changes(&self) -> Vec<Undone> {
        let mut all = Vec::new();
        for function in FUNCTIONS {
            if let Some(back) = function.back {
                let of = function.of;
                all.push(Undone {
                    name: function.name.replace("the answer", &self.of),
                    hint: function.hint,
                    rank: function.rank,
                    make: Box::new(move |v| each(v, |v| *v = of(*v))),
                    back: Box::new(move |v| each(v, |v| *v = back(*v))),
                });
            }
        }
        for factor in FACTORS.iter().flat_map(|factor| [*factor, 1.0 / factor]) {
            all.push(Undone {
                name: format!("returns {} times {}", named(factor), self.of),
                hint: super::CONSTANT,
                rank: 9,
                make: Box::new(move |v| each(v, |v| *v *= factor)),
                back: Box::new(move |v| each(v, |v| *v /= factor)),
            });
        }
        for shift in [0.5, -0.5, 1.0, -1.0] {
            let (verb, size) = if shift < 0.0 {
                ("subtracts", -shift)
            } else {
                ("adds", shift)
            };
            let to = if shift < 0.0 { "from" } else { "to" };
            all.push(Undone {
                name: format!("{verb} {} {to} each number of {}", named(size), self.of),
                hint: "Where is 0 in what is asked for, and where in your answer?",
                rank: 12,
                make: Box::new(move |v| each(v, |v| *v += shift)),
                back: Box::new(move |v| each(v, |v| *v -= shift)),
            });
        }
        all.extend(self.turned());
        all
    }

    /// The same components in another order or with other signs.
    fn turned(&self) -> Vec<Undone> {
        let is_whole = |order: &&&[usize]| (0..order.len()).all(|k| order.contains(&k));
        let orders = orders_of(self.axes().len()).iter().filter(is_whole);
        let all = orders.flat_map(|order| self.signs().map(move |signs| (*order, signs)));
        let all = all.filter_map(|(order, signs)| {
            let (name, rank) = self.order_called(order, signs)?;
            let sign = move |k: usize| super::orders::sign(signs, k);
            Some(Undone {
                name,
                hint: super::orders::ALONG_AN_AXIS,
                rank,
                make: Box::new(move |v| {
                    let old = v.to_vec();
                    for (k, from) in order.iter().enumerate() {
                        v[k] = sign(k) * old[*from];
                    }
                }),
                back: Box::new(move |v| {
                    let old = v.to_vec();
                    for (k, from) in order.iter().enumerate() {
                        v[*from] = sign(k) * old[k];
                    }
                }),
            })
        });
        all.collect()
    }

    /// The explanation by a change, if the wrong answers that are looked at first are right without it.
    fn explained(&self, one: Undone) -> Option<Explanation> {
        let evidence = self.evidence;
        let few = evidence.items[..evidence.wrong].iter().take(ENOUGH);
        // An answer that is wrong beside the others only needs no change to be right by itself.
        let is_mended = |item: &Item| {
            let mended = self.changed(&item.got, &*one.back);
            (item.right || !evidence.is_right(item, &item.got)) && evidence.is_right(item, &mended)
        };
        if !few.into_iter().all(is_mended) {
            return None;
        }
        let answer = |item: &Item| {
            if is_mended(item) {
                item.got.clone()
            } else {
                self.changed(item.golden(), &*one.make)
            }
        };
        let answers = evidence.items.iter().map(|item| Some(answer(item)));
        Some(Explanation {
            answers: answers.collect(),
            name: one.name,
            hint: one.hint.to_owned(),
            rank: one.rank,
            fitted: 0,
        })
    }

    /// An answer with this part of it changed.
    fn changed(&self, answer: &[f64], change: &dyn Fn(&mut [f64])) -> Vec<f64> {
        let mut changed = answer.to_vec();
        let kind = self.evidence.examiner.asked().answer.kind;
        for leaf in layout(kind, answer).of_part(self.part) {
            change(&mut changed[leaf.range()]);
        }
        changed
    }
}
