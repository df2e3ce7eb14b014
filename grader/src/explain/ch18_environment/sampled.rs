//! `sample_environment`: a row by its light, a texel of it, and a direction in the texel.

use super::map::{Map, on_map};
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::way::Way;
use glam::{DVec3, Vec3};
use raybook_workbook::exercises::ch17_rendering_equation::lattice;
use raybook_workbook::exercises::ch18_environment::{POINTS, SampleEnvironment};
use std::f64::consts::TAU;

/// Which of some weights a share of their sum falls into, and where in it.
fn choose(weights: &[f64], share: f64) -> (usize, f64) {
    let mut left = share * weights.iter().sum::<f64>();
    let mut last = (0, 0.0);
    for (i, weight) in weights
        .iter()
        .enumerate()
        .filter(|(_, weight)| **weight > 0.0)
    {
        last = (i, (left / weight).min(1.0));
        if left < *weight {
            break;
        }
        left -= weight;
    }
    last
}

impl Explained for SampleEnvironment {
    fn work(&self, way: &mut Way) -> Vec<Vec3> {
        let map = Map::new(self.width, self.height, &self.texels);
        let all = map.all_told(way);
        if way.decides("the map is black", all <= 0.0) {
            way.remark("The map is black: there is no direction to choose.");
            return Vec::new();
        }
        let rows: Vec<f64> = (0..map.height)
            .map(|row| map.of_row(row).iter().sum())
            .collect();
        way.remark("The first direction; the others go the same way:");
        way.of_first(lattice(POINTS), |way, u| {
            let u = way.pair("u", "", u.as_dvec2());
            let (row, down) = choose(&rows, u.y);
            let row = way.number(
                "u.y chooses the row by its light: its number",
                "",
                row as f64,
            );
            let down = way.number("and how far down in it", "", down);
            let row = (row.max(0.0) as usize).min(map.height - 1);
            let (column, right) = choose(map.of_row(row), u.x);
            let name = "u.x chooses the texel of the row: its number";
            let column = way.number(name, "", column as f64);
            let right = way.number("and how far right in it", "", right);
            let row = way.part("the row on the map", row as f64);
            let row = (row.max(0.0) as usize).min(map.height - 1);
            let turn = way.part(
                "(column + right)/width",
                (column + right) / map.width as f64,
            );
            let phi = TAU * (turn - 0.5);
            let phi = way.number("φ, which goes evenly through the texel", "rad", phi);
            let [top, bottom] = map.edges(row);
            let cosine = way.number("cos θ, which does so too", "", top + down * (bottom - top));
            let sine = way.part("sin θ", (1.0 - cosine * cosine).max(0.0).sqrt());
            let toward = DVec3::new(sine * phi.sin(), cosine, -sine * phi.cos());
            way.vector(
                "the direction (sin θ sin φ, cos θ, −sin θ cos φ)",
                "",
                toward,
            )
            .as_vec3()
        })
    }

    fn draw(&self, right: &Vec<Vec3>, yours: Option<&Vec<Vec3>>) -> Option<Diagram> {
        let mut drawing = Diagram::new(
            "The directions on the map; a texel that is brighter or larger on the sphere gets more of them",
        );
        Map::new(self.width, self.height, &self.texels).draw(&mut drawing, &self.texels);
        let yours = yours.map_or(&[][..], Vec::as_slice);
        for (directions, ink) in [(right.as_slice(), Ink::Right), (yours, Ink::Yours)] {
            for d in directions.iter().take(POINTS as usize) {
                drawing.point(on_map(d.as_dvec3()), ink);
            }
        }
        Some(drawing)
    }
}
