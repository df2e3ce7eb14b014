//! `circle_of_confusion`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Verdict, judge, sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch19_depth_of_field::CircleOfConfusion;

/// What is asked of a question here.
pub(super) trait Blur {
    /// How large the film shows the plane in focus.
    fn magnification(&self) -> f32;
}

impl Blur for CircleOfConfusion {
    fn magnification(&self) -> f32 {
        self.lens().film_distance() / self.focus
    }
}

impl Graded for CircleOfConfusion {
    fn random(rng: &mut Pcg) -> CircleOfConfusion {
        let focal_length = sample::number(rng, 0.02, 0.2);
        let focus = focal_length * sample::number(rng, 3.0, 40.0);
        let near = sample::number(rng, 0.4, 0.9);
        let far = sample::number(rng, 1.1, 8.0);
        let side = sample::number(rng, 0.0, 1.0);
        CircleOfConfusion {
            focal_length,
            f_number: sample::number(rng, 1.2, 16.0),
            focus,
            distance: focus * if side < 0.5 { near } else { far },
        }
    }

    /// By its size, and near the focus, where it is a small difference of distances, by the aperture's.
    fn is_sound(q: &CircleOfConfusion) -> bool {
        q.focus > q.focal_length
    }

    fn judge(q: &CircleOfConfusion, golden: &f32, got: &f32) -> Verdict {
        /// Who goes by where the points are sharp subtracts two nearly equal distances: a few roundings, 6e-8 each, of f.
        const OF_APERTURE: f32 = 1e-6;
        let tolerance = judge::RELATIVE * golden + OF_APERTURE * q.lens().aperture();
        let mm = |metres: f32| 1e3 * metres;
        judge::number_within("the diameter", "mm", mm(*golden), mm(*got), mm(tolerance))
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "is negative on the near side of the focus",
            hint: "What is nearer than the focus is blurred too: can a diameter be negative?",
            answer: |q| (1.0 - q.focus / q.distance) * q.lens().aperture() * q.magnification(),
        },
        Mistake {
            name: "is negative on the far side of the focus",
            hint: "What is beyond the focus is blurred too: can a diameter be negative?",
            answer: |q| (q.focus / q.distance - 1.0) * q.lens().aperture() * q.magnification(),
        },
        Mistake {
            name: "returns 0 on the far side of the focus",
            hint: "What is behind the plane in focus is not sharp either: what becomes of a negative difference?",
            answer: |q| {
                if q.distance > q.focus {
                    0.0
                } else {
                    CircleOfConfusion::right(q)
                }
            },
        },
        Mistake {
            name: "returns 0 on the near side of the focus",
            hint: "What is before the plane in focus is not sharp either: what becomes of a negative difference?",
            answer: |q| {
                if q.distance < q.focus {
                    0.0
                } else {
                    CircleOfConfusion::right(q)
                }
            },
        },
        Mistake {
            name: "returns the radius",
            hint: "How much of the disc's diameter lies between its middle and its edge?",
            answer: |q| 0.5 * Self::right(q),
        },
        Mistake {
            name: "exchanges the distance and the focus, or divides by the film's distance instead of that at which the point is sharp",
            hint: "Which of the two distances says where the film is? And where is the tip of the cone that is cut by the film?",
            answer: |q| {
                // As a limit, which a star has too.
                let sharp = (1.0 - q.focus / q.distance) / (1.0 - q.focal_length / q.distance);
                (q.lens().aperture() * sharp * q.focal_length / q.focus).abs()
            },
        },
        Mistake {
            name: "multiplies by the f-number",
            hint: "Is the aperture wider at f/2 or at f/16?",
            answer: |q| Self::misread(q, |q| q.f_number = 1.0 / q.f_number),
        },
        Mistake {
            name: "takes the focal length for the aperture",
            hint: "What does the f-number say about your lens?",
            answer: |q| Self::misread(q, |q| q.f_number = 1.0),
        },
        Mistake {
            name: "takes the focal length for the film's distance in the magnification",
            hint: "Where is the film when the focus is near?",
            answer: |q| Self::right(q) / q.magnification() * (q.focal_length / q.focus),
        },
        Mistake {
            name: "returns the size in the plane in focus",
            hint: "How large does the film show what is 1 m wide in the plane in focus?",
            answer: |q| Self::right(q) / q.magnification(),
        },
        Mistake {
            name: "divides by the focus instead of the distance",
            hint: "Draw the cone from the point to the edge of the lens: how far from its tip is the lens?",
            answer: |q| {
                q.lens().aperture() * (q.distance / q.focus - 1.0).abs() * q.magnification()
            },
        },
        Mistake {
            name: "divides by the focus instead of the distance, but not for a star",
            hint: "Draw the cone from the point to the edge of the lens: how far from its tip is the lens? Does your formula for a star follow from the one for a point that is very far away?",
            answer: |q| {
                if q.distance.is_infinite() {
                    return Self::right(q);
                }
                q.lens().aperture() * (q.distance / q.focus - 1.0).abs() * q.magnification()
            },
        },
        Mistake {
            name: "divides by the focal length instead of the distance at which the point is sharp",
            hint: "Behind the lens, the cone's tip is where the point would be sharp: how far from the lens is that?",
            answer: |q| {
                let sharp = |x: f32| 1.0 / (1.0 / q.focal_length - 1.0 / x);
                let (film, tip) = (sharp(q.focus), sharp(q.distance));
                q.lens().aperture() * (film - tip).abs() / q.focal_length
            },
        },
        Mistake {
            name: "returns NaN for a star",
            hint: "What is ∞/∞? Try to divide before you subtract.",
            answer: |q| {
                if q.distance.is_finite() {
                    Self::right(q)
                } else {
                    f32::NAN
                }
            },
        },
        Mistake {
            name: "returns millimetres",
            hint: "By which factor are you off?",
            answer: |q| 1e3 * Self::right(q),
        },
        Mistake {
            name: "leaves the film at the focal length, focused at infinity",
            hint: "Where must the film be, if something near is to be sharp?",
            answer: |q| (q.focal_length * q.focal_length / (q.f_number * q.distance)).abs(),
        },
        Mistake {
            name: "returns 0 for a star",
            hint: "A star is far behind the plane in focus: is it sharp?",
            answer: |q| {
                if q.distance.is_infinite() {
                    0.0
                } else {
                    CircleOfConfusion::right(q)
                }
            },
        },
        Mistake {
            name: "returns infinity for a star",
            hint: "Go far away from the lens: does the disc on the film grow without end?",
            answer: |q| {
                if q.distance.is_infinite() {
                    f32::INFINITY
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes f·s/(s + f) for the distance of the film",
            hint: "Is your film farther from the lens than the focal length, or nearer?",
            answer: |q| {
                let film = q.focal_length * q.focus / (q.focus + q.focal_length);
                let sharp = 1.0 / q.focal_length - 1.0 / q.distance;
                q.lens().aperture() * (1.0 - film * sharp).abs()
            },
        },
        Mistake {
            name: "ignores the distance: blurs everything as much as a star",
            hint: "What is in focus is a point on the film: how large is it in your picture?",
            answer: |q| Self::misread(q, |q| q.distance = f32::INFINITY),
        },
        Mistake {
            name: "takes the film's distance over the f-number for the aperture",
            hint: "Does the opening of the lens change when you focus?",
            answer: |q| Self::right(q) * q.lens().film_distance() / q.focal_length,
        },
        Mistake {
            name: "takes f/s for the magnification of a star's disc, as if the film were at the focal length",
            hint: "A star and a very distant lamp make nearly the same disc: do yours?",
            answer: |q| {
                if q.distance.is_infinite() {
                    q.lens().aperture() * q.focal_length / q.focus
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "makes a star's disc as large as the opening of the lens",
            hint: "A star and a very distant lamp make nearly the same disc: do yours?",
            answer: |q| {
                if q.distance.is_infinite() {
                    q.lens().aperture()
                } else {
                    Self::right(q)
                }
            },
        },
    ];
}
