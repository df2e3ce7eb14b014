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
                running(q, |first, twice_area| {
                    if first == Vec3::ZERO {
                        twice_area
                    } else {
                        first
                    }
                })
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
                running(q, |sum, twice_area| {
                    let is_behind = twice_area.dot(sum) < 0.0;
                    sum + if is_behind { -twice_area } else { twice_area }
                })
            },
        },
        Mistake {
            name: "weighs by the angle at the vertex, not by the area",
            hint: "That is another average, a good one too: by what does the task weigh the triangles?",
            answer: |q| {
                by_edges(q, |e1, e2| {
                    let across = e1.cross(e2);
                    across.length().atan2(e1.dot(e2)) * across.normalize_or_zero()
                })
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
        Mistake {
            name: "normalises the sum after each triangle",
            hint: "The sum must remember how large the triangles before were: what is left of that once it has the length 1?",
            answer: |q| running(q, |sum, twice_area| (sum + twice_area).normalize_or_zero()),
        },
        Mistake {
            name: "takes the mean of what it has so far and each further triangle",
            hint: "Of three triangles, which share has the first one in your mean, and which the last?",
            answer: |q| {
                running(q, |sum, twice_area| {
                    if sum == Vec3::ZERO {
                        twice_area
                    } else {
                        0.5 * (sum + twice_area)
                    }
                })
            },
        },
        Mistake {
            name: "normalises the edges before the cross product, and so weighs by the sine of an angle",
            hint: "How long is the cross product of two unit vectors, and how large is the triangle?",
            answer: |q| {
                normals(q, |e1, e2| {
                    e1.normalize_or_zero().cross(e2.normalize_or_zero())
                })
            },
        },
        Mistake {
            name: "weighs by the square root of the area",
            hint: "Of which length is the area the square, and does the task weigh by that?",
            answer: |q| {
                normals(q, |e1, e2| {
                    let across = e1.cross(e2);
                    across.normalize_or_zero() * across.length().sqrt()
                })
            },
        },
        Mistake {
            name: "weighs by the sine of the angle at the vertex over the lengths of both edges, as Max does",
            hint: "That is another average, a good one on a sphere: by what does the task weigh the triangles?",
            answer: |q| {
                by_edges(q, |e1, e2| {
                    e1.cross(e2)
                        / (e1.length_squared() * e2.length_squared()).max(f32::MIN_POSITIVE)
                })
            },
        },
        Mistake {
            name: "takes a small sum for zero",
            hint: "How long is the cross product of two edges of half a millimetre?",
            answer: |q| {
                let sums = sums(q, Vec3::cross).into_iter();
                let normal = |sum: Vec3| if sum.length() > 1e-6 { sum } else { Vec3::Y };
                sums.map(|sum| normal(sum).normalize()).collect()
            },
        },
        Mistake {
            name: "crosses the second corner and the third of each triangle, not two edges",
            hint: "Move the mesh by one metre: the normals must not change.",
            answer: |q| {
                let mut sums = vec![Vec3::ZERO; q.positions.len()];
                for (corners, _) in faces(q, Vec3::cross) {
                    let [_, p1, p2] = corners.map(|i| q.positions[i]);
                    for i in corners {
                        sums[i] += p1.cross(p2);
                    }
                }
                directions(sums)
            },
        },
        Mistake {
            name: "takes three vertices in a row for each triangle, whatever its numbers say",
            hint: "A vertex may belong to several triangles: which vertices has the second triangle of the list?",
            answer: |q| {
                let rows = 0..q.positions.len() as u32 / 3;
                let in_a_row = |i: u32| Indices {
                    a: 3 * i,
                    b: 3 * i + 1,
                    c: 3 * i + 2,
                };
                Self::misread(q, |q| q.triangles = rows.map(in_a_row).collect())
            },
        },
        Mistake {
            name: "takes the direction from the middle of all vertices to the vertex",
            hint: "That is right on a sphere: does it look at the triangles at all?",
            answer: |q| {
                let middle = q.positions.iter().sum::<Vec3>() / q.positions.len().max(1) as f32;
                directions(q.positions.iter().map(|p| *p - middle))
            },
        },
        Mistake {
            name: "ends at the first triangle without area",
            hint: "A triangle without area adds nothing: do those after it?",
            answer: |q| {
                let area = |t: &&Indices| {
                    let [p0, p1, p2] = [t.a, t.b, t.c].map(|i| q.positions[i as usize]);
                    (p1 - p0).cross(p2 - p0) != Vec3::ZERO
                };
                let until = q.triangles.iter().take_while(area).cloned().collect();
                Self::misread(q, |q| q.triangles = until)
            },
        },
        Mistake {
            name: "turns each triangle's normal up before it is added",
            hint: "It is the order of the corners that decides which side is outside, not the world.",
            answer: |q| {
                normals(q, |e1, e2| {
                    let across = e1.cross(e2);
                    if across.y < 0.0 { -across } else { across }
                })
            },
        },
        Mistake {
            name: "gives every vertex the first triangle's normal",
            hint: "Which triangles have this vertex as a corner?",
            answer: |q| {
                let first = faces(q, Vec3::cross).next();
                let normal = first.map_or(Vec3::Y, |(_, n)| n.normalize_or(Vec3::Y));
                vec![normal; q.positions.len()]
            },
        },
        Mistake {
            name: "adds +y for a triangle without area",
            hint: "What is +y the answer to, and what does such a triangle add to a sum?",
            answer: |q| {
                running(q, |so_far, v| {
                    so_far + if v == Vec3::ZERO { Vec3::Y } else { v }
                })
            },
        },
        Mistake {
            name: "takes the mean of what it has so far, at first zero, and each further triangle",
            hint: "Of three triangles, which share has the first one in your mean, and which the last?",
            answer: |q| running(q, |so_far, twice_area| 0.5 * (so_far + twice_area)),
        },
        Mistake {
            name: "takes the mean of what it has so far, at first zero, and each further triangle's unit normal",
            hint: "Of three triangles, which share has the first one in your mean, and which the last? And where does its area come in?",
            answer: |q| {
                running(q, |so_far, twice_area| {
                    0.5 * (so_far + twice_area.normalize_or_zero())
                })
            },
        },
        Mistake {
            name: "takes the mean of what it has so far and each further triangle's unit normal",
            hint: "Of three triangles, which share has the first one in your mean, and which the last? And where does its area come in?",
            answer: |q| {
                running(q, |so_far, twice_area| {
                    let normal = twice_area.normalize_or_zero();
                    if so_far == Vec3::ZERO {
                        normal
                    } else {
                        0.5 * (so_far + normal)
                    }
                })
            },
        },
        Mistake {
            name: "keeps the normal of the largest triangle only",
            hint: "An average has a share of every triangle: what becomes of the smaller ones?",
            answer: |q| {
                running(q, |largest, twice_area| {
                    if twice_area.length() > largest.length() {
                        twice_area
                    } else {
                        largest
                    }
                })
            },
        },
        Mistake {
            name: "adds unit normals, and normalises the sum after each triangle",
            hint: "The sum must remember how large the triangles before were: what is left of that once it has the length 1?",
            answer: |q| {
                running(q, |sum, twice_area| {
                    (sum + twice_area.normalize_or_zero()).normalize_or_zero()
                })
            },
        },
        Mistake {
            name: "divides by the number of triangles so far after each of them, the sum of before too",
            hint: "Of three triangles, by how much is the first one divided in all, and by how much the last?",
            answer: |q| {
                let mut so_far = vec![(Vec3::ZERO, 0.0); q.positions.len()];
                for (corners, twice_area) in faces(q, Vec3::cross) {
                    for i in corners {
                        let (sum, count) = so_far[i];
                        so_far[i] = ((sum + twice_area) / (count + 1.0), count + 1.0);
                    }
                }
                directions(so_far.into_iter().map(|(sum, _)| sum))
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
    directions(sums)
}

/// The normals, if `together` makes of what a vertex has so far and a triangle's vector what the vertex has next, in the place of a sum.
fn running(q: &VertexNormals, together: fn(Vec3, Vec3) -> Vec3) -> Vec<Vec3> {
    let mut so_far = vec![Vec3::ZERO; q.positions.len()];
    for (corners, twice_area) in faces(q, Vec3::cross) {
        for i in corners {
            so_far[i] = together(so_far[i], twice_area);
        }
    }
    directions(so_far)
}

/// The normals, if each triangle adds to a corner a vector that is made of the two edges at this corner.
fn by_edges(q: &VertexNormals, vector: fn(Vec3, Vec3) -> Vec3) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; q.positions.len()];
    for (corners, _) in faces(q, Vec3::cross) {
        for k in 0..3 {
            let [at, next, last] = [0, 1, 2].map(|i| q.positions[corners[(k + i) % 3]]);
            sums[corners[k]] += vector(next - at, last - at);
        }
    }
    directions(sums)
}

/// The directions of vectors, and +y where a vector is zero.
fn directions(vectors: impl IntoIterator<Item = Vec3>) -> Vec<Vec3> {
    let vectors = vectors.into_iter();
    vectors.map(|v| v.normalize_or(Vec3::Y)).collect()
}

pub(super) fn normals(q: &VertexNormals, vector: fn(Vec3, Vec3) -> Vec3) -> Vec<Vec3> {
    directions(sums(q, vector))
}
