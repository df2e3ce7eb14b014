//! The questions of `octree_build`.

use crate::{Edge, sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, OctreeBuildQuestion};
use glam::{Vec3, vec3};
use rand::RngExt;

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<OctreeBuild>> {
    let tiny = |p: Vec3| Corners {
        min: p - 0.01,
        max: p + 0.01,
    };
    let question = |depth, copies, shapes: Vec<Corners>| OctreeBuildQuestion {
        min: Vec3::ZERO,
        max: Vec3::splat(8.0),
        opening: 1.0,
        copies,
        depth,
        shapes,
    };
    let edge = |name, depth, copies, shapes| Edge::new(name, question(depth, copies, shapes));
    let corners = (0..8)
        .map(|i| tiny(vec3((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32) * 6.0 + 1.0));
    let crowd = (0..6).map(|i| tiny(vec3(0.3, 0.3, 0.2) + 0.3 * i as f32 * vec3(1.0, 0.0, 0.3)));
    let across = Corners {
        min: vec3(1.0, 1.0, 1.0),
        max: vec3(7.0, 1.5, 1.5),
    };
    let sheets = (0..4).map(|i| Corners {
        min: vec3(0.5, 0.5, 0.5 + 2.0 * i as f32),
        max: vec3(7.5, 7.5, 0.6 + 2.0 * i as f32),
    });
    let pair = [
        vec3(1.0, 1.0, 1.0),
        vec3(7.0, 1.0, 1.0),
        vec3(1.0, 1.0, 7.0),
        vec3(2.5, 1.0, 1.0),
    ];
    vec![
        edge("no shapes", 3, 8.0, vec![]),
        edge("one shape", 3, 8.0, vec![tiny(vec3(1.0, 2.0, 3.0))]),
        edge("one in each child", 3, 8.0, corners.collect()),
        edge("some along x, one along z", 3, 8.0, pair.map(tiny).to_vec()),
        edge("a crowd in a corner", 3, 8.0, crowd.clone().collect()),
        edge(
            "a crowd, and no depth left",
            1,
            8.0,
            crowd.clone().collect(),
        ),
        edge("no depth at all", 0, 8.0, crowd.clone().collect()),
        edge(
            "one that reaches across",
            2,
            8.0,
            crowd.chain([across]).collect(),
        ),
        edge(
            "all at the same place",
            3,
            8.0,
            vec![tiny(vec3(3.9, 3.9, 3.9)); 5],
        ),
        edge(
            "all reach all children",
            3,
            8.0,
            vec![
                Corners {
                    min: Vec3::splat(1.0),
                    max: Vec3::splat(7.0)
                };
                4
            ],
        ),
        edge("large sheets, few copies", 2, 1.5, sheets.clone().collect()),
        edge("large sheets, many copies", 2, 64.0, sheets.collect()),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> OctreeBuildQuestion {
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
    OctreeBuildQuestion {
        min,
        max: min + size,
        opening: 1.0,
        copies: [1.2, 2.0, 8.0][rng.random_range(0..3_usize)],
        depth: rng.random_range(1..4),
        shapes,
    }
}
