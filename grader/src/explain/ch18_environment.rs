//! Chapter 18: a direction's place on a cube map and on a latitude-longitude map.

use super::Explained;
use super::way::Way;
use glam::{DVec2, Vec2, dvec2};
use raybook_workbook::exercises::ch18_environment::{
    CubePlace, DirectionToCube, DirectionToLatlong,
};
use std::f64::consts::{PI, TAU};

impl Explained for DirectionToCube {
    fn work(&self, way: &mut Way) -> CubePlace {
        const FACES: [&str; 6] = ["+x", "−x", "+y", "−y", "+z", "−z"];
        let d = self.direction.as_dvec3();
        let axis = d.abs().max_position();
        let m = way.number("m: the component of the greatest magnitude", "", d[axis]);
        let face = 2 * axis + usize::from(m <= 0.0);
        way.remark(format!(
            "It belongs to face {face}, which is {}.",
            FACES[face]
        ));
        let (towards, right, down) = match face {
            0 => ("(z, −y)", d.z, -d.y),
            1 => ("(−z, −y)", -d.z, -d.y),
            2 => ("(x, −z)", d.x, -d.z),
            3 => ("(x, z)", d.x, d.z),
            4 => ("(−x, −y)", -d.x, -d.y),
            _ => ("(x, −y)", d.x, -d.y),
        };
        let name = format!("to the right and down on this face: {towards}");
        let along: DVec2 = way.pair(name, "", dvec2(right, down));
        let place = way.pair("(u, v) = ½ + ½ · that/|m|", "", 0.5 + 0.5 * along / m.abs());
        CubePlace {
            face: face as u32,
            u: place.x as f32,
            v: place.y as f32,
        }
    }
}

impl Explained for DirectionToLatlong {
    fn work(&self, way: &mut Way) -> Vec2 {
        let d = self.direction.as_dvec3();
        let phi = way.number("φ = atan2(x, −z), around from −z", "rad", d.x.atan2(-d.z));
        let turn = 0.5 + phi / TAU;
        if turn >= 1.0 {
            way.remark("φ = π is the right edge of the map, which is its left edge, too.");
        }
        let theta = d.x.hypot(d.z).atan2(d.y);
        let theta = way.number("θ = atan2(√(x² + z²), y), down from +y", "rad", theta);
        let u = if turn < 1.0 { turn } else { 0.0 };
        way.pair("(u, v) = (½ + φ/2π, θ/π)", "", dvec2(u, theta / PI))
            .as_vec2()
    }
}
