//! Chapter 18: `direction_to_cube`, `direction_to_latlong`, `sample_environment`, `environment_pdf`.

mod distributed;

use glam::vec3;
use raybook::light::environment::latlong;
use raybook::math::dir3::Dir3;
use raybook_workbook::exercises::ch18_environment::SampleEnvironment;
use std::f64::consts::PI;

raybook_workbook::ch18_environment!(graded);

fn toward(x: f32, y: f32, z: f32) -> Dir3 {
    Dir3::new_or(vec3(x, y, z), Dir3::X)
}

/// The cell of a place in [0, 1), of n.
fn cell(x: f32, n: u32) -> usize {
    ((x * n as f32).max(0.0) as usize).min(n as usize - 1)
}

/// What is asked of a question here.
pub(super) trait OfMap {
    fn texel(&self, x: usize, y: usize) -> f64;

    /// The solid angle of a texel of a row.
    fn solid_angle(&self, y: usize) -> f64;

    /// The light of a texel: its value times its solid angle.
    fn light(&self, x: usize, y: usize) -> f64;

    /// The light of all texels.
    fn all_light(&self) -> f64;

    /// The share of a texel in all the light.
    fn share(&self, x: usize, y: usize) -> f64 {
        self.light(x, y) / self.all_light()
    }
}

impl OfMap for SampleEnvironment {
    fn texel(&self, x: usize, y: usize) -> f64 {
        f64::from(self.texels[y * self.width as usize + x])
    }

    fn solid_angle(&self, y: usize) -> f64 {
        let [top, bottom] = [y, y + 1].map(|row| latlong::cosine(row, self.height as usize));
        2.0 * PI * (top - bottom) / f64::from(self.width)
    }

    fn light(&self, x: usize, y: usize) -> f64 {
        self.texel(x, y) * self.solid_angle(y)
    }

    fn all_light(&self) -> f64 {
        let cells =
            (0..self.height as usize).flat_map(|y| (0..self.width as usize).map(move |x| (x, y)));
        cells.map(|(x, y)| self.light(x, y)).sum()
    }
}
