//! Chapter 19: `concentric_disk`, `thin_lens_ray`, `circle_of_confusion`.

use crate::exercise::exercises;
use crate::exercises::ch01_rays::CameraRayAnswer;
use glam::{Vec2, Vec3, vec2};
use raybook::camera::Camera;
use raybook::camera::aperture::Aperture;
use raybook::camera::lens::Lens;
use raybook::camera::pinhole::Pinhole;
use raybook::camera::thin_lens::ThinLens;
use raybook::math::dir3::Dir3;
use raybook::sample::disk;

exercises! { ($) ch19_depth_of_field
    /// Map points of the unit square to the unit disc so that equal areas become equal areas, as Shirley and Chiu's
    /// concentric map does; another such map is right too. With i from 0 to n − 1 the points are the fractional parts
    /// of u = (shift.x + (i + ½)/n, shift.y + 0.618034 · (i + ½)).
    ConcentricDisk: concentric_disk(
        /// The number of points of the unit square.
        n: u32,
        /// By how much all points are moved (one that leaves the square comes in on the other side),
        shift: Vec2 [from -1 to 1],
    ) -> (
        /// The n points of the unit disc, one for each u.
        point: Vec<Vec2>,
    ) |q| {
        q.points().map(disk::concentric_disk).collect()
    }

    /// Return the ray from the point `on_lens` of the aperture, whose diameter is focal_length/f_number, to the point
    /// that the place `film` shows sharply. That is where the ray from the middle of the lens through `film` meets the
    /// plane at the distance `focus` along `forward`.
    ThinLensRay: thin_lens_ray(
        /// The middle of the lens, in metres.
        lens_middle: Vec3,
        /// Where the camera looks; perpendicular to `right` and `up`.
        forward: Dir3,
        /// To the right along the rows of the picture.
        right: Dir3,
        /// Upwards along the columns of the picture.
        up: Dir3,
        /// The focal length of the lens, in metres.
        focal_length: f32,
        /// The focal length over the diameter of the aperture, without a unit.
        f_number: f32,
        /// The distance from the lens to the plane in focus, in metres.
        focus: f32,
        /// The width and the height of the film, in metres. The film is at the distance f·s/(s − f) in front of the
        /// lens, as in camera_ray, with the focal length f and the focus s > f.
        plane: Vec2,
        /// The place on the film, in [0, 1]² from the top left, without a unit.
        film: Vec2,
        /// The point of the aperture, in the unit disc: (1, 0) is its edge on the camera's right, (0, 1) its
        /// upper edge.
        on_lens: Vec2,
    ) -> (
        /// The ray from that point.
        answer: CameraRayAnswer,
    ) {
        let body = Pinhole {
            focal_point: lens_middle,
            forward,
            right,
            up,
            focal_length,
            plane,
        };
        let camera = ThinLens::new(&body, f_number, focus, Aperture::Round);
        camera.map_or_else(
            |_| body.central_ray(film).into(),
            |camera| camera.refracted(film, on_lens).into(),
        )
    }

    /// Return the diameter, in metres, of the disc on the film that a thin lens makes of a point of light at the given
    /// distance. The film is where the plane in focus is sharp, and the aperture's diameter is focal_length/f_number. A
    /// star's distance is infinite.
    CircleOfConfusion: circle_of_confusion(
        /// The focal length of the lens, in metres.
        focal_length: f32,
        /// The focal length over the diameter of the aperture, without a unit.
        f_number: f32,
        /// The distance from the lens to the plane in focus, in metres.
        focus: f32,
        /// The distance from the lens to the point along the axis, in metres; inf for a star.
        distance: f32,
    ) -> (
        /// The diameter of the disc on the film, in metres.
        diameter: f32,
    ) |q| {
        q.lens().circle_of_confusion(q.distance)
    }
}

impl ConcentricDisk {
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

impl ThinLensRay {
    /// Its lens, as it stands.
    pub fn lens(&self) -> Lens {
        Lens {
            focal_length: self.focal_length,
            f_number: self.f_number,
            focus: self.focus,
        }
    }
}

impl CircleOfConfusion {
    /// Its lens, as it stands.
    pub fn lens(&self) -> Lens {
        Lens {
            focal_length: self.focal_length,
            f_number: self.f_number,
            focus: self.focus,
        }
    }
}
