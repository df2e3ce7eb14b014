//! `camera_ray`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Picture, Relation, Verdict, judge, sample};
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{basis::Basis, dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch01_rays::{CameraRay, CameraRayAnswer};

impl Graded for CameraRay {
    fn random(rng: &mut Pcg) -> CameraRay {
        let film = vec2(sample::number(rng, 0.0, 1.0), sample::number(rng, 0.0, 1.0));
        question(
            sample::point(rng, 5.0),
            sample::direction(rng),
            sample::number(rng, 0.02, 0.1),
            vec2(
                sample::number(rng, 0.01, 0.06),
                sample::number(rng, 0.01, 0.06),
            ),
            film,
        )
    }

    fn is_sound(q: &CameraRay) -> bool {
        sample::are_axes([q.forward, q.right, q.up])
    }

    fn judge(_q: &CameraRay, golden: &CameraRayAnswer, got: &CameraRayAnswer) -> Verdict {
        judge::point("the ray's origin", golden.origin, got.origin)?;
        judge::direction("the ray's direction", golden.direction, got.direction)
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| CameraRay {
        focal_point: q.focal_point + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "draws the picture upside down",
            hint: "film (0, 0) is the top left: does your y grow upwards or downwards on the film?",
            answer: |q| Self::misread(q, |q| q.film.y = 1.0 - q.film.y),
        },
        Mistake {
            name: "draws the picture mirrored",
            hint: "A place on the right of the film is on the camera's right.",
            answer: |q| Self::misread(q, |q| q.film.x = 1.0 - q.film.x),
        },
        Mistake {
            name: "turns the picture by 180°, upside down and mirrored",
            hint: "A place to the right of the film's middle is on the camera's right, and a place above it is upwards: which signs do `right` and `up` have in your direction?",
            answer: |q| Self::misread(q, |q| q.film = 1.0 - q.film),
        },
        Mistake {
            name: "ignores the focal length",
            hint: "Move the image plane further away: should the view get wider or narrower?",
            answer: |q| Self::misread(q, |q| q.focal_length = 1.0),
        },
        Mistake {
            name: "takes the plane to be twice as large",
            hint: "How much of the plane's width lies between its middle and its edge?",
            answer: |q| Self::misread(q, |q| q.plane *= 2.0),
        },
        Mistake {
            name: "measures from the plane's corner instead of its middle",
            hint: "Which place of the film lies straight ahead?",
            answer: |q| Self::misread(q, |q| q.film += vec2(0.5, -0.5)),
        },
        Mistake {
            name: "begins a whole width and height from the plane's middle, not half of them",
            hint: "How far is it from the middle of the plane to its corner, along each axis?",
            answer: |q| Self::misread(q, |q| q.film -= vec2(0.5, 0.5)),
        },
        Mistake {
            name: "takes the world's axes for the camera's",
            hint: "A camera that looks along +x: in which direction of the world does it look, and where is its right?",
            answer: |q| {
                Self::misread(q, |q| {
                    (q.right, q.up, q.forward) = (Dir3::X, Dir3::Y, -Dir3::Z);
                })
            },
        },
        Mistake {
            name: "ignores the size of the plane",
            hint: "A place on the film is a fraction: of what length?",
            answer: |q| Self::misread(q, |q| q.plane = Vec2::ONE),
        },
        Mistake {
            name: "looks backwards",
            hint: "Is the plane in front of the focal point?",
            answer: |q| Self::misread(q, |q| q.forward = -q.forward),
        },
        Mistake {
            name: "starts at the image plane",
            hint: "All rays of a pin-hole camera pass through one point: which?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = CameraRay::right(q);
                let to_plane = q.focal_length / direction.dot(*q.forward);
                CameraRayAnswer {
                    origin: origin + to_plane * direction,
                    direction,
                }
            },
        },
        Mistake {
            name: "forgets to normalise the direction",
            hint: "If t is to be a distance, how long must the direction be?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = CameraRay::right(q);
                CameraRayAnswer {
                    origin,
                    direction: q.focal_length / direction.dot(*q.forward) * direction,
                }
            },
        },
        Mistake {
            name: "confuses right and up",
            hint: "Along which of the camera's directions does film.x run?",
            answer: |q| Self::misread(q, |q| std::mem::swap(&mut q.right, &mut q.up)),
        },
        Mistake {
            name: "exchanges the plane's width and height",
            hint: "Make the picture twice as wide: does the view get wider or higher?",
            answer: |q| Self::misread(q, |q| q.plane = vec2(q.plane.y, q.plane.x)),
        },
        Mistake {
            name: "adds the focal point to the direction",
            hint: "A direction is the way from one point to another: is yours a way, or a point?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = CameraRay::right(q);
                let to_place = q.focal_length / direction.dot(*q.forward);
                CameraRayAnswer {
                    origin,
                    direction: (origin + to_place * direction).normalize_or_zero(),
                }
            },
        },
        Mistake {
            name: "measures the place on the film from the middle, although it is counted from the top left",
            hint: "Where on the plane is film = (0, 0), and where does your ray go for it?",
            answer: |q| Self::misread(q, |q| q.film += 0.5),
        },
        Mistake {
            name: "subtracts half of the plane's size, in metres, from film, which is a fraction",
            hint: "`film` goes from 0 to 1: how many metres of the plane is that?",
            answer: |q| Self::misread(q, |q| q.film /= q.plane),
        },
        Mistake {
            name: "multiplies the plane's width by the ratio of width to height, which it has already",
            hint: "The plane is as wide as plane.x says: what is left for the ratio of the picture's sides to do?",
            answer: |q| Self::misread(q, |q| q.plane.x *= q.plane.x / q.plane.y),
        },
        Mistake {
            name: "divides the angle of view evenly, not the image plane",
            hint: "The pixels are squares side by side on a plane: are the angles between their rays all alike?",
            answer: |q| {
                Self::misread(q, |q| {
                    let half = 0.5 * q.plane / q.focal_length;
                    let turned = (2.0 * (q.film - 0.5) * half.map(f32::atan)).map(f32::tan);
                    q.film = 0.5 + 0.5 * turned / half;
                })
            },
        },
        Mistake {
            name: "turns the direction from the world into the camera, not from the camera into the world",
            hint: "Your three numbers right, up and forward belong to three vectors of the world: are these the rows or the columns of your matrix?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = CameraRay::right(q);
                let axes = [*q.right, *q.up, -*q.forward];
                let [x, y, z] = axes.map(|axis| axis.dot(direction));
                let local = vec3(x, y, z);
                let [x, y, z] = axes.map(|axis| axis.dot(local));
                CameraRayAnswer {
                    origin,
                    direction: vec3(x, y, z),
                }
            },
        },
        Mistake {
            name: "makes `right` and `up` anew of the world's up, as if no camera could be rolled",
            hint: "Lay the camera on its side: which of the arguments tell you so?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.right = Dir3::new_or(q.forward.cross(Vec3::Y), q.right);
                    q.up = Dir3::new_or(q.right.cross(*q.forward), q.up);
                })
            },
        },
        Mistake {
            name: "puts the film on a sphere round the focal point, not on a plane",
            hint: "The focal length is the distance of the plane: how far from the focal point are its corners?",
            answer: |q| {
                Self::misread(q, |q| {
                    let place = (q.film - 0.5) * q.plane;
                    let square = q.focal_length * q.focal_length - place.length_squared();
                    q.focal_length = square.max(0.0).sqrt();
                })
            },
        },
        Mistake {
            name: "divides the plane's height by the ratio of width to height, which it has already",
            hint: "The plane is as high as plane.y says: what is left for the ratio of the picture's sides to do?",
            answer: |q| Self::misread(q, |q| q.plane.y *= q.plane.y / q.plane.x),
        },
        Mistake {
            name: "starts in the middle of the image plane",
            hint: "All rays of a pin-hole camera pass through one point: which?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = CameraRay::right(q);
                CameraRayAnswer {
                    origin: origin + q.focal_length * *q.forward,
                    direction,
                }
            },
        },
        Mistake {
            name: "multiplies the place on the plane by the focal length, where it should divide by it",
            hint: "Move the image plane further away: should the view get wider or narrower?",
            answer: |q| Self::misread(q, |q| q.focal_length = q.focal_length.recip()),
        },
        Mistake {
            name: "takes half of the angle of view for its tangent",
            hint: "Half of the plane's width over the focal length is a tangent: what is left for an arc tangent to do?",
            answer: |q| {
                Self::misread(q, |q| {
                    let half = 0.5 * q.plane / q.focal_length;
                    q.plane = 2.0 * q.focal_length * half.map(f32::atan);
                })
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "camera_ray",
        width: 96,
        height: 54,
        alt: "The direction of each pixel's ray as a colour",
        question: |x, y| {
            question(
                Vec3::ZERO,
                -Dir3::Z,
                0.024,
                vec2(0.036, 0.024),
                vec2((x as f32 + 0.5) / 96.0, (y as f32 + 0.5) / 54.0),
            )
        },
        colour: |_, ray| {
            Rgb::new(ray.direction.x, ray.direction.y, ray.direction.z).map(|v| 0.5 + 0.5 * v)
        },
    }];
}

/// A camera whose up is anything perpendicular to its view.
fn question(
    focal_point: Vec3,
    forward: Dir3,
    focal_length: f32,
    plane: Vec2,
    film: Vec2,
) -> CameraRay {
    let Basis { x: right, y, .. } = Basis::around(-forward);
    CameraRay {
        focal_point,
        forward,
        right,
        up: y,
        focal_length,
        plane,
        film,
    }
}
