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

pub(crate) fn camera(fields: Fields, aspect: f32) -> Result<Box<dyn Camera>, TextError> {
    let from = fields.place("from_m")?;
    let (from, to) = (fields.need("from_m", from)?, fields.place("to_m")?);
    let to = fields.need("to_m", to)?;
    let up = fields.direction("up")?.map_or(Vec3::Y, |up| *up);
    let kind = fields.choice("kind", &["lens", "panorama", "fisheye"])?;
    let length = view(&fields, kind)?;
    let pinhole = Pinhole::look_at(from, to, up, length, aspect)
        .map_err(|error| fields.wrong("to_m", error.to_string()))?;
    let pose = Pose::from(pinhole);
    let camera: Box<dyn Camera> = match kind {
        Some("panorama") => Box::new(Panorama { pose }),
        Some("fisheye") => Box::new(fisheye(&fields, pose, aspect)?),
        _ => lens(&fields, &pinhole, from.distance(to))?,
    };
    fields.finish()?;
    Ok(camera)
}

/// The focal length of the view, in metres.
fn view(fields: &Fields, kind: Option<&str>) -> Result<f32, TextError> {
    if matches!(kind, Some("panorama" | "fisheye")) {
        return Ok(1.0);
    }
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

/// The projections of a fisheye by their words.
const PROJECTIONS: [(&str, Projection); 4] = [
    ("equidistant", Projection::Equidistant),
    ("equisolid", Projection::Equisolid),
    ("stereographic", Projection::Stereographic),
    ("orthographic", Projection::Orthographic),
];

fn fisheye(fields: &Fields, pose: Pose, aspect: f32) -> Result<Fisheye, TextError> {
    let chosen = fields.choice("projection", &PROJECTIONS.map(|(word, _)| word))?;
    let found = PROJECTIONS
        .into_iter()
        .find(|(word, _)| chosen == Some(word));
    let projection = found.map_or(Projection::Equidistant, |(_, projection)| projection);
    let view = fields
        .number("view_degrees", 0.01..=360.0)?
        .unwrap_or(180.0);
    Fisheye::new(pose, projection, view, aspect)
        .map_err(|error| fields.wrong("view_degrees", error.to_string()))
}

/// A pin-hole, or a lens where its diameter or its f-number is given.
fn lens(fields: &Fields, view: &Pinhole, far: f32) -> Result<Box<dyn Camera>, TextError> {
    let diameter = fields.number("lens_diameter_m", 1e-6..=1e6)?;
    let f_number = fields.number("f_number", 0.1..=1000.0)?;
    if diameter.is_some() && f_number.is_some() {
        let message = "the lens is given twice; keep `lens_diameter_m` or `f_number`";
        return Err(fields.wrong("f_number", message));
    }
    let focus = fields.number("focus_m", 1e-6..=LARGEST)?;
    let blades = fields.whole("blades", 3..=64)?;
    let opening = f_number.map(|n| view.focal_length / n);
    let Some(diameter) = diameter.or(opening) else {
        if focus.is_none() && blades.is_none() {
            return Ok(Box::new(*view));
        }
        let lens = if focus.is_some() { "focus_m" } else { "blades" };
        let message = "only a lens has this; give `lens_diameter_m` or `f_number` too";
        return Err(fields.wrong(lens, message));
    };
    let aperture = match blades {
        Some(count) => Aperture::Blades {
            count: count as u32,
            turn: 0.3,
        },
        None => Aperture::Round,
    };
    let lens = ThinLens::with_view(view, diameter, focus.unwrap_or(far), aperture);
    let lens = lens.map_err(|error| fields.wrong("focus_m", error.to_string()))?;
    Ok(Box::new(lens))
}
