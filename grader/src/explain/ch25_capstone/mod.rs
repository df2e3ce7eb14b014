//! Chapter 25: a ray through a whole scene, surface by surface, and its way in a drawing.

mod drawn;
mod shapes;
mod tracer;

use super::Explained;
use super::ch12_phong::colour;
use super::diagram::Diagram;
use super::way::Way;
use raybook::image::rgb::Rgb;
use raybook_workbook::exercises::ch25_capstone::Trace;

impl Explained for Trace {
    fn work(&self, way: &mut Way) -> Rgb {
        colour(tracer::traced(self, way).1)
    }

    fn draw(&self, _: &Rgb, _: Option<&Rgb>) -> Option<Diagram> {
        Some(drawn::drawn(self))
    }
}
