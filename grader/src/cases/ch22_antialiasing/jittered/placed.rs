//! Where points lie in their cells, and what is wrong with it: one to a cell, anywhere in it, and each by a random number of its own.

use crate::Verdict;
use crate::cases::ch22_antialiasing::points;
use crate::together::Bounds;
use crate::traits;
use glam::{Vec2, vec2};
use raybook_workbook::exercises::ch22_antialiasing::Jittered;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// A point that is printed with six digits is moved by 5e-7, which is 1e-5 of a cell, perhaps over the edge.
const EDGE: f32 = 2e-5;

/// Whether each cell has one point; one on an edge, in units of cells, may belong to either side.
pub(super) fn one_each(q: &Jittered, scaled: &[Vec2]) -> Verdict {
    let last = vec2(q.columns as f32, q.rows as f32) - 1.0;
    let number = |p: Vec2| {
        let cell = p.floor().clamp(Vec2::ZERO, last);
        (cell.y * (last.x + 1.0) + cell.x) as usize
    };
    let corners = [
        vec2(0.0, 0.0),
        vec2(-1.0, -1.0),
        vec2(1.0, -1.0),
        vec2(-1.0, 1.0),
        vec2(1.0, 1.0),
    ];
    let may_be_in: Vec<_> = scaled
        .iter()
        .map(|p| corners.map(|corner| number(*p + EDGE * corner)))
        .collect();
    let mut owners = vec![None; scaled.len()];
    for i in 0..scaled.len() {
        if !finds_cell(i, &may_be_in, &mut owners, &mut Vec::new()) {
            let crowded = may_be_in[i][0];
            let points = may_be_in.iter().filter(|cells| cells[0] == crowded).count();
            let columns = q.columns as usize;
            return Err(format!(
                "the cell in column {} and row {} has {points} points; each cell has one",
                crowded % columns,
                crowded / columns
            ));
        }
    }
    Ok(())
}

/// Finds a free cell for a point, if need be by moving others from theirs (augmenting paths; Kuhn 1955).
fn finds_cell(
    point: usize,
    may_be_in: &[[usize; 5]],
    owners: &mut [Option<usize>],
    tried: &mut Vec<usize>,
) -> bool {
    may_be_in[point].into_iter().any(|cell| {
        let free = owners[cell].is_none_or(|owner| {
            let is_new = !tried.contains(&cell);
            tried.push(cell);
            is_new && finds_cell(owner, may_be_in, owners, tried)
        });
        if free {
            owners[cell] = Some(point);
        }
        free
    })
}

/// Where the points lie in their cells, from 0 to 1 along each axis.
pub(super) fn places(q: &Jittered, points: &[Vec2]) -> Vec<Vec2> {
    let count = vec2(q.columns as f32, q.rows as f32);
    let place = |p: &Vec2| count * *p - (count * *p).floor().min(count - 1.0);
    points.iter().map(place).collect()
}

/// In which order cells are counted.
#[derive(Clone, Copy)]
pub(super) enum CellOrder {
    AlongRows,
    DownColumns,
}

/// The points in the order of their cells.
pub(super) fn by_cells(q: &Jittered, points: &[Vec2], order: CellOrder) -> Vec<Vec2> {
    let count = vec2(q.columns as f32, q.rows as f32);
    let cell = |p: &Vec2| {
        let [i, j] = (count * *p).floor().to_array().map(|v| v as u32);
        match order {
            CellOrder::AlongRows => (j, i),
            CellOrder::DownColumns => (i, j),
        }
    };
    let mut points = points.to_vec();
    points.sort_by_cached_key(cell);
    points
}

/// This number of cells tells what the distribution of places is.
pub(super) const MANY: f64 = 100.0;

/// How unevenly the points are shared among the columns of cells, and among the rows.
pub(super) fn unevenness(q: &Jittered, points: &[Vec2]) -> [f64; 2] {
    [0, 1].map(|axis| {
        let along = points.iter().map(|p| p[axis].into());
        traits::unevenness(along, [q.columns, q.rows][axis])
    })
}

pub(super) const LEFT_TO_RIGHT: &str = "the place from left to right in a cell";
pub(super) const TOP_TO_BOTTOM: &str = "the place from top to bottom in a cell";
pub(super) const BOTH: &str = "the places along x and y in a cell";
pub(super) const IN_ONE_CELL: [&str; 3] = [
    "the place from left to right in one cell",
    "the place from top to bottom in one cell",
    "one of both places in one cell",
];

/// Whether each cell has a number of its own for each coordinate, and not one that is drawn for a whole column or row of cells: four such cells are
/// all alike by chance with (2e-4)⁴ = 2e-15.
pub(super) fn drawn_for_each(q: &Jittered, got: &[Vec2], places: &[Vec2]) -> Verdict {
    const ALIKE: f32 = 1e-4;
    const LEAST: usize = 4;
    let count = vec2(q.columns as f32, q.rows as f32);
    for (line, name) in ["column", "row"].into_iter().enumerate() {
        for (axis, direction) in ["from left to right", "from top to bottom"]
            .into_iter()
            .enumerate()
        {
            let mut firsts: BTreeMap<u32, f32> = BTreeMap::new();
            let mut others = 0;
            let mut are_alike = true;
            for (p, place) in got.iter().zip(places) {
                let number = (count * *p)[line] as u32;
                match firsts.entry(number) {
                    Entry::Vacant(first) => drop(first.insert(place[axis])),
                    Entry::Occupied(first) => {
                        others += 1;
                        are_alike &= (first.get() - place[axis]).abs() < ALIKE;
                    }
                }
            }
            if are_alike && others >= LEAST {
                return Err(format!(
                    "{direction}, all points of a {name} of cells lie alike in their cells: each cell needs a random number of its own"
                ));
            }
        }
    }
    Ok(())
}

/// Whether places in cells are anywhere in them, as often as elsewhere.
pub(super) fn scattered(places: &[Vec2]) -> Verdict {
    let [x, y] = [0, 1].map(|axis| places.iter().map(move |p| p[axis]));
    points::uniform(LEFT_TO_RIGHT, x, Bounds::CHANCE)?;
    points::uniform(TOP_TO_BOTTOM, y, Bounds::CHANCE)?;
    points::independent(BOTH, places.iter().copied(), Bounds::CHANCE)
}

/// The rows and columns of cells at the square's edges, in words.
const AT_THE_EDGES: [[&str; 2]; 2] = [["first column", "last column"], ["first row", "last row"]];

/// Whether places are chosen in the rows and columns of cells at the square's edges as they are in the others, if they are anywhere in these. Eight
/// distributions are compared, each of which chance makes as uneven with 5e-11: 4e-10 in all. Nobody is in doubt by these: of eight, one often looks a little uneven.
pub(super) fn same_at_the_edges(answers: &[(Jittered, Vec<Vec2>)]) -> Verdict {
    let (mut inner, mut edges) = (Vec::new(), [const { [const { Vec::new() }; 2] }; 2]);
    for (q, got) in answers {
        let last = vec2(q.columns as f32, q.rows as f32) - 1.0;
        for (p, place) in got.iter().zip(places(q, got)) {
            let cell = ((last + 1.0) * *p).floor().min(last);
            let mut is_inner = true;
            for axis in [0, 1] {
                for (end, at) in [0.0, last[axis]].into_iter().enumerate() {
                    if cell[axis] == at {
                        edges[axis][end].push(place);
                        is_inner = false;
                    }
                }
            }
            if is_inner {
                inner.push(place);
            }
        }
    }
    let along = |places: &[Vec2], axis: usize| {
        let what = [LEFT_TO_RIGHT, TOP_TO_BOTTOM][axis];
        points::uniform(what, places.iter().map(|place| place[axis]), Bounds::CHANCE)
    };
    for axis in [0, 1] {
        if along(&inner, axis).is_err() {
            continue;
        }
        let ends = edges.iter().zip(AT_THE_EDGES);
        let ends = ends.flat_map(|(places, names)| places.iter().zip(names));
        for (places, name) in ends {
            if along(places, axis).is_err() {
                let sum: f32 = places.iter().map(|place| place[axis]).sum();
                return Err(format!(
                    "in the {name} of cells, {} is {:.2} on average: other places are chosen there than in the cells within",
                    [LEFT_TO_RIGHT, TOP_TO_BOTTOM][axis],
                    sum / places.len().max(1) as f32
                ));
            }
        }
    }
    Ok(())
}
