//! `thin_lens_ray`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Picture, Relation, Verdict, judge, sample};
use glam::{Vec2, Vec3, vec2, vec3};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{basis::Basis, dir3::Dir3, interval::Interval, pcg, pcg::Pcg, ray::Ray};
use raybook::sample::disk::concentric_disk;
use raybook::shape::{Shape, sphere::Sphere};
use raybook_workbook::exercises::ch01_rays::CameraRayAnswer;
use raybook_workbook::exercises::ch19_depth_of_field::ThinLensRay;

/// What is asked of a question here.
pub(super) trait ThroughLens {
    /// The ray through the middle of the lens.
    fn central(&self) -> CameraRayAnswer;

    /// Where a ray meets the plane in focus.
    fn in_plane(&self, ray: &CameraRayAnswer) -> Vec3;

    /// The ray from the right point of the lens to another point.
    fn toward(&self, point: Vec3) -> CameraRayAnswer;
}

impl ThroughLens for ThinLensRay {
    fn central(&self) -> CameraRayAnswer {
        let mut middle = self.clone();
        middle.on_lens = Vec2::ZERO;
        ThinLensRay::right(&middle)
    }

    fn in_plane(&self, ray: &CameraRayAnswer) -> Vec3 {
        let ahead = ray.direction.dot(*self.forward);
        let to_plane = self.focus - (ray.origin - self.lens_middle).dot(*self.forward);
        ray.origin + to_plane / ahead * ray.direction
    }

    fn toward(&self, point: Vec3) -> CameraRayAnswer {
        let CameraRayAnswer { origin, .. } = ThinLensRay::right(self);
        CameraRayAnswer {
            origin,
            direction: (point - origin).normalize_or_zero(),
        }
    }
}

impl Graded for ThinLensRay {
    fn random(rng: &mut Pcg) -> ThinLensRay {
        let focal_length = sample::number(rng, 0.02, 0.1);
        let unit = |rng: &mut Pcg| vec2(rng.random(), rng.random());
        ThinLensRay {
            focal_length,
            f_number: sample::number(rng, 1.0, 2.8),
            focus: focal_length * sample::number(rng, 4.0, 25.0),
            // A film of any shape, also one that is higher than it is wide.
            plane: vec2(
                sample::number(rng, 0.01, 0.06),
                sample::number(rng, 0.01, 0.06),
            ),
            film: unit(rng),
            on_lens: concentric_disk(unit(rng)),
            ..question(sample::point(rng, 1.0), sample::direction(rng))
        }
    }

    /// In the units of what counts: the start by the aperture's size, the direction by what it misses in the plane in focus.
    fn is_sound(q: &ThinLensRay) -> bool {
        sample::are_axes([q.forward, q.right, q.up]) && q.focus > q.focal_length
    }

    fn judge(q: &ThinLensRay, golden: &CameraRayAnswer, got: &CameraRayAnswer) -> Verdict {
        /// Of the distance from the world's origin and from the lens: some two hundred roundings.
        const ROUNDING: f32 = 1e-5;
        let far = q.lens_middle.length() + q.lens().aperture();
        let of_lens = judge::RELATIVE * q.lens().aperture();
        judge::direction(
            "the ray's direction",
            got.direction.normalize_or_zero(),
            got.direction,
        )?;
        let off = golden.origin.distance(got.origin);
        if off.is_nan() || off > of_lens + ROUNDING * far {
            return Err(format!(
                "the ray's origin is {:.3} mm away from where it should be",
                1e3 * off
            ));
        }
        judge::direction("the ray's direction", golden.direction, got.direction)?;
        let miss = q.in_plane(golden).distance(q.in_plane(got));
        if miss.is_nan() || miss > of_lens + ROUNDING * (far + q.focus) {
            return Err(format!(
                "the ray misses the point in focus by {:.3} mm, {} m ahead of the lens",
                1e3 * miss,
                q.focus
            ));
        }
        Ok(())
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| ThinLensRay {
        lens_middle: q.lens_middle + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "focuses on a sphere instead of a plane",
            hint: "Photograph a wall: are its corners as far from the lens as its middle, and should they be sharp?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = q.central();
                q.toward(origin + q.focus * direction)
            },
        },
        Mistake {
            name: "takes the diameter of the aperture for its radius",
            hint: "How far from the middle of the lens is its edge?",
            answer: |q| Self::misread(q, |q| q.f_number *= 0.5),
        },
        Mistake {
            name: "forgets to normalise the direction",
            hint: "If t is to be a distance, how long must the direction be?",
            answer: |q| {
                let CameraRayAnswer { origin, .. } = Self::right(q);
                CameraRayAnswer {
                    origin,
                    direction: q.in_plane(&q.central()) - origin,
                }
            },
        },
        Mistake {
            name: "starts in the middle of the lens",
            hint: "From how many points does your camera look at the scene?",
            answer: |q| CameraRayAnswer {
                origin: q.lens_middle,
                ..Self::right(q)
            },
        },
        Mistake {
            name: "goes parallel to the ray through the middle",
            hint: "Two rays of the same place of the film: where should they meet, and where do yours?",
            answer: |q| CameraRayAnswer {
                direction: q.central().direction,
                ..Self::right(q)
            },
        },
        Mistake {
            name: "ignores on_lens: all rays go through the middle of the lens",
            hint: "Is there any blur? What is `on_lens` for?",
            answer: ThinLensRay::central,
        },
        Mistake {
            name: "focuses at the focal length",
            hint: "The focal length is a property of the lens; where is the plane in which all is sharp?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = q.central();
                let t = q.focal_length / direction.dot(*q.forward);
                q.toward(origin + t * direction)
            },
        },
        Mistake {
            name: "leaves the film at the focal length",
            hint: "Where is the film when the focus is near?",
            answer: |q| Self::misread(q, |q| q.plane *= q.lens().film_distance() / q.focal_length),
        },
        Mistake {
            name: "multiplies by the f-number",
            hint: "Is the aperture wider at f/2 or at f/16?",
            answer: |q| Self::misread(q, |q| q.f_number = 1.0 / q.f_number),
        },
        Mistake {
            name: "takes the opposite point of the lens",
            hint: "(1, 0) is the edge of the lens on the right, (0, 1) the upper one: where do your rays start?",
            answer: |q| Self::misread(q, |q| q.on_lens = -q.on_lens),
        },
        Mistake {
            name: "draws the picture upside down",
            hint: "film (0, 0) is the top left: does your y grow upwards or downwards on the film?",
            answer: |q| Self::misread(q, |q| q.film = vec2(q.film.x, 1.0 - q.film.y)),
        },
        Mistake {
            name: "takes the f-number for the radius",
            hint: "The aperture's diameter is the focal length over the f-number: how many metres is that?",
            answer: |q| Self::misread(q, |q| q.f_number = 0.5 * q.focal_length / q.f_number),
        },
        Mistake {
            name: "forgets the focal length in the size of the aperture",
            hint: "The f-number is a ratio: of what to what?",
            answer: |q| Self::misread(q, |q| q.on_lens /= q.focal_length),
        },
        Mistake {
            name: "does not enlarge the film to its size in the plane in focus",
            hint: "Through the middle of the lens, the film is thrown on the plane in focus: how much larger is it there?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.plane *= q.focal_length / (q.focus - q.focal_length);
                })
            },
        },
        Mistake {
            name: "takes f·s/(s + f) for the distance of the film",
            hint: "Is your film farther from the lens than the focal length, or nearer?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.plane *= (q.focus + q.focal_length) / (q.focus - q.focal_length);
                })
            },
        },
        Mistake {
            name: "counts the film from its middle, and not from its corner",
            hint: "Which place of the film is straight ahead of the lens: (0, 0), or (½, ½)?",
            answer: |q| Self::misread(q, |q| q.film += 0.5),
        },
        Mistake {
            name: "moves the start along the axes of the world, not along those of the camera",
            hint: "Turn the camera: does your lens turn with it?",
            answer: |q| {
                let start = Self::right(q).origin;
                let sharp = q.in_plane(&q.central());
                let away = start - q.lens_middle;
                let origin = q.lens_middle + vec3(away.dot(*q.right), away.dot(*q.up), 0.0);
                CameraRayAnswer {
                    origin,
                    direction: (sharp - origin).normalize_or_zero(),
                }
            },
        },
        Mistake {
            name: "measures the distance in focus from the film, not from the lens",
            hint: "From which of the two is the focus measured: from the lens, or from the film before it?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = q.central();
                let ahead = q.focus - q.lens().film_distance();
                q.toward(origin + ahead / direction.dot(*q.forward) * direction)
            },
        },
        Mistake {
            name: "puts the film one metre before the lens",
            hint: "Where is the film, so that the plane in focus is sharp?",
            answer: |q| Self::misread(q, |q| q.plane *= q.lens().film_distance()),
        },
        Mistake {
            name: "goes from the point of the lens through the place on the film",
            hint: "Where do all rays of one place of the film meet: on the film, or in the plane in focus?",
            answer: |q| {
                let CameraRayAnswer { origin, direction } = q.central();
                let ahead = q.lens().film_distance() / direction.dot(*q.forward);
                q.toward(origin + ahead * direction)
            },
        },
        Mistake {
            name: "takes the film's distance over the f-number for the aperture",
            hint: "Does the opening of the lens change when you focus?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.on_lens *= q.lens().film_distance() / q.focal_length;
                })
            },
        },
        Mistake {
            name: "takes the point of the lens for one of the unit square, and stretches that square from −1 to 1",
            hint: "`on_lens` is in the unit disc: where do your rays start for (0, 0), and for (1, 0)?",
            answer: |q| Self::misread(q, |q| q.on_lens = 2.0 * q.on_lens - 1.0),
        },
        Mistake {
            name: "takes (½, ½) for the middle of the lens",
            hint: "`on_lens` is in the unit disc: where do your rays start for (0, 0), and for (1, 0)?",
            answer: |q| Self::misread(q, |q| q.on_lens -= 0.5),
        },
        Mistake {
            name: "maps the point of the lens to the unit disc once more, by the concentric map",
            hint: "`on_lens` is in the unit disc already: where do your rays start for (0, 0), and for (1, 0)?",
            answer: |q| Self::misread(q, |q| q.on_lens = concentric_disk(q.on_lens)),
        },
        Mistake {
            name: "squeezes the lens along the camera's up axis, as the film is",
            hint: "The film is wider than high: is the aperture, too?",
            answer: |q| Self::misread(q, |q| q.on_lens *= vec2(1.0, q.plane.y / q.plane.x)),
        },
        Mistake {
            name: "stretches the lens along the camera's right axis, as the film is",
            hint: "The film is wider than high: is the aperture, too?",
            answer: |q| Self::misread(q, |q| q.on_lens *= vec2(q.plane.x / q.plane.y, 1.0)),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "thin_lens_ray",
        width: 96,
        height: 54,
        alt: "Three balls, one ray a pixel, each from another point of the lens: the middle one has a clean edge, the near and the far one are frayed",
        question: pixel,
        colour,
    }];
}

/// A lens of 50 mm before a film of the 35 mm format, whose up is anything perpendicular to its view.
fn question(lens_middle: Vec3, forward: Dir3) -> ThinLensRay {
    let Basis {
        x: right, y: up, ..
    } = Basis::around(-forward);
    ThinLensRay {
        lens_middle,
        forward,
        right,
        up,
        focal_length: 0.05,
        f_number: 2.0,
        focus: 2.0,
        plane: vec2(0.036, 0.024),
        film: Vec2::splat(0.5),
        on_lens: Vec2::ZERO,
    }
}

/// Each pixel has a point of the lens of its own.
fn pixel(x: u32, y: u32) -> ThinLensRay {
    let mut rng = pcg::stream(19, u64::from(96 * y + x));
    ThinLensRay {
        f_number: 1.25,
        film: (vec2(x as f32, y as f32) + 0.5) / vec2(96.0, 54.0),
        on_lens: concentric_disk(vec2(rng.random(), rng.random())),
        plane: vec2(0.0427, 0.024),
        right: Dir3::X,
        up: Dir3::Y,
        ..question(Vec3::ZERO, -Dir3::Z)
    }
}

/// A ball near the lens, one in focus and one far away, before a bright wall.
fn colour(_: &ThinLensRay, ray: &CameraRayAnswer) -> Rgb {
    let balls = [
        (vec3(-0.19, -0.05, -0.8), 0.1, Rgb::new(0.80, 0.25, 0.05)),
        (vec3(0.0, 0.0, -2.0), 0.3, Rgb::new(0.02, 0.28, 0.42)),
        (vec3(2.5, 0.6, -9.0), 1.1, Rgb::new(0.10, 0.42, 0.25)),
    ];
    let Some(direction) = Dir3::new(ray.direction) else {
        return Rgb::BLACK;
    };
    let ray = Ray::new(ray.origin, direction);
    let seen = |(center, radius, _): &(Vec3, f32, Rgb)| {
        let ball = Sphere::new(*center, *radius);
        ball.hit(&ray, Interval::AHEAD).is_some()
    };
    let ball = balls.iter().find(|ball| seen(ball));
    ball.map_or(Rgb::new(0.85, 0.80, 0.70), |(.., colour)| *colour)
}
