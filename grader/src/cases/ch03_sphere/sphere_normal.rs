//! `sphere_normal`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Verdict, judge, sample};
use glam::{Vec2, Vec3};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch03_sphere::SphereNormal;

impl Graded for SphereNormal {
    fn random(rng: &mut Pcg) -> SphereNormal {
        let (center, radius) = (sample::point(rng, 5.0), sample::number(rng, 0.3, 3.0));
        SphereNormal {
            center,
            radius,
            p: center + radius * *sample::direction(rng),
        }
    }

    fn is_sound(q: &SphereNormal) -> bool {
        (q.p.distance(q.center) - q.radius).abs() < 1e-4 * q.radius
    }

    fn judge(_q: &SphereNormal, golden: &Vec3, got: &Vec3) -> Verdict {
        judge::direction("the normal", *golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "points inwards",
            hint: "From the centre to the point, or from the point to the centre?",
            answer: |q| -SphereNormal::right(q),
        },
        Mistake {
            name: "forgets to normalise",
            hint: "How long is the vector from the centre to the point?",
            answer: |q| q.p - q.center,
        },
        Mistake {
            name: "divides by the sum of the components' absolute values, not by the length",
            hint: "How long is the vector (3, 4, 0)?",
            answer: |q| {
                let way = q.p - q.center;
                way / way.abs().element_sum()
            },
        },
        Mistake {
            name: "divides by the greatest of the components' absolute values, not by the length",
            hint: "How long is the vector (3, 4, 0)?",
            answer: |q| {
                let way = q.p - q.center;
                way / way.abs().max_element()
            },
        },
        Mistake {
            name: "takes the sphere to be at the origin",
            hint: "Move the sphere and the point by one metre: the normal must not change.",
            answer: |q| q.p.normalize_or_zero(),
        },
        Mistake {
            name: "divides by the radius squared",
            hint: "A normal has no unit: metres divided by what?",
            answer: |q| (q.p - q.center) / (q.radius * q.radius),
        },
        Mistake {
            name: "multiplies by the radius",
            hint: "Try a sphere of radius 2: how long is your normal?",
            answer: |q| (q.p - q.center) * q.radius,
        },
        Mistake {
            name: "divides the centre only by the radius, as p − c/r",
            hint: "What does your language calculate first in p − c/r?",
            answer: |q| q.p - q.center / q.radius,
        },
        Mistake {
            name: "divides by the point's distance from the world's origin, not from the centre",
            hint: "How long is p − c, and how long is p? By which length must p − c be divided to get the length 1?",
            answer: |q| (q.p - q.center) / q.p.length(),
        },
        Mistake {
            name: "turns the normal away from the world's origin",
            hint: "Move the sphere, and not the world's origin: from which point does a sphere's normal point away?",
            answer: |q| {
                let n = Self::right(q);
                if n.dot(q.p) < 0.0 { -n } else { n }
            },
        },
        Mistake {
            name: "divides the point only by the radius, as p/r − c",
            hint: "What does your language calculate first in p/r − c?",
            answer: |q| q.p / q.radius - q.center,
        },
        Mistake {
            name: "normalises the point and the centre, and then subtracts them",
            hint: "Which vector must have the length 1: the point, the centre, or the way between them?",
            answer: |q| q.p.normalize_or_zero() - q.center.normalize_or_zero(),
        },
        Mistake {
            name: "turns the normal towards the world's origin",
            hint: "Move the sphere, and not the world's origin: does the side change that is outside?",
            answer: |q| {
                let n = Self::right(q);
                if n.dot(q.p) > 0.0 { -n } else { n }
            },
        },
        Mistake {
            name: "turns every normal up",
            hint: "Where does the normal point at the bottom of a ball?",
            answer: |q| {
                let n = Self::right(q);
                if n.y < 0.0 { -n } else { n }
            },
        },
        Mistake {
            name: "takes atan(z/x) for the angle round the y axis, where opposite points have the same quotient",
            hint: "Two opposite points have the same quotient: which of the two does your angle belong to?",
            answer: |q| by_quotient(q, [2, 0], Upright::Well),
        },
        Mistake {
            name: "takes atan(z/x) for the angle round the y axis, where opposite points have the same quotient, and π/2 where x is 0",
            hint: "Two opposite points have the same quotient: which of the two does your angle belong to?",
            answer: |q| by_quotient(q, [2, 0], Upright::FirstHalf),
        },
        Mistake {
            name: "takes atan(z/x) for the angle round the y axis, where opposite points have the same quotient, and is NaN at the poles",
            hint: "Two opposite points have the same quotient: which of the two does your angle belong to? And what is 0/0?",
            answer: |q| by_quotient(q, [2, 0], Upright::NanAtPole),
        },
        Mistake {
            name: "takes atan(x/z) for the angle round the y axis, where opposite points have the same quotient",
            hint: "Two opposite points have the same quotient: which of the two does your angle belong to?",
            answer: |q| by_quotient(q, [0, 2], Upright::Well),
        },
        Mistake {
            name: "takes atan(x/z) for the angle round the y axis, where opposite points have the same quotient, and π/2 where z is 0",
            hint: "Two opposite points have the same quotient: which of the two does your angle belong to?",
            answer: |q| by_quotient(q, [0, 2], Upright::FirstHalf),
        },
        Mistake {
            name: "takes atan(y/x) for the angle round the z axis, where opposite points have the same quotient",
            hint: "Two opposite points have the same quotient: which of the two does your angle belong to?",
            answer: |q| by_quotient(q, [1, 0], Upright::Well),
        },
        Mistake {
            name: "takes atan(y/x) for the angle round the z axis, where opposite points have the same quotient, and π/2 where x is 0",
            hint: "Two opposite points have the same quotient: which of the two does your angle belong to?",
            answer: |q| by_quotient(q, [1, 0], Upright::FirstHalf),
        },
        Mistake {
            name: "takes the latitude for the angle from the pole",
            hint: "On the equator the latitude is 0: what is the angle from the pole there, and which sine and cosine does your formula need?",
            answer: |q| {
                let n = Self::right(q);
                let round = Vec2::new(n.x, n.z).try_normalize().unwrap_or(Vec2::X);
                Vec3::new(n.y * round.x, Vec2::new(n.x, n.z).length(), n.y * round.y)
            },
        },
        Mistake {
            name: "returns the normal of a box's face, along the axis of the largest component",
            hint: "How many different normals has a sphere, and how many has a box?",
            answer: |q| {
                let n = Self::right(q);
                let largest = n.abs().max_position();
                Vec3::AXES[largest] * n[largest].signum()
            },
        },
        Mistake {
            name: "never returns a negative x, as by a square root or by an arc cosine",
            hint: "Two points of a sphere at the origin differ in the sign of x only: does your formula tell them apart?",
            answer: |q| {
                let n = Self::right(q);
                n.with_x(n.x.abs())
            },
        },
        Mistake {
            name: "never returns a negative y, as by a square root or by an arc cosine",
            hint: "Two points of a sphere at the origin differ in the sign of y only: does your formula tell them apart?",
            answer: |q| {
                let n = Self::right(q);
                n.with_y(n.y.abs())
            },
        },
        Mistake {
            name: "never returns a negative z, as by a square root or by an arc cosine",
            hint: "Two points of a sphere at the origin differ in the sign of z only: does your formula tell them apart?",
            answer: |q| {
                let n = Self::right(q);
                n.with_z(n.z.abs())
            },
        },
        Mistake {
            name: "normalises approximately, as n (3 − n·n)/2, which is right only for lengths near 1",
            hint: "How long is your normal for a vector of length 2, and for one of length 4?",
            answer: |q| {
                let way = q.p - q.center;
                way * (1.5 - 0.5 * way.length_squared())
            },
        },
        Mistake {
            name: "normalises approximately, as 2 n/(1 + n·n), which is right only for lengths near 1",
            hint: "How long is your normal for a vector of length 2, and for one of length 4?",
            answer: |q| {
                let way = q.p - q.center;
                2.0 * way / (1.0 + way.length_squared())
            },
        },
        Mistake {
            name: "takes the fast inverse square root, whose one step leaves an error of up to 0.2 %",
            hint: "How long is your normal, to four digits? What would a second step make of it?",
            answer: |q| {
                let way = q.p - q.center;
                way * fast_inverse_root(way.length_squared())
            },
        },
        Mistake {
            name: "returns the gradient of |p − c|², which is 2 (p − c), without normalising it",
            hint: "The gradient points in the normal's direction: how long is it, and how long is a normal?",
            answer: |q| 2.0 * (q.p - q.center),
        },
    ];
}

/// What becomes of a quotient whose denominator is 0.
#[derive(Clone, Copy)]
enum Upright {
    /// The right angle.
    Well,
    /// Always π/2.
    FirstHalf,
    /// NaN for 0/0, and otherwise the right angle.
    NanAtPole,
}

/// The normal from an angle round an axis, which is the arctangent of the quotient of two components: where the one below is negative, both
/// have the wrong sign. `upright` says what happens where that is 0.
fn by_quotient(q: &SphereNormal, [over, under]: [usize; 2], upright: Upright) -> Vec3 {
    let mut n = SphereNormal::right(q);
    if n[under] == 0.0 {
        match upright {
            Upright::FirstHalf => n[over] = n[over].abs(),
            Upright::NanAtPole if n[over] == 0.0 => (n[under], n[over]) = (f32::NAN, f32::NAN),
            Upright::Well | Upright::NanAtPole => {}
        }
        return n;
    }
    if n[under] < 0.0 {
        (n[under], n[over]) = (-n[under], -n[over]);
    }
    n
}

/// About 1/√x: a guess by the bits of x, and one step of Newton's method.
fn fast_inverse_root(x: f32) -> f32 {
    let guess = f32::from_bits(0x5f37_59df_u32.wrapping_sub(x.to_bits() >> 1));
    guess * (1.5 - 0.5 * x * guess * guess)
}
