//! `brdf_phong`: the number itself.

use super::colour;
use crate::upon::changed;
use crate::{Graded, Mistake, Verdict, judge, sample};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch17_rendering_equation::BrdfPhong;
use std::f32::consts::{PI, TAU};

impl Graded for BrdfPhong {
    fn random(rng: &mut Pcg) -> BrdfPhong {
        let normal = sample::direction(rng);
        let above = |rng: &mut Pcg| {
            let d = sample::direction(rng);
            let flipped = if d.dot(*normal) < 0.0 { -d } else { d };
            Dir3::new_or(*flipped + 0.1 * *normal, normal)
        };
        let (view, light) = (above(rng), above(rng));
        // Half of them near the highlight.
        let mirrored = 2.0 * view.dot(*normal) * *normal - *view;
        let toward = if rng.random_bool(0.5) {
            Dir3::new_or(mirrored + sample::point(rng, 0.3), normal)
        } else {
            light
        };
        // Of one question in four, the viewer is below the surface, or the light, or both: more of them just below.
        let mut below = |d: Dir3| {
            let down = 1.0 + sample::number(rng, 0.2, 1.0).powi(2);
            Dir3::new_or(*d - down * d.dot(*normal) * *normal, -normal)
        };
        let (view_below, toward_below) = (below(view), below(toward));
        let (view, toward) = match rng.random_range(0..24) {
            0..3 => (view_below, toward),
            3..5 => (view, toward_below),
            5 => (view_below, toward_below),
            _ => (view, toward),
        };
        BrdfPhong {
            normal,
            view,
            toward,
            diffuse: colour(rng, 0.05, 0.6),
            specular: colour(rng, 0.1, 0.4),
            exponent: sample::number(rng, 0.5, 40.0),
        }
    }

    fn judge(_q: &BrdfPhong, golden: &Rgb, got: &Rgb) -> Verdict {
        let channels = golden.channels().into_iter().zip(got.channels());
        for (name, (golden, got)) in ["red", "green", "blue"].into_iter().zip(channels) {
            let tolerance = judge::RELATIVE * golden.max(0.01);
            judge::number_within(name, "per steradian", golden, got, tolerance)?;
        }
        Ok(())
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "leaves for the highlight only what the matte part does not reflect: multiplies it by 1 − diffuse",
            hint: "The two albedos are given: is the highlight's still to be made smaller?",
            answer: |q| Self::misread(q, |q| q.specular = q.specular * q.diffuse.map(|d| 1.0 - d)),
        },
        Mistake {
            name: "leaves for the matte part only what the highlight does not reflect: multiplies it by 1 − specular",
            hint: "The two albedos are given: is that of the matte part still to be made smaller?",
            answer: |q| Self::misread(q, |q| q.diffuse = q.diffuse * q.specular.map(|s| 1.0 - s)),
        },
        Mistake {
            name: "multiplies the whole BRDF by the cosine",
            hint: "Exchange light and viewer: a BRDF stays the same. To what does the cosine belong?",
            answer: |q| BrdfPhong::right(q) * q.normal.dot(*q.toward),
        },
        Mistake {
            name: "divides the whole BRDF by the cosine",
            hint: "What happens to your BRDF when the light goes down to the horizon?",
            answer: |q| {
                let cosine = q.normal.dot(*q.toward);
                if cosine > 0.0 {
                    BrdfPhong::right(q) / cosine
                } else {
                    Rgb::BLACK
                }
            },
        },
        Mistake {
            name: "forgets the factor of the highlight",
            hint: "The sharper a highlight, the brighter it must be in its middle to send out the same light.",
            answer: |q| brdf(q, |how| how.factor = |_| 1.0),
        },
        Mistake {
            name: "takes (n + 1)/2π for the factor",
            hint: "Which integral should be 1: of cosⁿα, or of cosⁿα cos θ?",
            answer: |q| brdf(q, |how| how.factor = |q| (q.exponent + 1.0) / TAU),
        },
        Mistake {
            name: "forgets the π under the matte part",
            hint: "How much does a surface with your BRDF send to all sides together, for each watt that arrives?",
            answer: |q| brdf(q, |how| how.matte = |_| 1.0),
        },
        Mistake {
            name: "looks for the highlight at the light",
            hint: "Where does a mirror show the light: where it is, or on the other side of the normal?",
            answer: |q| brdf(q, |how| how.cos_alpha = |q| q.toward.dot(*q.view)),
        },
        Mistake {
            name: "mirrors the light into the surface",
            hint: "Try a light straight above: where does your mirror direction point?",
            answer: |q| brdf(q, |how| how.cos_alpha = |q| -cos_alpha(q)),
        },
        Mistake {
            name: "takes the half vector's N·H for cos α",
            hint: "That is Blinn's model: which two vectors make the angle in Phong's?",
            answer: |q| {
                brdf(q, |how| {
                    how.cos_alpha = |q| Dir3::new_or(*q.toward + *q.view, q.normal).dot(*q.normal);
                })
            },
        },
        Mistake {
            name: "has a second highlight behind",
            hint: "An even power of a negative number is positive: what is the highlight beyond 90°?",
            answer: |q| brdf(q, |how| how.cos_alpha = |q| cos_alpha(q).abs()),
        },
        Mistake {
            name: "lights the surface from behind",
            hint: "A lamp hangs under a table: what does its light do to the table's top?",
            answer: |q| brdf(q, |how| how.is_lit = |_, _| true),
        },
        Mistake {
            name: "takes (n + 8)/8π for the factor",
            hint: "That factor belongs to Blinn's half vector: which belongs to Phong's mirrored one?",
            answer: |q| brdf(q, |how| how.factor = |q| (q.exponent + 8.0) / (8.0 * PI)),
        },
        Mistake {
            name: "forgets the 2 of the mirrored direction",
            hint: "Mirror a vector by hand: how often do you take away what is along the normal?",
            answer: |q| {
                brdf(q, |how| {
                    how.cos_alpha =
                        |q| q.normal.dot(*q.toward) * q.normal.dot(*q.view) - q.toward.dot(*q.view);
                })
            },
        },
        Mistake {
            name: "forgets the π under the highlight",
            hint: "How much does a surface with your BRDF send to all sides together, for each watt that arrives?",
            answer: |q| brdf(q, |how| how.factor = |q| 0.5 * (q.exponent + 2.0)),
        },
        Mistake {
            name: "divides the highlight by the cosine",
            hint: "What happens to your highlight when the light goes down to the horizon?",
            answer: |q| brdf(q, |how| how.times = |q| 1.0 / q.normal.dot(*q.toward)),
        },
        Mistake {
            name: "multiplies the highlight by the cosine",
            hint: "Exchange light and viewer: a BRDF stays the same. To what does the cosine belong?",
            answer: |q| brdf(q, |how| how.times = |q| q.normal.dot(*q.toward)),
        },
        Mistake {
            name: "takes (n + 2)/π for the factor",
            hint: "Which integral should be 1, and is yours 2?",
            answer: |q| brdf(q, |how| how.factor = |q| 2.0 * factor(q)),
        },
        Mistake {
            name: "does not ask whether the viewer is above the surface",
            hint: "The BRDF is 0 if the light is not above the surface: is that all that must be above it?",
            answer: |q| brdf(q, |how| how.is_lit = |light, _| light > 0.0),
        },
        Mistake {
            name: "does not ask whether the light is above the surface",
            hint: "The BRDF is 0 if the viewer is not above the surface: is that all that must be above it?",
            answer: |q| brdf(q, |how| how.is_lit = |_, viewer| viewer > 0.0),
        },
        Mistake {
            name: "divides the albedo of the highlight by π too",
            hint: "The factor of the highlight has a π already: is there another one?",
            answer: |q| brdf(q, |how| how.times = |_| 1.0 / PI),
        },
        Mistake {
            name: "multiplies the matte part by the cosine",
            hint: "Exchange light and viewer: a BRDF stays the same. To what does the cosine belong?",
            answer: |q| brdf(q, |how| how.matte = |q| q.normal.dot(*q.toward) / PI),
        },
        Mistake {
            name: "divides the highlight by 4 times both cosines, as in a microfacet model",
            hint: "Which models have a factor for the half vector, and is there one in yours?",
            answer: |q| {
                brdf(q, |how| {
                    how.times = |q| 0.25 / (q.normal.dot(*q.toward) * q.normal.dot(*q.view));
                })
            },
        },
        Mistake {
            name: "takes the cosine of n α for the power of the cosine",
            hint: "In cosⁿ α, what does n stand above: the angle, or the cosine?",
            answer: |q| {
                brdf(q, |how| {
                    how.power = |cosine, n| {
                        let angle = cosine.clamp(-1.0, 1.0).acos();
                        (n * angle).cos().max(0.0)
                    };
                })
            },
        },
        Mistake {
            name: "has a highlight beyond 90° where n is 0",
            hint: "What is 0 to the power of 0, and what is the highlight beyond 90°?",
            answer: |q| {
                let is_above = |d: &Dir3| q.normal.dot(**d) > 0.0;
                if q.exponent == 0.0 && is_above(&q.toward) && is_above(&q.view) {
                    // The power of any cosine is 1: so is that of α = 0.
                    Self::misread(q, |q| (q.toward, q.view) = (q.normal, q.normal))
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes the surface for the same from below: asks only whether light and viewer are on one side",
            hint: "Put the light and the viewer below the surface, both: what do you return?",
            answer: |q| {
                let [light, viewer] = [q.toward, q.view].map(|d| q.normal.dot(*d));
                if light < 0.0 && viewer < 0.0 {
                    Self::misread(q, |q| q.normal = -q.normal)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "multiplies the matte part by the factor (n + 2)/2π too, in place of 1/π",
            hint: "Is the matte part sharper where n is larger?",
            answer: |q| brdf(q, |how| how.matte = factor),
        },
        Mistake {
            name: "returns 0 only if light and viewer are both below the surface (and for or)",
            hint: "One of the two is below the surface: what does your condition say?",
            answer: |q| {
                brdf(q, |how| {
                    how.is_lit = |light, viewer| light > 0.0 || viewer > 0.0;
                })
            },
        },
        Mistake {
            name: "takes n + 2/2π for (n + 2)/2π: forgets the brackets",
            hint: "Calculate the factor for n = 1 by hand: what does your language divide by 2π?",
            answer: |q| brdf(q, |how| how.factor = |q| q.exponent + 1.0 / PI),
        },
    ];
}

/// How the BRDF is made; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// Whether there is any, where these are the cosines of the `light` and the `viewer`.
    is_lit: fn(light: f32, viewer: f32) -> bool,
    /// What the albedo of the matte part is multiplied by.
    matte: fn(&BrdfPhong) -> f32,
    /// The factor of the highlight.
    factor: fn(&BrdfPhong) -> f32,
    /// What the highlight is multiplied by besides.
    times: fn(&BrdfPhong) -> f32,
    /// The cosine of the angle between the mirrored direction and the other one.
    cos_alpha: fn(&BrdfPhong) -> f32,
    /// The power of the cosine.
    power: fn(cosine: f32, n: f32) -> f32,
}

/// As it should be.
const WELL: How = How {
    is_lit: |light, viewer| light > 0.0 && viewer > 0.0,
    matte: |_| 1.0 / PI,
    factor,
    times: |_| 1.0,
    cos_alpha,
    power: |cosine, n| {
        // Above 90° there is no highlight, even if n is 0.
        if cosine > 0.0 { cosine.powf(n) } else { 0.0 }
    },
};

fn factor(q: &BrdfPhong) -> f32 {
    (q.exponent + 2.0) / TAU
}

fn cos_alpha(q: &BrdfPhong) -> f32 {
    2.0 * q.normal.dot(*q.toward) * q.normal.dot(*q.view) - q.toward.dot(*q.view)
}

/// The BRDF, made rightly but for what is changed.
fn brdf(q: &BrdfPhong, change: fn(&mut How)) -> Rgb {
    let how = changed(WELL, change);
    if !(how.is_lit)(q.normal.dot(*q.toward), q.normal.dot(*q.view)) {
        return Rgb::BLACK;
    }
    let power = (how.power)((how.cos_alpha)(q), q.exponent);
    let highlight = (how.factor)(q) * (how.times)(q) * power;
    q.diffuse * (how.matte)(q) + q.specular * highlight
}
