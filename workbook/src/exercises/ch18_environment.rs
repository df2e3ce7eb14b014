//! Chapter 18: `direction_to_cube`, `direction_to_latlong`, `sample_environment`, `environment_pdf`.

use crate::exercise::exercises;
use crate::exercises::ch17_rendering_equation::lattice;
use crate::record::row;
use glam::{Vec2, Vec3};
use raybook::image::{Image, rgb::Rgb};
use raybook::light::environment::{Environment, cube, latlong};
use raybook::math::dir3::Dir3;

exercises! { ($) ch18_environment
    /// Return the face of a cube map that a direction points at (0 to 5: +x, -x, +y, -y, +z, -z) and the place on the
    /// face, from (0, 0) at its top left to (1, 1) at its bottom right, as seen from inside. On the walls +y is up. On
    /// the ceiling +y the direction -z is down, and on the floor -y it is up.
    DirectionToCube: direction_to_cube(
        /// The direction.
        direction: Dir3,
    ) -> (
        /// The face, and the place on it.
        answer: CubePlace,
    ) {
        let (face, place) = cube::place(direction);
        CubePlace {
            face: face as u32,
            u: place.x,
            v: place.y,
        }
    }

    /// Return where a direction is on a latitude-longitude map, from (0, 0) at its top left to (1, 1) at its bottom
    /// right: -z is in the middle, +x right of it, +y the top edge.
    DirectionToLatlong: direction_to_latlong(
        /// The direction.
        direction: Dir3,
    ) -> (
        /// The place on the map, from (0, 0) at the top left to (1, 1).
        place: Vec2,
    ) {
        latlong::place(direction)
    }

    /// Choose directions by a latitude-longitude map: a texel in proportion to its radiance times its solid angle, and
    /// a direction within it uniformly by solid angle. The answer is a direction for each u = ((i + ½)/256, the
    /// fractional part of 0.618034 · (i + ½)), with i from 0 to 255.
    SampleEnvironment: sample_environment(
        /// The number of texels in a row.
        width: u32,
        /// The number of rows.
        height: u32,
        /// The radiance of each texel, in W·m⁻²·sr⁻¹, row by row from the top left.
        texels: Vec<f32>,
    ) -> (
        /// The 256 directions of length 1, one for each point; no direction for a black map.
        direction: Vec<Vec3>,
    ) {
        let environment = environment(width, height, &texels);
        let chosen = lattice(POINTS).filter_map(|u| environment.choose(u));
        chosen.map(|direction| *direction).collect()
    }

    /// Return the probability density per steradian with which sample_environment chooses a direction: the probability
    /// of its texel divided by the texel's solid angle. It is 0 for a black map.
    EnvironmentPdf: environment_pdf(
        /// The direction.
        direction: Dir3,
        /// The number of texels in a row.
        width: u32,
        /// The number of rows.
        height: u32,
        /// The radiance of each texel, in W·m⁻²·sr⁻¹, row by row from the top left.
        texels: Vec<f32>,
    ) -> (
        /// The density of the direction, per steradian.
        density: f32,
    ) {
        environment(width, height, &texels).density(direction)
    }
}

row! {
    /// A place on a cube map.
    pub struct CubePlace {
        /// The face: 0 to 5 for +x, −x, +y, −y, +z, −z.
        pub face: u32,
        /// From 0 at the left edge of the face to 1 at the right one.
        pub u: f32,
        /// From 0 at the top edge of the face to 1 at the bottom one.
        pub v: f32,
    }
}

/// The map of a question.
fn environment(width: u32, height: u32, texels: &[f32]) -> Environment {
    Environment::new(Image::from_fn(
        width.max(1) as usize,
        height.max(1) as usize,
        |x, y| Rgb::gray(texels.get(y * width as usize + x).copied().unwrap_or(0.0)),
    ))
}

/// Number of points u that are asked for.
pub const POINTS: u32 = 256;
