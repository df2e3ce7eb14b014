//! One place through many cameras: pin holes of several widths, and fisheyes, with discs that show what they stretch.

use super::graticule;
use crate::kit::sheet::sheet;
use glam::Vec3;
use raybook::camera::Camera;
use raybook::camera::fisheye::{Fisheye, Projection};
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::camera::pose::Pose;
use raybook::image::Image;
use raybook::render::film::Film;
use std::error::Error;

/// A pin-hole camera of this horizontal field of view, in degrees.
///
/// # Errors
/// As [`Pinhole::look_at`].
pub(super) fn wide(
    from: Vec3,
    toward: Vec3,
    degrees: f32,
    aspect: f32,
) -> Result<Pinhole, LookAtError> {
    let camera = Pinhole::look_at(from, from + toward, Vec3::Y, 0.05, aspect)?;
    let focal_length = 0.5 * camera.plane.x / (0.5 * degrees.to_radians()).tan();
    Ok(Pinhole {
        focal_length,
        ..camera
    })
}

/// Pin-hole cameras of three widths.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn pinholes(
    film: &Film,
    from: Vec3,
    photograph: impl Fn(&Film, &dyn Camera) -> Image,
) -> Result<Image, Box<dyn Error>> {
    let mut tiles = Vec::new();
    for (name, degrees) in [("60° across", 60.0), ("100°", 100.0), ("150°", 150.0)] {
        let camera = wide(from, Vec3::NEG_Z, degrees, film.aspect())?;
        tiles.push((name, marked(&photograph(film, &camera), &camera)));
    }
    sheet(3, &tiles)
}

/// Half of all directions in the four projections; below, all directions or nearly all, looking ahead, down and up.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn fisheyes(
    film: &Film,
    from: Vec3,
    photograph: impl Fn(&Film, &dyn Camera) -> Image,
) -> Result<Image, Box<dyn Error>> {
    let (ahead, down, up) = (Vec3::NEG_Z, Vec3::NEG_Y, Vec3::Y);
    let views = [
        ("equidistant, 180°", Projection::Equidistant, 180.0, ahead),
        ("equisolid, 180°", Projection::Equisolid, 180.0, ahead),
        (
            "stereographic, 180°",
            Projection::Stereographic,
            180.0,
            ahead,
        ),
        ("orthographic, 180°", Projection::Orthographic, 180.0, ahead),
        ("equidistant, 360°", Projection::Equidistant, 360.0, ahead),
        ("equisolid, 360°", Projection::Equisolid, 360.0, ahead),
        (
            "down, stereographic, 290°",
            Projection::Stereographic,
            290.0,
            down,
        ),
        (
            "up, stereographic, 290°",
            Projection::Stereographic,
            290.0,
            up,
        ),
    ];
    let mut tiles = Vec::new();
    for (name, projection, view, toward) in views {
        // In a view downwards, "ahead" is above the middle; in a view upwards, below.
        let above = if toward == ahead {
            Vec3::Y
        } else {
            -toward.y * Vec3::NEG_Z
        };
        let stand = Pinhole::look_at(from, from + toward, above, 1.0, 1.0)?;
        let camera = Fisheye::new(Pose::from(stand), projection, view, film.aspect())?;
        tiles.push((name, marked(&photograph(film, &camera), &camera)));
    }
    sheet(4, &tiles)
}

fn marked(picture: &Image, camera: &dyn Camera) -> Image {
    let direction = |place| camera.central_ray(place).direction;
    graticule::over(picture, |place| {
        camera.sees(place).then(|| direction(place))
    })
}
