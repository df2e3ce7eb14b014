//! `sample_environment`: random questions and mistakes; [`super::distributed`] judges.

mod samplers;

use super::OfMap;
use super::{cell, distributed, toward};
use crate::examine::RANDOM_CASES;
use crate::together::Bounds;
use crate::{Flaw, Graded, Mistake, Verdict, judge, sample, traits};
use glam::{Vec2, Vec3, vec2};
use rand::RngExt;
use raybook::light::environment::latlong;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch17_rendering_equation::lattice;
use raybook_workbook::exercises::ch18_environment::{POINTS, SampleEnvironment};
use samplers::{
    Asked, by_angle, by_solid_angle, cut_off, direction, elsewhere, in_one_list, in_rows, listed,
    of_row, of_whole, raised, rest_of_number, sine, sine_from_end_to_end, sine_without_ends,
};

impl Graded for SampleEnvironment {
    fn random(rng: &mut Pcg) -> SampleEnvironment {
        let (width, height) = (rng.random_range(2..5), rng.random_range(2..5));
        let texels = (0..width * height)
            .map(|_| sample::number(rng, 0.1, 2.0).powi(3))
            .collect();
        SampleEnvironment {
            width,
            height,
            texels,
        }
    }

    /// By distribution: of the lattice's points, the right share must be in every part of the sphere.
    fn judge(q: &SampleEnvironment, golden: &Vec<Vec3>, got: &Vec<Vec3>) -> Verdict {
        if golden.len() != got.len() {
            return Err(format!(
                "there are {} directions, and should be {}",
                got.len(),
                golden.len()
            ));
        }
        for (i, direction) in got.iter().enumerate() {
            if (direction.length() - 1.0).abs() > judge::LENGTH || !direction.is_finite() {
                return Err(format!("direction {i} has length {}", direction.length()));
            }
        }
        distributed::distributed(q, got)
    }

    fn together(answers: &[(SampleEnvironment, Vec<Vec3>)], _: Bounds) -> Verdict {
        if answers.len() < RANDOM_CASES {
            return Ok(());
        }
        distributed::together(answers)
    }

    fn traits(q: &SampleEnvironment, got: &Vec<Vec3>) -> Vec<f64> {
        let (width, height) = (q.width as usize, q.height as usize);
        let places: Vec<_> = got
            .iter()
            .map(|d| latlong::place(toward(d.x, d.y, d.z)))
            .collect();
        let n = places.len().max(1) as f64;
        // Where the directions are in their texels, and how much light there is in these by the mean.
        let in_texel = |p: &Vec2| {
            let place = p.as_dvec2() * vec2(width as f32, height as f32).as_dvec2();
            place - place.floor()
        };
        let mut traits = traits::of_square(&places.iter().map(in_texel).collect::<Vec<_>>());
        let all = q.all_light();
        let share = |p: &Vec2| q.light(cell(p.x, q.width), cell(p.y, q.height)) / all;
        let texel = |p: &Vec2| q.texel(cell(p.x, q.width), cell(p.y, q.height));
        let texels = (width * height) as f64;
        let mean = q.texels.iter().map(|v| f64::from(*v)).sum::<f64>() / texels;
        traits.push(
            places
                .iter()
                .map(|p| (texels * share(p)).min(100.0))
                .sum::<f64>()
                / n,
        );
        traits.push(
            places
                .iter()
                .map(|p| (texel(p) / mean).min(100.0))
                .sum::<f64>()
                / n,
        );
        traits.push(
            places
                .iter()
                .map(|p| (std::f64::consts::PI * f64::from(p.y)).sin())
                .sum::<f64>()
                / n,
        );
        traits.push(places.iter().filter(|p| texel(p) == 0.0).count() as f64 / n);
        traits.extend(traits::shares(got.iter().map(|d| d.y.into()), -1.0, 1.0));
        traits.extend(traits::shares(places.iter().map(|p| p.x.into()), 0.0, 1.0));
        traits.push(got.iter().map(|d| f64::from(d.length())).sum::<f64>() / n);
        traits
    }

    const FIXED: &'static [&'static str] = &["width", "height", "texels"];

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "directions, and should be",
            name: "makes another number of directions than asked",
            hint: "How many are asked, and how many if the map is black?",
        },
        Flaw {
            complaint: "has length",
            name: "does not return directions of length 1",
            hint: "How do you get the sine from the cosine?",
        },
        Flaw {
            complaint: "the black texel",
            name: "chooses texels that are black",
            hint: "May a texel without light be chosen at all? Is the sum compared with < or with ≤?",
        },
        Flaw {
            complaint: "in column",
            name: "gives some texels more directions than their light is worth, and others fewer",
            hint: "What does a texel weigh: its radiance, or its radiance times its solid angle? Which direction belongs to which row and column?",
        },
        Flaw {
            complaint: "of +y",
            name: "does not spread the directions evenly within a row",
            hint: "Within a row of texels, which must be spread evenly: the cosine of the angle from +y, or the angle?",
        },
        Flaw {
            complaint: "of a texel's width",
            name: "does not spread the directions evenly from a texel's left edge to its right one",
            hint: "Can a direction be anywhere in its texel, close to its left edge and to its right one?",
        },
        Flaw {
            complaint: "of a texel's height",
            name: "does not spread the directions evenly from a texel's upper edge to its lower one",
            hint: "Can a direction be anywhere in its texel, close to its upper edge and to its lower one? By the angle, or by the area?",
        },
        Flaw {
            complaint: "a diagonal of their texels",
            name: "makes both places in a texel, from left to right and from top to bottom, of one number",
            hint: "How many numbers are given for a direction, and of which of them is each of its two places in the texel made?",
        },
        Flaw {
            complaint: "rows at",
            name: "weighs some rows a little too much, which no single answer shows",
            hint: "What does a texel of each row weigh: its radiance times which solid angle? Is it the same for the first row and the last?",
        },
        Flaw {
            complaint: "columns at",
            name: "weighs some columns a little too much, which no single answer shows",
            hint: "Do all texels of a row have the same solid angle in your sums, the first and the last too?",
        },
        Flaw {
            complaint: "texels are chosen slightly too often",
            name: "weighs bright texels a little too much, or too little",
            hint: "How often is a texel chosen that is twice as bright as another of the same size?",
        },
        Flaw {
            complaint: "on the map",
            name: "does not spread the directions evenly within a column",
            hint: "Can a direction be anywhere in its texel, from its left edge to its right one?",
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "weighs all rows as if they were equally wide",
            hint: "The rows near the poles are as long on the map as the others: are they on the sphere?",
            answer: |q| q.sampled(SampleEnvironment::texel, by_solid_angle),
        },
        Mistake {
            name: "spreads the directions of a row evenly by angle, not by area",
            hint: "Equal steps of the angle from a pole sweep unequal areas of the sphere: what does sweep equal ones?",
            answer: |q| q.sampled(|q, x, y| q.texel(x, y) * q.solid_angle(y), by_angle),
        },
        Mistake {
            name: "ignores how bright the texels are",
            hint: "Where is most of the light? Most of your directions should be there.",
            answer: |q| q.sampled(|q, _, y| q.solid_angle(y), by_solid_angle),
        },
        Mistake {
            name: "chooses all texels equally often",
            hint: "Does a bright texel get more directions than a dark one, and a large texel more than a small one?",
            answer: |q| q.sampled(|_, _, _| 1.0, by_solid_angle),
        },
        Mistake {
            name: "weighs by the square of the radiance",
            hint: "A texel twice as bright should be chosen twice as often: how often is it?",
            answer: |q| {
                q.sampled(
                    |q, x, y| q.texel(x, y).powi(2) * q.solid_angle(y),
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "chooses the column without regard to the row",
            hint: "Two bright texels in different rows: do you ever choose the row of one and the column of the other?",
            answer: |q| {
                q.sampled(
                    |q, x, y| {
                        let column: f64 = (0..q.height as usize).map(|y| q.share(x, y)).sum();
                        let row: f64 = (0..q.width as usize).map(|x| q.share(x, y)).sum();
                        column * row
                    },
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "always takes the middle of a texel",
            hint: "Are two directions in the same texel ever different? All of the texel shines.",
            answer: |q| {
                let centre = |d: &Vec3| {
                    let place = latlong::place(toward(d.x, d.y, d.z));
                    let (x, y) = (cell(place.x, q.width), cell(place.y, q.height));
                    *latlong::direction(vec2(
                        (x as f32 + 0.5) / q.width as f32,
                        (y as f32 + 0.5) / q.height as f32,
                    ))
                };
                Self::right(q).iter().map(centre).collect()
            },
        },
        Mistake {
            name: "has the map upside down",
            hint: "Which row is at the top, and which direction is up?",
            answer: |q| {
                Self::right(q)
                    .into_iter()
                    .map(|d| d * Vec3::new(1.0, -1.0, 1.0))
                    .collect()
            },
        },
        Mistake {
            name: "is half a turn off",
            hint: "Which column is straight ahead, the first or the middle one?",
            answer: |q| {
                Self::right(q)
                    .into_iter()
                    .map(|d| d * Vec3::new(-1.0, 1.0, -1.0))
                    .collect()
            },
        },
        Mistake {
            name: "is a quarter turn off, to the right",
            hint: "Which column is straight ahead, and from which axis do you count the angle around?",
            answer: |q| {
                let all = Self::right(q).into_iter();
                all.map(|d| Vec3::new(-d.z, d.y, d.x)).collect()
            },
        },
        Mistake {
            name: "is a quarter turn off, to the left",
            hint: "Which column is straight ahead, and from which axis do you count the angle around?",
            answer: |q| {
                let all = Self::right(q).into_iter();
                all.map(|d| Vec3::new(d.z, d.y, -d.x)).collect()
            },
        },
        Mistake {
            name: "has left and right exchanged",
            hint: "To which side of the middle do the columns with larger numbers lie?",
            answer: |q| {
                Self::right(q)
                    .into_iter()
                    .map(|d| d * Vec3::new(-1.0, 1.0, 1.0))
                    .collect()
            },
        },
        Mistake {
            name: "has front and back exchanged",
            hint: "Which direction is in the middle of the map?",
            answer: |q| {
                Self::right(q)
                    .into_iter()
                    .map(|d| d * Vec3::new(1.0, 1.0, -1.0))
                    .collect()
            },
        },
        Mistake {
            name: "always takes the middle between a texel's upper and lower edge",
            hint: "Can a direction be anywhere in its texel, near the upper edge too?",
            answer: |q| {
                q.sampled(
                    |q, x, y| q.texel(x, y) * q.solid_angle(y),
                    |top, bottom, _| (0.5 * (top.acos() + bottom.acos())).cos(),
                )
            },
        },
        Mistake {
            name: "always takes the middle between a texel's left and right edge",
            hint: "Can a direction be anywhere in its texel, near the left edge too?",
            answer: |q| elsewhere(q, |_, [x, y], [_, down]| ([x, y], [0.5, down])),
        },
        Mistake {
            name: "exchanges rows and columns of the list",
            hint: "Which texel is the second of the list: the one to the right of the first, or the one below the first?",
            answer: |q| {
                q.sampled(
                    |q, x, y| {
                        let there = q.texels[x * q.height as usize + y];
                        f64::from(there) * q.solid_angle(y)
                    },
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "divides by the number of rows, not by the width, to find a texel's row and column",
            hint: "How many texels come in the list before the first one of the second row?",
            answer: |q| {
                elsewhere(q, |q, [x, y], within| {
                    let number = y * q.width as usize + x;
                    let height = q.height as usize;
                    ([number % height, number / height], within)
                })
            },
        },
        Mistake {
            name: "is one row too low",
            hint: "Which row begins at the top of the map, with the cosine 1?",
            answer: |q| elsewhere(q, |_, [x, y], within| ([x, y + 1], within)),
        },
        Mistake {
            name: "is one row too high",
            hint: "Which row begins at the top of the map, with the cosine 1?",
            answer: |q| elsewhere(q, |_, [x, y], within| ([x, y.saturating_sub(1)], within)),
        },
        Mistake {
            name: "is one column too far right",
            hint: "Which column begins at the left edge of the map?",
            answer: |q| elsewhere(q, |_, [x, y], within| ([x + 1, y], within)),
        },
        Mistake {
            name: "is half a texel off to the right",
            hint: "From where to where does your direction go in its texel: from its left edge to its right one?",
            answer: |q| elsewhere(q, |_, at, [right, down]| (at, [right + 0.5, down])),
        },
        Mistake {
            name: "weighs by the sine at a row's upper edge",
            hint: "How large is the solid angle of your first row?",
            answer: |q| q.sampled(|q, x, y| q.texel(x, y) * sine(q, y, 0.0), by_solid_angle),
        },
        Mistake {
            name: "weighs by the sine at a row's lower edge",
            hint: "How large is the solid angle of your last row?",
            answer: |q| q.sampled(|q, x, y| q.texel(x, y) * sine(q, y, 1.0), by_solid_angle),
        },
        Mistake {
            name: "weighs by the cosine of the angle from +y in the place of its sine",
            hint: "Where is a texel widest on the sphere: at the horizon, or at a pole?",
            answer: |q| {
                q.sampled(
                    |q, x, y| {
                        let angle = std::f64::consts::PI * (y as f64 + 0.5) / f64::from(q.height);
                        q.texel(x, y) * (angle.cos().abs() + 1e-9)
                    },
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "always takes a texel's left edge",
            hint: "Can a direction be anywhere in its texel, near the right edge too?",
            answer: |q| elsewhere(q, |_, at, [_, down]| (at, [0.0, down])),
        },
        Mistake {
            name: "always takes a texel's upper edge",
            hint: "Can a direction be anywhere in its texel, near the lower edge too?",
            answer: |q| elsewhere(q, |_, at, [right, _]| (at, [right, 0.0])),
        },
        Mistake {
            name: "goes only half of the way around",
            hint: "From the left edge of the map to its right one, by which angle do you turn?",
            answer: |q| {
                let all = Self::right(q).into_iter();
                let halved = |d: Vec3| {
                    let place = latlong::place(toward(d.x, d.y, d.z));
                    *latlong::toward(0.25 + 0.5 * place.x, f64::from(d.y))
                };
                all.map(halved).collect()
            },
        },
        Mistake {
            name: "takes the number that chose a texel for the place in it as it is",
            hint: "The numbers that choose a texel are close together: how do they become numbers from 0 to 1?",
            answer: |q| in_one_list(q, |q, texel, _, u| (in_rows(q, texel), u.to_array())),
        },
        Mistake {
            name: "takes the numbers that chose row and column for the place in the texel as they are",
            hint: "The numbers that choose a row are close together: how do they become numbers from 0 to 1?",
            answer: |q| {
                let places = Self::right(q).into_iter().zip(lattice(POINTS));
                let moved = |(d, u): (Vec3, Vec2)| {
                    let place = latlong::place(toward(d.x, d.y, d.z));
                    let texel = [cell(place.x, q.width), cell(place.y, q.height)];
                    direction(q, (texel, u.to_array()))
                };
                places.map(moved).collect()
            },
        },
        Mistake {
            name: "takes the texel before the one that the number falls into",
            hint: "Add up the lights: where in the sums does the first texel begin, and where does it end?",
            answer: |q| {
                in_one_list(q, |q, texel, left, u| {
                    (in_rows(q, texel.saturating_sub(1)), [left, u.y])
                })
            },
        },
        Mistake {
            name: "takes the texel after the one that the number falls into",
            hint: "Add up the lights: where in the sums does the first texel begin, and where does it end?",
            answer: |q| {
                in_one_list(q, |q, texel, left, u| {
                    let next = (texel + 1).min(q.texels.len() - 1);
                    (in_rows(q, next), [left, u.y])
                })
            },
        },
        Mistake {
            name: "makes every circle of latitude as large as the horizon, and normalises",
            hint: "Near a pole, how far from the axis is a direction of length 1?",
            answer: |q| {
                let all = Self::right(q).into_iter();
                let level = |d: Vec3| Vec3::new(d.x, 0.0, d.z).normalize_or_zero();
                all.map(|d| (level(d) + d.y * Vec3::Y).normalize_or_zero())
                    .collect()
            },
        },
        Mistake {
            name: "always takes the brightest texel",
            hint: "Two texels are lit, one a little brighter: does the other one get no direction?",
            answer: |q| {
                q.sampled(
                    |q, x, y| {
                        let most = q.texels.iter().copied().fold(0.0, f32::max);
                        let is_brightest = q.texel(x, y) == f64::from(most);
                        if is_brightest { q.light(x, y) } else { 0.0 }
                    },
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "adds a tenth of the mean to each texel before it chooses one",
            hint: "How often should a texel of radiance 1 be chosen beside one of radiance 3, both as large? And a black one?",
            answer: |q| {
                q.sampled(
                    |q, x, y| {
                        let sum: f64 = q.texels.iter().map(|t| f64::from(*t)).sum();
                        raised(q, x, y, 0.1 * sum / q.texels.len() as f64)
                    },
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "adds the darkest texel's radiance to each texel before it chooses one",
            hint: "How often should a texel of radiance 1 be chosen beside one of radiance 3, both as large? And a black one?",
            answer: |q| {
                q.sampled(
                    |q, x, y| {
                        let least = q.texels.iter().copied().fold(f32::INFINITY, f32::min);
                        raised(q, x, y, least.into())
                    },
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "adds a small number such as 0.01 to each texel before it chooses one",
            hint: "With which probability is a black texel to be chosen, and what is the answer for a black map?",
            answer: |q| q.sampled(|q, x, y| raised(q, x, y, 0.01), by_solid_angle),
        },
        Mistake {
            name: "weighs a row by its sine twice",
            hint: "Where does the sine stand in your sums: in the weight of a texel, in that of a row, or in both?",
            answer: |q| {
                q.sampled(
                    |q, x, y| q.texel(x, y) * sine(q, y, 0.5).powi(2),
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "cuts the radiance off at 1 before it chooses a texel",
            hint: "A texel of radiance 8 should be chosen eight times as often as one of radiance 1 that is as large: how often is it?",
            answer: |q| q.sampled(|q, x, y| cut_off(q, x, y, 1.0), by_solid_angle),
        },
        Mistake {
            name: "cuts the radiance off at 2, or near it, before it chooses a texel",
            hint: "A texel of radiance 8 should be chosen eight times as often as one of radiance 1 that is as large: how often is it?",
            answer: |q| q.sampled(|q, x, y| cut_off(q, x, y, 2.0), by_solid_angle),
        },
        Mistake {
            name: "cuts the radiance off at 4, or near it, before it chooses a texel",
            hint: "A texel of radiance 8 should be chosen eight times as often as one of radiance 1 that is as large: how often is it?",
            answer: |q| q.sampled(|q, x, y| cut_off(q, x, y, 4.0), by_solid_angle),
        },
        Mistake {
            name: "cuts the radiance off at 1 before it chooses a texel (of one list of all)",
            hint: "A texel of radiance 8 should be chosen eight times as often as one of radiance 1 that is as large: how often is it?",
            answer: |q| listed(q, |q, x, y| cut_off(q, x, y, 1.0), rest_of_number),
        },
        Mistake {
            name: "cuts the radiance off at 2, or near it, before it chooses a texel (of one list of all)",
            hint: "A texel of radiance 8 should be chosen eight times as often as one of radiance 1 that is as large: how often is it?",
            answer: |q| listed(q, |q, x, y| cut_off(q, x, y, 2.0), rest_of_number),
        },
        Mistake {
            name: "cuts the radiance off at 4, or near it, before it chooses a texel (of one list of all)",
            hint: "A texel of radiance 8 should be chosen eight times as often as one of radiance 1 that is as large: how often is it?",
            answer: |q| listed(q, |q, x, y| cut_off(q, x, y, 4.0), rest_of_number),
        },
        Mistake {
            name: "weighs by the root of the radiance (in one list of all texels)",
            hint: "A texel twice as bright should be chosen twice as often: how often is it?",
            answer: |q| {
                listed(
                    q,
                    |q, x, y| q.texel(x, y).sqrt() * q.solid_angle(y),
                    rest_of_number,
                )
            },
        },
        Mistake {
            name: "weighs by the root of the radiance",
            hint: "A texel twice as bright should be chosen twice as often: how often is it?",
            answer: |q| {
                q.sampled(
                    |q, x, y| q.texel(x, y).sqrt() * q.solid_angle(y),
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "chooses all rows equally often that are not black",
            hint: "How often should a row be chosen that has twice as much light as another?",
            answer: |q| {
                q.sampled(
                    |q, x, y| q.light(x, y) / of_row(q, y).max(1e-30),
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "chooses all texels of a row equally often",
            hint: "In a row with one bright texel, how often is that one chosen?",
            answer: |q| q.sampled(|q, _, y| of_row(q, y), by_solid_angle),
        },
        Mistake {
            name: "chooses a row by its brightest texel",
            hint: "What is the light of a row with many texels: that of one of them, or of all?",
            answer: |q| {
                q.sampled(
                    |q, x, y| {
                        let row = (0..q.width as usize).map(|x| q.light(x, y));
                        let most = row.fold(0.0, f64::max);
                        q.light(x, y) / of_row(q, y).max(1e-30) * most
                    },
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "weighs row y by sin(π (y + 1)/(height + 1))",
            hint: "How large is the solid angle of your first row? From which angle to which does it go, and which share of the rows is that?",
            answer: |q| {
                q.sampled(
                    |q, x, y| q.texel(x, y) * sine_without_ends(q, y),
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "weighs row y by sin(π (y + 1)/(height + 1)) (in one list of all texels)",
            hint: "How large is the solid angle of your first row? From which angle to which does it go, and which share of the rows is that?",
            answer: |q| {
                listed(
                    q,
                    |q, x, y| q.texel(x, y) * sine_without_ends(q, y),
                    rest_of_number,
                )
            },
        },
        Mistake {
            name: "weighs row y by sin(π y/(height − 1)), and so nearly never chooses the first row and the last",
            hint: "How large is the solid angle of your first row? From which angle to which does it go, and which share of the rows is that?",
            answer: |q| {
                q.sampled(
                    |q, x, y| q.texel(x, y) * sine_from_end_to_end(q, y),
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "weighs row y by sin(π y/(height − 1)), and so nearly never chooses the first row and the last (in one list of all texels)",
            hint: "How large is the solid angle of your first row? From which angle to which does it go, and which share of the rows is that?",
            answer: |q| {
                listed(
                    q,
                    |q, x, y| q.texel(x, y) * sine_from_end_to_end(q, y),
                    rest_of_number,
                )
            },
        },
        Mistake {
            name: "weighs a row by the root of its sine (in one list of all texels)",
            hint: "What does a texel of each row weigh: its radiance times which solid angle?",
            answer: |q| {
                listed(
                    q,
                    |q, x, y| q.texel(x, y) * sine(q, y, 0.5).sqrt(),
                    rest_of_number,
                )
            },
        },
        Mistake {
            name: "cuts the light of a texel off at 30 % of all light (in one list of all texels)",
            hint: "A sun brings nine tenths of all light: how many of ten directions should lead to it?",
            answer: |q| listed(q, |q, x, y| of_whole(q, x, y, 0.3), rest_of_number),
        },
        Mistake {
            name: "cuts the light of a texel off at half of all light (in one list of all texels)",
            hint: "A sun brings nine tenths of all light: how many of ten directions should lead to it?",
            answer: |q| listed(q, |q, x, y| of_whole(q, x, y, 0.5), rest_of_number),
        },
        Mistake {
            name: "cuts the light of a texel off at a tenth of all light (in one list of all texels)",
            hint: "A sun brings nine tenths of all light: how many of ten directions should lead to it?",
            answer: |q| listed(q, |q, x, y| of_whole(q, x, y, 0.1), rest_of_number),
        },
        Mistake {
            name: "cuts the light of a texel off at 30 % of all light",
            hint: "A sun brings nine tenths of all light: how many of ten directions should lead to it?",
            answer: |q| q.sampled(|q, x, y| of_whole(q, x, y, 0.3), by_solid_angle),
        },
        Mistake {
            name: "cuts the light of a texel off at half of all light",
            hint: "A sun brings nine tenths of all light: how many of ten directions should lead to it?",
            answer: |q| q.sampled(|q, x, y| of_whole(q, x, y, 0.5), by_solid_angle),
        },
        Mistake {
            name: "cuts the light of a texel off at a tenth of all light",
            hint: "A sun brings nine tenths of all light: how many of ten directions should lead to it?",
            answer: |q| q.sampled(|q, x, y| of_whole(q, x, y, 0.1), by_solid_angle),
        },
        Mistake {
            name: "cuts the light of a texel off at a fifth of all light (in one list of all texels)",
            hint: "A sun brings nine tenths of all light: how many of ten directions should lead to it?",
            answer: |q| listed(q, |q, x, y| of_whole(q, x, y, 0.2), rest_of_number),
        },
        Mistake {
            name: "cuts the light of a texel off at a fifth of all light",
            hint: "A sun brings nine tenths of all light: how many of ten directions should lead to it?",
            answer: |q| q.sampled(|q, x, y| of_whole(q, x, y, 0.2), by_solid_angle),
        },
    ];
}
