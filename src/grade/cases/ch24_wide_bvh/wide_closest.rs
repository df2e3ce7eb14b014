//! `wide_closest`: its cases, judge and mistakes.

use crate::accel::bvh::build::Method;
use crate::accel::wide_bvh::build::build as build_wide;
use crate::accel::wide_bvh::node::Link;
use crate::grade::search::{self, How, Node, Order, Tree};
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::lab::palette::viridis;
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::shape::{Shape, mesh::Facet};
use crate::workbook::exercises::ch07_mesh::Corners;
use crate::workbook::exercises::ch24_wide_bvh::{
    WideChild, WideClosest, WideClosestAnswer, WideClosestQuestion, WideLeaf, WideNode,
};
use glam::{Vec3, vec3};
use rand::RngExt;

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

    const PICTURE: Option<Picture<Self>> = Some(Picture {
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
        let (ray, ahead) = (sample::ray(Vec3::ZERO, Vec3::Z), Interval::AHEAD);
        let back = sample::ray(vec3(0.0, 0.0, 100.0), -Vec3::Z);
        let minus_zero = sample::ray(Vec3::ZERO, vec3(-0.0, -0.0, 1.0));
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
                walls(40, sample::ray(vec3(0.0, 0.0, 31.0), Vec3::Z), ahead),
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
                walls(40, sample::ray(vec3(5.0, 0.0, 0.0), Vec3::Z), ahead),
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

    /// The hit, and the work: a quarter more than the reference's is as good, for another order may be unlucky.
    fn judge(
        _q: &WideClosestQuestion,
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

/// A question about triangles in the tree that the reference builds, its root a node even if a leaf would do.
fn question(triangles: Vec<[Vec3; 3]>, ray: Ray, within: Interval) -> WideClosestQuestion {
    let facets = triangles.iter().zip(0..);
    let facets: Vec<_> = facets.map(|(&corners, id)| Facet { corners, id }).collect();
    let all = facets
        .iter()
        .fold(Aabb::EMPTY, |all, facet| all.union(&facet.bounds()));
    let tree = build_wide(facets, Method::Binned);
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

/// A search that goes wrong in some way.
fn search(q: &WideClosestQuestion, change: impl FnOnce(&mut How)) -> WideClosestAnswer {
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
