//! `sah_split`: random questions, judge and mistakes.

mod choices;

use super::{area, around, center, crowd, heaps, no_dearer, whole_less_left};
use crate::{Flaw, Graded, Mistake, Relation, Verdict, judge, sample, traits};
use choices::{
    between_buckets, cheapest, cut_with, fewer_faces, first_best, least, longest, once,
    sorted_again, split, sum,
};
use glam::Vec3;
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercises::ch11_bvh::SahSplit;
use raybook_workbook::tree_rows::BoxRow;

/// All cuts between neighbouring centres along an axis: the axis, and who is on the left and on the right.
pub(super) fn cuts(boxes: &[BoxRow], key: fn(&BoxRow) -> Vec3) -> Vec<(usize, [Vec<u32>; 2])> {
    let mut cuts = Vec::new();
    for axis in 0..3 {
        let mut order: Vec<_> = (0..boxes.len() as u32).collect();
        order.sort_by(|&a, &b| {
            key(&boxes[a as usize])[axis].total_cmp(&key(&boxes[b as usize])[axis])
        });
        for left in 1..boxes.len() {
            let (left, right) = order.split_at(left);
            cuts.push((axis, [left.to_vec(), right.to_vec()]));
        }
    }
    cuts
}

/// The box of a side, and how many are in it.
fn whole(q: &SahSplit, side: &[u32]) -> (Aabb, f32) {
    (around(&q.boxes, side), side.len() as f32)
}

/// What a side costs.
fn sah_of(q: &SahSplit, side: &[u32]) -> f32 {
    let (bounds, count) = whole(q, side);
    sah(&bounds, count)
}

fn sah(bounds: &Aabb, count: f32) -> f32 {
    area(bounds.min, bounds.max) * count
}

fn split_cost(q: &SahSplit, left: &[u32]) -> Result<f32, String> {
    let n = q.boxes.len() as u32;
    if let Some(i) = left.iter().find(|&&i| i >= n) {
        return Err(format!("there is no box {i}: there are {n}, from 0"));
    }
    if let Some(twice) = (0..n).find(|i| left.iter().filter(|j| *j == i).count() > 1) {
        return Err(format!("box {twice} is on the left more than once"));
    }
    let right: Vec<_> = (0..n).filter(|i| !left.contains(i)).collect();
    if left.is_empty() || right.is_empty() {
        return Err("all boxes are on the same side".to_owned());
    }
    Ok(sah_of(q, left) + sah_of(q, &right))
}

/// Whether along some axis no box of a side has its centre behind that of a box on the other side, but for rounding.
fn is_a_left_side(q: &SahSplit, left: &[u32]) -> bool {
    let all = 0..q.boxes.len() as u32;
    let (left, right): (Vec<_>, Vec<_>) = all.partition(|i| left.contains(i));
    (0..3).any(|axis| {
        let place = |i: &u32| center(&q.boxes[*i as usize])[axis];
        let last = left.iter().map(place).fold(f32::NEG_INFINITY, f32::max);
        let first = right.iter().map(place).fold(f32::INFINITY, f32::min);
        last - first <= judge::RELATIVE * last.abs().max(first.abs()).max(1.0)
    })
}

impl Graded for SahSplit {
    fn random(rng: &mut Pcg) -> SahSplit {
        SahSplit { boxes: heaps(rng) }
    }

    fn crowded(rng: &mut Pcg, count: usize) -> Option<SahSplit> {
        Some(SahSplit {
            boxes: crowd(rng, count),
        })
    }

    fn is_sound(q: &SahSplit) -> bool {
        q.boxes.iter().all(|b| sample::is_box(b.min, b.max))
    }

    fn judge(q: &SahSplit, golden: &Vec<u32>, got: &Vec<u32>) -> Verdict {
        let (best, cost) = (split_cost(q, golden)?, split_cost(q, got)?);
        no_dearer("this split", cost, best, judge::RELATIVE)?;
        if is_a_left_side(q, got) {
            Ok(())
        } else {
            Err("the cut is right, but the numbers are those of its right side".to_owned())
        }
    }

    fn traits(q: &SahSplit, got: &Vec<u32>) -> Vec<f64> {
        let n = q.boxes.len().max(1) as f64;
        let left = got.len() as f64 / n;
        let cost = split_cost(q, got);
        let known = f64::from(cost.is_ok());
        vec![
            left.min(1.0 - left),
            cost.map_or(0.0, |cost| traits::log(cost.into())),
            known,
        ]
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "there is no box",
            name: "counts the boxes from 1",
            hint: "What is the number of the first box?",
        },
        Flaw {
            complaint: "is on the left more than once",
            name: "names a box twice",
            hint: "How often is each box appended to the left side?",
        },
        Flaw {
            complaint: "those of its right side",
            name: "returns the boxes on the right of the cut",
            hint: "Which end of the sorted row is the left one: the one with the least coordinates, or the other?",
        },
        Flaw {
            complaint: "all boxes are on the same side",
            name: "puts all boxes on the same side",
            hint: "A split has two sides: which cuts do you try, and is one of them no cut at all?",
        },
        Flaw {
            complaint: "% more than",
            name: "does not find the cheapest split",
            hint: "Of each cut: is its cost the area of a side's box times the number of boxes in it, summed over both sides? Do you try all three axes and all places between the sorted centres, and take the least?",
        },
    ];

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| SahSplit {
        boxes: q.boxes.iter().map(sample::moved_box).collect(),
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "stops along an axis at the first cut that is no better than the best so far",
            hint: "The cost rises from one cut to the next: may it fall again behind that?",
            answer: first_best,
        },
        Mistake {
            name: "returns the boxes on the right of the cut",
            hint: "Which end of the sorted row is the left one: the one with the least coordinates, or the other?",
            answer: |q| {
                let left = SahSplit::right(q);
                let all = 0..q.boxes.len() as u32;
                all.filter(|i| !left.contains(i)).collect()
            },
        },
        Mistake {
            name: "returns the first boxes in the order of the axis that was sorted last",
            hint: "The cheapest cut belongs to an axis: in which order are the boxes when you return those on its left?",
            answer: |q| {
                let left = split(q, |_| {}).len();
                let last = cuts(&q.boxes, center).into_iter().rev();
                let mut last = last.map(|(_, sides)| sides.concat());
                last.next()
                    .map_or(Vec::new(), |order| order[..left].to_vec())
            },
        },
        Mistake {
            name: "puts half of the boxes on each side",
            hint: "One box lies far away from nine others: should any of the nine share a side with it?",
            answer: |q| {
                cut_with(q, |q, _, axis, [left, right]| {
                    let off = left.len().abs_diff(right.len());
                    off as f32 + if axis == longest(q) { 0.0 } else { 100.0 }
                })
            },
        },
        Mistake {
            name: "tries only the cut in the middle of each axis's row",
            hint: "One box lies far away from nine others: is the cheapest cut that which leaves five boxes on each side?",
            answer: |q| {
                cut_with(q, |q, side, _, sides| {
                    let is_middle = sides[0].len() == q.boxes.len() / 2;
                    if is_middle {
                        sum(q, side, 0, sides)
                    } else {
                        f32::INFINITY
                    }
                })
            },
        },
        Mistake {
            name: "looks for the cut whose sides overlap least",
            hint: "Two sides that do not overlap may be large all the same: what does a ray pay for a side that it meets?",
            answer: |q| {
                cut_with(q, |q, _, _, [left, right]| {
                    let [left, right] = [left, right].map(|side| around(&q.boxes, side));
                    let (min, max) = (left.min.max(right.min), left.max.min(right.max));
                    (max - min).max(Vec3::ZERO).element_product()
                })
            },
        },
        Mistake {
            name: "looks for two sides that cost the same, and not for the least sum",
            hint: "A side's cost is what a ray pays that meets it: is it well spent where both are high?",
            answer: |q| {
                cut_with(q, |q, _, _, sides| {
                    let [left, right] =
                        [0, 1].map(|i| sah(&around(&q.boxes, &sides[i]), sides[i].len() as f32));
                    (left - right).abs()
                })
            },
        },
        Mistake {
            name: "returns places in the sorted row instead of the boxes' numbers",
            hint: "After sorting, which box is at the first place, and what was its number before?",
            answer: |q| {
                let left = Self::misread(q, |_| {}).len() as u32;
                (0..left).collect()
            },
        },
        Mistake {
            name: "tries the longest axis only",
            hint: "Is the best cut always across the longest side?",
            answer: |q| {
                cut_with(q, |q, side, axis, sides| {
                    if axis == longest(q) {
                        sum(q, side, 0, sides)
                    } else {
                        f32::INFINITY
                    }
                })
            },
        },
        Mistake {
            name: "tries the x axis only",
            hint: "Stack the boxes along y: where do you cut?",
            answer: |q| {
                cut_with(q, |q, side, axis, sides| {
                    if axis == 0 {
                        sum(q, side, 0, sides)
                    } else {
                        f32::INFINITY
                    }
                })
            },
        },
        Mistake {
            name: "does not multiply by the number of shapes",
            hint: "What does a ray that meets a side's box do there, and how often?",
            answer: |q| {
                least(q, |q, side| {
                    let (bounds, _) = whole(q, side);
                    area(bounds.min, bounds.max)
                })
            },
        },
        Mistake {
            name: "weighs by volume",
            hint: "How large is the chance that a ray meets a flat box, which has no volume?",
            answer: |q| {
                least(q, |q, side| {
                    let (bounds, count) = whole(q, side);
                    bounds.size().element_product() * count
                })
            },
        },
        Mistake {
            name: "weighs by the longest side",
            hint: "How many lines meet a box depends on its surface area, not on a length: what do you weigh by?",
            answer: |q| {
                least(q, |q, side| {
                    let (bounds, count) = whole(q, side);
                    bounds.size().max_element() * count
                })
            },
        },
        Mistake {
            name: "adds the extents for the area",
            hint: "In which unit is an area, and in which is your sum?",
            answer: |q| {
                least(q, |q, side| {
                    let (bounds, count) = whole(q, side);
                    bounds.size().element_sum() * count
                })
            },
        },
        Mistake {
            name: "takes the most expensive cut",
            hint: "A cost is something to keep small: which way round do you compare?",
            answer: |q| {
                least(q, |q, side| {
                    let (bounds, count) = whole(q, side);
                    -sah(&bounds, count)
                })
            },
        },
        Mistake {
            name: "cuts off a single box",
            hint: "If the left side has one box, how much work is left on the right?",
            answer: |q| {
                cut_with(q, |_, _, axis, [left, _]| {
                    left.len() as f32 + 0.1 * axis as f32
                })
            },
        },
        Mistake {
            name: "sorts by the least corners",
            hint: "A long box begins before most others and ends after them: between which of them does it stand in your row?",
            answer: |q| split(q, |how| how.key = |b| b.min),
        },
        Mistake {
            name: "multiplies each side by the number of boxes on the other",
            hint: "A ray that meets the left box: which shapes does it test there?",
            answer: |q| {
                cut_with(q, |q, _, _, [left, right]| {
                    let side = |side: &Vec<u32>, count: &Vec<u32>| {
                        sah(&around(&q.boxes, side), count.len() as f32)
                    };
                    side(left, right) + side(right, left)
                })
            },
        },
        Mistake {
            name: "leaves the faces across x out of the area",
            hint: "A box has six faces: which of them are in your sum?",
            answer: |q| least(q, fewer_faces::<0>),
        },
        Mistake {
            name: "leaves the faces across y out of the area",
            hint: "A box has six faces: which of them are in your sum?",
            answer: |q| least(q, fewer_faces::<1>),
        },
        Mistake {
            name: "leaves the faces across z out of the area",
            hint: "A box has six faces: which of them are in your sum?",
            answer: |q| least(q, fewer_faces::<2>),
        },
        Mistake {
            name: "keeps the best cut of the last axis, and forgets those of the others",
            hint: "Where does the least cost so far begin at infinity: before the loop over the axes, or in it?",
            answer: |q| {
                cut_with(q, |q, side, axis, sides| {
                    if axis == 2 {
                        sum(q, side, 0, sides)
                    } else {
                        f32::INFINITY
                    }
                })
            },
        },
        Mistake {
            name: "never tries to leave one box on the right",
            hint: "Of n boxes in a row there are n − 1 cuts: which is the last?",
            answer: |q| {
                cut_with(q, |q, side, _, sides| {
                    if sides[1].len() == 1 {
                        f32::INFINITY
                    } else {
                        sum(q, side, 0, sides)
                    }
                })
            },
        },
        Mistake {
            name: "never tries to leave one box on the left",
            hint: "Of n boxes in a row there are n − 1 cuts: which is the first?",
            answer: |q| {
                cut_with(q, |q, side, _, sides| {
                    if sides[0].len() == 1 {
                        f32::INFINITY
                    } else {
                        sum(q, side, 0, sides)
                    }
                })
            },
        },
        Mistake {
            name: "measures the boxes around the centres, not around the boxes",
            hint: "A side's box must hold the whole of its members: does a box around their centres?",
            answer: |q| {
                least(q, |q, side| {
                    let centers = side.iter().map(|i| center(&q.boxes[*i as usize]));
                    sah(&Aabb::of(centers), side.len() as f32)
                })
            },
        },
        Mistake {
            name: "takes the area of the box around all boxes for the right side",
            hint: "A cut leaves a few small boxes on the right: how large is the box around only these?",
            answer: |q| {
                cut_with(q, |q, side, _, [left, right]| {
                    let (all, _) = whole(q, &[&left[..], right].concat());
                    side(q, left) + sah(&all, right.len() as f32)
                })
            },
        },
        Mistake {
            name: "takes the whole area less the left side's for that of the right side",
            hint: "Two boxes around the two halves of a cube: do their areas come to that of the cube?",
            answer: |q| {
                cut_with(q, |q, _, _, [left, right]| {
                    whole_less_left(&q.boxes, left, right)
                })
            },
        },
        Mistake {
            name: "counts one box too many on the right",
            hint: "Of five boxes two are on the left: how many does your formula count on the right?",
            answer: |q| {
                cut_with(q, |q, side, _, sides| {
                    sum(q, side, 0, sides) + once(q, &sides[1])
                })
            },
        },
        Mistake {
            name: "counts one box too many on the left",
            hint: "The cut is behind the first box: how many does your formula count on the left?",
            answer: |q| {
                cut_with(q, |q, side, _, sides| {
                    sum(q, side, 0, sides) + once(q, &sides[0])
                })
            },
        },
        Mistake {
            name: "sorts by the greatest corners",
            hint: "A long box begins before most others and ends after them: between which of them does it stand in your row?",
            answer: |q| split(q, |how| how.key = |b| b.max),
        },
        Mistake {
            name: "stops along an axis as soon as the cost rises",
            hint: "The cost may rise and fall again along the row: is the first cut before a dearer one the cheapest?",
            answer: |q| {
                let (mut last, mut rises) = ((3, f32::INFINITY), false);
                cheapest(q, |axis, left, right| {
                    let cost = sah_of(q, left) + sah_of(q, right);
                    rises = axis == last.0 && (rises || cost > last.1);
                    last = (axis, cost);
                    if rises { f32::INFINITY } else { cost }
                })
            },
        },
        Mistake {
            name: "takes the greater of the two sides' costs, not their sum",
            hint: "A ray may meet both sides: what does it pay then?",
            answer: |q| {
                cut_with(q, |q, side, _, [left, right]| {
                    side(q, left).max(side(q, right))
                })
            },
        },
        Mistake {
            name: "never empties the left side's box: at the next axis it still holds those of the axis before",
            hint: "The first cut along y has one box on the left: what is in your left side's box then?",
            answer: |q| {
                let mut held = Vec::new();
                cheapest(q, |_, left, right| {
                    let bounds = around(&q.boxes, &[&held[..], left].concat());
                    if right.len() == 1 {
                        held.extend_from_slice(left);
                    }
                    sah(&bounds, left.len() as f32) + sah_of(q, right)
                })
            },
        },
        Mistake {
            name: "adds up the areas of a side's boxes, and makes no box around them",
            hint: "Two small boxes far apart are on one side: how large is the box that a ray has to miss?",
            answer: |q| {
                least(q, |q, side| {
                    let areas = side.iter().map(|i| {
                        let BoxRow { min, max } = q.boxes[*i as usize];
                        area(min, max)
                    });
                    areas.sum::<f32>() * side.len() as f32
                })
            },
        },
        Mistake {
            name: "cuts at the middle of the box around all, along its longest axis",
            hint: "One box lies far away from nine others: what does your rule know of areas and numbers?",
            answer: |q| {
                cut_with(q, |q, _, axis, [left, right]| {
                    if axis != longest(q) {
                        return f32::INFINITY;
                    }
                    let all = around(&q.boxes, &[&left[..], right].concat());
                    let is_before =
                        |i: &u32| center(&q.boxes[*i as usize])[axis] < all.center()[axis];
                    let strangers = left.iter().filter(|i| !is_before(i)).count()
                        + right.iter().filter(|i| is_before(i)).count();
                    strangers as f32
                })
            },
        },
        Mistake {
            name: "tries only the axis along which the centres lie farthest apart",
            hint: "Is the best cut always across the longest row of centres?",
            answer: |q| {
                cut_with(q, |q, side, axis, sides| {
                    let centers = Aabb::of(q.boxes.iter().map(center));
                    let is_longest = axis == centers.size().max_position();
                    if is_longest {
                        sum(q, side, 0, sides)
                    } else {
                        f32::INFINITY
                    }
                })
            },
        },
        Mistake {
            name: "sorts one row again along each axis, and returns its first boxes in the order of the last",
            hint: "The row was sorted along other axes after the cheapest cut was found: which boxes are at its left end when you return them?",
            answer: sorted_again,
        },
        Mistake {
            name: "forgets the axis of the cheapest cut, and returns the first boxes in the order along x",
            hint: "The cheapest cut may be one along z: along which axis is the row sorted when you take its first boxes?",
            answer: |q| {
                let left = split(q, |_| {}).len();
                let mut along_x = cuts(&q.boxes, center).into_iter();
                along_x
                    .next()
                    .map_or(Vec::new(), |(_, sides)| sides.concat()[..left].to_vec())
            },
        },
        Mistake {
            name: "sorts the centres into eight buckets along each axis, and cuts between buckets only",
            hint: "Two centres are in one bucket: is the cut between them ever tried?",
            answer: |q| cut_with(q, between_buckets::<8>),
        },
        Mistake {
            name: "sorts the centres into twelve buckets along each axis, and cuts between buckets only",
            hint: "Two centres are in one bucket: is the cut between them ever tried?",
            answer: |q| cut_with(q, between_buckets::<12>),
        },
        Mistake {
            name: "sorts the centres into sixteen buckets along each axis, and cuts between buckets only",
            hint: "Two centres are in one bucket: is the cut between them ever tried?",
            answer: |q| cut_with(q, between_buckets::<16>),
        },
        Mistake {
            name: "sorts the centres into 32 buckets along each axis, and cuts between buckets only",
            hint: "Two centres are in one bucket: is the cut between them ever tried?",
            answer: |q| cut_with(q, between_buckets::<32>),
        },
    ];
}
