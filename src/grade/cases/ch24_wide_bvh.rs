//! Chapter 24: `collapse`, `wide_closest`.

use crate::accel::bvh::COST;
use crate::accel::bvh::build::{Method, build, cost::Cost};
use crate::accel::ray_box::RayBox;
use crate::accel::wide_bvh::build::{COST as WIDE_COST, build as build_wide};
use crate::accel::wide_bvh::node::Link;
use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::lab::palette::viridis;
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::shape::{Shape, mesh::Facet};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch07_mesh::{Corners, MeshHitAnswer};
use crate::workbook::exercises::ch24_wide_bvh::{
    Collapse, CollapseQuestion, FamilyRow, WideChild, WideClosest, WideClosestAnswer,
    WideClosestQuestion, WideLeaf, WideNode,
};
use crate::workbook::tree_rows::{NodeRow, to_rows};
use glam::{Vec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&Collapse, &WideClosest];

const MOST: usize = 8;

fn is_branch(q: &CollapseQuestion, i: u32) -> bool {
    q.nodes[i as usize].count == 0
}

fn pair(q: &CollapseQuestion, i: u32) -> [u32; 2] {
    [0, 1].map(|side| q.nodes[i as usize].first + side)
}

fn half_area(q: &CollapseQuestion, i: u32) -> f32 {
    let node = &q.nodes[i as usize];
    let size = node.max - node.min;
    size.x * size.y + size.y * size.z + size.z * size.x
}

/// Families whose members are chosen by `open`: which of the branches among the members is opened next, if any.
fn families(
    q: &CollapseQuestion,
    open: impl Fn(&CollapseQuestion, &[u32]) -> Option<usize>,
) -> Vec<FamilyRow> {
    let mut families = Vec::new();
    let mut waiting = Vec::new();
    if !q.nodes.is_empty() {
        waiting.push(0);
    }
    while let Some(branch) = waiting.pop() {
        if !is_branch(q, branch) {
            continue;
        }
        let mut children = pair(q, branch).to_vec();
        while let Some(i) = open(q, &children) {
            let opened = children.remove(i);
            children.extend(pair(q, opened));
        }
        waiting.extend(&children);
        families.push(FamilyRow { branch, children });
    }
    families
}

/// The place of the best branch among the members, by an order of numbers.
fn best(
    q: &CollapseQuestion,
    members: &[u32],
    order: fn(&CollapseQuestion, u32) -> f32,
) -> Option<usize> {
    let branches = (0..members.len()).filter(|&i| is_branch(q, members[i]));
    branches.max_by(|&a, &b| order(q, members[a]).total_cmp(&order(q, members[b])))
}

fn while_fewer(
    most: usize,
    order: fn(&CollapseQuestion, u32) -> f32,
) -> impl Fn(&CollapseQuestion, &[u32]) -> Option<usize> {
    move |q, members| {
        (members.len() < most)
            .then(|| best(q, members, order))
            .flatten()
    }
}

/// The families without some members.
fn without(families: Vec<FamilyRow>, keep: impl Fn(usize, u32) -> bool) -> Vec<FamilyRow> {
    let thin = |family: FamilyRow| FamilyRow {
        children: (family.children.iter().enumerate())
            .filter(|&(i, &child)| keep(i, child))
            .map(|(_, &child)| child)
            .collect(),
        ..family
    };
    families.into_iter().map(thin).collect()
}

impl Graded for Collapse {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "opens the smallest branch first",
            hint: "Which of two boxes do more rays enter, and which of them would you rather spare a step?",
            answer: |q| families(q, while_fewer(MOST, |q, i| -half_area(q, i))),
        },
        Mistake {
            name: "opens the branches in the order of the list",
            hint: "Not all branches are worth opening alike: what says how often one is entered?",
            answer: |q| families(q, while_fewer(MOST, |_, i| -(i as f32))),
        },
        Mistake {
            name: "keeps two children per branch",
            hint: "There is room for eight: whose children can move up?",
            answer: |q| families(q, while_fewer(2, half_area)),
        },
        Mistake {
            name: "stops at four children",
            hint: "How many lanes does a node have?",
            answer: |q| families(q, while_fewer(4, half_area)),
        },
        Mistake {
            name: "goes on to nine children",
            hint: "Opening a branch takes one member away and brings two: when must you stop?",
            answer: |q| families(q, while_fewer(MOST + 1, half_area)),
        },
        Mistake {
            name: "forgets the second child of the last branch it opens",
            hint: "Count the leaves before and after.",
            answer: |q| {
                let right = Collapse::answer(q);
                without(right, |i, _| i != 7)
            },
        },
        Mistake {
            name: "leaves out leaves",
            hint: "A child may be a leaf or a branch: do both have a place in your node?",
            answer: |q| {
                let right = Collapse::answer(q);
                let leaves: Vec<_> = q.nodes.iter().map(|node| node.count > 0).collect();
                without(right, |_, child| !leaves[child as usize])
            },
        },
        Mistake {
            name: "keeps the branches that it opened",
            hint: "Once a branch's children are members, is the branch still one?",
            answer: |q| {
                let mut right = Collapse::answer(q);
                for family in &mut right {
                    family.children.push(family.branch);
                }
                right
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let row = |n: usize, size: fn(usize) -> f32| {
            let boxes: Vec<_> = (0..n)
                .map(|i| {
                    let at = vec3(3.0 * i as f32, 0.0, 0.0);
                    Aabb {
                        min: at,
                        max: at + Vec3::splat(size(i)),
                    }
                })
                .collect();
            binary_tree(&boxes)
        };
        let one = |_: usize| 1.0;
        let square: Vec<_> = (0..16)
            .map(|i| {
                let at = 2.0 * vec3((i % 4) as f32, (i / 4) as f32, 0.0);
                Aabb {
                    min: at,
                    max: at + Vec3::ONE,
                }
            })
            .collect();
        vec![
            Edge::new("no boxes", row(0, one)),
            Edge::new("a single leaf", row(1, one)),
            Edge::new("two leaves", row(2, one)),
            Edge::new("seven leaves: one node with a place left", row(7, one)),
            Edge::new("eight leaves: one full node", row(8, one)),
            Edge::new("nine leaves: one too many", row(9, one)),
            Edge::new("sixty-four leaves", row(64, one)),
            Edge::new("boxes that grow", row(20, |i| 0.1 + 0.2 * i as f32)),
            Edge::new("a chain: every branch has a leaf", chain(20)),
            Edge::new("a square of sixteen", binary_tree(&square)),
        ]
    }

    fn random(rng: &mut Pcg) -> CollapseQuestion {
        let boxes: Vec<_> = (0..rng.random_range(14..40))
            .map(|_| {
                let (at, size) = (sample::point(rng, 4.0), sample::number(rng, 0.05, 2.0));
                Aabb {
                    min: at,
                    max: at + size * (sample::point(rng, 0.4) + 0.5),
                }
            })
            .collect();
        binary_tree(&boxes)
    }

    /// By what a wide tree must keep to, and its cost: the areas of its branches together. A tree of another shape that
    /// costs no more is as right.
    fn judge(q: &CollapseQuestion, golden: &Vec<FamilyRow>, got: &Vec<FamilyRow>) -> Verdict {
        let mut due: Vec<u32> = Vec::new();
        if (0..q.nodes.len() as u32)
            .take(1)
            .any(|root| is_branch(q, root))
        {
            due.push(0);
        }
        let mut done = 0;
        while let Some(branch) = due.pop() {
            let mut own = got.iter().filter(|family| family.branch == branch);
            let (Some(family), None) = (own.next(), own.next()) else {
                return Err(format!(
                    "branch {branch} is in the new tree, so it needs one list of children; there are {}",
                    got.iter().filter(|family| family.branch == branch).count()
                ));
            };
            judge_family(q, family)?;
            due.extend(family.children.iter().filter(|&&child| is_branch(q, child)));
            done += 1;
        }
        if done < got.len() {
            return Err(format!(
                "{} branches have children, but only {done} are in the tree that begins at node 0",
                got.len()
            ));
        }
        let cost = |families: &[FamilyRow]| -> f32 {
            families
                .iter()
                .map(|family| half_area(q, family.branch))
                .sum()
        };
        let (least, paid) = (cost(golden), cost(got));
        if paid > 1.01 * least {
            let more = 100.0 * (paid / least - 1.0);
            return Err(format!(
                "all leaves are there, but the branches that are left have {more:.0} % more area than they need"
            ));
        }
        Ok(())
    }
}

/// Whether a family's children hold what the branch holds, and there are as many of them as there can be.
fn judge_family(q: &CollapseQuestion, family: &FamilyRow) -> Verdict {
    let FamilyRow { branch, children } = family;
    if let Some(wrong) = children
        .iter()
        .find(|&&child| child as usize >= q.nodes.len())
    {
        return Err(format!(
            "branch {branch} has a child {wrong}, and there are only {} nodes",
            q.nodes.len()
        ));
    }
    if children.len() > MOST {
        return Err(format!(
            "branch {branch} has {} children; there are {MOST} lanes",
            children.len()
        ));
    }
    let mut met = vec![0; children.len()];
    cover(q, *branch, children, &mut met).map_err(|lost| {
        format!("leaf {lost} was below branch {branch} and is below none of its new children")
    })?;
    if let Some(i) = met.iter().position(|&times| times != 1) {
        return Err(format!(
            "child {} of branch {branch} is below another child, twice in the list, or not below the branch",
            children[i]
        ));
    }
    match children.iter().find(|&&child| is_branch(q, child)) {
        Some(open) if children.len() < MOST => Err(format!(
            "branch {branch} has only {} children, and child {open} could be opened",
            children.len()
        )),
        _ => Ok(()),
    }
}

/// Goes down to the children, counting how often each is met; the number of a leaf that is reached without meeting one.
fn cover(q: &CollapseQuestion, node: u32, children: &[u32], met: &mut [u32]) -> Result<(), u32> {
    let mut here = false;
    for (child, met) in children.iter().zip(met.iter_mut()) {
        if *child == node {
            *met += 1;
            here = true;
        }
    }
    if here {
        Ok(())
    } else if is_branch(q, node) {
        pair(q, node)
            .into_iter()
            .try_for_each(|below| cover(q, below, children, met))
    } else {
        Err(node)
    }
}

/// A binary tree over boxes, one in each leaf.
fn binary_tree(boxes: &[Aabb]) -> CollapseQuestion {
    let cost = Cost { most: 1, ..COST };
    CollapseQuestion {
        nodes: to_rows(&build(boxes, Method::Binned, &cost)),
    }
}

/// A tree in which each branch has a leaf and the rest.
fn chain(n: u32) -> CollapseQuestion {
    let node = |i: u32, first, count| NodeRow {
        min: vec3(i as f32, 0.0, 0.0),
        max: vec3(if count == 0 { n as f32 } else { i as f32 + 1.0 }, 1.0, 1.0),
        first,
        count,
    };
    let mut nodes = vec![node(0, 1, 0)];
    for i in 0..n - 1 {
        nodes.push(node(i, i, 1));
        let last = i + 2 == n;
        nodes.push(if last {
            node(i + 1, i + 1, 1)
        } else {
            node(i + 1, 2 * i + 3, 0)
        });
    }
    CollapseQuestion { nodes }
}

#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a mistake of its own"
)]
/// How a search goes wrong.
#[derive(Clone, Copy)]
struct How {
    /// Asks the boxes at all.
    boxes: bool,
    /// −1 the nearest first, 1 the farthest first, 0 in the order of the node.
    order: i32,
    /// Drops those that wait beyond a hit.
    drops: bool,
    /// Ends at the first leaf with a hit.
    stops: bool,
    /// So many lanes are looked at.
    lanes: usize,
    /// Only the nearest child is opened.
    only_nearest: bool,
}

const WELL: How = How {
    boxes: true,
    order: -1,
    drops: true,
    stops: false,
    lanes: 8,
    only_nearest: false,
};

/// A search by recursion, with a list of children per node.
fn search(q: &WideClosestQuestion, how: How) -> WideClosestAnswer {
    let mut answer = WideClosestAnswer {
        nodes: 0,
        tests: 0,
        hit: None,
    };
    if !q.nodes.is_empty() {
        let mut within = q.within;
        open(q, how, 0, &mut within, &mut answer);
    }
    answer
}

/// Opens a node; true to end the search.
fn open(
    q: &WideClosestQuestion,
    how: How,
    node: u32,
    within: &mut Interval,
    answer: &mut WideClosestAnswer,
) -> bool {
    answer.nodes += 1;
    let ray = RayBox::new(&q.ray);
    let children = q.nodes[node as usize].children.iter().take(how.lanes);
    let mut met: Vec<(f32, &WideChild)> = children
        .filter_map(|child| {
            let bounds = Aabb {
                min: child.min,
                max: child.max,
            };
            let t = ray.enters(&bounds, *within);
            if how.boxes {
                t.map(|t| (t, child))
            } else {
                Some((t.unwrap_or(0.0), child))
            }
        })
        .collect();
    match how.order {
        -1 => met.sort_by(|a, b| a.0.total_cmp(&b.0)),
        1 => met.sort_by(|a, b| b.0.total_cmp(&a.0)),
        _ => {}
    }
    if how.only_nearest {
        met.truncate(1);
    }
    for (t, child) in met {
        if how.drops && t > within.max {
            continue;
        }
        if child.leaf == 0 {
            if open(q, how, child.index, within, answer) {
                return true;
            }
        } else if test(q, child.index, within, answer) && how.stops {
            return true;
        }
    }
    false
}

/// Tests the triangles of a leaf; whether any is hit.
fn test(
    q: &WideClosestQuestion,
    leaf: u32,
    within: &mut Interval,
    answer: &mut WideClosestAnswer,
) -> bool {
    let before = answer.hit.clone();
    for &id in &q.leaves[leaf as usize].triangles {
        answer.tests += 1;
        let Corners { p0, p1, p2 } = q.triangles[id as usize];
        let facet = Facet {
            corners: [p0, p1, p2],
            id,
        };
        if let Some(hit) = facet.hit(&q.ray, *within) {
            *within = within.before(hit.t);
            answer.hit = Some(MeshHitAnswer { t: hit.t, id });
        }
    }
    answer.hit != before
}

impl Graded for WideClosest {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "opens every child",
            hint: "The hit is right, but the boxes are there to spare you tests: ask them first.",
            answer: |q| {
                search(
                    q,
                    How {
                        boxes: false,
                        drops: false,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "opens the children in the order of the node",
            hint: "Where is the nearest hit more likely, and what is spared if you find it first?",
            answer: |q| search(q, How { order: 0, ..WELL }),
        },
        Mistake {
            name: "opens the farthest child first",
            hint: "The last one on the stack is the first one off it: which one should that be?",
            answer: |q| search(q, How { order: 1, ..WELL }),
        },
        Mistake {
            name: "opens children that wait behind the hit",
            hint: "A child was put aside, then something was hit before its box: is it still worth opening?",
            answer: |q| {
                search(
                    q,
                    How {
                        drops: false,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "ends at the first leaf with a hit",
            hint: "Boxes may overlap: can a triangle of a farther box be nearer?",
            answer: |q| {
                search(
                    q,
                    How {
                        stops: true,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "opens the nearest child only",
            hint: "The nearest box may be empty where the ray passes through it.",
            answer: |q| {
                search(
                    q,
                    How {
                        only_nearest: true,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "looks at four lanes of eight",
            hint: "How many children can a node have?",
            answer: |q| search(q, How { lanes: 4, ..WELL }),
        },
        Mistake {
            name: "ignores the interval's min",
            hint: "Can the ray hit what lies behind its origin?",
            answer: |q| {
                let mut q = q.clone();
                q.within.min = f32::NEG_INFINITY;
                search(&q, WELL)
            },
        },
        Mistake {
            name: "ignores the interval's max",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| {
                let mut q = q.clone();
                q.within.max = f32::INFINITY;
                search(&q, WELL)
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 54,
        alt: "Shingles on a slope, each in its colour",
        question: |x, y| {
            let toward = vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.0);
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
                Ray::new(vec3(0.0, 0.0, 3.0), Dir3::new_or(toward, Dir3::Z)),
                Interval::AHEAD,
            )
        },
        colour: |_, answer| {
            let hit = answer.hit.as_ref();
            hit.map_or(Rgb::gray(0.1), |hit| {
                viridis((hit.id as f32 * 0.382).fract())
            })
        },
    });

    fn edges() -> Vec<Edge<Self>> {
        let wall = |z: f32| [vec3(-2.0, -2.0, z), vec3(2.0, -2.0, z), vec3(0.0, 3.0, z)];
        let walls = |n: usize, ray, within| {
            question((1..=n).map(|i| wall(2.0 * i as f32)).collect(), ray, within)
        };
        let (ray, ahead) = (Ray::new(Vec3::ZERO, Dir3::Z), Interval::AHEAD);
        let back = Ray::new(vec3(0.0, 0.0, 100.0), -Dir3::Z);
        let minus_zero = Ray::new(Vec3::ZERO, Dir3::new_or(vec3(-0.0, -0.0, 1.0), Dir3::Z));
        let slanted = (1..=24).map(|i| {
            let z = 2.0 * i as f32;
            [
                vec3(-2.0, -2.0, z - 3.0),
                vec3(2.0, -2.0, z - 3.0),
                vec3(0.0, 3.0, z + 4.0),
            ]
        });
        let tilted = |i: usize| {
            let z = i as f32;
            [
                vec3(-2.0, -2.0, 2.0 + 0.1 * z),
                vec3(2.0, -2.0, 2.0),
                vec3(0.0, 3.0, 40.0),
            ]
        };
        let late = (0..4)
            .map(tilted)
            .chain((0..16).map(|i| wall(8.0 + i as f32)))
            .collect();
        vec![
            Edge::new("forty walls ahead", walls(40, ray, ahead)),
            Edge::new("forty walls, from the other end", walls(40, back, ahead)),
            Edge::new(
                "from between the walls",
                walls(40, Ray::new(vec3(0.0, 0.0, 31.0), Dir3::Z), ahead),
            ),
            Edge::new(
                "the nearest walls lie before the interval",
                walls(40, ray, Interval::new(21.0, 90.0)),
            ),
            Edge::new(
                "all walls beyond the interval",
                walls(40, ray, Interval::new(0.0, 1.5)),
            ),
            Edge::new(
                "a miss",
                walls(40, Ray::new(vec3(5.0, 0.0, 0.0), Dir3::Z), ahead),
            ),
            Edge::new("−0.0 in the direction", walls(40, minus_zero, ahead)),
            Edge::new(
                "a slanted wall begins first and ends last",
                question(late, ray, ahead),
            ),
            Edge::new(
                "boxes that overlap",
                question(slanted.collect(), ray, ahead),
            ),
            Edge::new("one leaf", walls(3, ray, ahead)),
        ]
    }

    fn random(rng: &mut Pcg) -> WideClosestQuestion {
        let triangles = (0..rng.random_range(28..44)).map(|_| {
            let at = sample::point(rng, 2.5);
            std::array::from_fn(|_| at + sample::point(rng, 1.6))
        });
        let triangles = triangles.collect();
        let max = if rng.random_bool(0.3) {
            sample::number(rng, 1.0, 5.0)
        } else {
            f32::INFINITY
        };
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

    /// The hit, and the work: a quarter more than the reference's is as good, for another order may be unlucky.
    fn judge(
        _q: &WideClosestQuestion,
        golden: &WideClosestAnswer,
        got: &WideClosestAnswer,
    ) -> Verdict {
        judge::option(
            "a hit",
            golden.hit.as_ref(),
            got.hit.as_ref(),
            |golden, got| {
                judge::number("t", "m", golden.t, got.t)?;
                if golden.id == got.id {
                    Ok(())
                } else {
                    Err(format!(
                        "you returned triangle {}, and triangle {} is hit",
                        got.id, golden.id
                    ))
                }
            },
        )?;
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

/// Four triangles to a leaf: so a few dozen make a tree in which the order of the search matters.
const SMALL_LEAVES: Cost = Cost {
    block_size: 4,
    most: 4,
    ..WIDE_COST
};

/// A question about triangles in the tree that the reference builds, its root a node even if a leaf would do.
fn question(triangles: Vec<[Vec3; 3]>, ray: Ray, within: Interval) -> WideClosestQuestion {
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
        .nodes
        .iter()
        .map(|old| node(old.children().collect()))
        .collect();
    if let Some(root) = tree.root.filter(|root| root.as_leaf().is_some()) {
        nodes.push(node(vec![(all, root)]));
    }
    let leaves = tree.leaves.iter().map(|leaf| WideLeaf {
        triangles: leaf.facets().collect(),
    });
    WideClosestQuestion {
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
