//! Chapter 11: trees of boxes.

use crate::alternatives::boxes::{Bounds, around, best_cut, bounds, build, cheapest_cut, list};
use crate::alternatives::student::{Alternative, Answer, NONE, Question, STYLES, line};
use crate::alternatives::triangle::{Corners, plane_then_inside, volumes};
use glam::DVec3;
use raybook_grader::cases;
use raybook_grader::examine::visible_rng;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "sah_cost",
        method: "from the leaves up, in f64",
        answer: |q| {
            let (branch, shape) = (q.number(), q.number());
            let nodes = q.list(node);
            Some(vec![
                price(&nodes, 0, branch, shape) / nodes[0].bounds.area(),
            ])
        },
    },
    Alternative {
        exercise: "sah_split",
        method: "all cuts, by their boxes, in f64",
        answer: |q| {
            let boxes = q.list(bounds);
            let all: Vec<_> = (0..boxes.len()).collect();
            let (left, _, _) = best_cut(&boxes, &all);
            Some(list(&left))
        },
    },
    Alternative {
        exercise: "bvh_build",
        method: "top-down by all cuts, in f64",
        answer: |q| {
            let most = q.whole();
            build(q, &|boxes, which| {
                let (left, right, cost) = best_cut(boxes, which);
                let area = around(boxes, which).area();
                let leaf = area * which.len() as f64;
                (which.len() > most || area + cost < leaf).then_some((left, right))
            })
        },
    },
    Alternative {
        exercise: "bvh_closest",
        method: "recursive, boxes by their slabs, triangles by planes, in f64",
        answer: |q| closest(q, plane_then_inside, false),
    },
    Alternative {
        exercise: "bvh_closest",
        method: "with a stack, each box tested when its turn comes, the root's too, triangles by volumes, in f64",
        answer: |q| closest(q, volumes, true),
    },
];

struct Node {
    bounds: Bounds,
    first: usize,
    count: usize,
}

fn node(q: &mut Question) -> Node {
    Node {
        bounds: bounds(q),
        first: q.whole(),
        count: q.whole(),
    }
}

/// Of a subtree, times the area of its box.
fn price(nodes: &[Node], at: usize, branch: f64, shape: f64) -> f64 {
    let Node {
        bounds,
        first,
        count,
    } = &nodes[at];
    if *count > 0 {
        return bounds.area() * shape * *count as f64;
    }
    let below = [*first, first + 1].map(|child| price(nodes, child, branch, shape));
    bounds.area() * branch + below[0] + below[1]
}

type HitTriangle = fn(DVec3, DVec3, Corners) -> Option<[f64; 3]>;

/// The counts, then the hit.
fn closest(q: &mut Question, hit: HitTriangle, late: bool) -> Answer {
    let mut ray = q.ray();
    let nodes = q.list(node);
    let triangles = q.list(|q| [(); 3].map(|()| q.vector()));
    let (mut boxes, mut tests, mut found) = (0, 0, None);
    let mut stack = vec![(f64::NEG_INFINITY, 0)];
    while let Some((enters, at)) = stack.pop() {
        if enters >= ray.max {
            continue;
        }
        if late {
            // Two are counted for each branch that is opened, so the root's is not.
            boxes += usize::from(at > 0);
            if nodes[at].bounds.clip(&ray).is_none() {
                continue;
            }
        }
        let Node { first, count, .. } = nodes[at];
        for (id, &corners) in triangles.iter().enumerate().skip(first).take(count) {
            tests += 1;
            if let Some([t, ..]) = hit(ray.o, ray.d, corners).filter(|h| ray.counts(h[0])) {
                ray.max = t;
                found = Some((t, id));
            }
        }
        if count > 0 {
            continue;
        }
        let mut met: Vec<_> = [first, first + 1]
            .into_iter()
            .filter_map(|child| {
                let clipped = nodes[child].bounds.clip(&ray);
                boxes += usize::from(!late);
                if late {
                    // The order by the middle of the box along the ray.
                    let middle = 0.5 * (nodes[child].bounds.min + nodes[child].bounds.max);
                    return Some(((middle - ray.o).dot(ray.d), child));
                }
                clipped.map(|(enter, _)| (enter, child))
            })
            .collect();
        met.sort_by(|a, b| b.0.total_cmp(&a.0));
        stack.extend(met.into_iter().map(|(t, child)| {
            let enters = if late { f64::NEG_INFINITY } else { t };
            (enters, child)
        }));
    }
    let mut answer = vec![boxes as f64, f64::from(tests)];
    match found {
        Some((t, id)) => answer.extend([t, id as f64]),
        None => answer.push(NONE),
    }
    Some(answer)
}

/// What few boxes hide.
const WRONG_AMONG_MANY: &[Alternative] = &[
    Alternative {
        exercise: "bvh_build",
        method: "areas without one of the three sides",
        answer: |q| {
            let most = q.whole();
            build(q, &|boxes, which| {
                let (left, right, _) = cheapest_cut(boxes, which, two_sides, |b| b.min + b.max);
                (which.len() > most).then_some((left, right))
            })
        },
    },
    Alternative {
        exercise: "sah_split",
        method: "areas without one of the three sides",
        answer: |q| split(q, two_sides, |b| b.min + b.max),
    },
    Alternative {
        exercise: "sah_split",
        method: "in rows by the greatest corners",
        answer: |q| split(q, Bounds::area, |b| b.max),
    },
];

fn two_sides(bounds: &Bounds) -> f64 {
    let size = bounds.max - bounds.min;
    2.0 * (size.x * size.y + size.z * size.x)
}

fn split(q: &mut Question, area: fn(&Bounds) -> f64, place: fn(&Bounds) -> DVec3) -> Answer {
    let boxes = q.list(bounds);
    let all: Vec<_> = (0..boxes.len()).collect();
    Some(list(&cheapest_cut(&boxes, &all, area, place).0))
}

#[test]
fn wrong_costs_show_among_a_thousand_boxes() {
    for wrong in WRONG_AMONG_MANY {
        let (name, method) = (wrong.exercise, wrong.method);
        let examiner = cases::find(name).expect("it is an exercise");
        let cases = examiner.cases(&mut visible_rng(name)).cases;
        let followers = examiner.followers(&cases);
        let crowd = &followers.last().expect("something follows").case;
        assert_eq!(crowd.name, "1000 elements", "{name}");
        let got = line(&wrong.answer_to(&crowd.question), STYLES[0].1);
        let verdict = examiner.judge(&crowd.question, &crowd.answers, &got);
        assert!(verdict.is_err(), "{name}: {method}");
    }
}
