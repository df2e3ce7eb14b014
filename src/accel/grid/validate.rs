//! The invariants of a grid.

use crate::accel::grid::Grid;
use crate::math::aabb::Aabb;
use crate::shape::Shape;

impl<S: Shape> Grid<S> {
    /// Checks the grid's invariants.
    ///
    /// # Errors
    /// The first invariant that does not hold, in words.
    pub fn validate(&self) -> Result<(), String> {
        let parts = &self.parts;
        let (cells, shapes) = (parts.lattice.cells(), parts.shapes.len());
        if parts.starts.len() != cells + 1 || parts.starts.first() != Some(&0) {
            return Err(format!(
                "{cells} cells need {} starts, the first of them 0, and there are {}",
                cells + 1,
                parts.starts.len()
            ));
        }
        if parts.starts.last().map(|&end| end as usize) != Some(parts.references.len()) {
            return Err("the last list does not end where the references do".to_owned());
        }
        let mut lists = vec![0; shapes];
        for cell in 0..cells {
            let (start, end) = (parts.starts[cell] as usize, parts.starts[cell + 1] as usize);
            if start > end {
                return Err(format!("the list of cell {cell} ends before it begins"));
            }
            let list = &parts.references[start..end];
            if !list.is_sorted_by(|a, b| a < b) {
                return Err(format!(
                    "a shape is twice in cell {cell}, or its list is not in order"
                ));
            }
            for &place in list {
                *lists
                    .get_mut(place as usize)
                    .ok_or_else(|| format!("cell {cell} holds shape {place} of {shapes}"))? += 1;
            }
        }
        if let Some(lost) = lists.iter().position(|&lists| lists == 0) {
            return Err(format!("shape {lost} is in no cell"));
        }
        let whole = parts.lattice.bounds();
        let outside = |shape: &S| {
            let Aabb { min, max } = shape.bounds();
            !whole.contains(min) || !whole.contains(max)
        };
        match parts.shapes.iter().position(outside) {
            Some(shape) => Err(format!("shape {shape} reaches out of the grid")),
            None => Ok(()),
        }
    }
}
