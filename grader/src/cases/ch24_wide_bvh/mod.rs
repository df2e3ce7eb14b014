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

fn half_area(q: &Collapse, i: u32) -> f32 {
    let node = &q.nodes[i as usize];
    let size = node.max - node.min;
    size.x * size.y + size.y * size.z + size.z * size.x
}
