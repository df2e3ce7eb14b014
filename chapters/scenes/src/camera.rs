//! The camera.

use crate::fields::Fields;
use crate::wrong::TextError;
use glam::Vec3;
use raybook::camera::Camera;
use raybook::camera::aperture::Aperture;
use raybook::camera::fisheye::{Fisheye, Projection};
use raybook::camera::panorama::Panorama;
use raybook::camera::pinhole::{Pinhole, focal_length};
use raybook::camera::pose::Pose;
use raybook::camera::thin_lens::ThinLens;
use raybook::math::domain::LARGEST;

/// The angle by which an aperture of blades is turned, in radians: no blade lies along the film's edge.
const TURN: f32 = 0.3;

/// Where a camera stands and looks, and the shape of its picture.
struct View {
    from: Vec3,
    to: Vec3,
    up: Vec3,
    aspect: f32,
}

impl View {
    /// A pin-hole of a focal length in metres.
    fn pinhole(&self, fields: &Fields, length: f32) -> Result<Pinhole, TextError> {
        Pinhole::look_at(self.from, self.to, self.up, length, self.aspect)
            .map_err(|error| fields.wrong("to_m", error.to_string()))
    }

    /// For a camera whose directions do not come from a focal length.
    fn pose(&self, fields: &Fields) -> Result<Pose, TextError> {
        self.pinhole(fields, 1.0).map(Pose::from)
    }
}

/// A camera of a table of its kind.
type Make = fn(&Fields, &View) -> Result<Box<dyn Camera>, TextError>;

/// The kinds by their words.
const KINDS: [(&str, Make); 3] = [("lens", lens), ("panorama", panorama), ("fisheye", fisheye)];

pub(crate) fn camera(fields: Fields, aspect: f32) -> Result<Box<dyn Camera>, TextError> {
    let view = View {
        from: fields.need("from_m", Fields::place)?,
        to: fields.need("to_m", Fields::place)?,
        up: fields.direction("up")?.map_or(Vec3::Y, |up| *up),
        aspect,
    };
    let camera = fields.choice("kind", &KINDS)?.unwrap_or(lens)(&fields, &view)?;
    fields.finish()?;
    Ok(camera)
}

fn panorama(fields: &Fields, view: &View) -> Result<Box<dyn Camera>, TextError> {
    let pose = view.pose(fields)?;
    Ok(Box::new(Panorama { pose }))
}

/// The projections of a fisheye by their words.
const PROJECTIONS: [(&str, Projection); 4] = [
    ("equidistant", Projection::Equidistant),
    ("equisolid", Projection::Equisolid),
    ("stereographic", Projection::Stereographic),
    ("orthographic", Projection::Orthographic),
];

fn fisheye(fields: &Fields, view: &View) -> Result<Box<dyn Camera>, TextError> {
    let projection = fields.choice("projection", &PROJECTIONS)?;
    let projection = projection.unwrap_or(Projection::Equidistant);
    let degrees = fields.number("view_degrees", 0.01..=360.0)?;
    let camera = Fisheye::new(
        view.pose(fields)?,
        projection,
        degrees.unwrap_or(180.0),
        view.aspect,
    );
    let camera = camera.map_err(|error| fields.wrong("view_degrees", error.to_string()))?;
    Ok(Box::new(camera))
}

/// The focal length, in metres.
fn length(fields: &Fields) -> Result<f32, TextError> {
    let angle = fields.number("view_height_degrees", 0.01..=175.0)?;
    let length = fields.number("focal_length_mm", 0.1..=100_000.0)?;
    match (angle, length) {
        (Some(_), Some(_)) => Err(fields.wrong(
            "focal_length_mm",
            "the view is given twice; keep `view_height_degrees` or `focal_length_mm`",
        )),
        (Some(angle), None) => Ok(focal_length(angle)),
        (None, Some(length)) => Ok(length / 1000.0),
        (None, None) => Ok(focal_length(40.0)),
    }
}

/// A pin-hole, or a lens where its diameter or its f-number is given.
fn lens(fields: &Fields, view: &View) -> Result<Box<dyn Camera>, TextError> {
    let pinhole = view.pinhole(fields, length(fields)?)?;
    let diameter = fields.number("lens_diameter_m", 1e-6..=1e6)?;
    let f_number = fields.number("f_number", 0.1..=1000.0)?;
    if diameter.is_some() && f_number.is_some() {
        let message = "the lens is given twice; keep `lens_diameter_m` or `f_number`";
        return Err(fields.wrong("f_number", message));
    }
    let focus = fields.number("focus_m", 1e-6..=LARGEST)?;
    let blades = fields.whole("blades", 3..=64)?;
    let opening = f_number.map(|n| pinhole.focal_length / n);
    let Some(diameter) = diameter.or(opening) else {
        if focus.is_none() && blades.is_none() {
            return Ok(Box::new(pinhole));
        }
        let lens = if focus.is_some() { "focus_m" } else { "blades" };
        let message = "only a lens has this; give `lens_diameter_m` or `f_number` too";
        return Err(fields.wrong(lens, message));
    };
    let far = view.from.distance(view.to);
    let aperture = match blades {
        Some(count) => Aperture::Blades {
            count: count as u32,
            turn: TURN,
        },
        None => Aperture::Round,
    };
    let lens = ThinLens::with_view(&pinhole, diameter, focus.unwrap_or(far), aperture);
    let lens = lens.map_err(|error| fields.wrong("focus_m", error.to_string()))?;
    Ok(Box::new(lens))
}
