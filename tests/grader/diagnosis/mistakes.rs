//! The mistakes: each as a function from the numbers of a question, and the right function, to the numbers of an answer.

#![allow(
    clippy::needless_for_each,
    clippy::semicolon_if_nothing_returned,
    reason = "a table of functions of a line each"
)]

use std::f64::consts::PI;

/// The answer of a function with a mistake to a question, given the right function.
type Answer = fn(&[f64], &dyn Fn(&[f64]) -> Vec<f64>) -> Vec<f64>;

/// A mistake.
pub struct Slip {
    /// The exercise.
    pub exercise: &'static str,
    /// What is wrong.
    pub what: &'static str,
    /// Words by any of which it is named; `&` stands between words that are all needed.
    pub names: &'static [&'static str],
    /// Its answer to a question, given the right function.
    pub answer: Answer,
}

pub const fn slip(
    exercise: &'static str,
    what: &'static str,
    names: &'static [&'static str],
    answer: Answer,
) -> Slip {
    Slip {
        exercise,
        what,
        names,
        answer,
    }
}

/// The right answer, changed.
fn changed(mut answer: Vec<f64>, change: impl Fn(&mut [f64])) -> Vec<f64> {
    change(&mut answer);
    answer
}

/// The right answer to a question that was misread.
pub fn misread(
    q: &[f64],
    right: &dyn Fn(&[f64]) -> Vec<f64>,
    change: impl Fn(&mut [f64]),
) -> Vec<f64> {
    let mut q = q.to_vec();
    change(&mut q);
    right(&q)
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

pub fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

pub fn cross(a: &[f64], b: &[f64]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Phong's model, with the highlight's cosine.
fn phong(q: &[f64], cosine: f64, power: f64) -> Vec<f64> {
    let (n, l) = (&q[..3], &q[6..9]);
    let lambert = dot(n, l);
    let channel = |i: usize| {
        if lambert <= 0.0 {
            return 0.0;
        }
        q[9 + i] * (q[12 + i] * lambert + q[15 + i] * cosine.max(0.0).powf(power))
    };
    (0..3).map(channel).collect()
}

/// The cosine between the mirrored light and the viewer.
fn mirrored(q: &[f64]) -> f64 {
    let (n, v, l) = (&q[..3], &q[3..6], &q[6..9]);
    2.0 * dot(n, l) * dot(n, v) - dot(l, v)
}

/// The mistakes.
pub const MISTAKES: &[Slip] = &[
    slip("ray_at", "halves t", &["half of t"], |q, right| {
        misread(q, right, |q| q[6] *= 0.5)
    }),
    slip(
        "ray_at",
        "ends at 100 m",
        &["more than 100 for t"],
        |q, right| misread(q, right, |q| q[6] = q[6].min(100.0)),
    ),
    slip(
        "expose",
        "divides by twice the stops where they are negative",
        &["where that is negative"],
        |q, right| {
            if q[3] < 0.0 {
                q[..3].iter().map(|v| v / (2.0 * q[3].abs())).collect()
            } else {
                right(q)
            }
        },
    ),
    slip(
        "sphere_hit",
        "gives up inside",
        &["begins inside"],
        |q, right| {
            let m = [q[0] - q[8], q[1] - q[9], q[2] - q[10]];
            if length(&m) < q[11] {
                vec![0.0]
            } else {
                right(q)
            }
        },
    ),
    slip(
        "bvh_closest",
        "counts each box twice",
        &["2 times boxes"],
        |q, right| changed(right(q), |n| n[0] *= 2.0),
    ),
    slip("ray_at", "squares t", &["square of t"], |q, right| {
        misread(q, right, |q| q[6] *= q[6])
    }),
    slip("ray_at", "subtracts the origin", &["origin"], |q, _| {
        (0..3).map(|i| q[6] * q[3 + i] - q[i]).collect()
    }),
    slip(
        "ray_at",
        "y and z are exchanged in the answer",
        &["exchanges y and z"],
        |q, right| changed(right(q), |p| p.swap(1, 2)),
    ),
    slip("ray_at", "forgets z", &["z"], |q, right| {
        changed(right(q), |p| p[2] = 0.0)
    }),
    slip("ray_at", "prints one digit", &["digit"], |q, right| {
        changed(right(q), |p| {
            p.iter_mut().for_each(|v| *v = (*v * 10.0).round() / 10.0)
        })
    }),
    slip(
        "camera_ray",
        "width and height of the plane exchanged",
        &["width and height", "exchanges plane.x and plane.y"],
        |q, right| misread(q, right, |q| q.swap(13, 14)),
    ),
    slip(
        "camera_ray",
        "film x and y exchanged",
        &["exchanges film.x and film.y"],
        |q, right| misread(q, right, |q| q.swap(15, 16)),
    ),
    slip(
        "camera_ray",
        "focal length squared",
        &["square of focal_length"],
        |q, right| misread(q, right, |q| q[12] *= q[12]),
    ),
    slip(
        "camera_ray",
        "starts at 0",
        &["focal_point", "origin"],
        |q, right| changed(right(q), |r| r[..3].fill(0.0)),
    ),
    slip(
        "camera_ray",
        "film from −1 to 1",
        &["film", "half"],
        |q, right| misread(q, right, |q| (q[15], q[16]) = (q[15] + 0.5, q[16])),
    ),
    slip(
        "expose",
        "has 10 for the base",
        &["power", "stops", "base"],
        |q, _| (0..3).map(|i| q[i] * 10_f64.powf(q[3])).collect(),
    ),
    slip(
        "expose",
        "one stop too many",
        &["2 times", "adds 1 to stops"],
        |q, right| changed(right(q), |c| c.iter_mut().for_each(|v| *v *= 2.0)),
    ),
    slip(
        "expose",
        "red and blue exchanged",
        &["exchanges r and b", "radiance.r and radiance.b"],
        |q, right| changed(right(q), |c| c.swap(0, 2)),
    ),
    slip("tone_map", "luminance of Rec. 601", &["601"], |q, _| {
        let l = 0.299 * q[0] + 0.587 * q[1] + 0.114 * q[2];
        q.iter().map(|v| v / (1.0 + l)).collect()
    }),
    slip(
        "tone_map",
        "takes the largest channel for the luminance",
        &["largest"],
        |q, _| {
            let l = q.iter().copied().fold(0.0, f64::max);
            q.iter().map(|v| v / (1.0 + l)).collect()
        },
    ),
    slip(
        "tone_map",
        "encodes for a display",
        &["display"],
        |q, right| {
            changed(right(q), |c| {
                c.iter_mut().for_each(|v| *v = v.powf(1.0 / 2.2))
            })
        },
    ),
    slip(
        "encode_srgb",
        "threshold of the inverse curve",
        &["threshold", "inverse"],
        |q, _| {
            let v = q[0].clamp(0.0, 1.0);
            vec![if v <= 0.04045 {
                12.92 * v
            } else {
                1.055 * v.powf(1.0 / 2.4) - 0.055
            }]
        },
    ),
    slip("encode_srgb", "returns a byte", &["255"], |q, right| {
        changed(right(q), |v| v[0] *= 255.0)
    }),
    slip(
        "encode_srgb",
        "a table of 512 values",
        &["steps of 1/512", "steps of 1/511"],
        |q, right| misread(q, right, |q| q[0] = (512.0 * q[0]).floor() / 512.0),
    ),
    slip(
        "encode_srgb",
        "a table of 1024 values, the nearest of which is taken",
        &["steps of 1/1024"],
        |q, right| misread(q, right, |q| q[0] = (1024.0 * q[0]).round() / 1024.0),
    ),
    slip(
        "encode_srgb",
        "exponent 1/2.2 in the curve",
        &["1/2.2", "2.2"],
        |q, _| {
            let v = q[0].clamp(0.0, 1.0);
            vec![if v <= 0.003_130_8 {
                12.92 * v
            } else {
                1.055 * v.powf(1.0 / 2.2) - 0.055
            }]
        },
    ),
    slip(
        "solve_quadratic",
        "divides by 2 instead of 2a",
        &[
            "instead of 2a",
            "returns the right answer times a",
            "times a",
        ],
        |q, right| changed(right(q), |t| t[1..].iter_mut().for_each(|t| *t *= q[0])),
    ),
    slip(
        "solve_quadratic",
        "takes c for its negative",
        &["sign of c"],
        |q, right| misread(q, right, |q| q[2] = -q[2]),
    ),
    slip(
        "solve_quadratic",
        "exchanges a and c",
        &["exchanges a and c", "reciprocal"],
        |q, right| misread(q, right, |q| q.swap(0, 2)),
    ),
    slip(
        "solve_quadratic",
        "the larger first",
        &["unsorted", "exchanges", "larger"],
        |q, right| {
            changed(right(q), |t| {
                if t.len() > 2 {
                    t.swap(1, 2)
                }
            })
        },
    ),
    slip(
        "sphere_hit",
        "takes the diameter for the radius",
        &["twice radius", "half of radius"],
        |q, right| misread(q, right, |q| q[11] *= 0.5),
    ),
    slip(
        "sphere_hit",
        "the sign of the centre",
        &["center"],
        |q, right| misread(q, right, |q| q[8..11].iter_mut().for_each(|v| *v = -*v)),
    ),
    slip(
        "sphere_hit",
        "returns t from the nearest point to the centre",
        &["nearest to the centre"],
        |q, right| {
            let from = minus(&q[8..11], &q[..3]);
            let middle = dot(&from, &q[3..6]);
            changed(right(q), |t| {
                if t.len() > 1 {
                    t[1] -= middle
                }
            })
        },
    ),
    slip(
        "sphere_hit",
        "returns the discriminant's root",
        &["half", "root"],
        |q, right| {
            changed(right(q), |t| {
                if t.len() > 1 {
                    t[1] = t[1].sqrt()
                }
            })
        },
    ),
    slip(
        "sphere_hit",
        "t twice as large",
        &["2 times", "twice"],
        |q, right| {
            changed(right(q), |t| {
                if t.len() > 1 {
                    t[1] *= 2.0
                }
            })
        },
    ),
    slip(
        "sphere_hit",
        "never hits from inside",
        &["gives up", "inside"],
        |q, right| {
            let from = minus(&q[8..11], &q[..3]);
            if length(&from) < q[11] {
                vec![0.0]
            } else {
                right(q)
            }
        },
    ),
    slip(
        "sphere_normal",
        "divides by the diameter",
        &["half", "0.5"],
        |q, right| changed(right(q), |n| n.iter_mut().for_each(|v| *v *= 0.5)),
    ),
    slip(
        "sphere_normal",
        "subtracts the radius",
        &["normal", "radius", "subtracts “|p − c|”"],
        |q, _| {
            let n: Vec<_> = (0..3).map(|i| q[4 + i] - q[i] - q[3]).collect();
            let l = length(&n);
            n.iter().map(|v| v / l).collect()
        },
    ),
    slip(
        "sphere_normal",
        "adds centre and point",
        &["sign of center", "center"],
        |q, _| {
            let n: Vec<_> = (0..3).map(|i| q[4 + i] + q[i]).collect();
            let l = length(&n);
            n.iter().map(|v| v / l).collect()
        },
    ),
    slip(
        "plane_hit",
        "exchanges direction and normal",
        &["exchanges direction and normal"],
        |q, right| misread(q, right, |q| (0..3).for_each(|i| q.swap(3 + i, 8 + i))),
    ),
    slip(
        "plane_hit",
        "takes the origin's distance without the offset",
        &["0 for offset", "world's origin"],
        |q, right| misread(q, right, |q| q[11] = 0.0),
    ),
    slip("plane_hit", "begins at 0", &["within.min"], |q, right| {
        misread(q, right, |q| q[6] = 0.0)
    }),
    slip(
        "plane_hit",
        "multiplies by n·d",
        &["direction·normal", "along the normal"],
        |q, right| {
            let d = dot(&q[3..6], &q[8..11]);
            changed(right(q), |t| {
                if t.len() > 1 {
                    t[1] *= d * d
                }
            })
        },
    ),
    slip(
        "box_clip",
        "near and far not exchanged along x",
        &["negative direction", "swap"],
        |q, right| {
            if q[3] < 0.0 { vec![0.0] } else { right(q) }
        },
    ),
    slip(
        "box_clip",
        "returns far before near",
        &["exchanges"],
        |q, right| {
            changed(right(q), |t| {
                if t.len() > 2 {
                    t.swap(1, 2)
                }
            })
        },
    ),
    slip("box_clip", "forgets z", &["z", "third"], |q, right| {
        misread(q, right, |q| (q[10], q[13]) = (-1e9, 1e9))
    }),
    slip(
        "bounds_of",
        "gives least corner and size",
        &["size", "minus the right min"],
        |q, right| {
            let b = right(q);
            (0..6)
                .map(|i| if i < 3 { b[i] } else { b[i] - b[i - 3] })
                .collect()
        },
    ),
    slip(
        "triangle_hit",
        "exchanges p1 and p2",
        &["swaps b1 and b2", "exchanges"],
        |q, right| misread(q, right, |q| (0..3).for_each(|i| q.swap(11 + i, 14 + i))),
    ),
    slip(
        "triangle_hit",
        "t twice too large and b1 and b2 swapped",
        &["2 times&b1 and b2"],
        |q, right| {
            changed(right(q), |h| {
                if h.len() > 1 {
                    h[1] *= 2.0;
                    h.swap(2, 3);
                }
            })
        },
    ),
    slip(
        "triangle_hit",
        "t has the wrong sign",
        &["sign"],
        |q, right| {
            changed(right(q), |h| {
                if h.len() > 1 {
                    h[1] = -h[1]
                }
            })
        },
    ),
    slip(
        "triangle_hit",
        "weights are halved",
        &["half", "0.5"],
        |q, right| {
            changed(right(q), |h| {
                if h.len() > 1 {
                    h[2] *= 0.5;
                    h[3] *= 0.5;
                }
            })
        },
    ),
    slip(
        "triangle_normal",
        "gives up for small triangles",
        &["small", "none"],
        |q, right| {
            let area = length(&cross(&minus(&q[3..6], &q[..3]), &minus(&q[6..9], &q[..3])));
            if area < 0.01 { vec![0.0] } else { right(q) }
        },
    ),
    slip(
        "triangle_normal",
        "twice as long",
        &["2 times"],
        |q, right| changed(right(q), |n| n[1..].iter_mut().for_each(|v| *v *= 2.0)),
    ),
    slip(
        "triangle_normal",
        "z turned",
        &["sign of z", "sign of the last component"],
        |q, right| {
            changed(right(q), |n| {
                if n.len() > 3 {
                    n[3] = -n[3]
                }
            })
        },
    ),
    slip(
        "interpolate_normal",
        "b1 is 1 − b1",
        &["1 − b.x"],
        |q, right| misread(q, right, |q| q[9] = 1.0 - q[9]),
    ),
    slip(
        "interpolate_normal",
        "n0 and n1 exchanged",
        &["n0 and n1", "wrong corners"],
        |q, right| misread(q, right, |q| (0..3).for_each(|i| q.swap(i, i + 3))),
    ),
    slip(
        "interpolate_texture",
        "v from below",
        &["1 − y", "other end"],
        |q, right| changed(right(q), |t| t[1] = 1.0 - t[1]),
    ),
    slip("interpolate_texture", "forgets b2", &["b.y"], |q, right| {
        misread(q, right, |q| q[7] = 0.0)
    }),
    slip(
        "vertex_normals",
        "points inwards",
        &["other way round", "sign", "inwards"],
        |q, right| changed(right(q), |n| n[1..].iter_mut().for_each(|v| *v = -*v)),
    ),
    slip("mesh_hit", "ids from 1", &["from 1"], |q, right| {
        changed(right(q), |h| {
            if h.len() > 2 {
                h[2] += 1.0
            }
        })
    }),
    slip("mesh_hit", "always id 0", &["0", "id"], |q, right| {
        changed(right(q), |h| {
            if h.len() > 2 {
                h[2] = 0.0
            }
        })
    }),
    slip(
        "mesh_hit",
        "forgets the last triangle",
        &["last"],
        |q, right| {
            if q[8] == 0.0 {
                return right(q);
            }
            let mut less = q[..q.len() - 9].to_vec();
            less[8] -= 1.0;
            right(&less)
        },
    ),
    slip(
        "grid_resolution",
        "counts in half",
        &["half of shapes", "density"],
        |q, right| misread(q, right, |q| q[4] *= 0.5),
    ),
    slip(
        "grid_resolution",
        "one more along each axis",
        &[
            "the value plus 1",
            "1 too much",
            "one too much",
            "from 1",
            "more than the budget",
        ],
        |q, right| changed(right(q), |n| n.iter_mut().for_each(|v| *v += 1.0)),
    ),
    slip(
        "grid_resolution",
        "x and z exchanged",
        &["x and z", "exchanges x"],
        |q, right| changed(right(q), |n| n.swap(0, 2)),
    ),
    slip(
        "voxels_of_triangle",
        "x and z exchanged",
        &["x and z"],
        |q, right| {
            changed(right(q), |n| {
                n[1..].chunks_mut(3).for_each(|c| c.swap(0, 2))
            })
        },
    ),
    slip(
        "voxels_of_triangle",
        "counts cells from 1",
        &["from 1"],
        |q, right| changed(right(q), |n| n[1..].iter_mut().for_each(|v| *v += 1.0)),
    ),
    slip(
        "grid_walk",
        "leaves at the middle",
        &["leave"],
        |q, right| changed(right(q), |n| n[1..].chunks_mut(4).for_each(|c| c[3] *= 0.5)),
    ),
    slip(
        "grid_walk",
        "goes on to the end of the grid",
        &["past the interval's max"],
        |q, right| {
            let inside = right(q);
            let endless = misread(q, right, |q| q[16] = f64::INFINITY);
            if inside[0] > 0.0 { endless } else { inside }
        },
    ),
    slip(
        "grid_walk",
        "walks to the end of the grid, with distances up to the interval's end",
        &["but not the walk"],
        |q, right| {
            let inside = right(q);
            let endless = misread(q, right, |q| q[16] = f64::INFINITY);
            let cut = changed(endless, |n| {
                n[1..].chunks_mut(4).for_each(|c| c[3] = c[3].min(q[16]))
            });
            if inside[0] > 0.0 { cut } else { inside }
        },
    ),
    slip(
        "mesh_hit",
        "begins at 0 again after a hit",
        &["at 0 again"],
        |q, right| {
            let mut best = vec![0.0];
            let mut q = q.to_vec();
            let triangles = q.split_off(8)[1..].to_vec();
            for (i, triangle) in triangles.chunks(9).enumerate() {
                let hit = right(&[&q[..], &[1.0], triangle].concat());
                if let [_, t, _] = hit[..] {
                    (q[6], q[7]) = (0.0, t);
                    best = vec![1.0, t, i as f64];
                }
            }
            best
        },
    ),
    slip(
        "refine_cell",
        "all shapes in the first cell",
        &["the first fine cell"],
        |q, right| {
            let entries = (0..q[7] as u32).map(|shape| [0.0, 0.0, 0.0, shape.into()]);
            let entries: Vec<_> = entries.collect();
            [&right(q)[..3], &[q[7]], &entries.concat()].concat()
        },
    ),
    slip(
        "grid_walk",
        "y and z exchanged",
        &["y and z"],
        |q, right| {
            changed(right(q), |n| {
                n[1..].chunks_mut(4).for_each(|c| c.swap(1, 2))
            })
        },
    ),
    slip(
        "grid_walk",
        "takes cells for cubes",
        &["cell.x for every", "cubes"],
        |q, right| misread(q, right, |q| (q[4], q[5]) = (q[3], q[3])),
    ),
    slip(
        "two_level_walk",
        "counts from 1",
        &["from 1"],
        |q, right| changed(right(q), |n| n[1..].iter_mut().for_each(|v| *v += 1.0)),
    ),
    slip("octree_child", "counts from 1", &["from 1"], |q, right| {
        changed(right(q), |n| n[0] += 1.0)
    }),
    slip("octree_walk", "ids from 1", &["from 1"], |q, right| {
        changed(right(q), |n| n[1..].iter_mut().for_each(|v| *v += 1.0))
    }),
    slip(
        "sah_cost",
        "the prices exchanged",
        &["exchanges branch and shape"],
        |q, right| misread(q, right, |q| q.swap(0, 1)),
    ),
    slip("sah_cost", "twice", &["2 times"], |q, right| {
        changed(right(q), |c| c[0] *= 2.0)
    }),
    slip("phong", "takes N·V", &["N·V"], |q, _| {
        phong(q, dot(&q[..3], &q[3..6]), q[18])
    }),
    slip(
        "phong",
        "k_d and k_s exchanged",
        &["k_d and k_s", "exchanges diffuse and specular"],
        |q, right| misread(q, right, |q| (0..3).for_each(|i| q.swap(12 + i, 15 + i))),
    ),
    slip(
        "phong",
        "exponent forgotten",
        &["1 for exponent", "exponent"],
        |q, _| phong(q, mirrored(q), 1.0),
    ),
    slip("phong", "divides by π", &["π"], |q, right| {
        changed(right(q), |c| c.iter_mut().for_each(|v| *v /= PI))
    }),
    slip("phong", "exponent doubled", &["twice exponent"], |q, _| {
        phong(q, mirrored(q), 2.0 * q[18])
    }),
    slip(
        "blinn_phong",
        "quarter of the exponent",
        &["quarter of exponent"],
        |q, right| misread(q, right, |q| q[18] *= 0.25),
    ),
    slip(
        "blinn_phong",
        "only the diffuse part",
        &["specular", "highlight"],
        |q, right| misread(q, right, |q| q[15..18].fill(0.0)),
    ),
    slip(
        "point_light",
        "intensity over distance cubed",
        &["divided by the right distance", "distance"],
        |q, right| {
            changed(right(q), |l| {
                if l.len() > 4 {
                    let d = l[4];
                    l[5..].iter_mut().for_each(|v| *v /= d);
                }
            })
        },
    ),
    slip(
        "point_light",
        "0.02 added to the square of the distance",
        &["plus 0.02"],
        |q, right| {
            changed(right(q), |l| {
                if l.len() > 4 {
                    let square = l[4] * l[4];
                    l[5..]
                        .iter_mut()
                        .for_each(|v| *v *= square / (square + 0.02));
                }
            })
        },
    ),
    slip(
        "point_light",
        "4π too much and the direction turned round",
        &["4π&sign", "4π&away", "4π&opposite"],
        |q, right| {
            changed(right(q), |l| {
                if l.len() > 4 {
                    l[1..4].iter_mut().for_each(|v| *v = -*v);
                    l[5..].iter_mut().for_each(|v| *v *= 4.0 * PI);
                }
            })
        },
    ),
    slip("reflect", "x turned", &["sign of x"], |q, right| {
        changed(right(q), |r| r[0] = -r[0])
    }),
    slip(
        "reflect",
        "exchanges the arguments",
        &["exchanges incoming and normal"],
        |q, right| misread(q, right, |q| (0..3).for_each(|i| q.swap(i, i + 3))),
    ),
    slip("refract", "twice as long", &["2 times"], |q, right| {
        changed(right(q), |r| r[1..].iter_mut().for_each(|v| *v *= 2.0))
    }),
    slip(
        "refract",
        "the sign of the answer",
        &["opposite", "sign"],
        |q, right| changed(right(q), |r| r[1..].iter_mut().for_each(|v| *v = -*v)),
    ),
    slip(
        "fresnel",
        "Rs and Rp halved",
        &["half", "0.5"],
        |q, right| {
            changed(right(q), |r| {
                r[0] *= 0.5;
                r[1] *= 0.5;
            })
        },
    ),
    slip(
        "fresnel",
        "returns what goes through",
        &["1 minus"],
        |q, right| changed(right(q), |r| r.iter_mut().for_each(|v| *v = 1.0 - *v)),
    ),
    slip(
        "shadow_ray",
        "dark length",
        &["direction", "normalise"],
        |q, right| changed(right(q), |w| w[3..6].iter_mut().for_each(|v| *v *= 2.0)),
    ),
    slip(
        "lit",
        "ignores all spheres",
        &["every light", "ignores the list", "horizon"],
        |q, _| vec![f64::from(q.len() > 11)],
    ),
    slip(
        "brdf_phong",
        "forgets 2 in (n + 2)",
        &["factor", "lobe", "exponent"],
        |q, right| misread(q, right, |q| q[15] += 1.0),
    ),
    slip("brdf_phong", "π too much", &["π"], |q, right| {
        changed(right(q), |c| c.iter_mut().for_each(|v| *v *= PI))
    }),
    slip(
        "direction_to_cube",
        "faces from 1",
        &["from 1"],
        |q, right| changed(right(q), |p| p[0] += 1.0),
    ),
    slip(
        "direction_to_cube",
        "u and v exchanged",
        &["exchanges u and v"],
        |q, right| changed(right(q), |p| p.swap(1, 2)),
    ),
    slip(
        "direction_to_cube",
        "v from below",
        &["upside down", "1 minus v"],
        |q, right| changed(right(q), |p| p[2] = 1.0 - p[2]),
    ),
    slip(
        "direction_to_latlong",
        "u and v exchanged",
        &["exchanges x and y"],
        |q, right| changed(right(q), |p| p.swap(0, 1)),
    ),
    slip(
        "direction_to_latlong",
        "y and z of the world exchanged",
        &["exchanges direction.y and direction.z"],
        |q, right| misread(q, right, |q| q.swap(1, 2)),
    ),
    slip("environment_pdf", "forgets π", &["π"], |q, right| {
        changed(right(q), |p| p[0] *= PI)
    }),
    slip(
        "environment_pdf",
        "width and height exchanged in the factor",
        &["width", "height"],
        |q, right| changed(right(q), |p| p[0] *= q[3] / q[4]),
    ),
    slip(
        "circle_of_confusion",
        "half",
        &["quarter", "radius", "half"],
        |q, right| changed(right(q), |p| p[0] *= 0.25),
    ),
    slip(
        "circle_of_confusion",
        "f-number squared",
        &["f_number"],
        |q, right| misread(q, right, |q| q[1] *= q[1]),
    ),
    slip(
        "circle_of_confusion",
        "centimetres",
        &["hundred", "100"],
        |q, right| changed(right(q), |p| p[0] *= 100.0),
    ),
    slip(
        "thin_lens_ray",
        "film mirrored",
        &["sign of plane.x", "film.x", "mirror"],
        |q, right| misread(q, right, |q| q[17] = 1.0 - q[17]),
    ),
    slip(
        "thin_lens_ray",
        "lens x and y exchanged",
        &["on_lens.x and on_lens.y"],
        |q, right| misread(q, right, |q| q.swap(19, 20)),
    ),
    slip(
        "thin_lens_ray",
        "right and up exchanged",
        &["exchanges right and up"],
        |q, right| misread(q, right, |q| (0..3).for_each(|i| q.swap(6 + i, 9 + i))),
    ),
    slip(
        "panorama_ray",
        "film exchanged",
        &["film.x and film.y"],
        |q, right| misread(q, right, |q| q.swap(12, 13)),
    ),
    slip("panorama_ray", "up turned", &["up"], |q, right| {
        misread(q, right, |q| q[9..12].iter_mut().for_each(|v| *v = -*v))
    }),
    slip(
        "geodesic_step",
        "half of the step",
        &["half of step"],
        |q, right| misread(q, right, |q| q[6] *= 0.5),
    ),
    slip(
        "geodesic_step",
        "goes backwards",
        &["sign of step", "sign of velocity", "turns velocity"],
        |q, right| misread(q, right, |q| q[6] = -q[6]),
    ),
    slip("deflection_angle", "twice", &["2 times"], |q, right| {
        changed(right(q), |a| {
            if a.len() > 1 {
                a[1] *= 2.0
            }
        })
    }),
    slip(
        "deflection_angle",
        "π too much",
        &["whole angle", "π"],
        |q, right| {
            changed(right(q), |a| {
                if a.len() > 1 {
                    a[1] += PI
                }
            })
        },
    ),
    slip(
        "needs_more",
        "the other way round",
        &["other way round", "opposite"],
        |q, right| changed(right(q), |a| a[0] = 1.0 - a[0]),
    ),
    slip(
        "spend_budget",
        "one more each",
        &[
            "1 too much",
            "one too much",
            "from 1",
            "more than the budget",
        ],
        |q, right| changed(right(q), |a| a[1..].iter_mut().for_each(|v| *v += 1.0)),
    ),
    slip(
        "pixel_average",
        "half the radius",
        &["half of radius", "the radius for the filter's whole width"],
        |q, right| misread(q, right, |q| q[0] *= 0.5),
    ),
    slip("pixel_average", "encodes", &["2.2", "sRGB"], |q, right| {
        changed(right(q), |c| {
            c.iter_mut().for_each(|v| *v = v.powf(1.0 / 2.2))
        })
    }),
    slip(
        "regular_grid",
        "x and y exchanged",
        &[
            "exchanges x and y",
            "column and row”: exchanges both numbers",
            "moves by the row along x, and by the column along y",
        ],
        |q, right| misread(q, right, |q| q.swap(0, 1)),
    ),
    slip("concentric_disk", "diameter 1", &["half"], |q, right| {
        changed(right(q), |p| p[1..].iter_mut().for_each(|v| *v *= 0.5))
    }),
    slip(
        "visible_fraction",
        "percent",
        &["100", "hundred"],
        |q, right| changed(right(q), |f| f[1..].iter_mut().for_each(|v| *v *= 100.0)),
    ),
    slip(
        "reflected_radiance",
        "divides by π",
        &["π"],
        |q, right| changed(right(q), |c| c.iter_mut().for_each(|v| *v /= PI)),
    ),
    slip(
        "reflected_radiance",
        "twice",
        &["twice the radiance", "2 times", "2.0"],
        |q, right| changed(right(q), |c| c.iter_mut().for_each(|v| *v *= 2.0)),
    ),
    slip("trace", "half of everything", &["half"], |q, right| {
        changed(right(q), |c| c.iter_mut().for_each(|v| *v *= 0.5))
    }),
    slip(
        "trace",
        "one surface too few",
        &["too early", "depth"],
        |q, right| misread(q, right, |q| q[0] = (q[0] - 1.0).max(0.0)),
    ),
    slip(
        "cosine_hemisphere",
        "uniform",
        &["equally likely"],
        |q, right| {
            // Any frame, and cos θ itself uniform.
            let list = right(q);
            let n = &q[..3];
            let mut made = vec![list[0]];
            for d in list[1..].chunks(3) {
                let c = dot(d, n);
                let side: Vec<_> = (0..3).map(|i| d[i] - c * n[i]).collect();
                let l = length(&side).max(1e-9);
                let h = c * c;
                made.extend((0..3).map(|i| h * n[i] + (1.0 - h * h).sqrt() * side[i] / l));
            }
            made
        },
    ),
    slip(
        "random_pattern",
        "crowds towards a corner",
        &["square", "root", "power"],
        |q, right| changed(right(q), |p| p[1..].iter_mut().for_each(|v| *v *= *v)),
    ),
];
