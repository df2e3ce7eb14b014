//! The cheapest cut of boxes in two.

use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::tree::area;
use crate::explain::view::{AXES, View, middle};
use crate::explain::way::Way;
use glam::{Vec3, dvec2};
use raybook_workbook::exercises::ch11_bvh::SahSplit;
use raybook_workbook::tree_rows::BoxRow;

/// A cut of boxes in two, and what it costs: the sum of area times number over both sides.
pub struct Cut {
    /// The axis that it crosses.
    pub axis: usize,
    /// The boxes on the left.
    pub left: Vec<u32>,
    /// The boxes on the right.
    pub right: Vec<u32>,
    /// The sum over both sides.
    pub cost: f64,
}

/// The box around some boxes.
pub fn around(boxes: &[BoxRow], some: &[u32]) -> [Vec3; 2] {
    let some = some.iter().map(|&i| &boxes[i as usize]);
    some.fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[min, max], b| {
        [min.min(b.min), max.max(b.max)]
    })
}

/// The cheapest cut of some boxes along an axis.
fn cut_along(way: &mut Way, boxes: &[BoxRow], some: &[u32], axis: usize) -> Option<Cut> {
    let mut sorted = some.to_vec();
    let mut middle = |i: u32| {
        let BoxRow { min, max } = &boxes[i as usize];
        let min = way.part("a box's least coordinate", f64::from(min[axis]));
        let max = way.part("a box's greatest coordinate", f64::from(max[axis]));
        way.part("the sum of a box's coordinates", min + max)
    };
    let mut keyed: Vec<_> = sorted.iter().map(|i| (middle(*i), *i)).collect();
    keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
    sorted.clear();
    sorted.extend(keyed.iter().map(|(_, i)| i));
    let cuts = way.rounds("the cuts along an axis", sorted.len().max(1) - 1);
    let cuts = cuts.map(|before| {
        let i = before + 1;
        let (left, right) = sorted.split_at(i);
        let within = way.part("the number of boxes in the left side's box", i as f64) as usize;
        let beyond = way.part("the number of boxes before the right side's box", i as f64) as usize;
        let around = |some: &[u32]| area(around(boxes, some));
        let of_left = around(sorted.get(..within).unwrap_or(left));
        let of_right = around(sorted.get(beyond..).unwrap_or(right));
        let of_left = way.part("the area of the left side's box", of_left);
        let of_right = way.part("the area of the right side's box", of_right);
        let left = way.part("the left side's number of boxes", left.len() as f64);
        let right = way.part("the right side's number of boxes", right.len() as f64);
        let left = way.part("the left side's area times its number", of_left * left);
        let right = way.part("the right side's area times its number", of_right * right);
        (i, way.part("the sum of both sides", left + right))
    });
    let mut cuts: Vec<_> = cuts.collect();
    let costs: Vec<_> = cuts.iter().map(|(_, cost)| *cost).collect();
    if cuts.is_empty() {
        return None;
    }
    let (i, cost) = cuts.swap_remove(way.least("the cheapest cut along an axis", &costs));
    let right = sorted.split_off(i);
    Some(Cut {
        axis,
        left: sorted,
        right,
        cost,
    })
}

/// The cheapest cut of some boxes along any axis, the steps to it written down.
pub fn best_cut(way: &mut Way, boxes: &[BoxRow], some: &[u32]) -> Option<Cut> {
    let axes = way.rounds("the axes", 3);
    let cuts = axes.map(|axis| way.silently(|way| cut_along(way, boxes, some, axis)));
    let mut cuts: Vec<_> = cuts.flatten().collect();
    for cut in &mut cuts {
        let (name, left, right) = (AXES[cut.axis], cut.left.len(), cut.right.len());
        let words = format!(
            "the best along {name}, {left} on the left and {right} on the right: areas times numbers"
        );
        cut.cost = way.number(words, "m²", cut.cost);
    }
    let costs: Vec<_> = cuts.iter().map(|cut| cut.cost).collect();
    let best = way.least("the cheapest of the axes", &costs);
    (best < cuts.len()).then(|| cuts.swap_remove(best))
}

impl Explained for SahSplit {
    fn work(&self, way: &mut Way) -> Vec<u32> {
        let all: Vec<_> = (0..self.boxes.len() as u32).collect();
        let Some(cut) = best_cut(way, &self.boxes, &all) else {
            way.remark("Fewer than two boxes cannot be cut.");
            return all;
        };
        way.remark(format!("The cheapest of them is along {}.", AXES[cut.axis]));
        cut.left
    }

    fn draw(&self, right: &Vec<u32>, yours: Option<&Vec<u32>>) -> Option<Diagram> {
        let all: Vec<_> = (0..self.boxes.len() as u32).collect();
        let [min, max] = around(&self.boxes, &all);
        let mut size = max.as_dvec3() - min.as_dvec3();
        // The axis of the cut is to be seen.
        if let Some(cut) = best_cut(&mut Way::default(), &self.boxes, &all) {
            size[cut.axis] = f64::INFINITY;
        }
        let view = View::least(size);
        let mut drawing = Diagram::new(format!(
            "The boxes by their numbers and the boxes around both sides, {}; marked are those on the left",
            view.words()
        ));
        for side in [true, false] {
            let some: Vec<_> = all
                .iter()
                .copied()
                .filter(|i| right.contains(i) == side)
                .collect();
            if !some.is_empty() {
                let corners = around(&self.boxes, &some).map(Vec3::as_dvec3);
                let ink = if side { Ink::Right } else { Ink::Shape };
                drawing.area(&view.rectangle(corners[0], corners[1]), ink);
            }
        }
        for (i, row) in (0..).zip(&self.boxes) {
            let seen = view.rectangle(row.min.as_dvec3(), row.max.as_dvec3());
            let mut outline = seen.to_vec();
            outline.push(seen[0]);
            drawing.line(&outline, Ink::Guide);
            let middle = middle(&seen);
            let ink = if right.contains(&i) {
                Ink::Right
            } else {
                Ink::Guide
            };
            drawing.point(middle, ink);
            if yours.is_some_and(|yours| yours.contains(&i)) {
                drawing.point(middle, Ink::Yours);
            }
            if self.boxes.len() <= 24 {
                drawing.label(middle, dvec2(0.9, 0.5), format!("{i}"), ink);
            }
        }
        Some(drawing)
    }
}
