//! `octree_build`: random questions, judge and mistakes.

mod builders;

use super::octree_tree::{cost, cut_for_nothing, is_tree, misplaced, names, wrong_choice};
use crate::{Flaw, Graded, Mistake, Verdict, sample, traits};
use builders::{begun, built, depth_first, name_all, sum};
use glam::Vec3;
use rand::RngExt;
use raybook::accel::octree::build::Limits;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch10_octree::OctreeBuild;
use raybook_workbook::octree_rows::TreeRow;

/// Leads to where a leaf's names begin.
const LENGTH_OF_THE_LIST: &str =
    "How long is the list of names before a leaf's own are appended, and how long after that?";

/// What a function does whose leaves begin where they end, whatever tree it makes.
const END_OF_A_LEAF: &str = "takes the end of a leaf's part of the list of names for its beginning";

/// The same, if they all begin with the list.
const START_OF_THE_LIST: &str = "lets every leaf begin at the start of the list of names";

/// The same, if they begin at the number of a shape.
const NUMBER_OF_A_SHAPE: &str =
    "writes the number of a leaf's first shape where that name's place in the list belongs";

/// The same, if nodes have the number of their last child.
const LAST_CHILD: &str = "gives a node the number of its last child, not that of its first";

/// What a function does that cuts without need.
const NOTHING_WON: &str = "cuts a cell where the cut costs as much as the leaf";
const NOTHING_WON_HINT: &str = "The cost of a cut is just that of the leaf: does the cut lower it?";

impl Graded for OctreeBuild {
    fn random(rng: &mut Pcg) -> OctreeBuild {
        let min = sample::point(rng, 3.0);
        let size = sample::number(rng, 1.0, 4.0);
        // Half of the shapes in one corner, so that depth matters.
        let crowd = min + size * Vec3::splat(sample::number(rng, 0.1, 0.6));
        let shapes = (0..rng.random_range(6..11))
            .map(|i| {
                let anywhere = min + size * (0.9 * (sample::point(rng, 0.5) + 0.5));
                let near = crowd + size * (0.1 * (sample::point(rng, 0.5) + 0.5));
                let least = if i % 2 == 0 { near } else { anywhere };
                let extent = size * 0.08 * (sample::point(rng, 0.5) + 0.5);
                Corners {
                    min: least,
                    max: least + extent,
                }
            })
            .collect();
        OctreeBuild {
            min,
            max: min + size,
            opening: 1.0,
            // No product of a few quotients of small numbers: rounding must not decide whether a cut is allowed.
            copies: [1.2, 2.0137, 7.9873][rng.random_range(0..3_usize)],
            depth: rng.random_range(1..4),
            shapes,
        }
    }

    /// Half of the shapes in one corner, the others anywhere.
    fn crowded(rng: &mut Pcg, count: usize) -> Option<OctreeBuild> {
        let shapes = (0..count).map(|i| {
            let near = if i % 2 == 0 { 0.25 } else { 1.0 };
            let least = 3.9 * near * (sample::point(rng, 0.5) + 0.5);
            let extent = 0.1 * (sample::point(rng, 0.5) + 0.5);
            Corners {
                min: least,
                max: least + extent,
            }
        });
        Some(OctreeBuild {
            min: Vec3::ZERO,
            max: Vec3::splat(4.0),
            opening: 1.0,
            copies: 8.0,
            depth: 5,
            shapes: shapes.collect(),
        })
    }

    /// Every shape in the leaves that it reaches and in no other, as few copies as asked for, and a cost like the reference's.
    fn is_sound(q: &OctreeBuild) -> bool {
        let mut shapes = q.shapes.iter();
        sample::is_cube(q.min, q.max) && shapes.all(|shape| sample::is_box(shape.min, shape.max))
    }

    fn judge(q: &OctreeBuild, golden: &TreeRow, got: &TreeRow) -> Verdict {
        is_tree(q, got).map_err(|why| misplaced(q, got).map_or(why, str::to_owned))?;
        let (most, copies) = (q.copies * q.shapes.len() as f32, got.names.len() as f32);
        if copies > most.max(q.shapes.len() as f32) + 1e-3 {
            return Err(format!(
                "the leaves name {copies} shapes in all, and may name {most}"
            ));
        }
        // The golden tree is made by the same rules, so it can be taken apart too.
        let (cost, least) = (cost(q, got), cost(q, golden));
        if cost > 1.02 * least + 1e-3 {
            let tests = format!(
                "a ray through the cell is expected to cost {cost:.2} tests, and need not cost more than {least:.2}"
            );
            return Err(match wrong_choice(q, got) {
                Some(why) => format!("{why}: {tests}"),
                None => tests,
            });
        }
        match cut_for_nothing(q, got) {
            Some(node) => Err(format!(
                "node {node} is cut, and nothing is won: the cut costs as much as the leaf would"
            )),
            None => Ok(()),
        }
    }

    fn traits(q: &OctreeBuild, got: &TreeRow) -> Vec<f64> {
        let n = q.shapes.len().max(1) as f64;
        let ends = got.nodes.iter().filter(|node| node.inner == 0);
        let all = ends.clone().count().max(1) as f64;
        let empty = ends.clone().filter(|node| node.count == 0).count();
        let most = ends.map(|node| node.count).max().unwrap_or(0);
        let held = |i: &u32| got.names.contains(i);
        vec![
            traits::log(got.nodes.len() as f64),
            traits::log(0.1 + got.names.len() as f64 / n),
            empty as f64 / all,
            f64::from(most) / n,
            (0..q.shapes.len() as u32).filter(held).count() as f64 / n,
            f64::from(names(q, got).is_ok()),
        ]
    }

    /// The nodes by levels, and the names of each leaf sorted, where it is a tree.
    fn canonical(q: &OctreeBuild, mut tree: TreeRow) -> TreeRow {
        // Where the names of an empty leaf begin is all the same.
        let leaves_of = tree.nodes.iter_mut().filter(|node| node.inner == 0);
        leaves_of
            .filter(|node| node.count == 0)
            .for_each(|node| node.first = 0);
        // Leaves that share names are told by it.
        let Ok(mut names) = names(q, &tree) else {
            return tree;
        };
        names.sort_by_key(|names| names.start);
        if names.windows(2).any(|two| two[0].end > two[1].start) {
            return tree;
        }
        let mut one = TreeRow {
            nodes: vec![tree.nodes[0].clone()],
            names: Vec::new(),
        };
        let mut i = 0;
        while i < one.nodes.len() {
            let first = one.nodes[i].first as usize;
            if one.nodes[i].inner == 1 {
                one.nodes[i].first = one.nodes.len() as u32;
                one.nodes.extend_from_slice(&tree.nodes[first..first + 8]);
            } else {
                one.nodes[i].first = one.names.len() as u32;
                let count = one.nodes[i].count as usize;
                let mut own = tree.names[first.min(tree.names.len())..][..count].to_vec();
                own.sort_unstable();
                one.names.extend(own);
            }
            i += 1;
        }
        // Those that no leaf has are told by it too.
        let mut begin = 0;
        for of_leaf in names {
            one.names.extend(&tree.names[begin..of_leaf.start]);
            begin = of_leaf.end;
        }
        one.names.extend(&tree.names[begin..]);
        one
    }

    const EFFORT: usize = 10;

    const ALLOWS: &'static str = "The tree may cost 2 % more than the reference's. Shapes may stand in any order within a leaf.";

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "there is no node",
            name: "gives a node children that are not in the list of nodes",
            hint: "A node's children are eight in a row, from its `first`: is that the number of the first child, and are all eight in the list, empty ones too?",
        },
        Flaw {
            complaint: "is the child of two nodes",
            name: "gives two nodes the same child",
            hint: "A node's eight children stand in a row, before any of their own children: how long is the list of nodes at the moment when they are appended?",
        },
        Flaw {
            complaint: "a node with children is 1, its first child and 0",
            name: "mixes up what a node with children holds and what a leaf holds",
            hint: "What do the three numbers of a node mean if it has children, and what if it is a leaf?",
        },
        Flaw {
            complaint: "of a list of",
            name: "lets leaves name places of the list of names that are not theirs: they begin at the wrong place, or count wrongly",
            hint: LENGTH_OF_THE_LIST,
        },
        Flaw {
            complaint: "both name what is at place",
            name: "lets leaves name places of the list of names that are not theirs: they begin at the wrong place, or count wrongly",
            hint: LENGTH_OF_THE_LIST,
        },
        Flaw {
            complaint: "begins behind its last name",
            name: END_OF_A_LEAF,
            hint: LENGTH_OF_THE_LIST,
        },
        Flaw {
            complaint: "begins one place too late",
            name: "counts the places of the list of names from 1",
            hint: "What is the place of the first name in the list?",
        },
        Flaw {
            complaint: "has the place of its last name",
            name: "gives a leaf the place of its last name, not that of its first",
            hint: LENGTH_OF_THE_LIST,
        },
        Flaw {
            complaint: "begins at place 0 of the list of names",
            name: START_OF_THE_LIST,
            hint: LENGTH_OF_THE_LIST,
        },
        Flaw {
            complaint: "has the number of its first shape",
            name: NUMBER_OF_A_SHAPE,
            hint: "The list holds the names of all leaves, one leaf's after the other's: at which place of it do a leaf's own begin?",
        },
        Flaw {
            complaint: "begins where the names of another are",
            name: "lets leaves begin at places of the list of names that are not theirs",
            hint: LENGTH_OF_THE_LIST,
        },
        Flaw {
            complaint: "has the number of its last child",
            name: LAST_CHILD,
            hint: "How long is the list of nodes at the moment before the eight children are appended?",
        },
        Flaw {
            complaint: "how far behind it",
            name: "tells how far behind a node its first child is, not its number",
            hint: "From where do the numbers of the nodes count?",
        },
        Flaw {
            complaint: "which is the limit",
            name: "cuts deeper than the depth allows",
            hint: "With a depth of 0, how many nodes may there be? What becomes of the depth from a cell to its children?",
        },
        Flaw {
            complaint: "counted from 0",
            name: "counts the shapes from 1",
            hint: "What is the number of the first shape?",
        },
        Flaw {
            complaint: "twice",
            name: "names a shape twice in the same leaf",
            hint: "How often may a ray test the same shape in a leaf?",
        },
        Flaw {
            complaint: "which does not name it",
            name: "leaves shapes out of leaves that they reach",
            hint: "A shape may reach several children: does your test let it into all of them, and are a child's lower and upper corners those of its number?",
        },
        Flaw {
            complaint: "which is not in it",
            name: "names shapes in leaves that they do not reach",
            hint: "Which of a cell's shapes does a child get: all, or those whose boxes overlap its own?",
        },
        Flaw {
            complaint: "shapes in all, and may name",
            name: "makes more copies than the limit allows",
            hint: "What is left of the limit on copies for the children, when a cut has used some of it?",
        },
        Flaw {
            complaint: "is cut, and that does not pay",
            name: "cuts cells where that does not pay",
            hint: "Write down the cost of a leaf and that of a cut cell for the smallest case: which of them is less, and what does a child cost a ray that may miss it?",
        },
        Flaw {
            complaint: "is cut, and nothing is won",
            name: NOTHING_WON,
            hint: NOTHING_WON_HINT,
        },
        Flaw {
            complaint: "is not cut, and that would pay",
            name: "leaves cells whole where a cut would pay",
            hint: "Write down the cost of a leaf and that of a cut cell for the smallest case: which of them is less, and has anything else stopped the cut?",
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "names a shape only where its middle is",
            hint: "A ray can hit a shape far from the shape's middle: in which leaves must the ray find the shape?",
            answer: |q| {
                built(q, |how| {
                    how.place = |shape| {
                        let middle = 0.5 * (shape.min + shape.max);
                        Corners {
                            min: middle,
                            max: middle,
                        }
                    };
                    how.kept = |bits| 1 << bits.trailing_zeros().min(7);
                })
            },
        },
        Mistake {
            name: "drops shapes that reach several children",
            hint: "A shape that does not fit into one child: where is it named?",
            answer: |q| {
                built(q, |how| {
                    how.kept = |bits| if bits.is_power_of_two() { bits } else { 0 };
                })
            },
        },
        Mistake {
            name: "does not write the names of a leaf's shapes into the list",
            hint: "A leaf says where its names begin, and how many they are: which line of yours writes them there?",
            answer: |q| TreeRow {
                names: Vec::new(),
                ..Self::right(q)
            },
        },
        Mistake {
            name: "writes the names of a cell that it cuts into the list, too",
            hint: "Who reads the names of a node with children? When is it known whether a cell is cut?",
            answer: |q| {
                let tree = Self::right(q);
                let mut made = TreeRow {
                    names: Vec::new(),
                    ..tree.clone()
                };
                name_all(&tree, 0, &mut made);
                made
            },
        },
        Mistake {
            name: "never cuts",
            hint: "What does a ray gain from a tree that is a single leaf? If your rule never allows a cut: which share of a child's shapes does a ray test?",
            answer: |q| Self::misread(q, |q| q.depth = 0),
        },
        Mistake {
            name: NOTHING_WON,
            hint: NOTHING_WON_HINT,
            answer: |q| built(q, |how| how.is_cheaper = |cut, whole| cut <= whole),
        },
        Mistake {
            name: "cuts as long as the depth allows",
            hint: "What does a ray gain if a leaf with one shape, or none, is cut?",
            answer: |q| Self::misread(q, |q| (q.opening, q.copies) = (-1e9, 1e9)),
        },
        Mistake {
            name: "cuts the root only",
            hint: "Are the children cells like any other?",
            answer: |q| Self::misread(q, |q| q.depth = q.depth.min(1)),
        },
        Mistake {
            name: "cuts one level deeper than the depth allows",
            hint: "With a depth of 0, how many nodes may there be?",
            answer: |q| Self::misread(q, |q| q.depth = q.depth.saturating_add(1)),
        },
        Mistake {
            name: "swaps x and z in the children's numbers and in their cells",
            hint: "Child 1 is in the upper half along one axis only: along which?",
            answer: |q| {
                let swap = |p: &mut Vec3| std::mem::swap(&mut p.x, &mut p.z);
                Self::misread(q, |q| {
                    let corners = q.shapes.iter_mut().flat_map(|s| [&mut s.min, &mut s.max]);
                    corners.chain([&mut q.min, &mut q.max]).for_each(swap);
                })
            },
        },
        Mistake {
            name: "swaps x and z in the children's numbers, but not in their cells",
            hint: "Child 1 is in the upper half along one axis only: along which? Do its cell and its shapes agree?",
            answer: |q| {
                built(q, |how| {
                    how.cells = |cells, _| [0, 4, 2, 6, 1, 5, 3, 7].map(|i: usize| cells[i]);
                })
            },
        },
        Mistake {
            name: "compares shapes with the middle of the whole scene in every cell",
            hint: "Which point parts the children of a cell that has been cut before: the root's middle, or its own?",
            answer: |q| built(q, |how| how.cells = |_, of_root| of_root),
        },
        Mistake {
            name: "ignores the limit on copies",
            hint: "How often are large shapes named in all leaves together?",
            answer: |q| Self::misread(q, |q| q.copies = f32::INFINITY),
        },
        Mistake {
            name: "forgets the cost of opening a node",
            hint: "Is a node with children free for a ray that enters it?",
            answer: |q| Self::misread(q, |q| q.opening = 0.0),
        },
        Mistake {
            name: "stops one level before the depth allows",
            hint: "With a depth of 1, how many nodes may there be?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.depth = q.depth.min(Limits::DEEPEST).saturating_sub(1);
                })
            },
        },
        Mistake {
            name: "compares what a cut makes with the copies that all shapes may have, not those of the cell",
            hint: "Of the scene's hundred shapes five are in the cell: how many names may its children have, if the limit is 2?",
            answer: |q| {
                built(q, |how| {
                    how.allowed = |q, copies, _| copies * q.shapes.len() as f32;
                })
            },
        },
        Mistake {
            name: "allows half as many copies as the limit does",
            hint: "A cell has n shapes: how many names may all leaves in this cell have together?",
            answer: |q| Self::misread(q, |q| q.copies *= 0.5),
        },
        Mistake {
            name: "names a shape only in the first child that it reaches",
            hint: "A ray can hit a shape in any part of the shape: in which leaves must the ray find the shape?",
            answer: |q| built(q, |how| how.kept = |bits| bits & bits.wrapping_neg()),
        },
        Mistake {
            name: "applies the limit on copies to each cell afresh, whatever the cuts above it have used",
            hint: "The root's cut makes as many copies as the limit allows: how many are left for the children?",
            answer: |q| built(q, |how| how.left = |copies, _| copies),
        },
        Mistake {
            name: "takes what a cut adds off the limit on copies, and does not divide by what it multiplies by",
            hint: "A cut makes twice as many names, and the next one twice as many again: how many are these, and how many did the limit allow?",
            answer: |q| built(q, |how| how.left = |copies, made| copies - (made - 1.0)),
        },
        Mistake {
            name: "takes what a cut multiplies the names by off the limit on copies, and does not divide by it",
            hint: "A cut makes twice as many names, and the next one twice as many again: how many are these, and how many did the limit allow?",
            answer: |q| built(q, |how| how.left = |copies, made| copies - made),
        },
        Mistake {
            name: "expects a ray to meet each child with probability 1/8, not 1/4",
            hint: "Of eight children with a shape each, how many does a ray pass through on average: does it meet only one?",
            answer: |q| built(q, |how| how.expected = |parts| 0.125 * sum(parts)),
        },
        Mistake {
            name: "expects a ray to meet one child only, that with the most shapes",
            hint: "How many children does a ray pass through on its way across the cell, and with what probability does it meet each?",
            answer: |q| {
                built(q, |how| {
                    how.expected = |parts| {
                        let most = parts.iter().map(Vec::len).max();
                        most.unwrap_or(0) as f32
                    };
                })
            },
        },
        Mistake {
            name: "counts the children that are not empty, not the shapes in them",
            hint: "A ray enters a child with nine shapes: how many does it test there, nine or one?",
            answer: |q| {
                built(q, |how| {
                    how.expected = |parts| {
                        let filled = parts.iter().filter(|part| !part.is_empty());
                        0.25 * (filled.count() as f32)
                    };
                })
            },
        },
        Mistake {
            name: "cuts each cell with more than one shape, as far as the limits allow, or counts a shape once in Σ nᵢ, however many children it reaches",
            hint: "Three large shapes reach all eight children: what is Σ nᵢ, and what does a ray gain by the cut? What does your condition compare?",
            answer: |q| {
                built(q, |how| {
                    how.expected = |_| f32::NEG_INFINITY;
                    how.more_than = 1.0;
                })
            },
        },
        Mistake {
            name: "compares the cost of a cut with the number of all shapes, not with that of the shapes in the cell",
            hint: "What does a ray pay in a cell of two shapes, or of none, that is not cut, however many shapes the scene has?",
            answer: |q| built(q, |how| how.compared = |q, _| q.shapes.len() as f32),
        },
        Mistake {
            name: "takes the limit on copies for the number of names that a cut may leave",
            hint: "The limit is one on copies of each shape: how many names may there be, if the cell has n shapes?",
            answer: |q| built(q, |how| how.allowed = |_, copies, _| copies),
        },
        Mistake {
            name: "divides what is left of the limit on copies by eight, for the eight children",
            hint: "The limit is one on copies of each shape, on average: must a child with half of the shapes make an eighth of them?",
            answer: |q| {
                built(q, |how| {
                    how.left = |copies, made| copies / made.max(1.0) / 8.0;
                })
            },
        },
        Mistake {
            name: "allows each cell as many copies as the whole tree, and hands the limit on unchanged",
            hint: "The limit is for each shape: by how many shapes do you multiply it in a small cell, and what has the cut above it used up?",
            answer: |q| {
                built(q, |how| {
                    how.allowed = |q, copies, _| copies * q.shapes.len() as f32;
                    how.left = |copies, _| copies;
                })
            },
        },
        Mistake {
            name: "numbers the nodes depth first, so that a node's second child comes after all below its first",
            hint: "A node's eight children stand in a row: how long is the list of nodes when you append the second of them, if the first has children?",
            answer: |q| {
                let mut made = TreeRow {
                    nodes: Vec::new(),
                    names: Vec::new(),
                };
                depth_first(&Self::right(q), 0, &mut made);
                made
            },
        },
        Mistake {
            name: "divides what is left of the limit on copies after each child, so that the first gets all of it",
            hint: "Print the limit that each of the eight children gets: are they the same?",
            answer: |q| built(q, |how| how.times = |child| [1, child]),
        },
        Mistake {
            name: "takes a level off the depth again for each child, in the loop over the children",
            hint: "Print the depth that is left for each of the eight children: are they the same?",
            answer: |q| built(q, |how| how.times = |child| [child + 1, 1]),
        },
        Mistake {
            name: "compares the cost of a cut with the number of all shapes, not with that of the shapes in the cell, but cuts no empty cell",
            hint: "What does a ray pay in a cell of two shapes that is not cut, however many shapes the scene has?",
            answer: |q| {
                built(q, |how| {
                    how.compared = |q, _| q.shapes.len() as f32;
                    how.more_than = 0.0;
                })
            },
        },
        Mistake {
            name: "does not cut a cell if one child would get all of its shapes",
            hint: "All shapes are in one child: does a ray that misses this child test any of them after the cut?",
            answer: |q| {
                built(q, |how| {
                    how.may_pay = |n, parts| !parts.iter().any(|part| part.len() as f32 == n);
                })
            },
        },
        Mistake {
            name: "does not cut a cell if one of its shapes would be in several children",
            hint: "One of nine shapes reaches two children: does the sum in the rule know of it, and can the cut pay all the same?",
            answer: |q| built(q, |how| how.may_pay = |n, parts| sum(parts) <= n),
        },
        Mistake {
            name: "makes a leaf of any cell with at most two shapes",
            hint: "Two shapes are in one child: what does a ray pay on average if the cell is a leaf, and what if it is cut?",
            answer: |q| built(q, |how| how.more_than = 2.0),
        },
        Mistake {
            name: "makes a leaf of any cell with at most four shapes",
            hint: "Four shapes are in one child: what does a ray pay on average if the cell is a leaf, and what if it is cut?",
            answer: |q| built(q, |how| how.more_than = 4.0),
        },
        Mistake {
            name: "makes a leaf of any cell with at most eight shapes",
            hint: "Eight shapes are in one child: what does a ray pay on average if the cell is a leaf, and what if it is cut?",
            answer: |q| built(q, |how| how.more_than = 8.0),
        },
        Mistake {
            name: "expects a ray to meet each child with probability 1/2, not 1/4",
            hint: "A ray passes through a cell: how many of its eight children does the ray meet on average?",
            answer: |q| built(q, |how| how.expected = |parts| 0.5 * sum(parts)),
        },
        Mistake {
            name: "adds the cost of opening in each of the eight children, with the probability of 1/4",
            hint: "How many nodes does a ray open when it enters a cut cell, before it comes to the children?",
            answer: |q| built(q, |how| how.openings = 2.0),
        },
        Mistake {
            name: "rounds a quarter of each child's number of shapes down, as a division of integers does",
            hint: "What is 3/4 in your language, if both are integers?",
            answer: |q| {
                built(q, |how| {
                    how.expected = |parts| {
                        let quarters = parts.iter().map(|part| part.len() / 4);
                        quarters.sum::<usize>() as f32
                    };
                })
            },
        },
        Mistake {
            name: "divides the limit on copies by a rounded quotient of two numbers of names, as a division of integers gives",
            hint: "What is 3/2 in your language, if both are integers?",
            answer: |q| {
                built(q, |how| {
                    how.left = |copies, made| copies / made.floor().max(1.0);
                })
            },
        },
        Mistake {
            name: "takes a quarter of the cost of opening, too",
            hint: "How many nodes does a ray open when it enters a cut cell, and how many of its children does it enter?",
            answer: |q| built(q, |how| how.openings = 0.25),
        },
        Mistake {
            name: "expects a ray to meet one child only, with the mean of the shapes of those that hold any",
            hint: "How many children does a ray pass through on its way across the cell, and does it know which of them are empty?",
            answer: |q| {
                built(q, |how| {
                    how.expected = |parts| {
                        let full = parts.iter().filter(|part| !part.is_empty()).count();
                        sum(parts) / (full.max(1) as f32)
                    };
                })
            },
        },
        Mistake {
            name: END_OF_A_LEAF,
            hint: LENGTH_OF_THE_LIST,
            answer: |q| begun(q, 0, |leaf, _| leaf.first + leaf.count),
        },
        Mistake {
            name: START_OF_THE_LIST,
            hint: LENGTH_OF_THE_LIST,
            answer: |q| begun(q, 0, |_, _| 0),
        },
        Mistake {
            name: NUMBER_OF_A_SHAPE,
            hint: "The list holds the names of all leaves, one leaf's after the other's: at which place of it do a leaf's own begin?",
            answer: |q| {
                begun(q, 0, |leaf, names| {
                    let name = names.get(leaf.first as usize).filter(|_| leaf.count > 0);
                    name.copied().unwrap_or(leaf.first)
                })
            },
        },
        Mistake {
            name: LAST_CHILD,
            hint: "How long is the list of nodes at the moment before the eight children are appended?",
            answer: |q| begun(q, 1, |node, _| node.first + 7),
        },
    ];
}
