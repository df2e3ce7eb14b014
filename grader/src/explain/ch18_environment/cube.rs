//! `direction_to_cube`: the face by the largest component, the place by the other two.

use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::way::Way;
use glam::{DVec2, dvec2};
use raybook_workbook::exercises::ch18_environment::{CubePlace, DirectionToCube};

impl Explained for DirectionToCube {
    fn work(&self, way: &mut Way) -> CubePlace {
        const FACES: [&str; 6] = ["+x", "−x", "+y", "−y", "+z", "−z"];
        let d = way.part("the direction", self.direction.as_dvec3());
        let smallness = (-d.abs()).to_array();
        let axis = way.least("the axis of the greatest component", &smallness);
        let m = way.number("m: the component of the greatest magnitude", "", d[axis]);
        let is_negative = way.decides("m is negative", m <= 0.0);
        let face = 2 * axis + usize::from(is_negative);
        way.remark(format!(
            "It belongs to face {face}, which is {}.",
            FACES[face]
        ));
        // Each face has a line of its own, and its own slips.
        let along: DVec2 = match face {
            0 => way.pair("to the right and down on +x: (z, −y)", "", dvec2(d.z, -d.y)),
            1 => way.pair(
                "to the right and down on −x: (−z, −y)",
                "",
                dvec2(-d.z, -d.y),
            ),
            2 => way.pair("to the right and down on +y: (x, −z)", "", dvec2(d.x, -d.z)),
            3 => way.pair("to the right and down on −y: (x, z)", "", dvec2(d.x, d.z)),
            4 => way.pair(
                "to the right and down on +z: (−x, −y)",
                "",
                dvec2(-d.x, -d.y),
            ),
            _ => way.pair("to the right and down on −z: (x, −y)", "", dvec2(d.x, -d.y)),
        };
        let along = way.part("that, on any face", along);
        let along = way.part("that/|m|", along / m.abs());
        let place = way.pair("(u, v) = ½ + ½ · that/|m|", "", 0.5 + 0.5 * along);
        let face = way.part("the face's number", face as f64);
        CubePlace {
            face: face as u32,
            u: place.x as f32,
            v: place.y as f32,
        }
    }

    fn draw(&self, right: &CubePlace, yours: Option<&CubePlace>) -> Option<Diagram> {
        /// Each face's name, and the lower left corner of its square in the unfolded cube.
        const FACES: [(&str, DVec2); 6] = [
            ("+x", dvec2(2.0, 1.0)),
            ("−x", dvec2(0.0, 1.0)),
            ("+y", dvec2(1.0, 2.0)),
            ("−y", dvec2(1.0, 0.0)),
            ("+z", dvec2(3.0, 1.0)),
            ("−z", dvec2(1.0, 1.0)),
        ];
        let mut drawing = Diagram::new(
            "The cube unfolded around −z, as seen from inside, and the place on its faces",
        );
        for (name, corner) in FACES {
            let (x, y) = (DVec2::X, DVec2::Y);
            let outline = [corner, corner + x, corner + x + y, corner + y, corner];
            drawing.line(&outline, Ink::Guide);
            drawing.label(corner + 0.5, DVec2::ZERO, name, Ink::Guide);
        }
        for (place, ink) in [(Some(right), Ink::Right), (yours, Ink::Yours)] {
            let on_face = place.and_then(|p| Some((p, FACES.get(p.face as usize)?)));
            if let Some((place, (_, corner))) = on_face {
                let (u, v) = (f64::from(place.u), f64::from(place.v));
                drawing.point(corner + dvec2(u, 1.0 - v), ink);
            }
        }
        Some(drawing)
    }
}
