//! `octree_child`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Relation, Verdict, sample};
use glam::{Vec3, vec3};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch10_octree::OctreeChild;

impl Graded for OctreeChild {
    fn random(rng: &mut Pcg) -> OctreeChild {
        let min = sample::point(rng, 4.0);
        // No cube, so that no side stands for another.
        let size = vec3(
            sample::number(rng, 0.5, 4.0),
            sample::number(rng, 0.5, 4.0),
            sample::number(rng, 0.5, 4.0),
        );
        let inside = sample::point(rng, 0.5) + 0.5;
        OctreeChild {
            min,
            max: min + size,
            p: min + inside * size,
        }
    }

    fn is_sound(q: &OctreeChild) -> bool {
        sample::is_box(q.min, q.max) && q.p.clamp(q.min, q.max) == q.p
    }

    fn judge(_q: &OctreeChild, golden: &u32, got: &u32) -> Verdict {
        if golden == got {
            return Ok(());
        }
        if *got > 7 {
            return Err(format!(
                "there are eight children, 0 to 7, and no child {got}"
            ));
        }
        let half = |n: u32, axis: u32| if n >> axis & 1 == 1 { "upper" } else { "lower" };
        let wrong = (0..3)
            .zip(["x", "y", "z"])
            .find(|&(axis, _)| half(*golden, axis) != half(*got, axis));
        let (axis, name) = wrong.unwrap_or((0, "x"));
        Err(format!(
            "child {got} is in the {} half along {name}, and the point is in the {}",
            half(*got, axis),
            half(*golden, axis)
        ))
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| OctreeChild {
        min: q.min + sample::METRE,
        max: q.max + sample::METRE,
        p: q.p + sample::METRE,
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "counts x as the highest bit",
            hint: "Move the point along x from one half to the other: by how much does the number change?",
            answer: |q| {
                let n = OctreeChild::right(q);
                (n & 1) << 2 | n & 2 | n >> 2
            },
        },
        Mistake {
            name: "swaps y and z",
            hint: "Which of the three coordinates is worth 4?",
            answer: |q| {
                let n = OctreeChild::right(q);
                n & 1 | (n & 2) << 1 | (n & 4) >> 1
            },
        },
        Mistake {
            name: "counts the upper half as 0",
            hint: "Which child has the number 0: the one at the least corner or at the greatest?",
            answer: |q| 7 - OctreeChild::right(q),
        },
        Mistake {
            name: "puts a point on a middle plane into the lower half",
            hint: "The middle plane belongs to one of the two halves: to which?",
            answer: |q| bits(q.p.cmpgt(0.5 * (q.min + q.max))),
        },
        Mistake {
            name: "compares with half the size of the cell",
            hint: "Where is the middle of a cell that begins at x = 10 and is 2 wide?",
            answer: |q| bits(q.p.cmpge(0.5 * (q.max - q.min))),
        },
        Mistake {
            name: "compares with 0",
            hint: "Is the middle of every cell at the origin?",
            answer: |q| bits(q.p.cmpge(Vec3::ZERO)),
        },
        Mistake {
            name: "looks at x and y only",
            hint: "A quad-tree has four children; how many has an octree?",
            answer: |q| OctreeChild::right(q) & 3,
        },
        Mistake {
            name: "counts the children from 1",
            hint: "Which is the smallest number of a child?",
            answer: |q| OctreeChild::right(q) + 1,
        },
        Mistake {
            name: "looks at x and z only",
            hint: "A quad-tree has four children; how many has an octree?",
            answer: |q| OctreeChild::right(q) & 5,
        },
        Mistake {
            name: "looks at y and z only",
            hint: "A quad-tree has four children; how many has an octree?",
            answer: |q| OctreeChild::right(q) & 6,
        },
        Mistake {
            name: "counts the lower half along x as 1",
            hint: "What does the bit of x say: upper, or lower?",
            answer: |q| OctreeChild::right(q) ^ 1,
        },
        Mistake {
            name: "counts the lower half along y as 1",
            hint: "What does the bit of y say: upper, or lower?",
            answer: |q| OctreeChild::right(q) ^ 2,
        },
        Mistake {
            name: "counts the lower half along z as 1",
            hint: "What does the bit of z say: upper, or lower?",
            answer: |q| OctreeChild::right(q) ^ 4,
        },
        Mistake {
            name: "looks at the next axis only if the point is in the lower half along those before (else if)",
            hint: "A point in the upper half along all three axes: how many of your conditions are asked?",
            answer: |q| {
                let n = OctreeChild::right(q);
                n & n.wrapping_neg()
            },
        },
        Mistake {
            name: "takes 1, 2 and 3 for the weights of x, y and z",
            hint: "How many children are there, and how many different sums do your three weights have?",
            answer: |q| {
                let n = OctreeChild::right(q);
                (n & 1) + (n & 2) + 3 * (n >> 2)
            },
        },
        Mistake {
            name: "puts a point on the middle plane of x into the lower half, and is right along the other axes",
            hint: "Your three comparisons should be alike: which of them differs, > or >=?",
            answer: |q| middle_is_below(q, 1),
        },
        Mistake {
            name: "puts a point on the middle plane of y into the lower half, and is right along the other axes",
            hint: "Your three comparisons should be alike: which of them differs, > or >=?",
            answer: |q| middle_is_below(q, 2),
        },
        Mistake {
            name: "puts a point on the middle plane of z into the lower half, and is right along the other axes",
            hint: "Your three comparisons should be alike: which of them differs, > or >=?",
            answer: |q| middle_is_below(q, 4),
        },
        Mistake {
            name: "takes the cell for a cube: half of its extent along x is half of the others too",
            hint: "A cell reaches from y = 0 to y = 4: at which y is its middle, if the cell is 2 long along x?",
            answer: |q| in_cube(q, (q.max - q.min).x),
        },
        Mistake {
            name: "swaps x and y",
            hint: "Which of the three coordinates is worth 1?",
            answer: |q| {
                let n = OctreeChild::right(q);
                (n & 1) << 1 | (n & 2) >> 1 | n & 4
            },
        },
        Mistake {
            name: "rounds the middle down to a whole number",
            hint: "A cell reaches from x = 0 to x = 1: where is its middle? What does your language make of 1/2?",
            answer: |q| bits(q.p.cmpge((0.5 * (q.min + q.max)).floor())),
        },
        Mistake {
            name: "takes min + max/2 for the middle, not half of the sum",
            hint: "A cell reaches from x = 10 to x = 12: is your middle 11? Which of the two is halved?",
            answer: |q| bits(q.p.cmpge(q.min + 0.5 * q.max)),
        },
        Mistake {
            name: "numbers the four quarters of a layer in a circle",
            hint: "Go round a layer from child 0: is the third one upper along x, along y, or along both?",
            answer: |q| {
                let n = OctreeChild::right(q);
                n ^ (n >> 1 & 1)
            },
        },
        Mistake {
            name: "adds 1 for each upper half, whichever axis it is of",
            hint: "How many children are there, and how many different sums do your numbers have?",
            answer: |q| OctreeChild::right(q).count_ones(),
        },
        Mistake {
            name: "compares x, y and z with the middle along x",
            hint: "Your three comparisons: which of the middle's coordinates stands in each?",
            answer: |q| bits(q.p.cmpge(Vec3::splat(0.5 * (q.min.x + q.max.x)))),
        },
        Mistake {
            name: "looks at the next axis only if the point is in the lower half along those before, z first (else if)",
            hint: "A point in the upper half along all three axes: how many of your conditions are asked?",
            answer: |q| {
                let n = OctreeChild::right(q);
                n.checked_ilog2().map_or(0, |highest| 1 << highest)
            },
        },
        Mistake {
            name: "takes the cell for a cube: half of its longest side is half of the others too",
            hint: "A cell reaches from y = 0 to y = 2: at which y is its middle, if the cell is 4 long along x?",
            answer: |q| in_cube(q, (q.max - q.min).max_element()),
        },
        Mistake {
            name: "takes the cell for a cube: half of its shortest side is half of the others too",
            hint: "A cell reaches from y = 0 to y = 4: at which y is its middle, if the cell is 2 long along x?",
            answer: |q| in_cube(q, (q.max - q.min).min_element()),
        },
        Mistake {
            name: "leaves out the brackets around the shifts: + binds more tightly than <<",
            hint: "How does your language read x + y << 1: is the sum shifted, or only y?",
            answer: |q| {
                let [x, y, z] = digits(q);
                (x + y) << (1 + z) << 2
            },
        },
        Mistake {
            name: "leaves out the brackets around the shifts, z first: + binds more tightly than <<",
            hint: "How does your language read z << 2 + y: by how much is z shifted?",
            answer: |q| {
                let [x, y, z] = digits(q);
                z << (2 + y) << (1 + x)
            },
        },
        Mistake {
            name: "leaves out the brackets around the shifts, one of 0 among them: + binds more tightly than <<",
            hint: "How does your language read x << 0 + y: by how much is x shifted?",
            answer: |q| {
                let [x, y, z] = digits(q);
                x << y << (1 + z) << 2
            },
        },
        Mistake {
            name: "leaves out the brackets around the conditional expressions: x counts only in the upper half along y, and z only in the lower half along y",
            hint: "How far does your `else`, or `:`, reach: to the end of the bracket, or to the next +?",
            answer: |q| {
                let [x, y, z] = digits(q);
                if y == 1 { x + 2 } else { 4 * z }
            },
        },
        Mistake {
            name: "takes ^ for the power of a number",
            hint: "What is 2 ^ 2 in your language: 4, or 0?",
            answer: |q| {
                let [x, y, _] = digits(q);
                2 * x + 3 * y
            },
        },
        Mistake {
            name: "counts the axes from 1: x is worth 2, y 4 and z 8",
            hint: "The greatest number of a child is 7: what is the sum of your three weights?",
            answer: |q| 2 * Self::right(q),
        },
        Mistake {
            name: "reads the three digits as a decimal number",
            hint: "What is 110 in the binary system, and what in the decimal system?",
            answer: |q| {
                let [x, y, z] = digits(q);
                x + 10 * y + 100 * z
            },
        },
        Mistake {
            name: "rounds twice the fraction of the cell down, and counts a point on the greatest face as a third half",
            hint: "A point on the greatest face: how much is twice its fraction of the cell, and how many halves are there?",
            answer: |q| {
                // On the greatest face twice the fraction is 2: once more than in the upper half.
                Self::right(q) + bits(q.p.cmpeq(q.max))
            },
        },
    ];
}

pub(super) fn bits(above: glam::BVec3) -> u32 {
    above.bitmask()
}

/// The child, if the cell were a cube with sides of this length.
fn in_cube(q: &OctreeChild, side: f32) -> u32 {
    bits(q.p.cmpge(q.min + 0.5 * side))
}

/// The child, where a point on the middle plane of the axis of this bit is in the lower half.
fn middle_is_below(q: &OctreeChild, bit: u32) -> u32 {
    let above = bits(q.p.cmpgt(0.5 * (q.min + q.max)));
    OctreeChild::right(q) & (above | !bit)
}

/// The binary digits of the right child's number, those of x, y and z.
fn digits(q: &OctreeChild) -> [u32; 3] {
    let n = OctreeChild::right(q);
    [n & 1, n >> 1 & 1, n >> 2]
}
