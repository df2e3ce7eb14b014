//! Chapters 9 and 10: two-level grids and octrees, in f64 and by other ways.

use crate::alternatives::grid::inside;
use crate::alternatives::student::{Alternative, Answer, Question, Ray};
use glam::DVec3;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "refine_cell",
        method: "cell by cell: which boxes overlap it, in f64",
        answer: refine_cell,
    },
    Alternative {
        exercise: "two_level_walk",
        method: "all cells that the ray is in, sorted by the middle of its stay, in f64",
        answer: |q| {
            let (ray, min, max) = (q.ray(), q.vector(), q.vector());
            let coarse = resolution(q);
            let cuts = q.list(resolution);
            let cells = cells_of(min, max, coarse).zip(cuts);
            let fine = cells.flat_map(|((low, high), cut)| cells_of(low, high, cut));
            visited(&ray, fine.enumerate())
        },
    },
    Alternative {
        exercise: "octree_child",
        method: "by the fraction of the cell, in f64",
        answer: |q| {
            let (min, max, p) = (q.vector(), q.vector(), q.vector());
            let upper = (2.0 * (p - min) / (max - min))
                .floor()
                .clamp(DVec3::ZERO, DVec3::ONE);
            Some(vec![upper.dot(DVec3::new(1.0, 2.0, 4.0))])
        },
    },
    Alternative {
        exercise: "octree_build",
        method: "level by level, in f64",
        answer: octree_build,
    },
    Alternative {
        exercise: "octree_walk",
        method: "all leaves that the ray is in, sorted by the middle of its stay, in f64",
        answer: |q| {
            let (ray, min, max) = (q.ray(), q.vector(), q.vector());
            let nodes = q.list(|q| [q.whole(), q.whole(), q.whole()]);
            let (mut leaves, mut to_do) = (Vec::new(), vec![(0, (min, max))]);
            while let Some((node, cell)) = to_do.pop() {
                match nodes[node] {
                    [0, _, 0] => {}
                    [0, ..] => leaves.push((node, cell)),
                    [_, first, _] => to_do.extend((0..8).map(|i| (first + i, child(cell, i)))),
                }
            }
            visited(&ray, leaves.into_iter())
        },
    },
];

type Cell = (DVec3, DVec3);

fn resolution(q: &mut Question) -> [usize; 3] {
    [q.whole(), q.whole(), q.whole()]
}

/// All cells of a box, along x first.
fn cells_of(min: DVec3, max: DVec3, along: [usize; 3]) -> impl Iterator<Item = Cell> {
    let [nx, ny, nz] = along;
    let size = (max - min) / DVec3::new(nx as f64, ny as f64, nz as f64);
    (0..nx * ny * nz).map(move |i| {
        let cell = DVec3::new((i % nx) as f64, (i / nx % ny) as f64, (i / nx / ny) as f64);
        (min + cell * size, min + (cell + 1.0) * size)
    })
}

/// The numbers of the cells in which the ray stays for a while, in order.
fn visited(ray: &Ray, cells: impl Iterator<Item = (usize, Cell)>) -> Answer {
    let mut stays: Vec<_> = cells
        .filter_map(|(i, (low, high))| {
            let (enter, leave) = inside(ray, low, high)?;
            (leave - enter > 1e-9).then_some((enter + leave, i))
        })
        .collect();
    stays.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut numbers = vec![stays.len() as f64];
    numbers.extend(stays.iter().map(|&(_, i)| i as f64));
    Some(numbers)
}

fn boxes(q: &mut Question) -> Vec<Cell> {
    q.list(|q| (q.vector(), q.vector()))
}

fn overlap(a: &Cell, b: &Cell) -> bool {
    a.0.cmple(b.1).all() && b.0.cmple(a.1).all()
}

fn refine_cell(q: &mut Question) -> Answer {
    let (min, max, density) = (q.vector(), q.vector(), q.number());
    let shapes = boxes(q);
    if shapes.is_empty() {
        return Some(vec![0.0; 4]);
    }
    let (size, cells) = (max - min, density * shapes.len() as f64);
    let mut thick = [true; 3];
    let along = loop {
        let count = thick.iter().filter(|&&thick| thick).count() as i32;
        let volume: f64 = (0..3).filter(|&i| thick[i]).map(|i| size[i]).product();
        let per_metre = (cells / volume).powf(1.0 / f64::from(count));
        let thin = (0..3).find(|&i| thick[i] && size[i] * per_metre < 1.0);
        match thin {
            Some(axis) if count > 1 => thick[axis] = false,
            _ => break [0, 1, 2].map(|i| if thick[i] { size[i] * per_metre } else { 1.0 }),
        }
    };
    let along = along.map(|n| n.round().clamp(1.0, 255.0) as usize);
    let [nx, ny, _] = along;
    let mut entries = Vec::new();
    for (i, cell) in cells_of(min, max, along).enumerate() {
        for (shape, bounds) in shapes.iter().enumerate() {
            if overlap(bounds, &cell) {
                entries.push([i % nx, i / nx % ny, i / nx / ny, shape]);
            }
        }
    }
    let numbers = along.into_iter().chain([entries.len()]);
    let numbers = numbers.chain(entries.into_iter().flatten());
    Some(numbers.map(|n| n as f64).collect())
}

fn child(cell: Cell, i: usize) -> Cell {
    let (mut min, mut max) = cell;
    for axis in 0..3 {
        let middle = 0.5 * (cell.0[axis] + cell.1[axis]);
        if i >> axis & 1 == 1 {
            min[axis] = middle;
        } else {
            max[axis] = middle;
        }
    }
    (min, max)
}

fn octree_build(q: &mut Question) -> Answer {
    let root = (q.vector(), q.vector());
    let (opening, copies, depth) = (q.number(), q.number(), q.whole());
    let shapes = boxes(q);
    let (mut nodes, mut names) = (vec![[0; 3]], Vec::new());
    let mut level = vec![(0, root, (0..shapes.len()).collect::<Vec<_>>(), copies)];
    for at in 0..=depth {
        let mut next = Vec::new();
        for (node, cell, inside, copies) in std::mem::take(&mut level) {
            let parts = [0, 1, 2, 3, 4, 5, 6, 7].map(|i| {
                let cell = child(cell, i);
                let reaches = |&shape: &usize| overlap(&shapes[shape], &cell);
                inside.iter().copied().filter(reaches).collect::<Vec<_>>()
            });
            let after: usize = parts.iter().map(Vec::len).sum();
            let growth = after as f64 / inside.len() as f64;
            let pays = opening + 0.25 * (after as f64) < inside.len() as f64;
            if at == depth || !pays || growth > copies {
                nodes[node] = [0, names.len(), inside.len()];
                names.extend(inside);
                continue;
            }
            let first = nodes.len();
            nodes[node] = [1, first, 0];
            for (i, part) in parts.into_iter().enumerate() {
                nodes.push([0; 3]);
                next.push((first + i, child(cell, i), part, copies / growth.max(1.0)));
            }
        }
        level = next;
    }
    let numbers = [nodes.len()].into_iter().chain(nodes.into_iter().flatten());
    let numbers = numbers.chain([names.len()]).chain(names);
    Some(numbers.map(|n| n as f64).collect())
}
