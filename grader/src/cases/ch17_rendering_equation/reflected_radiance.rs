//! `reflected_radiance`: an estimate, held against the integral.

mod estimates;

use super::colour;
use crate::together::{Bounds, scattered};
use crate::{Flaw, Graded, Mistake, Verdict, judge, sample, traits, upon};
use estimates::{
    both, built, by_own_density, clamped, clamped_light, cosine, crossed, estimated, from_below,
    half_sphere, highlight, integral, integrated, inverse_sine, lobe, lobes, matte, mirrored,
    on_curve, raised, under, uneven,
};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook::sample::hemisphere;
use raybook_workbook::exercises::ch17_rendering_equation::ReflectedRadiance;
use std::f32::consts::{PI, TAU};

/// The integral, and the standard deviation of the estimate that scatters most among those that may well be written.
fn exact_and_scatter(q: &ReflectedRadiance) -> ([f32; 3], [f32; 3]) {
    let brdf = q.brdf();
    let [exact, sphere, cosine] = integral(q.normal, |d| {
        let cosine = d.dot(*q.normal);
        let light = brdf.value(q.normal, q.view, d) * q.sky(d) * cosine;
        let square = |pdf: f32| light * light / pdf;
        [
            light,
            square(0.5 * hemisphere::UNIFORM),
            square(hemisphere::cosine_pdf(cosine)),
        ]
    })
    .map(Rgb::channels);
    let scatter = [0, 1, 2].map(|i| {
        let variance = (sphere[i].max(cosine[i]) - exact[i] * exact[i]).max(0.0);
        (variance / q.samples as f32).sqrt()
    });
    (exact, scatter)
}

/// Samples of the question that is asked again and again, to see whether each answer has random numbers of its own.
const AGAIN: u32 = 1000;

/// That question, each time hardly another, for who takes random numbers from all that is asked; and among the first of them it is asked
/// for twice as many samples.
fn again(rng: &mut Pcg) -> Vec<ReflectedRadiance> {
    let question = ReflectedRadiance {
        samples: AGAIN,
        ..ReflectedRadiance::random(rng)
    };
    let hardly = |i| {
        let by = 1.0 + 1e-5 * i as f32;
        ReflectedRadiance {
            diffuse: question.diffuse * by,
            specular: question.specular * by,
            exponent: question.exponent * by,
            radiance: question.radiance * by,
            ..question.clone()
        }
    };
    let mut questions: Vec<_> = (0..71).map(hardly).collect();
    let of_more = ReflectedRadiance {
        samples: 2 * AGAIN,
        ..questions[0].clone()
    };
    questions.insert(1, of_more);
    questions
}

/// Whether other numbers of samples make other estimates. Who always takes the same number of them, and the same random numbers, has the
/// same one.
fn depends_on_samples(answers: &[(ReflectedRadiance, Rgb)]) -> Verdict {
    for (i, (one, got)) in answers.iter().enumerate() {
        let is_same = |(other, its): &&(ReflectedRadiance, Rgb)| {
            let mut question = other.clone();
            question.samples = one.samples;
            other.samples != one.samples && question == *one && its == got
        };
        if let Some((other, _)) = answers[..i].iter().find(is_same) {
            let [few, many] = [
                one.samples.min(other.samples),
                one.samples.max(other.samples),
            ];
            return Err(format!(
                "an estimate by {few} samples is exactly the same as that by {many}"
            ));
        }
    }
    Ok(())
}

/// Whether the answers to that question, eight at least, scatter. Who takes the same random numbers each time is off to the same side each time, and
/// rightly so: there only the question makes a difference.
fn are_independent(answers: &[(ReflectedRadiance, Rgb)]) -> bool {
    /// Of the scatter that is most.
    const LEAST: f32 = 0.02;
    let again = answers.iter().filter(|(q, _)| q.samples == AGAIN);
    let (questions, got): (Vec<_>, Vec<_>) = again.map(|(q, got)| (q, got.channels())).unzip();
    let Some(question) = questions.first().filter(|_| got.len() >= 8) else {
        return false;
    };
    let sums = || got.iter().map(|got| got.iter().sum::<f32>());
    let mean = sums().sum::<f32>() / got.len() as f32;
    let variance = sums().map(|sum| (sum - mean).powi(2)).sum::<f32>() / got.len() as f32;
    let (_, scatter) = exact_and_scatter(question);
    let is_new = |i: usize| !got[..i].contains(&got[i]);
    (0..got.len()).all(is_new) && variance.sqrt() > LEAST * scatter.iter().sum::<f32>()
}

impl Graded for ReflectedRadiance {
    const ULPS: i32 = 0; // an integral has no edges at which a last digit decides

    /// Estimates scatter: what a student's is, another estimate with the same mistake is only nearly.
    const ALIKE: f32 = 0.05;

    fn right(&self) -> Rgb {
        upon::answer(self).unwrap_or_else(|| estimated(self, |_, _| 1.0))
    }

    fn random(rng: &mut Pcg) -> ReflectedRadiance {
        let normal = sample::direction(rng);
        let d = sample::direction(rng);
        let above = if d.dot(*normal) < 0.0 { -d } else { d };
        ReflectedRadiance {
            normal,
            view: Dir3::new_or(*above + 0.3 * *normal, normal),
            diffuse: colour(rng, 0.2, 0.6),
            specular: colour(rng, 0.05, 0.3),
            exponent: sample::number(rng, 0.5, 5.0),
            zenith: Dir3::new_or(*sample::direction(rng) + *normal, normal),
            radiance: colour(rng, 0.5, 3.0),
            samples: 20_000,
        }
    }

    /// Against the integral. The bound is 6.2 standard deviations of the estimate that scatters most among those that may
    /// well be written: by directions of the whole sphere, half of them in vain, or by the cosine. Of 300 random cases the
    /// others (the hemisphere, the highlight's lobe and one of them, half and half) scatter less in every one. Of 500
    /// students with 42 cases of three channels, chance fails one with a probability of 500 · 126 · 6e-10 = 4e-5.
    fn judge(q: &ReflectedRadiance, _golden: &Rgb, got: &Rgb) -> Verdict {
        const DEVIATIONS: f32 = 6.2;
        let (exact, scatter) = exact_and_scatter(q);
        for (i, name) in ["red", "green", "blue"].into_iter().enumerate() {
            let tolerance = DEVIATIONS * scatter[i] + 2.0 * judge::RELATIVE * exact[i];
            judge::number_within(name, "W·m⁻²·sr⁻¹", exact[i], got.channels()[i], tolerance)
                .map_err(|why| format!("{why}: more than chance explains"))?;
        }
        Ok(())
    }

    /// The sum of n estimates, each over the standard deviation of the one that scatters most, has a standard deviation of √n at most: a
    /// bias of 2 % shows in 42 cases. And so does a twentieth of the samples, by the sum of the squares of these and of the answers to the
    /// question that is asked again.
    fn together(answers: &[(ReflectedRadiance, Rgb)], bounds: Bounds) -> Verdict {
        const DEVIATIONS: f64 = 6.25;
        depends_on_samples(answers)?;
        if !are_independent(answers) {
            return Ok(());
        }
        let (mut off, mut sum, mut bias, mut n) = (Vec::new(), 0.0, 0.0, 0.0);
        for (q, got) in answers {
            let total = |channels: [f32; 3]| f64::from(channels.iter().sum::<f32>());
            let (exact, scatter) = exact_and_scatter(q);
            let (exact, scatter) = (total(exact), total(scatter));
            let apart = total(got.channels()) - exact;
            off.push(apart / scatter);
            // Of few samples an estimate tells much of its scatter, and little of a bias.
            if q.samples > AGAIN {
                sum += apart / scatter;
                bias += apart / exact;
                n += 1.0;
            }
        }
        if n > 0.0 && f64::abs(sum) > bounds.of(DEVIATIONS) * f64::sqrt(n) {
            return Err(format!(
                "the estimates are {:.1} % too {} on average: more than chance explains",
                100.0 * f64::abs(bias / n),
                if bias > 0.0 { "large" } else { "small" }
            ));
        }
        scattered("the estimates", off.into_iter(), bounds)
    }

    /// One question again and again, once for more samples.
    fn further(rng: &mut Pcg) -> Vec<ReflectedRadiance> {
        again(rng)
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "on average: more than chance explains",
            name: "is off by a few percent on average, which no single answer shows",
            hint: "Which constant of your formula, or which range of your random numbers, is slightly wrong? By how many samples do you divide?",
        },
        Flaw {
            complaint: "times as much as those of so many samples may",
            name: "takes fewer samples than are asked for, or some of them again, which no single answer shows",
            hint: "How many samples do you take for each estimate, and does each of them have random numbers of its own?",
        },
        Flaw {
            complaint: "is exactly the same as that by",
            name: "does not take the number of samples that is asked for: more of them change nothing",
            hint: "How many samples do you take for each estimate? Is that the number of the question, or one that you have chosen?",
        },
    ];

    fn traits(_q: &ReflectedRadiance, got: &Rgb) -> Vec<f64> {
        got.channels().map(|v| traits::log(v.into())).to_vec()
    }

    const EFFORT: usize = 100;

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets the cosine",
            hint: "A beam that arrives at a slant is spread over more of the surface: where does that come in?",
            answer: |q| estimated(q, |q, d| 1.0 / cosine(q, d)),
        },
        Mistake {
            name: "chooses directions uniformly and forgets to divide by the density",
            hint: "The mean over the hemisphere is not yet the integral: how large is the hemisphere?",
            answer: |q| estimated(q, |_, _| hemisphere::UNIFORM),
        },
        Mistake {
            name: "returns twice the radiance",
            hint: "Over how many steradians are your directions spread: those of the density, or half of them? By how many samples do you divide? How bright is the sky at its zenith?",
            answer: |q| estimated(q, |_, _| 2.0),
        },
        Mistake {
            name: "chooses directions uniformly and divides by the density of the cosine",
            hint: "Is p the density of the directions that you really chose?",
            answer: |q| estimated(q, |q, d| 0.5 / cosine(q, d)),
        },
        Mistake {
            name: "chooses directions by the cosine and divides by the uniform density",
            hint: "Is p the density of the directions that you really chose?",
            answer: |q| estimated(q, |q, d| 2.0 * cosine(q, d)),
        },
        Mistake {
            name: "adds up without dividing by the number of samples",
            hint: "Take twice as many samples: does your surface get brighter?",
            answer: |q| estimated(q, |q, _| q.samples as f32),
        },
        Mistake {
            name: "looks at the sky along the normal only",
            hint: "From which directions does light arrive at the surface?",
            answer: |q| (q.diffuse + q.specular) * q.sky(q.normal),
        },
        Mistake {
            name: "multiplies by π once more",
            hint: "A white surface under a sky of the same radiance everywhere looks as bright as the sky: does yours?",
            answer: |q| estimated(q, |_, _| PI),
        },
        Mistake {
            name: "returns half of the radiance",
            hint: "Half of a sphere is below the surface, and no light comes from there: what do such samples add, and to what density do they belong? Of directions chosen in two ways, half each, which density has one of them?",
            answer: |q| estimated(q, |_, _| 0.5),
        },
        Mistake {
            name: "takes the normal for the sky's zenith",
            hint: "The sky stays where it is when the surface is turned: between which two directions is γ?",
            answer: |q| under(q, |q, d| q.radiance * (0.5 + 0.5 * d.dot(*q.normal))),
        },
        Mistake {
            name: "takes +y for the sky's zenith",
            hint: "The zenith is given: is it always +y?",
            answer: |q| under(q, |q, d| q.radiance * (0.5 + 0.5 * d.y)),
        },
        Mistake {
            name: "takes cos γ for the sky, without the ½ (1 + cos γ)",
            hint: "How bright is the sky at its horizon, where γ is 90°?",
            answer: |q| under(q, |q, d| q.radiance * d.dot(*q.zenith).max(0.0)),
        },
        Mistake {
            name: "takes the same light from all of the sky",
            hint: "Is the sky as bright at its horizon as at its zenith?",
            answer: |q| under(q, |q, _| q.radiance),
        },
        Mistake {
            name: "multiplies by the sky's ½ (1 + cos γ) twice",
            hint: "How bright is the sky at its horizon, where γ is 90°: half as bright as at its zenith, or a quarter?",
            answer: |q| under(q, |q, d| q.sky(d) * (0.5 + 0.5 * d.dot(*q.zenith))),
        },
        Mistake {
            name: "takes the direction to the light for the viewer's in the BRDF",
            hint: "The BRDF has two directions, to the light and to the viewer: which of them do you hand over?",
            answer: |q| {
                integrated(q, |how| {
                    how.shine = |q, d| {
                        let cosine = 2.0 * cosine(q, d).powi(2) - 1.0;
                        cosine.max(0.0).powf(q.exponent)
                    };
                })
            },
        },
        Mistake {
            name: "leaves out the highlight",
            hint: "The BRDF is a sum of two: which of them is in yours?",
            answer: |q| Self::misread(q, |q| q.specular = Rgb::BLACK),
        },
        Mistake {
            name: "leaves out the matte part",
            hint: "The BRDF is a sum of two: which of them is in yours?",
            answer: |q| Self::misread(q, |q| q.diffuse = Rgb::BLACK),
        },
        Mistake {
            name: "chooses directions by the cosine and forgets to divide by the density",
            hint: "Where many directions are chosen, each of them counts less: by what do you divide?",
            answer: |q| estimated(q, |q, d| cosine(q, d) / PI),
        },
        Mistake {
            name: "multiplies by the cosine twice",
            hint: "If directions are chosen by the cosine, the density holds one cosine and the integrand another: is there a third in yours?",
            answer: |q| estimated(q, cosine),
        },
        Mistake {
            name: "looks at the sky in the viewer's direction, whatever direction is chosen",
            hint: "From which directions does light arrive at the surface?",
            answer: |q| under(q, |q, _| q.sky(q.view)),
        },
        Mistake {
            name: "takes (n + 1)/2π for the factor of the highlight in the BRDF",
            hint: "Which factor has the highlight in brdf_phong, and which one has the density of its lobe?",
            answer: |q| integrated(q, |how| how.gloss = |n| (n + 1.0) / (n + 2.0)),
        },
        Mistake {
            name: "chooses half of the directions by a lobe of another exponent than in the density",
            hint: "A number to the power of 1/(n + 1) belongs to the density (n + 1)/2π · cosⁿ α: does yours?",
            answer: |q| {
                estimated(q, |q, d| {
                    0.5 * (matte(q, d) + highlight(q, q.exponent + 1.0, d)) / both(q, d)
                })
            },
        },
        Mistake {
            name: "takes (n + 2)/2π for the factor of the lobe's density",
            hint: "The integral of a density over all directions is 1: is that of cosⁿ α times your factor?",
            answer: |q| {
                estimated(q, |q, d| {
                    let n = q.exponent;
                    let factor = (n + 2.0) / (n + 1.0);
                    both(q, d) / (0.5 * (matte(q, d) + factor * highlight(q, n, d)))
                })
            },
        },
        Mistake {
            name: "exchanges the exponents of both lobes: the cosine to the power of n around the normal, and the cosine itself around the mirrored viewer",
            hint: "Which of your two ways of choosing is that of the matte part, and which that of the highlight?",
            answer: |q| {
                estimated(q, |q, d| {
                    0.5 * (lobe(*q.normal, q.exponent, d) + highlight(q, 1.0, d)) / both(q, d)
                })
            },
        },
        Mistake {
            name: "forgets the π in the cosine's part of a density of two",
            hint: "The integral of a density over all directions is 1: is that of cos θ?",
            answer: |q| {
                estimated(q, |q, d| {
                    both(q, d) / (0.5 * (PI * matte(q, d) + highlight(q, q.exponent, d)))
                })
            },
        },
        Mistake {
            name: "divides directions that are chosen in two ways by the density of the cosine only",
            hint: "A direction may come from either of your two ways of choosing: what is the density of both together?",
            answer: |q| estimated(q, |q, d| both(q, d) / matte(q, d)),
        },
        Mistake {
            name: "divides directions that are chosen in two ways by the density of the highlight only",
            hint: "A direction may come from either of your two ways of choosing: what is the density of both together?",
            answer: |q| estimated(q, |q, d| both(q, d) / highlight(q, q.exponent, d).max(1e-9)),
        },
        Mistake {
            name: "divides each of two kinds of directions by its own density, although the highlight's reach no direction beyond 90° from its axis",
            hint: "Half of your samples never come to some directions in which the matte part has light: who stands for them?",
            answer: |q| estimated(q, by_own_density),
        },
        Mistake {
            name: "divides by the number of samples above the surface only",
            hint: "A direction below the surface brings no light; is it a sample all the same?",
            answer: |q| {
                let [above] = integral(q.normal, |d| [Rgb::gray(both(q, d))]);
                integrated(q, |_| {}) / above.g
            },
        },
        Mistake {
            name: "takes the viewer's direction for the sky's zenith",
            hint: "The sky stays where it is when you walk around: between which two directions is γ?",
            answer: |q| under(q, |q, d| q.radiance * (0.5 + 0.5 * d.dot(*q.view))),
        },
        Mistake {
            name: "chooses directions by the cosine only, and divides by the density of two ways of choosing",
            hint: "Is p the density of the directions that you really chose?",
            answer: |q| estimated(q, |q, d| matte(q, d) / both(q, d)),
        },
        Mistake {
            name: "chooses directions by the highlight only, and divides by the density of two ways of choosing",
            hint: "Is p the density of the directions that you really chose?",
            answer: |q| estimated(q, |q, d| highlight(q, q.exponent, d) / both(q, d)),
        },
        Mistake {
            name: "takes the sky for black where it is more than 90° from its zenith, or chooses no directions there",
            hint: "The sky's formula holds for every angle from its zenith: is it 0 at 90°? And around which axis are your directions?",
            answer: |q| {
                under(q, |q, d| {
                    if d.dot(*q.zenith) < 0.0 {
                        Rgb::BLACK
                    } else {
                        q.sky(d)
                    }
                })
            },
        },
        Mistake {
            name: "keeps the cosine of the sky's angle from falling below 0",
            hint: "Opposite to the zenith cos γ is −1: how bright is the sky there?",
            answer: |q| {
                under(q, |q, d| {
                    q.radiance * (0.5 + 0.5 * d.dot(*q.zenith).max(0.0))
                })
            },
        },
        Mistake {
            name: "divides by the number of samples above the surface only, where half of them are chosen on the whole sphere",
            hint: "A direction below the surface brings no light; is it a sample all the same?",
            answer: |q| {
                let [above] = integral(q.normal, |d| {
                    let sphere = 0.5 * hemisphere::UNIFORM;
                    [Rgb::gray(0.5 * (sphere + highlight(q, q.exponent, d)))]
                });
                integrated(q, |_| {}) / above.g
            },
        },
        Mistake {
            name: "counts directions below the surface, whose cosine is negative",
            hint: "May a direction below the surface take light away?",
            answer: |q| {
                let is_reached = |q: &Self, d: Dir3| f32::from(highlight(q, q.exponent, d) > 0.0);
                Self::right(q) + from_below(q, is_reached) * -1.0
            },
        },
        Mistake {
            name: "takes the absolute value of the cosine, so that directions below the surface count, too",
            hint: "Does light come through the surface from below?",
            answer: |q| {
                let share = |q: &Self, d: Dir3| {
                    let gloss = highlight(q, q.exponent, d);
                    gloss / (gloss - cosine(q, d) / PI).max(1e-9)
                };
                Self::right(q) + from_below(q, share)
            },
        },
        Mistake {
            name: "has the sky darkest at its zenith",
            hint: "Where is ½ (1 + cos γ) largest? To where does your direction point: to the sky, or from it?",
            answer: |q| under(q, |q, d| q.radiance * (0.5 - 0.5 * d.dot(*q.zenith))),
        },
        Mistake {
            name: "takes 1 + ½ cos γ for the sky, without the brackets of ½ (1 + cos γ)",
            hint: "How bright is the sky at its zenith, where cos γ is 1?",
            answer: |q| under(q, |q, d| q.radiance * (1.0 + 0.5 * d.dot(*q.zenith))),
        },
        Mistake {
            name: "takes ½ + cos γ for the sky, without the brackets of ½ (1 + cos γ)",
            hint: "How bright is the sky at its zenith, where cos γ is 1?",
            answer: |q| under(q, |q, d| q.radiance * (0.5 + d.dot(*q.zenith))),
        },
        Mistake {
            name: "looks at the sky along the normal, whatever direction is chosen",
            hint: "From which directions does light arrive at the surface?",
            answer: |q| under(q, |q, _| q.sky(q.normal)),
        },
        Mistake {
            name: "looks at the sky in the viewer's mirror direction, whatever direction is chosen",
            hint: "A mirror shows one place of the sky: and a matte surface?",
            answer: |q| under(q, |q, _| q.sky(mirrored(q))),
        },
        Mistake {
            name: "forgets the π under the matte part of the BRDF",
            hint: "How much does a surface with your BRDF send to all sides together, for each watt that arrives?",
            answer: |q| integrated(q, |how| how.matte = PI),
        },
        Mistake {
            name: "forgets the factor of the highlight in the BRDF",
            hint: "The sharper a highlight, the brighter it must be in its middle to send out the same light.",
            answer: |q| integrated(q, |how| how.gloss = |n| TAU / (n + 2.0)),
        },
        Mistake {
            name: "looks for the highlight at the viewer, without mirroring",
            hint: "Where does a mirror show the light: where you are, or on the other side of the normal?",
            answer: |q| {
                integrated(q, |how| {
                    how.shine = |q, d| d.dot(*q.view).max(0.0).powf(q.exponent);
                })
            },
        },
        Mistake {
            name: "has a highlight on the far side too, in the BRDF",
            hint: "The size of a negative cosine is positive: what if the light and the mirrored viewer are on different sides?",
            answer: |q| {
                integrated(q, |how| {
                    how.shine = |q, d| d.dot(*mirrored(q)).abs().powf(q.exponent);
                })
            },
        },
        Mistake {
            name: "takes the half vector's N·H for the highlight's cosine in the BRDF",
            hint: "That is Blinn's model: which two vectors make the angle in Phong's?",
            answer: |q| {
                integrated(q, |how| {
                    how.shine = |q, d| {
                        let half = Dir3::new_or(*d + *q.view, q.normal);
                        half.dot(*q.normal).max(0.0).powf(q.exponent)
                    };
                })
            },
        },
        Mistake {
            name: "forgets the exponent of the highlight's cosine in the BRDF",
            hint: "A larger n, a smaller highlight: does yours become smaller?",
            answer: |q| integrated(q, |how| how.shine = |q, d| d.dot(*mirrored(q)).max(0.0)),
        },
        Mistake {
            name: "chooses half of the directions around the viewer, with the density of those around the mirrored viewer",
            hint: "Around which axis is the highlight, for given directions to the viewer?",
            answer: |q| {
                estimated(q, |q, d| {
                    0.5 * (matte(q, d) + lobe(*q.view, q.exponent, d)) / both(q, d)
                })
            },
        },
        Mistake {
            name: "takes a number to the power of 1/n, not 1/(n + 1), for the cosine in the lobe",
            hint: "Which power of a uniform number belongs to the density (n + 1)/2π · cosⁿ α?",
            answer: |q| {
                estimated(q, |q, d| {
                    let axis = *mirrored(q);
                    // Where n is below 1, that density is infinite at 90° from the axis.
                    let steep = lobe(axis, q.exponent, d) / d.dot(axis).max(1e-3);
                    let steep = q.exponent / (q.exponent + 1.0) * steep;
                    0.5 * (matte(q, d) + steep) / both(q, d)
                })
            },
        },
        Mistake {
            name: "takes a uniform number itself for the cosine, in both ways of choosing",
            hint: "Which power of a uniform number belongs to the density (n + 1)/2π · cosⁿ α?",
            answer: |q| {
                estimated(q, |q, d| {
                    let axes = [*q.normal, *mirrored(q)];
                    let [matte, gloss] = axes.map(|axis| half_sphere(axis, d));
                    0.5 * (matte + gloss) / both(q, d)
                })
            },
        },
        Mistake {
            name: "adds up what both ways of choosing give, each divided by its own density",
            hint: "Either way gives all of the light that its directions reach: what do you get of both together?",
            answer: |q| estimated(q, |q, d| 2.0 * by_own_density(q, d)),
        },
        Mistake {
            name: "spreads the angle to the normal evenly, and divides by the uniform density",
            hint: "Is p the density of the directions that you really chose? A ring around the normal gets larger with its angle.",
            answer: |q| estimated(q, |q, d| 2.0 / PI * inverse_sine(cosine(q, d))),
        },
        Mistake {
            name: "spreads the angle to the normal evenly, and divides by the density of the cosine",
            hint: "Is p the density of the directions that you really chose? A ring around the normal gets larger with its angle.",
            answer: |q| {
                estimated(q, |q, d| {
                    let cosine = cosine(q, d);
                    inverse_sine(cosine) / (PI * cosine)
                })
            },
        },
        Mistake {
            name: "takes a uniform number itself for the radius on the disc, and divides by the density of the cosine",
            hint: "The inner half of a disc's radius holds only a quarter of its area: does it get only a quarter of your points?",
            answer: |q| estimated(q, |q, d| 0.5 * inverse_sine(cosine(q, d))),
        },
        Mistake {
            name: "cuts off what is brighter than 1, or another fixed value, in samples chosen by the cosine",
            hint: "A rare bright sample stands for many that did not come: what becomes of the average if it is made darker?",
            answer: |q| clamped(q, matte),
        },
        Mistake {
            name: "cuts off what is brighter than 1, or another fixed value, in samples chosen by cosine and highlight",
            hint: "A rare bright sample stands for many that did not come: what becomes of the average if it is made darker?",
            answer: |q| clamped(q, both),
        },
        Mistake {
            name: "cuts off what is brighter than 1, or another fixed value, in samples chosen uniformly",
            hint: "A rare bright sample stands for many that did not come: what becomes of the average if it is made darker?",
            answer: |q| clamped(q, |_, _| hemisphere::UNIFORM),
        },
        Mistake {
            name: "cuts the radiance off at 1",
            hint: "A screen shows nothing brighter than 1: is the radiance what a screen shows?",
            answer: |q| Self::right(q).map(|v| v.min(1.0)),
        },
        Mistake {
            name: "chooses two directions of three by the highlight, and divides by the density of half and half",
            hint: "How often do you choose a direction in each of your two ways, and which share has each of them in p?",
            answer: |q| estimated(q, |q, d| uneven(q, 1.0 / 3.0, d)),
        },
        Mistake {
            name: "chooses two directions of three by the cosine, and divides by the density of half and half",
            hint: "How often do you choose a direction in each of your two ways, and which share has each of them in p?",
            answer: |q| estimated(q, |q, d| uneven(q, 2.0 / 3.0, d)),
        },
        Mistake {
            name: "chooses three directions of four by the highlight, and divides by the density of half and half",
            hint: "How often do you choose a direction in each of your two ways, and which share has each of them in p?",
            answer: |q| estimated(q, |q, d| uneven(q, 0.25, d)),
        },
        Mistake {
            name: "chooses three directions of four by the cosine, and divides by the density of half and half",
            hint: "How often do you choose a direction in each of your two ways, and which share has each of them in p?",
            answer: |q| estimated(q, |q, d| uneven(q, 0.75, d)),
        },
        Mistake {
            name: "makes both angles of a direction of one random number, and chooses by the cosine",
            hint: "Draw your directions on the hemisphere: do they fill it, or do they make a spiral? How many random numbers has each of them?",
            answer: |q| on_curve(q, &[(q.normal, 1.0)], built, |u| 1.0 - u),
        },
        Mistake {
            name: "makes both angles of a direction of one random number, and chooses by the cosine (axes by cross products)",
            hint: "Draw your directions on the hemisphere: do they fill it, or do they make a spiral? How many random numbers has each of them?",
            answer: |q| on_curve(q, &[(q.normal, 1.0)], crossed, |u| 1.0 - u),
        },
        Mistake {
            name: "makes both angles of a direction of one random number, and chooses by cosine and highlight",
            hint: "Draw your directions on the hemisphere: do they fill it, or do they make a spiral? How many random numbers has each of them?",
            answer: |q| on_curve(q, &lobes(q), built, |u| 1.0 - u),
        },
        Mistake {
            name: "makes both angles of a direction of one random number, and chooses by cosine and highlight (axes by cross products)",
            hint: "Draw your directions on the hemisphere: do they fill it, or do they make a spiral? How many random numbers has each of them?",
            answer: |q| on_curve(q, &lobes(q), crossed, |u| u),
        },
        Mistake {
            name: "cuts off what is brighter than 3, or another fixed value, in the light over the density, before it multiplies by the BRDF",
            hint: "A rare bright sample stands for many that did not come: what becomes of the average if it is made darker?",
            answer: |q| clamped_light(q, 3.0),
        },
        Mistake {
            name: "cuts off what is brighter than 2, or another fixed value, in the light over the density, before it multiplies by the BRDF",
            hint: "A rare bright sample stands for many that did not come: what becomes of the average if it is made darker?",
            answer: |q| clamped_light(q, 2.0),
        },
        Mistake {
            name: "divides by π once more",
            hint: "A white surface under a sky of the same radiance everywhere looks as bright as the sky: does yours?",
            answer: |q| estimated(q, |_, _| 1.0 / PI),
        },
        Mistake {
            name: "takes the viewer's cosine in the place of the light's",
            hint: "Light that arrives at a slant is spread over more of the surface: between which two directions is the angle?",
            answer: |q| estimated(q, |q, d| q.view.dot(*q.normal) / cosine(q, d).max(1e-9)),
        },
        Mistake {
            name: "multiplies by the viewer's cosine too",
            hint: "Light that arrives at a slant is spread over more of the surface: between which two directions is the angle?",
            answer: |q| estimated(q, |q, _| q.view.dot(*q.normal)),
        },
        Mistake {
            name: "divides by 0.08, or a number near it, where the density is less",
            hint: "Where few directions are chosen, each of them counts more: what becomes of the average if some count less than they should?",
            answer: |q| estimated(q, |q, d| raised(0.08, both(q, d))),
        },
    ];
}
