//! `fresnel`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Verdict, judge, sample};
use rand::RngExt;
use raybook::material::fresnel;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch14_refraction::{Fresnel, FresnelAnswer};

impl Graded for Fresnel {
    fn random(rng: &mut Pcg) -> Fresnel {
        let asked = Fresnel {
            cos1: sample::number(rng, 0.02, 1.0),
            n1: sample::number(rng, 1.0, 1.7),
            n2: sample::number(rng, 1.0, 2.4),
        };
        if rng.random_bool(0.12) {
            near_the_critical_angle(rng, &asked)
        } else {
            asked
        }
    }

    fn judge(_q: &Fresnel, golden: &FresnelAnswer, got: &FresnelAnswer) -> Verdict {
        /// Of all light. Other orders of the same operations in `f32` are within 1e-6 of each other where the answer is stable.
        const TOLERANCE: f32 = 1e-4;
        let close = |name, golden, got| judge::number_within(name, "", golden, got, TOLERANCE);
        close("Rs", golden.rs, got.rs)?;
        close("Rp", golden.rp, got.rp)?;
        close("R", golden.r, got.r)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "returns Schlick's approximation for Rs, Rp and R",
            hint: "One of Rs and Rp is zero at Brewster's angle: which of yours is?",
            answer: |q| {
                let r = fresnel::schlick(q.cos1, q.n1, q.n2);
                let r = if cos2(q).is_some() { r } else { 1.0 };
                FresnelAnswer { rs: r, rp: r, r }
            },
        },
        Mistake {
            name: "exchanges Rs and Rp",
            hint: "At Brewster's angle, which polarisation is not reflected?",
            answer: |q| {
                let FresnelAnswer { rs, rp, r } = Fresnel::right(q);
                FresnelAnswer { rs: rp, rp: rs, r }
            },
        },
        Mistake {
            name: "uses the formula of Rs for Rp too",
            hint: "At Brewster's angle one of the two is zero: is one of yours?",
            answer: |q| {
                let FresnelAnswer { rs, .. } = Fresnel::right(q);
                mean(rs, rs)
            },
        },
        Mistake {
            name: "uses the formula of Rp for Rs too",
            hint: "At Brewster's angle only one of the two is zero: is the other one of yours above 0?",
            answer: |q| {
                let FresnelAnswer { rp, .. } = Fresnel::right(q);
                mean(rp, rp)
            },
        },
        Mistake {
            name: "forgets to square both amplitudes",
            hint: "Your fractions are those of the field's amplitude: with which power of the amplitude does the light's power go?",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::right(q);
                mean(rs.sqrt(), rp.sqrt())
            },
        },
        Mistake {
            name: "reflects nothing beyond the critical angle",
            hint: "Where no light goes through, where does it all go?",
            answer: |q| {
                if cos2(q).is_some() {
                    Fresnel::right(q)
                } else {
                    mean(0.0, 0.0)
                }
            },
        },
        Mistake {
            name: "has the ratio in Snell's law upside down",
            hint: "In the denser medium the angle is the smaller one: is yours?",
            answer: |q| {
                let turned = Fresnel {
                    n1: q.n2,
                    n2: q.n1,
                    ..*q
                };
                cos2(&turned)
                    .map_or_else(|| mean(1.0, 1.0), |cos2| shares(q.n1, q.cos1, q.n2, cos2))
            },
        },
        Mistake {
            name: "takes the same angle on both sides",
            hint: "The formulas have two angles; what does Snell's law say about the second?",
            answer: |q| {
                if cos2(q).is_some() {
                    shares(q.n1, q.cos1, q.n2, q.cos1)
                } else {
                    mean(1.0, 1.0)
                }
            },
        },
        Mistake {
            name: "exchanges the two media",
            hint: "Out of glass, all is reflected from 42° on; into glass, never. Try 60° both ways.",
            answer: |q| {
                Fresnel::right(&Fresnel {
                    cos1: q.cos1,
                    n1: q.n2,
                    n2: q.n1,
                })
            },
        },
        Mistake {
            name: "takes the sum of Rs and Rp for R",
            hint: "Unpolarised light is half of one kind and half of the other.",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::right(q);
                let r = if cos2(q).is_some() { rs + rp } else { 1.0 };
                FresnelAnswer { rs, rp, r }
            },
        },
        Mistake {
            name: "leaves Rp out of R",
            hint: "Unpolarised light is half of one kind and half of the other: where is the other half in yours?",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::right(q);
                FresnelAnswer { rs, rp, r: rs }
            },
        },
        Mistake {
            name: "takes the product of Rs and Rp for R",
            hint: "Unpolarised light is half of one kind and half of the other: what is the mean of both?",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::right(q);
                FresnelAnswer { rs, rp, r: rs * rp }
            },
        },
        Mistake {
            name: "forgets to square the amplitude of Rs",
            hint: "Can a share of the light be negative?",
            answer: |q| {
                cos2(q).map_or_else(
                    || mean(1.0, 1.0),
                    |cos2| {
                        let FresnelAnswer { rp, .. } = Fresnel::right(q);
                        let (a, b) = (q.n1 * q.cos1, q.n2 * cos2);
                        mean((a - b) / (a + b), rp)
                    },
                )
            },
        },
        Mistake {
            name: "forgets to square the amplitude of Rp",
            hint: "Can a share of the light be negative?",
            answer: |q| {
                cos2(q).map_or_else(
                    || mean(1.0, 1.0),
                    |cos2| {
                        let FresnelAnswer { rs, .. } = Fresnel::right(q);
                        let (a, b) = (q.n1 * cos2, q.n2 * q.cos1);
                        mean(rs, (a - b) / (a + b))
                    },
                )
            },
        },
        Mistake {
            name: "divides Rp by the sum that belongs to Rs",
            hint: "Below the fraction line of Rp: which index goes with which cosine?",
            answer: |q| {
                cos2(q).map_or_else(
                    || mean(1.0, 1.0),
                    |cos2| {
                        let FresnelAnswer { rs, .. } = Fresnel::right(q);
                        let rp = (q.n1 * cos2 - q.n2 * q.cos1) / (q.n1 * q.cos1 + q.n2 * cos2);
                        mean(rs, rp * rp)
                    },
                )
            },
        },
        Mistake {
            name: "takes the geometric mean of Rs and Rp for R",
            hint: "Unpolarised light is half of one kind and half of the other: what is the mean of both?",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::right(q);
                FresnelAnswer {
                    rs,
                    rp,
                    r: (rs * rp).sqrt(),
                }
            },
        },
        Mistake {
            name: "returns Schlick's approximation for R, beside the exact Rs and Rp",
            hint: "R is the mean of Rs and Rp: why approximate what you have?",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::right(q);
                FresnelAnswer {
                    rs,
                    rp,
                    r: fresnel::schlick(q.cos1, q.n1, q.n2).max(if cos2(q).is_some() {
                        0.0
                    } else {
                        1.0
                    }),
                }
            },
        },
        Mistake {
            name: "forgets the root in the cosine on the other side",
            hint: "sin² + cos² = 1: what do you have when you take sin² from 1?",
            answer: |q| {
                cos2(q).map_or_else(
                    || mean(1.0, 1.0),
                    |cos2| shares(q.n1, q.cos1, q.n2, cos2 * cos2),
                )
            },
        },
        Mistake {
            name: "forgets the root in the sine of the angle",
            hint: "sin² + cos² = 1: what do you have when you take cos² from 1?",
            answer: |q| {
                let sine = q.n1 / q.n2 * (1.0 - q.cos1 * q.cos1);
                if sine >= 1.0 {
                    mean(1.0, 1.0)
                } else {
                    shares(q.n1, q.cos1, q.n2, (1.0 - sine * sine).sqrt())
                }
            },
        },
        Mistake {
            name: "takes 1 − cos θ₁ for sin θ₁",
            hint: "sin² + cos² = 1: what are sine and cosine of 60° together?",
            answer: |q| {
                let sine = q.n1 / q.n2 * (1.0 - q.cos1);
                if sine >= 1.0 {
                    mean(1.0, 1.0)
                } else {
                    shares(q.n1, q.cos1, q.n2, (1.0 - sine * sine).sqrt())
                }
            },
        },
        Mistake {
            name: "squares half of the difference of both amplitudes for R",
            hint: "Unpolarised light is half of one kind and half of the other: are amplitudes added, or shares of the light?",
            answer: |q| by_amplitudes(q, |s, p| s - p),
        },
        Mistake {
            name: "squares the mean of both amplitudes for R",
            hint: "Unpolarised light is half of one kind and half of the other: are amplitudes added, or shares of the light?",
            answer: |q| by_amplitudes(q, |s, p| s + p),
        },
        Mistake {
            name: "exchanges the two media where the first is the denser one",
            hint: "Out of glass, all is reflected from 42° on: is there such an angle in yours?",
            answer: |q| {
                Fresnel::right(&Fresnel {
                    n1: q.n1.min(q.n2),
                    n2: q.n1.max(q.n2),
                    ..*q
                })
            },
        },
        Mistake {
            name: "compares the cosine with n₂/n₁ for total reflection",
            hint: "At the critical angle, the sine is n₂/n₁: is the ray steeper or flatter where all is reflected?",
            answer: |q| {
                if q.n1 > q.n2 && q.cos1 < q.n2 / q.n1 {
                    mean(1.0, 1.0)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes n₁/n₂ cos θ₁ for cos θ₂, as if Snell's law were one of cosines",
            hint: "Snell's law is about the angles' sines: how do you come from a cosine to a sine, and back?",
            answer: |q| match cos2(q) {
                Some(_) => shares(q.n1, q.cos1, q.n2, q.n1 / q.n2 * q.cos1),
                None => Fresnel::right(q),
            },
        },
        Mistake {
            name: "takes the shares of light that arrives straight, at any angle",
            hint: "Look along a window: does it mirror as little as when you look straight into it?",
            answer: |q| {
                if cos2(q).is_some() {
                    shares(q.n1, 1.0, q.n2, 1.0)
                } else {
                    mean(1.0, 1.0)
                }
            },
        },
        Mistake {
            name: "reflects all light where the medium behind is the thinner one, at any angle",
            hint: "Look out of the water, straight up: do you see the sky?",
            answer: |q| {
                if q.n1 > q.n2 {
                    mean(1.0, 1.0)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "forgets to square the sine in the cosine on the other side",
            hint: "sin² + cos² = 1: which of the two squares is missing in yours?",
            answer: |q| {
                let sine = q.n1 / q.n2 * (1.0 - q.cos1 * q.cos1).sqrt();
                if sine >= 1.0 {
                    mean(1.0, 1.0)
                } else {
                    shares(q.n1, q.cos1, q.n2, (1.0 - sine).sqrt())
                }
            },
        },
        Mistake {
            name: "compares the sine with n₁/n₂ for total reflection",
            hint: "The sine behind the surface is n₁/n₂ times that before it: when is it 1?",
            answer: |q| {
                let sine = (1.0 - q.cos1 * q.cos1).sqrt();
                if sine > q.n1 / q.n2 {
                    mean(1.0, 1.0)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes the root of the mean of both squares for R",
            hint: "Unpolarised light is half of one kind and half of the other: what is the mean of both?",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::right(q);
                let r = (0.5 * (rs * rs + rp * rp)).sqrt();
                FresnelAnswer { rs, rp, r }
            },
        },
        Mistake {
            name: "squares the amplitudes of the light that goes through",
            hint: "Which light do the two formulas speak of: what is reflected, or what goes on behind the surface?",
            answer: |q| match cos2(q) {
                Some(cos2) => {
                    let share = |sum: f32| (2.0 * q.n1 * q.cos1 / sum.max(1e-6)).powi(2);
                    let (s, p) = (q.n1 * q.cos1 + q.n2 * cos2, q.n1 * cos2 + q.n2 * q.cos1);
                    mean(share(s), share(p))
                }
                None => Self::right(q),
            },
        },
        Mistake {
            name: "returns Schlick's approximation for R, with θ₁ even where n₁ > n₂, beside the exact Rs and Rp",
            hint: "R is the mean of Rs and Rp: why approximate what you have?",
            answer: |q| {
                let FresnelAnswer { rs, rp, r } = Fresnel::right(q);
                let r = cos2(q).map_or(r, |_| schlick_of_cos1(q));
                FresnelAnswer { rs, rp, r }
            },
        },
        Mistake {
            name: "returns Schlick's approximation for Rs, Rp and R, with θ₁ even where n₁ > n₂",
            hint: "One of Rs and Rp is zero at Brewster's angle: which of yours is?",
            answer: |q| {
                let r = cos2(q).map_or(1.0, |_| schlick_of_cos1(q));
                mean(r, r)
            },
        },
        Mistake {
            name: "returns Schlick's approximation for Rs, Rp and R, and knows no total reflection",
            hint: "One of Rs and Rp is zero at Brewster's angle: which of yours is? And where no light goes through, where does it all go?",
            answer: |q| {
                let r = schlick_of_cos1(q);
                mean(r, r)
            },
        },
        Mistake {
            name: "squares the mean of the sizes of both amplitudes for R",
            hint: "Unpolarised light is half of one kind and half of the other: are amplitudes added, or shares of the light?",
            answer: |q| by_amplitudes(q, |s, p| s.abs() + p.abs()),
        },
    ];
}

/// The same media from the denser side, and an angle whose sine behind the surface is nearly 1: a threshold that is a little wrong shows
/// there only. Single precision still tells on which side of 1 it is, and media that are nearly alike have no such angle but along the surface.
fn near_the_critical_angle(rng: &mut Pcg, asked: &Fresnel) -> Fresnel {
    let n2 = asked.n1.min(asked.n2);
    let n1 = asked.n1.max(asked.n2).max(1.05 * n2);
    let off = sample::number(rng, 0.004, 0.02);
    let sin2 = if rng.random_bool(0.5) {
        1.0 + off
    } else {
        1.0 - off
    };
    let sin1 = sin2 * n2 / n1;
    Fresnel {
        cos1: (1.0 - sin1 * sin1).sqrt(),
        n1,
        n2,
    }
}

/// The answer whose R is the square of half of what is made of the two amplitudes.
fn by_amplitudes(q: &Fresnel, both: fn(f32, f32) -> f32) -> FresnelAnswer {
    let FresnelAnswer { rs, rp, r } = Fresnel::right(q);
    let r = cos2(q).map_or(r, |cos2| {
        let amplitude = |a: f32, b: f32| (a - b) / (a + b);
        let s = amplitude(q.n1 * q.cos1, q.n2 * cos2);
        let p = amplitude(q.n1 * cos2, q.n2 * q.cos1);
        (0.5 * both(s, p)).powi(2)
    });
    FresnelAnswer { rs, rp, r }
}

/// Schlick's approximation from the angle before the surface, whichever medium is the denser one.
fn schlick_of_cos1(q: &Fresnel) -> f32 {
    let (thinner, denser) = (q.n1.min(q.n2), q.n1.max(q.n2));
    fresnel::schlick(q.cos1, thinner, denser)
}

/// cos θ₂, unless all is reflected.
fn cos2(q: &Fresnel) -> Option<f32> {
    let squared = 1.0 - (q.n1 / q.n2).powi(2) * (1.0 - q.cos1 * q.cos1);
    (squared >= 0.0).then(|| squared.sqrt())
}

/// Rs and Rp by their formulas, from any cosines.
fn shares(n1: f32, cos1: f32, n2: f32, cos2: f32) -> FresnelAnswer {
    let share = |a: f32, b: f32| ((a - b) / (a + b)).powi(2);
    mean(share(n1 * cos1, n2 * cos2), share(n1 * cos2, n2 * cos1))
}

fn mean(rs: f32, rp: f32) -> FresnelAnswer {
    FresnelAnswer {
        rs,
        rp,
        r: 0.5 * (rs + rp),
    }
}
