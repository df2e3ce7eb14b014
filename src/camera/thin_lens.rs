//! The thin-lens camera: the rays of a place on the film pass through all of a lens, and meet in the plane in focus.

use crate::camera::lens::{Lens, LensError};
use crate::camera::{Camera, aperture::Aperture, pinhole::Pinhole};
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec2, Vec3, vec2};

/// A lens in front of a film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinLens {
    /// The pin-hole camera with the same view: its hole is the middle of the lens, its plane the film.
    pub view: Pinhole,
    /// The lens.
    pub lens: Lens,
    /// The shape of its opening.
    pub aperture: Aperture,
}

/// Where light from a point arrives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// The place on the film; `film` as for [`Camera::ray`], and outside [0, 1]² beside the film.
    pub film: Vec2,
    /// The area on the film per area of the point's surroundings that face the ray, for one point of the lens.
    pub magnified: f32,
    /// From the point of the lens to where the light comes from.
    pub ray: Ray,
    /// How far that is, in metres.
    pub distance: f32,
}

impl ThinLens {
    /// The camera that has a lens instead of a hole.
    ///
    /// The pin-hole's focal length becomes that of the lens. The film keeps its size, and is f s/(s − f) behind the lens, where
    /// what is s away is sharp. So the view gets narrower when the focus comes nearer, as with a real lens that moves as a
    /// whole.
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

    /// The camera that sees what a pin-hole camera sees, through a lens of this diameter, in metres.
    ///
    /// The film stays where it is, v behind the lens, and f = v s/(v + s) follows from the thin-lens equation.
    ///
    /// # Errors
    /// As for [`Lens::new`].
    pub fn with_view(
        view: &Pinhole,
        diameter: f32,
        focus: f32,
        aperture: Aperture,
    ) -> Result<Self, LensError> {
        let film = view.focal_length;
        let focal_length = film * focus / (film + focus);
        Ok(Self {
            view: *view,
            lens: Lens::new(focal_length, focal_length / diameter, focus)?,
            aperture,
        })
    }

    // ANCHOR: thin_lens_ray
    /// The ray from a point of the lens to what a place on the film shows sharply; `film` as for [`Camera::ray`].
    ///
    /// The ray through the middle of the lens goes straight on, as through a pin-hole, and meets the plane at the distance s
    /// along `forward`: at t = s/cos θ. There all rays from the same place of the film meet. `on_lens` is in the unit disc:
    /// (1, 0) is the lens' edge to the camera's right, A/2 from its middle.
    pub fn ray_through(&self, film: Vec2, on_lens: Vec2) -> Ray {
        let Pinhole {
            forward, right, up, ..
        } = self.view;
        let central = self.view.ray_through(film);
        let in_focus = central.at(self.lens.focus / central.direction.dot(*forward));
        let radius = 0.5 * self.lens.aperture();
        let origin = central.origin + radius * (on_lens.x * *right + on_lens.y * *up);
        Ray::new(origin, Dir3::new_or(in_focus - origin, forward))
    }
    // ANCHOR_END: thin_lens_ray

    // ANCHOR: arrival
    /// Where on the film light from p arrives through a point of the lens: [`ThinLens::ray_through`] backwards.
    ///
    /// `None` from behind the lens.
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
        self.ray_through(film, self.aperture.point(lens))
    }

    fn has_lens(&self) -> bool {
        true
    }
}
