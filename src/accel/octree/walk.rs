//! A ray's way through the leaves, front to back.

use crate::accel::Count;
use crate::accel::octree::tree::{Kind, Tree};
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use glam::Vec3;

/// More than the depth that [`Limits`](crate::accel::octree::build::Limits) allow.
const LEVELS: usize = 21;

/// A distance (b − o)·(1/d) has three roundings, of 2⁻²⁴ each. Two of them are compared, and a shape's own test sees the
/// ray a few roundings off too: a cell is left only when the ray is so much beyond it.
const SLACK: f32 = 16.0 * (f32::EPSILON / 2.0);

/// For each axis, the children (numbered as the ray meets them) on the near side of the middle plane, one bit each.
const NEAR: [u8; 3] = [0b0101_0101, 0b0011_0011, 0b0000_1111];

/// A ray on its way through a tree.
pub struct Walk<'a> {
    tree: &'a Tree,
    origin: Vec3,
    /// 1/d per axis; ±∞ where the ray does not move.
    inverse: Vec3,
    /// Bit i is set if the ray moves down along axis i. A child's number, with these bits flipped, counts as the ray goes:
    /// 0 in the half that it meets first, 1 in the other.
    mirror: u8,
    /// The node that is to be looked at next.
    next: Option<Visit>,
    /// The open nodes, each one a child of the one before.
    open: [Open; LEVELS],
    opened: usize,
}

/// A node that the ray enters, its cell, and the distances between which it is inside.
#[derive(Clone, Copy)]
struct Visit {
    node: u32,
    cell: Aabb,
    enters: f32,
    leaves: f32,
}

/// A node whose children are being visited.
#[derive(Clone, Copy)]
struct Open {
    children: u32,
    /// The children still to be visited, as the ray counts them, one bit each.
    waiting: u8,
    /// Per axis the lower face, the middle plane and the upper face.
    planes: [[f32; 3]; 3],
    /// Where the ray enters and leaves each child, as it counts them.
    enters: [f32; 8],
    leaves: [f32; 8],
}

impl<'a> Walk<'a> {
    /// Starts a ray's walk.
    pub fn new(tree: &'a Tree, ray: &Ray, within: Interval) -> Self {
        let inverse = ray.direction.recip();
        let mut walk = Self {
            tree,
            origin: ray.origin,
            inverse,
            // The sign bit, not d < 0: it makes −0.0 the mirror image of +0.0.
            mirror: ray.direction.is_negative_bitmask() as u8,
            next: None,
            open: [Open::NONE; LEVELS],
            opened: 0,
        };
        walk.next = walk.enter_root(within);
        walk
    }

    // ANCHOR: octree_walk
    /// The next leaf that is not empty and that the ray enters before `limit`; front to back.
    ///
    /// The children of a node are counted as the ray goes: 0 is the one before all three middle planes, 7 the one behind all.
    /// A ray crosses each plane once, so it is never in child 1 before child 0, nor in 3 before 1 or 2: for every ray the
    /// order of the numbers is an order from front to back, and nothing needs to be sorted.
    ///
    /// A child is entered where the ray has crossed all the planes that the child lies behind, and left where it crosses the
    /// first of those that the child lies in front of. If it is left before it is entered, the ray is never in it.
    pub fn next_leaf(&mut self, limit: f32, count: &mut impl Count) -> Option<u32> {
        loop {
            let Visit {
                node,
                cell,
                enters,
                leaves,
            } = match self.next.take() {
                Some(root) => root,
                None => self.next_child(limit)?,
            };
            count.tested_box();
            let (children, occupied) = match self.tree.nodes[node as usize].kind() {
                Kind::Leaf { .. } => return Some(node),
                Kind::Inner { children, occupied } => (children, occupied),
            };
            let center = cell.center();
            let t = self.distances(center);
            let (mut enters, mut leaves) = ([enters; 8], [leaves; 8]);
            for axis in 0..3 {
                let (behind, crossed) = (1 << axis, later(t[axis]));
                for i in 0..8 {
                    // 0·∞: the ray runs in this plane. The comparisons are false for the NaN, and it is in both halves.
                    if i & behind != 0 {
                        enters[i] = greater(enters[i], t[axis]);
                    } else {
                        leaves[i] = less(leaves[i], crossed);
                    }
                }
            }
            let entered = (0..8).fold(0, |bits, i| bits | u8::from(enters[i] <= leaves[i]) << i);
            let planes = [0, 1, 2].map(|axis| [cell.min[axis], center[axis], cell.max[axis]]);
            self.open[self.opened] = Open {
                children,
                waiting: entered & self.mirrored(occupied),
                planes,
                enters,
                leaves,
            };
            self.opened += 1;
        }
    }
    // ANCHOR_END: octree_walk

    /// The root, if the ray meets its cell.
    fn enter_root(&self, within: Interval) -> Option<Visit> {
        let Aabb { min, max } = self.tree.bounds;
        let (low, high) = (self.distances(min), self.distances(max));
        let (mut enters, mut leaves) = (within.min, later(within.max));
        for axis in 0..3 {
            let down = self.mirror >> axis & 1 != 0;
            let (near, far) = if down {
                (high[axis], low[axis])
            } else {
                (low[axis], high[axis])
            };
            // 0·∞: the ray runs in this face. The comparisons are false for the NaN, and the other face decides.
            enters = greater(enters, near);
            leaves = less(leaves, later(far));
        }
        (enters <= leaves).then_some(Visit {
            node: 0,
            cell: self.tree.bounds,
            enters,
            leaves,
        })
    }

    #[inline]
    /// The next child of the deepest open node that has one left.
    fn next_child(&mut self, limit: f32) -> Option<Visit> {
        while self.opened > 0 {
            let open = &mut self.open[self.opened - 1];
            if open.waiting == 0 {
                self.opened -= 1;
                continue;
            }
            let first = open.waiting.trailing_zeros() as usize;
            open.waiting &= open.waiting - 1;
            if open.enters[first] <= limit {
                let child = first ^ self.mirror as usize;
                let [x, y, z] = [0, 1, 2].map(|axis| {
                    let above = child >> axis & 1;
                    (open.planes[axis][above], open.planes[axis][above + 1])
                });
                return Some(Visit {
                    node: open.children + child as u32,
                    cell: Aabb {
                        min: Vec3::new(x.0, y.0, z.0),
                        max: Vec3::new(x.1, y.1, z.1),
                    },
                    enters: open.enters[first],
                    leaves: open.leaves[first],
                });
            }
        }
        None
    }

    /// The distances of the three planes x = p.x, y = p.y and z = p.z.
    fn distances(&self, p: Vec3) -> Vec3 {
        (p - self.origin) * self.inverse
    }

    /// Eight bits, one per child, in the order in which the ray counts the children.
    fn mirrored(&self, mut bits: u8) -> u8 {
        if self.mirror & 1 != 0 {
            bits = (bits & NEAR[0]) << 1 | (bits >> 1) & NEAR[0];
        }
        if self.mirror & 2 != 0 {
            bits = (bits & NEAR[1]) << 2 | (bits >> 2) & NEAR[1];
        }
        if self.mirror & 4 != 0 {
            bits = bits << 4 | bits >> 4;
        }
        bits
    }
}

impl Open {
    const NONE: Self = Self {
        children: 0,
        waiting: 0,
        planes: [[0.0; 3]; 3],
        enters: [0.0; 8],
        leaves: [0.0; 8],
    };
}

/// The distance a little later, by [`SLACK`] of its size.
fn later(t: f32) -> f32 {
    t * (1.0 + SLACK.copysign(t))
}

/// The greater of two; a if b is NaN.
fn greater(a: f32, b: f32) -> f32 {
    if b > a { b } else { a }
}

/// The less of two; a if b is NaN.
fn less(a: f32, b: f32) -> f32 {
    if b < a { b } else { a }
}
