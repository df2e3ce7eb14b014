//! A ray's traversal of the leaves, front to back.

use crate::accel::Count;
use crate::accel::octree::build::Limits;
use crate::accel::octree::tree::{Kind, Tree};
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use arrayvec::ArrayVec;
use glam::{Vec3, Vec4};

/// k: a cell is left later than computed, as if its plane were k·u·(largest |b| of the tree + |o|) metres away, u = 2⁻²⁴, and the
/// next cell is entered as much earlier. A distance (b − o)·(1/d) has three roundings of u, and a shape's test has a few more.
const ROUNDINGS: f32 = 16.0;

/// For each axis, the four children in the lower half, one bit each.
const LOWER: [u8; 3] = [0b0101_0101, 0b0011_0011, 0b0000_1111];

/// A ray on its way through a tree.
#[derive(Clone, Debug)]
pub struct Walk<'a> {
    tree: &'a Tree,
    /// The ray's origin, moved forwards by the bound on rounding, so that a plane is met earlier.
    ahead: Vec3,
    /// The ray's origin, moved backwards by the same bound, so that a plane is met later.
    behind: Vec3,
    /// 1/d per axis; ±∞ where the ray does not move.
    inverse: Vec3,
    /// Bit i is set if the ray moves down along axis i. A child's number with these bits flipped is its number in the order of
    /// the ray: along each axis, 0 for the half that the ray meets first, 1 for the other.
    mirror: usize,
    /// The root, until it has been visited.
    root: Option<Visit>,
    /// The open nodes, from the root on; each is a child of the node before it.
    open: ArrayVec<Open, { Limits::DEEPEST as usize }>,
}

/// A node that the ray enters, and the distances at which the ray enters and leaves it.
#[derive(Clone, Copy, Debug)]
struct Visit {
    node: usize,
    enter: f32,
    leave: f32,
}

/// A node of which some children are still to be visited.
#[derive(Clone, Copy, Debug)]
struct Open {
    children: u32,
    /// The children still to be visited, in the order of the ray, one bit each.
    waiting: u8,
    /// Per axis the lower face, the middle plane and the upper face.
    planes: [[f32; 3]; 3],
    /// The distances at which the ray enters and leaves each child, in the order of the ray: of four children, and of the four
    /// behind the middle plane along z.
    enters: [[f32; 4]; 2],
    leaves: [[f32; 4]; 2],
}

impl Open {
    /// The cell of one of its children, by the number of the child's node.
    #[inline]
    fn cell_of(&self, node: usize) -> Aabb {
        let child = node - self.children as usize;
        let face = |above: usize| {
            let [x, y, z] = &self.planes;
            Vec3::new(
                x[(child & 1) + above],
                y[(child >> 1 & 1) + above],
                z[(child >> 2 & 1) + above],
            )
        };
        Aabb {
            min: face(0),
            max: face(1),
        }
    }
}

impl<'a> Walk<'a> {
    /// Starts the walk of a ray.
    pub fn new(tree: &'a Tree, ray: &Ray, within: Interval) -> Self {
        let sizes = ray.origin.abs() + tree.bounds.min.abs().max(tree.bounds.max.abs());
        let step = ROUNDINGS * 0.5 * f32::EPSILON * sizes + f32::MIN_POSITIVE;
        let step = step.copysign(*ray.direction);
        let mut walk = Self {
            tree,
            ahead: ray.origin + step,
            behind: ray.origin - step,
            inverse: ray.direction.recip(),
            // The sign bit, not d < 0: it makes −0.0 the mirror image of +0.0.
            mirror: ray.direction.is_negative_bitmask() as usize,
            root: None,
            open: ArrayVec::new(),
        };
        walk.root = walk.enter_root(within);
        walk
    }

    // ANCHOR: octree_walk
    /// The next leaf, front to back, that is not empty and that the ray enters before `limit`; `None` at the end.
    ///
    /// The children of a node are numbered in the order of the ray: child 0 is before all three middle planes, child 7 behind all
    /// three (mirrored as in Revelles, Ureña and Lastra 2000). A ray crosses each plane once, so it is never in child 1 before
    /// child 0, nor in child 3 before 1 or 2. So for every ray the numbers are an order from front to back, and nothing needs to
    /// be sorted. (A ray that runs in a plane is in the children on both sides; they are visited one after the other.)
    ///
    /// The ray enters a child where it has crossed all middle planes that the child is behind. The ray leaves the child where it
    /// crosses the first of the planes that the child is in front of. If it leaves before it enters, it is never in the child.
    pub fn next_leaf(&mut self, limit: f32, count: &mut impl Count) -> Option<u32> {
        loop {
            let Visit { node, enter, leave } = match self.root.take() {
                Some(root) => root,
                None => self.next_child(limit)?,
            };
            count.tested_box();
            let (children, occupied) = match self.tree.nodes[node].kind() {
                Kind::Leaf { .. } => return Some(node as u32),
                Kind::Inner { children, occupied } => (children, occupied),
            };
            let cell = self
                .open
                .last()
                .map_or(self.tree.bounds, |open| open.cell_of(node));
            let center = cell.center();
            // 0·∞: the ray runs in this plane. Comparisons with the NaN are false, so the ray is in both halves.
            let later = |t: f32| if t > enter { t } else { enter };
            let sooner = |t: f32| if t < leave { t } else { leave };
            // One by one, for `map` of an array may remain a function call. Children 0 to 3 are before the plane along z, children
            // 4 to 7 behind it.
            let planes = self.earlier(center);
            let (x, y, z) = (later(planes.x), later(planes.y), later(planes.z));
            let near = Vec4::new(enter, x, y, if x > y { x } else { y });
            let enters = [near, near.max(Vec4::splat(z))];
            let planes = self.later(center);
            let (x, y, z) = (sooner(planes.x), sooner(planes.y), sooner(planes.z));
            let far = Vec4::new(if x < y { x } else { y }, y, x, leave);
            let leaves = [far.min(Vec4::splat(z)), far];
            let met = |half: usize| enters[half].cmple(leaves[half]).bitmask() as u8;
            let waiting = (met(0) | met(1) << 4) & mirrored(occupied, self.mirror);
            let Aabb { min, max } = cell;
            self.open.push(Open {
                children,
                waiting,
                planes: [
                    [min.x, center.x, max.x],
                    [min.y, center.y, max.y],
                    [min.z, center.z, max.z],
                ],
                enters: [enters[0].to_array(), enters[1].to_array()],
                leaves: [leaves[0].to_array(), leaves[1].to_array()],
            });
        }
    }
    // ANCHOR_END: octree_walk

    /// The next child of the deepest open node that has a child left.
    #[inline]
    fn next_child(&mut self, limit: f32) -> Option<Visit> {
        while let Some(open) = self.open.last_mut() {
            if open.waiting == 0 {
                self.open.pop();
                continue;
            }
            let next = open.waiting.trailing_zeros() as usize;
            open.waiting &= open.waiting - 1;
            let enter = open.enters[next / 4][next % 4];
            if enter <= limit {
                return Some(Visit {
                    node: open.children as usize + (next ^ self.mirror),
                    enter,
                    leave: open.leaves[next / 4][next % 4],
                });
            }
        }
        None
    }

    /// The least distances at which the ray may meet the three planes through a point.
    #[inline]
    fn earlier(&self, planes: Vec3) -> Vec3 {
        (planes - self.ahead) * self.inverse
    }

    /// The greatest distances at which the ray may meet the three planes through a point.
    #[inline]
    fn later(&self, planes: Vec3) -> Vec3 {
        (planes - self.behind) * self.inverse
    }

    /// The root, if there are shapes in it and the ray meets its cell.
    fn enter_root(&self, within: Interval) -> Option<Visit> {
        let Aabb { min, max } = self.tree.bounds;
        let (mut enter, mut leave) = (within.min, within.max);
        for axis in 0..3 {
            let down = self.mirror >> axis & 1 != 0;
            let (near, far) = if down { (max, min) } else { (min, max) };
            let (near, far) = (self.earlier(near)[axis], self.later(far)[axis]);
            // 0·∞: the ray runs in this face. Comparisons with the NaN are false, so the other face decides.
            enter = if near > enter { near } else { enter };
            leave = if far < leave { far } else { leave };
        }
        let some = !self.tree.named.is_empty() && enter <= leave;
        some.then_some(Visit {
            node: 0,
            enter,
            leave,
        })
    }
}

/// The bits of eight children, moved to the children's numbers in the order of the ray.
#[inline]
fn mirrored(mut bits: u8, mirror: usize) -> u8 {
    for (axis, lower) in LOWER.into_iter().enumerate() {
        if mirror >> axis & 1 != 0 {
            let width = 1 << axis;
            bits = (bits & lower) << width | bits >> width & lower;
        }
    }
    bits
}
