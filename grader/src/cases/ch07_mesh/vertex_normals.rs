//! `vertex_normals`: random questions, judge and mistakes.

use crate::upon::changed;
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
            answer: |q| {
                averaged(q, |how| {
                    how.vector = |corners, _| across(corners).normalize_or_zero();
                })
            },
        },
        Mistake {
            name: "weighs by 1 over the area, so that small triangles count most",
            hint: "Cut a triangle in two, from a vertex to the opposite side: should the normal at this vertex change?",
            answer: |q| {
                averaged(q, |how| {
                    how.vector = |corners, _| {
                        let across = across(corners);
                        across / across.length_squared().max(f32::MIN_POSITIVE)
                    }
                })
            },
        },
        Mistake {
            name: "forgets to normalise",
            hint: "How long is a sum of many normals?",
            answer: |q| averaged(q, |how| how.normal = |sum, _| sum),
        },
        Mistake {
            name: "points inwards",
            hint: "Counter-clockwise seen from outside: e1 × e2 or e2 × e1?",
            answer: |q| averaged(q, |how| how.side = |vector| -vector),
        },
        Mistake {
            name: "keeps the last triangle's normal only",
            hint: "A vertex belongs to several triangles: do you add to its sum, or replace it?",
            answer: |q| averaged(q, |how| how.add = |_, vector, _| vector),
        },
        Mistake {
            name: "adds to the first corner only",
            hint: "Each triangle has three corners: to how many of them do you add its normal?",
            answer: |q| averaged(q, |how| how.shares = [1.0, 0.0, 0.0]),
        },
        Mistake {
            name: "returns NaN for a vertex without triangles",
            hint: "What is 0/0, and what does the task want instead?",
            answer: |q| averaged(q, |how| how.normal = |sum, _| sum / sum.length()),
        },
        Mistake {
            name: "returns a normal per triangle",
            hint: "How many normals are asked for: one per vertex, or one per triangle?",
            answer: |q| {
                let normal = |triangle| across(corners(q, triangle)).normalize_or(Vec3::Y);
                q.triangles.iter().map(normal).collect()
            },
        },
        Mistake {
            name: "returns 0 0 0 for a vertex without triangles",
            hint: "A normal has length 1, always: what does the task say of a vertex that no triangle has?",
            answer: |q| averaged(q, |how| how.normal = |sum, _| sum.normalize_or_zero()),
        },
        Mistake {
            name: "divides by the number of triangles instead of normalising",
            hint: "How long is the mean of two unit vectors that point in different directions?",
            answer: |q| {
                averaged(q, |how| {
                    how.normal = |sum, count| if count == 0.0 { Vec3::Y } else { sum / count }
                })
            },
        },
        Mistake {
            name: "adds every triangle to every vertex",
            hint: "Which triangles have this vertex as a corner?",
            answer: |q| {
                let across = |triangle| across(corners(q, triangle));
                let all: Vec3 = q.triangles.iter().map(across).sum();
                vec![all.normalize_or(Vec3::Y); q.positions.len()]
            },
        },
        Mistake {
            name: "leaves out the last corner of each triangle",
            hint: "How many corners has a triangle, and to how many of them do you add?",
            answer: |q| averaged(q, |how| how.shares = [1.0, 1.0, 0.0]),
        },
        Mistake {
            name: "keeps the first triangle's normal only",
            hint: "A vertex belongs to several triangles: do you add to its sum, or leave it as soon as it has something?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |first, vector, _| if first == Vec3::ZERO { vector } else { first }
                })
            },
        },
        Mistake {
            name: "returns +z for a vertex without triangles",
            hint: "What does the task say of a vertex that no triangle has? Which axis is up in this course?",
            answer: |q| averaged(q, |how| how.normal = |sum, _| sum.normalize_or(Vec3::Z)),
        },
        Mistake {
            name: "leaves out the first corner of each triangle",
            hint: "How many corners has a triangle, and to how many of them do you add?",
            answer: |q| averaged(q, |how| how.shares = [0.0, 1.0, 1.0]),
        },
        Mistake {
            name: "forgets the last triangle",
            hint: "Where does your loop over the triangles end?",
            answer: |q| {
                averaged(q, |how| {
                    how.taken = |all| all.split_last().map_or(all, |(_, others)| others);
                })
            },
        },
        Mistake {
            name: "forgets the first triangle",
            hint: "Where does your loop over the triangles begin?",
            answer: |q| {
                averaged(q, |how| {
                    how.taken = |all| all.split_first().map_or(all, |(_, others)| others);
                })
            },
        },
        Mistake {
            name: "weighs by the square of the area",
            hint: "The cross product is as long as twice the area already: how often do you multiply by it?",
            answer: |q| {
                averaged(q, |how| {
                    how.vector = |corners, _| {
                        let across = across(corners);
                        across * across.length()
                    }
                })
            },
        },
        Mistake {
            name: "leaves out the second corner of each triangle",
            hint: "How many corners has a triangle, and to how many of them do you add?",
            answer: |q| averaged(q, |how| how.shares = [1.0, 0.0, 1.0]),
        },
        Mistake {
            name: "points inwards at the first corner of each triangle",
            hint: "From each corner, the first of your edges goes to the next corner of the triangle: does it, at all three?",
            answer: |q| averaged(q, |how| how.shares = [-1.0, 1.0, 1.0]),
        },
        Mistake {
            name: "points inwards at the second corner of each triangle",
            hint: "From each corner, the first of your edges goes to the next corner of the triangle: does it, at all three?",
            answer: |q| averaged(q, |how| how.shares = [1.0, -1.0, 1.0]),
        },
        Mistake {
            name: "points inwards at the last corner of each triangle",
            hint: "From each corner, the first of your edges goes to the next corner of the triangle: does it, at all three?",
            answer: |q| averaged(q, |how| how.shares = [1.0, 1.0, -1.0]),
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
                averaged(q, |how| {
                    how.add = |sum, vector, _| {
                        let is_behind = vector.dot(sum) < 0.0;
                        sum + if is_behind { -vector } else { vector }
                    }
                })
            },
        },
        Mistake {
            name: "weighs by the angle at the vertex, not by the area",
            hint: "That is another average, a good one too: by what does the task weigh the triangles?",
            answer: |q| {
                averaged(q, |how| {
                    how.vector = |corners, k| {
                        let [e1, e2] = edges_at(corners, k);
                        let across = e1.cross(e2);
                        across.length().atan2(e1.dot(e2)) * across.normalize_or_zero()
                    }
                })
            },
        },
        Mistake {
            name: "returns 0 0 0 where the normals of a vertex's triangles cancel out",
            hint: "A normal has length 1, always: what does the task say of a sum that has no direction?",
            answer: |q| {
                averaged(q, |how| {
                    how.normal = |sum, count| {
                        if count == 0.0 {
                            Vec3::Y
                        } else {
                            sum.normalize_or_zero()
                        }
                    }
                })
            },
        },
        Mistake {
            name: "normalises the sum after each triangle",
            hint: "The sum must remember how large the triangles before were: what is left of that once it has the length 1?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |sum, vector, _| (sum + vector).normalize_or_zero();
                })
            },
        },
        Mistake {
            name: "takes the mean of what it has so far and each further triangle",
            hint: "Of three triangles, which share has the first one in your mean, and which the last?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |so_far, vector, _| {
                        if so_far == Vec3::ZERO {
                            vector
                        } else {
                            0.5 * (so_far + vector)
                        }
                    }
                })
            },
        },
        Mistake {
            name: "normalises the edges before the cross product, and so weighs by the sine of an angle",
            hint: "How long is the cross product of two unit vectors, and how large is the triangle?",
            answer: |q| {
                averaged(q, |how| {
                    how.vector = |corners, _| {
                        let [e1, e2] = edges_at(corners, 0).map(Vec3::normalize_or_zero);
                        e1.cross(e2)
                    }
                })
            },
        },
        Mistake {
            name: "weighs by the square root of the area",
            hint: "Of which length is the area the square, and does the task weigh by that?",
            answer: |q| {
                averaged(q, |how| {
                    how.vector = |corners, _| {
                        let across = across(corners);
                        across.normalize_or_zero() * across.length().sqrt()
                    }
                })
            },
        },
        Mistake {
            name: "weighs by the sine of the angle at the vertex over the lengths of both edges, as Max does",
            hint: "That is another average, a good one on a sphere: by what does the task weigh the triangles?",
            answer: |q| {
                averaged(q, |how| {
                    how.vector = |corners, k| {
                        let [e1, e2] = edges_at(corners, k);
                        e1.cross(e2)
                            / (e1.length_squared() * e2.length_squared()).max(f32::MIN_POSITIVE)
                    }
                })
            },
        },
        Mistake {
            name: "takes a small sum for zero",
            hint: "How long is the cross product of two edges of half a millimetre?",
            answer: |q| {
                averaged(q, |how| {
                    how.normal = |sum, _| {
                        let is_zero = sum.length() <= 1e-6;
                        if is_zero { Vec3::Y } else { sum.normalize() }
                    }
                })
            },
        },
        Mistake {
            name: "crosses the second corner and the third of each triangle, not two edges",
            hint: "Move the mesh by one metre: the normals must not change.",
            answer: |q| averaged(q, |how| how.vector = |[_, p1, p2], _| p1.cross(p2)),
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
                let directions = q
                    .positions
                    .iter()
                    .map(|p| (*p - middle).normalize_or(Vec3::Y));
                directions.collect()
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
                averaged(q, |how| {
                    how.side = |vector| if vector.y < 0.0 { -vector } else { vector };
                })
            },
        },
        Mistake {
            name: "gives every vertex the first triangle's normal",
            hint: "Which triangles have this vertex as a corner?",
            answer: |q| {
                let first = q.triangles.first().map(|first| across(corners(q, first)));
                vec![first.unwrap_or_default().normalize_or(Vec3::Y); q.positions.len()]
            },
        },
        Mistake {
            name: "adds +y for a triangle without area",
            hint: "What is +y the answer to, and what does such a triangle add to a sum?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |sum, vector, _| {
                        sum + if vector == Vec3::ZERO {
                            Vec3::Y
                        } else {
                            vector
                        }
                    }
                })
            },
        },
        Mistake {
            name: "takes the mean of what it has so far, at first zero, and each further triangle",
            hint: "Of three triangles, which share has the first one in your mean, and which the last?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |so_far, vector, _| 0.5 * (so_far + vector);
                })
            },
        },
        Mistake {
            name: "takes the mean of what it has so far, at first zero, and each further triangle's unit normal",
            hint: "Of three triangles, which share has the first one in your mean, and which the last? And where does its area come in?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |so_far, vector, _| 0.5 * (so_far + vector.normalize_or_zero());
                })
            },
        },
        Mistake {
            name: "takes the mean of what it has so far and each further triangle's unit normal",
            hint: "Of three triangles, which share has the first one in your mean, and which the last? And where does its area come in?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |so_far, vector, _| {
                        let normal = vector.normalize_or_zero();
                        if so_far == Vec3::ZERO {
                            normal
                        } else {
                            0.5 * (so_far + normal)
                        }
                    }
                })
            },
        },
        Mistake {
            name: "keeps the normal of the largest triangle only",
            hint: "An average has a share of every triangle: what becomes of the smaller ones?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |largest, vector, _| {
                        let is_larger = vector.length() > largest.length();
                        if is_larger { vector } else { largest }
                    }
                })
            },
        },
        Mistake {
            name: "adds unit normals, and normalises the sum after each triangle",
            hint: "The sum must remember how large the triangles before were: what is left of that once it has the length 1?",
            answer: |q| {
                averaged(q, |how| {
                    how.add =
                        |sum, vector, _| (sum + vector.normalize_or_zero()).normalize_or_zero();
                })
            },
        },
        Mistake {
            name: "divides by the number of triangles so far after each of them, the sum of before too",
            hint: "Of three triangles, by how much is the first one divided in all, and by how much the last?",
            answer: |q| {
                averaged(q, |how| {
                    how.add = |sum, vector, before| (sum + vector) / (before + 1.0);
                })
            },
        },
    ];
}

/// How normals are averaged; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The triangles that are looked at.
    taken: fn(&[Indices]) -> &[Indices],
    /// What a triangle with these `corners` adds to corner `k` of them.
    vector: fn(corners: [Vec3; 3], k: usize) -> Vec3,
    /// The same on the side to which it points.
    side: fn(vector: Vec3) -> Vec3,
    /// The share of it that each corner gets.
    shares: [f32; 3],
    /// What a vertex has next that has `so_far`, of `before` triangles, when another one adds its `vector`.
    add: fn(so_far: Vec3, vector: Vec3, before: f32) -> Vec3,
    /// The normal of a vertex that has this `sum` in the end, of `count` triangles.
    normal: fn(sum: Vec3, count: f32) -> Vec3,
}

/// As it should be.
const WELL: How = How {
    taken: |all| all,
    vector: |corners, _| across(corners),
    side: |vector| vector,
    shares: [1.0; 3],
    add: |sum, vector, _| sum + vector,
    normal: |sum, _| sum.normalize_or(Vec3::Y),
};

/// The normals, averaged rightly but for what is changed.
fn averaged(q: &VertexNormals, change: fn(&mut How)) -> Vec<Vec3> {
    let how = changed(WELL, change);
    let mut so_far = vec![(Vec3::ZERO, 0.0); q.positions.len()];
    for triangle in (how.taken)(&q.triangles) {
        let vertices = [triangle.a, triangle.b, triangle.c].into_iter();
        for (k, (vertex, share)) in vertices.zip(how.shares).enumerate() {
            if share != 0.0 {
                let vector = share * (how.side)((how.vector)(corners(q, triangle), k));
                let (sum, count) = &mut so_far[vertex as usize];
                *sum = (how.add)(*sum, vector, *count);
                *count += 1.0;
            }
        }
    }
    let normals = so_far.into_iter();
    normals
        .map(|(sum, count)| (how.normal)(sum, count))
        .collect()
}

/// The corners of a triangle.
fn corners(q: &VertexNormals, triangle: &Indices) -> [Vec3; 3] {
    [triangle.a, triangle.b, triangle.c].map(|i| q.positions[i as usize])
}

/// The edges from a corner to the next one, and to the last.
fn edges_at(corners: [Vec3; 3], k: usize) -> [Vec3; 2] {
    let [at, next, last] = [0, 1, 2].map(|i| corners[(k + i) % 3]);
    [next - at, last - at]
}

/// The cross product of the edges at the first corner: as long as twice the area.
fn across(corners: [Vec3; 3]) -> Vec3 {
    let [e1, e2] = edges_at(corners, 0);
    e1.cross(e2)
}
