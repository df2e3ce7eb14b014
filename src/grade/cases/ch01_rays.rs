//! Chapter 1: `ray_at`, `camera_ray`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::math::{basis::Basis, dir3::Dir3, pcg::Pcg, ray::Ray};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch01_rays::{
    CameraRay, CameraRayAnswer, CameraRayQuestion, RayAt, RayAtQuestion,
};
use glam::{Vec2, Vec3, vec2, vec3};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&RayAt, &CameraRay];

impl Graded for RayAt {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets the origin",
            hint: "At t = 0, where is the ray?",
            answer: |q| q.t * *q.ray.direction,
        },
        Mistake {
            name: "ignores t",
            hint: "How far from the origin is your point? How far should it be?",
            answer: |q| q.ray.origin + *q.ray.direction,
        },
        Mistake {
            name: "goes backwards",
            hint: "A positive t lies ahead.",
            answer: |q| q.ray.origin - q.t * *q.ray.direction,
        },
        Mistake {
            name: "scales the origin too",
            hint: "Only one of the two vectors grows with t.",
            answer: |q| q.t * (q.ray.origin + *q.ray.direction),
        },
        Mistake {
            name: "scales the origin instead of the direction",
            hint: "Which of the two vectors says where the ray starts?",
            answer: |q| q.t * q.ray.origin + *q.ray.direction,
        },
        Mistake {
            name: "clamps t to what lies ahead",
            hint: "The line goes on behind the origin: which point is 2 m behind it?",
            answer: |q| q.ray.at(q.t.max(0.0)),
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, origin, toward, t| {
            Edge::new(
                name,
                RayAtQuestion {
                    ray: Ray::new(origin, Dir3::new_or(toward, Dir3::Z)),
                    t,
                },
            )
        };
        vec![
            edge("t is 0", vec3(1.0, 2.0, 3.0), Vec3::X, 0.0),
            edge("along x from the world's origin", Vec3::ZERO, Vec3::X, 2.5),
            edge("from somewhere else", vec3(-4.0, 0.5, 2.0), Vec3::Y, 3.0),
            edge("behind the origin", vec3(1.0, 1.0, 1.0), Vec3::Z, -2.0),
            edge("askew", vec3(0.0, 1.0, 0.0), vec3(3.0, 0.0, 4.0), 10.0),
            edge("far away", vec3(1.0, 2.0, 3.0), Vec3::NEG_Z, 1e6),
        ]
    }

    fn random(rng: &mut Pcg) -> RayAtQuestion {
        RayAtQuestion {
            ray: Ray::new(sample::point(rng, 5.0), sample::direction(rng)),
            t: sample::number(rng, -5.0, 20.0),
        }
    }

    fn judge(_q: &RayAtQuestion, golden: &Vec3, got: &Vec3) -> Verdict {
        judge::point("the point", *golden, *got)
    }
}

impl Graded for CameraRay {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "draws the picture upside down",
            hint: "film (0, 0) is the top left: does your y grow upwards or downwards on the film?",
            answer: |q| ask(q, |q| q.film.y = 1.0 - q.film.y),
        },
        Mistake {
            name: "draws the picture mirrored",
            hint: "A place on the right of the film is on the camera's right.",
            answer: |q| ask(q, |q| q.film.x = 1.0 - q.film.x),
        },
        Mistake {
            name: "ignores the focal length",
            hint: "Move the image plane further away: should the view get wider or narrower?",
            answer: |q| ask(q, |q| q.focal_length = 1.0),
        },
        Mistake {
            name: "takes the plane to be twice as large",
            hint: "From the middle of the plane to its edge is how much of its width?",
            answer: |q| ask(q, |q| q.plane *= 2.0),
        },
        Mistake {
            name: "measures from the plane's corner instead of its middle",
            hint: "Which place of the film lies straight ahead?",
            answer: |q| ask(q, |q| q.film += vec2(0.5, -0.5)),
        },
        Mistake {
            name: "ignores the size of the plane",
            hint: "A place on the film is a fraction: of what length?",
            answer: |q| ask(q, |q| q.plane = Vec2::ONE),
        },
        Mistake {
            name: "looks backwards",
            hint: "Is the plane in front of the focal point?",
            answer: |q| ask(q, |q| q.forward = -q.forward),
        },
        Mistake {
            name: "starts at the image plane",
            hint: "All rays of a pin-hole camera pass through one point: which?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = CameraRay::answer(q);
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
                let CameraRayAnswer { origin, direction } = CameraRay::answer(q);
                CameraRayAnswer {
                    origin,
                    direction: q.focal_length / direction.dot(*q.forward) * direction,
                }
            },
        },
        Mistake {
            name: "confuses right and up",
            hint: "Along which of the camera's directions does film.x run?",
            answer: |q| ask(q, |q| std::mem::swap(&mut q.right, &mut q.up)),
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 54,
        alt: "The direction of each pixel's ray as a colour",
        question: |x, y| {
            question(
                Vec3::ZERO,
                -Dir3::Z,
                0.024,
                vec2((x as f32 + 0.5) / 96.0, (y as f32 + 0.5) / 54.0),
            )
        },
        colour: |_, ray| {
            Rgb::new(ray.direction.x, ray.direction.y, ray.direction.z).map(|v| 0.5 + 0.5 * v)
        },
    });

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, x, y| {
            Edge::new(
                name,
                question(vec3(1.0, 2.0, 3.0), -Dir3::Z, 0.05, vec2(x, y)),
            )
        };
        vec![
            edge("the middle of the film", 0.5, 0.5),
            edge("the top left corner", 0.0, 0.0),
            edge("the bottom right corner", 1.0, 1.0),
            edge("the middle of the top", 0.5, 0.0),
            edge("the middle of the right", 1.0, 0.5),
            edge("the centre of pixel (0, 0) of 4 × 2", 0.125, 0.25),
            Edge::new(
                "a wide angle",
                question(Vec3::ZERO, Dir3::X, 0.01, vec2(0.1, 0.8)),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> CameraRayQuestion {
        let film = vec2(sample::number(rng, 0.0, 1.0), sample::number(rng, 0.0, 1.0));
        question(
            sample::point(rng, 5.0),
            sample::direction(rng),
            sample::number(rng, 0.02, 0.1),
            film,
        )
    }

    fn judge(_q: &CameraRayQuestion, golden: &CameraRayAnswer, got: &CameraRayAnswer) -> Verdict {
        judge::point("the ray's origin", golden.origin, got.origin)?;
        judge::direction("the ray's direction", golden.direction, got.direction)
    }
}

/// A camera of the 35 mm format whose up is anything square to its view.
fn question(focal_point: Vec3, forward: Dir3, focal_length: f32, film: Vec2) -> CameraRayQuestion {
    let Basis { x: right, y, .. } = Basis::around(-forward);
    CameraRayQuestion {
        focal_point,
        forward,
        right,
        up: y,
        focal_length,
        plane: vec2(0.036, 0.024),
        film,
    }
}

/// The right answer to a question that was misread.
fn ask(q: &CameraRayQuestion, misread: fn(&mut CameraRayQuestion)) -> CameraRayAnswer {
    let mut q = q.clone();
    misread(&mut q);
    CameraRay::answer(&q)
}
