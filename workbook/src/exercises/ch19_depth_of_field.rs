//! Chapter 19: `concentric_disk`, `thin_lens_ray`, `circle_of_confusion`.

use raybook::camera::aperture::Aperture;
use raybook::camera::lens::Lens;
use raybook::camera::pinhole::Pinhole;
use raybook::camera::thin_lens::ThinLens;
use raybook::math::dir3::Dir3;
use raybook::sample::disk;
use crate::exercise::{Asked, Exercise};
use crate::exercises::ch01_rays::CameraRayAnswer;
use crate::row::row;
use glam::{Vec2, Vec3, vec2};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&ConcentricDisk, &ThinLensRay, &CircleOfConfusion];

/// See [`Exercise::TASK`].
pub struct ConcentricDisk;

row! {
    /// Which points of the unit square are asked.
    pub struct ConcentricDiskQuestion {
        /// How many.
        pub n: u32,
        /// By how much all of them are moved, around the square's edges.
        pub shift: Vec2,
    }
}

impl ConcentricDiskQuestion {
    /// The points u.
    pub fn points(&self) -> impl Iterator<Item = Vec2> + use<> {
        let (n, shift) = (f64::from(self.n), self.shift.as_dvec2());
        (0..self.n).map(move |i| {
            let i = f64::from(i) + 0.5;
            let (x, y) = (shift.x + i / n, shift.y + 0.618_034 * i);
            vec2((x - x.floor()) as f32, (y - y.floor()) as f32)
        })
    }
}

impl Exercise for ConcentricDisk {
    type Question = ConcentricDiskQuestion;
    type Answer = Vec<Vec2>;
    const NAME: &'static str = "concentric_disk";
    const ANSWER: &'static str = "point";
    const TASK: &'static str = "Return the point of the unit disc that belongs to a point u of the unit square, so that equal areas of the square become equal areas of the disc, as Shirley and Chiu's concentric map makes them; another map that does so is right too. The answer is the list of the points for the n points u = (the fractional part of shift.x + (i + ½)/n, the fractional part of shift.y + 0.618034 · (i + ½)), with i from 0 to n − 1.";

    fn answer(q: &Self::Question) -> Self::Answer {
        q.points().map(disk::concentric_disk).collect()
    }
}

/// See [`Exercise::TASK`].
pub struct ThinLensRay;

row! {
    /// A camera with a lens, a place on its film and a point of its lens.
    pub struct ThinLensRayQuestion {
        /// The middle of the lens.
        pub lens_middle: Vec3,
        /// Where the camera looks.
        pub forward: Dir3,
        /// Along the rows of the picture.
        pub right: Dir3,
        /// Against the columns of the picture.
        pub up: Dir3,
        /// Of the lens.
        pub focal_length: f32,
        /// The focal length over the diameter of the aperture.
        pub f_number: f32,
        /// From the lens to the plane in focus.
        pub focus: f32,
        /// Width and height of the film.
        pub plane: Vec2,
        /// In [0, 1]², from the top left.
        pub film: Vec2,
        /// In the unit disc: (1, 0) is the edge of the aperture on the camera's right, (0, 1) its upper edge.
        pub on_lens: Vec2,
    }
}

impl ThinLensRayQuestion {
    /// Its lens, as it stands.
    pub fn lens(&self) -> Lens {
        Lens {
            focal_length: self.focal_length,
            f_number: self.f_number,
            focus: self.focus,
        }
    }
}

impl Exercise for ThinLensRay {
    type Question = ThinLensRayQuestion;
    type Answer = CameraRayAnswer;
    const NAME: &'static str = "thin_lens_ray";
    const TASK: &'static str = "Return the ray that starts at the point `on_lens` of the aperture, whose diameter is focal_length/f_number, and meets what the place `film` shows sharply: the point where the ray through the middle of the lens meets the plane at the distance `focus` along `forward`. The film is f·s/(s − f) from the lens, f the focal length and s the focus, which is larger than f; as in camera_ray, think of it in front of the lens, with film (0, 0) at its top left and (1, 1) at its bottom right.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let body = Pinhole {
            focal_point: q.lens_middle,
            forward: q.forward,
            right: q.right,
            up: q.up,
            focal_length: q.focal_length,
            plane: q.plane,
        };
        let camera = ThinLens::new(&body, q.f_number, q.focus, Aperture::Round);
        camera.map_or_else(
            |_| body.ray_through(q.film).into(),
            |camera| camera.ray_through(q.film, q.on_lens).into(),
        )
    }
}

/// See [`Exercise::TASK`].
pub struct CircleOfConfusion;

row! {
    /// A lens and a distance.
    pub struct CircleOfConfusionQuestion {
        /// Of the lens, in metres.
        pub focal_length: f32,
        /// The focal length over the diameter of the aperture.
        pub f_number: f32,
        /// From the lens to the plane in focus, in metres.
        pub focus: f32,
        /// From the lens to the point, along the axis, in metres.
        pub distance: f32,
    }
}

impl CircleOfConfusionQuestion {
    /// Its lens, as it stands.
    pub fn lens(&self) -> Lens {
        Lens {
            focal_length: self.focal_length,
            f_number: self.f_number,
            focus: self.focus,
        }
    }
}

impl Exercise for CircleOfConfusion {
    type Question = CircleOfConfusionQuestion;
    type Answer = f32;
    const NAME: &'static str = "circle_of_confusion";
    const ANSWER: &'static str = "diameter";
    const TASK: &'static str = "Return the diameter, in metres, of the disc on the film that a point of light at a distance from a thin lens becomes, when the film is where the plane in focus is sharp and the aperture's diameter is focal_length/f_number; a star's distance is infinite.";

    fn answer(q: &Self::Question) -> Self::Answer {
        q.lens().circle_of_confusion(q.distance)
    }
}
