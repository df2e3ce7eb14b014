//! Chapter 12: `phong`, `blinn_phong`, `point_light`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::math::{dir3::Dir3, pcg::Pcg};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch12_phong::{
    Arriving, BlinnPhongExercise, Highlight, PhongExercise, PointLightExercise, PointLightQuestion,
};
use glam::{Vec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&PhongExercise, &BlinnPhongExercise, &PointLightExercise];

/// R.
fn mirrored(q: &Highlight) -> Vec3 {
    2.0 * q.toward.dot(*q.normal) * *q.normal - *q.toward
}

/// H.
fn half(q: &Highlight) -> Vec3 {
    (*q.toward + *q.view).normalize_or_zero()
}

/// Both terms of a light above the surface, with this number in the place of the highlight's (R·V)^α or (N·H)^α.
fn with_highlight(q: &Highlight, highlight: f32) -> Rgb {
    let cosine = q.toward.dot(*q.normal);
    if cosine > 0.0 {
        (q.diffuse * cosine + q.specular * highlight) * q.arriving
    } else {
        Rgb::BLACK
    }
}

fn power(cosine: f32, q: &Highlight) -> f32 {
    cosine.max(0.0).powf(q.exponent)
}

impl Graded for PhongExercise {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "lets the highlight shine through from behind",
            hint: "Put the light below the surface: the diffuse part vanishes; does everything?",
            answer: |q| {
                let diffuse = q.diffuse * q.toward.dot(*q.normal).max(0.0);
                (diffuse + q.specular * power(mirrored(q).dot(*q.view), q)) * q.arriving
            },
        },
        Mistake {
            name: "lets a light from behind take light away",
            hint: "Is any of your channels ever negative? There is no negative light.",
            answer: |q| {
                let diffuse = q.diffuse * q.toward.dot(*q.normal);
                (diffuse + q.specular * power(mirrored(q).dot(*q.view), q)) * q.arriving
            },
        },
        Mistake {
            name: "mirrors the wrong way",
            hint: "Draw L, N and R: on which side of the surface does your R end?",
            answer: |q| with_highlight(q, power(-mirrored(q).dot(*q.view), q)),
        },
        Mistake {
            name: "takes the light's direction for its mirror direction",
            hint: "Where do you have to stand to see a lamp in a polished floor: beside the lamp?",
            answer: |q| with_highlight(q, power(q.toward.dot(*q.view), q)),
        },
        Mistake {
            name: "takes N·H",
            hint: "That is Blinn's highlight: which two directions does Phong compare?",
            answer: |q| with_highlight(q, power(half(q).dot(*q.normal), q)),
        },
        Mistake {
            name: "has a highlight on the far side too",
            hint: "An even power of a negative number is positive: what if R and V point away from each other?",
            answer: |q| with_highlight(q, mirrored(q).dot(*q.view).abs().powf(q.exponent)),
        },
        Mistake {
            name: "multiplies by the exponent",
            hint: "Raise α: the highlight should become smaller, and stay as bright in its middle.",
            answer: |q| with_highlight(q, q.exponent * mirrored(q).dot(*q.view).max(0.0)),
        },
        Mistake {
            name: "multiplies the highlight by L·N",
            hint: "In the formula as it stands, which of the two terms has the factor L·N?",
            answer: |q| {
                with_highlight(
                    q,
                    q.toward.dot(*q.normal) * power(mirrored(q).dot(*q.view), q),
                )
            },
        },
        Mistake {
            name: "forgets what arrives in the highlight",
            hint: "Switch the light off: is your highlight gone?",
            answer: |q| {
                let highlight = q.specular * power(mirrored(q).dot(*q.view), q);
                let matt = with_highlight(q, 0.0);
                if q.toward.dot(*q.normal) > 0.0 {
                    matt + highlight
                } else {
                    matt
                }
            },
        },
        Mistake {
            name: "forgets the diffuse term's cosine",
            hint: "Tilt the surface away from the light: does it receive as much?",
            answer: |q| {
                let cosine = q.toward.dot(*q.normal);
                let highlight = q.specular * power(mirrored(q).dot(*q.view), q);
                if cosine > 0.0 {
                    (q.diffuse + highlight) * q.arriving
                } else {
                    Rgb::BLACK
                }
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 64,
        height: 64,
        alt: "A shiny clay ball before a wall of the same material, lit from the upper left",
        question: on_ball,
        colour: |_, radiance| *radiance,
    });

    fn edges() -> Vec<Edge<Self>> {
        edges()
            .into_iter()
            .map(|(name, q)| Edge::new(name, q))
            .collect()
    }

    fn random(rng: &mut Pcg) -> Highlight {
        random(rng)
    }

    fn judge(_q: &Highlight, golden: &Rgb, got: &Rgb) -> Verdict {
        radiance(*golden, *got)
    }
}

impl Graded for BlinnPhongExercise {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets to normalise H",
            hint: "How long is L + V if light and viewer are in the same place, and if they are far apart?",
            answer: |q| with_highlight(q, power((*q.toward + *q.view).dot(*q.normal), q)),
        },
        Mistake {
            name: "halves L + V",
            hint: "The middle of two points on a circle is not on the circle: how long is your H?",
            answer: |q| with_highlight(q, power(0.5 * (*q.toward + *q.view).dot(*q.normal), q)),
        },
        Mistake {
            name: "takes R·V",
            hint: "That is Phong's highlight: which two directions does Blinn compare?",
            answer: |q| with_highlight(q, power(mirrored(q).dot(*q.view), q)),
        },
        Mistake {
            name: "takes V·H",
            hint: "V·H is the same on every surface, however it is turned: what is missing?",
            answer: |q| with_highlight(q, power(half(q).dot(*q.view), q)),
        },
        Mistake {
            name: "takes the difference of L and V",
            hint: "Let light and viewer be in the same place, straight above: where does H point?",
            answer: |q| {
                let across = (*q.toward - *q.view).normalize_or_zero();
                with_highlight(q, power(across.dot(*q.normal), q))
            },
        },
        Mistake {
            name: "takes four times the exponent",
            hint: "That makes Phong's and Blinn's highlights alike; but the α that you are given is already Blinn's.",
            answer: |q| with_highlight(q, half(q).dot(*q.normal).max(0.0).powf(4.0 * q.exponent)),
        },
        Mistake {
            name: "lets the highlight shine through from behind",
            hint: "Put the light just below the surface: N·H may still be large; should there be a highlight?",
            answer: |q| {
                let diffuse = q.diffuse * q.toward.dot(*q.normal).max(0.0);
                (diffuse + q.specular * power(half(q).dot(*q.normal), q)) * q.arriving
            },
        },
        Mistake {
            name: "normalises a vector without direction",
            hint: "What is L + V if light and viewer are opposite each other, both at the horizon?",
            answer: |q| {
                let half = (*q.toward + *q.view) / (*q.toward + *q.view).length();
                let highlight = half.dot(*q.normal).powf(q.exponent);
                let right = with_highlight(q, highlight);
                if highlight.is_nan() {
                    Rgb::gray(f32::NAN)
                } else {
                    right
                }
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 64,
        height: 64,
        alt: "A shiny clay ball before a wall of the same material, lit from the upper left",
        question: on_ball,
        colour: |_, radiance| *radiance,
    });

    fn edges() -> Vec<Edge<Self>> {
        edges()
            .into_iter()
            .map(|(name, q)| Edge::new(name, q))
            .collect()
    }

    fn random(rng: &mut Pcg) -> Highlight {
        random(rng)
    }

    fn judge(_q: &Highlight, golden: &Rgb, got: &Rgb) -> Verdict {
        radiance(*golden, *got)
    }
}

/// Named questions; the surface lies in the xz plane.
fn edges() -> Vec<(&'static str, Highlight)> {
    let edge = |name, view: Vec3, toward: Vec3, exponent| {
        let q = Highlight {
            normal: Dir3::Y,
            view: Dir3::new_or(view, Dir3::Y),
            toward: Dir3::new_or(toward, Dir3::Y),
            arriving: Rgb::new(3.0, 2.0, 1.0),
            diffuse: Rgb::new(0.1, 0.2, 0.3),
            specular: Rgb::gray(0.25),
            exponent,
        };
        (name, q)
    };
    let slanting = vec3(0.6, 0.8, 0.0);
    vec![
        edge("light and viewer straight above", Vec3::Y, Vec3::Y, 10.0),
        edge(
            "the viewer in the mirror direction",
            vec3(-0.6, 0.8, 0.0),
            slanting,
            50.0,
        ),
        edge("the view along the light", slanting, slanting, 3.0),
        edge(
            "beside the mirror direction",
            vec3(-0.48, 0.8, 0.36),
            slanting,
            20.0,
        ),
        edge("an exponent of 1", vec3(0.0, 0.8, 0.6), slanting, 1.0),
        edge(
            "the mirror direction points away from the viewer",
            vec3(0.96, 0.28, 0.0),
            vec3(0.8, 0.6, 0.0),
            2.0,
        ),
        edge(
            "a light at the horizon, in the viewer's face",
            vec3(-0.96, 0.28, 0.0),
            Vec3::X,
            2.0,
        ),
        edge(
            "a light below the horizon",
            Vec3::Y,
            vec3(0.6, -0.8, 0.0),
            2.0,
        ),
        edge(
            "a light just below the horizon, in the viewer's face",
            vec3(-0.8, 0.6, 0.0),
            vec3(0.96, -0.28, 0.0),
            2.0,
        ),
        edge(
            "a light straight below",
            vec3(0.6, 0.8, 0.0),
            Vec3::NEG_Y,
            4.0,
        ),
        edge(
            "light and viewer opposite, both at the horizon",
            Vec3::X,
            Vec3::NEG_X,
            5.0,
        ),
    ]
}

/// A viewer above the surface, and a light, most often near enough to the viewer's mirror direction for a highlight.
fn random(rng: &mut Pcg) -> Highlight {
    let (normal, view) = loop {
        let (normal, view) = (sample::direction(rng), sample::direction(rng));
        if normal.dot(*view) > 0.1 {
            break (normal, view);
        }
    };
    let toward = if rng.random_bool(0.15) {
        sample::direction(rng)
    } else {
        let near = *view + rng.random_range(0.1..0.5) * *sample::direction(rng);
        Dir3::new_or(2.0 * near.dot(*normal) * *normal - near, normal)
    };
    let mut colour = |least, most| {
        let mut channel = || sample::number(rng, least, most);
        Rgb::new(channel(), channel(), channel())
    };
    let (arriving, diffuse, specular) = (colour(0.5, 4.0), colour(0.02, 0.3), colour(0.1, 0.5));
    Highlight {
        normal,
        view,
        toward,
        arriving,
        diffuse,
        specular,
        exponent: sample::number(rng, 0.0, 4.5).exp2(),
    }
}

/// A pixel of a ball, or of the wall behind it.
fn on_ball(x: u32, y: u32) -> Highlight {
    let place = |i: u32| (i as f32 + 0.5) / 29.0 - 32.0 / 29.0;
    let (x, y) = (place(x), -place(y));
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    let normal = if z > 0.0 { vec3(x, y, z) } else { Vec3::Z };
    Highlight {
        normal: Dir3::new_or(normal, Dir3::Z),
        view: Dir3::Z,
        toward: Dir3::new_or(vec3(-0.5, 0.6, 0.6), Dir3::Z),
        arriving: Rgb::gray(3.0),
        diffuse: Rgb::new(0.25, 0.07, 0.016),
        specular: Rgb::gray(0.25),
        exponent: 20.0,
    }
}

fn radiance(golden: Rgb, got: Rgb) -> Verdict {
    channels(golden, got, 0.01)
}

/// Each channel, relative to its size or to `least`.
fn channels(golden: Rgb, got: Rgb, least: f32) -> Verdict {
    let names = ["red", "green", "blue"];
    for ((name, golden), got) in names.iter().zip(golden.channels()).zip(got.channels()) {
        let tolerance = judge::RELATIVE * golden.abs().max(least);
        judge::number_within(name, "", golden, got, tolerance)?;
    }
    Ok(())
}

/// What arrives, changed by a function of the distance.
fn falling_off(q: &PointLightQuestion, by: fn(f32) -> f32) -> Option<Arriving> {
    let right = PointLightExercise::answer(q)?;
    let arriving = q.intensity * by(right.distance);
    Some(Arriving { arriving, ..right })
}

impl Graded for PointLightExercise {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "does not let the light fall off",
            hint: "Go twice as far away: is the lamp as bright on your page?",
            answer: |q| falling_off(q, |_| 1.0),
        },
        Mistake {
            name: "lets the light fall off with the distance, not its square",
            hint: "The same power goes through ever larger spheres: how does a sphere's area grow with its radius?",
            answer: |q| falling_off(q, |r| 1.0 / r),
        },
        Mistake {
            name: "takes the intensity for a power",
            hint: "The intensity is given per steradian already: is there a 4π left to divide by?",
            answer: |q| falling_off(q, |r| 1.0 / (4.0 * std::f32::consts::PI * r * r)),
        },
        Mistake {
            name: "adds 1 to the squared distance",
            hint: "That avoids a large number near the lamp; what does it do to the light at one metre?",
            answer: |q| falling_off(q, |r| 1.0 / (1.0 + r * r)),
        },
        Mistake {
            name: "points away from the light",
            hint: "To the light, or from it: which of two points do you subtract from which?",
            answer: |q| {
                let right = PointLightExercise::answer(q)?;
                Some(Arriving {
                    toward: -right.toward,
                    ..right
                })
            },
        },
        Mistake {
            name: "forgets to normalise the direction",
            hint: "How long is the vector from the point to the light?",
            answer: |q| {
                let right = PointLightExercise::answer(q)?;
                Some(Arriving {
                    toward: right.toward * right.distance,
                    ..right
                })
            },
        },
        Mistake {
            name: "returns the squared distance",
            hint: "In which unit is your distance?",
            answer: |q| {
                let right = PointLightExercise::answer(q)?;
                Some(Arriving {
                    distance: right.distance * right.distance,
                    ..right
                })
            },
        },
        Mistake {
            name: "takes the light to be at the origin",
            hint: "Move the lamp by one metre: does your answer change?",
            answer: |q| {
                PointLightExercise::answer(&PointLightQuestion {
                    position: Vec3::ZERO,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "answers at the light itself too",
            hint: "Stand where the light is: in which direction would you look for it?",
            answer: |q| {
                let there = Arriving {
                    toward: Vec3::Y,
                    distance: 0.0,
                    arriving: q.intensity,
                };
                PointLightExercise::answer(q).or(Some(there))
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, position, at| {
            let intensity = Rgb::new(8.0, 4.0, 2.0);
            Edge::new(
                name,
                PointLightQuestion {
                    position,
                    intensity,
                    at,
                },
            )
        };
        vec![
            edge("one metre below the lamp", Vec3::Y, Vec3::ZERO),
            edge("two metres: a quarter", 2.0 * Vec3::Y, Vec3::ZERO),
            edge(
                "half a metre: four times as much",
                0.5 * Vec3::Y,
                Vec3::ZERO,
            ),
            edge("above the lamp", Vec3::ZERO, vec3(0.0, 4.0, 0.0)),
            edge(
                "far from the origin",
                vec3(100.0, 50.0, -200.0),
                vec3(103.0, 46.0, -200.0),
            ),
            edge("a kilometre away", vec3(600.0, 800.0, 0.0), Vec3::ZERO),
            edge("a millimetre away", vec3(0.0, 0.0, 0.001), Vec3::ZERO),
            edge(
                "at the light itself",
                vec3(1.0, 2.0, 3.0),
                vec3(1.0, 2.0, 3.0),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> PointLightQuestion {
        let mut channel = || sample::number(rng, 0.5, 20.0);
        PointLightQuestion {
            intensity: Rgb::new(channel(), channel(), channel()),
            position: sample::point(rng, 5.0),
            at: sample::point(rng, 5.0),
        }
    }

    fn judge(
        _q: &PointLightQuestion,
        golden: &Option<Arriving>,
        got: &Option<Arriving>,
    ) -> Verdict {
        judge::option("light", golden.as_ref(), got.as_ref(), |golden, got| {
            judge::direction("the direction to the light", golden.toward, got.toward)?;
            let tolerance = judge::RELATIVE * golden.distance;
            judge::number_within(
                "the distance",
                "m",
                golden.distance,
                got.distance,
                tolerance,
            )?;
            channels(golden.arriving, got.arriving, 1e-9)
        })
    }
}
