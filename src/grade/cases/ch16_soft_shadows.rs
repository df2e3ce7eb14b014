//! Chapter 16: `sample_rect`, `sample_sphere_light`, `visible_fraction`.
//!
//! Samples are judged by their distribution: any right way to spread them passes. An 8 × 8 lattice that is spread by a
//! concentric disc has a mean that is 0.016 off and a variance that is 0.010 off; other right ways are closer. A disc inside a
//! square has a variance that is 0.021 off.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Verdict, judge, sample};
use crate::math::{basis::Basis, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::shape::{Shape, sphere::Sphere};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch16_soft_shadows::{
    Ball, Chosen, SampleRect, SampleRectQuestion, SampleSphereLight, SampleSphereLightQuestion,
    VisibleFraction, VisibleFractionQuestion,
};
use glam::{DVec2, Vec2, Vec3, dvec2, vec2, vec3};
use rand::RngExt;
use std::f32::consts::{PI, TAU};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&SampleRect, &SampleSphereLight, &VisibleFraction];

/// So fine are the lattices.
const N: u32 = 8;

/// A density may be off by this share: naive formulas lose a few digits.
const DENSITY: f32 = 5e-3;

/// The middles of the cells of an n × n lattice.
fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |k| (vec2((k % n) as f32, (k / n) as f32) + 0.5) / n as f32)
}

/// Whether places in the unit square are spread evenly, as their means, their variances and their counts tell.
fn evenly(what: &str, places: &[DVec2]) -> Verdict {
    let n = places.len() as f64;
    let mean = places.iter().sum::<DVec2>() / n;
    let off = |p: &DVec2| *p - mean;
    let variance = places.iter().map(|p| off(p) * off(p)).sum::<DVec2>() / n;
    let covariance = places.iter().map(|p| off(p).element_product()).sum::<f64>() / n;
    if (mean - 0.5).abs().max_element() > 0.08 {
        return Err(format!(
            "{what} are not uniform: their mean is {:.2} of the way across and {:.2} of the way along",
            mean.x, mean.y
        ));
    }
    if (variance - 1.0 / 12.0).abs().max_element() > 0.015 || covariance.abs() > 0.015 {
        return Err(format!(
            "{what} are not uniform: they are too close together, or too far apart, or on a line"
        ));
    }
    let mut quarters = [0; 4];
    for p in places {
        quarters[usize::from(p.x > 0.5) + 2 * usize::from(p.y > 0.5)] += 1;
    }
    let expected = places.len() / 4;
    if quarters
        .iter()
        .any(|count| !(expected / 2..=2 * expected).contains(count))
    {
        return Err(format!(
            "{what} are not uniform: of four equal parts, one has {} and another {}, and not about {expected} each",
            quarters.iter().min().unwrap_or(&0),
            quarters.iter().max().unwrap_or(&0),
        ));
    }
    Ok(())
}

/// The number of samples, and what each says of itself.
fn each(n: u32, radiance: f32, got: &[Chosen], check: impl Fn(&Chosen) -> Verdict) -> Verdict {
    if got.len() != (n * n) as usize {
        return Err(format!(
            "there are {} samples, and should be {}",
            got.len(),
            n * n
        ));
    }
    for (i, chosen) in got.iter().enumerate() {
        let sample = || {
            judge::direction(
                "the direction",
                chosen.toward.normalize_or_zero(),
                chosen.toward,
            )?;
            check(chosen)?;
            let arriving = radiance / chosen.pdf;
            let tolerance = DENSITY * arriving.abs();
            judge::number_within("radiance/density", "", arriving, chosen.arriving, tolerance)
        };
        sample().map_err(|why| format!("sample {i}: {why}"))?;
    }
    Ok(())
}

impl Graded for SampleRect {
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
            name: "forgets the distance",
            hint: "Twice as far away, how much smaller does the light look?",
            answer: |q| spoil_rect(q, |_, chosen| chosen.pdf / chosen.distance.powi(2)),
        },
        Mistake {
            name: "does not square the distance",
            hint: "Twice as far away, how much smaller does the light look?",
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
            answer: |q| {
                let front = SampleRectQuestion {
                    corner: q.corner + q.a,
                    a: -q.a,
                    ..q.clone()
                };
                SampleRect::answer(q).or_else(|| SampleRect::answer(&front))
            },
        },
        Mistake {
            name: "takes the corner for the middle",
            hint: "Which points do u = (0, 0) and u = (1, 1) belong to?",
            answer: |q| {
                SampleRect::answer(&SampleRectQuestion {
                    corner: q.corner - 0.5 * (q.a + q.b),
                    ..q.clone()
                })
            },
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
                SampleRect::answer(q).map(|mut all| {
                    for chosen in &mut all {
                        chosen.arriving = q.radiance;
                    }
                    all
                })
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, at, corner, a, b| {
            Edge::new(
                name,
                SampleRectQuestion {
                    at,
                    corner,
                    a,
                    b,
                    radiance: 2.0,
                    n: N,
                },
            )
        };
        let above = vec3(-0.5, 2.0, -0.5);
        vec![
            edge(
                "a square straight above",
                Vec3::ZERO,
                above,
                Vec3::X,
                Vec3::Z,
            ),
            edge(
                "the square turns its back",
                Vec3::ZERO,
                above,
                Vec3::Z,
                Vec3::X,
            ),
            edge(
                "from within its plane",
                vec3(3.0, 2.0, 0.0),
                above,
                Vec3::X,
                Vec3::Z,
            ),
            edge(
                "a long rectangle, seen from the side",
                vec3(4.0, 1.5, 0.0),
                above,
                Vec3::X,
                4.0 * Vec3::Z,
            ),
            edge("very close", vec3(0.0, 1.9, 0.0), above, Vec3::X, Vec3::Z),
            edge(
                "far away",
                vec3(10.0, -300.0, 20.0),
                above,
                Vec3::X,
                Vec3::Z,
            ),
            edge(
                "a tiny one",
                Vec3::ZERO,
                vec3(0.25, 1.0, 0.5),
                0.007_812_5 * Vec3::X,
                0.015_625 * Vec3::Z,
            ),
            edge(
                "askew",
                vec3(-0.4, -0.3, 0.2),
                vec3(1.0, 1.0, 1.0),
                vec3(2.0, -1.0, 0.0),
                vec3(1.0, 2.0, -0.5),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> SampleRectQuestion {
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
        SampleRectQuestion {
            at: corner + place.x * a + place.y * b + side * before * *basis.z,
            corner,
            a,
            b,
            radiance: sample::number(rng, 0.5, 5.0),
            n: N,
        }
    }

    fn judge(q: &SampleRectQuestion, golden: &Self::Answer, got: &Self::Answer) -> Verdict {
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
                    return Err("its point is not on the light".to_owned());
                }
                let cosine = -chosen.toward.dot(q.a.cross(q.b).normalize_or_zero());
                let pdf = chosen.distance.powi(2) / (area(q) * cosine);
                judge::number_within("the density", "/sr", pdf, chosen.pdf, DENSITY * pdf)
            })?;
            let places: Vec<_> = got.iter().map(|c| place(c).as_dvec2()).collect();
            evenly("the points", &places)
        })
    }
}

fn area(q: &SampleRectQuestion) -> f32 {
    q.a.length() * q.b.length()
}

/// The right answer with another density, of the cosine at the light and the right choice.
fn spoil_rect(q: &SampleRectQuestion, pdf: impl Fn(f32, &Chosen) -> f32) -> Option<Vec<Chosen>> {
    let mut all = SampleRect::answer(q)?;
    for chosen in &mut all {
        let cosine = -chosen.toward.dot(q.a.cross(q.b).normalize_or_zero());
        chosen.pdf = pdf(cosine, chosen);
        chosen.arriving = q.radiance / chosen.pdf;
    }
    Some(all)
}

/// Other points of the light, with the right density of uniform ones.
fn chosen_rect(q: &SampleRectQuestion, place: fn(Vec2) -> Vec2) -> Option<Vec<Chosen>> {
    SampleRect::answer(q)?;
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

impl Graded for SampleSphereLight {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "makes θ uniform in the place of cos θ",
            hint: "A ring around the cone's axis has the more directions the wider it is: do your samples crowd the middle?",
            answer: |q| {
                cone(q, |u, cap| {
                    let angle = (1.0 - cap).clamp(-1.0, 1.0).acos();
                    (1.0 - (u.x * angle).cos(), TAU * u.y, 1.0 / (TAU * cap))
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
            name: "goes half way round only",
            hint: "Look along the axis of the cone: on which sides of it are your samples?",
            answer: |q| cone(q, |u, cap| (u.x * cap, PI * u.y, 1.0 / (TAU * cap))),
        },
        Mistake {
            name: "lets 1 − cos α cancel",
            hint: "For a small, distant light cos α is 1 in 32 bits: write 1 − cos α with sin²α.",
            answer: |q| {
                let squared = (q.radius / q.at.distance(q.center)).powi(2);
                let cap = 1.0 - (1.0 - squared).max(0.0).sqrt();
                let cap = if squared < 1.0 { cap } else { 2.0 };
                cone(q, |u, _| (u.x * cap, TAU * u.y, 1.0 / (TAU * cap)))
            },
        },
        Mistake {
            name: "returns the far side of the sphere",
            hint: "Which of the two points where the line meets the sphere is seen?",
            answer: |q| {
                let mut all = SampleSphereLight::answer(q);
                for chosen in &mut all {
                    let middle = (q.center - q.at).dot(chosen.toward);
                    chosen.distance = middle + (middle - chosen.distance).abs();
                }
                all
            },
        },
        Mistake {
            name: "returns the distance of the centre",
            hint: "The light's surface is nearer than its centre.",
            answer: |q| {
                let mut all = SampleSphereLight::answer(q);
                let distance = q.at.distance(q.center);
                for chosen in &mut all {
                    chosen.distance = distance;
                }
                all
            },
        },
        Mistake {
            name: "sees only half of a sphere from inside",
            hint: "Inside the light, from which directions does no light come?",
            answer: |q| {
                let inside = q.at.distance(q.center) <= q.radius;
                cone(q, |u, cap| {
                    let cap = if inside { 1.0 } else { cap };
                    (u.x * cap, TAU * u.y, 1.0 / (TAU * cap))
                })
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, at, center, radius| {
            Edge::new(
                name,
                SampleSphereLightQuestion {
                    at,
                    center,
                    radius,
                    radiance: 2.0,
                    n: N,
                },
            )
        };
        vec![
            edge("straight above", Vec3::ZERO, 3.0 * Vec3::Y, 1.0),
            edge("straight below", Vec3::ZERO, -2.0 * Vec3::Y, 0.5),
            edge(
                "along z, against it",
                vec3(1.0, 0.0, 5.0),
                vec3(1.0, 0.0, 0.0),
                2.0,
            ),
            edge(
                "so close that it fills half the view",
                Vec3::ZERO,
                1.03125 * Vec3::X,
                1.0,
            ),
            edge(
                "small and far away",
                vec3(-60.0, 0.0, 80.0),
                Vec3::ZERO,
                0.0625,
            ),
            edge("from inside", vec3(0.25, 0.5, 0.0), Vec3::ZERO, 1.0),
            edge(
                "from its centre",
                vec3(1.0, 2.0, 3.0),
                vec3(1.0, 2.0, 3.0),
                2.0,
            ),
            edge("askew", vec3(1.0, -2.0, 0.5), vec3(-1.0, 1.0, 2.0), 1.5),
        ]
    }

    fn random(rng: &mut Pcg) -> SampleSphereLightQuestion {
        let (center, radius) = (sample::point(rng, 3.0), sample::number(rng, 0.3, 2.0));
        let away = match rng.random_range(0..8) {
            0 | 1 => sample::number(rng, 0.1, 0.9),
            2 => sample::number(rng, 500.0, 2000.0),
            _ => sample::number(rng, 1.2, 6.0),
        };
        SampleSphereLightQuestion {
            at: center + away * radius * *sample::direction(rng),
            center,
            radius,
            radiance: sample::number(rng, 0.5, 5.0),
            n: N,
        }
    }

    fn judge(q: &SampleSphereLightQuestion, _: &Self::Answer, got: &Self::Answer) -> Verdict {
        let (d, inside) = (q.at.distance(q.center), q.at.distance(q.center) <= q.radius);
        let cap = f64::from(cap(q));
        let axis = Dir3::new_or(q.center - q.at, Dir3::Y);
        // 1 − cos θ by the chord, which keeps its digits in a narrow cone.
        let height = |c: &Chosen| 0.5 * c.toward.as_dvec3().distance_squared(axis.as_dvec3());
        let pdf = (1.0 / (f64::from(TAU) * cap)) as f32;
        each(q.n, q.radiance, got, |chosen| {
            if height(chosen) > cap * 1.01 + 1e-6 {
                return Err("its direction misses the light".to_owned());
            }
            let point = q.at + chosen.distance * chosen.toward;
            let off = (point.distance(q.center) - q.radius).abs();
            let middle = (q.center - q.at).dot(chosen.toward);
            // Next to the rim the near side and the far side are close to each other.
            let margin = 0.02 * q.radius + judge::RELATIVE * d;
            let seen = if inside {
                chosen.distance >= middle - margin
            } else {
                chosen.distance <= middle + margin
            };
            // As `<=`, so that a NaN is off.
            let on_it = off <= margin && seen;
            if !on_it {
                return Err(format!(
                    "at a distance of {:.4} m, there is no point of the light that is seen",
                    chosen.distance
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
        evenly("the directions", &places)
    }
}

/// 1 − cos α of the cone in which the light is seen.
fn cap(q: &SampleSphereLightQuestion) -> f32 {
    let squared = (q.radius / q.at.distance(q.center)).powi(2);
    if squared < 1.0 {
        squared / (1.0 + (1.0 - squared).sqrt())
    } else {
        2.0
    }
}

/// Directions by 1 − cos θ and φ, with a density, from u and 1 − cos α.
fn cone(
    q: &SampleSphereLightQuestion,
    choose: impl Fn(Vec2, f32) -> (f32, f32, f32),
) -> Vec<Chosen> {
    let axis = Dir3::new_or(q.center - q.at, Dir3::Y);
    let (basis, cap) = (Basis::around(axis), cap(q));
    let light = Sphere::new(q.center, q.radius);
    let chosen = |u: Vec2| {
        let (height, phi, pdf) = choose(u, cap);
        let sine = (height * (2.0 - height)).max(0.0).sqrt();
        let toward = vec3(sine * phi.cos(), sine * phi.sin(), 1.0 - height);
        let toward = Dir3::new_or(basis.to_world(toward), axis);
        let hit = light.hit(&Ray::new(q.at, toward), Interval::AHEAD);
        let distance = hit.map_or(q.at.distance(q.center), |hit| hit.t);
        Chosen {
            toward: *toward,
            distance,
            pdf,
            arriving: q.radiance / pdf,
        }
    };
    lattice(q.n).map(chosen).collect()
}

/// How many samples are asked for.
const SAMPLES: u32 = 1024;

impl Graded for VisibleFraction {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "asks for the middle of the light only",
            hint: "What is the width of your penumbra?",
            answer: |q| seen(q, 1, |u| u, 1.0),
        },
        Mistake {
            name: "returns the fraction that is in the dark",
            hint: "How much of the light is seen where nothing is in the way?",
            answer: |q| VisibleFraction::answer(q).iter().map(|f| 1.0 - f).collect(),
        },
        Mistake {
            name: "lets the shadow ray go on behind the light",
            hint: "A ball behind the light throws no shadow: where does your ray end?",
            answer: |q| seen(q, 16, |u| u, f32::INFINITY),
        },
        Mistake {
            name: "asks for one quarter of the light only",
            hint: "Which points of the light do the numbers from 0 to 1 reach?",
            answer: |q| seen(q, 16, |u| 0.5 * u, 1.0),
        },
        Mistake {
            name: "asks for one diagonal of the light only",
            hint: "Does each sample have two random numbers of its own?",
            answer: |q| seen(q, 16, |u| Vec2::splat(u.x), 1.0),
        },
        Mistake {
            name: "asks for the four corners only",
            hint: "In the penumbra, how many different fractions do you get?",
            answer: |q| seen(q, 2, |u| 2.0 * u - 0.5, 1.0),
        },
        Mistake {
            name: "calls every penumbra shadow",
            hint: "Something in the way of one sample is not in the way of all.",
            answer: |q| {
                let all = VisibleFraction::answer(q);
                all.iter()
                    .map(|f| if *f < 1.0 { 0.0 } else { 1.0 })
                    .collect()
            },
        },
        Mistake {
            name: "lets a light shine backwards",
            hint: "Where does a × b point, and on which side of the light is the point?",
            answer: |q| {
                let turned = VisibleFractionQuestion {
                    corner: q.corner + q.a,
                    a: -q.a,
                    ..q.clone()
                };
                let (front, back) = (VisibleFraction::answer(q), VisibleFraction::answer(&turned));
                front
                    .iter()
                    .zip(back)
                    .map(|(front, back)| front + back)
                    .collect()
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let square = |points: &[Vec3], balls: &[(Vec3, f32)]| VisibleFractionQuestion {
            corner: vec3(-1.0, 4.0, -1.0),
            a: 2.0 * Vec3::X,
            b: 2.0 * Vec3::Z,
            points: points.to_vec(),
            balls: balls
                .iter()
                .map(|&(center, radius)| Ball { center, radius })
                .collect(),
            samples: SAMPLES,
        };
        let row = [0.0, 0.5, 1.0, 2.0].map(|x| vec3(x, 0.0, 0.0));
        vec![
            Edge::new("nothing in the way", square(&row, &[])),
            Edge::new(
                "from the umbra to full light",
                square(&row, &[(vec3(0.0, 1.0, 0.0), 0.5)]),
            ),
            Edge::new(
                "a ball too small for an umbra",
                square(&row, &[(vec3(0.0, 3.0, 0.0), 0.5)]),
            ),
            Edge::new(
                "a ball that hides the middle of the light",
                square(
                    &[Vec3::ZERO, 0.25 * Vec3::Z],
                    &[(vec3(0.0, 2.0, 0.0), 0.25)],
                ),
            ),
            Edge::new(
                "a ball behind the light",
                square(&row, &[(vec3(0.0, 6.0, 0.0), 1.5)]),
            ),
            Edge::new(
                "a ball below the points",
                square(&row, &[(vec3(0.0, -2.0, 0.0), 1.5)]),
            ),
            Edge::new(
                "points behind the light",
                square(&[vec3(0.0, 5.0, 0.0), vec3(1.0, 7.0, 0.5), Vec3::ZERO], &[]),
            ),
            Edge::new(
                "two balls, whose shadows overlap",
                square(
                    &row,
                    &[(vec3(0.25, 2.0, 0.0), 0.5), (vec3(0.5, 1.0, 0.25), 0.25)],
                ),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> VisibleFractionQuestion {
        let [width, depth] = [(); 2].map(|()| sample::number(rng, 1.0, 3.0));
        let height = sample::number(rng, 3.0, 5.0);
        let balls = (0..3).map(|i| Ball {
            center: vec3(
                sample::number(rng, -1.0, 1.0),
                // The third is above the light, where it is in nobody's way.
                if i == 2 {
                    height + 1.5
                } else {
                    sample::number(rng, 0.9, 0.7 * height)
                },
                sample::number(rng, -1.0, 1.0),
            ),
            radius: sample::number(rng, 0.3, 0.8),
        });
        let balls = balls.collect();
        let on_floor = |_| {
            let p = sample::point(rng, 1.8);
            vec3(p.x, 0.0, p.z)
        };
        let points = (0..4).map(on_floor).collect();
        VisibleFractionQuestion {
            corner: vec3(-0.5 * width, height, -0.5 * depth),
            a: width * Vec3::X,
            b: depth * Vec3::Z,
            points,
            balls,
            samples: SAMPLES,
        }
    }

    /// By Bernstein's inequality, the mean of n samples that are 0 or 1 is off by more than √(2 f(1 − f) L/n) + 2L/(3n)
    /// with a probability below 2 e^(−L): with L = 21 once in 10⁹ points, in a class of 500 less than once in 10⁴ times.
    fn judge(q: &VisibleFractionQuestion, _golden: &Vec<f32>, got: &Vec<f32>) -> Verdict {
        const L: f32 = 21.0;
        /// What the lattice that stands for the exact value may be off.
        const LATTICE: f32 = 0.01;
        if got.len() != q.points.len() {
            return Err(format!(
                "there are {} fractions, and should be {}, one per point",
                got.len(),
                q.points.len()
            ));
        }
        let exact = exact(q);
        for (i, (&f, &got)) in exact.iter().zip(got).enumerate() {
            let n = q.samples as f32;
            let bound = (2.0 * f * (1.0 - f) * L / n).sqrt() + 2.0 * L / (3.0 * n) + LATTICE;
            judge::number_within(&format!("the fraction of point {i}"), "", f, got, bound)?;
        }
        Ok(())
    }
}

/// The fractions, by a lattice fine enough to stand for the exact value.
fn exact(q: &VisibleFractionQuestion) -> Vec<f32> {
    seen(q, 32, |u| u, 1.0)
}

/// The fractions by the points of the light to which an n × n lattice is mapped, and by rays that end at so many times the
/// distance of the light.
fn seen(q: &VisibleFractionQuestion, n: u32, place: fn(Vec2) -> Vec2, end: f32) -> Vec<f32> {
    let balls: Vec<_> = q
        .balls
        .iter()
        .map(|b| Sphere::new(b.center, b.radius))
        .collect();
    let arrives = |from: Vec3, u: Vec2| {
        let r = q.corner + u.x * q.a + u.y * q.b - from;
        let way = Interval::new(0.0, end * r.length());
        let free = |ray: &Ray| !balls.iter().any(|ball| ball.blocks(ray, way));
        r.dot(q.a.cross(q.b)) < 0.0 && Dir3::new(r).is_some_and(|d| free(&Ray::new(from, d)))
    };
    let fraction = |&p: &Vec3| {
        let count = lattice(n).filter(|&u| arrives(p, place(u))).count();
        count as f32 / (n * n) as f32
    };
    q.points.iter().map(fraction).collect()
}
