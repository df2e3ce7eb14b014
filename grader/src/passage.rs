//! Judging a ray's way through cells: by where the ray is, not by the order in which a program comes upon the cells.

use crate::{Flaw, Verdict};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};

/// What is wrong where [`passage`] complains.
pub const TWICE: Flaw = Flaw {
    complaint: "is visited twice",
    name: "visits the same cell twice",
    hint: "Does each step of your walk lead on, or may it stay where it is?",
};

/// What is wrong where [`passage`] complains.
pub const ASIDE: Flaw = Flaw {
    complaint: "the ray does not pass through",
    name: "visits cells through which the ray does not pass",
    hint: "Does the ray go through the cell within the interval? Is the cell's number that of its place in the list?",
};

/// What is wrong where [`passage`] complains.
pub const LATE: Flaw = Flaw {
    complaint: "comes too late",
    name: "visits the cells in another order than the ray",
    hint: "Which of two cells does the ray enter first, whatever its direction?",
};

/// What is wrong where [`passage`] complains.
pub const MISSING: Flaw = Flaw {
    complaint: "is missing: the ray is in it",
    name: "leaves out cells through which the ray passes",
    hint: "Which cell comes after the one before the gap, and what makes your walk step over it, or end?",
};

/// What is wrong where [`passage`] complains.
pub const NOTHING: Flaw = Flaw {
    complaint: "you visit no",
    name: "visits nothing",
    hint: "What makes your loop end before its first round?",
};

/// A cell may be taken for this much larger or smaller, as a part of the largest coordinate that matters.
const TOLERANCE: f64 = 1e-4;

/// The cells that a ray should visit, and those that it visited, by their places in `cells`; `what` is "leaf" or "cell".
///
/// Where the ray runs in the plane between two cells, or through an edge, either neighbour will do, or both; a cell that
/// it only touches may be visited or left out.
///
/// # Errors
/// Which cell is wrong, missing, repeated or out of order.
pub fn passage(
    what: &str,
    cells: &[Aabb],
    ray: &Ray,
    within: Interval,
    golden: &[u32],
    got: &[u32],
) -> Verdict {
    let way = Way::new(ray, within, cells);
    let number = |counted: usize| format!("you visit {counted}, the reference {}", golden.len());
    // `reached` is where the ray leaves the cells before, `surely` where it leaves those of them that it does not only touch.
    let (mut reached, mut surely) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    for (i, &cell) in got.iter().enumerate() {
        let Some(bounds) = cells.get(cell as usize) else {
            return Err(format!("there is no {what} {cell}"));
        };
        if got[..i].contains(&cell) {
            return Err(format!("{what} {cell} is visited twice"));
        }
        let Some((_, leaves)) = way.inside(bounds, way.tolerance) else {
            let number = number(got.len());
            return Err(format!(
                "the ray does not pass through {what} {cell} ({number})"
            ));
        };
        // Of neighbours, one is left where the other is entered.
        let well = way.inside(bounds, -way.tolerance);
        if leaves < reached || well.is_some_and(|(_, leaves)| leaves < surely) {
            return Err(format!(
                "{what} {cell} comes too late: the ray leaves it before it enters the {what} before it in your list"
            ));
        }
        let enters = |inside: Option<(f64, f64)>| inside.map_or(f64::NEG_INFINITY, |at| at.0);
        reached = reached.max(enters(way.inside(bounds, 0.0)));
        surely = surely.max(enters(well));
    }
    for &cell in golden {
        let bounds = cells.get(cell as usize);
        let Some((enters, leaves)) = bounds.and_then(|bounds| way.inside(bounds, -way.tolerance))
        else {
            continue;
        };
        let middle = 0.5 * (enters + leaves);
        let holds = |&got: &u32| {
            let inside = way.inside(&cells[got as usize], way.tolerance);
            inside.is_some_and(|(enters, leaves)| enters <= middle && middle <= leaves)
        };
        if !got.iter().any(holds) {
            let number = number(got.len());
            return Err(format!(
                "{what} {cell} is missing: the ray is in it from t = {enters:.3} to {leaves:.3} ({number})"
            ));
        }
    }
    // In a plane between cells, none is entered with a tolerance; but not all of them may be left out.
    if got.is_empty()
        && !golden.is_empty()
        && golden
            .iter()
            .filter_map(|&cell| cells.get(cell as usize))
            .any(|bounds| way.is_long(bounds))
    {
        return Err(format!(
            "you visit no {what}, the reference {}",
            golden.len()
        ));
    }
    Ok(())
}

/// A ray in double precision.
struct Way {
    origin: [f64; 3],
    direction: [f64; 3],
    within: (f64, f64),
    tolerance: f64,
}

impl Way {
    fn new(ray: &Ray, within: Interval, cells: &[Aabb]) -> Self {
        let all = cells.iter().fold(Aabb::EMPTY, |all, cell| all.union(cell));
        let largest = all.min.abs().max(all.max.abs()).max(ray.origin.abs());
        Self {
            origin: ray.origin.to_array().map(f64::from),
            direction: ray.direction.to_array().map(f64::from),
            within: (f64::from(within.min), f64::from(within.max)),
            tolerance: TOLERANCE * f64::from(largest.max_element()),
        }
    }

    /// Where the ray is inside a box that is `grown` larger on each side.
    fn inside(&self, bounds: &Aabb, grown: f64) -> Option<(f64, f64)> {
        let (mut enters, mut leaves) = self.within;
        for axis in 0..3 {
            let (o, d) = (self.origin[axis], self.direction[axis]);
            let low = f64::from(bounds.min[axis]) - grown;
            let high = f64::from(bounds.max[axis]) + grown;
            if d == 0.0 {
                if o < low || o > high {
                    return None;
                }
            } else {
                let (a, b) = ((low - o) / d, (high - o) / d);
                enters = enters.max(a.min(b));
                leaves = leaves.min(a.max(b));
            }
        }
        (enters <= leaves).then_some((enters, leaves))
    }

    /// Whether the ray is in a box for a while.
    fn is_long(&self, bounds: &Aabb) -> bool {
        self.inside(bounds, 0.0)
            .is_some_and(|(enters, leaves)| leaves - enters > 4.0 * self.tolerance)
    }
}
