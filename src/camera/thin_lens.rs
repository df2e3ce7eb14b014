//! The thin-lens camera: the rays of a place on the film pass through all points of a lens, and meet in the plane in focus.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let body = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, 0.050, 1.0)?;
//! let camera = ThinLens::new(&body, 2.0, 3.0, Aperture::Round)?;
//! // Through two points of the lens, the rays of one place on the film meet in the plane in focus.
//! let [a, b] = [-Vec2::X, Vec2::X].map(|lens| camera.refracted(vec2(0.7, 0.4), lens));
//! let in_focus = |ray: Ray| ray.at(-3.0 / ray.direction.z);
//! assert!(a.origin.distance(b.origin) > 0.02);
//! assert!(in_focus(a).distance(in_focus(b)) < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::camera::lens::{Lens, LensError};
use crate::camera::{Camera, aperture::Aperture, pinhole::Pinhole};
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec2, Vec3, vec2};

/// A lens in front of a film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinLens {
    /// The pin-hole camera with the same view: the hole is the middle of the lens, the image plane is the film.
    pub view: Pinhole,
    /// The lens.
    pub lens: Lens,
    /// The shape of the lens' opening.
    pub aperture: Aperture,
}

/// The arrival on the film of light from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// The place on the film, in [0, 1]² as for [`Camera::ray`], or outside [0, 1]² if the light misses the film.
    pub film: Vec2,
    /// (d/x)²/cos θ: area on the film over area at the light's point, perpendicular to the ray, for one point of the lens.
    pub magnified: f32,
    /// The ray from the point of the lens to the point that the light comes from.
    pub ray: Ray,
    /// The distance between these two points, in metres.
    pub distance: f32,
}

impl ThinLens {
    /// The pin-hole camera `body`, with a lens instead of its hole.
    ///
    /// The pin-hole's focal length becomes that of the lens. The film keeps its size, and is f s/(s − f) behind the lens, so that
    /// the plane at the distance s = `focus` (in metres) is sharp. So the view gets narrower when the focus comes nearer, as with
    /// a real lens that is moved as a whole.
    ///
    /// # Errors
    /// As for [`Lens::new`].
    pub fn new(
        body: &Pinhole,
        f_number: f32,
        focus: f32,
        aperture: Aperture,
    ) -> Result<Self, LensError> {
        let lens = Lens::new(body.focal_length, f_number, focus)?;
        let view = Pinhole {
            focal_length: lens.film_distance(),
            ..*body
        };
        Ok(Self {
            view,
            lens,
            aperture,
        })
    }

    /// A camera with the view of the pin-hole camera `view`, through an aperture of the given `diameter`, in metres.
    ///
    /// The film stays at the distance d behind the lens, and f = d s/(d + s) follows from the thin-lens equation.
    ///
    /// # Errors
    /// If the diameter is not finite or below 0, or the focus is not finite and above 0; else as for [`Lens::new`].
    pub fn with_view(
        view: &Pinhole,
        diameter: f32,
        focus: f32,
        aperture: Aperture,
    ) -> Result<Self, LensError> {
        if !(diameter >= 0.0 && diameter.is_finite()) {
            return Err(LensError::Diameter(diameter));
        }
        if !(focus > 0.0 && focus.is_finite()) {
            return Err(LensError::Plane(focus));
        }
        let film = view.focal_length;
        let focal_length = film * focus / (film + focus);
        Ok(Self {
            view: *view,
            lens: Lens::new(focal_length, focal_length / diameter, focus)?,
            aperture,
        })
    }

    // ANCHOR: thin_lens_ray
    /// The ray into which a point of the lens refracts light from a place on the film; `film` as for [`Camera::ray`].
    ///
    /// The ray through the middle of the lens goes straight on, as through a pin-hole. It meets the plane in focus, at the
    /// distance s along `forward`, at t = s/cos θ. All rays from the same place on the film meet there. `on_lens` is in the unit
    /// disc: (1, 0) is the edge of the lens on the camera's right, A/2 from the middle.
    pub fn refracted(&self, film: Vec2, on_lens: Vec2) -> Ray {
        let Pinhole {
            forward, right, up, ..
        } = self.view;
        let central = self.view.central_ray(film);
        let in_focus = central.at(self.lens.focus / central.direction.dot(*forward));
        let radius = 0.5 * self.lens.aperture();
        let origin = central.origin + radius * (on_lens.x * *right + on_lens.y * *up);
        Ray::new(origin, Dir3::new_or(in_focus - origin, forward))
    }
    // ANCHOR_END: thin_lens_ray

    // ANCHOR: arrival
    /// The place on the film where light from p arrives through a point of the lens: the inverse of [`ThinLens::refracted`].
    ///
    /// `None` if p is behind the lens.
    pub fn arrival(&self, p: Vec3, on_lens: Vec2) -> Option<Arrival> {
        let Pinhole {
            focal_point,
            forward,
            right,
            up,
            focal_length,
            plane,
        } = self.view;
        let radius = 0.5 * self.lens.aperture();
        let origin = focal_point + radius * (on_lens.x * *right + on_lens.y * *up);
        let toward = p - origin;
        let x = toward.dot(*forward);
        let direction = Dir3::new(toward).filter(|_| x > 0.0)?;
        let in_focus = origin + toward * (self.lens.focus / x) - focal_point;
        let on_film =
            focal_length / self.lens.focus * vec2(in_focus.dot(*right), -in_focus.dot(*up));
        Some(Arrival {
            film: 0.5 + on_film / plane,
            magnified: (focal_length / x).powi(2) / direction.dot(*forward),
            ray: Ray::new(origin, direction),
            distance: toward.length(),
        })
    }
    // ANCHOR_END: arrival
}

impl Camera for ThinLens {
    fn ray(&self, film: Vec2, lens: Vec2) -> Ray {
        self.refracted(film, self.aperture.point(lens))
    }

    fn central_ray(&self, film: Vec2) -> Ray {
        self.view.central_ray(film)
    }

    fn has_lens(&self) -> bool {
        true
    }
}
