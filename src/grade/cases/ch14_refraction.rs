//! Chapter 14: `refract`, `fresnel`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Verdict, judge, sample};
use crate::material::fresnel;
use crate::math::{dir3::Dir3, pcg::Pcg};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch14_refraction::{
    Fresnel, FresnelAnswer, FresnelQuestion, Refract, RefractQuestion,
};
use glam::{Vec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&Refract, &Fresnel];

impl Graded for Refract {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "never turns the normal",
            hint: "On which side of the surface is a ray that leaves the glass? Your formula wants the normal on the ray's side.",
            answer: |q| snell(q, *q.normal, -q.direction.dot(*q.normal), ratio(q)),
        },
        Mistake {
            name: "takes the same ratio for entering and leaving",
            hint: "A ray that leaves the glass comes from the inside: which index is then n1?",
            answer: |q| {
                let n = facing(q);
                snell(q, n, -q.direction.dot(n), q.outside / q.inside)
            },
        },
        Mistake {
            name: "has the ratio of the indices upside down",
            hint: "Into a denser medium a ray bends towards the normal: does yours?",
            answer: |q| {
                let n = facing(q);
                snell(q, n, -q.direction.dot(n), 1.0 / ratio(q))
            },
        },
        Mistake {
            name: "has the sign of the cosine wrong",
            hint: "The ray runs against the normal: which sign does their dot product have?",
            answer: |q| {
                let n = facing(q);
                snell(q, n, q.direction.dot(n), ratio(q))
            },
        },
        Mistake {
            name: "mirrors the ray where it is totally reflected",
            hint: "This function is asked for the ray behind the surface only: is there one?",
            answer: |q| {
                let n = facing(q);
                let mirrored = *q.direction - 2.0 * q.direction.dot(n) * n;
                Some(Refract::answer(q).unwrap_or(mirrored))
            },
        },
        Mistake {
            name: "lets the ray graze the surface where it is totally reflected",
            hint: "What does it mean if the sine of an angle would be larger than 1?",
            answer: |q| {
                let n = facing(q);
                let along = *q.direction - q.direction.dot(n) * n;
                Refract::answer(q).or(Some(along.normalize_or_zero()))
            },
        },
        Mistake {
            name: "forgets the square root",
            hint: "You have the square of a cosine: how long is your answer at 45°?",
            answer: |q| {
                let (n, along) = (facing(q), along(q)?);
                Some(along - (1.0 - along.length_squared()) * n)
            },
        },
        Mistake {
            name: "sends the ray to the wrong side",
            hint: "Does your ray go on behind the surface, or come back?",
            answer: |q| {
                let (n, along) = (facing(q), along(q)?);
                Some(along + (1.0 - along.length_squared()).sqrt() * n)
            },
        },
        Mistake {
            name: "goes straight on",
            hint: "Where are the two indices in your formula?",
            answer: |q| Refract::answer(q).map(|_| *q.direction),
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, direction: Vec3, normal: Vec3, outside, inside| {
            Edge::new(
                name,
                RefractQuestion {
                    direction: Dir3::new_or(direction, Dir3::Y),
                    normal: Dir3::new_or(normal, Dir3::Y),
                    outside,
                    inside,
                },
            )
        };
        let down = |degrees: f32| {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            vec3(sine, -cosine, 0.0)
        };
        let up = |degrees: f32| down(degrees) * vec3(1.0, -1.0, 1.0);
        vec![
            edge("straight into glass", Vec3::NEG_Y, Vec3::Y, 1.0, 1.5),
            edge("straight out of glass", Vec3::Y, Vec3::Y, 1.0, 1.5),
            edge("into glass at 45°", down(45.0), Vec3::Y, 1.0, 1.5),
            edge("out of glass at 30°", up(30.0), Vec3::Y, 1.0, 1.5),
            edge(
                "out of glass at 60°: totally reflected",
                up(60.0),
                Vec3::Y,
                1.0,
                1.5,
            ),
            edge(
                "just before the critical angle",
                up(41.5),
                Vec3::Y,
                1.0,
                1.5,
            ),
            edge(
                "just behind the critical angle",
                up(42.1),
                Vec3::Y,
                1.0,
                1.5,
            ),
            edge("into glass, nearly along it", down(89.0), Vec3::Y, 1.0, 1.5),
            edge(
                "the same medium on both sides",
                down(50.0),
                Vec3::Y,
                1.333,
                1.333,
            ),
            edge("from water into glass", down(50.0), Vec3::Y, 1.333, 1.5),
            edge(
                "into a bubble of air in glass",
                down(20.0),
                Vec3::Y,
                1.5,
                1.0,
            ),
            edge(
                "a bubble that reflects totally",
                down(60.0),
                Vec3::Y,
                1.5,
                1.0,
            ),
            edge(
                "out of a bubble of air in glass",
                up(60.0),
                Vec3::Y,
                1.5,
                1.0,
            ),
            edge(
                "a normal askew",
                vec3(0.3, -0.5, -0.8),
                vec3(-1.0, 1.0, 2.0),
                1.0,
                2.417,
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> RefractQuestion {
        let (normal, mut direction) = (sample::direction(rng), sample::direction(rng));
        // Steep rays are refracted, flat ones are often not: most are to be refracted.
        if rng.random_bool(0.5) {
            let steeper = *direction + direction.dot(*normal).signum() * *normal;
            direction = Dir3::new_or(steeper, direction);
        }
        RefractQuestion {
            direction,
            normal,
            outside: sample::number(rng, 1.0, 1.7),
            inside: sample::number(rng, 1.0, 2.4),
        }
    }

    fn judge(_q: &RefractQuestion, golden: &Option<Vec3>, got: &Option<Vec3>) -> Verdict {
        let (golden, got) = (golden.as_ref(), got.as_ref());
        judge::option("a refracted ray", golden, got, |golden, got| {
            judge::direction("the refracted ray", *golden, *got)
        })
    }
}

/// The normal on the ray's side.
fn facing(q: &RefractQuestion) -> Vec3 {
    -q.direction.dot(*q.normal).signum() * *q.normal
}

/// n₁/n₂.
fn ratio(q: &RefractQuestion) -> f32 {
    if q.direction.dot(*q.normal) < 0.0 {
        q.outside / q.inside
    } else {
        q.inside / q.outside
    }
}

/// The part of the refracted ray along the surface, unless it is totally reflected.
fn along(q: &RefractQuestion) -> Option<Vec3> {
    let n = facing(q);
    let along = ratio(q) * (*q.direction - q.direction.dot(n) * n);
    (along.length_squared() < 1.0).then_some(along)
}

/// η i + (η cos θ₁ − √(1 − η²(1 − cos²θ₁))) n.
fn snell(q: &RefractQuestion, n: Vec3, cos1: f32, eta: f32) -> Option<Vec3> {
    let cos2_squared = 1.0 - eta * eta * (1.0 - cos1 * cos1);
    (cos2_squared >= 0.0).then(|| eta * *q.direction + (eta * cos1 - cos2_squared.sqrt()) * n)
}

impl Graded for Fresnel {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "returns Schlick's approximation",
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
                let FresnelAnswer { rs, rp, r } = Fresnel::answer(q);
                FresnelAnswer { rs: rp, rp: rs, r }
            },
        },
        Mistake {
            name: "forgets to square",
            hint: "The fractions are those of the field; the light's power goes with its square.",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::answer(q);
                mean(rs.sqrt(), rp.sqrt())
            },
        },
        Mistake {
            name: "reflects nothing behind the critical angle",
            hint: "Where no light goes through, where does it all go?",
            answer: |q| {
                if cos2(q).is_some() {
                    Fresnel::answer(q)
                } else {
                    mean(0.0, 0.0)
                }
            },
        },
        Mistake {
            name: "has the ratio in Snell's law upside down",
            hint: "In the denser medium the angle is the smaller one: is yours?",
            answer: |q| {
                let eta = q.n2 / q.n1;
                let cos2 = (1.0 - eta * eta * (1.0 - q.cos1 * q.cos1)).max(0.0).sqrt();
                shares(q.n1, q.cos1, q.n2, cos2)
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
                Fresnel::answer(&FresnelQuestion {
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
                let FresnelAnswer { rs, rp, .. } = Fresnel::answer(q);
                FresnelAnswer { rs, rp, r: rs + rp }
            },
        },
        Mistake {
            name: "leaves Rp out of R",
            hint: "Is lamplight polarised?",
            answer: |q| {
                let FresnelAnswer { rs, rp, .. } = Fresnel::answer(q);
                FresnelAnswer { rs, rp, r: rs }
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, degrees: f32, n1, n2| {
            let cos1 = degrees.to_radians().cos().max(0.0);
            Edge::new(name, FresnelQuestion { cos1, n1, n2 })
        };
        vec![
            edge("straight into glass: 4 %", 0.0, 1.0, 1.5),
            edge("straight out of glass: 4 % too", 0.0, 1.5, 1.0),
            edge("into glass at 45°", 45.0, 1.0, 1.5),
            edge("out of glass at 10°", 10.0, 1.5, 1.0),
            edge("Brewster's angle: Rp is 0", 56.309_93, 1.0, 1.5),
            edge("into glass at 89°", 89.0, 1.0, 1.5),
            Edge::new(
                "along the surface: all is reflected",
                FresnelQuestion {
                    cos1: 0.0,
                    n1: 1.0,
                    n2: 1.5,
                },
            ),
            edge("out of glass at 40°", 40.0, 1.5, 1.0),
            edge("out of glass at 60°: totally reflected", 60.0, 1.5, 1.0),
            edge("the same medium on both sides", 70.0, 1.333, 1.333),
            edge("from water into glass", 50.0, 1.333, 1.5),
            edge("into diamond", 30.0, 1.0, 2.417),
        ]
    }

    fn random(rng: &mut Pcg) -> FresnelQuestion {
        FresnelQuestion {
            cos1: sample::number(rng, 0.02, 1.0),
            n1: sample::number(rng, 1.0, 1.7),
            n2: sample::number(rng, 1.0, 2.4),
        }
    }

    fn judge(_q: &FresnelQuestion, golden: &FresnelAnswer, got: &FresnelAnswer) -> Verdict {
        /// Of all light. Other orders of the same operations in `f32` are within 1e-6 of each other where the answer is stable.
        const TOLERANCE: f32 = 1e-4;
        let close = |name, golden, got| judge::number_within(name, "", golden, got, TOLERANCE);
        close("Rs", golden.rs, got.rs)?;
        close("Rp", golden.rp, got.rp)?;
        close("R", golden.r, got.r)
    }
}

/// cos θ₂, unless all is reflected.
fn cos2(q: &FresnelQuestion) -> Option<f32> {
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
