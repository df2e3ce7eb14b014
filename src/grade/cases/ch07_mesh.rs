//! Chapter 7: `interpolate_normal`, `interpolate_texture`, `vertex_normals`, `mesh_hit`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::lab::palette::viridis;
use crate::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch07_mesh::{
    Corners, Indices, InterpolateNormal, InterpolateNormalQuestion, InterpolateTexture,
    InterpolateTextureQuestion, MeshHit, MeshHitAnswer, MeshHitQuestion, MeshQuestion,
    VertexNormals,
};
use glam::{Vec2, Vec3, vec2, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[
    &InterpolateNormal,
    &InterpolateTexture,
    &VertexNormals,
    &MeshHit,
];

/// Places in a triangle, by name: (b1, b2).
const PLACES: [(&str, Vec2); 6] = [
    ("at the first corner", vec2(0.0, 0.0)),
    ("at the second corner", vec2(1.0, 0.0)),
    ("at the third corner", vec2(0.0, 1.0)),
    ("in the middle of the first edge", vec2(0.5, 0.0)),
    ("in the middle of the long edge", vec2(0.5, 0.5)),
    ("off the middle", vec2(0.2, 0.5)),
];

fn place(rng: &mut Pcg) -> Vec2 {
    let b1 = sample::number(rng, 0.0, 1.0);
    vec2(b1, (1.0 - b1) * sample::number(rng, 0.0, 1.0))
}

impl Graded for InterpolateNormal {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets to normalise",
            hint: "How long is the mean of two unit vectors at right angles?",
            answer: |q| mix(q, 1.0 - q.b.x - q.b.y, q.b.x, q.b.y),
        },
        Mistake {
            name: "gives the weights to the wrong corners",
            hint: "At b1 = b2 = 0, whose normal do you return?",
            answer: |q| mix(q, q.b.x, q.b.y, 1.0 - q.b.x - q.b.y).normalize_or_zero(),
        },
        Mistake {
            name: "swaps b1 and b2",
            hint: "At b1 = 1, whose normal do you return?",
            answer: |q| mix(q, 1.0 - q.b.x - q.b.y, q.b.y, q.b.x).normalize_or_zero(),
        },
        Mistake {
            name: "takes the mean of the corners anywhere",
            hint: "Move the point towards a corner: the normal should turn towards that corner's.",
            answer: |q| mix(q, 1.0, 1.0, 1.0).normalize_or_zero(),
        },
        Mistake {
            name: "gives the first corner the weight 1",
            hint: "The three weights add up to 1.",
            answer: |q| mix(q, 1.0, q.b.x, q.b.y).normalize_or_zero(),
        },
        Mistake {
            name: "returns the first corner's normal",
            hint: "That is flat shading; what changes inside the triangle?",
            answer: |q| *q.n0,
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let normals = [
            vec3(0.0, 1.0, 0.0),
            vec3(1.0, 1.0, 0.0),
            vec3(0.0, 0.5, 1.0),
        ]
        .map(|n| Dir3::new_or(n, Dir3::Y));
        let [n0, n1, n2] = normals;
        PLACES
            .map(|(name, b)| Edge::new(name, InterpolateNormalQuestion { n0, n1, n2, b }))
            .into()
    }

    fn random(rng: &mut Pcg) -> InterpolateNormalQuestion {
        // Three normals of one hemisphere, as on a smooth mesh.
        let around = *sample::direction(rng);
        let mut normal = || Dir3::new_or(around + 0.9 * *sample::direction(rng), Dir3::Y);
        let (n0, n1, n2) = (normal(), normal(), normal());
        InterpolateNormalQuestion {
            n0,
            n1,
            n2,
            b: place(rng),
        }
    }

    fn judge(_q: &InterpolateNormalQuestion, golden: &Vec3, got: &Vec3) -> Verdict {
        judge::direction("the normal", *golden, *got)
    }
}

fn mix(q: &InterpolateNormalQuestion, w0: f32, w1: f32, w2: f32) -> Vec3 {
    w0 * *q.n0 + w1 * *q.n1 + w2 * *q.n2
}

impl Graded for InterpolateTexture {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "gives the weights to the wrong corners",
            hint: "At b1 = b2 = 0, whose coordinates do you return?",
            answer: |q| q.b.x * q.t0 + q.b.y * q.t1 + (1.0 - q.b.x - q.b.y) * q.t2,
        },
        Mistake {
            name: "swaps b1 and b2",
            hint: "At b1 = 1, whose coordinates do you return?",
            answer: |q| (1.0 - q.b.x - q.b.y) * q.t0 + q.b.y * q.t1 + q.b.x * q.t2,
        },
        Mistake {
            name: "swaps u and v",
            hint: "Which of the two coordinates comes first?",
            answer: |q| {
                vec2(
                    InterpolateTexture::answer(q).y,
                    InterpolateTexture::answer(q).x,
                )
            },
        },
        Mistake {
            name: "normalises as if it were a direction",
            hint: "Texture coordinates have no length that matters.",
            answer: |q| InterpolateTexture::answer(q).normalize_or_zero(),
        },
        Mistake {
            name: "wraps them into [0, 1)",
            hint: "A texture may repeat: whose decision is that?",
            answer: |q| InterpolateTexture::answer(q).fract_gl(),
        },
        Mistake {
            name: "returns (b1, b2)",
            hint: "Those say where in the triangle; where in the texture?",
            answer: |q| q.b,
        },
        Mistake {
            name: "gives the first corner the weight 1",
            hint: "The three weights add up to 1.",
            answer: |q| q.t0 + q.b.x * q.t1 + q.b.y * q.t2,
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let (t0, t1, t2) = (vec2(0.25, 0.5), vec2(2.0, 0.75), vec2(0.5, -1.0));
        PLACES
            .map(|(name, b)| Edge::new(name, InterpolateTextureQuestion { t0, t1, t2, b }))
            .into()
    }

    fn random(rng: &mut Pcg) -> InterpolateTextureQuestion {
        let mut texture = || {
            vec2(
                sample::number(rng, -1.0, 3.0),
                sample::number(rng, -1.0, 3.0),
            )
        };
        let (t0, t1, t2) = (texture(), texture(), texture());
        InterpolateTextureQuestion {
            t0,
            t1,
            t2,
            b: place(rng),
        }
    }

    fn judge(_q: &InterpolateTextureQuestion, golden: &Vec2, got: &Vec2) -> Verdict {
        judge::pair(["u", "v"], *golden, *got)
    }
}

impl Graded for VertexNormals {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "gives every triangle the same weight",
            hint: "Cut one triangle in two: should the normals at its other corners' neighbours change?",
            answer: |q| normals(q, |e1, e2| e1.cross(e2).normalize_or_zero()),
        },
        Mistake {
            name: "forgets to normalise",
            hint: "How long is a sum of many normals?",
            answer: |q| sums(q, Vec3::cross),
        },
        Mistake {
            name: "points inwards",
            hint: "Counter-clockwise seen from outside: e1 × e2 or e2 × e1?",
            answer: |q| normals(q, |e1, e2| e2.cross(e1)),
        },
        Mistake {
            name: "keeps the last triangle's normal only",
            hint: "A vertex belongs to several triangles: do you add to its sum, or replace it?",
            answer: |q| {
                let mut normals = vec![Vec3::Y; q.positions.len()];
                for (corners, twice_area) in faces(q, Vec3::cross) {
                    for i in corners {
                        normals[i] = twice_area.normalize_or(Vec3::Y);
                    }
                }
                normals
            },
        },
        Mistake {
            name: "adds to the first corner only",
            hint: "Each triangle has three corners: who gets its normal?",
            answer: |q| {
                let mut sums = vec![Vec3::ZERO; q.positions.len()];
                for ([first, ..], twice_area) in faces(q, Vec3::cross) {
                    sums[first] += twice_area;
                }
                sums.into_iter()
                    .map(|sum| sum.normalize_or(Vec3::Y))
                    .collect()
            },
        },
        Mistake {
            name: "returns NaN for a vertex without triangles",
            hint: "What is 0/0, and what does the task want instead?",
            answer: |q| {
                sums(q, Vec3::cross)
                    .into_iter()
                    .map(|sum| sum / sum.length())
                    .collect()
            },
        },
        Mistake {
            name: "returns a normal per triangle",
            hint: "How many normals are asked for: one per vertex, or one per triangle?",
            answer: |q| {
                faces(q, Vec3::cross)
                    .map(|(_, n)| n.normalize_or(Vec3::Y))
                    .collect()
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, positions: &[Vec3], triangles: &[[u32; 3]]| {
            Edge::new(
                name,
                MeshQuestion {
                    positions: positions.to_vec(),
                    triangles: triangles
                        .iter()
                        .map(|&[a, b, c]| Indices { a, b, c })
                        .collect(),
                },
            )
        };
        let square = [Vec3::ZERO, Vec3::X, vec3(1.0, 1.0, 0.0), Vec3::Y];
        let roof = [
            Vec3::ZERO,
            vec3(0.0, 0.0, 1.0),
            vec3(-4.0, -1.0, 0.5),
            vec3(0.5, -1.0, 0.5),
        ];
        let tetrahedron = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
        vec![
            edge("one triangle", &square[..3], &[[0, 1, 2]]),
            edge("a flat square", &square, &[[0, 1, 2], [0, 2, 3]]),
            edge(
                "a roof with a large and a small side",
                &roof,
                &[[0, 2, 1], [0, 1, 3]],
            ),
            edge(
                "a tetrahedron",
                &tetrahedron,
                &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
            ),
            edge("a vertex without triangles", &square, &[[0, 1, 2]]),
            edge(
                "a triangle without area adds nothing",
                &square,
                &[[0, 1, 2], [0, 2, 2]],
            ),
            edge(
                "two sides that cancel out",
                &square[..3],
                &[[0, 1, 2], [0, 2, 1]],
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> MeshQuestion {
        // A fan around vertex 0: a bumpy cone, whose triangles differ in size.
        let count = rng.random_range(3..7_u32);
        let rim = (0..count).map(|i| {
            let angle = std::f32::consts::TAU * i as f32 / count as f32;
            let radius = sample::number(rng, 0.4, 2.5);
            vec3(
                radius * angle.cos(),
                sample::number(rng, -1.5, 0.5),
                radius * angle.sin(),
            )
        });
        let positions = std::iter::once(vec3(0.1, 0.8, -0.2))
            .chain(rim.collect::<Vec<_>>())
            .collect();
        let triangles = (0..count)
            .map(|i| Indices {
                a: 0,
                b: 1 + (i + 1) % count,
                c: 1 + i,
            })
            .collect();
        MeshQuestion {
            positions,
            triangles,
        }
    }

    fn judge(_q: &MeshQuestion, golden: &Vec<Vec3>, got: &Vec<Vec3>) -> Verdict {
        if golden.len() != got.len() {
            return Err(format!(
                "there are {} vertices, but you returned {} normals",
                golden.len(),
                got.len()
            ));
        }
        let mut pairs = golden.iter().zip(got).enumerate();
        pairs.try_for_each(|(i, (golden, got))| {
            judge::direction(&format!("the normal of vertex {i}"), *golden, *got)
        })
    }
}

/// Each triangle's corners, and a vector made of its edges.
fn faces(
    q: &MeshQuestion,
    vector: fn(Vec3, Vec3) -> Vec3,
) -> impl Iterator<Item = ([usize; 3], Vec3)> {
    q.triangles.iter().map(move |t| {
        let corners = [t.a, t.b, t.c].map(|i| i as usize);
        let [p0, p1, p2] = corners.map(|i| q.positions[i]);
        (corners, vector(p1 - p0, p2 - p0))
    })
}

/// Per vertex, the sum of its triangles' vectors.
fn sums(q: &MeshQuestion, vector: fn(Vec3, Vec3) -> Vec3) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; q.positions.len()];
    for (corners, vector) in faces(q, vector) {
        for i in corners {
            sums[i] += vector;
        }
    }
    sums
}

fn normals(q: &MeshQuestion, vector: fn(Vec3, Vec3) -> Vec3) -> Vec<Vec3> {
    sums(q, vector)
        .into_iter()
        .map(|sum| sum.normalize_or(Vec3::Y))
        .collect()
}

impl Graded for MeshHit {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "returns the first hit in the list",
            hint: "Put the far triangle first: which one do you see?",
            answer: |q| hits(q).next(),
        },
        Mistake {
            name: "returns the last hit in the list",
            hint: "Put the near triangle first: is it still the one you return?",
            answer: |q| hits(q).last(),
        },
        Mistake {
            name: "returns the farthest hit",
            hint: "Which of two opaque triangles hides the other?",
            answer: |q| hits(q).max_by(|a, b| a.t.total_cmp(&b.t)),
        },
        Mistake {
            name: "ignores the interval's max",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| {
                MeshHit::answer(&MeshHitQuestion {
                    within: Interval::new(q.within.min, f32::INFINITY),
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "ignores the interval's min",
            hint: "Can the ray hit what lies behind its origin?",
            answer: |q| {
                MeshHit::answer(&MeshHitQuestion {
                    within: Interval::new(f32::NEG_INFINITY, q.within.max),
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "forgets the last triangle",
            hint: "Try a list of a single triangle.",
            answer: |q| {
                let rest = &q.triangles[..q.triangles.len().saturating_sub(1)];
                MeshHit::answer(&MeshHitQuestion {
                    triangles: rest.to_vec(),
                    ..q.clone()
                })
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 54,
        alt: "Three triangles, one before the other, each in its colour",
        question: |x, y| {
            let toward = vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.0);
            let shifted = |by: Vec3| {
                let [p0, p1, p2] = [
                    vec3(-0.8, -0.7, 0.0),
                    vec3(0.8, -0.7, 0.0),
                    vec3(0.0, 0.8, 0.0),
                ]
                .map(|p| p + by);
                Corners { p0, p1, p2 }
            };
            MeshHitQuestion {
                ray: Ray::new(vec3(0.0, 0.0, 3.0), Dir3::new_or(toward, Dir3::Z)),
                within: Interval::AHEAD,
                triangles: [
                    vec3(0.5, 0.2, -0.4),
                    vec3(0.0, 0.0, 0.0),
                    vec3(-0.5, 0.1, -0.2),
                ]
                .map(shifted)
                .into(),
            }
        },
        colour: |_, hit| {
            hit.as_ref()
                .map_or(Rgb::gray(0.1), |hit| viridis(0.2 + 0.35 * hit.id as f32))
        },
    });

    fn edges() -> Vec<Edge<Self>> {
        let wall = |z: f32| Corners {
            p0: vec3(-2.0, -2.0, z),
            p1: vec3(2.0, -2.0, z),
            p2: vec3(0.0, 3.0, z),
        };
        let question = |walls: &[f32], within| MeshHitQuestion {
            ray: Ray::new(Vec3::ZERO, Dir3::Z),
            within,
            triangles: walls.iter().map(|&z| wall(z)).collect(),
        };
        let ahead = Interval::AHEAD;
        vec![
            Edge::new("near before far", question(&[2.0, 5.0], ahead)),
            Edge::new("far before near", question(&[5.0, 2.0], ahead)),
            Edge::new(
                "the nearest in the middle",
                question(&[7.0, 3.0, 5.0], ahead),
            ),
            Edge::new("one behind the origin", question(&[-1.0, 4.0], ahead)),
            Edge::new("a single triangle", question(&[3.0], ahead)),
            Edge::new("an empty list", question(&[], ahead)),
            Edge::new(
                "all beyond the interval",
                question(&[5.0, 6.0], Interval::new(0.0, 4.0)),
            ),
            Edge::new(
                "the nearest lies before the interval",
                question(&[2.0, 6.0], Interval::new(3.0, 9.0)),
            ),
            Edge::new("two at the same distance", question(&[3.0, 3.0], ahead))
                .or(Some(MeshHitAnswer { t: 3.0, id: 1 })),
        ]
    }

    fn random(rng: &mut Pcg) -> MeshHitQuestion {
        let count = rng.random_range(2..7);
        let corners = |rng: &mut Pcg| std::array::from_fn(|_| sample::point(rng, 2.5));
        let triangles = (0..count)
            .map(|_| {
                let [p0, p1, p2] = corners(rng);
                Corners { p0, p1, p2 }
            })
            .collect::<Vec<_>>();
        let max = if rng.random_bool(0.3) {
            sample::number(rng, 1.0, 4.0)
        } else {
            f32::INFINITY
        };
        let origin = sample::point(rng, 3.0);
        let direction = Dir3::new_or(sample::point(rng, 1.0) - origin, Dir3::X);
        MeshHitQuestion {
            ray: Ray::new(origin, direction),
            within: Interval::new(0.0, max),
            triangles,
        }
    }

    fn judge(
        _q: &MeshHitQuestion,
        golden: &Option<MeshHitAnswer>,
        got: &Option<MeshHitAnswer>,
    ) -> Verdict {
        judge::option("a hit", golden.as_ref(), got.as_ref(), |golden, got| {
            judge::number("t", "m", golden.t, got.t)?;
            if golden.id == got.id {
                Ok(())
            } else {
                Err(format!(
                    "you returned triangle {}, and triangle {} is hit",
                    got.id, golden.id
                ))
            }
        })
    }
}

/// The hit of each triangle that is hit, in the order of the list.
fn hits(q: &MeshHitQuestion) -> impl Iterator<Item = MeshHitAnswer> {
    q.triangles.iter().zip(0..).filter_map(|(triangle, id)| {
        let alone = MeshHitQuestion {
            triangles: vec![triangle.clone()],
            ..q.clone()
        };
        MeshHit::answer(&alone).map(|hit| MeshHitAnswer { id, ..hit })
    })
}
