//! Chapter 20: `panorama_ray`: its cases, judge and mistakes.

use crate::{Graded, Mistake, Picture, Verdict, judge, sample};
use glam::{Vec2, Vec3, vec2};
use raybook::math::{basis::Basis, dir3::Dir3, pcg::Pcg};
use raybook_chapters::kit::palette::direction as direction_colour;
use raybook_workbook::exercises::ch01_rays::CameraRayAnswer;
use raybook_workbook::exercises::ch20_panorama::PanoramaRay;
use std::f32::consts::{FRAC_PI_2, PI, TAU};

impl Graded for PanoramaRay {
    fn random(rng: &mut Pcg) -> PanoramaRay {
        let film = vec2(sample::number(rng, 0.0, 1.0), sample::number(rng, 0.0, 1.0));
        question(sample::point(rng, 5.0), sample::direction(rng), film)
    }

    /// Rays are compared, not angles: at the top and at the bottom every angle around is right.
    fn is_sound(q: &PanoramaRay) -> bool {
        sample::are_axes([q.forward, q.right, q.up])
    }

    fn judge(_q: &PanoramaRay, golden: &CameraRayAnswer, got: &CameraRayAnswer) -> Verdict {
        judge::point("the ray's origin", golden.origin, got.origin)?;
        judge::direction("the ray's direction", golden.direction, got.direction)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "draws the picture upside down",
            hint: "film (0, 0) is the top left: is the top edge of your picture the sky or the ground?",
            answer: |q| Self::misread(q, |q| q.film.y = 1.0 - q.film.y),
        },
        Mistake {
            name: "takes the angle from up for the angle above the horizon",
            hint: "At the top of the picture your angle is 0: is its sine, or its cosine, what goes with `up`?",
            answer: |q| along(q, TAU * (q.film.x - 0.5), FRAC_PI_2 - PI * q.film.y),
        },
        Mistake {
            name: "draws the picture mirrored",
            hint: "Turn your head from the middle of the picture to your right: does film.x grow or shrink?",
            answer: |q| Self::misread(q, |q| q.film.x = 1.0 - q.film.x),
        },
        Mistake {
            name: "looks backwards in the middle",
            hint: "For which film.x is the angle around `up` 0, and where in the picture is that place?",
            answer: |q| Self::misread(q, |q| q.film.x += 0.5),
        },
        Mistake {
            name: "has right in the middle",
            hint: "Which of the camera's axes do you get where the angle around `up` is 0?",
            answer: |q| Self::misread(q, |q| q.film.x += 0.25),
        },
        Mistake {
            name: "sees half of the way around only",
            hint: "From the left edge of the picture to its right edge you turn once around: by which angle?",
            answer: |q| Self::misread(q, |q| q.film.x = 0.25 + 0.5 * q.film.x),
        },
        Mistake {
            name: "lets the angle from up grow to 2π at the bottom edge",
            hint: "What is the angle between straight up and straight down?",
            answer: |q| along(q, TAU * (q.film.x - 0.5), TAU * q.film.y),
        },
        Mistake {
            name: "counts the angle from the horizon",
            hint: "Your angle is 0 at the top edge: which direction must that be, and which do you return?",
            answer: |q| along(q, TAU * (q.film.x - 0.5), PI * q.film.y + 0.5 * PI),
        },
        Mistake {
            name: "lets the height fall evenly down the picture, not the angle grow",
            hint: "A quarter of the way down the picture the direction is 45 degrees high: how high is yours?",
            answer: |q| along(q, TAU * (q.film.x - 0.5), (1.0 - 2.0 * q.film.y).acos()),
        },
        Mistake {
            name: "makes every circle of latitude as large as the horizon",
            hint: "How long is your direction halfway up the sky? Near the zenith the circle that you walk around is small.",
            answer: |q| {
                let (sin, cos) = (TAU * (q.film.x - 0.5)).sin_cos();
                let up = (PI * q.film.y).cos() * *q.up;
                ray(q, cos * *q.forward + sin * *q.right + up)
            },
        },
        Mistake {
            name: "calculates the angle from up and the angle around it in degrees",
            hint: "In which unit does your sine expect its angle?",
            answer: |q| along(q, 360.0 * (q.film.x - 0.5), 180.0 * q.film.y),
        },
        Mistake {
            name: "looks along the world's axes",
            hint: "Turn the camera: does your direction turn with it?",
            answer: |q| {
                Self::misread(q, |q| {
                    (q.forward, q.right, q.up) = (-Dir3::Z, Dir3::X, Dir3::Y);
                })
            },
        },
        Mistake {
            name: "rises along the world's +y, not along the camera's up",
            hint: "Tilt the camera: is straight up for the camera still +y? And how long is the sum of two directions that are not perpendicular?",
            answer: |q| {
                let level = along(q, TAU * (q.film.x - 0.5), 0.5 * PI).direction;
                let (sin, cos) = (PI * q.film.y).sin_cos();
                ray(q, sin * level + cos * Vec3::Y)
            },
        },
        Mistake {
            name: "confuses up and forward",
            hint: "Around which of the camera's axes does the picture go from left to right?",
            answer: |q| Self::misread(q, |q| std::mem::swap(&mut q.up, &mut q.forward)),
        },
        Mistake {
            name: "leaves out a narrow strip at each edge of the picture",
            hint: "The left edge and the right edge of the picture are one direction; where are the top and the bottom?",
            answer: |q| Self::misread(q, |q| q.film = 0.01 + 0.98 * q.film),
        },
        Mistake {
            name: "starts on a sphere around the position",
            hint: "Where do the rays of this camera meet? That is where they start.",
            answer: |q| {
                let right = Self::right(q);
                CameraRayAnswer {
                    origin: right.origin + right.direction,
                    ..right
                }
            },
        },
        Mistake {
            name: "wraps the film round a cylinder",
            hint: "A row of the film is an angle, not a height: is the pole seen anywhere?",
            answer: |q| {
                ray(
                    q,
                    (along(q, TAU * (q.film.x - 0.5), 0.5 * PI).direction
                        + (1.0 - 2.0 * q.film.y) * *q.up)
                        .normalize(),
                )
            },
        },
        Mistake {
            name: "lets the latitude go from π to −π, twice from pole to pole",
            hint: "Straight up is at the top and straight down at the bottom: how large is the angle between them?",
            answer: |q| {
                let latitude = PI - TAU * q.film.y;
                along(q, TAU * (q.film.x - 0.5), 0.5 * PI - latitude)
            },
        },
        Mistake {
            name: "calculates longitude and latitude in degrees",
            hint: "In which unit do sine and cosine take their angle?",
            answer: |q| {
                let (longitude, latitude) = (360.0 * q.film.x - 180.0, 90.0 - 180.0 * q.film.y);
                let level = longitude.cos() * *q.forward + longitude.sin() * *q.right;
                CameraRayAnswer {
                    origin: q.position,
                    direction: latitude.cos() * level + latitude.sin() * *q.up,
                }
            },
        },
        Mistake {
            name: "takes the latitude for the height above the horizon, and normalises",
            hint: "On a sphere, how high above the horizon is what you see at an angle of 45°, and how far away?",
            answer: |q| at_height(q, PI * (0.5 - q.film.y)),
        },
        Mistake {
            name: "sees half of the way from the sky to the ground only",
            hint: "From the top edge of the picture to its bottom edge, from which direction to which do you look?",
            answer: |q| along(q, TAU * (q.film.x - 0.5), 0.25 * PI + 0.5 * PI * q.film.y),
        },
        Mistake {
            name: "takes the film for a flat one twice as wide as it is far away, as that of a pin-hole camera",
            hint: "A flat film sees what is ahead: where on it is what lies behind you?",
            answer: |q| flat(q, 1.0),
        },
        Mistake {
            name: "takes the film for a flat one as wide as it is far away, as that of a pin-hole camera",
            hint: "A flat film sees what is ahead: where on it is what lies behind you?",
            answer: |q| flat(q, 0.5),
        },
        Mistake {
            name: "goes half way around from left to right, and once around from top to bottom",
            hint: "Which of the two angles goes once around, and which only from the sky to the ground?",
            answer: |q| along(q, PI * (q.film.x - 0.5), TAU * q.film.y - 0.5 * PI),
        },
        Mistake {
            name: "turns in the wrong order: tilts what lies ahead only, and leaves right and left on the horizon",
            hint: "Look to your right and up: does right, too, move towards up? Which of the two turns comes first?",
            answer: |q| {
                let (sin, cos) = (TAU * (q.film.x - 0.5)).sin_cos();
                let height = PI * (0.5 - q.film.y);
                let tilted = height.cos() * *q.forward + height.sin() * *q.up;
                ray(q, cos * tilted + sin * *q.right)
            },
        },
        Mistake {
            name: "goes straight from the horizon to up, and normalises, so that the angle does not grow evenly",
            hint: "A third of the way from the horizon to up, how many degrees high is your direction? What makes an angle grow evenly?",
            answer: |q| {
                let ray = straight_up(q);
                CameraRayAnswer {
                    direction: ray.direction.normalize_or_zero(),
                    ..ray
                }
            },
        },
        Mistake {
            name: "goes straight from the horizon to up, and does not normalise",
            hint: "How long is a vector half of the way between two perpendicular ones, and how long must a direction be?",
            answer: straight_up,
        },
        Mistake {
            name: "goes straight from forward to right, and on to the back, and normalises",
            hint: "A third of the way from forward to right, by how many degrees have you turned? What makes an angle grow evenly?",
            answer: |q| {
                let turns = 4.0 * (q.film.x - 0.5);
                let across = (1.0 - (turns.abs() - 1.0).abs()).copysign(turns);
                let level = (1.0 - turns.abs()) * *q.forward + across * *q.right;
                let (sin, cos) = (PI * q.film.y).sin_cos();
                ray(q, sin * level.normalize_or_zero() + cos * *q.up)
            },
        },
        Mistake {
            name: "does not shorten the part along the horizon as the direction rises or falls, and normalises the sum",
            hint: "Straight up, how much of the direction is along the horizon, and how much of yours before you normalise? Half way up, how much?",
            answer: |q| at_height(q, (PI * q.film.y).cos()),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "panorama_ray",
        width: 96,
        height: 48,
        alt: "All directions as colours: a bright sky in the upper half, a dark ground in the lower one",
        question: |x, y| {
            let film = vec2((x as f32 + 0.5) / 96.0, (y as f32 + 0.5) / 48.0);
            question(Vec3::ZERO, -Dir3::Z, film)
        },
        colour: |_, ray| direction_colour(ray.direction),
    }];
}

/// A camera that looks along a direction; its up is anything perpendicular to that.
fn question(position: Vec3, forward: Dir3, film: Vec2) -> PanoramaRay {
    let Basis {
        x: right, y: up, ..
    } = Basis::around(-forward);
    PanoramaRay {
        position,
        forward,
        right,
        up,
        film,
    }
}

/// The ray at two angles: φ around up from forward, and θ from up.
fn along(q: &PanoramaRay, phi: f32, theta: f32) -> CameraRayAnswer {
    let around = phi.cos() * *q.forward + phi.sin() * *q.right;
    ray(q, theta.sin() * around + theta.cos() * *q.up)
}

/// The ray at the right longitude, to a place one metre away at this height above the horizon.
fn at_height(q: &PanoramaRay, height: f32) -> CameraRayAnswer {
    let (sin, cos) = (TAU * (q.film.x - 0.5)).sin_cos();
    let level = cos * *q.forward + sin * *q.right;
    ray(q, (level + height * *q.up).normalize_or_zero())
}

/// The ray at the right longitude, to a place on the straight line from the horizon to up, or to down.
fn straight_up(q: &PanoramaRay) -> CameraRayAnswer {
    let (sin, cos) = (TAU * (q.film.x - 0.5)).sin_cos();
    let up = 1.0 - 2.0 * q.film.y;
    let level = cos * *q.forward + sin * *q.right;
    ray(q, (1.0 - up.abs()) * level + up * *q.up)
}

/// The ray of a pin-hole camera whose film is flat, a metre away, and reaches this far to each side.
fn flat(q: &PanoramaRay, half: f32) -> CameraRayAnswer {
    let place = half * vec2(2.0 * q.film.x - 1.0, 1.0 - 2.0 * q.film.y);
    let toward = *q.forward + place.x * *q.right + place.y * *q.up;
    ray(q, toward.normalize())
}

fn ray(q: &PanoramaRay, direction: Vec3) -> CameraRayAnswer {
    CameraRayAnswer {
        origin: q.position,
        direction,
    }
}
