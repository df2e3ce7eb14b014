//! Chapter 17: `cosine_hemisphere`, `brdf_phong`, `reflected_radiance`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::material::modified_phong::ModifiedPhong;
use crate::math::{basis::Basis, dir3::Dir3, pcg::Pcg};
use crate::sample::hemisphere;
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch17_rendering_equation::{
    BrdfPhong, BrdfPhongQuestion, CosineHemisphere, CosineHemisphereQuestion, ReflectedRadiance,
    ReflectedRadianceQuestion, lattice,
};
use glam::{Vec2, Vec3, vec3};
use rand::RngExt;
use std::f32::consts::{FRAC_PI_2, PI, TAU};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&CosineHemisphere, &BrdfPhong, &ReflectedRadiance];

fn toward(x: f32, y: f32, z: f32) -> Dir3 {
    Dir3::new_or(vec3(x, y, z), Dir3::Z)
}

/// The lattice's images, given in coordinates whose z is the normal.
fn around(q: &CosineHemisphereQuestion, warp: fn(Vec2) -> Vec3) -> Vec<Vec3> {
    let basis = Basis::around(q.normal);
    lattice(q.n).map(|u| basis.to_world(warp(u))).collect()
}

/// The direction at a height over the horizon, and an angle around the normal.
fn at_height(z: f32, phi: f32) -> Vec3 {
    let r = (1.0 - z * z).max(0.0).sqrt();
    vec3(r * phi.cos(), r * phi.sin(), z)
}

impl Graded for CosineHemisphere {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes all directions for equally likely",
            hint: "How many of your directions are less than 30° above the horizon? By the cosine it is a quarter, and uniformly it is a half.",
            answer: |q| around(q, |u| at_height(1.0 - u.x, TAU * u.y)),
        },
        Mistake {
            name: "takes the radius on the disc itself for the uniform number",
            hint: "The inner half of a disc's radius holds only a quarter of its area: does it get only a quarter of your points?",
            answer: |q| around(q, |u| at_height((1.0 - u.x * u.x).sqrt(), TAU * u.y)),
        },
        Mistake {
            name: "spreads the angle to the normal evenly",
            hint: "A ring around the normal gets larger with its angle: do your points crowd where it is small?",
            answer: |q| around(q, |u| at_height((FRAC_PI_2 * u.x).cos(), TAU * u.y)),
        },
        Mistake {
            name: "ignores the normal",
            hint: "Try a normal that points down: do your directions follow it?",
            answer: |q| {
                CosineHemisphere::answer(&CosineHemisphereQuestion {
                    normal: Dir3::Z,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "goes only half way round",
            hint: "Add up all your directions: does the sum point along the normal?",
            answer: |q| around(q, |u| at_height((1.0 - u.x).sqrt(), PI * u.y)),
        },
        Mistake {
            name: "leaves the disc at a height of 1 − r",
            hint: "How long are your directions? What is the height of a sphere above the point at r?",
            answer: |q| {
                around(q, |u| {
                    let (r, phi) = (u.x.sqrt(), TAU * u.y);
                    vec3(r * phi.cos(), r * phi.sin(), 1.0 - r)
                })
            },
        },
        Mistake {
            name: "fills the whole sphere",
            hint: "Which of your directions point into the surface?",
            answer: |q| around(q, |u| at_height(1.0 - 2.0 * u.x, TAU * u.y)),
        },
        Mistake {
            name: "uses one of the two numbers twice",
            hint: "Draw your directions on the disc: do they fill it, or do they make a spiral?",
            answer: |q| around(q, |u| at_height((1.0 - u.x).sqrt(), TAU * u.x)),
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, normal, n| Edge::new(name, CosineHemisphereQuestion { normal, n });
        vec![
            edge("the normal is +z", Dir3::Z, 64),
            edge("the normal is −z", -Dir3::Z, 64),
            edge("the normal is up", Dir3::Y, 60),
            edge("the normal is +x", Dir3::X, 72),
            edge("the normal is down", -Dir3::Y, 64),
            edge("nearly −z", toward(1e-4, -1e-4, -1.0), 64),
            edge("askew", toward(-1.0, 2.0, 0.5), 90),
        ]
    }

    fn random(rng: &mut Pcg) -> CosineHemisphereQuestion {
        CosineHemisphereQuestion {
            normal: sample::direction(rng),
            n: rng.random_range(48..=96),
        }
    }

    /// By what the directions have in common, whichever number makes the radius and from wherever the angle is counted.
    ///
    /// The bounds are errors of the lattice, not of chance. Measured for n from 48 to 96, with the numbers exchanged or
    /// not, any turn around the normal, the disc by rings or by squares (Shirley and Chiu 1997), or a sphere's point added
    /// to the normal: all means are right to 0.026, and the shares too. The nearest mistakes, which spread the angle evenly
    /// and which use a number twice, are off by 0.095 in a share, and by 0.12 in a mean.
    fn judge(q: &CosineHemisphereQuestion, _golden: &Vec<Vec3>, got: &Vec<Vec3>) -> Verdict {
        const BOUND: f32 = 0.055;
        let expected = q.n as usize;
        if got.len() != expected {
            return Err(format!(
                "there are {} directions; {expected} were asked",
                got.len()
            ));
        }
        let basis = Basis::around(q.normal);
        let local = |d: &Vec3| vec3(d.dot(*basis.x), d.dot(*basis.y), d.dot(*basis.z));
        let local: Vec<_> = got.iter().map(local).collect();
        for (d, i) in local.iter().zip(1..) {
            let length = d.length();
            if !((length - 1.0).abs() <= judge::LENGTH) {
                return Err(format!(
                    "direction {i} has length {length:.4}; a direction has length 1"
                ));
            }
            if d.z < -judge::LENGTH {
                let below = (-d.z).min(1.0).asin().to_degrees();
                return Err(format!("direction {i} points {below:.1}° into the surface"));
            }
        }
        let mean = |f: fn(&Vec3) -> f32| local.iter().map(f).sum::<f32>() / expected as f32;
        for (name, got, exact) in [
            ("the mean of cos θ", mean(|d| d.z), 2.0 / 3.0),
            ("the mean of cos²θ", mean(|d| d.z * d.z), 0.5),
            ("the mean to one side", mean(|d| d.x), 0.0),
            ("the mean to the other side", mean(|d| d.y), 0.0),
            (
                "the mean of the squares to one side",
                mean(|d| d.x * d.x),
                0.25,
            ),
            ("the mean of xy", mean(|d| d.x * d.y), 0.0),
        ] {
            if (got - exact).abs() > BOUND {
                return Err(format!(
                    "{name} is {got:.3} and should be {exact:.3} (x and y are square to the normal)"
                ));
            }
        }
        // cos²θ ≤ h has the probability h: the disc's area outside the radius √(1 − h).
        let mut heights: Vec<_> = local.iter().map(|d| d.z * d.z).collect();
        heights.sort_by(f32::total_cmp);
        for (i, h) in heights.iter().enumerate() {
            let (below, up_to) = (i as f32 / expected as f32, (i + 1) as f32 / expected as f32);
            if below - h > BOUND || h - up_to > BOUND {
                let degrees = h.clamp(0.0, 1.0).sqrt().asin().to_degrees();
                return Err(format!(
                    "{:.0} % of the directions are less than {degrees:.0}° above the surface; {:.0} % should be",
                    100.0 * below,
                    100.0 * h
                ));
            }
        }
        Ok(())
    }
}

/// The matt part plus the highlight times a factor, of which all mistakes are made.
fn phong(q: &BrdfPhongQuestion, cos_alpha: f32, matt: f32, norm: f32) -> Rgb {
    if q.normal.dot(*q.toward) <= 0.0 || q.normal.dot(*q.view) <= 0.0 {
        return Rgb::BLACK;
    }
    q.diffuse * matt + q.specular * (norm * cos_alpha.max(0.0).powf(q.exponent))
}

fn cos_alpha(q: &BrdfPhongQuestion) -> f32 {
    2.0 * q.normal.dot(*q.toward) * q.normal.dot(*q.view) - q.toward.dot(*q.view)
}

fn norm(q: &BrdfPhongQuestion) -> f32 {
    (q.exponent + 2.0) / TAU
}

impl Graded for BrdfPhong {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "multiplies by the cosine",
            hint: "Exchange light and viewer: a BRDF stays the same. To what does the cosine belong?",
            answer: |q| BrdfPhong::answer(q) * q.normal.dot(*q.toward),
        },
        Mistake {
            name: "divides by the cosine",
            hint: "What happens to your BRDF when the light goes down to the horizon?",
            answer: |q| {
                let cosine = q.normal.dot(*q.toward);
                if cosine > 0.0 {
                    BrdfPhong::answer(q) / cosine
                } else {
                    Rgb::BLACK
                }
            },
        },
        Mistake {
            name: "leaves the highlight without its factor",
            hint: "The sharper a highlight, the brighter it must be in its middle to send out the same light.",
            answer: |q| phong(q, cos_alpha(q), 1.0 / PI, 1.0),
        },
        Mistake {
            name: "takes the factor of the lobe alone",
            hint: "Which integral should be 1: of cosⁿα, or of cosⁿα cos θ?",
            answer: |q| phong(q, cos_alpha(q), 1.0 / PI, (q.exponent + 1.0) / TAU),
        },
        Mistake {
            name: "forgets the π under the matt part",
            hint: "How much does a surface with your BRDF send to all sides together, for each watt that arrives?",
            answer: |q| phong(q, cos_alpha(q), 1.0, norm(q)),
        },
        Mistake {
            name: "looks for the highlight at the light",
            hint: "Where does a mirror show the light: where it is, or on the other side of the normal?",
            answer: |q| phong(q, q.toward.dot(*q.view), 1.0 / PI, norm(q)),
        },
        Mistake {
            name: "mirrors the light into the surface",
            hint: "Try a light straight above: where does your mirror direction point?",
            answer: |q| phong(q, -cos_alpha(q), 1.0 / PI, norm(q)),
        },
        Mistake {
            name: "takes the half vector",
            hint: "That is Blinn's model: which two vectors make the angle in Phong's?",
            answer: |q| {
                let half = Dir3::new_or(*q.toward + *q.view, q.normal);
                phong(q, half.dot(*q.normal), 1.0 / PI, norm(q))
            },
        },
        Mistake {
            name: "has a second highlight behind",
            hint: "An even power of a negative number is positive: what is the highlight beyond 90°?",
            answer: |q| phong(q, cos_alpha(q).abs(), 1.0 / PI, norm(q)),
        },
        Mistake {
            name: "lights the surface from behind",
            hint: "What does a lamp do to the top of a table that it hangs under?",
            answer: |q| {
                let highlight = cos_alpha(q).max(0.0).powf(q.exponent);
                q.diffuse * (1.0 / PI) + q.specular * (norm(q) * highlight)
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, view: Dir3, light: Dir3, exponent| -> Edge<Self> {
            Edge::new(
                name,
                BrdfPhongQuestion {
                    normal: Dir3::Z,
                    view,
                    toward: light,
                    diffuse: Rgb::new(0.5, 0.3, 0.1),
                    specular: Rgb::new(0.3, 0.4, 0.5),
                    exponent,
                },
            )
        };
        let slant = |x: f32| toward(x, 0.0, 1.0);
        let mut turned = edge(
            "the normal is askew",
            slant(0.5),
            toward(0.0, 1.0, 1.0),
            8.0,
        );
        turned.question.normal = toward(0.3, 0.4, 1.0);
        vec![
            edge("both straight above", Dir3::Z, Dir3::Z, 10.0),
            edge("in the mirror direction", slant(1.0), slant(-1.0), 20.0),
            edge("the view along the light", slant(0.7), slant(0.7), 5.0),
            edge(
                "the light below the horizon",
                slant(0.2),
                toward(0.3, 0.0, -1.0),
                4.0,
            ),
            edge(
                "the viewer below the horizon",
                toward(0.3, 0.0, -1.0),
                slant(0.2),
                4.0,
            ),
            edge(
                "more than 90° from the mirror direction",
                slant(3.0),
                slant(2.0),
                2.0,
            ),
            edge("an exponent of 0", slant(0.5), toward(0.1, 0.4, 1.0), 0.0),
            edge(
                "a sharp highlight",
                slant(0.5),
                toward(-0.52, 0.03, 1.0),
                200.0,
            ),
            edge(
                "the light near the horizon",
                slant(0.5),
                toward(-6.0, 1.0, 0.6),
                3.0,
            ),
            turned,
        ]
    }

    fn random(rng: &mut Pcg) -> BrdfPhongQuestion {
        let normal = sample::direction(rng);
        let above = |rng: &mut Pcg| {
            let d = sample::direction(rng);
            let flipped = if d.dot(*normal) < 0.0 { -d } else { d };
            Dir3::new_or(*flipped + 0.1 * *normal, normal)
        };
        let (view, light) = (above(rng), above(rng));
        // Half of them near the highlight, a few behind the surface.
        let mirrored = 2.0 * view.dot(*normal) * *normal - *view;
        let toward = match rng.random_range(0..20) {
            0 => -light,
            1..=10 => Dir3::new_or(mirrored + sample::point(rng, 0.3), normal),
            _ => light,
        };
        BrdfPhongQuestion {
            normal,
            view,
            toward,
            diffuse: colour(rng, 0.05, 0.6),
            specular: colour(rng, 0.1, 0.4),
            exponent: sample::number(rng, 0.5, 40.0),
        }
    }

    fn judge(_q: &BrdfPhongQuestion, golden: &Rgb, got: &Rgb) -> Verdict {
        let channels = golden.channels().into_iter().zip(got.channels());
        for (name, (golden, got)) in ["red", "green", "blue"].into_iter().zip(channels) {
            let tolerance = judge::RELATIVE * golden.max(0.01);
            judge::number_within(name, "per steradian", golden, got, tolerance)?;
        }
        Ok(())
    }
}

fn colour(rng: &mut Pcg, min: f32, max: f32) -> Rgb {
    Rgb::new(
        sample::number(rng, min, max),
        sample::number(rng, min, max),
        sample::number(rng, min, max),
    )
}

/// ∫ g dω over the hemisphere around the normal, of several g, by the middles of cells of equal solid angle.
fn integral<const N: usize>(normal: Dir3, g: impl Fn(Dir3) -> [Rgb; N]) -> [Rgb; N] {
    const RINGS: u32 = 48;
    const SECTORS: u32 = 40;
    let basis = Basis::around(normal);
    let mut sums = [Rgb::BLACK; N];
    for i in 0..RINGS * SECTORS {
        let z = ((i / SECTORS) as f32 + 0.5) / RINGS as f32;
        let phi = TAU * ((i % SECTORS) as f32 + 0.5) / SECTORS as f32;
        let d = Dir3::new_or(basis.to_world(at_height(z, phi)), normal);
        for (sum, value) in sums.iter_mut().zip(g(d)) {
            *sum += value * (TAU / (RINGS * SECTORS) as f32);
        }
    }
    sums
}

/// ∫ f L_i cos θ · weight dω, as a wrong estimate would have it in the mean.
fn weighted(q: &ReflectedRadianceQuestion, weight: impl Fn(f32) -> f32) -> Rgb {
    let brdf = q.brdf();
    let [sum] = integral(q.normal, |d| {
        let cosine = d.dot(*q.normal);
        [brdf.value(q.normal, q.view, d) * q.sky(d) * (cosine * weight(cosine))]
    });
    sum
}

impl Graded for ReflectedRadiance {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets the cosine",
            hint: "A beam that arrives at a slant is spread over more of the surface: where does that come in?",
            answer: |q| weighted(q, |cosine| 1.0 / cosine),
        },
        Mistake {
            name: "forgets to divide by the density",
            hint: "The mean over the hemisphere is not yet the integral: how large is the hemisphere?",
            answer: |q| weighted(q, |_| hemisphere::UNIFORM),
        },
        Mistake {
            name: "takes the density of the whole sphere",
            hint: "How many steradians do your directions share?",
            answer: |q| weighted(q, |_| 2.0),
        },
        Mistake {
            name: "chooses directions uniformly and divides by the density of the cosine",
            hint: "Is p the density of the directions that you really chose?",
            answer: |q| weighted(q, |cosine| 0.5 / cosine),
        },
        Mistake {
            name: "chooses directions by the cosine and divides by the uniform density",
            hint: "Is p the density of the directions that you really chose?",
            answer: |q| weighted(q, |cosine| 2.0 * cosine),
        },
        Mistake {
            name: "adds up without dividing by the number of samples",
            hint: "Take twice as many samples: does your surface get brighter?",
            answer: |q| weighted(q, |_| q.samples as f32),
        },
        Mistake {
            name: "looks at the sky along the normal only",
            hint: "From which directions does light arrive at the surface?",
            answer: |q| (q.diffuse + q.specular) * q.sky(q.normal),
        },
        Mistake {
            name: "multiplies by π once more",
            hint: "A white surface under a white sky of radiance 1: how bright is it? It disappears.",
            answer: |q| weighted(q, |_| PI),
        },
        Mistake {
            name: "takes samples below the surface too",
            hint: "Half of a sphere is below the surface, and no light comes from there: what do such samples add, and to what density do they belong?",
            answer: |q| weighted(q, |_| 0.5),
        },
    ];

    /// Estimates scatter: what a student's is, another estimate with the same mistake is only nearly.
    const ALIKE: f32 = 0.05;

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, view: Dir3, [diffuse, specular]: [f32; 2], exponent, zenith| {
            Edge::new(
                name,
                ReflectedRadianceQuestion {
                    normal: Dir3::Y,
                    view,
                    diffuse: Rgb::new(diffuse, 0.8 * diffuse, 0.5 * diffuse),
                    specular: Rgb::gray(specular),
                    exponent,
                    zenith,
                    radiance: Rgb::new(1.0, 1.5, 2.0),
                    samples: 10_000,
                },
            )
        };
        let slant = toward(1.0, 1.0, 0.0);
        vec![
            edge("matt, under the zenith", Dir3::Y, [0.8, 0.0], 1.0, Dir3::Y),
            edge(
                "matt, the zenith is at the horizon",
                slant,
                [0.8, 0.0],
                1.0,
                Dir3::X,
            ),
            edge(
                "matt, the zenith is below",
                slant,
                [0.8, 0.0],
                1.0,
                -Dir3::Y,
            ),
            edge("only a highlight", Dir3::Y, [0.0, 0.9], 3.0, Dir3::Y),
            edge(
                "a highlight towards the zenith",
                slant,
                [0.2, 0.6],
                6.0,
                toward(-1.0, 1.0, 0.0),
            ),
            edge(
                "a highlight away from the zenith",
                slant,
                [0.2, 0.6],
                6.0,
                toward(1.0, 1.0, 0.0),
            ),
            edge(
                "seen at a slant: part of the lobe is cut off",
                toward(1.0, 0.3, 0.2),
                [0.1, 0.6],
                2.0,
                Dir3::Y,
            ),
            edge(
                "the highlight is as wide as the matt part",
                slant,
                [0.3, 0.3],
                1.0,
                Dir3::Z,
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> ReflectedRadianceQuestion {
        let normal = sample::direction(rng);
        let d = sample::direction(rng);
        let above = if d.dot(*normal) < 0.0 { -d } else { d };
        ReflectedRadianceQuestion {
            normal,
            view: Dir3::new_or(*above + 0.3 * *normal, normal),
            diffuse: colour(rng, 0.2, 0.6),
            specular: colour(rng, 0.05, 0.3),
            exponent: sample::number(rng, 0.5, 5.0),
            zenith: Dir3::new_or(*sample::direction(rng) + *normal, normal),
            radiance: colour(rng, 0.5, 3.0),
            samples: 10_000,
        }
    }

    /// Against the integral. The bound is 6.5 standard deviations of the estimate by uniform directions or by the cosine,
    /// whichever scatters more: of 500 students with 42 cases of three channels, chance fails one with a probability of
    /// 500 · 126 · 8e-11 = 5e-6.
    fn judge(q: &ReflectedRadianceQuestion, _golden: &Rgb, got: &Rgb) -> Verdict {
        const DEVIATIONS: f32 = 6.5;
        let brdf: ModifiedPhong = q.brdf();
        let [exact, uniform, cosine] = integral(q.normal, |d| {
            let cosine = d.dot(*q.normal);
            let light = brdf.value(q.normal, q.view, d) * q.sky(d) * cosine;
            let square = |pdf: f32| light * light / pdf;
            [
                light,
                square(hemisphere::UNIFORM),
                square(hemisphere::cosine_pdf(cosine)),
            ]
        })
        .map(Rgb::channels);
        for (i, name) in ["red", "green", "blue"].into_iter().enumerate() {
            let variance = (uniform[i].max(cosine[i]) - exact[i] * exact[i]).max(0.0);
            let scatter = (variance / q.samples as f32).sqrt();
            let tolerance = DEVIATIONS * scatter + 2.0 * judge::RELATIVE * exact[i];
            judge::number_within(name, "W·m⁻²·sr⁻¹", exact[i], got.channels()[i], tolerance)
                .map_err(|why| format!("{why}: more than chance explains"))?;
        }
        Ok(())
    }
}
