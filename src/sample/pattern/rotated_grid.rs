//! The rotated grid: a square lattice turned by arctan ½, so that none of its rows is along an edge of the pixel.

use glam::{Vec2, vec2};

// ANCHOR: rotated_grid
/// The points ½ + spacing · R (i + offset.x, j + offset.y) of the unit square, i and j whole: a square lattice around its middle,
/// turned by arctan ½ = 26.565°.
///
/// R = (2 −1; 1 2)/√5. Few edges of a picture run along this lattice's rows, and many along the axes. Of four points in two
/// rows, a vertical edge passes two at once; of the rotated four it passes one by one, and shows five steps of grey instead
/// of three (in hardware: 3dfx, 2000).
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

/// Where the middle of the square can be: in the middle of four points, on a point, or between two.
///
/// The points come in fours, in ones and fours, and in twos.
const MIDDLES: [Vec2; 3] = [Vec2::splat(0.5), Vec2::ZERO, vec2(0.5, 0.0)];

/// The rotated grid of n points.
///
/// The lattice is magnified until n of its points are inside, those next to the square's edge as far from it as the next ones
/// outside. Four are then at eighths, 1, 3, 5 and 7, the pattern known from graphics hardware; five repeat seamlessly. Where
/// several points arrive at the edge at once and are too many, the last in the corners are left out. `grid` returns all points for
/// a spacing and an offset, in any order.
pub fn of(n: usize, grid: impl FnOnce(f32, Vec2) -> Vec<Vec2>) -> Vec<Vec2> {
    let fits = MIDDLES.iter().filter_map(|&offset| Fit::of(n, offset));
    let Some(best) = fits.min_by_key(|fit| fit.too_many) else {
        return Vec::new();
    };
    let mut points = grid(best.spacing, best.offset);
    // Of those equally far out, but for rounding, the same ones are left out in whatever order they come, and opposite ones together.
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

/// A lattice of which at least n points are inside.
struct Fit {
    spacing: f32,
    offset: Vec2,
    too_many: usize,
}

impl Fit {
    /// With the square's middle there; `None` for no points.
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
