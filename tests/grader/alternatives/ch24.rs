//! Chapter 24: wide trees.

use crate::alternatives::student::{Alternative, Answer, Question, Ray};
use crate::alternatives::triangle::{Corners, plane_then_inside, volumes};
use glam::DVec3;
use std::collections::VecDeque;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "collapse",
        method: "level by level, the members kept sorted by area, in f64",
        answer: |q| {
            let nodes = q.list(node);
            let mut numbers = vec![0.0];
            let mut waiting: VecDeque<_> = (0..nodes.len().min(1)).collect();
            while let Some(branch) = waiting.pop_front() {
                if nodes[branch].count > 0 {
                    continue;
                }
                let mut members = vec![branch];
                while members.len() < 8 {
                    members.sort_by(|&a, &b| nodes[a].area.total_cmp(&nodes[b].area));
                    let Some(i) = members.iter().rposition(|&i| nodes[i].count == 0) else {
                        break;
                    };
                    let left = nodes[members.remove(i)].first;
                    members.extend([left, left + 1]);
                }
                numbers[0] += 1.0;
                numbers.extend([branch as f64, members.len() as f64]);
                numbers.extend(members.iter().map(|&i| i as f64));
                waiting.extend(members);
            }
            Some(numbers)
        },
    },
    Alternative {
        exercise: "wide_closest",
        method: "the nearest box of all that wait, wherever it is, in f64",
        answer: |q| {
            let tree = Tree::read(q);
            let mut search = Search::default();
            let mut waiting = tree.root();
            while let Some(next) = take_nearest(&mut waiting) {
                if search.hit.is_some_and(|(t, _)| t < next.t) {
                    break;
                }
                if next.leaf {
                    search.test(&tree, next.index, |ray, corners| {
                        plane_then_inside(ray.o, ray.d, corners).map(|h| h[0])
                    });
                } else {
                    search.nodes += 1;
                    waiting.extend(tree.met(next.index));
                }
            }
            search.answer()
        },
    },
    Alternative {
        exercise: "wide_closest",
        method: "by recursion, each node's children sorted, triangles by volumes, in f64",
        answer: |q| {
            let tree = Tree::read(q);
            let mut search = Search::default();
            for root in tree.root() {
                open(&tree, root, &mut search);
            }
            search.answer()
        },
    },
];

struct Node {
    area: f64,
    first: usize,
    count: usize,
}

fn node(q: &mut Question) -> Node {
    let (min, max) = (q.vector(), q.vector());
    let size = max - min;
    Node {
        area: size.x * size.y + size.y * size.z + size.z * size.x,
        first: q.whole(),
        count: q.whole(),
    }
}

#[derive(Clone, Copy)]
struct Child {
    t: f64,
    leaf: bool,
    index: usize,
}

struct Tree {
    ray: Ray,
    nodes: Vec<Vec<(DVec3, DVec3, Child)>>,
    leaves: Vec<Vec<usize>>,
    triangles: Vec<Corners>,
}

impl Tree {
    fn read(q: &mut Question) -> Self {
        Self {
            ray: q.ray(),
            nodes: q.list(|q| {
                q.list(|q| {
                    let (min, max) = (q.vector(), q.vector());
                    let (leaf, index) = (q.whole() == 1, q.whole());
                    (
                        min,
                        max,
                        Child {
                            t: 0.0,
                            leaf,
                            index,
                        },
                    )
                })
            }),
            leaves: q.list(|q| q.list(Question::whole)),
            triangles: q.list(|q| [(); 3].map(|()| q.vector())),
        }
    }

    fn root(&self) -> Vec<Child> {
        let (t, leaf, index) = (self.ray.min, false, 0);
        let root = Child { t, leaf, index };
        self.nodes.first().map(|_| root).into_iter().collect()
    }

    /// The children whose boxes, a little larger, the ray meets.
    fn met(&self, node: usize) -> impl Iterator<Item = Child> {
        self.nodes[node].iter().filter_map(|&(min, max, child)| {
            let inverse = self.ray.d.recip();
            let (a, b) = (
                (min - 1e-6 - self.ray.o) * inverse,
                (max + 1e-6 - self.ray.o) * inverse,
            );
            let enter = a.min(b).max_element().max(self.ray.min);
            let leave = a.max(b).min_element().min(self.ray.max);
            (enter <= leave).then_some(Child { t: enter, ..child })
        })
    }
}

fn take_nearest(waiting: &mut Vec<Child>) -> Option<Child> {
    let nearest = (0..waiting.len()).min_by(|&a, &b| waiting[a].t.total_cmp(&waiting[b].t))?;
    Some(waiting.swap_remove(nearest))
}

#[derive(Default)]
struct Search {
    nodes: usize,
    tests: usize,
    hit: Option<(f64, usize)>,
}

impl Search {
    fn test(&mut self, tree: &Tree, leaf: usize, t: impl Fn(&Ray, Corners) -> Option<f64>) {
        for &i in &tree.leaves[leaf] {
            self.tests += 1;
            let t = t(&tree.ray, tree.triangles[i]).filter(|&t| tree.ray.counts(t));
            if let Some(t) = t.filter(|&t| self.hit.is_none_or(|(nearest, _)| t < nearest)) {
                self.hit = Some((t, i));
            }
        }
    }

    fn answer(self) -> Answer {
        let hit = self
            .hit
            .map_or(vec![crate::alternatives::student::NONE], |(t, i)| {
                vec![t, i as f64]
            });
        Some([vec![self.nodes as f64, self.tests as f64], hit].concat())
    }
}

fn open(tree: &Tree, child: Child, search: &mut Search) {
    if search.hit.is_some_and(|(t, _)| t < child.t) {
        return;
    }
    if child.leaf {
        search.test(tree, child.index, |ray, corners| {
            volumes(ray.o, ray.d, corners).map(|h| h[0])
        });
        return;
    }
    search.nodes += 1;
    let mut met: Vec<_> = tree.met(child.index).collect();
    met.sort_by(|a, b| a.t.total_cmp(&b.t));
    for child in met {
        open(tree, child, search);
    }
}
