//! `direction_to_latlong`: the two angles of a direction.

use super::map::{Map, on_map};
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::way::Way;
use glam::{DVec3, Vec2, dvec2};
use raybook_workbook::exercises::ch18_environment::DirectionToLatlong;
use std::f64::consts::{PI, TAU};

/// The same with φ by its cosine, and the side by the sign of x.
fn by_cosines(asked: &DirectionToLatlong, way: &mut Way) -> Vec2 {
    let d = way.part("the direction", asked.direction.as_dvec3());
    let x = way.part("x", d.x);
    let ahead = way.part("−z", -d.z);
    let level = way.part("√(x² + z²)", d.x.hypot(d.z));
    let is_pole = way.decides("the direction is straight up or down", level == 0.0);
    let cosine = if is_pole { 1.0 } else { ahead / level };
    let cosine = way.part("cos φ = −z/√(x² + z²)", cosine);
    let phi = way.part("φ, on either side", cosine.clamp(-1.0, 1.0).acos());
    let phi = way.part("φ", phi.copysign(x));
    let y = way.part("y = cos θ", d.y);
    let theta = way.part("θ", y.clamp(-1.0, 1.0).acos());
    let turn = way.part("½ + φ/2π", 0.5 + phi / TAU);
    let u = if turn >= 1.0 { 0.0 } else { turn };
    let v = way.part("θ/π", theta / PI);
    dvec2(u, v).as_vec2()
}

impl Explained for DirectionToLatlong {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec2] = &[Self::work, by_cosines];

    fn work(&self, way: &mut Way) -> Vec2 {
        let d = way.part("the direction", self.direction.as_dvec3());
        let x = way.part("x", d.x);
        let ahead = way.part("−z", -d.z);
        let phi = way.number("φ = atan2(x, −z), around from −z", "rad", x.atan2(ahead));
        let turn = way.part("½ + φ/2π", 0.5 + phi / TAU);
        let is_edge = way.decides("φ is π", turn >= 1.0);
        if is_edge {
            way.remark("φ = π is the right edge of the map, which is its left edge, too.");
        }
        let level = way.part("√(x² + z²)", d.x.hypot(d.z));
        let y = way.part("y", d.y);
        let theta = way.number(
            "θ = atan2(√(x² + z²), y), down from +y",
            "rad",
            level.atan2(y),
        );
        let u = if is_edge { 0.0 } else { turn };
        let v = way.part("θ/π", theta / PI);
        way.pair("(u, v) = (½ + φ/2π, θ/π)", "", dvec2(u, v))
            .as_vec2()
    }

    fn draw(&self, right: &Vec2, yours: Option<&Vec2>) -> Option<Diagram> {
        let mut drawing =
            Diagram::new("The place on the map, with a line every 45°; −z is in its middle");
        Map::new(8, 4, &[]).draw(&mut drawing, &[]);
        for (name, d) in [("−z", DVec3::NEG_Z), ("+x", DVec3::X), ("−x", DVec3::NEG_X)] {
            drawing.label(on_map(d), dvec2(0.6, 0.8), name, Ink::Guide);
        }
        for (place, ink) in [(Some(right), Ink::Right), (yours, Ink::Yours)] {
            if let Some(place) = place {
                let (u, v) = (f64::from(place.x), f64::from(place.y));
                drawing.point(dvec2(2.0 * u, -v), ink);
            }
        }
        Some(drawing)
    }
}
