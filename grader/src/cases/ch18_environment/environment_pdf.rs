//! `environment_pdf`: the number itself.

mod densities;

use self::densities::{
    OfDensity, between, by_own_sine, by_row_and_column, density, from_the_middle, is_at_pole,
    quarters, rounded, tenth,
};
use super::{OfMap, toward};
use crate::{Graded, Mistake, Picture, Verdict, judge, sample};
use glam::vec2;
use raybook::light::environment::latlong;
use raybook::math::pcg::Pcg;
use raybook_chapters::kit::palette::viridis;
use raybook_workbook::exercises::ch18_environment::{EnvironmentPdf, SampleEnvironment};
use std::f64::consts::PI;

impl Graded for EnvironmentPdf {
    fn random(rng: &mut Pcg) -> EnvironmentPdf {
        let map = SampleEnvironment::random(rng);
        EnvironmentPdf {
            direction: sample::direction(rng),
            width: map.width,
            height: map.height,
            texels: map.texels,
        }
    }

    fn judge(_q: &EnvironmentPdf, golden: &f32, got: &f32) -> Verdict {
        let tolerance = judge::RELATIVE * golden.abs().max(1e-3);
        judge::number_within("the density", "per steradian", *golden, *got, tolerance)
    }

    const FIXED: &'static [&'static str] = &["width", "height", "texels"];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "returns the probability of the texel",
            hint: "A probability becomes a density when it is divided by something: what is the unit of the answer?",
            answer: |q| density(q, |how| how.area = Some(|_, _| 1.0)),
        },
        Mistake {
            name: "returns the density on the map, not on the sphere",
            hint: "How many steradians is the unit square of the map, and is it the same everywhere on it?",
            answer: |q| density(q, |how| how.area = Some(|q, _| q.of_one(1.0))),
        },
        Mistake {
            name: "takes the sine at the direction for the whole texel",
            hint: "Directions are uniform inside a texel: does your density differ between two directions of the same texel?",
            answer: |q| density(q, |how| how.area = Some(by_own_sine)),
        },
        Mistake {
            name: "multiplies by the sine at the direction once more",
            hint: "A density per steradian is uniform inside a texel: does yours differ between two directions of the same texel?",
            answer: |q| Self::right(q) * q.direction.x.hypot(q.direction.z),
        },
        Mistake {
            name: "forgets that rows differ in solid angle when it chooses them",
            hint: "For a constant map the density must be 1/(4π) everywhere: is it, near a pole?",
            answer: |q| {
                density(q, |how| {
                    how.weight = |_, _| 1.0;
                    how.area = Some(EnvironmentPdf::solid_angle);
                })
            },
        },
        Mistake {
            name: "gives all texels the solid angle of 4π over their number",
            hint: "Texels at the equator and at a pole: which is larger on the sphere?",
            answer: |q| density(q, |how| how.area = Some(|q, _| q.of_one(4.0 * PI))),
        },
        Mistake {
            name: "ignores the map",
            hint: "Bright directions are chosen more often: is your density larger there?",
            answer: |q| {
                if q.texels.iter().all(|t| *t == 0.0) {
                    0.0
                } else {
                    (0.25 / PI) as f32
                }
            },
        },
        Mistake {
            name: "counts the rows from the bottom",
            hint: "Which row does +y belong to?",
            answer: |q| {
                let d = q.direction;
                Self::right(&EnvironmentPdf {
                    direction: toward(d.x, -d.y, d.z),
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "returns the radiance",
            hint: "If the whole map were twice as bright, would the directions be chosen otherwise?",
            answer: |q| density(q, |how| how.whole = Some(|_, _| 1.0)),
        },
        Mistake {
            name: "divides the radiance by the sum of the texels",
            hint: "In which unit is the integral of the map? What is a texel multiplied by in it?",
            answer: |q| density(q, |how| how.weight = |_, _| 1.0),
        },
        Mistake {
            name: "takes 2π² for the solid angle of the map, as if all rows were equally wide",
            hint: "A row of texels near a pole: how wide is it on the sphere?",
            answer: |q| density(q, |how| how.weight = |q, _| q.of_one(2.0 * PI * PI)),
        },
        Mistake {
            name: "takes 2π for the solid angle of the map, as that of half a sphere, and all rows as equally wide",
            hint: "How many steradians has the whole sphere, and how wide is a row of texels near a pole?",
            answer: |q| density(q, |how| how.weight = |q, _| q.of_one(2.0 * PI)),
        },
        Mistake {
            name: "exchanges rows and columns of the map",
            hint: "Which texel is the second of the list: the one to the right of the first, or the one below the first?",
            answer: |q| {
                density(q, |how| {
                    how.radiance =
                        |q, _, [x, y]| q.listed(x * q.height as usize + y).unwrap_or(0.0);
                })
            },
        },
        Mistake {
            name: "exchanges rows and columns of the map, in its integral too",
            hint: "Which texel is the second of the list: the one to the right of the first, or the one below the first?",
            answer: |q| {
                let (width, height) = (q.width as usize, q.height as usize);
                let places = (0..q.texels.len()).map(|i| (i % width) * height + i / width);
                let texels = places.map(|place| q.texels[place]).collect();
                Self::misread(q, |q| q.texels = texels)
            },
        },
        Mistake {
            name: "multiplies the row by the number of rows, not by the width, to find the texel in the list",
            hint: "How many texels come in the list before the first one of the second row?",
            answer: |q| {
                density(q, |how| {
                    how.radiance = |q, _, [x, y]| {
                        let there = q.listed(y * q.height as usize + x);
                        there.unwrap_or_else(|| q.texel(x, y))
                    };
                })
            },
        },
        Mistake {
            name: "takes 4π over their number for the solid angle of every texel, in the sum too",
            hint: "Texels at the equator and at a pole: which is larger on the sphere?",
            answer: |q| density(q, |how| how.weight = |q, _| q.of_one(4.0 * PI)),
        },
        Mistake {
            name: "rounds the place to a texel instead of cutting off its fraction",
            hint: "The place 0.9 of three columns is 2.7: in which column is that, counted from 0?",
            answer: |q| density(q, |how| how.number = [rounded; 2]),
        },
        Mistake {
            name: "rounds the row instead of cutting off its fraction",
            hint: "The place 0.9 of three rows is 2.7: in which row is that, counted from 0?",
            answer: |q| density(q, |how| how.number[1] = rounded),
        },
        Mistake {
            name: "rounds the column instead of cutting off its fraction",
            hint: "The place 0.9 of three columns is 2.7: in which column is that, counted from 0?",
            answer: |q| density(q, |how| how.number[0] = rounded),
        },
        Mistake {
            name: "rounds the column instead of cutting off its fraction, and takes the first one behind the last",
            hint: "The place 0.9 of three columns is 2.7: in which column is that, counted from 0?",
            answer: |q| {
                density(q, |how| {
                    how.number[0] = |place, n| (place * n as f32).round() as i32;
                })
            },
        },
        Mistake {
            name: "takes the first row for the one straight down, as if rows went round as columns do",
            hint: "The map's right edge is its left one again: is its lower edge the upper one? Which row is straight down?",
            answer: |q| {
                density(q, |how| {
                    how.number[1] = |place, n| (place * n as f32) as i32 % n as i32;
                })
            },
        },
        Mistake {
            name: "finds the row by the height, not by the angle from the top",
            hint: "The rows of the map are equally many degrees high: are they equally high on the sphere?",
            answer: |q| {
                density(q, |how| {
                    how.place = |d| vec2(latlong::place(d).x, 0.5 - 0.5 * d.y);
                })
            },
        },
        Mistake {
            name: "takes the sine in the middle of a row for the whole row",
            hint: "The solid angle of a row is 2π times a difference of cosines: how far is the sine in its middle from that, near a pole?",
            answer: |q| density(q, |how| how.weight = |q, row| q.by_sine(row, 0.5)),
        },
        Mistake {
            name: "takes the sine at a row's upper edge for the whole row",
            hint: "How large is the solid angle of your first row?",
            answer: |q| density(q, |how| how.weight = |q, row| q.by_sine(row, 0.0)),
        },
        Mistake {
            name: "divides the radiance by the brightest texel",
            hint: "A density's integral over all directions is 1: what is that of yours?",
            answer: |q| {
                density(q, |how| {
                    how.whole = Some(|q, _| q.texels.iter().copied().fold(0.0, f32::max).into());
                })
            },
        },
        Mistake {
            name: "takes the sine at the direction for the whole texel, and chooses all rows as if they were equally wide",
            hint: "For a constant map the density must be 1/(4π) everywhere: is it, near a pole?",
            answer: |q| {
                density(q, |how| {
                    how.weight = |_, _| 1.0;
                    how.area = Some(by_own_sine);
                })
            },
        },
        Mistake {
            name: "is one column too far right",
            hint: "The place 0 is in the first column, whose number is 0: which number does your formula give?",
            answer: |q| density(q, |how| how.right = 1),
        },
        Mistake {
            name: "is one column too far left",
            hint: "The place 0 is in the first column, whose number is 0: which number does your formula give?",
            answer: |q| density(q, |how| how.right = -1),
        },
        Mistake {
            name: "is one row too low",
            hint: "The place 0 is in the first row, whose number is 0: which number does your formula give?",
            answer: |q| density(q, |how| how.down = 1),
        },
        Mistake {
            name: "is one row too high",
            hint: "The place 0 is in the first row, whose number is 0: which number does your formula give?",
            answer: |q| density(q, |how| how.down = -1),
        },
        Mistake {
            name: "is half a turn off",
            hint: "Which direction is in the middle of the map, and to which side of it is +x?",
            answer: |q| quarters(q, 2),
        },
        Mistake {
            name: "is a quarter turn off, to the right",
            hint: "Which direction is in the middle of the map, and to which side of it is +x?",
            answer: |q| quarters(q, 1),
        },
        Mistake {
            name: "is a quarter turn off, to the left",
            hint: "Which direction is in the middle of the map, and to which side of it is +x?",
            answer: |q| quarters(q, 3),
        },
        Mistake {
            name: "returns 1/(4π) for a black map",
            hint: "With which probability does a black map choose a direction?",
            answer: |q| density(q, |how| how.dark = (0.25 / PI) as f32),
        },
        Mistake {
            name: "returns NaN for a black map",
            hint: "A black map has no light: which two numbers do you divide?",
            answer: |q| density(q, |how| how.dark = f32::NAN),
        },
        Mistake {
            name: "takes the sine at a row's lower edge for the whole row",
            hint: "How large is the solid angle of your last row?",
            answer: |q| density(q, |how| how.weight = |q, row| q.by_sine(row, 1.0)),
        },
        Mistake {
            name: "goes over evenly from texel to texel, as between the pixels of a picture",
            hint: "Directions are uniform inside a texel: does your density differ between two directions of the same texel?",
            answer: |q| density(q, |how| how.radiance = between),
        },
        Mistake {
            name: "multiplies the row's probability with that of the column in the whole map",
            hint: "The column is chosen after the row: how probable is it in that row?",
            answer: |q| density(q, |how| how.radiance = by_row_and_column),
        },
        Mistake {
            name: "multiplies the place by one column and one row less than there are",
            hint: "The place 0.9 of three columns is 2.7: in which column is that, counted from 0?",
            answer: |q| {
                density(q, |how| {
                    how.number = [|place, n| (place * (n as f32 - 1.0)) as i32; 2];
                })
            },
        },
        Mistake {
            name: "squares the radiance",
            hint: "A texel twice as bright should be chosen twice as often: how large is its density?",
            answer: |q| Self::misread(q, |q| q.texels.iter_mut().for_each(|t| *t *= *t)),
        },
        Mistake {
            name: "takes all rows to be chosen equally often",
            hint: "One row is dark and another one bright: how probable is each of them?",
            answer: |q| {
                density(q, |how| {
                    how.whole = Some(|q, row| q.of_row(row) * f64::from(q.height));
                })
            },
        },
        Mistake {
            name: "rounds the place times one column and one row less than there are",
            hint: "The first of three columns is a third of the map: how much of it is it in yours?",
            answer: |q| {
                density(q, |how| {
                    how.number = [|place, n| (place * (n as f32 - 1.0)).round() as i32; 2];
                })
            },
        },
        Mistake {
            name: "takes the sine at the direction for the whole texel, and returns 0 at the poles",
            hint: "Directions are uniform inside a texel: does your density differ between two directions of the same texel, and why should it be 0 straight up?",
            answer: |q| {
                if is_at_pole(q) {
                    0.0
                } else {
                    density(q, |how| how.area = Some(by_own_sine))
                }
            },
        },
        Mistake {
            name: "returns 0 at the poles",
            hint: "Straight up is a direction as any other: how large is the solid angle of a texel that touches the pole?",
            answer: |q| if is_at_pole(q) { 0.0 } else { Self::right(q) },
        },
        Mistake {
            name: "adds a tenth of the mean to each texel, so that none has the density 0",
            hint: "With which probability does sample_environment choose a black texel?",
            answer: |q| {
                let more = tenth(q);
                Self::misread(q, |q| q.texels.iter_mut().for_each(|t| *t += more))
            },
        },
        Mistake {
            name: "adds a tenth of the mean to the direction's texel, and not to those of the integral",
            hint: "A density's integral over all directions is 1: what is that of yours?",
            answer: |q| {
                density(q, |how| {
                    how.radiance = |q, _, [x, y]| q.texel(x, y) + f64::from(tenth(q));
                })
            },
        },
        Mistake {
            name: "lets the density within a texel go with the inverse of the direction's sine, and has it right in the middle of the row",
            hint: "Directions are uniform inside a texel: does your density differ between two directions of the same texel?",
            answer: from_the_middle,
        },
        Mistake {
            name: "counts the columns from the right",
            hint: "On which side of the map is +x?",
            answer: |q| {
                let d = q.direction;
                Self::misread(q, |q| q.direction = toward(-d.x, d.y, d.z))
            },
        },
        Mistake {
            name: "divides by the solid angle of the whole row, not by that of a texel",
            hint: "How many texels share the solid angle of a row?",
            answer: |q| Self::right(q) / q.width as f32,
        },
        Mistake {
            name: "adds the light of the direction's row only, not of all rows",
            hint: "A density's integral over all directions is 1: what is that of yours?",
            answer: |q| density(q, |how| how.whole = Some(EnvironmentPdf::of_row)),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "environment_pdf",
        width: 96,
        height: 48,
        alt: "A map of 8 by 4 texels, each as bright as the density there",
        question: |x, y| EnvironmentPdf {
            direction: latlong::direction(vec2((x as f32 + 0.5) / 96.0, (y as f32 + 0.5) / 48.0)),
            width: 8,
            height: 4,
            texels: (0..32).map(|i| ((i * 7) % 11) as f32).collect(),
        },
        colour: |_, density| viridis(4.0 * density),
    }];
}
