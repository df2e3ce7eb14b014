//! `grid_walk`: random questions, judge and mistakes.

mod ends;
mod marching;
mod walks;

use crate::{Flaw, Graded, Mistake, Picture, Relation, Verdict, judge, sample};
use ends::{AT_ENTRY, AT_EXIT, at_an_end};
use glam::{UVec3, Vec3, uvec3, vec3};
use marching::{MARCHES, MARCHES_HINT, SHORT, less_than_a_step, looked_up, marched};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray, slab};
use raybook_chapters::kit::palette::viridis;
use raybook_workbook::exercises::ch08_grid::{GridWalk, Visit};
use walks::{
    ADDING, Adding, added, ahead, beyond, by_distance, by_layers, by_middles, in_front, in_lattice,
    nearest, numbered, stuck, student, walked, without_xy, without_xz, without_yz, x_again,
    z_before_y,
};

impl Graded for GridWalk {
    fn random(rng: &mut Pcg) -> GridWalk {
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
        GridWalk {
            min,
            cell,
            nx: n.x,
            ny: n.y,
            nz: n.z,
            ray,
            within,
        }
    }

    fn judge(q: &GridWalk, golden: &Vec<Visit>, got: &Vec<Visit>) -> Verdict {
        compared(q, golden, got).map_err(|why| {
            let short = less_than_a_step(q, golden, got);
            short.or_else(|| at_an_end(q, golden, got)).unwrap_or(why)
        })
    }

    /// Without the cells that the ray only touches, whatever distances are given.
    fn canonical(q: &GridWalk, mut visits: Vec<Visit>) -> Vec<Visit> {
        visits.retain(|visit| !is_only_touched(q, visit.cell()));
        visits
    }

    const POSITIVE: &'static [&'static str] = &["cell"];

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "your walk ends after",
            name: "ends the walk too early",
            hint: "When does your loop end: at the last cell, at the interval's end, or before?",
        },
        Flaw {
            complaint: "your walk goes on to",
            name: "goes on after the ray has left the grid, or after the interval's end",
            hint: "When does your loop end: at the last cell, at the interval's end, or after it?",
        },
        Flaw {
            complaint: "of your walk is",
            name: "walks through other cells than the ray",
            hint: "Draw three cells in a row: at which distance is the next plane along each axis, and which of the three comes first? Where does the first cell begin?",
        },
        Flaw {
            complaint: "is not in the lattice",
            name: "walks out of the lattice",
            hint: "What are the numbers of the first and the last cell along each axis, and what does your loop do beyond them?",
        },
        Flaw {
            complaint: "which is not in cell",
            name: "gives a cell and a distance at which the ray is not in that cell",
            hint: "Take the first cell of the first wrong case: between which two planes does it lie along each axis, and where is the ray when it enters?",
        },
        Flaw {
            complaint: "the distance at which it leaves",
            name: "gives wrong distances for the right cells",
            hint: "From where is t measured, and at which plane does the ray leave the cell?",
        },
        Flaw {
            complaint: AT_ENTRY,
            name: "looks for the cell at the distance at which the ray enters it: there the ray is in the plane between two cells, and rounding chooses one",
            hint: "Between which two distances is the ray in one cell, and where between them is it surely not in a plane?",
        },
        Flaw {
            complaint: AT_EXIT,
            name: "looks for the cell at the distance at which the ray leaves it: there the ray is in the plane between two cells, and rounding chooses one",
            hint: "Between which two distances is the ray in one cell, and where between them is it surely not in a plane?",
        },
        Flaw {
            complaint: SHORT,
            name: MARCHES,
            hint: MARCHES_HINT,
        },
    ];

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| GridWalk {
        ray: sample::moved(&q.ray),
        min: q.min + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "skips the first cell",
            hint: "The ray begins inside a cell, or enters one: is it visited before the first step?",
            answer: |q| {
                let visits = passed(q, &GridWalk::right(q));
                visits.into_iter().skip(1).collect()
            },
        },
        Mistake {
            name: "forgets the last cell",
            hint: "Count the cells of a lattice of one cell.",
            answer: |q| {
                let mut visits = passed(q, &GridWalk::right(q));
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
            name: "goes on to the last cell of the grid, also past the interval's max",
            hint: "The interval may end in the middle of the grid: in which cell, and when does your loop end?",
            answer: |q| beyond(q, f32::INFINITY),
        },
        Mistake {
            name: "ends the distances at the interval's max, but not the walk",
            hint: "In which cell does the interval end? No cell after this one belongs to the answer.",
            answer: |q| beyond(q, q.within.max),
        },
        Mistake {
            name: "starts before the interval's min",
            hint: "Where does the interval begin, and in which cell is the ray there?",
            answer: |q| walked(q, Interval::new(0.0, q.within.max)),
        },
        Mistake {
            name: "begins in the cell that is nearest to the ray's origin",
            hint: "The origin may lie outside the lattice: at which t does the ray enter, and which cell is there?",
            answer: |q| student(q, |_| 0.0, in_front, nearest),
        },
        Mistake {
            name: "begins in the cell where the interval begins, inside the lattice or not",
            hint: "Where the interval begins the ray may still be outside the lattice: at which t does it enter, and which cell is there?",
            answer: |q| student(q, |q| q.within.min, in_front, nearest),
        },
        Mistake {
            name: "looks at a cell's upper plane even where the ray goes backwards",
            hint: "A ray that goes left leaves its cell through the left face: which of the cell's two planes is that?",
            answer: |q| student(q, start, |_, i| i + 1, nearest),
        },
        Mistake {
            name: "crosses the farthest plane first",
            hint: "The ray leaves the cell through the face that it meets first.",
            answer: |q| {
                student(q, start, in_front, |next| {
                    by_distance(next).pop().into_iter().collect()
                })
            },
        },
        Mistake {
            name: "loses its way where the ray does not move along an axis",
            hint: "What is the distance to a plane that the ray never meets, and is it the least of the three?",
            answer: |q| {
                let stays = (0..3).any(|axis| q.ray.direction[axis] == 0.0);
                let visits = GridWalk::right(q);
                visits
                    .into_iter()
                    .take(if stays { 1 } else { usize::MAX })
                    .collect()
            },
        },
        Mistake {
            name: "steps along an axis along which the ray does not move",
            hint: "Where a direction is 0, your division gives ∞ or −∞: which plane does the ray meet next along this axis, and is its distance the least of the three?",
            answer: |q| {
                let in_front = |d, i| ahead(d <= 0.0, i);
                student(q, start, in_front, |next| {
                    let least = |a: &usize, b: &usize| next[*a].total_cmp(&next[*b]);
                    (0..3).min_by(least).into_iter().collect()
                })
            },
        },
        Mistake {
            name: "says where the ray enters a cell, not where it leaves",
            hint: "The search may stop when the best hit lies before which end of the cell?",
            answer: |q| {
                let visits = entered(q).into_iter();
                visits.map(|(v, leave)| Visit { leave, ..v }).collect()
            },
        },
        Mistake {
            name: "steps along two axes at once",
            hint: "A ray leaves a cell through one face: which of the three numbers changes then?",
            answer: |q| {
                student(q, start, in_front, |next| {
                    let mut axes = by_distance(next);
                    axes.truncate(2);
                    axes
                })
            },
        },
        Mistake {
            name: "skips every second cell",
            hint: "How often in a round of your loop does the cell change, and how often is it visited?",
            answer: |q| {
                let visits = GridWalk::right(q);
                visits.into_iter().step_by(2).collect()
            },
        },
        Mistake {
            name: "takes cells for cubes",
            hint: "A cell may be longer than it is wide: which of its extents do you use along each axis?",
            answer: |q| Self::misread(q, |q| (q.cell.y, q.cell.z) = (q.cell.x, q.cell.x)),
        },
        Mistake {
            name: "measures the distances from where the ray enters the grid",
            hint: "From where is t measured: from the ray's origin, or from the grid?",
            answer: |q| {
                let high = q.min + q.cell * vec3(q.nx as f32, q.ny as f32, q.nz as f32);
                let enters = |axis: usize| {
                    let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
                    let near = if d > 0.0 { q.min[axis] } else { high[axis] };
                    if d == 0.0 {
                        f32::NEG_INFINITY
                    } else {
                        (near - o) / d
                    }
                };
                let start = (0..3).map(enters).fold(q.within.min, f32::max);
                let visits = GridWalk::right(q).into_iter();
                visits
                    .map(|visit| Visit {
                        leave: visit.leave - start,
                        ..visit
                    })
                    .collect()
            },
        },
        Mistake {
            name: "counts the cells along y from the top",
            hint: "Which cell along y is number 0: the one at the least y, or the one at the greatest?",
            answer: |q| {
                GridWalk::right(q)
                    .into_iter()
                    .map(|visit| Visit {
                        y: (q.ny - 1).saturating_sub(visit.y),
                        ..visit
                    })
                    .collect()
            },
        },
        Mistake {
            name: "takes 1/d, not cell/d, for the way between two planes",
            hint: "How far is it along the ray from one plane to the next, if a cell is 0.7 m wide?",
            answer: |q| {
                let apart = |_, d: Vec3, axis: usize| (1.0 / d[axis]).abs();
                added(q, &Adding { apart, ..ADDING })
            },
        },
        Mistake {
            name: "takes a cell's extent along x for the way between two planes along every axis",
            hint: "How far is it along the ray from one plane to the next, along each axis? Which extent stands in each of the three lines?",
            answer: |q| {
                let apart = |cell: Vec3, d: Vec3, axis: usize| (cell.x / d[axis]).abs();
                added(q, &Adding { apart, ..ADDING })
            },
        },
        Mistake {
            name: "subtracts the way between two planes where the ray goes backwards",
            hint: "Along an axis with a negative direction, does t grow or fall from plane to plane? What is the sign of cell/d?",
            answer: |q| {
                let apart = |cell: Vec3, d: Vec3, axis: usize| cell[axis] / d[axis];
                added(q, &Adding { apart, ..ADDING })
            },
        },
        Mistake {
            name: "measures the first planes from where the ray enters the grid",
            hint: "From where is t measured: from the ray's origin, or from the place where the ray enters?",
            answer: |q| {
                let late = start;
                added(q, &Adding { late, ..ADDING })
            },
        },
        Mistake {
            name: "rounds to the nearest cell where the ray begins",
            hint: "A ray at 0.7 of a cell's width is in this cell: which one does your rounding give?",
            answer: |q| {
                let rounded = f32::round;
                added(q, &Adding { rounded, ..ADDING })
            },
        },
        Mistake {
            name: "rounds to the nearest cell where the ray begins, and leaves out what is behind it",
            hint: "A ray at 0.7 of a cell's width is in this cell: which one does your rounding give?",
            answer: |q| {
                let (rounded, is_clipped) = (f32::round, true);
                added(
                    q,
                    &Adding {
                        rounded,
                        is_clipped,
                        ..ADDING
                    },
                )
            },
        },
        Mistake {
            name: "measures the first planes from where the ray enters the grid, and leaves out what is behind it",
            hint: "From where is t measured: from the ray's origin, or from the place where the ray enters?",
            answer: |q| {
                let (late, is_clipped) = (start, true);
                added(
                    q,
                    &Adding {
                        late,
                        is_clipped,
                        ..ADDING
                    },
                )
            },
        },
        Mistake {
            name: "takes a cell's extent, not cell/d, for the way between two planes",
            hint: "How far is it along a slanting ray from one plane to the next, if the planes are 0.7 m apart?",
            answer: |q| {
                let apart = |cell: Vec3, _, axis: usize| cell[axis];
                added(q, &Adding { apart, ..ADDING })
            },
        },
        Mistake {
            name: "never goes on to the next cell along x",
            hint: "A plane is crossed: along its axis, which number of the cell changes, whichever of the three axes it is?",
            answer: |q| stuck(q, [false, true, true]),
        },
        Mistake {
            name: "never goes on to the next cell along y",
            hint: "A plane is crossed: along its axis, which number of the cell changes, whichever of the three axes it is?",
            answer: |q| stuck(q, [true, false, true]),
        },
        Mistake {
            name: "never goes on to the next cell along z",
            hint: "A plane is crossed: along its axis, which number of the cell changes, whichever of the three axes it is?",
            answer: |q| stuck(q, [true, true, false]),
        },
        Mistake {
            name: "says how long the ray stays in a cell, not where it leaves",
            hint: "From where is t measured: from the ray's origin, or from where the ray enters the cell?",
            answer: |q| {
                let mut enter = start(q);
                let visits = GridWalk::right(q).into_iter();
                visits
                    .map(|visit| {
                        let leave = visit.leave - enter;
                        enter = visit.leave;
                        Visit { leave, ..visit }
                    })
                    .collect()
            },
        },
        Mistake {
            name: "crosses the farthest plane first, as far as the lattice reaches",
            hint: "The ray leaves the cell through the face that it meets first: is the distance to it the least or the greatest of the three?",
            answer: |q| in_lattice(q, |next| by_distance(next).pop()),
        },
        Mistake {
            name: "lets the last cell end where the ray leaves it, behind the interval's max",
            hint: "The interval may end inside the last cell: can anything behind its end be hit?",
            answer: |q| {
                let mut visits = beyond(q, f32::INFINITY);
                visits.truncate(GridWalk::right(q).len());
                visits
            },
        },
        Mistake {
            name: "compares x with y and y with z, but never x with z",
            hint: "The next planes are at 3 along x, at 4 along y and at 2 along z: which axis do your conditions choose?",
            answer: |q| student(q, start, in_front, |next| vec![without_xz(next)]),
        },
        Mistake {
            name: "begins one cell behind the last one where the ray enters through a face at the far end of an axis",
            hint: "A ray enters through the last of a lattice's faces along x: which number does your division give, and which is that of the last cell?",
            answer: |q| {
                let high = q.lattice().bounds().max;
                let at = q.ray.at(start(q));
                let is_last = |axis: usize| (at[axis] - high[axis]).abs() <= touch(q);
                if start(q) > q.within.min && (0..3).any(is_last) {
                    Vec::new()
                } else {
                    GridWalk::right(q)
                }
            },
        },
        Mistake {
            name: "takes the lattice to begin at the origin where the number of the first cell is calculated",
            hint: "The lattice begins at x = 2, and its cells are 1 m wide: in which one is the ray at x = 3.5?",
            answer: |q| {
                let corner = |_: &GridWalk| Vec3::ZERO;
                added(q, &Adding { corner, ..ADDING })
            },
        },
        Mistake {
            name: "leaves out the cell in which the interval ends",
            hint: "The interval ends before the next plane: is the cell listed before your loop ends?",
            answer: |q| {
                let mut visits = GridWalk::right(q);
                visits.retain(|visit| visit.leave < q.within.max);
                visits
            },
        },
        Mistake {
            name: "adds the way to the next plane before it writes down the distance",
            hint: "Along the axis that is crossed: is your distance that of this plane, or of the one behind it?",
            answer: |q| {
                let is_late = true;
                added(q, &Adding { is_late, ..ADDING })
            },
        },
        Mistake {
            name: "compares x with y and x with z, but never y with z",
            hint: "The next planes are at 3 along x, at 1 along y and at 2 along z: which axis do your conditions choose?",
            answer: |q| student(q, start, in_front, |next| vec![without_yz(next)]),
        },
        Mistake {
            name: "compares x with y and x with z, but never y with z, as far as the lattice reaches",
            hint: "The next planes are at 3 along x, at 1 along y and at 2 along z: which axis do your conditions choose?",
            answer: |q| in_lattice(q, |next| Some(without_yz(next))),
        },
        Mistake {
            name: "takes z wherever it comes before y, also where x comes first",
            hint: "The next planes are at 1 along x, at 3 along y and at 2 along z: which axis do your conditions choose?",
            answer: |q| student(q, start, in_front, |next| vec![z_before_y(next)]),
        },
        Mistake {
            name: "takes z wherever it comes before y, also where x comes first, as far as the lattice reaches",
            hint: "The next planes are at 1 along x, at 3 along y and at 2 along z: which axis do your conditions choose?",
            answer: |q| in_lattice(q, |next| Some(z_before_y(next))),
        },
        Mistake {
            name: "compares y with x again, and never with z",
            hint: "The next planes are at 4 along x, at 3 along y and at 2 along z: which axis do your conditions choose?",
            answer: |q| student(q, start, in_front, |next| vec![x_again(next)]),
        },
        Mistake {
            name: "compares y with x again, and never with z, as far as the lattice reaches",
            hint: "The next planes are at 4 along x, at 3 along y and at 2 along z: which axis do your conditions choose?",
            answer: |q| in_lattice(q, |next| Some(x_again(next))),
        },
        Mistake {
            name: "compares x with z and y with z, but never x with y",
            hint: "The next planes are at 2 along x, at 1 along y and at 3 along z: which axis do your conditions choose?",
            answer: |q| student(q, start, in_front, |next| vec![without_xy(next)]),
        },
        Mistake {
            name: "compares x with z and y with z, but never x with y, as far as the lattice reaches",
            hint: "The next planes are at 2 along x, at 1 along y and at 3 along z: which axis do your conditions choose?",
            answer: |q| in_lattice(q, |next| Some(without_xy(next))),
        },
        Mistake {
            name: "compares x with y and y with z, but never x with z, as far as the lattice reaches",
            hint: "The next planes are at 3 along x, at 4 along y and at 2 along z: which axis do your conditions choose?",
            answer: |q| in_lattice(q, |next| Some(without_xz(next))),
        },
        Mistake {
            name: MARCHES,
            hint: MARCHES_HINT,
            answer: |q| marched(q, 0.02 * f64::from(q.cell.min_element())),
        },
        Mistake {
            name: "looks for the ray's cell in steps as long as the smallest extent of a cell, and misses cells in which the ray stays shorter",
            hint: "A ray may only cut off a cell's corner: how long does it stay there, and does any of your steps end there?",
            answer: |q| looked_up(q, f64::from(q.cell.min_element())),
        },
        Mistake {
            name: "looks for the ray's cell in steps half as long as the smallest extent of a cell, and misses cells in which the ray stays shorter",
            hint: "A ray may only cut off a cell's corner: how long does it stay there, and does any of your steps end there?",
            answer: |q| looked_up(q, 0.5 * f64::from(q.cell.min_element())),
        },
        Mistake {
            name: "looks for the ray's cell in steps a quarter as long as the smallest extent of a cell, and misses cells in which the ray stays shorter",
            hint: "A ray may only cut off a cell's corner: how long does it stay there, and does any of your steps end there?",
            answer: |q| looked_up(q, 0.25 * f64::from(q.cell.min_element())),
        },
        Mistake {
            name: "looks for the ray's cell in steps a tenth as long as the smallest extent of a cell, and misses cells in which the ray stays shorter",
            hint: "A ray may only cut off a cell's corner: how long does it stay there, and does any of your steps end there?",
            answer: |q| looked_up(q, 0.1 * f64::from(q.cell.min_element())),
        },
        Mistake {
            name: "looks for the ray's cell in steps of 0.1 m, and misses cells in which the ray stays shorter",
            hint: "A ray may only cut off a cell's corner: how long does it stay there, and does any of your steps end there?",
            answer: |q| looked_up(q, 0.1),
        },
        Mistake {
            name: "takes one cell in each layer along the axis on which the ray advances fastest, as lines of pixels are drawn",
            hint: "Between two planes across one axis: may the ray cross a plane of another axis, too?",
            answer: by_layers,
        },
        Mistake {
            name: "lists the cells by their numbers, x first, not in the order of the ray",
            hint: "A ray that goes left enters cell 3 before cell 2: in which order does your loop find them?",
            answer: |q| numbered(q, |visit| [visit.x, visit.y, visit.z]),
        },
        Mistake {
            name: "lists the cells by their numbers, z first, not in the order of the ray",
            hint: "A ray that goes left enters cell 3 before cell 2: in which order does your loop find them?",
            answer: |q| numbered(q, |visit| [visit.z, visit.y, visit.x]),
        },
        Mistake {
            name: "takes the lattice to begin at the origin where the number of any cell is calculated",
            hint: "The lattice begins at x = 2, and its cells are 1 m wide: in which one is the ray at x = 3.5?",
            answer: |q| by_middles(q, |q, middle| (middle / q.cell).floor()),
        },
        Mistake {
            name: "rounds to the nearest cell where the number of any cell is calculated",
            hint: "A ray at 0.7 of a cell's width is in this cell: which one does your rounding give?",
            answer: |q| by_middles(q, |q, middle| ((middle - q.min) / q.cell).round()),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "grid_walk",
        width: 96,
        height: 54,
        alt: "How many cells of a lattice each ray passes through: the brighter, the more",
        question: |x, y| {
            let toward = vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.2);
            let turned = vec3(0.8 * toward.x - 0.6, toward.y - 0.45, -0.8 - 0.6 * toward.x);
            GridWalk {
                min: vec3(-1.0, -0.7, -1.0),
                cell: vec3(0.25, 0.28, 0.25),
                nx: 8,
                ny: 5,
                nz: 8,
                ray: sample::ray(vec3(2.2, 1.5, 2.8), turned),
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
    }];
}

/// Whether a walk passes through the right cells, and leaves them where the ray does.
fn compared(q: &GridWalk, golden: &[Visit], got: &[Visit]) -> Verdict {
    got.iter().try_for_each(|visit| is_there(q, visit))?;
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
            "your walk goes on to cell {}, but there the ray is through already",
            more.cell()
        )),
        None => Ok(()),
    }
}

/// Whether the ray leaves a visited cell where it says, even a cell that the ray only touches.
fn is_there(q: &GridWalk, visit: &Visit) -> Verdict {
    let (cell, lattice) = (visit.cell(), q.lattice());
    if cell.cmpge(lattice.resolution).any() {
        return Err(format!(
            "cell {cell} is not in the lattice, whose last cell is {}",
            lattice.resolution - 1
        ));
    }
    let off = judge::RELATIVE * (visit.leave.abs().max(1.0) + q.cell.max_element());
    let at = q.ray.at(visit.leave);
    if lattice.bounds_of(cell, cell).grown(off).contains(at) {
        Ok(())
    } else {
        Err(format!(
            "at t = {} the ray is at {at}, which is not in cell {cell}",
            visit.leave
        ))
    }
}

/// A ray that is no longer than this in a cell only touches it.
fn touch(q: &GridWalk) -> f32 {
    1e-3 * q.cell.min_element()
}

/// Whether the ray meets a cell of the lattice within the interval, and only touches it.
fn is_only_touched(q: &GridWalk, cell: UVec3) -> bool {
    let lattice = q.lattice();
    if cell.cmpge(lattice.resolution).any() {
        return false;
    }
    let bounds = lattice.bounds_of(cell, cell).grown(0.1 * touch(q));
    let stay = slab::clip(&bounds, &q.ray, q.within);
    stay.is_some_and(|stay| stay.max - stay.min <= touch(q))
}

/// The visits without those of cells that the ray only touches, as in an edge or a corner: in which order these come,
/// and whether they do, is left to rounding.
fn passed(q: &GridWalk, visits: &[Visit]) -> Vec<Visit> {
    let mut enter = start(q);
    let mut passed = Vec::new();
    for visit in visits {
        let touched = visit.leave - enter <= touch(q);
        enter = visit.leave;
        if !touched {
            passed.push(visit.clone());
        }
    }
    passed
}

/// Where the ray enters the lattice, or the interval begins.
fn start(q: &GridWalk) -> f32 {
    slab::clip(&q.lattice().bounds(), &q.ray, q.within).map_or(q.within.min, |inside| inside.min)
}

/// The right visits, each with the distance at which the ray enters the cell.
fn entered(q: &GridWalk) -> Vec<(Visit, f32)> {
    let visits = GridWalk::right(q);
    let leaves = visits.iter().map(|visit| visit.leave);
    let enters: Vec<_> = std::iter::once(start(q)).chain(leaves).collect();
    visits.into_iter().zip(enters).collect()
}
