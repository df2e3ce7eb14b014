//! `environment_pdf`: the probability of a direction's texel, per steradian.

use super::map::{Map, on_map};
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::way::Way;
use glam::{DVec2, dvec2};
use raybook_workbook::exercises::ch18_environment::{DirectionToLatlong, EnvironmentPdf};

impl Explained for EnvironmentPdf {
    fn work(&self, way: &mut Way) -> f32 {
        let map = Map::new(self.width, self.height, &self.texels);
        let all = map.all_told(way);
        if way.decides("the map is black", all <= 0.0) {
            way.remark("The map is black: the density is 0.");
            return 0.0;
        }
        let latlong = DirectionToLatlong {
            direction: self.direction,
        };
        let place = latlong.work(way).as_dvec2();
        let columns = way.part("the number of columns", map.width as f64);
        let rows = way.part("the number of rows", map.height as f64);
        let texel = |place: f64, count: f64| (place * count).floor().min(count - 1.0);
        let of = [texel(place.x, columns), texel(place.y, rows)];
        let at = way.part("column and row", DVec2::from_array(of));
        let x = way.number("its texel's column, from 0", "", at.x);
        let y = way.number("its texel's row, from 0", "", at.y);
        let within = |place: f64, count: usize| (place.max(0.0) as usize).min(count - 1);
        let y = within(y, map.height);
        let width = way.part("the number of texels in a row", map.width as f64);
        let number = way.number(
            "its number in the list, row · width + column",
            "",
            y as f64 * width + x,
        );
        let solid_angle = way.number(
            "the texel's solid angle, 2π (cos θ₀ − cos θ₁)/width",
            "sr",
            map.solid_angle(y),
        );
        let texel = within(number, self.texels.len());
        let radiance = way.number("its radiance", "W·m⁻²·sr⁻¹", f64::from(self.texels[texel]));
        let probability = way.number(
            "its probability: radiance times solid angle over the sum",
            "",
            radiance * map.solid_angle(y) / all,
        );
        way.number("probability/solid angle", "1/sr", probability / solid_angle) as f32
    }

    fn draw(&self, _: &f32, _: Option<&f32>) -> Option<Diagram> {
        let mut drawing =
            Diagram::new("The direction on the map, whose texels have these radiances");
        drawing.keyed = false;
        Map::new(self.width, self.height, &self.texels).draw(&mut drawing, &self.texels);
        let at = on_map(self.direction.as_dvec3());
        drawing.point(at, Ink::Shape);
        drawing.label(at, dvec2(0.6, 0.8), "the direction", Ink::Shape);
        Some(drawing)
    }
}
