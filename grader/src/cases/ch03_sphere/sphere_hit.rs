//! `sphere_hit`: random questions, judge and mistakes.

use crate::upon::changed;
use crate::{Graded, Mistake, Picture, Relation, Verdict, judge, sample};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{basis::Basis, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_chapters::kit::palette::viridis;
use raybook_workbook::exercises::ch03_sphere::SphereHit;

impl Graded for SphereHit {
    fn random(rng: &mut Pcg) -> SphereHit {
        let (center, radius) = (sample::point(rng, 3.0), sample::number(rng, 0.5, 2.0));
        // One ray in four starts inside; most aim near the sphere, so that about half of all hit. One in eight nearly touches it.
        let touches = rng.random_bool(0.125);
        let distance = radius
            * if !touches && rng.random_bool(0.25) {
                sample::number(rng, 0.1, 0.9)
            } else {
                sample::number(rng, 1.5, 5.0)
            };
        let toward = sample::direction(rng);
        let origin = center - distance * *toward;
        let (direction, length) = if touches {
            let sine = (1.0 - sample::beside(rng)) * radius / distance;
            let side = Basis::around(toward).x;
            let cosine = (1.0 - sine * sine).sqrt();
            (cosine * *toward + sine * *side, f32::INFINITY)
        } else {
            let aim = center + sample::point(rng, 1.2 * radius);
            (aim - origin, sample::end(rng, 0.3, 0.5, 6.0))
        };
        let ray = sample::ray(origin, direction);
        // One interval in two begins ahead of the ray's origin or behind it, and the sphere may be behind it, too.
        let (ray, min) = if rng.random_bool(0.5) {
            let origin = ray.at(sample::number(rng, 0.0, 8.0));
            let min = sample::number(rng, -6.0, 2.0);
            (Ray::new(origin, ray.direction), min)
        } else {
            (ray, 0.0)
        };
        SphereHit {
            ray,
            within: Interval::new(min, min + length),
            center,
            radius,
        }
    }

    fn judge(q: &SphereHit, golden: &Option<f32>, got: &Option<f32>) -> Verdict {
        judge::option("a hit", golden.as_ref(), got.as_ref(), |golden, got| {
            // Measured by the sphere, not by its distance; but no finer than a few of t's last digits.
            let tolerance = judge::RELATIVE * q.radius + 4.0 * f32::EPSILON * golden.abs();
            judge::number_within("t", "m", *golden, *got, tolerance)
        })
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| SphereHit {
        ray: sample::moved(&q.ray),
        center: q.center + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes the far root",
            hint: "The ray enters the sphere before it leaves it: which of the two does the eye see?",
            answer: |q| hit(q, |how| how.asked = |_, [_, far]| [far; 2]),
        },
        Mistake {
            name: "gives up when the near root does not count",
            hint: "Stand inside the sphere: the near root is behind you, but you still see a wall.",
            answer: |q| hit(q, |how| how.asked = |_, [near, _]| [near; 2]),
        },
        Mistake {
            name: "ignores the interval",
            hint: "Is every t you return between min and max?",
            answer: |q| hit(q, |how| how.counts = |_, _| true),
        },
        Mistake {
            name: "only asks for t > min",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| hit(q, |how| how.counts = |q, t| t > q.within.min),
        },
        Mistake {
            name: "takes the sphere to be at the origin",
            hint: "Move the sphere by one metre: does your answer move with it?",
            answer: |q| Self::misread(q, |q| q.center = Vec3::ZERO),
        },
        Mistake {
            name: "forgets to square the radius",
            hint: "Check the units: what do you subtract from a squared length?",
            answer: |q| Self::misread(q, |q| q.radius = q.radius.sqrt()),
        },
        Mistake {
            name: "skips the first millimetre",
            hint: "You may have learnt to ignore small t against self-intersection; the interval you are given already says where hits begin to count.",
            answer: |q| Self::misread(q, |q| q.within.min = q.within.min.max(1e-3)),
        },
        Mistake {
            name: "computes b² − 4ac from far away",
            hint: "From a thousand radii away, |o − c|² and r² differ in size by a million: what is left of r² after the subtraction? Could you move the ray's start closer first?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| {
                        let (d, from) = (*q.ray.direction, q.ray.origin - q.center);
                        let c = from.length_squared() - q.radius * q.radius;
                        solved(2.0 * from.dot(d), c)
                    };
                })
            },
        },
        Mistake {
            name: "forgets to divide by 2",
            hint: "Put your t into o + t·d: is that point on the sphere?",
            answer: |q| hit(q, |how| how.roots = |q| Some(roots(q)?.map(|t| 2.0 * t))),
        },
        Mistake {
            name: "returns the distance of the point nearest to the centre",
            hint: "There the ray is deep inside the sphere: how far before that point is the surface?",
            answer: |q| {
                hit(q, |how| {
                    how.asked = |_, [near, far]| [0.5 * (near + far); 2];
                })
            },
        },
        Mistake {
            name: "returns the far root unchecked where the near root does not count",
            hint: "The whole sphere may lie before the interval, or behind it: is the far root between min and max then?",
            answer: |q| {
                hit(q, |how| {
                    how.asked =
                        |q, [near, far]| [if q.within.contains(near) { near } else { far }; 2];
                    how.counts = |_, _| true;
                })
            },
        },
        Mistake {
            name: "calls every sphere a miss whose centre is behind the origin",
            hint: "Stand in a large sphere with your back to its centre: do you see a wall?",
            answer: |q| {
                let is_ahead = (q.center - q.ray.origin).dot(*q.ray.direction) >= 0.0;
                Self::misread(q, |_| {}).filter(|_| is_ahead)
            },
        },
        Mistake {
            name: "calls every sphere a miss that the ray begins inside of",
            hint: "Stand in a large sphere: do you see its wall, and which of the two roots is it?",
            answer: |q| {
                let is_outside = q.ray.origin.distance(q.center) >= q.radius;
                q.right().filter(|_| is_outside)
            },
        },
        Mistake {
            name: "takes the radius less the centre's distance from the ray for half of the chord",
            hint: "Half of the chord, the radius and the distance of the ray from the centre make a right triangle: which theorem gives the third side?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| {
                        let half = q.radius - beside(q).length();
                        (half >= 0.0).then(|| ends(foot(q), half))
                    };
                })
            },
        },
        Mistake {
            name: "measures t from the point of the ray that is nearest to the centre, and not from its origin",
            hint: "How far is it from the origin to the point nearest to the centre, and where is this number in your t?",
            answer: |q| Self::right(q).map(|t| t - foot(q)),
        },
        Mistake {
            name: "asks only whether the near root is ahead",
            hint: "The near root may lie before the interval although it is ahead: what about the far root then?",
            answer: |q| {
                hit(q, |how| {
                    how.asked = |_, [near, far]| [if near > 0.0 { near } else { far }; 2];
                })
            },
        },
        Mistake {
            name: "takes the square of half the chord for half the chord",
            hint: "What is the unit of the square of half the chord, and of the number that you subtract this square from?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| {
                        let [near, far] = roots(q)?;
                        Some(ends(foot(q), 0.25 * (far - near).powi(2)))
                    };
                })
            },
        },
        Mistake {
            name: "goes from the centre to the origin instead of from the origin to the centre",
            hint: "From where to where does your vector between the origin and the centre point?",
            answer: |q| Self::misread(q, |q| q.ray.direction = -q.ray.direction),
        },
        Mistake {
            name: "goes only a quarter of the chord back and forth from its middle",
            hint: "From the middle of the chord, how far is it to its ends?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| {
                        let [near, far] = roots(q)?;
                        Some(ends(foot(q), 0.25 * (far - near)))
                    };
                })
            },
        },
        Mistake {
            name: "takes the centre's distance from the origin for its distance from the ray",
            hint: "Draw the right triangle in the sphere: which of its sides is the radius, and how near does the ray come to the centre?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| {
                        let distance = q.ray.origin.distance_squared(q.center);
                        chord(foot(q), q.radius * q.radius - distance)
                    };
                })
            },
        },
        Mistake {
            name: "adds the square of the centre's distance from the ray to r² instead of subtracting it",
            hint: "Half of the chord, the radius and the distance of the ray from the centre make a right triangle: which side is the longest?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| {
                        let square = q.radius * q.radius + beside(q).length_squared();
                        chord(foot(q), square)
                    };
                })
            },
        },
        Mistake {
            name: "takes d·m for 2 d·m in the equation, and all else as if the 2 were there",
            hint: "Write (m + t·d)² out: how often does d·m occur in it?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| {
                        let m = q.ray.origin - q.center;
                        solved(-foot(q), m.length_squared() - q.radius * q.radius)
                    };
                })
            },
        },
        Mistake {
            name: "returns the root that is nearest to the origin, ahead of it or behind",
            hint: "A root behind the origin may be nearer than the one that you see: is it between min and max?",
            answer: |q| {
                hit(q, |how| {
                    how.asked = |_, roots| by_size(roots);
                    how.counts = |q, t| t < q.within.max;
                })
            },
        },
        Mistake {
            name: "asks only whether the root that is nearest to the origin counts",
            hint: "The root behind the origin may be the nearer of the two: what about the other one then?",
            answer: |q| hit(q, |how| how.asked = |_, roots| [by_size(roots)[0]; 2]),
        },
        Mistake {
            name: "returns the distance of the hit from the world's origin",
            hint: "From where is t measured: from the ray's origin, or from the world's?",
            answer: |q| q.right().map(|t| q.ray.at(t).length()),
        },
        Mistake {
            name: "returns the far root where both count",
            hint: "The ray enters the sphere before it leaves it: which of the two roots do you ask first?",
            answer: |q| hit(q, |how| how.asked = |_, [near, far]| [far, near]),
        },
        Mistake {
            name: "takes the far root only where the ray begins inside the sphere",
            hint: "The near root may lie before the interval although the ray begins outside: what about the far root then?",
            answer: |q| {
                hit(q, |how| {
                    how.asked = |q, [near, far]| {
                        let is_inside = q.ray.origin.distance(q.center) < q.radius;
                        [if is_inside { far } else { near }; 2]
                    };
                })
            },
        },
        Mistake {
            name: "compares the far root with min only, and not with max",
            hint: "The interval may lie inside the sphere as a whole: is the far root before its end?",
            answer: |q| {
                let [near, far] = roots(q)?;
                if near > q.within.min {
                    Some(near).filter(|t| *t < q.within.max)
                } else {
                    Some(far).filter(|t| *t > q.within.min)
                }
            },
        },
        Mistake {
            name: "returns that of two roots in the interval whose absolute value is the smaller one",
            hint: "The interval may begin behind the origin: which is the smaller of −4 and −2?",
            answer: |q| hit(q, |how| how.asked = |_, roots| by_size(roots)),
        },
        Mistake {
            name: "takes the radius for half of the chord",
            hint: "Is the chord of a ray that passes beside the centre as long as that of a ray through it?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| roots(q).map(|_| ends(foot(q), q.radius));
                })
            },
        },
        Mistake {
            name: "returns the origin's distance from the surface, not the distance along the ray",
            hint: "The nearest point of the sphere need not lie on the ray: where does the ray meet it?",
            answer: |q| {
                q.right()
                    .map(|_| (q.ray.origin.distance(q.center) - q.radius).abs())
            },
        },
        Mistake {
            name: "takes the ray's origin for the middle of the chord where the centre is behind it",
            hint: "Stand inside the sphere with your back to its centre: where is the middle of the chord on the whole line?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| {
                        let middle = foot(q).max(0.0);
                        let beside = q.center - q.ray.at(middle);
                        chord(middle, q.radius * q.radius - beside.length_squared())
                    };
                })
            },
        },
        Mistake {
            name: "calls a sphere a miss whose middle of the chord lies beyond the interval's end",
            hint: "The ray enters the sphere before it reaches the middle of the chord: may the interval end between the two?",
            answer: |q| q.right().filter(|_| foot(q) <= q.within.max),
        },
        Mistake {
            name: "returns the interval's beginning where that lies inside the sphere",
            hint: "Is a sphere solid here, or a surface: where is the next point of the surface?",
            answer: |q| {
                let is_inside = q.ray.at(q.within.min).distance(q.center) < q.radius;
                if is_inside {
                    Some(q.within.min)
                } else {
                    q.right()
                }
            },
        },
        Mistake {
            name: "forgets to square the centre's distance from the ray",
            hint: "Check the units: what do you subtract from a squared length?",
            answer: |q| {
                hit(q, |how| {
                    how.roots = |q| chord(foot(q), q.radius * q.radius - beside(q).length());
                })
            },
        },
        Mistake {
            name: "calls a sphere a miss that the ray only grazes",
            hint: "How small must the number under the root be, for there to be no root?",
            answer: |q| {
                hit(q, |how| {
                    how.roots =
                        |q| roots(q).filter(|[near, far]| 0.25 * (far - near).powi(2) > 1e-3);
                })
            },
        },
        Mistake {
            name: "calls a sphere a miss whose middle of the chord lies before the interval's beginning",
            hint: "The ray leaves the sphere behind the middle of the chord: may the interval begin between the two?",
            answer: |q| q.right().filter(|_| foot(q) >= q.within.min),
        },
        Mistake {
            name: "calls a sphere a miss whose middle of the chord is not in the interval",
            hint: "The ends of the chord lie before and behind its middle: may one of them be in the interval without the middle?",
            answer: |q| q.right().filter(|_| q.within.contains(foot(q))),
        },
        Mistake {
            name: "takes 0 for within.min, wherever the interval begins",
            hint: "The interval says where hits begin to count: is that always at the ray's origin?",
            answer: |q| Self::misread(q, |q| q.within.min = 0.0),
        },
        Mistake {
            name: "takes 0 for within.min where the interval begins behind the origin",
            hint: "An interval may begin behind the origin: is what lies there in it?",
            answer: |q| Self::misread(q, |q| q.within.min = q.within.min.max(0.0)),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "sphere_hit",
        width: 96,
        height: 54,
        alt: "A sphere; the brighter, the nearer",
        question: |x, y| {
            let toward = sample::pixel(x, y);
            let ray = sample::ray(vec3(0.0, 0.0, 3.0), toward);
            SphereHit {
                ray,
                within: Interval::AHEAD,
                center: vec3(0.2, 0.1, 0.0),
                radius: 1.0,
            }
        },
        colour: |_, t| t.map_or(Rgb::gray(0.1), |t| viridis(1.0 - (t - 2.0) / 2.0)),
    }];
}

/// The distance at which the whole line is nearest to the centre: the middle of the chord.
fn foot(q: &SphereHit) -> f32 {
    (q.center - q.ray.origin).dot(*q.ray.direction)
}

/// From there to the centre.
fn beside(q: &SphereHit) -> Vec3 {
    q.center - q.ray.at(foot(q))
}

/// How a hit is found; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// Where the whole line meets the sphere: the near root, and the far one.
    roots: fn(&SphereHit) -> Option<[f32; 2]>,
    /// The roots that are asked whether they count, in their order.
    asked: fn(&SphereHit, [f32; 2]) -> [f32; 2],
    /// Whether a root counts.
    counts: fn(&SphereHit, f32) -> bool,
}

/// As it should be.
const WELL: How = How {
    roots,
    asked: |_, roots| roots,
    counts: |q, t| q.within.contains(t),
};

/// The hit, found rightly but for what is changed.
fn hit(q: &SphereHit, change: fn(&mut How)) -> Option<f32> {
    let how = changed(WELL, change);
    let asked = (how.asked)(q, (how.roots)(q)?);
    asked.into_iter().find(|t| (how.counts)(q, *t))
}

/// Both distances at which the whole line meets the sphere.
fn roots(q: &SphereHit) -> Option<[f32; 2]> {
    let (direction, way) = (
        q.ray.direction.as_dvec3(),
        q.center.as_dvec3() - q.ray.origin.as_dvec3(),
    );
    let middle = way.dot(direction);
    let beside = way - middle * direction;
    let square = f64::from(q.radius).powi(2) - beside.length_squared();
    let half = (square >= 0.0).then(|| square.sqrt())?;
    Some([(middle - half) as f32, (middle + half) as f32])
}

/// The roots of t² + bt + c.
fn solved(b: f32, c: f32) -> Option<[f32; 2]> {
    let square = b * b - 4.0 * c;
    chord(-0.5 * b, 0.25 * square)
}

/// The ends of a chord around its middle; `square` is the square of half of it.
fn chord(middle: f32, square: f32) -> Option<[f32; 2]> {
    (square >= 0.0).then(|| ends(middle, square.sqrt()))
}

/// The same of half a chord.
fn ends(middle: f32, half: f32) -> [f32; 2] {
    [middle - half, middle + half]
}

/// The roots by their absolute values, the least first.
fn by_size([one, other]: [f32; 2]) -> [f32; 2] {
    if one.abs() <= other.abs() {
        [one, other]
    } else {
        [other, one]
    }
}
