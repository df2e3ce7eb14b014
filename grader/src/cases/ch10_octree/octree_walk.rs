//! `octree_walk`: random questions, judge and mistakes.

mod walks;

use super::octree_tree::{inner, leaf};
use crate::{
    Flaw, Graded, Mistake, Relation, Verdict,
    passage::{self, passage},
    sample,
};
use glam::Vec3;
use rand::RngExt;
use raybook::inside::octree::{Kind, child_cell};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray, slab};
use raybook_workbook::exercises::ch10_octree::OctreeWalk;
use walks::{
    below, chosen, descend, down, ends_only, fill_empty_leaves, in_turn, levels, met, mirror,
    missed, nearest_only, numbered, octant, ordered, walked,
};

/// The leaves' cells by the nodes' numbers, and which nodes are leaves that are not empty; empty boxes for inner nodes.
pub(super) fn cells(q: &OctreeWalk) -> (Vec<Aabb>, Vec<u32>) {
    let tree = q.tree();
    let mut cells = vec![Aabb::EMPTY; tree.nodes.len()];
    let mut leaves = Vec::new();
    for place in tree.places() {
        if let Kind::Leaf { count, .. } = tree.nodes[place.node as usize].kind() {
            cells[place.node as usize] = place.cell;
            if count > 0 {
                leaves.push(place.node);
            }
        }
    }
    leaves.sort_unstable();
    (cells, leaves)
}

impl Graded for OctreeWalk {
    fn random(rng: &mut Pcg) -> OctreeWalk {
        let (min, size) = (sample::point(rng, 3.0), sample::number(rng, 1.0, 6.0));
        let mut nodes = vec![inner(1)];
        let mut names = 0;
        let mut add_leaf = |rng: &mut Pcg| {
            let count = if rng.random_bool(0.25) {
                0
            } else {
                rng.random_range(1..4)
            };
            names += count;
            leaf(names - count, count)
        };
        for _ in 0..8 {
            nodes.push(add_leaf(rng));
        }
        for child in 1..9 {
            if rng.random_bool(0.35) {
                nodes[child] = inner(nodes.len() as u32);
                for _ in 0..8 {
                    nodes.push(add_leaf(rng));
                }
            }
        }
        let inside = min + size * (sample::point(rng, 0.35) + 0.5);
        let origin = if rng.random_bool(0.3) {
            min + size * (sample::point(rng, 0.5) + 0.5)
        } else {
            inside + size * 1.5 * *sample::direction(rng)
        };
        let end = if rng.random_bool(0.3) {
            size
        } else {
            f32::INFINITY
        };
        OctreeWalk {
            ray: Ray::new(origin, Dir3::new_or(inside - origin, Dir3::X)),
            within: Interval::new(0.0, end),
            min,
            max: min + size,
            nodes,
        }
    }

    fn is_sound(q: &OctreeWalk) -> bool {
        sample::is_cube(q.min, q.max)
    }

    fn judge(q: &OctreeWalk, golden: &Vec<u32>, got: &Vec<u32>) -> Verdict {
        let (cells, leaves) = cells(q);
        if let Some(node) = got.iter().find(|node| !leaves.contains(node)) {
            let what = match q.nodes.get(*node as usize) {
                None => "does not exist",
                Some(row) if row.inner != 0 => "is no leaf",
                Some(_) => "is an empty leaf",
            };
            return Err(format!("node {node} {what}"));
        }
        passage("leaf", &cells, &q.ray, q.within, golden, got)
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "does not exist",
            name: "names nodes that are not there",
            hint: "What is the number of a node's child?",
        },
        Flaw {
            complaint: "is no leaf",
            name: "names nodes that are no leaves",
            hint: "Which number of a node tells whether it is a leaf, and what do you return of it?",
        },
        Flaw {
            complaint: "is an empty leaf",
            name: "names empty leaves too",
            hint: "What is there to test in a leaf without shapes?",
        },
        passage::TWICE,
        passage::ASIDE,
        passage::LATE,
        passage::MISSING,
        passage::NOTHING,
    ];

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| OctreeWalk {
        ray: sample::moved(&q.ray),
        min: q.min + sample::METRE,
        max: q.max + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "visits the children in the order of their numbers",
            hint: "A ray that runs towards −x meets the upper half first.",
            answer: |q| in_turn(q, 0),
        },
        Mistake {
            name: "visits every leaf",
            hint: "Which leaves does the ray never enter?",
            answer: |q| cells(q).1,
        },
        Mistake {
            name: "stops after the first leaf",
            hint: "If the first leaf has no hit, where is the next one?",
            answer: |q| OctreeWalk::right(q).into_iter().take(1).collect(),
        },
        Mistake {
            name: "goes into the nearest child of each node only",
            hint: "The nearest child may have no hit: which child does the ray pass through next?",
            answer: nearest_only,
        },
        Mistake {
            name: "does not go below the children of the root",
            hint: "A child of the root may have children of its own: is it opened like the root?",
            answer: |q| {
                let root = &q.nodes[0];
                let near = |leaf: &u32| *leaf < root.first + 8;
                let all = OctreeWalk::right(q).into_iter();
                all.filter(|leaf| root.inner == 0 || near(leaf)).collect()
            },
        },
        Mistake {
            name: "goes on beyond the end of the interval",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| walked(q, q.ray, Interval::new(q.within.min, f32::INFINITY)),
        },
        Mistake {
            name: "begins behind the ray's origin",
            hint: "Can the ray enter a leaf that lies behind its origin?",
            answer: |q| walked(q, q.ray, Interval::new(f32::NEG_INFINITY, q.within.max)),
        },
        Mistake {
            name: "asks for the interval at the root only",
            hint: "The root holds the interval's part of the ray: does each child too?",
            answer: |q| {
                let root = Aabb {
                    min: q.min,
                    max: q.max,
                };
                if slab::clip(&root, &q.ray, q.within).is_some() {
                    let all = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
                    walked(q, q.ray, all)
                } else {
                    Vec::new()
                }
            },
        },
        Mistake {
            name: "loses rays that do not move along some axis",
            hint: "If the ray does not move along x, how far is it to the middle plane in x, and what is 0 · ∞?",
            answer: |q| {
                let along = q.ray.direction.to_array().contains(&0.0);
                if along {
                    Vec::new()
                } else {
                    OctreeWalk::right(q)
                }
            },
        },
        Mistake {
            name: "visits the leaves from back to front",
            hint: "In which leaf would the nearest hit be?",
            answer: |q| OctreeWalk::right(q).into_iter().rev().collect(),
        },
        Mistake {
            name: "names empty leaves too",
            hint: "What is there to be hit in a leaf without shapes?",
            answer: |q| Self::misread(q, fill_empty_leaves),
        },
        Mistake {
            name: "takes z for the lowest bit of a child's number, and x for the highest",
            hint: "Child 1 is the upper one along which axis?",
            answer: |q| {
                let turned = |v: glam::Vec3| glam::vec3(v.z, v.y, v.x);
                OctreeWalk::right(&OctreeWalk {
                    ray: Ray::new(
                        turned(q.ray.origin),
                        Dir3::new_or(turned(*q.ray.direction), Dir3::X),
                    ),
                    min: turned(q.min),
                    max: turned(q.max),
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "leaves out the last leaf",
            hint: "When does your loop end: before the last leaf is listed, or after it?",
            answer: |q| {
                let mut leaves = OctreeWalk::right(q);
                leaves.pop();
                leaves
            },
        },
        Mistake {
            name: "leaves out the first leaf",
            hint: "Is the first leaf listed before the first step, or after it?",
            answer: |q| OctreeWalk::right(q).into_iter().skip(1).collect(),
        },
        Mistake {
            name: "takes the order of the children from the direction's x only",
            hint: "A ray that runs towards −y meets the upper half along y first: which bits of a child's number do you turn?",
            answer: |q| ordered(q, |d| u32::from(d[0] < 0.0)),
        },
        Mistake {
            name: "turns the order of the children round only where the ray moves down along all axes",
            hint: "Each axis has a bit of its own: which of them do you turn for a ray that moves down along x only?",
            answer: |q| ordered(q, |d| if d.iter().all(|d| *d < 0.0) { 7 } else { 0 }),
        },
        Mistake {
            name: "turns the order of all children round where the ray moves down along any axis",
            hint: "Each axis has a bit of its own: which of them do you turn for a ray that moves down along x only?",
            answer: |q| ordered(q, |d| if d.iter().any(|d| *d < 0.0) { 7 } else { 0 }),
        },
        Mistake {
            name: "does not turn the order of the children round along x",
            hint: "Each axis has a bit of its own: which of them do you turn for a ray that moves down along x only?",
            answer: |q| ordered(q, |d| down(d) & 0b110),
        },
        Mistake {
            name: "does not turn the order of the children round along y",
            hint: "Each axis has a bit of its own: which of them do you turn for a ray that moves down along y only?",
            answer: |q| ordered(q, |d| down(d) & 0b101),
        },
        Mistake {
            name: "does not turn the order of the children round along z",
            hint: "Each axis has a bit of its own: which of them do you turn for a ray that moves down along z only?",
            answer: |q| ordered(q, |d| down(d) & 0b011),
        },
        Mistake {
            name: "exchanges the bits of x and z in the order of the children",
            hint: "Which axis has the lowest bit of a child's number?",
            answer: |q| {
                ordered(q, |d| {
                    u32::from(d[2] < 0.0) | u32::from(d[1] < 0.0) << 1 | u32::from(d[0] < 0.0) << 2
                })
            },
        },
        Mistake {
            name: "returns a leaf's `first`, not the leaf's number",
            hint: "A leaf's `first` is a place in another list: which number names the leaf itself?",
            answer: |q| {
                OctreeWalk::right(q)
                    .into_iter()
                    .map(|leaf| q.nodes[leaf as usize].first)
                    .collect()
            },
        },
        Mistake {
            name: "looks at four children only",
            hint: "How many children has a node of an octree?",
            answer: |q| {
                let (all, mut open) = (OctreeWalk::right(q), vec![0]);
                let mut seen = Vec::new();
                while let Some(node) = open.pop() {
                    let row = &q.nodes[node as usize];
                    seen.push(node);
                    if row.inner == 1 {
                        open.extend(row.first..row.first + 4);
                    }
                }
                all.into_iter().filter(|leaf| seen.contains(leaf)).collect()
            },
        },
        Mistake {
            name: "lists nodes with children too",
            hint: "Which nodes hold shapes, and which hold nodes?",
            answer: |q| {
                let mut found = Vec::new();
                below(q, 0, mirror(q.ray.direction.to_array()), &mut |node| {
                    if q.nodes[node as usize].inner == 1 || q.nodes[node as usize].count > 0 {
                        found.push(node);
                    }
                });
                found
            },
        },
        Mistake {
            name: "leaves out the leaf in which the interval begins",
            hint: "Stand inside a leaf: is the ray in it from the beginning, or must it enter it first?",
            answer: |q| {
                let cells = cells(q).0;
                let start = q.ray.at(q.within.min);
                let is_around = |leaf: &u32| {
                    let cell = &cells[*leaf as usize];
                    cell.min.cmplt(start).all() && start.cmplt(cell.max).all()
                };
                let all = OctreeWalk::right(q).into_iter();
                all.filter(|leaf| !is_around(leaf)).collect()
            },
        },
        Mistake {
            name: "sorts the leaves by the distances of their middles from the ray's origin",
            hint: "A ray begins near the edge of a large leaf: how far is it to the middle of this leaf, and to that of a small one beside it?",
            answer: |q| {
                let cells = cells(q).0;
                let middle = |leaf: u32| cells[leaf as usize].center();
                let far = |leaf: u32| middle(leaf).distance(q.ray.origin);
                let mut leaves = Self::right(q);
                leaves.sort_by(|a, b| far(*a).total_cmp(&far(*b)));
                leaves
            },
        },
        Mistake {
            name: "takes the order of the children from the direction's largest component only",
            hint: "A ray may move down along two axes: which bits of a child's number do you turn?",
            answer: |q| {
                ordered(q, |d| {
                    let axis = Vec3::from(d).abs().max_position();
                    u32::from(d[axis] < 0.0) << axis
                })
            },
        },
        Mistake {
            name: "sorts the leaves by the distances of their least corners from the ray's origin",
            hint: "A ray that runs towards −x enters a leaf far from the leaf's least corner: which distance tells when?",
            answer: |q| {
                let cells = cells(q).0;
                let far = |leaf: &u32| cells[*leaf as usize].min.distance(q.ray.origin);
                let mut leaves = Self::right(q);
                leaves.sort_by(|a, b| far(a).total_cmp(&far(b)));
                leaves
            },
        },
        Mistake {
            name: "ends at the first empty leaf",
            hint: "In an empty leaf there is nothing to visit: where does the ray go on?",
            answer: |q| {
                let leaves = Self::misread(q, fill_empty_leaves).into_iter();
                leaves
                    .take_while(|leaf| q.nodes[*leaf as usize].count > 0)
                    .collect()
            },
        },
        Mistake {
            name: "mirrors a ray that runs backwards, and does not turn the children's numbers",
            hint: "You mirror the ray so that it runs forwards: which child of the octree is child 0 of the mirrored one?",
            answer: |q| {
                let (mut origin, mut direction) = (q.ray.origin, *q.ray.direction);
                for axis in 0..3 {
                    if direction[axis] < 0.0 {
                        origin[axis] = q.min[axis] + q.max[axis] - origin[axis];
                        direction[axis] = -direction[axis];
                    }
                }
                let ray = Ray::new(origin, Dir3::new_or(direction, Dir3::X));
                walked(q, ray, q.within)
            },
        },
        Mistake {
            name: "takes a bit that is set for the lower half",
            hint: "Child 0 is at the least corner: in which half along x is child 1?",
            answer: |q| numbered(q, |_, first, i| first + (7 - i)),
        },
        Mistake {
            name: "takes 8 · node + 1 + i for the number of child i, as in a full tree",
            hint: "Only some nodes have children: which number of a node says where its children begin?",
            answer: |q| numbered(q, |node, _, i| 8 * node + 1 + i),
        },
        Mistake {
            name: "lists the leaves level by level, as they come from a queue",
            hint: "A near child has children, and a far one is a leaf: which leaf does the ray pass first?",
            answer: |q| {
                let level = levels(q);
                let mut leaves = Self::right(q);
                leaves.sort_by_key(|leaf| level[*leaf as usize]);
                leaves
            },
        },
        Mistake {
            name: "visits the children from 0 to 7, or backwards where the sum of the direction's components is negative",
            hint: "A ray that goes up quickly and a little to the left: in which order does it meet the children along x, and along y?",
            answer: |q| ordered(q, |d| if d.iter().sum::<f32>() < 0.0 { 7 } else { 0 }),
        },
        Mistake {
            name: "visits the children from 0 to 7, or backwards where the direction's x is negative",
            hint: "A ray goes up along one axis and down along another: in which order does it meet the children along each of them?",
            answer: |q| ordered(q, |d| if d[0] < 0.0 { 7 } else { 0 }),
        },
        Mistake {
            name: "visits the children from 0 to 7, or backwards where the direction's y is negative",
            hint: "A ray goes up along one axis and down along another: in which order does it meet the children along each of them?",
            answer: |q| ordered(q, |d| if d[1] < 0.0 { 7 } else { 0 }),
        },
        Mistake {
            name: "visits the children from 0 to 7, or backwards where the direction's z is negative",
            hint: "A ray goes up along one axis and down along another: in which order does it meet the children along each of them?",
            answer: |q| ordered(q, |d| if d[2] < 0.0 { 7 } else { 0 }),
        },
        Mistake {
            name: "visits the children from 0 to 7, or backwards where the direction's largest component is negative",
            hint: "A ray goes up along one axis and down along another: in which order does it meet the children along each of them?",
            answer: |q| {
                ordered(q, |d| {
                    let axis = Vec3::from(d).abs().max_position();
                    if d[axis] < 0.0 { 7 } else { 0 }
                })
            },
        },
        Mistake {
            name: "takes the order of the children, at all levels, from the root's octant in which the ray begins",
            hint: "A ray begins before the root's middle plane and moves away from it: which half of a small cell on its way does it meet first?",
            answer: |q| in_turn(q, octant(q, q.ray.origin)),
        },
        Mistake {
            name: "takes the order of the children, at all levels, from the root's octant that the ray enters first",
            hint: "A ray enters the root before its middle plane and moves away from it: which half of a small cell on its way does it meet first?",
            answer: |q| {
                let root = Aabb::new(q.min, q.max);
                let inside = slab::clip(&root, &q.ray, q.within);
                inside.map_or(Vec::new(), |inside| {
                    in_turn(q, octant(q, q.ray.at(inside.min)))
                })
            },
        },
        Mistake {
            name: "visits only the child in which the ray enters a node and the child in which it leaves the node",
            hint: "A ray goes slantwise through a cell that is cut in eight: through how many children can it pass, and which are those in between?",
            answer: ends_only,
        },
        Mistake {
            name: "visits at most two children of a node",
            hint: "How many middle planes has a cell, and how many children does a ray pass through that crosses all of them?",
            answer: |q| chosen(q, |children| met(children).take(2).collect()),
        },
        Mistake {
            name: "visits at most three children of a node",
            hint: "How many middle planes has a cell, and how many children does a ray pass through that crosses all of them?",
            answer: |q| chosen(q, |children| met(children).take(3).collect()),
        },
        Mistake {
            name: "visits no more children of a node after the first that the ray misses",
            hint: "A ray misses one child: can it meet a later one? What leaves your loop, and what only goes on to the next child?",
            answer: |q| chosen(q, |children| met(&children[..missed(children)]).collect()),
        },
        Mistake {
            name: "takes the cells of the root's children for those of the children of any node",
            hint: "A child of the root is cut, too: where is the middle of its own cell?",
            answer: |q| {
                let root = Aabb::new(q.min, q.max);
                let mut found = Vec::new();
                descend(
                    q,
                    (0, root),
                    &|_, i| child_cell(&root, i),
                    &|children| met(children).collect(),
                    &mut found,
                );
                found
            },
        },
        Mistake {
            name: "sorts the leaves by how far along the ray their middles are",
            hint: "A ray cuts off a corner of a large leaf, and its middle lies far ahead: when does the ray enter this leaf, and when the small one beside it?",
            answer: |q| {
                let cells = cells(q).0;
                let way = |leaf: u32| cells[leaf as usize].center() - q.ray.origin;
                let far = |leaf: u32| way(leaf).dot(*q.ray.direction);
                let mut leaves = Self::right(q);
                leaves.sort_by(|a, b| far(*a).total_cmp(&far(*b)));
                leaves
            },
        },
        Mistake {
            name: "returns the leaves in the order of their numbers",
            hint: "A leaf with a small number may lie behind one with a large number: in which order does the ray meet them?",
            answer: |q| {
                let mut leaves = OctreeWalk::right(q);
                leaves.sort_unstable();
                leaves
            },
        },
    ];
}
