//! The numbers on a lens, and how it blurs a point that is out of focus.
//!
//! ```
//! use raybook::camera::lens::Lens;
//!
//! let lens = Lens::new(0.050, 2.0, 3.0)?; // 50 mm, f/2, focused at 3 m
//! assert_eq!(lens.aperture(), 0.025);
//! assert_eq!(lens.circle_of_confusion(3.0), 0.0); // sharp
//! assert!(lens.circle_of_confusion(f32::INFINITY) > 4e-4); // 0.42 mm: blurred
//! # Ok::<(), raybook::camera::lens::LensError>(())
//! ```

/// A thin lens: focal length, f-number and focus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// f: the distance behind the lens at which parallel light meets in a point, in metres.
    pub focal_length: f32,
    /// N: the focal length over the aperture's diameter; ∞ for a pin-hole.
    pub f_number: f32,
    /// s: the distance from the lens to the plane that is in focus, in metres.
    pub focus: f32,
}

/// Why a lens makes no picture.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LensError {
    /// The focal length is not a finite number above 0.
    #[error("a focal length of {0} m: it needs one above 0")]
    FocalLength(f32),
    /// The f-number is not above 0.
    #[error("an f-number of {0}: it needs one above 0")]
    FNumber(f32),
    /// The film would be infinitely far away, or in front of the lens.
    #[error(
        "a lens of {focal_length} m cannot focus at {focus} m: it needs a finite distance above its focal length"
    )]
    Focus {
        /// The focal length, in metres.
        focal_length: f32,
        /// The distance that was asked for, in metres.
        focus: f32,
    },
    /// The aperture's diameter is not a finite number, 0 or above.
    #[error("an aperture with a diameter of {0} m: it needs a finite one, 0 or above")]
    Diameter(f32),
    /// The plane in focus is not at a finite distance in front of the lens.
    #[error("a lens cannot focus at {0} m: it needs a finite distance above 0")]
    Plane(f32),
}

impl Lens {
    /// A lens of the focal length f, the f-number N and the focus s.
    ///
    /// # Errors
    /// If f is not finite and above 0, N is not above 0, or s is not finite and above f.
    pub fn new(focal_length: f32, f_number: f32, focus: f32) -> Result<Self, LensError> {
        if !(focal_length > 0.0 && focal_length.is_finite()) {
            return Err(LensError::FocalLength(focal_length));
        }
        if f_number.is_nan() || f_number <= 0.0 {
            return Err(LensError::FNumber(f_number));
        }
        if !(focus > focal_length && focus.is_finite()) {
            return Err(LensError::Focus {
                focal_length,
                focus,
            });
        }
        Ok(Self {
            focal_length,
            f_number,
            focus,
        })
    }

    /// A = f/N: the aperture's diameter, in metres.
    pub fn aperture(&self) -> f32 {
        self.focal_length / self.f_number
    }

    /// d = f s/(s − f): the distance from the lens to the film, in metres, by the thin-lens equation 1/d + 1/s = 1/f.
    pub fn film_distance(&self) -> f32 {
        self.focal_length * self.focus / (self.focus - self.focal_length)
    }

    // ANCHOR: circle_of_confusion
    /// c = A |x − s|/x · f/(s − f): the circle of confusion, the disc on the film that a point at the distance x becomes; c is
    /// its diameter in metres.
    ///
    /// The rays from the point to the aperture meet the plane in focus in a disc of the diameter A |x − s|/x. The film shows this
    /// plane f/(s − f) times as large. Both distances are in metres along the axis; x > 0 may be ∞.
    pub fn circle_of_confusion(&self, x: f32) -> f32 {
        let (f, s) = (self.focal_length, self.focus);
        self.aperture() * (1.0 - s / x).abs() * f / (s - f)
    }
    // ANCHOR_END: circle_of_confusion

    // ANCHOR: depth_of_field
    /// The depth of field: the nearest and the farthest distance, in metres, between which no circle of confusion is larger than
    /// c (in metres): x = s/(1 ± k), where k = c (s − f)/(A f).
    ///
    /// From k = 1 on, everything far away is sharp enough, and the farthest distance is ∞.
    pub fn depth_of_field(&self, c: f32) -> [f32; 2] {
        let (f, s) = (self.focal_length, self.focus);
        let k = c * (s - f) / (self.aperture() * f);
        let far = if k < 1.0 {
            s / (1.0 - k)
        } else {
            f32::INFINITY
        };
        [s / (1.0 + k), far]
    }
    // ANCHOR_END: depth_of_field

    /// f + A f/c: the hyperfocal distance, in metres: the nearest focus for which no point behind the focus has a circle of
    /// confusion larger than c (in metres).
    ///
    /// With this focus, everything from half of this distance on is sharp enough.
    pub fn hyperfocal(&self, c: f32) -> f32 {
        self.focal_length + self.aperture() * self.focal_length / c
    }
}
