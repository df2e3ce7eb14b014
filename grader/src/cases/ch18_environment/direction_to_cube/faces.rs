//! Places on the cube as students find them: on faces that are turned, mirrored or numbered otherwise, or by another axis.

use super::asks;
use crate::Graded;
use raybook::math::dir3::Dir3;
use raybook_workbook::exercises::ch18_environment::{CubePlace, DirectionToCube};

/// The right answer, changed on some faces.
pub(super) fn on(
    q: &DirectionToCube,
    faces: &[u32],
    change: fn(CubePlace) -> CubePlace,
) -> CubePlace {
    let right = DirectionToCube::right(q);
    if faces.contains(&right.face) {
        change(right)
    } else {
        right
    }
}

/// The place by the component along this axis, whether it is the largest or not.
pub(super) fn on_axis(q: &DirectionToCube, axis: usize) -> CubePlace {
    let d = *q.direction;
    let longer = 2.0 * d.abs().max_element();
    let mut toward = d;
    toward[axis] = longer.copysign(d[axis]);
    let near = DirectionToCube::right(&asks(Dir3::new_or(toward, q.direction)));
    let farther = |place: f32| 0.5 + (place - 0.5) * longer / d[axis].abs();
    CubePlace {
        face: near.face,
        u: farther(near.u),
        v: farther(near.v),
    }
}

/// The right face, with a place that is divided by the component along this axis.
pub(super) fn divided(q: &DirectionToCube, axis: usize) -> CubePlace {
    let (p, d) = (DirectionToCube::right(q), q.direction.abs());
    let by = if d[axis] > 0.0 { d[axis] } else { 1.0 };
    let farther = |place: f32| 0.5 + (place - 0.5) * d.max_element() / by;
    CubePlace {
        u: farther(p.u),
        v: farther(p.v),
        ..p
    }
}

/// The right place, with other numbers of the six faces.
pub(super) fn numbered(q: &DirectionToCube, faces: [u32; 6]) -> CubePlace {
    let p = DirectionToCube::right(q);
    let face = faces[p.face as usize];
    CubePlace { face, ..p }
}

/// Left and right exchanged.
pub(super) fn left_for_right(mut p: CubePlace) -> CubePlace {
    p.u = 1.0 - p.u;
    p
}

/// Top and bottom exchanged.
pub(super) fn top_for_bottom(mut p: CubePlace) -> CubePlace {
    p.v = 1.0 - p.v;
    p
}

/// A quarter turn of the face, seen from inside.
pub(super) fn clockwise(mut p: CubePlace) -> CubePlace {
    (p.u, p.v) = (1.0 - p.v, p.u);
    p
}

/// The same the other way round.
pub(super) fn counter_clockwise(mut p: CubePlace) -> CubePlace {
    (p.u, p.v) = (p.v, 1.0 - p.u);
    p
}
