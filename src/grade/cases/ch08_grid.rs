//! Chapter 8: `grid_resolution`, `voxels_of_triangle`, `grid_walk`.

use crate::accel::grid::build;
use crate::accel::lattice::{Lattice, range};
use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::lab::palette::viridis;
use crate::math::aabb::Aabb;
use crate::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray, slab};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch08_grid::{
    Cell, GridResolution, GridResolutionQuestion, GridWalk, GridWalkQuestion, Visit,
    VoxelsOfTriangle, VoxelsOfTriangleQuestion,
};
use glam::{UVec3, Vec3, uvec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&GridResolution, &VoxelsOfTriangle, &GridWalk];

impl Graded for GridResolution {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "gives every axis the same number",
            hint: "Should a long side be cut into as many pieces as a short one?",
            answer: |q| whole(Vec3::splat(cells(q).cbrt()), f32::round),
        },
        Mistake {
            name: "forgets the density",
            hint: "How many cells should there be for each shape?",
            answer: |q| {
                GridResolution::answer(&GridResolutionQuestion {
                    density: 1.0,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "cuts the longest side into ∛(λN)",
            hint: "Multiply your three numbers: how many cells are that in all?",
            answer: |q| {
                let longest = q.extents.max_element().max(f32::MIN_POSITIVE);
                whole(q.extents / longest * cells(q).cbrt(), f32::round)
            },
        },
        Mistake {
            name: "rounds down",
            hint: "2.9 is nearer to 3 than to 2.",
            answer: |q| whole(share(q), f32::floor),
        },
        Mistake {
            name: "rounds up",
            hint: "2.1 is nearer to 2 than to 3.",
            answer: |q| whole(share(q), f32::ceil),
        },
        Mistake {
            name: "keeps a thin axis in the volume",
            hint: "A flat scene has hardly any volume: into how many cells do you cut its two long sides?",
            answer: |q| {
                let volume = q.extents.element_product().max(f32::MIN_POSITIVE);
                whole(q.extents * (cells(q) / volume).cbrt(), f32::round)
            },
        },
        Mistake {
            name: "gives a thin axis no cell",
            hint: "How many cells are there in all if one of your numbers is 0?",
            answer: |q| {
                let right = GridResolution::answer(q);
                let thin = |n: u32, extent: f32| if extent <= 0.0 { 0 } else { n };
                Cell {
                    x: thin(right.x, q.extents.x),
                    y: thin(right.y, q.extents.y),
                    z: thin(right.z, q.extents.z),
                }
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, extents, shapes, density| {
            Edge::new(
                name,
                GridResolutionQuestion {
                    extents,
                    shapes,
                    density,
                },
            )
        };
        vec![
            edge("a cube", Vec3::splat(2.0), 1000, 1.0),
            edge("a cube, eight cells a shape", Vec3::splat(0.5), 1000, 8.0),
            edge("a long hall", vec3(40.0, 10.0, 5.0), 3000, 4.0),
            edge("a flat square", vec3(10.0, 0.0, 10.0), 900, 4.0),
            edge("a thin terrain", vec3(10.0, 0.01, 20.0), 2000, 5.0),
            edge("a stick", vec3(0.0, 3.0, 0.0), 50, 2.0),
            edge("a thin stick", vec3(0.02, 3.0, 0.001), 50, 2.0),
            edge("one point", Vec3::ZERO, 10, 5.0),
            edge("one shape", vec3(1.0, 1.3, 0.7), 1, 5.0),
            edge("no shape", Vec3::ONE, 0, 5.0),
            edge("a grain", vec3(2e-4, 1e-4, 1.3e-4), 500, 5.0),
            edge("fewer cells than shapes", vec3(3.0, 2.0, 1.0), 5000, 0.1),
        ]
    }

    fn random(rng: &mut Pcg) -> GridResolutionQuestion {
        let mut extents = sample::point(rng, 6.0) + 6.5;
        if rng.random_bool(0.3) {
            let axis = rng.random_range(0..3_usize);
            extents[axis] *= sample::number(rng, 0.0001, 0.01);
        }
        GridResolutionQuestion {
            extents,
            shapes: rng.random_range(2..60_000),
            density: sample::number(rng, 0.5, 10.0),
        }
    }

    fn judge(q: &GridResolutionQuestion, golden: &Cell, got: &Cell) -> Verdict {
        for (axis, golden, got) in [
            ("x", golden.x, got.x),
            ("y", golden.y, got.y),
            ("z", golden.z, got.z),
        ] {
            if golden != got {
                return Err(format!(
                    "there are {got} cells along {axis}, and should be {golden}: {} cells of about one size in each direction",
                    cells(q)
                ));
            }
        }
        Ok(())
    }
}

/// λN.
fn cells(q: &GridResolutionQuestion) -> f32 {
    q.density * q.shapes as f32
}

/// At least 1 along each axis.
fn whole(along: Vec3, round: fn(f32) -> f32) -> Cell {
    along.map(round).max(Vec3::ONE).as_uvec3().into()
}

/// What is to be rounded: it is right up to the last step.
fn share(q: &GridResolutionQuestion) -> Vec3 {
    let mut thick = Vec3::from([0, 1, 2].map(|i| f32::from(u8::from(q.extents[i] > 0.0))));
    loop {
        let root = |x: f32| x.powf(1.0 / thick.element_sum());
        let volume: f32 = (0..3)
            .filter(|&i| thick[i] > 0.0)
            .map(|i| q.extents[i])
            .product();
        let along = q.extents * root(cells(q) / volume);
        match (0..3).find(|&i| thick[i] > 0.0 && along[i] < 1.0) {
            Some(i) => thick[i] = 0.0,
            None => return along * thick,
        }
    }
}

impl Graded for VoxelsOfTriangle {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes all cells of the bounding box",
            hint: "A large slanting triangle has a large bounding box: is it everywhere in it?",
            answer: |q| kept(q, |_, _| true),
        },
        Mistake {
            name: "takes only the cells that hold a corner",
            hint: "What if the triangle is larger than a cell?",
            answer: |q| {
                kept(q, |bounds, corners| {
                    corners.iter().any(|&p| bounds.grown(q.margin).contains(p))
                })
            },
        },
        Mistake {
            name: "takes all cells of the box that the plane cuts",
            hint: "The plane goes on beyond the triangle's edges: which directions can tell a box that lies past an edge?",
            answer: |q| {
                kept(q, |bounds, [p0, p1, p2]| {
                    let n = (p1 - p0).cross(p2 - p0);
                    let half = 0.5 * bounds.size() + q.margin;
                    n.dot(bounds.center() - p0).abs() <= n.abs().dot(half)
                })
            },
        },
        Mistake {
            name: "takes only cells whose centre is near the plane's",
            hint: "How far from its centre does a box reach along the triangle's normal: to a face, or to a corner?",
            answer: |q| {
                let all = VoxelsOfTriangle::answer(q);
                let n = (q.p1 - q.p0).cross(q.p2 - q.p0).normalize_or_zero();
                let near = |cell: &Cell| {
                    let center =
                        q.min + (vec3(cell.x as f32, cell.y as f32, cell.z as f32) + 0.5) * q.cell;
                    n.dot(center - q.p0).abs() <= 0.5 * q.cell.min_element()
                };
                all.into_iter().filter(near).collect()
            },
        },
        Mistake {
            name: "forgets the margin",
            hint: "A triangle just beyond a plane of the lattice: which cells does it belong to?",
            answer: |q| {
                VoxelsOfTriangle::answer(&VoxelsOfTriangleQuestion {
                    margin: 0.0,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "leaves out the last cell along each axis",
            hint: "The cell that holds the bounding box's greatest corner: is it in your loop?",
            answer: |q| {
                let all = VoxelsOfTriangle::answer(q);
                let last = all
                    .iter()
                    .fold(UVec3::ZERO, |last, c| last.max(uvec3(c.x, c.y, c.z)));
                all.into_iter()
                    .filter(|c| uvec3(c.x, c.y, c.z).cmplt(last).all())
                    .collect()
            },
        },
        Mistake {
            name: "takes the lattice to begin at the origin",
            hint: "Move the lattice and the triangle by one metre: the answer must not change.",
            answer: |q| {
                VoxelsOfTriangle::answer(&VoxelsOfTriangleQuestion {
                    min: Vec3::ZERO,
                    ..q.clone()
                })
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, [p0, p1, p2]: [Vec3; 3], margin| {
            Edge::new(
                name,
                VoxelsOfTriangleQuestion {
                    min: vec3(-2.0, 0.0, 1.0),
                    cell: vec3(1.0, 1.0, 1.0),
                    nx: 4,
                    ny: 4,
                    nz: 3,
                    margin,
                    p0,
                    p1,
                    p2,
                },
            )
        };
        let slanting = [
            vec3(-1.8, 0.2, 1.2),
            vec3(1.8, 0.4, 3.8),
            vec3(-0.3, 3.7, 2.4),
        ];
        let small = [
            vec3(0.2, 1.3, 2.4),
            vec3(0.6, 1.4, 2.5),
            vec3(0.3, 1.7, 2.6),
        ];
        let moved = |triangle: [Vec3; 3], by| triangle.map(|p: Vec3| p + by);
        vec![
            edge("in one cell", small, 0.0),
            edge("slanting through many", slanting, 0.0),
            edge(
                "flat in the middle of a layer",
                [
                    vec3(-1.7, 1.5, 1.3),
                    vec3(1.6, 1.5, 1.4),
                    vec3(-1.6, 1.5, 3.7),
                ],
                0.01,
            ),
            edge(
                "a needle",
                [
                    vec3(-1.9, 0.3, 1.4),
                    vec3(1.9, 3.6, 3.7),
                    vec3(1.9, 3.61, 3.7),
                ],
                0.0,
            ),
            edge(
                "a triangle without area",
                [
                    vec3(-1.5, 0.4, 1.6),
                    vec3(0.4, 2.3, 1.7),
                    vec3(1.35, 3.25, 1.75),
                ],
                0.0,
            ),
            edge("a point", [vec3(0.3, 2.6, 1.4); 3], 0.0),
            edge(
                "just before a plane, with a margin",
                moved(small, vec3(0.35, 0.0, 0.0)),
                0.1,
            ),
            edge(
                "just before a corner, with a margin",
                moved(small, vec3(0.37, 0.26, 0.36)),
                0.1,
            ),
            edge("half outside", moved(slanting, vec3(2.0, 1.5, 0.0)), 0.0),
            edge("all outside", moved(slanting, vec3(0.0, 6.0, 0.0)), 0.0),
            edge(
                "past the corner of a cell of its bounding box",
                [
                    vec3(-0.9, 0.1, 1.5),
                    vec3(0.9, 1.9, 1.5),
                    vec3(0.9, 1.9, 1.6),
                ],
                0.0,
            ),
            edge(
                "larger than the lattice",
                slanting.map(|p| 4.0 * p - vec3(0.0, 3.0, 6.0)),
                0.0,
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> VoxelsOfTriangleQuestion {
        let cell = vec3(1.0, 0.8, 1.1) * sample::number(rng, 0.5, 1.5);
        let min = sample::point(rng, 3.0);
        let n = uvec3(
            rng.random_range(2..6),
            rng.random_range(2..6),
            rng.random_range(2..5),
        );
        let extents = n.as_vec3() * cell;
        let center = min + 0.5 * extents;
        let half = 0.5 * sample::number(rng, 0.5, 1.1) * extents;
        let mut corner = || center + sample::point(rng, 1.0) * half;
        let (p0, p1, p2) = (corner(), corner(), corner());
        VoxelsOfTriangleQuestion {
            min,
            cell,
            nx: n.x,
            ny: n.y,
            nz: n.z,
            margin: sample::number(rng, 0.0, 0.15),
            p0,
            p1,
            p2,
        }
    }

    fn judge(q: &VoxelsOfTriangleQuestion, _golden: &Vec<Cell>, got: &Vec<Cell>) -> Verdict {
        // A cell that the triangle only touches is nobody's fault: these must be there, and only those may be.
        let hair = 1e-4 * (q.cell.max_element() + q.min.abs().max_element());
        let with = |margin| build::voxels_of_triangle(&q.lattice(), margin, &[q.p0, q.p1, q.p2]);
        let (must, may) = (with(q.margin - hair), with(q.margin + hair));
        let got: Vec<_> = got.iter().map(|c| uvec3(c.x, c.y, c.z)).collect();
        for (i, cell) in got.iter().enumerate() {
            if got[..i].contains(cell) {
                return Err(format!("cell {cell} is there twice"));
            }
            if cell.cmpge(q.lattice().resolution).any() {
                return Err(format!(
                    "cell {cell} is not in the lattice, whose last cell is {}",
                    q.lattice().resolution - 1
                ));
            }
            if !may.contains(cell) {
                return Err(format!(
                    "cell {cell} is one too many: the triangle does not reach it"
                ));
            }
        }
        match must.iter().find(|&cell| !got.contains(cell)) {
            Some(cell) => Err(format!(
                "cell {cell} is missing: the triangle reaches into it"
            )),
            None => Ok(()),
        }
    }
}

/// The cells of the triangle's bounding box, grown by the margin, that a test keeps.
fn kept(q: &VoxelsOfTriangleQuestion, keep: impl Fn(Aabb, [Vec3; 3]) -> bool) -> Vec<Cell> {
    let (lattice, corners) = (q.lattice(), [q.p0, q.p1, q.p2]);
    let bounds = Aabb::of(corners).grown(q.margin);
    let (first, last) = lattice.cells_of(&bounds);
    range(first, last)
        .filter(|&cell| keep(lattice.bounds_of(cell, cell), corners))
        .map(Cell::from)
        .collect()
}

impl Graded for GridWalk {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "skips the first cell",
            hint: "The ray begins inside a cell, or enters one: is it visited before the first step?",
            answer: |q| GridWalk::answer(q).into_iter().skip(1).collect(),
        },
        Mistake {
            name: "forgets the last cell",
            hint: "Count the cells of a lattice of one cell.",
            answer: |q| {
                let mut visits = GridWalk::answer(q);
                visits.pop();
                visits
            },
        },
        Mistake {
            name: "goes on beyond the interval's max",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| walked(q, Interval::new(q.within.min, f32::INFINITY)),
        },
        Mistake {
            name: "starts before the interval's min",
            hint: "Where does the interval begin, and in which cell is the ray there?",
            answer: |q| walked(q, Interval::new(0.0, q.within.max)),
        },
        Mistake {
            name: "looks at the plane behind when it goes backwards",
            hint: "A ray that goes left leaves its cell through the left face: which of the cell's two planes is that?",
            answer: |q| student(q, |_, i| i + 1, least),
        },
        Mistake {
            name: "crosses the farthest plane first",
            hint: "The ray leaves the cell through the face that it meets first.",
            answer: |q| {
                student(q, ahead, |next| {
                    (0..3)
                        .filter(|&i| next[i].is_finite())
                        .max_by(|&a, &b| next[a].total_cmp(&next[b]))
                        .unwrap_or(0)
                })
            },
        },
        Mistake {
            name: "loses its way where the ray does not move along an axis",
            hint: "What is the distance to a plane that the ray never meets, and is it the least of the three?",
            answer: |q| {
                let stays = (0..3).any(|axis| q.ray.direction[axis] == 0.0);
                let visits = GridWalk::answer(q);
                visits
                    .into_iter()
                    .take(if stays { 1 } else { usize::MAX })
                    .collect()
            },
        },
        Mistake {
            name: "says where the ray enters a cell, not where it leaves",
            hint: "The search may stop when the best hit lies before which end of the cell?",
            answer: |q| {
                let visits = GridWalk::answer(q);
                let enters: Vec<_> = std::iter::once(start(q))
                    .chain(visits.iter().map(|v| v.leave))
                    .collect();
                visits
                    .into_iter()
                    .zip(enters)
                    .map(|(v, leave)| Visit { leave, ..v })
                    .collect()
            },
        },
        Mistake {
            name: "steps along all axes at once",
            hint: "A ray leaves a cell through one face: which of the three numbers changes then?",
            answer: |q| {
                let visits = GridWalk::answer(q);
                visits.into_iter().step_by(2).collect()
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 54,
        alt: "How many cells of a lattice each ray passes through: the brighter, the more",
        question: |x, y| {
            let toward = vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.2);
            let turned = vec3(0.8 * toward.x - 0.6, toward.y - 0.45, -0.8 - 0.6 * toward.x);
            GridWalkQuestion {
                min: vec3(-1.0, -0.7, -1.0),
                cell: vec3(0.25, 0.28, 0.25),
                nx: 8,
                ny: 5,
                nz: 8,
                ray: Ray::new(vec3(2.2, 1.5, 2.8), Dir3::new_or(turned, Dir3::Z)),
                within: Interval::AHEAD,
            }
        },
        colour: |_, visits| {
            if visits.is_empty() {
                Rgb::gray(0.1)
            } else {
                viridis(visits.len() as f32 / 18.0)
            }
        },
    });

    fn edges() -> Vec<Edge<Self>> {
        let ahead = Interval::AHEAD;
        let beside = |y: u32, from: f32| {
            (0..4)
                .map(|x| Visit {
                    x,
                    y,
                    z: 0,
                    leave: from + (x + 1) as f32,
                })
                .collect()
        };
        let mut edges = vec![
            Edge::new("along x", question(vec3(-1.0, 1.5, 0.5), Vec3::X, ahead)),
            Edge::new(
                "along −x",
                question(vec3(5.0, 1.5, 0.5), Vec3::NEG_X, ahead),
            ),
            Edge::new(
                "along z, with negative zeros",
                question(vec3(2.5, 0.5, -1.0), vec3(-0.0, -0.0, 1.0), ahead),
            ),
            Edge::new(
                "askew",
                question(vec3(-0.7, 0.2, -0.3), vec3(3.0, 1.7, 1.1), ahead),
            ),
            Edge::new(
                "askew and back",
                question(vec3(4.9, 3.1, 2.3), vec3(-3.0, -1.9, -1.3), ahead),
            ),
            Edge::new(
                "from inside",
                question(vec3(1.3, 2.6, 0.4), vec3(2.0, -1.7, 0.3), ahead),
            ),
            Edge::new(
                "from a plane on",
                question(vec3(1.0, 1.5, 0.5), Vec3::X, ahead),
            ),
            Edge::new(
                "from a plane back",
                question(vec3(2.0, 1.5, 0.5), vec3(-1.0, 0.2, 0.1), ahead),
            ),
            Edge::new(
                "from the last face inwards",
                question(vec3(4.0, 1.2, 0.7), vec3(-1.0, 0.3, 0.1), ahead),
            ),
            Edge::new(
                "through edges",
                question(vec3(-1.0, -1.0, 0.5), vec3(1.0, 1.0, 0.0), ahead),
            ),
            Edge::new(
                "through corners",
                question(vec3(-1.0, -1.0, -1.0), Vec3::ONE, ahead),
            ),
            Edge::new(
                "in the plane between two layers",
                question(vec3(-1.0, 1.0, 0.5), Vec3::X, ahead),
            )
            .or(beside(0, 1.0)),
        ];
        edges.extend(edges_of_the_walk());
        edges
    }

    fn random(rng: &mut Pcg) -> GridWalkQuestion {
        let mut count = || rng.random_range(1..7_u32);
        let n = uvec3(count(), count(), count());
        let cell = vec3(1.0, 0.7, 1.2) * sample::number(rng, 0.4, 1.5);
        let min = sample::point(rng, 3.0);
        let (center, half) = (min + 0.5 * n.as_vec3() * cell, 0.5 * n.as_vec3() * cell);
        let origin = center + sample::point(rng, 1.8) * half;
        let aim = center + sample::point(rng, 0.9) * half;
        let ray = Ray::new(origin, Dir3::new_or(aim - origin, Dir3::X));
        let bounds = Aabb {
            min,
            max: min + 2.0 * half,
        };
        // From the middle of what is inside, or up to there.
        let inside = slab::clip(&bounds, &ray, Interval::AHEAD).unwrap_or(Interval::AHEAD);
        let middle = 0.5 * (inside.min + inside.max);
        let within = match rng.random_range(0..6) {
            0 => Interval::new(0.0, middle),
            1 | 2 => Interval::new(middle, f32::INFINITY),
            _ => Interval::AHEAD,
        };
        GridWalkQuestion {
            min,
            cell,
            nx: n.x,
            ny: n.y,
            nz: n.z,
            ray,
            within,
        }
    }

    fn judge(q: &GridWalkQuestion, golden: &Vec<Visit>, got: &Vec<Visit>) -> Verdict {
        let (right, yours) = (passed(q, golden), passed(q, got));
        for (i, golden) in right.iter().enumerate() {
            let cell = golden.cell();
            let Some(got) = yours.get(i) else {
                return Err(format!(
                    "your walk ends after {i} cells, and the ray goes on through cell {cell}"
                ));
            };
            if got.cell() != cell {
                return Err(format!(
                    "cell {} of your walk is {}, and the ray passes through {cell} there",
                    i + 1,
                    got.cell()
                ));
            }
            judge::number(
                &format!("the distance at which it leaves {cell}"),
                "m",
                golden.leave,
                got.leave,
            )?;
        }
        match yours.get(right.len()) {
            Some(more) => Err(format!(
                "your walk goes on to cell {}, but the ray is through after {} cells",
                more.cell(),
                right.len()
            )),
            None => Ok(()),
        }
    }
}

/// A question about 4 × 3 × 2 cells of a metre.
fn question(origin: Vec3, toward: Vec3, within: Interval) -> GridWalkQuestion {
    GridWalkQuestion {
        min: Vec3::ZERO,
        cell: Vec3::ONE,
        nx: 4,
        ny: 3,
        nz: 2,
        ray: Ray::new(origin, Dir3::new_or(toward, Dir3::Z)),
        within,
    }
}

/// Where it begins and ends, and whether there is one.
fn edges_of_the_walk() -> Vec<Edge<GridWalk>> {
    let ahead = Interval::AHEAD;
    let one = |q: GridWalkQuestion| GridWalkQuestion {
        nx: 1,
        ny: 1,
        nz: 1,
        ..q
    };
    vec![
        Edge::new(
            "the interval ends inside",
            question(
                vec3(-1.0, 1.5, 0.5),
                vec3(1.0, 0.1, 0.0),
                Interval::new(0.0, 3.3),
            ),
        ),
        Edge::new(
            "the interval begins inside",
            question(
                vec3(-1.0, 1.5, 0.5),
                vec3(1.0, 0.1, 0.0),
                Interval::new(2.7, f32::INFINITY),
            ),
        ),
        Edge::new(
            "the interval ends before it",
            question(vec3(-1.0, 1.5, 0.5), Vec3::X, Interval::new(0.0, 0.5)),
        ),
        Edge::new(
            "it is behind",
            question(vec3(-1.0, 1.5, 0.5), Vec3::NEG_X, ahead),
        ),
        Edge::new(
            "beside it, parallel",
            question(vec3(-1.0, 3.5, 0.5), Vec3::X, ahead),
        ),
        Edge::new(
            "a single cell",
            one(question(vec3(-1.0, 0.2, 0.3), vec3(1.0, 0.3, 0.1), ahead)),
        ),
        Edge::new(
            "from far away",
            question(
                vec3(-300.0, 200.0, 100.0),
                vec3(302.1, -198.4, -99.1),
                ahead,
            ),
        ),
    ]
}

/// The visits without those of cells that the ray only touches, as in an edge or a corner: in which order these come,
/// and whether they do, is left to rounding.
fn passed(q: &GridWalkQuestion, visits: &[Visit]) -> Vec<Visit> {
    let touch = 1e-3 * q.cell.min_element();
    let mut enter = start(q);
    let mut passed = Vec::new();
    for visit in visits {
        let touched = visit.leave - enter <= touch;
        enter = visit.leave;
        if !touched {
            passed.push(visit.clone());
        }
    }
    passed
}

/// Where the ray enters the lattice, or the interval begins.
fn start(q: &GridWalkQuestion) -> f32 {
    slab::clip(&q.lattice().bounds(), &q.ray, q.within).map_or(q.within.min, |inside| inside.min)
}

fn walked(q: &GridWalkQuestion, within: Interval) -> Vec<Visit> {
    GridWalk::answer(&GridWalkQuestion {
        within,
        ..q.clone()
    })
}

/// The number of the plane that the ray meets next, from that of its cell.
fn ahead(backward: bool, cell: i64) -> i64 {
    if backward { cell } else { cell + 1 }
}

fn least(next: [f32; 3]) -> usize {
    (0..3)
        .min_by(|&a, &b| next[a].total_cmp(&next[b]))
        .unwrap_or(0)
}

/// A walk with a plane and an axis of the student's choice.
fn student(
    q: &GridWalkQuestion,
    plane: fn(bool, i64) -> i64,
    choose: fn([f32; 3]) -> usize,
) -> Vec<Visit> {
    let lattice: Lattice = q.lattice();
    let Some(inside) = slab::clip(&lattice.bounds(), &q.ray, q.within) else {
        return Vec::new();
    };
    let mut cell = lattice.cell_at(q.ray.at(inside.min));
    let mut visits = Vec::new();
    for _ in 0..lattice.resolution.element_sum() {
        let next = [0, 1, 2].map(|axis| {
            let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
            let number = plane(d.is_sign_negative(), i64::from(cell[axis])) as f32;
            let t = (lattice.min[axis] + number * lattice.cell[axis] - o) / d;
            if t.is_nan() { f32::INFINITY } else { t }
        });
        let axis = choose(next);
        let leave = next[axis].min(q.within.max);
        let UVec3 { x, y, z } = cell;
        visits.push(Visit { x, y, z, leave });
        let forward = !q.ray.direction[axis].is_sign_negative();
        let last = if forward {
            lattice.resolution[axis] - 1
        } else {
            0
        };
        if leave >= q.within.max || cell[axis] == last {
            break;
        }
        cell[axis] = if forward {
            cell[axis] + 1
        } else {
            cell[axis] - 1
        };
    }
    visits
}
