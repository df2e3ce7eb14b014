//! `bvh_closest`: random questions, judge and mistakes.

mod walk;

use super::tree;
use crate::search::{BEFORE_THE_EXIT, BEHIND_THE_ENTRY, INSIDE, Part, lose_outside};
use crate::{
    Flaw, Graded, Mistake, Picture, Relation, Verdict, judge, sample, search, search::By,
    search::Found, search::How, search::Keeps, search::Node, search::Order, search::Tree, traits,
};
use glam::{Vec3, vec3};
use raybook::accel::bvh::build::Method;
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch07_mesh::Corners;
use raybook_workbook::exercises::ch11_bvh::{BvhClosest, BvhClosestAnswer};
use raybook_workbook::tree_rows::{BoxRow, NodeRow};
use std::ops::Range;
use std::sync::LazyLock;
use walk::{Until, walk};

impl Graded for BvhClosest {
    fn random(rng: &mut Pcg) -> BvhClosest {
        let triangles = (0..24).map(|_| {
            let center = sample::point(rng, 2.0);
            std::array::from_fn(|_| center + sample::point(rng, 1.0))
        });
        let triangles: Vec<_> = triangles.collect();
        let origin = sample::point(rng, 4.0);
        let toward = sample::point(rng, 1.5) - origin;
        let end = sample::end(rng, 0.2, 2.0, 5.0);
        let ray = Ray::new(origin, Dir3::new_or(toward, Dir3::X));
        question(&triangles, ray, Interval::new(0.0, end))
    }

    fn judge(q: &BvhClosest, golden: &BvhClosestAnswer, got: &BvhClosestAnswer) -> Verdict {
        judge::nearest(golden.hit.as_ref(), got.hit.as_ref())?;
        let least = with_tree(q, |tree| {
            search::least(tree, &node(q, 0), golden.hit.as_ref())
        });
        search::counted("triangle tests", least.tests, got.tests)?;
        search::counted("box tests", least.boxes, got.boxes)?;
        few("triangle", golden.tests, got.tests)?;
        few("box", golden.boxes, got.boxes)?;
        if golden.hit.is_none() {
            let without_hit = with_tree(q, |tree| search::without_hit(tree, &node(q, 0)));
            tests_without_hit(without_hit.tests, got.tests)?;
        }
        Ok(())
    }

    fn traits(_q: &BvhClosest, got: &BvhClosestAnswer) -> Vec<f64> {
        let (t, id) = got
            .hit
            .as_ref()
            .map_or((-1.0, -1.0), |hit| (hit.t, hit.id as f32));
        vec![
            traits::log(1.0 + f64::from(got.boxes)),
            traits::log(1.0 + f64::from(got.tests)),
            f64::from(t.clamp(-100.0, 100.0)),
            f64::from(id.min(100.0)) / 10.0,
        ]
    }

    const EFFORT: usize = 2;

    const FLAWS: &'static [Flaw] = search::FLAWS;

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| {
        let moved = |node: &NodeRow| NodeRow {
            min: node.min + sample::METRE,
            max: node.max + sample::METRE,
            ..node.clone()
        };
        BvhClosest {
            ray: sample::moved(&q.ray),
            nodes: q.nodes.iter().map(moved).collect(),
            triangles: q.triangles.iter().map(sample::moved_triangle).collect(),
            ..q.clone()
        }
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "tests every triangle",
            hint: "The hit is right, but the boxes are there to spare you tests: ask them first.",
            answer: |q| BvhClosestAnswer {
                boxes: 0,
                ..search(q, |how| how.asks = false)
            },
        },
        Mistake {
            name: "opens every box",
            hint: "What does it mean for all that is in a box if the ray misses the box?",
            answer: |q| search(q, |how| how.asks = false),
        },
        Mistake {
            name: "does not shorten the interval for the second child, nor for any box behind a hit",
            hint: "Something was hit in the first child: which boxes are still worth opening?",
            answer: |q| search(q, |how| how.shortens = false),
        },
        Mistake {
            name: "returns the last hit instead of the nearest",
            hint: "A hit in the second child may lie behind one in the first: which one stays?",
            answer: |q| search(q, |how| (how.shortens, how.keeps) = (false, Keeps::Last)),
        },
        Mistake {
            name: "opens the farther child first",
            hint: "Where is the nearest hit more likely, and what is spared if you find it first?",
            answer: |q| search(q, |how| how.order = Order::Farthest),
        },
        Mistake {
            name: "never opens the farther child",
            hint: "The nearer box may be empty where the ray passes through it.",
            answer: |q| search(q, |how| how.opens = 1),
        },
        Mistake {
            name: "stops at the first leaf with a hit",
            hint: "Boxes may overlap: can a triangle of the farther box be nearer?",
            answer: |q| search(q, |how| how.stops = true),
        },
        Mistake {
            name: "ignores the interval's min",
            hint: "Can the ray hit what lies behind its origin?",
            answer: |q| Self::misread(q, |q| q.within.min = f32::NEG_INFINITY),
        },
        Mistake {
            name: "begins the interval at 0 again once something is hit",
            hint: "A hit ends the interval at its distance: what becomes of the interval's beginning?",
            answer: |q| search(q, |how| how.begins_again = true),
        },
        Mistake {
            name: "opens a waiting node without asking again whether it is behind the hit",
            hint: "Something was hit since the node was put aside: can anything in it still be nearer?",
            answer: |q| search(q, |how| how.drops = false),
        },
        Mistake {
            name: "opens the first child first, whichever is nearer",
            hint: "Where is the nearest hit more likely, and what is spared if you find it first?",
            answer: |q| search(q, |how| how.order = Order::Stored),
        },
        Mistake {
            name: "opens the second child first, whichever is nearer",
            hint: "The child that is put on the stack last is taken off first: which child should that be?",
            answer: |q| search(q, |how| how.order = Order::Backwards),
        },
        Mistake {
            name: "tests no more triangles of a leaf after the first that is hit",
            hint: "Two triangles of a leaf are hit: which one is tested first, and which one is nearer?",
            answer: |q| search(q, |how| how.stops_in_leaf = true),
        },
        Mistake {
            name: "asks the first child's box for both children",
            hint: "Each child has a box of its own: which node's `min` and `max` do you ask for the second child?",
            answer: |q| search(q, |how| how.asks_the_first = true),
        },
        Mistake {
            name: "looks at the first child of each branch twice, and at the second never",
            hint: "A branch has two children: what are their numbers?",
            answer: |q| search(q, |how| how.looks_twice = true),
        },
        Mistake {
            name: "returns the number of the first triangle in the leaf that is hit",
            hint: "A leaf of two triangles, of which the second is hit: what is its number?",
            answer: |q| {
                let mut answer = Self::right(q);
                if let Some(hit) = &mut answer.hit {
                    let leaf = leaf_of(q, hit.id);
                    hit.id = leaf.map_or(hit.id, |leaf| leaf.first);
                }
                answer
            },
        },
        Mistake {
            name: "leaves out the last triangle of each leaf",
            hint: "A leaf of one triangle: how often does your loop over its triangles go round?",
            answer: |q| search(q, |how| how.forgets_the_last = true),
        },
        Mistake {
            name: "leaves out the first triangle of each leaf",
            hint: "A leaf of one triangle: how often does your loop over its triangles go round?",
            answer: |q| search(q, |how| how.forgets_the_first = true),
        },
        Mistake {
            name: "begins to count the tests at 1",
            hint: "A ray that misses all boxes: how many triangles does it test?",
            answer: |q| {
                let right = q.right();
                BvhClosestAnswer {
                    tests: right.tests + 1,
                    ..right
                }
            },
        },
        Mistake {
            name: "keeps the first hit that it finds",
            hint: "Boxes may overlap: can a triangle that is tested later be nearer?",
            answer: |q| search(q, |how| (how.shortens, how.keeps) = (false, Keeps::First)),
        },
        Mistake {
            name: "returns the number of the triangle in its leaf",
            hint: "Where does the number of a triangle come from: its place in the list of all triangles, or in its leaf?",
            answer: |q| {
                let mut answer = Self::right(q);
                if let Some(hit) = &mut answer.hit {
                    let leaf = leaf_of(q, hit.id);
                    hit.id -= leaf.map_or(0, |leaf| leaf.first);
                }
                answer
            },
        },
        Mistake {
            name: "counts one box for each branch",
            hint: "Both children's boxes are asked when a branch is opened: how many tests are that?",
            answer: |q| {
                let right = q.right();
                BvhClosestAnswer {
                    boxes: right.boxes / 2,
                    ..right
                }
            },
        },
        Mistake {
            name: "tests only the first triangle of each leaf",
            hint: "A leaf of two triangles: how often does your loop go round?",
            answer: |q| search(q, |how| how.only_the_first = true),
        },
        Mistake {
            name: "counts only the boxes that are met",
            hint: "Is a test work that finds nothing?",
            answer: |q| search(q, |how| how.counts_met = true),
        },
        Mistake {
            name: "counts the triangles of a leaf as one test",
            hint: "A leaf of two triangles: how many triangles does a ray test there?",
            answer: |q| counting(q, |found| (found.boxes, found.leaves)),
        },
        Mistake {
            name: "counts only the triangles that are hit",
            hint: "Is a test work that finds nothing?",
            answer: |q| search(q, |how| how.counts_hits = true),
        },
        Mistake {
            name: "tests triangles from 0 on, not from the interval's min on",
            hint: "A box may reach into the interval, and a triangle in it lie before: which distances count?",
            answer: |q| search(q, |how| how.tests_from_0 = true),
        },
        Mistake {
            name: "looks at the first child of each branch only",
            hint: "A branch has two children: what is in the second one?",
            answer: |q| search(q, |how| how.looks_at = 1),
        },
        Mistake {
            name: "returns the first hit that it finds, and looks no further",
            hint: "Another triangle of the same leaf, or of a box that overlaps, may be nearer: when is the search over?",
            answer: |q| search(q, |how| (how.stops, how.stops_in_leaf) = (true, true)),
        },
        Mistake {
            name: "counts the nodes that are visited, not the boxes that are tested",
            hint: "A branch is opened: how many boxes are tested then, and is the root's among them?",
            answer: |q| counting(q, |found| (found.branches + found.leaves, found.tests)),
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
            name: "returns the number of the leaf's node",
            hint: "A leaf of two triangles, of which the second is hit: which number tells the two apart?",
            answer: |q| {
                let mut answer = Self::right(q);
                if let Some(hit) = &mut answer.hit {
                    let leaf = leaf_with(q, hit.id);
                    hit.id = leaf.map_or(hit.id, |leaf| leaf as u32);
                }
                answer
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
            name: "ignores the interval's max",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| Self::misread(q, |q| q.within.max = f32::INFINITY),
        },
        Mistake {
            name: "goes by where the ray leaves the boxes, not by where it enters them",
            hint: "A large box may begin near and end far away: can the nearest hit be in it? By which end do you choose, and stop?",
            answer: |q| search(q, |how| how.by = By::Exit),
        },
        Mistake {
            name: "goes by where the ray passes the boxes' middles, not by where it enters the boxes",
            hint: "A large box may begin near, and its middle be far away: can the nearest hit be in it? By which distance do you choose, and stop?",
            answer: |q| search(q, |how| how.by = By::Middle),
        },
        Mistake {
            name: "goes by the middle of the ray's stay in the boxes, not by where it enters them",
            hint: "A large box may begin near and end far away: can the nearest hit be at its beginning? By which distance do you choose, and stop?",
            answer: |q| search(q, |how| how.by = By::Stay),
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
            name: "ends the loop over a leaf's triangles at its count, and begins it at its `first`",
            hint: "A leaf of two triangles begins at triangle 6: what are the numbers of its triangles, and at which of them does your loop end?",
            answer: |q| in_leaves(q, |first, count| first..count),
        },
        Mistake {
            name: "tests the triangles from 0 on in each leaf, as many as the leaf has",
            hint: "A leaf of two triangles begins at triangle 6: which triangles does your loop test?",
            answer: |q| in_leaves(q, |_, count| 0..count),
        },
        Mistake {
            name: "asks the second child only if the ray misses the first (else if)",
            hint: "A ray meets both children of a branch: how many of your conditions are asked?",
            answer: |q| walked(q, Until::Met),
        },
        Mistake {
            name: "asks the second child only if the ray meets the first",
            hint: "A ray misses the first child: does it miss the second, too? What leaves your loop, and what only goes on to the next child?",
            answer: |q| walked(q, Until::Missed),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "bvh_closest",
        width: 96,
        height: 54,
        alt: "Tiles on a slanted wall, each in its colour",
        question: |x, y| BvhClosest {
            ray: sample::ray(WALL.ray.origin, sample::pixel(x, y)),
            ..WALL.clone()
        },
        colour: |_, answer| search::colour(answer.hit.as_ref()),
    }];
}

/// The picture's tiles, in front of a camera.
static WALL: LazyLock<BvhClosest> = LazyLock::new(|| {
    let tiles = (0..15).map(|i| {
        let at = vec3((i % 5) as f32 - 2.0, (i / 5) as f32 - 1.0, 0.0);
        let tilt = vec3(0.0, 0.0, 0.3 * at.x);
        let [p0, p1, p2] = [
            vec3(-0.45, -0.4, 0.0),
            vec3(0.45, -0.4, 0.2),
            vec3(0.0, 0.45, -0.1),
        ];
        [p0, p1, p2].map(|p| 0.75 * (p + at + tilt))
    });
    let ray = sample::ray(vec3(0.0, 0.0, 3.0), Vec3::NEG_Z);
    question(&tiles.collect::<Vec<_>>(), ray, Interval::AHEAD)
});

/// Not many more tests than the reference's: half as many, and four, for another sound order of the children.
pub(super) fn few(what: &str, golden: u32, got: u32) -> Verdict {
    if u64::from(got) <= 3 * u64::from(golden) / 2 + 4 {
        Ok(())
    } else {
        Err(format!(
            "the hit is right, but it took {got} {what} tests; the reference needs {golden}"
        ))
    }
}

/// No more triangles than those of all leaves that the ray enters: where nothing is hit, no order matters. (A box may be tested
/// once more, when a waiting node's turn comes.)
fn tests_without_hit(most: u32, got: u32) -> Verdict {
    if got <= most {
        Ok(())
    } else {
        Err(format!(
            "the hit is right, but it took {got} triangle tests; where nothing is hit, every search makes {most}"
        ))
    }
}

/// The leaf that holds a triangle.
fn leaf_of(q: &BvhClosest, triangle: u32) -> Option<&NodeRow> {
    leaf_with(q, triangle).map(|leaf| &q.nodes[leaf])
}

/// The number of the leaf that holds a triangle.
fn leaf_with(q: &BvhClosest, triangle: u32) -> Option<usize> {
    let holds = |node: &NodeRow| (node.first..node.first + node.count).contains(&triangle);
    q.nodes.iter().position(holds)
}

/// The right search, with other counts of boxes and of tests.
fn counting(q: &BvhClosest, count: fn(&Found) -> (u32, u32)) -> BvhClosestAnswer {
    let found = with_tree(q, |tree| search::search(tree, &node(q, 0), |_| {}));
    let (boxes, tests) = count(&found);
    BvhClosestAnswer {
        boxes,
        tests,
        hit: found.hit,
    }
}

/// A search that goes wrong in some way.
fn search(q: &BvhClosest, change: fn(&mut How)) -> BvhClosestAnswer {
    answer_of(with_tree(q, |tree| {
        search::search(tree, &node(q, 0), change)
    }))
}

/// What is in a node.
fn node(q: &BvhClosest, i: u32) -> Node {
    let NodeRow { first, count, .. } = q.nodes[i as usize];
    match count {
        0 => Node::Branch(i),
        _ => Node::Leaf((first..first + count).collect()),
    }
}

/// Whatever is to be done with the question's tree.
fn with_tree<T>(q: &BvhClosest, then: impl FnOnce(&Tree) -> T) -> T {
    of_nodes(q, &|i| node(q, i), then)
}

/// The same, with other contents of the nodes.
fn of_nodes<T>(q: &BvhClosest, node: &dyn Fn(u32) -> Node, then: impl FnOnce(&Tree) -> T) -> T {
    let child = |i: u32| {
        let NodeRow { min, max, .. } = q.nodes[i as usize];
        (Aabb { min, max }, node(i))
    };
    then(&Tree {
        ray: &q.ray,
        within: q.within,
        triangles: &q.triangles,
        children: &|i| {
            let left = q.nodes[i as usize].first;
            vec![child(left), child(left + 1)]
        },
    })
}

/// The question of a ray through these triangles, in a tree of small leaves.
pub fn question(triangles: &[[Vec3; 3]], ray: Ray, within: Interval) -> BvhClosest {
    let boxes: Vec<_> = triangles
        .iter()
        .map(|&corners| {
            let Aabb { min, max } = Aabb::of(corners);
            BoxRow { min, max }
        })
        .collect();
    let tree = tree(&boxes, Method::Binned, 2);
    let in_order = tree.order.iter().map(|&i| {
        let [p0, p1, p2] = triangles[i as usize];
        Corners { p0, p1, p2 }
    });
    BvhClosest {
        ray,
        within,
        triangles: in_order.collect(),
        nodes: tree.nodes,
    }
}

/// Shrinks each triangle in a leaf to a point, unless the ray hits it within a part of the distances that count.
fn lose_outside_of_boxes(q: &mut BvhClosest, part: Part) {
    // The root's box is not asked: a root that is a leaf is tested within all distances.
    for node in q.nodes.iter().skip(1).filter(|node| node.count > 0) {
        let bounds = Aabb::new(node.min, node.max);
        let triangles = q.triangles.iter_mut().skip(node.first as usize);
        for triangle in triangles.take(node.count as usize) {
            lose_outside(triangle, &bounds, (&q.ray, q.within), part);
        }
    }
}

/// The right search, but for the triangles of a leaf: their numbers are made of the leaf's `first` and `count`.
fn in_leaves(q: &BvhClosest, ids: fn(u32, u32) -> Range<u32>) -> BvhClosestAnswer {
    let node = |i: u32| {
        let NodeRow { first, count, .. } = q.nodes[i as usize];
        match count {
            0 => Node::Branch(i),
            _ => Node::Leaf(ids(first, count).collect()),
        }
    };
    answer_of(of_nodes(q, &node, |tree| {
        search::search(tree, &node(0), |_| {})
    }))
}

/// The answer of a search that asks no more children of a branch after one that is met, or missed.
fn walked(q: &BvhClosest, until: Until) -> BvhClosestAnswer {
    answer_of(with_tree(q, |tree| walk(tree, &node(q, 0), until)))
}

/// What is answered after a search.
fn answer_of(found: Found) -> BvhClosestAnswer {
    BvhClosestAnswer {
        boxes: found.boxes,
        tests: found.tests,
        hit: found.hit,
    }
}
