//! `sample_rect`: random questions, judge and mistakes.

use super::chosen::{self, DENSITY, FINE, MEAN, N, each, evenly};
use super::flaws;
use super::lattice;
use crate::{Flaw, Graded, Mistake, Relation, Verdict, judge, sample};
use glam::{DVec2, Vec2, vec2};
use rand::RngExt;
use raybook::math::{basis::Basis, pcg::Pcg};
use raybook_workbook::exercises::ch16_soft_shadows::{Chosen, SampleRect};
use std::f32::consts::TAU;

impl Graded for SampleRect {
    fn random(rng: &mut Pcg) -> SampleRect {
        let basis = Basis::around(sample::direction(rng));
        let [width, height] = [(); 2].map(|()| sample::number(rng, 0.3, 3.0));
        let (a, b) = (width * *basis.x, height * *basis.y);
        let corner = sample::point(rng, 2.0);
        let place = vec2(
            sample::number(rng, -0.5, 1.5),
            sample::number(rng, -0.5, 1.5),
        );
        let before = sample::number(rng, 0.5, 4.0);
        let side = if rng.random_bool(0.1) { -1.0 } else { 1.0 };
        SampleRect {
            at: corner + place.x * a + place.y * b + side * before * *basis.z,
            corner,
            a,
            b,
            radiance: sample::number(rng, 0.5, 5.0),
            n: N,
        }
    }

    fn judge(q: &SampleRect, golden: &Self::Answer, got: &Self::Answer) -> Verdict {
        judge::option("light", golden.as_ref(), got.as_ref(), |_, got| {
            let size = q.a.length().max(q.b.length());
            let place = |chosen: &Chosen| {
                let p = q.at + chosen.distance * chosen.toward - q.corner;
                vec2(p.dot(q.a), p.dot(q.b)) / vec2(q.a.length_squared(), q.b.length_squared())
            };
            each(q.n, q.radiance, got, |chosen| {
                let p = place(chosen);
                let margin = judge::RELATIVE * (1.0 + q.at.distance(q.corner) / size);
                let point = q.at + chosen.distance * chosen.toward;
                let off = point.distance(q.corner + p.x * q.a + p.y * q.b);
                // As `<=`, so that a NaN is outside.
                let inside = (p - 0.5).abs().max_element() <= 0.5 + margin && off <= margin * size;
                if !inside {
                    let n = q.a.cross(q.b);
                    let right = (q.corner - q.at).dot(n) / chosen.toward.dot(n);
                    let there = place(&Chosen {
                        distance: right,
                        ..chosen.clone()
                    });
                    let is_met = right > 0.0 && (there - 0.5).abs().max_element() <= 0.5 + margin;
                    return Err(if is_met {
                        format!(
                            "the light is {} m away in its direction, and its distance is {} m",
                            judge::size(right),
                            judge::size(chosen.distance)
                        )
                    } else {
                        "its point is not on the light".to_owned()
                    });
                }
                let cosine = -chosen.toward.dot(q.a.cross(q.b).normalize_or_zero());
                let pdf = chosen.distance.powi(2) / (area(q) * cosine);
                judge::number_within("the density", "/sr", pdf, chosen.pdf, DENSITY * pdf)
            })?;
            let places: Vec<_> = got.iter().map(|c| place(c).as_dvec2()).collect();
            evenly("the points", &places, DVec2::splat(MEAN))
        })
    }

    /// Of a light that is seen edge-on, samples of any density that is far too large are those of an infinite one: how much a light of no
    /// width is made wider, is everybody's own choice.
    fn canonical(q: &SampleRect, answer: Self::Answer) -> Self::Answer {
        let is_dense = |chosen: &Chosen| chosen.pdf * area(q) > DENSE * chosen.distance.powi(2);
        answer.map(|all| {
            if is_edge_on(q) && all.len() == (q.n * q.n) as usize && all.iter().all(is_dense) {
                edge_on(q)
            } else {
                all
            }
        })
    }

    fn traits(q: &SampleRect, got: &Self::Answer) -> Vec<f64> {
        let Some(got) = got else {
            return vec![0.0; chosen::TRAITS];
        };
        let place = |chosen: &Chosen| {
            let p = q.at + chosen.distance * chosen.toward - q.corner;
            vec2(p.dot(q.a), p.dot(q.b)) / vec2(q.a.length_squared(), q.b.length_squared())
        };
        let right = |chosen: &Chosen| {
            let cosine = -chosen.toward.dot(q.a.cross(q.b).normalize_or_zero());
            chosen.distance.powi(2) / (area(q) * cosine)
        };
        let places = got.iter().map(|chosen| place(chosen).as_dvec2());
        chosen::traits(q.radiance, got, &places.collect::<Vec<_>>(), right)
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation {
        name: chosen::FINER,
        question: |q| Self {
            n: FINE,
            ..q.clone()
        },
    }];

    const FLAWS: &'static [Flaw] = &[
        flaws::COUNT,
        flaws::LENGTH,
        Flaw {
            complaint: "its point is not on the light",
            name: "chooses points that are not on the light",
            hint: "The corner and the two sides: between which numbers times the sides is a point on the light?",
        },
        Flaw {
            complaint: "away in its direction",
            name: "returns a distance that is not that of the light in the sample's direction",
            hint: "From where to where is your distance measured, and does each sample have its own?",
        },
        flaws::DENSITY,
        flaws::RATIO,
        flaws::UNEVEN,
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "returns the density per area",
            hint: "The density is asked per steradian: how many steradians is a piece of the light, seen from the point?",
            answer: |q| spoil_rect(q, |_, chosen| 1.0 / area(q) + 0.0 * chosen.pdf),
        },
        Mistake {
            name: "forgets the cosine at the light",
            hint: "A light that is seen from the side looks narrower.",
            answer: |q| spoil_rect(q, |cosine, chosen| chosen.pdf * cosine),
        },
        Mistake {
            name: "forgets the distance in the density",
            hint: "Twice as far away, how much smaller does the light look?",
            answer: |q| spoil_rect(q, |_, chosen| chosen.pdf / chosen.distance.powi(2)),
        },
        Mistake {
            name: "does not square the distance, or takes the cosine with a vector that is not of length 1",
            hint: "Twice as far away, how much smaller does the light look? And how long are both vectors of your cosine?",
            answer: |q| spoil_rect(q, |_, chosen| chosen.pdf / chosen.distance),
        },
        Mistake {
            name: "returns the inverse of the density",
            hint: "A small light is seen in few directions: is their density then large or small?",
            answer: |q| spoil_rect(q, |_, chosen| 1.0 / chosen.pdf),
        },
        Mistake {
            name: "does not see that the light turns its back",
            hint: "Where does a × b point, and on which side of the light is the point?",
            answer: |q| SampleRect::right(q).or_else(|| from_behind(q)),
        },
        Mistake {
            name: "does not see that the light turns its back, nor that it is seen edge-on",
            hint: "Where does a × b point, and on which side of the light is the point? Of what is your cosine the absolute value, or which sign may it have?",
            answer: |q| {
                let right = SampleRect::right(q).or_else(|| from_behind(q));
                right.or_else(|| is_edge_on(q).then(|| edge_on(q)))
            },
        },
        Mistake {
            name: "takes the light's corner for its middle",
            hint: "Which points of the light belong to u = (0, 0) and to u = (1, 1)?",
            answer: |q| Self::misread(q, |q| q.corner -= 0.5 * (q.a + q.b)),
        },
        Mistake {
            name: "uses one number for both sides",
            hint: "Draw your points on the light: do they fill it?",
            answer: |q| chosen_rect(q, |u| Vec2::splat(u.x)),
        },
        Mistake {
            name: "samples a disc inside the rectangle",
            hint: "Do your points come into the light's corners?",
            answer: |q| chosen_rect(q, |u| 0.5 + 0.5 * u.x.sqrt() * Vec2::from_angle(TAU * u.y)),
        },
        Mistake {
            name: "does not divide the radiance by the density",
            hint: "The mean of what arrives must not depend on how the points are chosen.",
            answer: |q| {
                let all = Self::right(q)?;
                Some(chosen::changed(all, |chosen| chosen.arriving = q.radiance))
            },
        },
        Mistake {
            name: "leaves the radiance out of what arrives",
            hint: "Make the light twice as bright: does twice as much arrive?",
            answer: |q| {
                let all = Self::right(q)?;
                Some(chosen::changed(all, |chosen| {
                    chosen.arriving = 1.0 / chosen.pdf;
                }))
            },
        },
        Mistake {
            name: "takes the middle of the light for every sample",
            hint: "Where on the light do your samples lie?",
            answer: |q| chosen_rect(q, |_| Vec2::splat(0.5)),
        },
        Mistake {
            name: "takes the corners of the lattice's cells for their middles",
            hint: "The first pair is (½/n, ½/n): what is yours?",
            answer: |q| chosen_rect(q, |u| u - 0.5 / q.n as f32),
        },
        Mistake {
            name: "squares one of the two uniform numbers",
            hint: "Is every part of the light chosen as often as every other?",
            answer: |q| chosen_rect(q, |u| glam::vec2(u.x * u.x, u.y)),
        },
        Mistake {
            name: "divides what arrives by the number of samples, too",
            hint: "Each sample stands for the whole light: who takes the mean of them, this function or the one that calls it?",
            answer: |q| {
                Some(chosen::changed(Self::right(q)?, |chosen| {
                    chosen.arriving /= (q.n * q.n) as f32;
                }))
            },
        },
        Mistake {
            name: "takes the density at the light's middle for all samples",
            hint: "Each sample has a distance and a cosine of its own: where in your loop is the density calculated?",
            answer: |q| {
                let way = q.corner + 0.5 * (q.a + q.b) - q.at;
                let cosine = -way.dot(q.a.cross(q.b).normalize_or_zero()) / way.length();
                spoil_rect(q, |_, _| way.length_squared() / (area(q) * cosine))
            },
        },
        Mistake {
            name: "takes the cosine at the light for the direction to its middle, whatever the sample",
            hint: "Each sample has a distance and a cosine of its own: which direction is the cosine of?",
            answer: |q| {
                let way = q.corner + 0.5 * (q.a + q.b) - q.at;
                let cosine = -way.dot(q.a.cross(q.b).normalize_or_zero()) / way.length();
                spoil_rect(q, |_, chosen| chosen.distance.powi(2) / (area(q) * cosine))
            },
        },
        Mistake {
            name: "takes a × b for the light's normal without bringing it to length 1 for the cosine",
            hint: "How long is the cross product of the light's two sides?",
            answer: |q| spoil_rect(q, |_, chosen| chosen.pdf / area(q)),
        },
        Mistake {
            name: "lets the wrong side of the light shine",
            hint: "Where does a × b point, and on which side of the light is the point?",
            answer: from_behind,
        },
        Mistake {
            name: "spreads the lattice from border to border of the light",
            hint: "The first pair is (½/n, ½/n): what is yours?",
            answer: |q| {
                let wider = q.n as f32 / q.n.saturating_sub(1).max(1) as f32;
                chosen_rect(q, |u| 0.5 + (u - 0.5) * wider)
            },
        },
        Mistake {
            name: "multiplies the density by the number of samples",
            hint: "What is the integral of a density over all directions, however many samples are taken?",
            answer: |q| spoil_rect(q, |_, chosen| chosen.pdf * (q.n * q.n) as f32),
        },
        Mistake {
            name: "multiplies the density per area by the cosine and divides it by the squared distance",
            hint: "Twice as far away, does a piece of the light fill more directions, or fewer? And how dense are they then?",
            answer: |q| {
                spoil_rect(q, |cosine, chosen| {
                    cosine / (chosen.distance.powi(2) * area(q))
                })
            },
        },
        Mistake {
            name: "chooses places on one half of the light only, a triangle",
            hint: "The light has four corners: into which of them do your places come?",
            answer: |q| chosen_rect(q, |u| if u.element_sum() > 1.0 { 1.0 - u } else { u }),
        },
        Mistake {
            name: "takes the distance to the light's middle in the density of every sample",
            hint: "Each sample has a distance of its own: from where to where is the distance in your density?",
            answer: |q| {
                let way = q.corner + 0.5 * (q.a + q.b) - q.at;
                spoil_rect(q, |cosine, _| way.length_squared() / (area(q) * cosine))
            },
        },
        Mistake {
            name: "takes the distance to the light's corner in the density of every sample",
            hint: "Each sample has a distance of its own: from where to where is the distance in your density?",
            answer: |q| {
                let square = q.corner.distance_squared(q.at);
                spoil_rect(q, |cosine, _| square / (area(q) * cosine))
            },
        },
        Mistake {
            name: "multiplies the density by the cosine at the light, and does not divide by it",
            hint: "A light that is seen from the side fills fewer directions: are they then denser, or less dense?",
            answer: |q| spoil_rect(q, |cosine, chosen| chosen.pdf * cosine * cosine),
        },
        Mistake {
            name: "takes the cosine at the light's corner, whatever the sample",
            hint: "Each sample has a distance and a cosine of its own: which direction is the cosine of?",
            answer: |q| {
                let way = q.corner - q.at;
                let cosine = -way.dot(q.a.cross(q.b).normalize_or_zero()) / way.length();
                spoil_rect(q, |_, chosen| chosen.distance.powi(2) / (area(q) * cosine))
            },
        },
        Mistake {
            name: "returns the distance of the light's plane, along its normal, for all points of it",
            hint: "Only one point of the plane is straight ahead of it: is the way to the others not longer?",
            answer: |q| {
                let normal = q.a.cross(q.b).normalize_or_zero();
                Some(chosen::changed(Self::right(q)?, |chosen| {
                    chosen.distance = (q.at - q.corner).dot(normal);
                }))
            },
        },
        Mistake {
            name: "multiplies the radiance by the density instead of dividing",
            hint: "A direction that is chosen often must count less: what does your product do?",
            answer: |q| {
                Some(chosen::changed(Self::right(q)?, |chosen| {
                    chosen.arriving = q.radiance * chosen.pdf;
                }))
            },
        },
    ];
}

/// The right answer for a light that shines to the other side.
fn from_behind(q: &SampleRect) -> Option<Vec<Chosen>> {
    SampleRect::right(&SampleRect {
        corner: q.corner + q.a,
        a: -q.a,
        ..q.clone()
    })
}

/// One over the least cosine at a light that can be told from 0.
const DENSE: f32 = 1e4;

/// Whether a point lies in the light's plane.
fn is_edge_on(q: &SampleRect) -> bool {
    let (way, normal) = (q.corner - q.at, q.a.cross(q.b).normalize_or_zero());
    DENSE * way.dot(normal).abs() < way.length()
}

/// Samples of a light that is seen edge-on, as of one that is seen: nothing arrives from infinitely dense directions.
fn edge_on(q: &SampleRect) -> Vec<Chosen> {
    let chosen = |u: Vec2| {
        let r = q.corner + u.x * q.a + u.y * q.b - q.at;
        Chosen {
            toward: r.normalize_or_zero(),
            distance: r.length(),
            pdf: f32::INFINITY,
            arriving: 0.0,
        }
    };
    lattice(q.n).map(chosen).collect()
}

fn area(q: &SampleRect) -> f32 {
    q.a.length() * q.b.length()
}

/// The right answer with another density, of the cosine at the light and the right choice.
fn spoil_rect(q: &SampleRect, pdf: impl Fn(f32, &Chosen) -> f32) -> Option<Vec<Chosen>> {
    let mut all = SampleRect::right(q)?;
    for chosen in &mut all {
        let cosine = -chosen.toward.dot(q.a.cross(q.b).normalize_or_zero());
        chosen.pdf = pdf(cosine, chosen);
        chosen.arriving = q.radiance / chosen.pdf;
    }
    Some(all)
}

/// Other points of the light, with the right density of uniform ones.
fn chosen_rect(q: &SampleRect, place: impl Fn(Vec2) -> Vec2) -> Option<Vec<Chosen>> {
    SampleRect::right(q)?;
    let chosen = |u: Vec2| {
        let p = place(u);
        let r = q.corner + p.x * q.a + p.y * q.b - q.at;
        let cosine = -r.dot(q.a.cross(q.b).normalize_or_zero()) / r.length();
        let pdf = r.length_squared() / (area(q) * cosine);
        Chosen {
            toward: r.normalize_or_zero(),
            distance: r.length(),
            pdf,
            arriving: q.radiance / pdf,
        }
    };
    Some(lattice(q.n).map(chosen).collect())
}
