//! What the tree is made of: nodes of eight children and leaves of up to eight triangles, laid out for vector instructions.

use crate::math::aabb::Aabb;
use crate::shape::mesh::Facet;
use glam::Vec3;

/// Children of a node.
pub const CHILDREN: usize = 8;

/// Triangles of a leaf.
pub const TRIANGLES: usize = 8;

/// The place of a child: a node, or, with the top bit set, a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd)]
pub struct Link(u32);

/// The bit that tells leaves from nodes.
const LEAF: u32 = 1 << 31;

impl Link {
    /// To no child.
    pub(super) const NONE: Self = Self(u32::MAX);

    /// To the node number i.
    pub fn node(i: usize) -> Self {
        Self(i as u32)
    }

    /// To the leaf number i.
    pub fn leaf(i: usize) -> Self {
        Self(i as u32 | LEAF)
    }

    /// The link with these bits.
    #[inline(always)]
    pub(super) fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    /// Its number and what it leads to, in one number.
    #[inline(always)]
    pub(super) fn bits(self) -> u32 {
        self.0
    }

    /// The number of the leaf, if it is one.
    pub fn as_leaf(self) -> Option<usize> {
        (self.0 & LEAF != 0).then_some((self.0 & !LEAF) as usize)
    }

    /// The number of the node or the leaf.
    pub fn index(self) -> usize {
        (self.0 & !LEAF) as usize
    }
}

/// The rows of inverted boxes.
const EMPTY: [[f32; CHILDREN]; 6] = {
    let (least, greatest) = ([f32::INFINITY; CHILDREN], [f32::NEG_INFINITY; CHILDREN]);
    [least, greatest, least, greatest, least, greatest]
};

/// Eight boxes, as rows of eight numbers: all least x, all greatest x, then y, then z; and the eight children in them.
///
/// A place without a child has an inverted box, which no ray meets. 256 bytes: four cache lines, from the start of one.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct Node {
    /// Row 2·axis + 0 or 1.
    pub(super) rows: [[f32; CHILDREN]; 6],
    /// The children.
    pub(super) links: [Link; CHILDREN],
}

impl Node {
    /// A node of at most eight children with their boxes.
    pub(super) fn new(children: impl IntoIterator<Item = (Aabb, Link)>) -> Self {
        let mut node = Self {
            rows: EMPTY,
            links: [Link::NONE; CHILDREN],
        };
        for (lane, (bounds, link)) in children.into_iter().enumerate() {
            for axis in 0..3 {
                node.rows[2 * axis][lane] = bounds.min[axis];
                node.rows[2 * axis + 1][lane] = bounds.max[axis];
            }
            node.links[lane] = link;
        }
        node
    }

    /// The children with their boxes.
    pub fn children(&self) -> impl Iterator<Item = (Aabb, Link)> {
        let lanes = (0..CHILDREN).filter(|&lane| self.links[lane] != Link::NONE);
        lanes.map(|lane| {
            let corner =
                |side: usize| Vec3::from_array([0, 2, 4].map(|row| self.rows[row + side][lane]));
            (
                Aabb {
                    min: corner(0),
                    max: corner(1),
                },
                self.links[lane],
            )
        })
    }
}

/// Up to eight triangles side by side: the first corners' x, then their y, and so on.
///
/// A place without a triangle has corners of NaN, which no ray hits.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub struct Leaf {
    /// `[corner][axis][lane]`, in metres.
    pub(super) corners: [[[f32; TRIANGLES]; 3]; 3],
    /// Their places in the list of facets.
    pub(super) facets: [u32; TRIANGLES],
    /// Their ids.
    pub(super) ids: [u32; TRIANGLES],
}

/// A place without a triangle.
pub(super) const NO_FACET: u32 = u32::MAX;

impl Leaf {
    /// A leaf of at most [`TRIANGLES`] of the facets.
    pub(super) fn new(facets: &[Facet], chosen: &[u32]) -> Self {
        let mut leaf = Self {
            corners: [[[f32::NAN; TRIANGLES]; 3]; 3],
            facets: [NO_FACET; TRIANGLES],
            ids: [0; TRIANGLES],
        };
        for (lane, &index) in chosen.iter().enumerate() {
            leaf.facets[lane] = index;
            leaf.ids[lane] = facets[index as usize].id;
            for (rows, p) in leaf.corners.iter_mut().zip(facets[index as usize].corners) {
                for (row, v) in rows.iter_mut().zip(p.to_array()) {
                    row[lane] = v;
                }
            }
        }
        leaf
    }

    /// The places of its triangles in the list of facets.
    pub fn facets(&self) -> impl Iterator<Item = u32> {
        let all = self.facets.iter().copied();
        all.filter(|&facet| facet != NO_FACET)
    }
}
