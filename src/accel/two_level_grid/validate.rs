//! The invariants of a two-level grid.

use crate::accel::two_level_grid::TwoLevelGrid;
use crate::math::aabb::Aabb;
use crate::shape::Shape;

impl<S: Shape> TwoLevelGrid<S> {
    /// Checks the grid's invariants.
    ///
    /// # Errors
    /// The first invariant that does not hold, in words.
    pub fn validate(&self) -> Result<(), String> {
        let parts = &self.parts;
        let (levels, shapes) = (&parts.levels, &parts.shapes);
        if levels.cuts.len() != levels.top.cells() {
            return Err(format!(
                "{} coarse cells, and {} of them cut",
                levels.top.cells(),
                levels.cuts.len()
            ));
        }
        if parts.starts.len() != levels.cells() + 1 || parts.starts.first() != Some(&0) {
            return Err("there is not one start for each fine cell".to_owned());
        }
        if parts.starts.last().map(|&end| end as usize) != Some(parts.references.len()) {
            return Err("the last list does not end where the references do".to_owned());
        }
        let mut lists = vec![0; shapes.len()];
        for coarse in levels.top.all() {
            let Some((first, fine)) = levels.fine(coarse) else {
                continue;
            };
            for cell in fine.all() {
                let i = first + fine.index(cell);
                let reach = fine.bounds_of(cell, cell).grown(2.0 * parts.margin);
                if parts.starts[i] > parts.starts[i + 1] {
                    return Err(format!(
                        "the list of cell {cell} of {coarse} ends before it begins"
                    ));
                }
                let list =
                    &parts.references[parts.starts[i] as usize..parts.starts[i + 1] as usize];
                for (at, &place) in list.iter().enumerate() {
                    let Some(shape) = shapes.get(place as usize) else {
                        return Err(format!(
                            "cell {cell} of {coarse} holds shape {place}, which is none"
                        ));
                    };
                    let Aabb { min, max } = shape.bounds();
                    if min.cmpgt(reach.max).any() || max.cmplt(reach.min).any() {
                        return Err(format!("shape {place} is far from cell {cell} of {coarse}"));
                    }
                    if list[..at].contains(&place) {
                        return Err(format!("shape {place} is twice in cell {cell} of {coarse}"));
                    }
                    lists[place as usize] += 1;
                }
            }
        }
        let whole = levels.top.bounds();
        for (place, shape) in shapes.iter().enumerate() {
            let Aabb { min, max } = shape.bounds();
            if lists[place] == 0 {
                return Err(format!("shape {place} is in no cell"));
            }
            if !whole.contains(min) || !whole.contains(max) {
                return Err(format!("shape {place} reaches out of the grid"));
            }
        }
        Ok(())
    }
}
