//! `two_level_walk`: random questions, judge and mistakes.

mod walks;

use crate::{
    Flaw, Graded, Mistake, Relation, Verdict,
    passage::{self, passage},
    sample,
};
use glam::{UVec3, vec3};
use rand::RngExt;
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch09_two_level_grid::{Resolution, TwoLevelWalk};
use walks::{AtEmpty, Place, before_is, by_boxes, looked_up, marched, numbered};

/// The boxes of all fine cells, in the row of all.
pub(super) fn cells(q: &TwoLevelWalk) -> Vec<Aabb> {
    let levels = q.levels();
    let fine = levels.top.all().filter_map(|coarse| levels.fine(coarse));
    fine.flat_map(|(_, fine)| fine.all().map(move |cell| fine.bounds_of(cell, cell)))
        .collect()
}

/// The walk's cells grouped by the coarse cell in which they are: its first cell's place, and their places.
fn by_coarse_cell(q: &TwoLevelWalk) -> Vec<(u32, u32, Vec<u32>)> {
    let levels = q.levels();
    let mut groups: Vec<(u32, u32, Vec<u32>)> = Vec::new();
    for place in TwoLevelWalk::right(q) {
        let cut = levels
            .cuts
            .iter()
            .rfind(|cut| cut.first <= place && cut.resolution.x > 0);
        let (first, count) = cut.map_or((0, 0), |cut| {
            (cut.first, cut.resolution.as_uvec3().element_product())
        });
        match groups.last_mut() {
            Some((last, _, places)) if *last == first => places.push(place),
            _ => groups.push((first, count, vec![place])),
        }
    }
    groups
}

impl Graded for TwoLevelWalk {
    fn random(rng: &mut Pcg) -> TwoLevelWalk {
        let min = sample::point(rng, 3.0);
        let size = vec3(
            sample::number(rng, 2.0, 6.0),
            sample::number(rng, 2.0, 6.0),
            sample::number(rng, 2.0, 6.0),
        );
        let mut along = |least| rng.random_range(least..4_u32);
        let coarse = Resolution {
            nx: along(2),
            ny: along(1),
            nz: along(1),
        };
        let count = coarse.nx * coarse.ny * coarse.nz;
        let fine = (0..count)
            .map(|_| {
                let (nx, ny, nz) = (along(0), along(1), along(1));
                let some = u32::from(nx > 0);
                Resolution {
                    nx,
                    ny: ny * some,
                    nz: nz * some,
                }
            })
            .collect();
        let inside = min + size * (sample::point(rng, 0.35) + 0.5);
        let origin = if rng.random_bool(0.3) {
            min + size * (sample::point(rng, 0.5) + 0.5)
        } else {
            inside + size.max_element() * 1.5 * *sample::direction(rng)
        };
        let end = if rng.random_bool(0.3) {
            size.max_element()
        } else {
            f32::INFINITY
        };
        let ray = Ray::new(origin, Dir3::new_or(inside - origin, Dir3::X));
        // Half of the rays are followed from near the point inside, or no further.
        let at = ray.direction.dot(inside - origin).max(0.0);
        let within = match rng.random_range(0..4) {
            0 => Interval::new(at, f32::INFINITY),
            1 => Interval::new(0.0, at.max(0.1)),
            _ => Interval::new(0.0, end),
        };
        TwoLevelWalk {
            ray,
            within,
            min,
            max: min + size,
            coarse,
            fine,
        }
    }

    fn is_sound(q: &TwoLevelWalk) -> bool {
        sample::is_box(q.min, q.max)
    }

    fn judge(q: &TwoLevelWalk, golden: &Vec<u32>, got: &Vec<u32>) -> Verdict {
        passage("cell", &cells(q), &q.ray, q.within, golden, got)
    }

    const FLAWS: &'static [Flaw] = &[
        passage::TWICE,
        passage::ASIDE,
        passage::LATE,
        passage::MISSING,
        passage::NOTHING,
    ];

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| TwoLevelWalk {
        ray: sample::moved(&q.ray),
        min: q.min + sample::METRE,
        max: q.max + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "visits all fine cells of a coarse cell",
            hint: "Which fine cells does the ray pass through?",
            answer: |q| {
                let groups = by_coarse_cell(q).into_iter();
                groups
                    .flat_map(|(first, count, _)| first..first + count)
                    .collect()
            },
        },
        Mistake {
            name: "visits the fine cells in the order in which they are stored",
            hint: "A ray that runs towards −x meets the last cell of a row first.",
            answer: |q| {
                let groups = by_coarse_cell(q).into_iter();
                groups
                    .flat_map(|(_, _, mut places)| {
                        places.sort_unstable();
                        places
                    })
                    .collect()
            },
        },
        Mistake {
            name: "numbers the fine cells of each coarse cell from 0",
            hint: "All fine cells are in one row: where do those of this coarse cell begin?",
            answer: |q| {
                let groups = by_coarse_cell(q).into_iter();
                groups
                    .flat_map(|(first, _, places)| {
                        places.into_iter().map(move |place| place - first)
                    })
                    .collect()
            },
        },
        Mistake {
            name: "stops after the first coarse cell that is not empty",
            hint: "If there is no hit in it, where does the ray go on?",
            answer: |q| {
                by_coarse_cell(q)
                    .into_iter()
                    .next()
                    .map_or(Vec::new(), |group| group.2)
            },
        },
        Mistake {
            name: "visits the first fine cell of each coarse cell only",
            hint: "The inner walk takes more than one step: how many?",
            answer: |q| {
                by_coarse_cell(q)
                    .into_iter()
                    .map(|group| group.2[0])
                    .collect()
            },
        },
        Mistake {
            name: "goes on beyond the end of the interval",
            hint: "What is the interval's max for?",
            answer: |q| Self::misread(q, |q| q.within.max = f32::INFINITY),
        },
        Mistake {
            name: "takes the first coarse cell's resolution for all",
            hint: "Each coarse cell is cut in its own way: where is that stored?",
            answer: |q| {
                let first = q.fine.iter().find(|r| r.nx > 0).cloned();
                let same = |r: &Resolution| match &first {
                    Some(first) if r.nx > 0 => first.clone(),
                    _ => r.clone(),
                };
                Self::misread(q, |q| q.fine = q.fine.iter().map(same).collect())
            },
        },
        Mistake {
            name: "numbers the fine cells along z first",
            hint: "In each coarse cell the fine cells along x come first: by how much does the place grow with x, with y and with z?",
            answer: |q| numbered(q, |_, [x, y, z], [_, ny, nz]| z + nz * (y + ny * x)),
        },
        Mistake {
            name: "numbers the fine cells along y first",
            hint: "In each coarse cell the fine cells along x come first: by how much does the place grow with x, with y and with z?",
            answer: |q| numbered(q, |_, [x, y, z], [nx, ny, _]| y + ny * (x + nx * z)),
        },
        Mistake {
            name: "numbers the fine cells with the coarse grid's resolution",
            hint: "How many fine cells has this coarse cell along x, and how many along y?",
            answer: |q| numbered(q, |q, [x, y, z], _| x + q.coarse.nx * (y + q.coarse.ny * z)),
        },
        Mistake {
            name: "goes to the next row of fine cells by the number of rows, not by that of cells in a row",
            hint: "By how much does the place grow from a cell to the one above it along y: by the number of cells along x, or along y?",
            answer: |q| numbered(q, |_, [x, y, z], [_, ny, nz]| x + ny * (y + nz * z)),
        },
        Mistake {
            name: "goes to the next layer of fine cells by one row, not by all rows of a layer",
            hint: "How many fine cells lie in one layer of equal z?",
            answer: |q| numbered(q, |_, [x, y, z], [nx, _, _]| x + nx * (y + z)),
        },
        Mistake {
            name: "ignores the interval",
            hint: "Where does the interval begin, and where does it end?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.within = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
                })
            },
        },
        Mistake {
            name: "walks through a whole coarse cell, even where the interval begins or ends in it",
            hint: "The interval begins and ends within one coarse cell: which of its fine cells does the ray pass before, and which after?",
            answer: |q| {
                let met: Vec<_> = by_coarse_cell(q).into_iter().map(|group| group.0).collect();
                let mut all = q.clone();
                all.within = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
                let groups = by_coarse_cell(&all).into_iter();
                let groups = groups.filter(|(first, ..)| met.contains(first));
                groups.flat_map(|group| group.2).collect()
            },
        },
        Mistake {
            name: "leaves out the last cell",
            hint: "When does your loop end: before the last cell is listed, or after it?",
            answer: |q| {
                let mut cells = TwoLevelWalk::right(q);
                cells.pop();
                cells
            },
        },
        Mistake {
            name: "leaves out the first cell",
            hint: "Is the first cell listed before the first step, or after it?",
            answer: |q| TwoLevelWalk::right(q).into_iter().skip(1).collect(),
        },
        Mistake {
            name: "visits the cells from back to front",
            hint: "In which cell would the nearest hit be?",
            answer: |q| TwoLevelWalk::right(q).into_iter().rev().collect(),
        },
        Mistake {
            name: "begins behind the ray's origin",
            hint: "Can the ray enter a cell that lies behind its origin?",
            answer: |q| Self::misread(q, |q| q.within.min = f32::NEG_INFINITY),
        },
        Mistake {
            name: "counts an empty coarse cell as one fine cell",
            hint: "How many fine cells has an empty coarse cell, and what does that mean for the places of those after it?",
            answer: |q| {
                let before = |place: u32| {
                    let levels = q.levels();
                    levels
                        .cuts
                        .iter()
                        .take_while(|cut| cut.first <= place)
                        .filter(|cut| cut.resolution.x == 0)
                        .count() as u32
                };
                TwoLevelWalk::right(q)
                    .into_iter()
                    .map(|place| place + before(place))
                    .collect()
            },
        },
        Mistake {
            name: "stops at the first empty coarse cell",
            hint: "In an empty coarse cell there is nothing to visit: where does the ray go on?",
            answer: |q| looked_up(q, |how| how.at_empty = AtEmpty::Ends),
        },
        Mistake {
            name: "goes through the row of all coarse cells, and stops at the first empty one",
            hint: "In an empty coarse cell there is nothing to visit: what comes behind it in the row?",
            answer: |q| {
                let cuts = q.levels().cuts;
                let mut empty = cuts.iter().filter(|cut| cut.resolution.x == 0);
                let end = empty.next().map_or(u32::MAX, |cut| cut.first);
                let mut places = TwoLevelWalk::right(q);
                places.retain(|place| *place < end);
                places
            },
        },
        Mistake {
            name: "looks up the coarse cells with y and z exchanged",
            hint: "The coarse cells lie in a row along x first, then y, then z: by how much does the place grow with y, and with z?",
            answer: |q| {
                looked_up(q, |how| {
                    how.coarse = |[x, y, z], [nx, _, nz]| x + nx * (z + nz * y);
                })
            },
        },
        Mistake {
            name: "looks up the coarse cells along z first",
            hint: "The coarse cells lie in a row along x first, then y, then z: by how much does the place grow with x?",
            answer: |q| {
                looked_up(q, |how| {
                    how.coarse = |[x, y, z], [_, ny, nz]| z + nz * (y + ny * x);
                })
            },
        },
        Mistake {
            name: "goes to the next row of coarse cells by the number of rows, not by that of cells in a row",
            hint: "By how much does the place of a coarse cell grow with y: by the number of cells along x, or along y?",
            answer: |q| {
                looked_up(q, |how| {
                    how.coarse = |[x, y, z], [_, ny, nz]| x + ny * (y + nz * z);
                })
            },
        },
        Mistake {
            name: "returns the places of the coarse cells",
            hint: "Which cells hold the shapes that the ray has to be tested with: the coarse ones, or the fine ones?",
            answer: |q| {
                let levels = q.levels();
                let of = |place: u32| {
                    levels
                        .cuts
                        .iter()
                        .rposition(|cut| cut.first <= place && cut.resolution.x > 0)
                        .unwrap_or(0) as u32
                };
                TwoLevelWalk::right(q).into_iter().map(of).collect()
            },
        },
        Mistake {
            name: "numbers the fine cells along x first, then z",
            hint: "In each coarse cell the fine cells along x come first: by how much does the place grow with x, with y and with z?",
            answer: |q| numbered(q, |_, [x, y, z], [nx, _, nz]| x + nx * (z + nz * y)),
        },
        Mistake {
            name: "looks up the coarse cells along y first",
            hint: "The coarse cells lie in a row along x first, then y, then z: by how much does the place grow with y, and with z?",
            answer: |q| {
                looked_up(q, |how| {
                    how.coarse = |[x, y, z], [nx, ny, _]| y + ny * (x + nx * z);
                })
            },
        },
        Mistake {
            name: "takes every coarse cell before this one to have as many fine cells as this one",
            hint: "The coarse cells are cut in different ways: how many fine cells lie before those of this one?",
            answer: |q| {
                before_is(q, |cuts| {
                    let count = cuts.last().map_or(0, |of| of.element_product());
                    (cuts.len() as u32 - 1) * count
                })
            },
        },
        Mistake {
            name: "counts a coarse cell's own fine cells as if they came before it",
            hint: "The first coarse cell: how many fine cells lie before those of this one?",
            answer: |q| before_is(q, |cuts| cuts.iter().map(|cut| cut.element_product()).sum()),
        },
        Mistake {
            name: "counts one fine cell for every coarse cell before this one, empty or not",
            hint: "The coarse cells are cut in different ways: how many fine cells lie before those of this one?",
            answer: |q| before_is(q, |cuts| cuts.len() as u32 - 1),
        },
        Mistake {
            name: "counts one fine cell for every coarse cell before this one that is not empty",
            hint: "The coarse cells are cut in different ways: how many fine cells lie before those of this one?",
            answer: |q| {
                let is_cut = |cut: &&UVec3| cut.x > 0;
                before_is(q, |cuts| cuts.iter().filter(is_cut).count() as u32 - 1)
            },
        },
        Mistake {
            name: "takes the cells along z first, the coarse ones and the fine ones",
            hint: "Both lists begin with the cells along x, then y, then z: by how much does the place grow with x?",
            answer: |q| {
                looked_up(q, |how| {
                    let along_z: Place = |[x, y, z], [_, ny, nz]| z + nz * (y + ny * x);
                    (how.coarse, how.fine) = (along_z, along_z);
                })
            },
        },
        Mistake {
            name: "visits the coarse cells in the order in which they are stored",
            hint: "A ray that runs towards −x meets the last coarse cell of a row first.",
            answer: |q| {
                let mut groups = by_coarse_cell(q);
                groups.sort_by_key(|group| group.0);
                groups.into_iter().flat_map(|group| group.2).collect()
            },
        },
        Mistake {
            name: "sorts the fine cells by the distances of their middles from the ray's origin",
            hint: "A ray begins near the edge of a large cell: how far is it to the middle of this cell, and to that of a small one beside it?",
            answer: |q| {
                let cells = cells(q);
                let far = |place: &u32| cells[*place as usize].center().distance(q.ray.origin);
                let mut places = TwoLevelWalk::right(q);
                places.sort_by(|a, b| far(a).total_cmp(&far(b)));
                places
            },
        },
        Mistake {
            name: "visits an empty coarse cell as if it were one fine cell",
            hint: "How many fine cells has an empty coarse cell, and whose place in the row do you name for it?",
            answer: |q| looked_up(q, |how| how.at_empty = AtEmpty::Visits),
        },
        Mistake {
            name: "counts the fine cells of those coarse cells only that the ray has passed",
            hint: "The row holds the fine cells of all coarse cells: do those count that the ray passes by?",
            answer: |q| {
                let mut before = 0;
                let mut places = Vec::new();
                for (first, count, own) in by_coarse_cell(q) {
                    places.extend(own.into_iter().map(|place| place - first + before));
                    before += count;
                }
                places
            },
        },
        Mistake {
            name: "takes every coarse cell to have as many fine cells as the one with the most",
            hint: "The coarse cells are cut in different ways: how many fine cells lie before those of this one?",
            answer: |q| {
                let count = |cut: &Resolution| cut.nx * cut.ny * cut.nz;
                let most = q.fine.iter().map(count).max().unwrap_or(0);
                before_is(q, |cuts| (cuts.len() as u32 - 1) * most)
            },
        },
        Mistake {
            name: "lets a fine cell end one fine side behind the corner of its coarse cell, not behind its own corner",
            hint: "The third fine cell along x begins two sides behind its coarse cell: where does it end?",
            answer: |q| {
                by_boxes(q, |coarse, fine| Aabb {
                    max: coarse.min + fine.size(),
                    ..fine
                })
            },
        },
        Mistake {
            name: "lets every fine cell begin at the corner of its coarse cell",
            hint: "The third fine cell along x: how many sides behind the corner of its coarse cell does it begin?",
            answer: |q| {
                by_boxes(q, |coarse, fine| Aabb {
                    min: coarse.min,
                    ..fine
                })
            },
        },
        Mistake {
            name: "takes a fine cell to be as large as its coarse cell",
            hint: "A coarse cell is cut into four along x: how long is a fine one?",
            answer: |q| {
                by_boxes(q, |coarse, fine| Aabb {
                    max: fine.min + coarse.size(),
                    ..fine
                })
            },
        },
        Mistake {
            name: "goes along the ray in steps of half the smallest side of a cell, from the middle of the first step, and misses cells in which the ray stays shorter",
            hint: "Between two of your steps the ray crosses a plane between cells: at which distance, and might it cross a second one? Can you calculate these distances, instead of trying?",
            answer: |q| marched(q, |least| 0.5 * least, 0.5),
        },
        Mistake {
            name: "goes along the ray in steps of half the smallest side of a cell, and misses cells in which the ray stays shorter",
            hint: "Between two of your steps the ray crosses a plane between cells: at which distance, and might it cross a second one? Can you calculate these distances, instead of trying?",
            answer: |q| marched(q, |least| 0.5 * least, 0.0),
        },
        Mistake {
            name: "goes along the ray in steps of the smallest side of a cell, from the middle of the first step, and misses cells in which the ray stays shorter",
            hint: "Between two of your steps the ray crosses a plane between cells: at which distance, and might it cross a second one? Can you calculate these distances, instead of trying?",
            answer: |q| marched(q, |least| least, 0.5),
        },
        Mistake {
            name: "goes along the ray in steps of the smallest side of a cell, and misses cells in which the ray stays shorter",
            hint: "Between two of your steps the ray crosses a plane between cells: at which distance, and might it cross a second one? Can you calculate these distances, instead of trying?",
            answer: |q| marched(q, |least| least, 0.0),
        },
        Mistake {
            name: "goes along the ray in steps of a quarter of the smallest side of a cell, from the middle of the first step, and misses cells in which the ray stays shorter",
            hint: "Between two of your steps the ray crosses a plane between cells: at which distance, and might it cross a second one? Can you calculate these distances, instead of trying?",
            answer: |q| marched(q, |least| 0.25 * least, 0.5),
        },
        Mistake {
            name: "goes along the ray in steps of half a metre, and misses cells in which the ray stays shorter",
            hint: "Between two of your steps the ray crosses a plane between cells: at which distance, and might it cross a second one? Can you calculate these distances, instead of trying?",
            answer: |q| marched(q, |_| 0.5, 0.0),
        },
        Mistake {
            name: "goes along the ray in steps of a tenth of a metre, and misses cells in which the ray stays shorter",
            hint: "Between two of your steps the ray crosses a plane between cells: at which distance, and might it cross a second one? Can you calculate these distances, instead of trying?",
            answer: |q| marched(q, |_| 0.1, 0.0),
        },
    ];
}
