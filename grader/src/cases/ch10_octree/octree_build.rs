//! `octree_build`: its mistakes.

use super::octree_build_cases;
use super::octree_build_judge::judge;
use raybook::accel::octree::build::{Limits, build};
use crate::{Graded, Mistake, Verdict};
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, reached};
use raybook_workbook::octree_rows::TreeRow;

/// The tree that the library builds if it is told something else about which cells a box reaches, or other limits.
fn built(
    q: &OctreeBuild,
    limits: impl FnOnce(Limits) -> Limits,
    seen: impl Fn(&Corners, &[Aabb; 8]) -> u8,
) -> TreeRow {
    let limits = limits(Limits {
        opening: q.opening,
        copies: q.copies,
        depth: q.depth,
    });
    let bounds = Aabb {
        min: q.min,
        max: q.max,
    };
    let tree = build(bounds, q.shapes.len() as u32, limits, &|i, cells| {
        seen(&q.shapes[i as usize], cells)
    });
    TreeRow::from(tree)
}

impl Graded for OctreeBuild {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "names a shape only where its middle is",
            hint: "A ray can hit a shape far from its middle: in which leaf does it look for it?",
            answer: |q| {
                built(
                    q,
                    |l| l,
                    |shape, cells| {
                        let middle = 0.5 * (shape.min + shape.max);
                        let place = Corners {
                            min: middle,
                            max: middle,
                        };
                        1 << reached(&place, cells).trailing_zeros().min(7)
                    },
                )
            },
        },
        Mistake {
            name: "drops shapes that reach several children",
            hint: "A shape that does not fit into one child: where is it named?",
            answer: |q| {
                built(
                    q,
                    |l| l,
                    |shape, cells| {
                        let bits = reached(shape, cells);
                        if bits.is_power_of_two() { bits } else { 0 }
                    },
                )
            },
        },
        Mistake {
            name: "never cuts",
            hint: "What does a ray gain from a tree that is a single leaf?",
            answer: |q| built(q, |l| Limits { depth: 0, ..l }, reached),
        },
        Mistake {
            name: "cuts as long as the depth allows",
            hint: "What does a ray gain if a leaf with one shape, or none, is cut?",
            answer: |q| {
                built(
                    q,
                    |l| Limits {
                        opening: -1e9,
                        copies: 1e9,
                        ..l
                    },
                    reached,
                )
            },
        },
        Mistake {
            name: "cuts the root only",
            hint: "Are the children cells like any other?",
            answer: |q| {
                built(
                    q,
                    |l| Limits {
                        depth: l.depth.min(1),
                        ..l
                    },
                    reached,
                )
            },
        },
        Mistake {
            name: "cuts once too often",
            hint: "With a depth of 0, how many nodes may there be?",
            answer: |q| {
                built(
                    q,
                    |l| Limits {
                        depth: l.depth + 1,
                        ..l
                    },
                    reached,
                )
            },
        },
        Mistake {
            name: "swaps x and z in the children's numbers",
            hint: "Child 1 is in the upper half along one axis only: along which?",
            answer: |q| {
                built(
                    q,
                    |l| l,
                    |shape, cells| {
                        let swapped = [0, 4, 2, 6, 1, 5, 3, 7].map(|i: usize| cells[i]);
                        reached(shape, &swapped)
                    },
                )
            },
        },
        Mistake {
            name: "ignores the limit on copies",
            hint: "How often are large shapes named in all leaves together?",
            answer: |q| {
                built(
                    q,
                    |l| Limits {
                        copies: f32::INFINITY,
                        ..l
                    },
                    reached,
                )
            },
        },
    ];

    fn random(rng: &mut Pcg) -> OctreeBuild {
        octree_build_cases::random(rng)
    }

    fn judge(q: &OctreeBuild, golden: &TreeRow, got: &TreeRow) -> Verdict {
        judge(q, golden, got)
    }
}
