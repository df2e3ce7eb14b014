//! The number of cells along each axis.

use crate::explain::Explained;
use crate::explain::view::AXES;
use crate::explain::way::Way;
use glam::DVec3;
use raybook_workbook::exercises::ch08_grid::{Cell, GridResolution};

impl Explained for GridResolution {
    fn work(&self, way: &mut Way) -> Cell {
        let extents = self.extents.as_dvec3();
        let extents = way.part("the extents", extents);
        let density = way.part("density", f64::from(self.density));
        let shapes = way.part("shapes", f64::from(self.shapes));
        let cells = way.number("cells = density · shapes", "", density * shapes);
        let mut thick: Vec<usize> = (0..3).filter(|&axis| extents[axis] > 0.0).collect();
        let along = loop {
            if way.decides("no axis is left to be cut", thick.is_empty()) {
                way.remark("No axis is left to be cut: there is one cell.");
                break DVec3::ONE;
            }
            let names: Vec<_> = thick.iter().map(|&axis| AXES[axis]).collect();
            let volume: f64 = thick.iter().map(|&axis| extents[axis]).product();
            let names = names.join(" · ");
            let volume = way.number(format!("the volume, of {names}"), "", volume);
            let shared = if thick.len() == 3 {
                way.part("cells, where all axes share them", cells)
            } else {
                way.part("cells, where fewer axes share them", cells)
            };
            let dense = way.part("cells/volume", shared / volume);
            let root = way.part("1 over the number of axes", 1.0 / thick.len() as f64);
            let dense = way.power("the root of cells/volume", dense, root);
            let per_metre = way.number("cells per metre: the root of cells/volume", "1/m", dense);
            let mut along = DVec3::ONE;
            for &axis in &thick {
                along[axis] = (extents[axis] * per_metre).min(cells.max(1.0));
            }
            let along = way.vector("extent · cells per metre", "", along);
            let before = thick.len();
            let least = way.part("the one cell that an axis must get", 1.0);
            let thin = thick.iter().any(|&axis| along[axis] < least);
            if !way.decides("an axis gets less than one cell", thin) {
                break along;
            }
            thick.retain(|&axis| along[axis] >= least);
            if thick.len() == before {
                break along;
            }
            way.remark("An axis gets less than one cell: it has 1, and is left out of the volume.");
        };
        let along = way.part("the same before it is rounded", along);
        way.vector("rounded, and 1 at least", "", along.round().max(DVec3::ONE))
            .as_uvec3()
            .into()
    }
}
