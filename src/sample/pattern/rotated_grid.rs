//! The rotated grid: a square lattice turned by arctan ½, so that none of its rows is parallel to an edge of the pixel.
//!
//! ```
//! use raybook::sample::pattern::rotated_grid::rotated_grid;
//!
//! let points = rotated_grid(0.5, glam::Vec2::ZERO);
//! let mut heights: Vec<_> = points.iter().map(|p| p.y).collect();
//! heights.sort_by(f32::total_cmp);
//! assert!(heights.windows(2).all(|two| two[1] - two[0] > 0.1)); // no two points are in a row
//! ```

use glam::{Vec2, vec2};

// ANCHOR: rotated_grid
/// The points ½ + spacing · R (i + offset.x, j + offset.y) in the unit square, for all integers i and j: a square lattice, turned
/// around the square's middle by arctan ½ = 26.565°. `spacing` is above 0.
///
/// R = (2 −1; 1 2)/√5. Few edges of a picture are parallel to this lattice's rows, and many are parallel to the axes. A vertical
/// edge that moves over four points in two rows passes two points at once; it passes the rotated four one by one, and shows five
/// levels of grey instead of three (in hardware: 3dfx, 2000).
pub fn rotated_grid(spacing: f32, offset: Vec2) -> Vec<Vec2> {
    let reach = (0.5 * 2.0_f32.sqrt() / spacing).ceil() as i32 + 1;
    let lattice =
        (-reach..=reach).flat_map(|j| (-reach..=reach).map(move |i| vec2(i as f32, j as f32)));
    lattice
        .map(|q| 0.5 + spacing * turned(q + offset))
        .filter(|p| p.cmpge(Vec2::ZERO).all() && p.cmplt(Vec2::ONE).all())
        .collect()
}
// ANCHOR_END: rotated_grid

/// R q.
fn turned(q: Vec2) -> Vec2 {
    vec2(2.0 * q.x - q.y, q.x + 2.0 * q.y) / 5.0_f32.sqrt()
}

/// The possible places of the square's middle in the lattice: in the middle of four points, on a point, or between two points.
///
/// By symmetry, the number of points is then a multiple of 4, a multiple of 4 plus 1, or a multiple of 2.
const MIDDLES: [Vec2; 3] = [Vec2::splat(0.5), Vec2::ZERO, vec2(0.5, 0.0)];

/// The rotated grid of n points.
///
/// The spacing is chosen so that n points are inside, and that the outermost of them are as far from the square's edge as the
/// next points outside. With n = 4 the coordinates are 1, 3, 5 and 7 eighths, the pattern known from graphics hardware; n = 5
/// repeats seamlessly. If several points reach the edge at once, and are more than n, those farthest from the middle are left
/// out. `grid` returns all points for a spacing and an offset, in any order.
pub fn of(n: usize, grid: impl FnOnce(f32, Vec2) -> Vec<Vec2>) -> Vec<Vec2> {
    let fits = MIDDLES.iter().filter_map(|&offset| Fit::of(n, offset));
    let Some(best) = fits.min_by_key(|fit| fit.too_many) else {
        return Vec::new();
    };
    let mut points = grid(best.spacing, best.offset);
    // Of points equally far out, up to rounding, the same ones are left out whatever their order, and opposite points together.
    let coarse = |v: Vec2| ((1e4 * v.y).round() as i64, (1e4 * v.x).round() as i64);
    let out = |p: &Vec2| {
        let from_middle = *p - 0.5;
        let (one, opposite) = (coarse(from_middle), coarse(-from_middle));
        let far = (1e4 * from_middle.length_squared()).round() as i64;
        (far, one.max(opposite), one)
    };
    points.sort_by_key(out);
    points.truncate(n);
    points
}

/// A lattice with at least n points inside the square.
struct Fit {
    spacing: f32,
    offset: Vec2,
    too_many: usize,
}

impl Fit {
    /// The lattice with this offset; `None` for n = 0.
    fn of(n: usize, offset: Vec2) -> Option<Self> {
        let reach = (n as f32).sqrt() as i32 + 3;
        let lattice =
            (-reach..=reach).flat_map(|j| (-reach..=reach).map(move |i| vec2(i as f32, j as f32)));
        let mut outs: Vec<_> = lattice
            .map(|q| turned(q + offset).abs().max_element())
            .collect();
        outs.sort_by(f32::total_cmp);
        let last = *outs.get(n.checked_sub(1)?)?;
        // Points on one line are equally far out, up to rounding.
        let inside = outs.partition_point(|&out| out <= last + 1e-2);
        Some(Self {
            spacing: 1.0 / (last + outs.get(inside)?),
            offset,
            too_many: inside - n,
        })
    }
}
