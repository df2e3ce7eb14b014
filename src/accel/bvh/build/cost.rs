//! What a search costs: the surface-area heuristic.

/// The price of a ray's steps through a tree; only their ratio matters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// Testing the boxes of a branch's children.
    pub branch: f32,
    /// Testing a block of shapes.
    pub block: f32,
    /// Shapes in a block, which are tested at once.
    pub block_size: u32,
    /// Leaves have at most so many shapes.
    pub most: u32,
}

impl Cost {
    /// The price of testing so many shapes.
    pub fn shapes(&self, count: usize) -> f32 {
        self.block * count.div_ceil(self.block_size as usize) as f32
    }
}
