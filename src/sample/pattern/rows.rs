//! Cells of equal area for any number of points, and places in them.

use glam::{Vec2, vec2};

/// How many cells each of the rows has: about √n rows of about √n cells, n together; 5 are 2 and 3.
pub fn rows(n: usize) -> impl Iterator<Item = usize> {
    let rows = (n as f64).sqrt().round() as usize;
    (0..rows).map(move |row| (row + 1) * n / rows - row * n / rows)
}

/// n points, in cells of equal area: `grid` places one in each cell of columns × rows equal ones of the unit square.
///
/// A row is as high as it has cells: a row of m is m/n high and its cells are 1/m wide, so that every cell, of whichever row, has
/// the area 1/n, and the mean over the points has no bias. Rows alike that follow one another are one grid; if n is a
/// square, there is only one, of √n × √n cells.
pub fn in_rows(n: usize, mut grid: impl FnMut(usize, usize) -> Vec<Vec2>) -> Vec<Vec2> {
    let rows: Vec<_> = rows(n).collect();
    let mut above = 0;
    let mut points = Vec::with_capacity(n);
    for alike in rows.chunk_by(|one, next| one == next) {
        let cells = alike[0] * alike.len();
        let lowered = |p: Vec2| vec2(p.x, place(above, cells, p.y.into(), n));
        points.extend(grid(alike[0], alike.len()).into_iter().map(lowered));
        above += cells;
    }
    points
}

/// The place a fraction u of the way through `count` of n equal parts of [0, 1), from part number `first` on:
/// (first + u·count)/n.
///
/// Rounding never takes it out of these parts, least of all to 1.
pub fn place(first: usize, count: usize, u: f64, n: usize) -> f32 {
    let exact = (first as f64 + u * count as f64) / n as f64;
    let x = exact as f32;
    let part = (f64::from(x) * n as f64) as usize;
    if part < first {
        x.next_up()
    } else if part >= first + count {
        x.next_down()
    } else {
        x
    }
}
