//! `wide_closest`: random questions, judge and mistakes.

use crate::search::{BEFORE_THE_EXIT, BEHIND_THE_ENTRY, INSIDE, Part, lose_outside};
use crate::{
    Flaw, Graded, Mistake, Picture, Relation, Verdict, judge, sample, search, search::By,
    search::How, search::Keeps, search::Node, search::Order, search::Tree, traits,
};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::Cost;
use raybook::inside::wide_bvh::{COST, Link, build as build_wide};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook::shape::{Shape, mesh::Facet};
use raybook_workbook::exercises::ch07_mesh::Corners;
use raybook_workbook::exercises::ch24_wide_bvh::{
    WideChild, WideClosest, WideClosestAnswer, WideLeaf, WideNode,
};
use std::sync::LazyLock;

impl Graded for WideClosest {
    fn random(rng: &mut Pcg) -> WideClosest {
        let triangles = (0..rng.random_range(28..44)).map(|_| {
            let at = sample::point(rng, 2.5);
            std::array::from_fn(|_| at + sample::point(rng, 1.6))
        });
        let triangles = triangles.collect();
        let max = sample::end(rng, 0.3, 1.0, 5.0);
        let min = if rng.random_bool(0.3) {
            sample::number(rng, 0.5, 3.0)
        } else {
            0.0
        };
        let origin = 4.0 * *sample::direction(rng);
        let direction = Dir3::new_or(sample::point(rng, 1.5) - origin, Dir3::X);
        question(
            triangles,
            Ray::new(origin, direction),
            Interval::new(min, max.max(min + 1.0)),
        )
    }

    /// The hit, and the work: a quarter more than the reference's is as good, for another order may be unlucky. Where nothing is
    /// hit, no order matters.
    fn judge(q: &WideClosest, golden: &WideClosestAnswer, got: &WideClosestAnswer) -> Verdict {
        judge::nearest(golden.hit.as_ref(), got.hit.as_ref())?;
        let least = with_tree(q, |tree| {
            search::least(tree, &Node::Branch(0), golden.hit.as_ref())
        });
        search::counted("triangle tests", least.tests, got.tests)?;
        search::counted("nodes opened", least.branches, got.nodes)?;
        let without_hit = with_tree(q, |tree| search::without_hit(tree, &Node::Branch(0)));
        for (what, needed, without_hit, made) in [
            ("triangle tests", golden.tests, without_hit.tests, got.tests),
            (
                "nodes opened",
                golden.nodes,
                without_hit.branches,
                got.nodes,
            ),
        ] {
            let most = match golden.hit {
                Some(_) => needed.saturating_add(needed / 4 + 1),
                None => without_hit,
            };
            if made > most {
                return Err(format!(
                    "the hit is right, but with {made} {what}; the reference needs {needed}"
                ));
            }
        }
        Ok(())
    }

    fn traits(_q: &WideClosest, got: &WideClosestAnswer) -> Vec<f64> {
        let (t, id) = got
            .hit
            .as_ref()
            .map_or((-1.0, -1.0), |hit| (hit.t, hit.id as f32));
        vec![
            traits::log(1.0 + f64::from(got.nodes)),
            traits::log(1.0 + f64::from(got.tests)),
            f64::from(t.clamp(-100.0, 100.0)),
            f64::from(id.min(100.0)) / 10.0,
        ]
    }

    const EFFORT: usize = 2;

    const FLAWS: &'static [Flaw] = search::FLAWS;

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| {
        let mut moved = q.clone();
        for child in moved.nodes.iter_mut().flat_map(|node| &mut node.children) {
            child.min += sample::METRE;
            child.max += sample::METRE;
        }
        WideClosest {
            ray: sample::moved(&q.ray),
            triangles: q.triangles.iter().map(sample::moved_triangle).collect(),
            ..moved
        }
    })];

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
            hint: "The child that is put on the stack last is taken off first: which child should that be?",
            answer: |q| search(q, |how| how.order = Order::Farthest),
        },
        Mistake {
            name: "asks every box as if nothing had been hit yet, and opens what is behind the hit",
            hint: "Once something is hit, how far does the ray still have to be followed?",
            answer: |q| search(q, |how| how.shortens = false),
        },
        Mistake {
            name: "opens children that wait behind the hit",
            hint: "A child was put aside, then something was hit nearer than the child's box: is the child still worth opening?",
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
            name: "looks at four of eight children only",
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
        Mistake {
            name: "begins the interval at 0 again once something is hit",
            hint: "A hit ends the interval at its distance: what becomes of the interval's beginning?",
            answer: |q| search(q, |how| how.begins_again = true),
        },
        Mistake {
            name: "keeps the last hit that it finds",
            hint: "A triangle that is tested later may lie behind one that was hit: which one stays?",
            answer: |q| search(q, |how| (how.shortens, how.keeps) = (false, Keeps::Last)),
        },
        Mistake {
            name: "keeps the first hit that it finds",
            hint: "Boxes may overlap: can a triangle that is tested later be nearer?",
            answer: |q| search(q, |how| (how.shortens, how.keeps) = (false, Keeps::First)),
        },
        Mistake {
            name: "counts each leaf as a node too",
            hint: "What is counted as opened: nodes, or leaves as well?",
            answer: |q| search_counting_leaves(q),
        },
        Mistake {
            name: "begins to count the nodes at 1, or counts the root twice",
            hint: "Before the root is opened, how many nodes are open?",
            answer: |q| {
                let right = q.right();
                WideClosestAnswer {
                    nodes: right.nodes + 1,
                    ..right
                }
            },
        },
        Mistake {
            name: "leaves out the last triangle of each leaf",
            hint: "A leaf of one triangle: how often does your loop over its triangles go round?",
            answer: |q| search(q, |how| how.forgets_the_last = true),
        },
        Mistake {
            name: "begins to count the tests at 1",
            hint: "A ray that misses all boxes: how many triangles does it test?",
            answer: |q| {
                let right = q.right();
                WideClosestAnswer {
                    tests: right.tests + 1,
                    ..right
                }
            },
        },
        Mistake {
            name: "opens the children in the reverse order of the node, as they come from a stack",
            hint: "Where is the nearest hit more likely, and what is spared if you find it first?",
            answer: |q| search(q, |how| how.order = Order::Backwards),
        },
        Mistake {
            name: "returns the number of the leaf for that of the triangle",
            hint: "Which of the two numbers in your loops is the triangle's?",
            answer: |q| {
                let mut answer = q.right();
                if let Some(hit) = &mut answer.hit {
                    let holds = |leaf: &WideLeaf| leaf.triangles.contains(&hit.id);
                    let leaf = q.leaves.iter().position(holds);
                    hit.id = leaf.unwrap_or_default() as u32;
                }
                answer
            },
        },
        Mistake {
            name: "returns the triangle's place in its leaf for its number",
            hint: "A leaf holds numbers of triangles: do you return what is in the leaf, or where in the leaf it is?",
            answer: |q| {
                let mut answer = q.right();
                if let Some(hit) = &mut answer.hit {
                    let place =
                        |leaf: &WideLeaf| leaf.triangles.iter().position(|id| *id == hit.id);
                    hit.id = q.leaves.iter().find_map(place).unwrap_or_default() as u32;
                }
                answer
            },
        },
        Mistake {
            name: "counts the triangles of a leaf as one test",
            hint: "A leaf of four triangles: how many tests does it take?",
            answer: |q| {
                let found = with_tree(q, |tree| search::search(tree, &Node::Branch(0), |_| {}));
                WideClosestAnswer {
                    nodes: found.branches,
                    tests: found.leaves,
                    hit: found.hit,
                }
            },
        },
        Mistake {
            name: "counts a node for each child whose box is tested",
            hint: "The boxes of all children of a node are tested at once: what is it that is opened?",
            answer: |q| {
                let found = with_tree(q, |tree| search::search(tree, &Node::Branch(0), |_| {}));
                WideClosestAnswer {
                    nodes: found.boxes,
                    tests: found.tests,
                    hit: found.hit,
                }
            },
        },
        Mistake {
            name: "tests only the first triangle of each leaf",
            hint: "A leaf of four triangles: how often does your loop over its triangles go round?",
            answer: |q| search(q, |how| how.only_the_first = true),
        },
        Mistake {
            name: "leaves out the first triangle of each leaf",
            hint: "A leaf of one triangle: how often does your loop over its triangles go round?",
            answer: |q| search(q, |how| how.forgets_the_first = true),
        },
        Mistake {
            name: "tests no more triangles of a leaf after the first that is hit",
            hint: "Two triangles of one leaf are hit: is the first that is tested the nearer one?",
            answer: |q| search(q, |how| how.stops_in_leaf = true),
        },
        Mistake {
            name: "counts only the triangles that are hit",
            hint: "Does a test cost less if the ray misses the triangle?",
            answer: |q| search(q, |how| how.counts_hits = true),
        },
        Mistake {
            name: "looks at no more than the first of a node's children",
            hint: "A node of eight children: how many boxes does your program test?",
            answer: |q| search(q, |how| how.looks_at = 1),
        },
        Mistake {
            name: "tests triangles from 0 on, not from the interval's min on",
            hint: "A box may reach into the interval, and a triangle in it lie before: which distances count?",
            answer: |q| search(q, |how| how.tests_from_0 = true),
        },
        Mistake {
            name: "returns the first hit that it finds, and looks no further",
            hint: "Another triangle of the same leaf, or of a box that overlaps, may be nearer: when is the search over?",
            answer: |q| search(q, |how| (how.stops, how.stops_in_leaf) = (true, true)),
        },
        Mistake {
            name: "ends at the first leaf with a hit, of all that wait in the order of their distances",
            hint: "Boxes may overlap: can a triangle of a box that begins a little later be nearer?",
            answer: |q| {
                search(q, |how| {
                    how.order = Order::NearestOfAll;
                    how.stops = true;
                })
            },
        },
        Mistake {
            name: "goes by where the ray leaves the boxes, not by where it enters them",
            hint: "A large box may begin near and end far away: can the nearest hit be in it? By which end do you choose, and stop?",
            answer: |q| {
                search(q, |how| {
                    how.order = Order::NearestOfAll;
                    how.by = By::Exit;
                })
            },
        },
        Mistake {
            name: "takes a box for missed if the ray begins in it",
            hint: "A ray begins inside a box: where does it enter, before the interval's min or behind it, and is the box met?",
            answer: |q| search(q, |how| how.only_from_outside = true),
        },
        Mistake {
            name: "loses the boxes if the ray does not move along some axis",
            hint: "If the ray does not move along x, how far is it to the two faces across x, and what is 0 · ∞?",
            answer: |q| search(q, |how| how.loses_parallel = true),
        },
        Mistake {
            name: "leaves out triangles whose backs the ray meets",
            hint: "Does the task want the nearest triangle, or the nearest that faces the ray?",
            answer: |q| search(q, |how| how.culls = true),
        },
        Mistake {
            name: "goes by where the ray passes the boxes' middles, not by where it enters the boxes",
            hint: "A large box may begin near, and its middle be far away: can the nearest hit be in it? By which distance do you choose, and stop?",
            answer: |q| {
                search(q, |how| {
                    how.order = Order::NearestOfAll;
                    how.by = By::Middle;
                })
            },
        },
        Mistake {
            name: "sorts the boxes by the distances of their least corners from the ray's origin",
            hint: "A ray that runs towards −x enters a box far from its least corner: which distance tells when?",
            answer: |q| search(q, |how| how.order = Order::LeastCorner),
        },
        Mistake {
            name: "tests all leaves of a node before it opens the nodes among its children",
            hint: "A far child is a leaf, and a near one a node: in which is the nearest hit more likely?",
            answer: |q| search(q, |how| how.order = Order::LeavesFirst),
        },
        Mistake {
            name: "takes the nearest child first, and the others in the order of the node",
            hint: "The nearest child has no hit: which child should come next?",
            answer: |q| search(q, |how| how.order = Order::NearestThenStored),
        },
        Mistake {
            name: "ends the whole search at the first waiting child behind the hit, although nearer ones wait below it on the stack",
            hint: "The child on top of the stack begins behind the hit: do all others on the stack, too?",
            answer: |q| search(q, |how| how.ends_behind = true),
        },
        Mistake {
            name: "goes by the middle of the ray's stay in the boxes, not by where it enters them",
            hint: "A large box may begin near and end far away: can the nearest hit be at its beginning? By which distance do you choose, and stop?",
            answer: |q| {
                search(q, |how| {
                    how.order = Order::NearestOfAll;
                    how.by = By::Stay;
                })
            },
        },
        Mistake {
            name: "opens first the child whose box the ray leaves first",
            hint: "The nearest hit may be where a long box begins: by which end of the boxes do you sort?",
            answer: |q| search(q, |how| how.order = Order::LeftFirst),
        },
        Mistake {
            name: "opens first the child in whose box the middle of the ray's stay is nearest",
            hint: "The nearest hit may be where a long box begins: by which place in the boxes do you sort?",
            answer: |q| search(q, |how| how.order = Order::MiddleOfStay),
        },
        Mistake {
            name: "tests the triangles of a leaf only between where the ray enters the leaf's box and where the ray leaves it, ends excluded",
            hint: "A flat box is entered and left at the same distance: which distances lie between, and where is the hit?",
            answer: |q| Self::misread(q, |q| lose_outside_of_boxes(q, INSIDE)),
        },
        Mistake {
            name: "tests the triangles of a leaf only behind where the ray enters the leaf's box",
            hint: "A triangle lies in the face by which the ray enters the box: is its distance greater than that of the box?",
            answer: |q| Self::misread(q, |q| lose_outside_of_boxes(q, BEHIND_THE_ENTRY)),
        },
        Mistake {
            name: "tests the triangles of a leaf only before where the ray leaves the leaf's box",
            hint: "A triangle lies in the face by which the ray leaves the box: is its distance less than that of the face?",
            answer: |q| Self::misread(q, |q| lose_outside_of_boxes(q, BEFORE_THE_EXIT)),
        },
        Mistake {
            name: "takes the place of a triangle in its leaf for its number, and tests the triangles from 0 on in each leaf",
            hint: "A leaf holds the numbers 6 and 9: which two triangles does your loop test?",
            answer: |q| {
                Self::misread(q, |q| {
                    for leaf in &mut q.leaves {
                        leaf.triangles = (0..leaf.triangles.len() as u32).collect();
                    }
                })
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "wide_closest",
        width: 96,
        height: 54,
        alt: "Shingles on a slope, each in its colour",
        question: |x, y| WideClosest {
            ray: sample::ray(SLOPE.ray.origin, sample::pixel(x, y)),
            ..SLOPE.clone()
        },
        colour: |_, answer| search::colour(answer.hit.as_ref()),
    }];
}

/// The picture's shingles, in front of a camera.
static SLOPE: LazyLock<WideClosest> = LazyLock::new(|| {
    let shingles = (0..24).map(|i| {
        let (column, row) = ((i % 6) as f32, (i / 6) as f32);
        let at = vec3(
            0.65 * column - 1.7 + 0.25 * (row % 2.0),
            0.58 * row - 1.05,
            0.5 * row - 1.0,
        );
        [
            vec3(-0.4, -0.45, 0.32),
            vec3(0.4, -0.45, 0.26),
            vec3(0.0, 0.5, 0.0),
        ]
        .map(|p| p + at)
    });
    let ray = sample::ray(vec3(0.0, 0.0, 3.0), Vec3::NEG_Z);
    question(shingles.collect(), ray, Interval::AHEAD)
});

/// A search that goes wrong in some way.
fn search(q: &WideClosest, change: fn(&mut How)) -> WideClosestAnswer {
    let found = with_tree(q, |tree| search::search(tree, &Node::Branch(0), change));
    WideClosestAnswer {
        nodes: found.branches,
        tests: found.tests,
        hit: found.hit,
    }
}

/// Whatever is to be done with the question's tree.
fn with_tree<T>(q: &WideClosest, then: impl FnOnce(&Tree) -> T) -> T {
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
    then(&Tree {
        ray: &q.ray,
        within: q.within,
        triangles: &q.triangles,
        children: &|i| q.nodes[i as usize].children.iter().map(child).collect(),
    })
}

/// Four triangles to a leaf: so a few dozen make a tree in which the order of the search matters.
const SMALL_LEAVES: Cost = Cost {
    block_size: 4,
    most: 4,
    ..COST
};

/// A question about triangles in the tree that the reference builds, its root a node even if a leaf would do.
pub fn question(triangles: Vec<[Vec3; 3]>, ray: Ray, within: Interval) -> WideClosest {
    let facets = triangles.iter().zip(0..);
    let facets: Vec<_> = facets.map(|(&corners, id)| Facet { corners, id }).collect();
    let all = facets
        .iter()
        .fold(Aabb::EMPTY, |all, facet| all.union(&facet.bounds()));
    let tree = build_wide(facets, Method::Binned, &SMALL_LEAVES);
    let child = |(bounds, link): (Aabb, Link)| WideChild {
        min: bounds.min,
        max: bounds.max,
        leaf: u32::from(link.as_leaf().is_some()),
        index: link.index() as u32,
    };
    let node = |children: Vec<(Aabb, Link)>| WideNode {
        children: children.into_iter().map(child).collect(),
    };
    let mut nodes: Vec<_> = tree
        .nodes()
        .iter()
        .map(|old| node(old.children().collect()))
        .collect();
    if let Some(root) = tree.root().filter(|root| root.as_leaf().is_some()) {
        nodes.push(node(vec![(all, root)]));
    }
    let leaves = tree.leaves().iter().map(|leaf| WideLeaf {
        triangles: leaf.facets().collect(),
    });
    WideClosest {
        ray,
        within,
        nodes,
        leaves: leaves.collect(),
        triangles: triangles
            .into_iter()
            .map(|[p0, p1, p2]| Corners { p0, p1, p2 })
            .collect(),
    }
}

/// A right search that counts the leaves that it looks into as nodes.
fn search_counting_leaves(q: &WideClosest) -> WideClosestAnswer {
    let found = with_tree(q, |tree| search::search(tree, &Node::Branch(0), |_| {}));
    WideClosestAnswer {
        nodes: found.branches + found.leaves,
        tests: found.tests,
        hit: found.hit,
    }
}

/// Shrinks each triangle in a leaf to a point, unless the ray hits it within a part of the distances that count.
fn lose_outside_of_boxes(q: &mut WideClosest, part: Part) {
    let children = q.nodes.iter().flat_map(|node| &node.children);
    for child in children.filter(|child| child.leaf != 0) {
        let bounds = Aabb::new(child.min, child.max);
        for &id in &q.leaves[child.index as usize].triangles {
            let triangle = &mut q.triangles[id as usize];
            lose_outside(triangle, &bounds, (&q.ray, q.within), part);
        }
    }
}
