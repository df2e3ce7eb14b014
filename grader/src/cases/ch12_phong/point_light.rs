//! `point_light`: random questions, judge and mistakes.

use super::channels;
use crate::{Graded, Mistake, Relation, Verdict, judge, sample};
use glam::Vec3;
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch12_phong::{Arriving, PointLightExercise};

/// What arrives, changed by a function of the distance.
fn falling_off(q: &PointLightExercise, by: fn(f32) -> f32) -> Option<Arriving> {
    let right = PointLightExercise::right(q)?;
    let arriving = q.intensity * by(right.distance);
    Some(Arriving { arriving, ..right })
}

impl Graded for PointLightExercise {
    fn random(rng: &mut Pcg) -> PointLightExercise {
        let mut channel = || sample::number(rng, 0.5, 20.0);
        PointLightExercise {
            intensity: Rgb::new(channel(), channel(), channel()),
            position: sample::point(rng, 5.0),
            at: sample::point(rng, 5.0),
        }
    }

    fn judge(
        _q: &PointLightExercise,
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

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| PointLightExercise {
        position: q.position + sample::METRE,
        at: q.at + sample::METRE,
        ..q.clone()
    })];

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
            name: "divides by 4π, as if the intensity were a power",
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
                let right = PointLightExercise::right(q)?;
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
                let right = PointLightExercise::right(q)?;
                Some(Arriving {
                    toward: right.toward * right.distance,
                    ..right
                })
            },
        },
        Mistake {
            name: "takes a near light for one at the point itself",
            hint: "A lamp of a millimetre's distance: is there no direction to it?",
            answer: |q| PointLightExercise::right(q).filter(|right| right.distance > 0.005),
        },
        Mistake {
            name: "returns the squared distance",
            hint: "In which unit is your distance?",
            answer: |q| {
                let right = PointLightExercise::right(q)?;
                Some(Arriving {
                    distance: right.distance * right.distance,
                    ..right
                })
            },
        },
        Mistake {
            name: "takes the light to be at the origin",
            hint: "Move the lamp by one metre: does your answer change?",
            answer: |q| Self::misread(q, |q| q.position = Vec3::ZERO),
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
                PointLightExercise::right(q).or(Some(there))
            },
        },
        Mistake {
            name: "returns the whole intensity at the light itself, from no direction",
            hint: "Stand where the light is: in which direction would you look for it? How does an answer say that there is none?",
            answer: |q| {
                let there = Arriving {
                    toward: Vec3::ZERO,
                    distance: 0.0,
                    arriving: q.intensity,
                };
                PointLightExercise::right(q).or(Some(there))
            },
        },
        Mistake {
            name: "lets the light fall off with the cube of the distance",
            hint: "How does a sphere's area grow with its radius? Is a vector that you divide by normalised already?",
            answer: |q| falling_off(q, |r| 1.0 / (r * r * r)),
        },
        Mistake {
            name: "divides by 1 + d + d²",
            hint: "That avoids a large number near the lamp; what does it do to the light at one metre?",
            answer: |q| falling_off(q, |r| 1.0 / (1.0 + r + r * r)),
        },
        Mistake {
            name: "divides by 1 + 0.09 d + 0.032 d², as games do",
            hint: "The formula has one term: how much of the lamp's light arrives at one metre?",
            answer: |q| falling_off(q, |r| 1.0 / (1.0 + 0.09 * r + 0.032 * r * r)),
        },
        Mistake {
            name: "adds up what lies between light and point along each axis for the distance",
            hint: "Three steps along x, y and z are longer than the straight way: how long is that?",
            answer: |q| {
                let right = PointLightExercise::right(q)?;
                let distance = (q.position - q.at).abs().element_sum();
                Some(Arriving {
                    distance,
                    arriving: q.intensity * (1.0 / (distance * distance)),
                    ..right
                })
            },
        },
        Mistake {
            name: "multiplies by the cosine between the direction and +y, as if the surface faced up",
            hint: "The answer is for a surface that faces the light: how large is the cosine there?",
            answer: |q| {
                let right = PointLightExercise::right(q)?;
                Some(Arriving {
                    arriving: right.arriving * right.toward.y.max(0.0),
                    ..right
                })
            },
        },
        Mistake {
            name: "takes e^−d for 1/d²",
            hint: "Clear air swallows nothing: why does a lamp look weaker from far away?",
            answer: |q| falling_off(q, |r| (-r).exp()),
        },
        Mistake {
            name: "multiplies by the squared distance",
            hint: "Go twice as far away: does the lamp become brighter on your page?",
            answer: |q| falling_off(q, |r| r * r),
        },
        Mistake {
            name: "divides by the squared distance twice",
            hint: "In how many places of your function does the light fall off?",
            answer: |q| falling_off(q, |r| 1.0 / (r * r * r * r)),
        },
        Mistake {
            name: "divides by π d², the area of a circle",
            hint: "The intensity is given per steradian already: is there a π left to divide by?",
            answer: |q| falling_off(q, |r| 1.0 / (std::f32::consts::PI * r * r)),
        },
        Mistake {
            name: "divides by 2π, as if the intensity were the power of half of a sphere",
            hint: "The intensity is given per steradian already: is there a 2π left to divide by?",
            answer: |q| falling_off(q, |r| 1.0 / (std::f32::consts::TAU * r * r)),
        },
        Mistake {
            name: "takes 1 for a squared distance below 1, so that the light never grows",
            hint: "Half a metre from the lamp: is the page brighter than at one metre?",
            answer: |q| falling_off(q, |r| 1.0 / (r * r).max(1.0)),
        },
        Mistake {
            name: "takes the lit point to be at the world's origin",
            hint: "Move the point by one metre: does your answer change?",
            answer: |q| Self::misread(q, |q| q.at = Vec3::ZERO),
        },
        Mistake {
            name: "adds the point to the light's position instead of subtracting it",
            hint: "From which of the two points to which one does the direction go: what do you subtract from what?",
            answer: |q| Self::misread(q, |q| q.at = -q.at),
        },
        Mistake {
            name: "divides the direction by the squared distance",
            hint: "How long is your direction at two metres, and how long should it be?",
            answer: |q| {
                let right = PointLightExercise::right(q)?;
                Some(Arriving {
                    toward: right.toward / right.distance,
                    ..right
                })
            },
        },
    ];
}
