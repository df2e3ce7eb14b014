//! `wide_closest`: its judge and mistakes.

use super::wide_closest_cases::{self, question};
use crate::search::{self, How, Node, Order, Tree};
use crate::{Graded, Mistake, Picture, Verdict, judge, sample};
use raybook::math::{aabb::Aabb, interval::Interval, pcg::Pcg};
use raybook_workbook::exercises::ch24_wide_bvh::{WideChild, WideClosest, WideClosestAnswer};
use glam::vec3;

impl Graded for WideClosest {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "opens every child",
            hint: "The hit is right, but the boxes are there to spare you tests: ask them first.",
            answer: |q| search(q, |how| how.asks = false),
        },
        Mistake {
            name: "opens the children in the order of the node",
            hint: "Where is the nearest hit more likely, and what is spared if you find it first?",
            answer: |q| search(q, |how| how.order = Order::Stored),
        },
        Mistake {
            name: "opens the farthest child first",
            hint: "The last one on the stack is the first one off it: which one should that be?",
            answer: |q| search(q, |how| how.order = Order::Farthest),
        },
        Mistake {
            name: "opens children that wait behind the hit",
            hint: "A child was put aside, then something was hit before its box: is it still worth opening?",
            answer: |q| search(q, |how| how.drops = false),
        },
        Mistake {
            name: "ends at the first leaf with a hit",
            hint: "Boxes may overlap: can a triangle of a farther box be nearer?",
            answer: |q| search(q, |how| how.stops = true),
        },
        Mistake {
            name: "opens the nearest child only",
            hint: "The nearest box may be empty where the ray passes through it.",
            answer: |q| search(q, |how| how.opens = 1),
        },
        Mistake {
            name: "looks at four lanes of eight",
            hint: "How many children can a node have?",
            answer: |q| search(q, |how| how.looks_at = 4),
        },
        Mistake {
            name: "ignores the interval's min",
            hint: "Can the ray hit what lies behind its origin?",
            answer: |q| Self::misread(q, |q| q.within.min = f32::NEG_INFINITY),
        },
        Mistake {
            name: "ignores the interval's max",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| Self::misread(q, |q| q.within.max = f32::INFINITY),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "wide_closest",
        width: 96,
        height: 54,
        alt: "Shingles on a slope, each in its colour",
        question: |x, y| {
            let toward = sample::pixel(x, y);
            let shingles = (0..40).map(|i| {
                let (column, row) = ((i % 8) as f32, (i / 8) as f32);
                let at = vec3(
                    0.5 * column - 1.75 + 0.2 * (row % 2.0),
                    0.45 * row - 1.1,
                    0.4 * row - 1.0,
                );
                [
                    vec3(-0.3, -0.35, 0.25),
                    vec3(0.3, -0.35, 0.2),
                    vec3(0.0, 0.4, 0.0),
                ]
                .map(|p| p + at)
            });
            question(
                shingles.collect(),
                sample::ray(vec3(0.0, 0.0, 3.0), toward),
                Interval::AHEAD,
            )
        },
        colour: |_, answer| search::colour(answer.hit.as_ref()),
    }];

    fn random(rng: &mut Pcg) -> WideClosest {
        wide_closest_cases::random(rng)
    }

    /// The hit, and the work: a quarter more than the reference's is as good, for another order may be unlucky.
    fn judge(
        _q: &WideClosest,
        golden: &WideClosestAnswer,
        got: &WideClosestAnswer,
    ) -> Verdict {
        judge::nearest(golden.hit.as_ref(), got.hit.as_ref())?;
        if got.hit.is_some() && got.tests == 0 {
            return Err("there is a hit, but no triangle was tested: count each test".into());
        }
        for (what, needed, made) in [
            ("triangle tests", golden.tests, got.tests),
            ("nodes opened", golden.nodes, got.nodes),
        ] {
            if 4 * u64::from(made) > 5 * u64::from(needed) + 4 {
                return Err(format!(
                    "the hit is right, but with {made} {what}; the reference needs {needed}"
                ));
            }
        }
        Ok(())
    }
}

/// A search that goes wrong in some way.
fn search(q: &WideClosest, change: impl FnOnce(&mut How)) -> WideClosestAnswer {
    let child = |child: &WideChild| {
        let &WideChild {
            min, max, index, ..
        } = child;
        let node = match child.leaf {
            0 => Node::Branch(index),
            _ => Node::Leaf(q.leaves[index as usize].triangles.clone()),
        };
        (Aabb { min, max }, node)
    };
    let tree = Tree {
        ray: &q.ray,
        within: q.within,
        triangles: &q.triangles,
        children: &|i| q.nodes[i as usize].children.iter().map(child).collect(),
    };
    let found = search::search(&tree, &Node::Branch(0), change);
    WideClosestAnswer {
        nodes: found.branches,
        tests: found.tests,
        hit: found.hit,
    }
}
