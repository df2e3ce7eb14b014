//! The numbers on a lens, and what they make of a point that is out of focus.

/// A thin lens: focal length, f-number and focus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// f: where the lens unites the light of a star, in metres.
    pub focal_length: f32,
    /// N: the focal length over the aperture's diameter; ∞ for a pin-hole.
    pub f_number: f32,
    /// s: the distance from the lens to the plane that is in focus, in metres.
    pub focus: f32,
}

/// Why a lens makes no picture.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LensError {
    /// No lens has such a focal length.
    #[error("a focal length of {0} m: it needs one above 0")]
    FocalLength(f32),
    /// No aperture is so large.
    #[error("an f-number of {0}: it needs one above 0")]
    FNumber(f32),
    /// The film would be infinitely far away, or in front of the lens.
    #[error(
        "a lens of {focal_length} m cannot focus at {focus} m: it needs a finite distance above its focal length"
    )]
    Focus {
        /// The focal length.
        focal_length: f32,
        /// The distance that was asked for.
        focus: f32,
    },
}

impl Lens {
    /// A lens.
    ///
    /// # Errors
    /// If f or N is not above 0, or s is not finite and above f.
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

    /// f s/(s − f): how far behind the lens the film is, in metres, for 1/film + 1/s = 1/f (the thin-lens equation).
    pub fn film_distance(&self) -> f32 {
        self.focal_length * self.focus / (self.focus - self.focal_length)
    }

    // ANCHOR: circle_of_confusion
    /// c = A |x − s|/x · f/(s − f): the diameter, in metres, of the disc on the film that a point at the distance x becomes.
    ///
    /// Seen from the point, the aperture has the shadow A |x − s|/x in the plane in focus, and the film shows that plane
    /// f/(s − f) times as large. Both distances are measured along the axis; x may be ∞.
    pub fn circle_of_confusion(&self, x: f32) -> f32 {
        let (f, s) = (self.focal_length, self.focus);
        self.aperture() * (1.0 - s / x).abs() * f / (s - f)
    }
    // ANCHOR_END: circle_of_confusion

    // ANCHOR: depth_of_field
    /// The distances, in metres, between which no circle of confusion is larger than c: x = s/(1 ± k), where
    /// k = c (s − f)/(A f).
    ///
    /// From k = 1 on, all that is far away is sharp enough, and the second is ∞.
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

    /// f + A f/c: the nearest focus, in metres, for which no distant point has a circle of confusion larger than c.
    ///
    /// All is sharp enough then from half of it on.
    pub fn hyperfocal(&self, c: f32) -> f32 {
        self.focal_length + self.aperture() * self.focal_length / c
    }
}
