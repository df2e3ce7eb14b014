//! `vertex_normals`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Verdict, judge, sample};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch07_mesh::{Indices, VertexNormals};

impl Graded for VertexNormals {
    fn random(rng: &mut Pcg) -> VertexNormals {
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
        VertexNormals {
            positions,
            triangles,
        }
    }

    fn judge(_q: &VertexNormals, golden: &Vec<Vec3>, got: &Vec<Vec3>) -> Verdict {
        if golden.len() != got.len() {
            return Err(format!(
                "there are {} vertices, but your list of normals has the length {}",
                golden.len(),
                got.len()
            ));
        }
        let mut pairs = golden.iter().zip(got).enumerate();
        pairs.try_for_each(|(i, (golden, got))| {
            judge::direction(&format!("the normal of vertex {i}"), *golden, *got)
        })
    }

    const FIXED: &'static [&'static str] = &["positions"];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "gives every triangle the same weight",
            hint: "Cut a triangle in two, from a vertex to the opposite side: should the normal at this vertex change?",
            answer: |q| normals(q, |e1, e2| e1.cross(e2).normalize_or_zero()),
        },
        Mistake {
            name: "weighs by 1 over the area, so that small triangles count most",
            hint: "Cut a triangle in two, from a vertex to the opposite side: should the normal at this vertex change?",
            answer: |q| {
                normals(q, |e1, e2| {
                    let across = e1.cross(e2);
                    across / across.length_squared().max(f32::MIN_POSITIVE)
                })
            },
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
            hint: "Each triangle has three corners: to how many of them do you add its normal?",
            answer: |q| by_corner(q, [1.0, 0.0, 0.0]),
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
        Mistake {
            name: "returns 0 0 0 for a vertex without triangles",
            hint: "A normal has length 1, always: what does the task say of a vertex that no triangle has?",
            answer: |q| {
                let sums = sums(q, Vec3::cross).into_iter();
                sums.map(Vec3::normalize_or_zero).collect()
            },
        },
        Mistake {
            name: "divides by the number of triangles instead of normalising",
            hint: "How long is the mean of two unit vectors that point in different directions?",
            answer: |q| {
                let counts = sums(q, |_, _| Vec3::ONE);
                let means = sums(q, Vec3::cross).into_iter().zip(counts);
                let mean = |(sum, count): (Vec3, Vec3)| {
                    if count == Vec3::ZERO {
                        Vec3::Y
                    } else {
                        sum / count
                    }
                };
                means.map(mean).collect()
            },
        },
        Mistake {
            name: "adds every triangle to every vertex",
            hint: "Which triangles have this vertex as a corner?",
            answer: |q| {
                let all: Vec3 = faces(q, Vec3::cross)
                    .map(|(_, twice_area)| twice_area)
                    .sum();
                vec![all.normalize_or(Vec3::Y); q.positions.len()]
            },
        },
        Mistake {
            name: "leaves out the last corner of each triangle",
            hint: "How many corners has a triangle, and to how many of them do you add?",
            answer: |q| by_corner(q, [1.0, 1.0, 0.0]),
        },
        Mistake {
            name: "keeps the first triangle's normal only",
            hint: "A vertex belongs to several triangles: do you add to its sum, or leave it as soon as it has something?",
            answer: |q| {
                let mut normals = vec![Vec3::ZERO; q.positions.len()];
                for (corners, twice_area) in faces(q, Vec3::cross) {
                    for i in corners {
                        if normals[i] == Vec3::ZERO {
                            normals[i] = twice_area;
                        }
                    }
                }
                normals
                    .into_iter()
                    .map(|n| n.normalize_or(Vec3::Y))
                    .collect()
            },
        },
        Mistake {
            name: "returns +z for a vertex without triangles",
            hint: "What does the task say of a vertex that no triangle has? Which axis is up in this course?",
            answer: |q| {
                sums(q, Vec3::cross)
                    .into_iter()
                    .map(|sum| sum.normalize_or(Vec3::Z))
                    .collect()
            },
        },
        Mistake {
            name: "leaves out the first corner of each triangle",
            hint: "How many corners has a triangle, and to how many of them do you add?",
            answer: |q| by_corner(q, [0.0, 1.0, 1.0]),
        },
        Mistake {
            name: "forgets the last triangle",
            hint: "Where does your loop over the triangles end?",
            answer: |q| {
                let mut fewer = q.clone();
                fewer.triangles.pop();
                normals(&fewer, Vec3::cross)
            },
        },
        Mistake {
            name: "forgets the first triangle",
            hint: "Where does your loop over the triangles begin?",
            answer: |q| {
                let mut fewer = q.clone();
                fewer.triangles = fewer.triangles.into_iter().skip(1).collect();
                normals(&fewer, Vec3::cross)
            },
        },
        Mistake {
            name: "weighs by the square of the area",
            hint: "The cross product is as long as twice the area already: how often do you multiply by it?",
            answer: |q| normals(q, |e1, e2| e1.cross(e2) * e1.cross(e2).length()),
        },
        Mistake {
            name: "leaves out the second corner of each triangle",
            hint: "How many corners has a triangle, and to how many of them do you add?",
            answer: |q| by_corner(q, [1.0, 0.0, 1.0]),
        },
        Mistake {
            name: "points inwards at the first corner of each triangle",
            hint: "From each corner, the first of your edges goes to the next corner of the triangle: does it, at all three?",
            answer: |q| by_corner(q, [-1.0, 1.0, 1.0]),
        },
        Mistake {
            name: "points inwards at the second corner of each triangle",
            hint: "From each corner, the first of your edges goes to the next corner of the triangle: does it, at all three?",
            answer: |q| by_corner(q, [1.0, -1.0, 1.0]),
        },
        Mistake {
            name: "points inwards at the last corner of each triangle",
            hint: "From each corner, the first of your edges goes to the next corner of the triangle: does it, at all three?",
            answer: |q| by_corner(q, [1.0, 1.0, -1.0]),
        },
        Mistake {
            name: "turns every normal up",
            hint: "It is the order of the corners that decides which side is outside, not the world.",
            answer: |q| {
                VertexNormals::right(q)
                    .into_iter()
                    .map(|n| if n.y < 0.0 { -n } else { n })
                    .collect()
            },
        },
        Mistake {
            name: "turns each triangle's normal to the side of the sum before it is added",
            hint: "The order of the corners says on which side of a triangle the outside is: may its normal be turned?",
            answer: |q| {
                let mut sums = vec![Vec3::ZERO; q.positions.len()];
                for (corners, twice_area) in faces(q, Vec3::cross) {
                    for i in corners {
                        let is_behind = twice_area.dot(sums[i]) < 0.0;
                        sums[i] += if is_behind { -twice_area } else { twice_area };
                    }
                }
                sums.into_iter()
                    .map(|sum| sum.normalize_or(Vec3::Y))
                    .collect()
            },
        },
        Mistake {
            name: "weighs by the angle at the vertex, not by the area",
            hint: "That is another average, a good one too: by what does the task weigh the triangles?",
            answer: |q| {
                let mut sums = vec![Vec3::ZERO; q.positions.len()];
                for (corners, twice_area) in faces(q, Vec3::cross) {
                    for k in 0..3 {
                        let [at, next, last] = [0, 1, 2].map(|i| q.positions[corners[(k + i) % 3]]);
                        let (e1, e2) = (next - at, last - at);
                        let angle = e1.cross(e2).length().atan2(e1.dot(e2));
                        sums[corners[k]] += angle * twice_area.normalize_or_zero();
                    }
                }
                sums.into_iter()
                    .map(|sum| sum.normalize_or(Vec3::Y))
                    .collect()
            },
        },
        Mistake {
            name: "returns 0 0 0 where the normals of a vertex's triangles cancel out",
            hint: "A normal has length 1, always: what does the task say of a sum that has no direction?",
            answer: |q| {
                let counts = sums(q, |_, _| Vec3::ONE);
                let all = sums(q, Vec3::cross).into_iter().zip(counts);
                all.map(|(sum, count)| {
                    if count == Vec3::ZERO {
                        Vec3::Y
                    } else {
                        sum.normalize_or_zero()
                    }
                })
                .collect()
            },
        },
    ];
}

/// Each triangle's corners, and a vector made of its edges.
fn faces(
    q: &VertexNormals,
    vector: fn(Vec3, Vec3) -> Vec3,
) -> impl Iterator<Item = ([usize; 3], Vec3)> {
    q.triangles.iter().map(move |t| {
        let corners = [t.a, t.b, t.c].map(|i| i as usize);
        let [p0, p1, p2] = corners.map(|i| q.positions[i]);
        (corners, vector(p1 - p0, p2 - p0))
    })
}

/// Per vertex, the sum of its triangles' vectors.
fn sums(q: &VertexNormals, vector: fn(Vec3, Vec3) -> Vec3) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; q.positions.len()];
    for (corners, vector) in faces(q, vector) {
        for i in corners {
            sums[i] += vector;
        }
    }
    sums
}

/// The normals, if each triangle is added to its three corners with these weights.
fn by_corner(q: &VertexNormals, weights: [f32; 3]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; q.positions.len()];
    for (corners, twice_area) in faces(q, Vec3::cross) {
        for (corner, weight) in corners.into_iter().zip(weights) {
            sums[corner] += weight * twice_area;
        }
    }
    sums.into_iter()
        .map(|sum| sum.normalize_or(Vec3::Y))
        .collect()
}

pub(super) fn normals(q: &VertexNormals, vector: fn(Vec3, Vec3) -> Vec3) -> Vec<Vec3> {
    sums(q, vector)
        .into_iter()
        .map(|sum| sum.normalize_or(Vec3::Y))
        .collect()
}
