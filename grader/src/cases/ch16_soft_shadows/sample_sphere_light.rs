//! `sample_sphere_light`: random questions, judge and mistakes.

use super::chosen::{self, DENSITY, FINE, MEAN, MEAN_ANGLE, N, each, evenly};
use super::cone::{
    angle, around, as_on_disc, cap, cone, dense, on_cap, on_disc, rise, squeezed, wide, with_sine,
};
use super::flaws;
use crate::{Flaw, Graded, Mistake, Relation, Verdict, judge, sample};
use glam::{Vec2, Vec3, dvec2, vec2};
use rand::RngExt;
use raybook::math::{basis::Basis, dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch16_soft_shadows::{Chosen, SampleSphereLight};
use std::f32::consts::{PI, TAU};

/// The distance at which a direction meets the light, and by how much it may be off.
///
/// r² less the square of the distance by which the ray passes the centre is the square of half the ray's way through the light. A
/// direction of six digits is off by 1e-6, and what it makes of a distance d of d² decides near the rim; one beside the light by a
/// last digit is taken for one that touches it.
pub(super) fn distance(q: &SampleSphereLight, chosen: &Chosen) -> (f64, f64) {
    let [at, center] = [q.at, q.center].map(Vec3::as_dvec3);
    let to_center = center - at;
    let toward = chosen.toward.as_dvec3().normalize_or_zero();
    let (radius, middle) = (f64::from(q.radius), to_center.dot(toward));
    let squared = radius * radius - (to_center - middle * toward).length_squared();
    let unsure = (1e-5 * to_center.length_squared()).max(-squared);
    let half = squared.max(0.0).sqrt();
    let right = if to_center.length() <= radius {
        middle + half
    } else {
        middle - half
    };
    let at_rim = (squared.max(0.0) + unsure).sqrt() - half;
    (right, f64::from(judge::RELATIVE) * right.abs() + at_rim)
}

impl Graded for SampleSphereLight {
    fn random(rng: &mut Pcg) -> SampleSphereLight {
        let (center, radius) = (sample::point(rng, 3.0), sample::number(rng, 0.3, 2.0));
        let away = match rng.random_range(0..8) {
            0 | 1 => sample::number(rng, 0.1, 0.9),
            2 => sample::number(rng, 500.0, 2000.0),
            _ => sample::number(rng, 1.2, 6.0),
        };
        SampleSphereLight {
            at: center + away * radius * *sample::direction(rng),
            center,
            radius,
            radiance: sample::number(rng, 0.5, 5.0),
            n: N,
        }
    }

    fn judge(q: &SampleSphereLight, _: &Self::Answer, got: &Self::Answer) -> Verdict {
        let cap = f64::from(cap(q));
        let axis = Dir3::new_or(q.center - q.at, Dir3::Y);
        // 1 − cos θ by the chord, which keeps its digits in a narrow cone.
        let height = |c: &Chosen| 0.5 * c.toward.as_dvec3().distance_squared(axis.as_dvec3());
        let pdf = (1.0 / (f64::from(TAU) * cap)) as f32;
        each(q.n, q.radiance, got, |chosen| {
            if height(chosen) > cap * 1.01 + 1e-6 {
                return Err("its direction misses the light".to_owned());
            }
            let (right, tolerance) = distance(q, chosen);
            // As `<=`, so that a NaN is off.
            let on_it = (f64::from(chosen.distance) - right).abs() <= tolerance;
            if !on_it {
                return Err(format!(
                    "at a distance of {} m, there is no point of the light that is seen",
                    judge::size(chosen.distance)
                ));
            }
            judge::number_within("the density", "/sr", pdf, chosen.pdf, DENSITY * pdf)
        })?;
        // In these coordinates, directions uniform in the cone are uniform in the unit square.
        let basis = Basis::around(axis);
        let place = |c: &Chosen| {
            let phi = c.toward.dot(*basis.y).atan2(c.toward.dot(*basis.x));
            dvec2(height(c) / cap, f64::from(phi / TAU + 0.5))
        };
        let places: Vec<_> = got.iter().map(place).collect();
        evenly("the directions", &places, dvec2(MEAN, MEAN_ANGLE))
    }

    fn traits(q: &SampleSphereLight, got: &Self::Answer) -> Vec<f64> {
        let cap = cap(q);
        let axis = Dir3::new_or(q.center - q.at, Dir3::Y);
        let basis = Basis::around(axis);
        // The angle counts from anywhere, in either sense: from the last sample, which is on no axis, to the side on which more of
        // the others are.
        let aside = |c: &Chosen| vec2(c.toward.dot(*basis.x), c.toward.dot(*basis.y));
        let last = got.last().map_or(Vec2::X, aside);
        let angle = |c: &Chosen| {
            let angle = last.angle_to(aside(c));
            if angle.is_finite() { angle } else { 0.0 }
        };
        let sense = got.iter().map(|c| angle(c).sin()).sum::<f32>().signum();
        let n = got.len().max(1) as f32;
        let place = |c: &Chosen| {
            // What is beside the light is beside it, however far; and of a distant light, single precision knows a few digits.
            let rounded = |v: f32| f64::from((400.0 * v).round() / 400.0);
            let height = (0.5 * c.toward.distance_squared(*axis) / cap).min(2.0);
            // Off the edges of the shares that are counted.
            let turn = sense * angle(c) / TAU + 0.28 / N as f32;
            dvec2(rounded(height), rounded(turn.rem_euclid(1.0)))
        };
        // From the centre all directions are alike, and any of them may be the axis.
        let has_axis = q.at != q.center;
        let places: Vec<_> = got.iter().filter(|_| has_axis).map(place).collect();
        let mut traits = chosen::traits(q.radiance, got, &places, |_| 1.0 / (TAU * cap));
        // Beside the light any distance is as wrong as another.
        let meets = |c: &&Chosen| 0.5 * c.toward.distance_squared(*axis) <= cap;
        let off = |c: &Chosen| f64::from(c.distance) - distance(q, c).0;
        let off = got.iter().filter(meets).map(off).sum::<f64>();
        traits.push(off / f64::from(q.radius * n));
        traits
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
            complaint: "its direction misses the light",
            name: "chooses directions that miss the light",
            hint: "How wide is the cone in which the light is seen?",
        },
        Flaw {
            complaint: "there is no point of the light that is seen",
            name: "returns a distance at which there is no point of the light",
            hint: "A ray meets a sphere twice: which of the two points is seen?",
        },
        flaws::DENSITY,
        flaws::RATIO,
        flaws::UNEVEN,
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "makes θ uniform in the place of cos θ",
            hint: "The wider a ring around the cone's axis, the more directions it holds: do your samples crowd in the middle?",
            answer: |q| {
                cone(q, |u, cap| {
                    let half = 0.5 * u.x * angle(cap);
                    (2.0 * half.sin().powi(2), TAU * u.y, 1.0 / (TAU * cap))
                })
            },
        },
        Mistake {
            name: "makes the directions of a whole hemisphere",
            hint: "How wide is the cone in which the light is seen?",
            answer: |q| cone(q, |u, cap| (u.x, TAU * u.y, 1.0 / (TAU * cap))),
        },
        Mistake {
            name: "returns the density of a whole hemisphere",
            hint: "The density is the inverse of the solid angle of the cone: how large is it?",
            answer: |q| cone(q, |u, cap| (u.x * cap, TAU * u.y, 1.0 / TAU)),
        },
        Mistake {
            name: "forgets 2π in the density",
            hint: "What is the area of a cap of height h on the unit sphere?",
            answer: |q| cone(q, |u, cap| (u.x * cap, TAU * u.y, 1.0 / cap)),
        },
        Mistake {
            name: "goes only half way round the axis",
            hint: "Look along the axis of the cone: on which sides of it are your samples?",
            answer: |q| cone(q, |u, cap| (u.x * cap, PI * u.y, 1.0 / (TAU * cap))),
        },
        Mistake {
            name: "lets 1 − cos α cancel",
            hint: "For a small, distant light cos α is rounded to 1: how can you get 1 − cos α from sin²α?",
            answer: |q| {
                let squared = (q.radius / q.at.distance(q.center)).powi(2);
                let cap = 1.0 - (1.0 - squared).max(0.0).sqrt();
                let cap = if squared < 1.0 { cap } else { 2.0 };
                cone(q, |u, _| (u.x * cap, TAU * u.y, 1.0 / (TAU * cap)))
            },
        },
        Mistake {
            name: "returns the distance of the sphere's far side",
            hint: "Which of the two points where the line meets the sphere is seen?",
            answer: |q| {
                chosen::changed(Self::right(q), |chosen| {
                    let middle = (q.center - q.at).dot(chosen.toward);
                    chosen.distance = middle + (middle - chosen.distance).abs();
                })
            },
        },
        Mistake {
            name: "returns the distance of the centre",
            hint: "The light's surface is nearer than its centre.",
            answer: |q| {
                let distance = q.at.distance(q.center);
                chosen::changed(Self::right(q), |chosen| {
                    chosen.distance = distance;
                })
            },
        },
        Mistake {
            name: "returns the distance of the sphere's nearest point for all directions",
            hint: "Only one of your directions goes through the sphere's centre: how far is the sphere along the others?",
            answer: |q| {
                let mut all = SampleSphereLight::right(q);
                let distance = q.at.distance(q.center) - q.radius;
                for chosen in all.iter_mut().filter(|_| distance > 0.0) {
                    chosen.distance = distance;
                }
                all
            },
        },
        Mistake {
            name: "chooses only half of all directions from inside the light",
            hint: "Inside the light, from which directions does no light come?",
            answer: |q| {
                let inside = q.at.distance(q.center) <= q.radius;
                cone(q, |u, cap| {
                    let cap = if inside { 1.0 } else { cap };
                    (u.x * cap, TAU * u.y, 1.0 / (TAU * cap))
                })
            },
        },
        Mistake {
            name: "takes the corners of the lattice's cells for their middles",
            hint: "The first pair is (½/n, ½/n): what is yours?",
            answer: |q| {
                cone(q, |u, cap| {
                    let u = u - 0.5 / q.n as f32;
                    (u.x * cap, TAU * u.y, 1.0 / (TAU * cap))
                })
            },
        },
        Mistake {
            name: "fills half of the cone only",
            hint: "How far from the axis do your directions go, and how far does the sphere?",
            answer: |q| cone(q, |u, cap| (0.5 * u.x * cap, TAU * u.y, 1.0 / (TAU * cap))),
        },
        Mistake {
            name: "uses one number for both angles",
            hint: "Do your directions fill the cone, or a curve in it?",
            answer: |q| cone(q, |u, cap| (u.x * cap, TAU * u.x, 1.0 / (TAU * cap))),
        },
        Mistake {
            name: "forgets the root in the cosine of the cone",
            hint: "The sine of the cone's angle is the radius over the distance: how do you get the cosine from the sine?",
            answer: |q| {
                let far = q.at.distance(q.center);
                let squared = (q.radius / far).powi(2);
                if squared < 1.0 {
                    wide(q, squared)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes the radius over the distance for the tangent of the cone, not for its sine",
            hint: "Draw the cone and the radius to where it touches the sphere: where is the right angle?",
            answer: |q| {
                let far = q.at.distance(q.center);
                if far > q.radius {
                    let sine = q.radius / far.hypot(q.radius);
                    wide(q, rise(sine * sine))
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "returns one over the area of the sphere for the density",
            hint: "In which unit is the density: per square metre, or per steradian?",
            answer: |q| {
                let pdf = 1.0 / (2.0 * TAU * q.radius * q.radius);
                let chosen = Self::right(q).into_iter();
                chosen
                    .map(|c| Chosen {
                        pdf,
                        arriving: q.radiance / pdf,
                        ..c
                    })
                    .collect()
            },
        },
        Mistake {
            name: "takes the sine of the cone's angle for its cosine",
            hint: "Draw the cone and the radius to where it touches the sphere: is the radius over the distance the sine of its angle, or the cosine?",
            answer: |q| {
                let far = q.at.distance(q.center);
                if far > q.radius {
                    wide(q, 1.0 - q.radius / far)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "forgets to square the radius over the distance for the cosine of the cone",
            hint: "The sine of the cone's angle is the radius over the distance: how do you get the cosine from the sine?",
            answer: |q| {
                let far = q.at.distance(q.center);
                if far > q.radius {
                    wide(q, rise(q.radius / far))
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes π for 2π in the density",
            hint: "What is the area of a cap of height h on the unit sphere?",
            answer: |q| cone(q, |u, cap| (u.x * cap, TAU * u.y, 1.0 / (PI * cap))),
        },
        Mistake {
            name: "takes 4π for 2π in the density",
            hint: "What is the area of a cap of height h on the unit sphere?",
            answer: |q| cone(q, |u, cap| (u.x * cap, TAU * u.y, 0.5 / (TAU * cap))),
        },
        Mistake {
            name: "returns the density of a whole sphere",
            hint: "The density is the inverse of the solid angle of the cone: how large is it?",
            answer: |q| cone(q, |u, cap| (u.x * cap, TAU * u.y, 0.5 / TAU)),
        },
        Mistake {
            name: "chooses among all directions, not only those to the light",
            hint: "From outside, a ball fills only a cone: how large is the angle from its axis at most?",
            answer: |q| cone(q, |u, _| (2.0 * u.x, TAU * u.y, 0.5 / TAU)),
        },
        Mistake {
            name: "makes the directions around +z, wherever the light is",
            hint: "The middle of all your directions points along one axis of the world: where is the light?",
            answer: |q| {
                around(q, Dir3::Z, |u, cap| {
                    (u.x * cap, TAU * u.y, 1.0 / (TAU * cap))
                })
            },
        },
        Mistake {
            name: "makes the directions around +y, wherever the light is",
            hint: "The middle of all your directions points along one axis of the world: where is the light?",
            answer: |q| {
                around(q, Dir3::Y, |u, cap| {
                    (u.x * cap, TAU * u.y, 1.0 / (TAU * cap))
                })
            },
        },
        Mistake {
            name: "makes the directions away from the light",
            hint: "From the point to the light: which of the two do you subtract from which?",
            answer: |q| {
                let away = -Dir3::new_or(q.center - q.at, Dir3::Y);
                around(q, away, |u, cap| (u.x * cap, TAU * u.y, 1.0 / (TAU * cap)))
            },
        },
        Mistake {
            name: "forgets the root in the sine of a direction's angle",
            hint: "sin² + cos² = 1: what do you have when you take cos² from 1? How long are your directions?",
            answer: |q| with_sine(q, |cosine| 1.0 - cosine * cosine),
        },
        Mistake {
            name: "takes 1 − cos θ for the sine of a direction's angle",
            hint: "sin² + cos² = 1: how do you get the sine from the cosine? How long are your directions?",
            answer: |q| with_sine(q, |cosine| 1.0 - cosine),
        },
        Mistake {
            name: "divides what arrives by the number of samples, too",
            hint: "Each sample stands for the whole light: who takes the mean of them, this function or the one that calls it?",
            answer: |q| {
                chosen::changed(Self::right(q), |chosen| {
                    chosen.arriving /= (q.n * q.n) as f32;
                })
            },
        },
        Mistake {
            name: "takes the diameter for the radius in the cone's angle",
            hint: "Draw the cone and the radius to where it touches the sphere: how long is the side across from its angle?",
            answer: |q| {
                let squared = (2.0 * q.radius / q.at.distance(q.center)).powi(2);
                if squared < 1.0 {
                    wide(q, rise(squared))
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes πr²/d² for the solid angle, which is right far away only",
            hint: "From close by, does a ball look as large as a flat disc at the distance of its centre?",
            answer: |q| {
                let squared = (q.radius / q.at.distance(q.center)).powi(2);
                cone(q, |u, cap| {
                    let solid = if squared < 1.0 {
                        PI * squared
                    } else {
                        TAU * cap
                    };
                    (u.x * cap, TAU * u.y, 1.0 / solid)
                })
            },
        },
        Mistake {
            name: "chooses among the directions of the whole hemisphere around the light's middle, with its density",
            hint: "From outside, a ball fills only a cone: how large is the angle from its axis at most?",
            answer: |q| wide(q, 1.0),
        },
        Mistake {
            name: "returns the distance of the ray's point that is nearest to the centre",
            hint: "There the ray is deep inside the light: how far before that point does the ray enter it?",
            answer: |q| {
                let mut all = Self::right(q);
                let is_outside = q.at.distance(q.center) > q.radius;
                for chosen in all.iter_mut().filter(|_| is_outside) {
                    chosen.distance = (q.center - q.at).dot(chosen.toward);
                }
                all
            },
        },
        Mistake {
            name: "takes πr²/d² for the solid angle, from inside the light too",
            hint: "From close by, does a ball look as large as a flat disc at the distance of its centre? And from inside?",
            answer: |q| {
                let squared = q.at.distance_squared(q.center).max(1e-9);
                dense(q, |_| squared / (PI * q.radius * q.radius))
            },
        },
        Mistake {
            name: "takes tan α = r/√(d² − r²) for the sine of the cone's angle α",
            hint: "Draw the cone and the radius to where it touches the sphere: across from the right angle, which side is it?",
            answer: |q| {
                let squared = (q.radius / q.at.distance(q.center)).powi(2);
                if squared < 1.0 {
                    wide(q, rise((squared / (1.0 - squared)).min(1.0)))
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes the root of the uniform number that makes cos θ",
            hint: "How is cos θ made of a number from 0 to 1, if all directions are equally likely: do your samples crowd at the rim?",
            answer: |q| cone(q, |u, cap| (u.x.sqrt() * cap, TAU * u.y, 1.0 / (TAU * cap))),
        },
        Mistake {
            name: "spreads the lattice from border to border of the cone",
            hint: "The first pair is (½/n, ½/n): what is yours?",
            answer: |q| {
                let n = q.n.max(2) as f32;
                cone(q, |u, cap| {
                    let u = 0.5 + (u - 0.5) * n / (n - 1.0);
                    (u.x * cap, TAU * u.y, 1.0 / (TAU * cap))
                })
            },
        },
        Mistake {
            name: "returns the distance of the nearer hit from inside too, which is behind the point",
            hint: "Inside the light, which of the two points where the line meets the sphere is ahead?",
            answer: |q| {
                let is_inside = q.at.distance(q.center) <= q.radius;
                let mut all = Self::right(q);
                for chosen in all.iter_mut().filter(|_| is_inside) {
                    let middle = (q.center - q.at).dot(chosen.toward);
                    chosen.distance = 2.0 * middle - chosen.distance;
                }
                all
            },
        },
        Mistake {
            name: "chooses places on the disc through the light's centre, with the density of the cone",
            hint: "A disc on which all places are equally likely: are the directions to it, too?",
            answer: |q| {
                let pdf = 1.0 / (TAU * cap(q));
                let mut all = on_disc(q, |_, _| 1.0);
                for chosen in &mut all {
                    chosen.pdf = pdf;
                    chosen.arriving = q.radiance / pdf;
                }
                all
            },
        },
        Mistake {
            name: "chooses places on the disc through the light's centre, with their density",
            hint: "Where does the cone touch the sphere: at the disc through its centre, or before that?",
            answer: |q| on_disc(q, |cosine, disc| 1.0 / (disc * cosine.powi(3))),
        },
        Mistake {
            name: "chooses places on the whole surface of the sphere, on its far side too",
            hint: "How much of the ball's surface do you see from the point?",
            answer: |q| on_cap(q, Dir3::Z, 2.0),
        },
        Mistake {
            name: "takes each direction's own angle for the cone's in the density",
            hint: "All directions of the cone are equally likely: do their densities differ?",
            answer: |q| dense(q, |height| 1.0 / (TAU * height.max(1e-9))),
        },
        Mistake {
            name: "does not normalise the axes beside the cone's, made by cross products with +y",
            hint: "How long is the cross product of two vectors of length 1 that are not perpendicular?",
            answer: |q| squeezed(q, Vec3::Y),
        },
        Mistake {
            name: "does not normalise the axes beside the cone's, made by cross products with +z",
            hint: "How long is the cross product of two vectors of length 1 that are not perpendicular?",
            answer: |q| squeezed(q, Vec3::Z),
        },
        Mistake {
            name: "chooses places on the half of the sphere that faces the point",
            hint: "How much of a ball do you see from close by: half of its surface, or less?",
            answer: |q| {
                if q.at.distance(q.center) > q.radius {
                    on_cap(q, Dir3::new_or(q.at - q.center, Dir3::Y), 1.0)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "makes sin²θ uniform in the place of cos θ",
            hint: "What is the area of a cap of height h on the unit sphere? How many of your samples are in the upper half of the cone's cap?",
            answer: |q| {
                cone(q, |u, cap| {
                    let squared = u.x * cap * (2.0 - cap);
                    // From inside, where the sine says nothing, cos θ is uniform.
                    let height = if cap < 2.0 { rise(squared) } else { u.x * cap };
                    (height, TAU * u.y, 1.0 / (TAU * cap))
                })
            },
        },
        Mistake {
            name: "makes θ² uniform in the place of cos θ, as on a flat disc",
            hint: "The rings around the cone's axis grow with sin θ, those of a flat disc with the radius: where do they differ most, in a narrow cone, or inside the light?",
            answer: |q| as_on_disc(q, |cap| 1.0 / (TAU * cap)),
        },
        Mistake {
            name: "takes the cone for a flat disc whose radius is the cone's angle, for the directions and their density",
            hint: "From inside the light, its directions fill a whole sphere: how large is that, and how large is your disc?",
            answer: |q| as_on_disc(q, |cap| 1.0 / (PI * angle(cap).powi(2))),
        },
        Mistake {
            name: "takes π times the square of the cone's angle for the solid angle",
            hint: "What is the area of a cap of height h on the unit sphere? Is it as large as a flat disc whose radius is the arc?",
            answer: |q| {
                cone(q, |u, cap| {
                    let solid = PI * angle(cap).powi(2);
                    (u.x * cap, TAU * u.y, 1.0 / solid)
                })
            },
        },
        Mistake {
            name: "multiplies the radiance by the density instead of dividing",
            hint: "A direction that is chosen often must count less: what does your product do?",
            answer: |q| {
                chosen::changed(Self::right(q), |chosen| {
                    chosen.arriving = q.radiance * chosen.pdf;
                })
            },
        },
    ];
}
