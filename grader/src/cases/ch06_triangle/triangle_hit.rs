//! `triangle_hit`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Picture, Relation, Verdict, judge, sample};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch06_triangle::{TriangleHit, TriangleHitAnswer};

impl Graded for TriangleHit {
    fn random(rng: &mut Pcg) -> TriangleHit {
        let [p0, p1, p2] = std::array::from_fn(|_| sample::point(rng, 3.0));
        // One ray in eight passes close to an edge, on either side of it.
        let aim = if rng.random_bool(0.125) {
            let gap = sample::beside(rng);
            let along = sample::number(rng, 0.1, 0.9);
            let mut corners = [p0, p1, p2];
            corners.rotate_left(rng.random_range(0..3));
            let [from, to, opposite] = corners;
            from.lerp(to, along).lerp(opposite, gap)
        } else {
            let b1 = sample::number(rng, -0.3, 0.8);
            let b2 = sample::number(rng, -0.3, 0.8);
            p0 + b1 * (p1 - p0) + b2 * (p2 - p0)
        };
        // One interval in two begins ahead of the ray's origin or behind it, and the triangle may be behind it, too.
        let (distance, min) = if rng.random_bool(0.5) {
            (
                sample::number(rng, -5.0, 6.0),
                sample::number(rng, -6.0, 2.0),
            )
        } else {
            (sample::number(rng, 1.0, 6.0), 0.0)
        };
        let direction = sample::direction(rng);
        let max = min + sample::end(rng, 0.2, 1.0, 5.0);
        TriangleHit {
            ray: Ray::new(aim - distance * *direction, direction),
            within: Interval::new(min, max),
            p0,
            p1,
            p2,
        }
    }

    fn is_sound(q: &TriangleHit) -> bool {
        sample::is_triangle([q.p0, q.p1, q.p2])
    }

    fn judge(
        _q: &TriangleHit,
        golden: &Option<TriangleHitAnswer>,
        got: &Option<TriangleHitAnswer>,
    ) -> Verdict {
        judge::option("a hit", golden.as_ref(), got.as_ref(), |golden, got| {
            judge::number("t", "m", golden.t, got.t)?;
            judge::number("b1", "", golden.b1, got.b1)?;
            judge::number("b2", "", golden.b2, got.b2)
        })
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| TriangleHit {
        ray: sample::moved(&q.ray),
        p0: q.p0 + sample::METRE,
        p1: q.p1 + sample::METRE,
        p2: q.p2 + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets b1 + b2 <= 1",
            hint: "Which shape do b1 >= 0 and b2 >= 0 alone, each at most 1, describe?",
            answer: |q| plane(q, |b1, b2| b1 >= 0.0 && b2 >= 0.0 && b1 <= 1.0 && b2 <= 1.0),
        },
        Mistake {
            name: "accepts negative weights",
            hint: "On which side of an edge is a point whose weight for the opposite corner is negative?",
            answer: |q| plane(q, |b1, b2| b1 + b2 <= 1.0),
        },
        Mistake {
            name: "hits the whole plane",
            hint: "The plane is found; is the point inside the triangle?",
            answer: |q| plane(q, |_, _| true),
        },
        Mistake {
            name: "sees the front only",
            hint: "Walk around the triangle: it has two sides.",
            answer: |q| TriangleHit::right(q).filter(|_| normal(q).dot(*q.ray.direction) < 0.0),
        },
        Mistake {
            name: "sees the back only",
            hint: "What is the sign of the determinant for the side you look at?",
            answer: |q| TriangleHit::right(q).filter(|_| normal(q).dot(*q.ray.direction) > 0.0),
        },
        Mistake {
            name: "swaps b1 and b2",
            hint: "At the second corner, which of the two weights is 1?",
            answer: |q| {
                TriangleHit::right(q).map(|hit| TriangleHitAnswer {
                    b1: hit.b2,
                    b2: hit.b1,
                    ..hit
                })
            },
        },
        Mistake {
            name: "returns the weights of the first and the second corner for b1 and b2",
            hint: "The three weights add up to 1; which two are b1 and b2?",
            answer: |q| {
                TriangleHit::right(q).map(|hit| TriangleHitAnswer {
                    b1: 1.0 - hit.b1 - hit.b2,
                    b2: hit.b1,
                    ..hit
                })
            },
        },
        Mistake {
            name: "ignores the interval",
            hint: "Is every t you return between min and max?",
            answer: |q| Self::misread(q, |q| q.within = sample::LINE),
        },
        Mistake {
            name: "forgets to divide the weights by the determinant",
            hint: "Make the triangle twice as large: the weights must not change.",
            answer: |q| {
                let determinant = -normal(q).dot(*q.ray.direction);
                TriangleHit::right(q).map(|hit| TriangleHitAnswer {
                    b1: hit.b1 * determinant,
                    b2: hit.b2 * determinant,
                    ..hit
                })
            },
        },
        Mistake {
            name: "takes a small triangle for one without area",
            hint: "A determinant is a volume: how small is it for a triangle of a millimetre?",
            answer: |q| {
                TriangleHit::right(q).filter(|_| normal(q).dot(*q.ray.direction).abs() > 1e-4)
            },
        },
        Mistake {
            name: "takes |t| for the distance t",
            hint: "What if the triangle is behind the origin?",
            answer: |q| {
                let hit = Self::misread(q, |q| q.within = sample::LINE)?;
                let t = hit.t.abs();
                q.within
                    .contains(t)
                    .then_some(TriangleHitAnswer { t, ..hit })
            },
        },
        Mistake {
            name: "takes the way to the first corner for the distance",
            hint: "The plane is met where its normal n has n·p = n·p0: which part of the way to p0 is along the ray?",
            answer: |q| {
                let t = (q.p0 - q.ray.origin).dot(*q.ray.direction);
                TriangleHit::right(q).map(|hit| TriangleHitAnswer { t, ..hit })
            },
        },
        Mistake {
            name: "returns the distance of the hit from the world's origin",
            hint: "From where is t measured: from the ray's origin, or from the world's?",
            answer: |q| {
                TriangleHit::right(q).map(|hit| TriangleHitAnswer {
                    t: q.ray.at(hit.t).length(),
                    ..hit
                })
            },
        },
        Mistake {
            name: "finds the weights in the projection on the xy plane, and misses a triangle that is perpendicular to it",
            hint: "Stand the triangle upright: how large is its projection on the xy plane? On which of the three planes is it largest?",
            answer: |q| TriangleHit::right(q).filter(|_| normal(q).z != 0.0),
        },
        Mistake {
            name: "takes areas without a sign for the weights, and divides them by their sum",
            hint: "The length of a cross product is never negative: what tells you on which side of an edge a point is?",
            answer: |q| {
                plane(q, |_, _| true).map(|hit| {
                    let weights = [1.0 - hit.b1 - hit.b2, hit.b1, hit.b2];
                    let [b0, b1, b2] = weights.map(f32::abs);
                    let sum = b0 + b1 + b2;
                    TriangleHitAnswer {
                        b1: b1 / sum,
                        b2: b2 / sum,
                        ..hit
                    }
                })
            },
        },
        Mistake {
            name: "clamps the weights to the range from 0 to 1, instead of missing",
            hint: "What does a negative weight say about the point: may it be mended?",
            answer: |q| {
                plane(q, |_, _| true).map(|hit| TriangleHitAnswer {
                    b1: hit.b1.clamp(0.0, 1.0),
                    b2: hit.b2.clamp(0.0, 1.0),
                    ..hit
                })
            },
        },
        Mistake {
            name: "leaves out a margin along the edges, where a weight is small",
            hint: "How small may a weight be for a point inside the triangle?",
            answer: |q| {
                TriangleHit::right(q)
                    .filter(|hit| hit.b1.min(hit.b2).min(1.0 - hit.b1 - hit.b2) > 1e-3)
            },
        },
        Mistake {
            name: "accepts points a little beyond the edges",
            hint: "How far below 0 may a weight be, and how far beyond the edge is that?",
            answer: |q| plane(q, |b1, b2| b1.min(b2).min(1.0 - b1 - b2) >= -1e-3),
        },
        Mistake {
            name: "returns the origin's distance from the plane, not the distance along the ray",
            hint: "Does a slanted ray go as far to the plane as a ray along the normal?",
            answer: |q| {
                let height = normal(q).normalize_or_zero().dot(q.p0 - q.ray.origin).abs();
                TriangleHit::right(q).map(|hit| TriangleHitAnswer { t: height, ..hit })
            },
        },
        Mistake {
            name: "finds the weights in the projection on the zx plane, and misses a triangle that is perpendicular to it",
            hint: "Stand the triangle upright: how large is its projection on the floor? On which of the three planes is it largest?",
            answer: |q| TriangleHit::right(q).filter(|_| normal(q).y != 0.0),
        },
        Mistake {
            name: "finds the weights in the projection on the yz plane, and misses a triangle that is perpendicular to it",
            hint: "Lay the triangle on the floor: how large is its projection on the yz plane? On which of the three planes is it largest?",
            answer: |q| TriangleHit::right(q).filter(|_| normal(q).x != 0.0),
        },
        Mistake {
            name: "asks whether the point is in the triangle's bounding box, not in the triangle",
            hint: "The plane and the box are hit: how much of the part of the plane in the box does the triangle fill?",
            answer: |q| {
                let (min, max) = (q.p0.min(q.p1).min(q.p2), q.p0.max(q.p1).max(q.p2));
                plane(q, |_, _| true).filter(|hit| {
                    let p = q.ray.at(hit.t);
                    p.cmpge(min - 1e-5).all() && p.cmple(max + 1e-5).all()
                })
            },
        },
        Mistake {
            name: "makes the weights half as large",
            hint: "Which weights has the second corner itself, and which has it in your program?",
            answer: |q| {
                plane(q, |b1, b2| b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 2.0).map(|hit| {
                    TriangleHitAnswer {
                        b1: 0.5 * hit.b1,
                        b2: 0.5 * hit.b2,
                        ..hit
                    }
                })
            },
        },
        Mistake {
            name: "projects the point onto each of the two edges by itself for the weights",
            hint: "Where the edges are not perpendicular, what does a step along one of them change in the projection onto the other?",
            answer: |q| {
                let hit = plane(q, |_, _| true)?;
                let from_p0 = q.ray.at(hit.t) - q.p0;
                let [b1, b2] = [q.p1 - q.p0, q.p2 - q.p0]
                    .map(|edge| from_p0.dot(edge) / edge.length_squared());
                let is_inside = b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
                is_inside.then_some(TriangleHitAnswer { b1, b2, ..hit })
            },
        },
        Mistake {
            name: "takes the weights without their signs, as absolute values or as lengths of cross products, and so meets points outside",
            hint: "Beyond an edge one of the weights is negative: what becomes of its sign in your function?",
            answer: |q| {
                let TriangleHitAnswer { t, b1, b2 } =
                    plane(q, |b1, b2| b1.abs() + b2.abs() <= 1.0)?;
                let [b1, b2] = [b1.abs(), b2.abs()];
                Some(TriangleHitAnswer { t, b1, b2 })
            },
        },
        Mistake {
            name: "takes the first weight and b1 without their signs, as absolute values or as lengths of cross products, and what they lack of 1 for b2",
            hint: "Two points lie on both sides of the edge from p0 to p2, and as far from it: how do your weights tell which is inside?",
            answer: |q| {
                let hit = plane(q, |_, _| true)?;
                let (b0, b1) = ((1.0 - hit.b1 - hit.b2).abs(), hit.b1.abs());
                let b2 = 1.0 - b0 - b1;
                (b2 >= 0.0).then_some(TriangleHitAnswer { b1, b2, ..hit })
            },
        },
        Mistake {
            name: "lets the sum of three areas be a hundredth larger than the whole, and so accepts points beyond the edges",
            hint: "Just beside an edge, by how much do the three areas together exceed the triangle's, and how much of that do you take for rounding?",
            answer: |q| plane(q, |b1, b2| areas(b1, b2) <= 1.01),
        },
        Mistake {
            name: "takes the weights without their signs, as absolute values or as lengths of cross products, and lets their sum be a hundredth larger than 1",
            hint: "Just beside an edge, by how much does the sum of your weights exceed 1, and how much of that do you take for rounding?",
            answer: |q| {
                plane(q, |b1, b2| areas(b1, b2) <= 1.01).map(|hit| TriangleHitAnswer {
                    b1: hit.b1.abs(),
                    b2: hit.b2.abs(),
                    ..hit
                })
            },
        },
        Mistake {
            name: "accepts points up to a hundredth beyond the edges",
            hint: "How far below 0 may a weight be, and how far beyond the edge of a triangle of ten metres is that?",
            answer: |q| plane(q, |b1, b2| b1.min(b2).min(1.0 - b1 - b2) >= -1e-2),
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
        name: "triangle_hit",
        width: 96,
        height: 54,
        alt: "A triangle whose colours are the weights of its corners",
        question: |x, y| {
            let toward = sample::pixel(x, y);
            TriangleHit {
                ray: sample::ray(vec3(0.0, 0.0, 3.0), toward),
                within: Interval::AHEAD,
                p0: vec3(-1.7, -1.1, 0.3),
                p1: vec3(1.6, -0.8, -0.5),
                p2: vec3(0.2, 1.2, 0.1),
            }
        },
        colour: |_, hit| {
            hit.as_ref().map_or(Rgb::gray(0.1), |hit| {
                Rgb::new(1.0 - hit.b1 - hit.b2, hit.b1, hit.b2)
            })
        },
    }];
}

/// Twice the triangle's area, as a vector along its normal.
pub(super) fn normal(q: &TriangleHit) -> Vec3 {
    (q.p1 - q.p0).cross(q.p2 - q.p0)
}

/// The areas of the three triangles that a point makes with the edges, without their signs, as a share of the whole.
fn areas(b1: f32, b2: f32) -> f32 {
    (1.0 - b1 - b2).abs() + b1.abs() + b2.abs()
}

/// The hit of the triangle's plane, if the weights there are to one's taste.
fn plane(q: &TriangleHit, inside: fn(f32, f32) -> bool) -> Option<TriangleHitAnswer> {
    let (n, e1, e2) = (normal(q), q.p1 - q.p0, q.p2 - q.p0);
    let t = n.dot(q.p0 - q.ray.origin) / n.dot(*q.ray.direction);
    let from_p0 = q.ray.at(t) - q.p0;
    let (b1, b2) = (
        from_p0.cross(e2).dot(n) / n.length_squared(),
        e1.cross(from_p0).dot(n) / n.length_squared(),
    );
    (inside(b1, b2) && q.within.contains(t)).then_some(TriangleHitAnswer { t, b1, b2 })
}
