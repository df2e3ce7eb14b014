//! The form of answers: lists whose order is free, trees that mean the same, one part of several.

use super::Evidence;
use crate::layout::layout;
use std::cmp::Ordering;

/// The shorter of two rows of numbers first, and of those of the same length by the first numbers that differ.
fn by_numbers(one: &[f64], other: &[f64]) -> Ordering {
    let mut each = one.iter().zip(other).map(|(a, b)| a.total_cmp(b));
    let by_length = one.len().cmp(&other.len());
    by_length.then_with(|| each.find(|order| order.is_ne()).unwrap_or(Ordering::Equal))
}

impl Evidence<'_> {
    /// Whether the judge takes lists in any order.
    pub(super) fn order_is_free(&self) -> bool {
        let mut tried = 0;
        for item in &self.items {
            let layout = layout(self.kind(), item.golden());
            let mut turned = item.golden().to_vec();
            // Nested lists may differ in length: one list is enough to know.
            if let Some(span) = layout.lists.first() {
                turned = layout.rearranged(&turned, span.list, &|n| (0..n).rev().collect());
            }
            if turned == item.golden() {
                continue;
            }
            tried += 1;
            if self
                .examiner
                .compare(&item.question, item.golden(), &turned)
                .is_err()
            {
                return false;
            }
            if tried == 5 {
                break;
            }
        }
        tried > 0
    }

    /// An answer whose lists are in one order, if their order is free.
    pub fn canonical(&self, question: &[f64], answer: &[f64]) -> Vec<f64> {
        let mut answer = self.examiner.canonical(question, answer);
        if !self.free {
            return answer;
        }
        // The innermost lists come first.
        let lists = layout(self.kind(), &answer).lists;
        let last = lists.iter().map(|span| span.list).max();
        for list in (0..last.map_or(0, |last| last + 1)).rev() {
            let layout = layout(self.kind(), &answer);
            for span in layout.lists.iter().filter(|span| span.list == list) {
                let places = span.elements.iter();
                let mut elements: Vec<_> = places.map(|place| &answer[place.clone()]).collect();
                elements.sort_by(|a, b| by_numbers(a, b));
                let start = span.count + 1;
                let flat = elements.concat();
                answer[start..start + flat.len()].copy_from_slice(&flat);
            }
        }
        answer
    }

    pub(super) fn same_shape(&self, one: &[f64], other: &[f64]) -> bool {
        let shape = |numbers: &[f64]| layout(self.kind(), numbers).shape(numbers);
        shape(one) == shape(other)
    }

    /// The golden answer with a part of another answer of the same shape.
    pub(super) fn projected(&self, part: usize, golden: &[f64], other: &[f64]) -> Option<Vec<f64>> {
        let here = layout(self.kind(), golden);
        let there = layout(self.kind(), other);
        if here.shape(golden) != there.shape(other) || here != there {
            return None;
        }
        let mut projected = golden.to_vec();
        for leaf in here.of_part(part) {
            projected[leaf.range()].copy_from_slice(&other[leaf.range()]);
        }
        Some(projected)
    }
}
