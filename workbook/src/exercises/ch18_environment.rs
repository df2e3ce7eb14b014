//! Chapter 18: `direction_to_cube`, `direction_to_latlong`, `sample_environment`, `environment_pdf`.

use raybook::image::{Image, rgb::Rgb};
use raybook::light::environment::{Environment, cube, latlong};
use raybook::math::dir3::Dir3;
use crate::exercise::{Asked, Exercise};
use crate::exercises::ch17_rendering_equation::lattice;
use crate::row::row;
use glam::{Vec2, Vec3};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[
    &DirectionToCube,
    &DirectionToLatlong,
    &SampleEnvironment,
    &EnvironmentPdf,
];

/// See [`Exercise::TASK`].
pub struct DirectionToCube;

row! {
    /// A direction.
    pub struct DirectionQuestion {
        /// Where to look.
        pub direction: Dir3,
    }
}

row! {
    /// A place on a cube map.
    pub struct CubePlace {
        /// 0 to 5: +x, −x, +y, −y, +z, −z.
        pub face: u32,
        /// From the left edge of the face, 0, to the right one, 1.
        pub u: f32,
        /// From the top edge of the face, 0, to the bottom one, 1.
        pub v: f32,
    }
}

impl Exercise for DirectionToCube {
    type Question = DirectionQuestion;
    type Answer = CubePlace;
    const NAME: &'static str = "direction_to_cube";
    const TASK: &'static str = "Return the face of a cube map that a direction points at (0 to 5: +x, -x, +y, -y, +z, -z) and the place on it, (0, 0) at its top left and (1, 1) at its bottom right, as seen from inside: +y is up on the walls, -z is down on the ceiling +y and up on the floor -y.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let (face, place) = cube::place(q.direction);
        CubePlace {
            face: face as u32,
            u: place.x,
            v: place.y,
        }
    }
}

/// See [`Exercise::TASK`].
pub struct DirectionToLatlong;

impl Exercise for DirectionToLatlong {
    type Question = DirectionQuestion;
    type Answer = Vec2;
    const NAME: &'static str = "direction_to_latlong";
    const ANSWER: &'static str = "place";
    const TASK: &'static str = "Return where a direction is on a latitude-longitude map, from (0, 0) at its top left to (1, 1) at its bottom right: -z is in the middle, +x right of it, +y the top edge.";

    fn answer(q: &Self::Question) -> Self::Answer {
        latlong::place(q.direction)
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

/// See [`Exercise::TASK`].
pub struct SampleEnvironment;

row! {
    /// A latitude–longitude map.
    pub struct MapQuestion {
        /// Texels in a row.
        pub width: u32,
        /// Rows.
        pub height: u32,
        /// The radiance of each texel, row by row from the top left.
        pub texels: Vec<f32>,
    }
}

/// So many points u are asked for.
pub const POINTS: u32 = 256;

impl Exercise for SampleEnvironment {
    type Question = MapQuestion;
    type Answer = Vec<Vec3>;
    const NAME: &'static str = "sample_environment";
    const ANSWER: &'static str = "direction";
    const TASK: &'static str = "Return a direction for u in the unit square, so that a texel of the latitude-longitude map is chosen in proportion to its radiance times its solid angle, and its directions uniformly by solid angle; None for a black map. The answer is the list of the directions for the 256 points u = ((i + ½)/256, the fraction of 0.618034 · (i + ½)), with i from 0 to 255.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let environment = environment(q.width, q.height, &q.texels);
        let chosen = lattice(POINTS).filter_map(|u| environment.choose(u));
        chosen.map(|direction| *direction).collect()
    }
}

/// See [`Exercise::TASK`].
pub struct EnvironmentPdf;

row! {
    /// A latitude–longitude map, and a direction.
    pub struct DensityQuestion {
        /// Towards a place on the map.
        pub direction: Dir3,
        /// Texels in a row.
        pub width: u32,
        /// Rows.
        pub height: u32,
        /// The radiance of each texel, row by row from the top left.
        pub texels: Vec<f32>,
    }
}

impl Exercise for EnvironmentPdf {
    type Question = DensityQuestion;
    type Answer = f32;
    const NAME: &'static str = "environment_pdf";
    const ANSWER: &'static str = "density";
    const TASK: &'static str = "Return the density per steradian with which sample_environment chooses a direction: the probability of its texel divided by the texel's solid angle; 0 for a black map.";

    fn answer(q: &Self::Question) -> Self::Answer {
        environment(q.width, q.height, &q.texels).density(q.direction)
    }
}
