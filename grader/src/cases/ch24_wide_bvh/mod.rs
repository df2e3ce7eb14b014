//! Chapter 24: `collapse`, `wide_closest`.

use raybook_workbook::exercises::ch24_wide_bvh::Collapse;

raybook_workbook::ch24_wide_bvh!(graded);

pub use wide_closest::question;

const MOST: usize = 8;

fn is_branch(q: &Collapse, i: u32) -> bool {
    q.nodes[i as usize].count == 0
}

fn pair(q: &Collapse, i: u32) -> [u32; 2] {
    [0, 1].map(|side| q.nodes[i as usize].first + side)
}

/// Half of the area of a node's box; 0 for one that is not there.
fn half_area(q: &Collapse, i: u32) -> f32 {
    q.nodes.get(i as usize).map_or(0.0, |node| {
        let size = node.max - node.min;
        size.x * size.y + size.y * size.z + size.z * size.x
    })
}
