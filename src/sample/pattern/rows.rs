//! Cells of equal area for any number of points, and places in them.
//!
//! ```
//! use raybook::sample::pattern::rows::rows;
//!
//! // Seven cells of equal area: as nearly square as they can be.
//! assert_eq!(rows(7).sum::<usize>(), 7);
//! assert_eq!(rows(9).collect::<Vec<_>>(), [3, 3, 3]);
//! ```

use glam::{Vec2, vec2};

/// The number of cells of each row: about √n rows with about √n cells each, n cells in all; for n = 5, rows of 2 and 3.
pub fn rows(n: usize) -> impl Iterator<Item = usize> {
    let rows = (n as f64).sqrt().round() as usize;
    (0..rows).map(move |row| (row + 1) * n / rows - row * n / rows)
}

/// n points in cells of equal area. `grid(columns, rows)` returns one point in each of columns × rows equal cells of the unit
/// square.
///
/// The height of a row is proportional to the number of its cells: a row of m cells is m/n high, and its cells are 1/m wide. So
/// every cell has the area 1/n, and the mean over the points is unbiased. Consecutive rows with equally many cells are one grid;
/// if n is a square, there is only one grid, of √n × √n cells.
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

/// The place (first + u·count)/n: [0, 1) is cut into n equal parts, and the place is the fraction u of the way through `count`
/// parts from part number `first` on.
///
/// By rounding, the place never leaves these parts, and never becomes 1.
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
