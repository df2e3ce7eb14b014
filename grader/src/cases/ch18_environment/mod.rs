//! Chapter 18: `direction_to_cube`, `direction_to_latlong`, `sample_environment`, `environment_pdf`.

mod distributed;

use glam::vec3;
use raybook::light::environment::latlong;
use raybook::math::dir3::Dir3;
use std::f64::consts::PI;

raybook_workbook::ch18_environment!(graded);

fn toward(x: f32, y: f32, z: f32) -> Dir3 {
    Dir3::new_or(vec3(x, y, z), Dir3::X)
}

/// The cell of a place in [0, 1), of n.
fn cell(x: f32, n: u32) -> usize {
    ((x * n as f32).max(0.0) as usize).min(n as usize - 1)
}

/// What is asked of a question's map here.
pub(super) trait OfMap {
    /// Columns and rows.
    fn size(&self) -> [usize; 2];

    /// Row by row.
    fn texels(&self) -> &[f32];

    fn texel(&self, x: usize, y: usize) -> f64 {
        f64::from(self.texels()[y * self.size()[0] + x])
    }

    /// The solid angle of a texel of a row.
    fn solid_angle(&self, y: usize) -> f64 {
        let [width, height] = self.size();
        let [top, bottom] = [y, y + 1].map(|row| latlong::cosine(row, height));
        2.0 * PI * (top - bottom) / width as f64
    }

    /// The light of a texel: its value times its solid angle.
    fn light(&self, x: usize, y: usize) -> f64 {
        self.texel(x, y) * self.solid_angle(y)
    }

    /// The light of all texels.
    fn all_light(&self) -> f64 {
        let [width, height] = self.size();
        let cells = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        cells.map(|(x, y)| self.light(x, y)).sum()
    }

    /// The share of a texel in all the light.
    fn share(&self, x: usize, y: usize) -> f64 {
        self.light(x, y) / self.all_light()
    }
}

/// Of an exercise whose questions have a map.
macro_rules! of_map {
    ($($exercise:ident),+) => {
        $(impl OfMap for raybook_workbook::exercises::ch18_environment::$exercise {
            fn size(&self) -> [usize; 2] {
                [self.width, self.height].map(|n| n as usize)
            }

            fn texels(&self) -> &[f32] {
                &self.texels
            }
        })+
    };
}

of_map!(SampleEnvironment, EnvironmentPdf);
