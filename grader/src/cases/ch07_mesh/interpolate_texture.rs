//! `interpolate_texture`: random questions, judge and mistakes.

use super::{nearest_corner, place};
use crate::{Graded, Mistake, Verdict, judge, sample};
use glam::{Vec2, Vec2Swizzles, vec2};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch07_mesh::InterpolateTexture;

impl Graded for InterpolateTexture {
    fn random(rng: &mut Pcg) -> InterpolateTexture {
        let mut texture = || {
            vec2(
                sample::number(rng, -1.0, 3.0),
                sample::number(rng, -1.0, 3.0),
            )
        };
        let (t0, t1, t2) = (texture(), texture(), texture());
        InterpolateTexture {
            t0,
            t1,
            t2,
            b: place(rng),
        }
    }

    fn is_sound(q: &InterpolateTexture) -> bool {
        sample::are_weights(q.b)
    }

    fn judge(_q: &InterpolateTexture, golden: &Vec2, got: &Vec2) -> Verdict {
        judge::pair(["u", "v"], *golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "gives the weights to the wrong corners",
            hint: "At b1 = b2 = 0, whose coordinates do you return?",
            answer: |q| Self::misread(q, |q| (q.t0, q.t1, q.t2) = (q.t2, q.t0, q.t1)),
        },
        Mistake {
            name: "swaps b1 and b2",
            hint: "At b1 = 1, whose coordinates do you return?",
            answer: |q| Self::misread(q, |q| q.b = q.b.yx()),
        },
        Mistake {
            name: "swaps u and v",
            hint: "Which of the two coordinates comes first?",
            answer: |q| Self::right(q).yx(),
        },
        Mistake {
            name: "normalises the coordinates as if they were a direction",
            hint: "Texture coordinates have no length that matters.",
            answer: |q| InterpolateTexture::right(q).normalize_or_zero(),
        },
        Mistake {
            name: "wraps the coordinates into [0, 1)",
            hint: "A texture may repeat: is that decided here, or where the texture is looked up?",
            answer: |q| InterpolateTexture::right(q).fract_gl(),
        },
        Mistake {
            name: "returns (b1, b2)",
            hint: "b1 and b2 say where the point is in the triangle: where is the point in the texture?",
            answer: |q| Self::misread(q, |q| (q.t0, q.t1, q.t2) = (Vec2::ZERO, Vec2::X, Vec2::Y)),
        },
        Mistake {
            name: "gives the first corner the weight 1",
            hint: "The three weights add up to 1.",
            answer: |q| q.t0 + q.b.x * q.t1 + q.b.y * q.t2,
        },
        Mistake {
            name: "leaves b2 out of the first corner's weight",
            hint: "The three weights add up to 1: do yours, where neither b1 nor b2 is 0?",
            answer: |q| (1.0 - q.b.x) * q.t0 + q.b.x * q.t1 + q.b.y * q.t2,
        },
        Mistake {
            name: "takes the mean of the three corners' coordinates, wherever the point is",
            hint: "Move the point towards a corner: the coordinates should move towards that corner's.",
            answer: |q| Self::misread(q, |q| q.b = Vec2::splat(1.0 / 3.0)),
        },
        Mistake {
            name: "returns the coordinates of the nearest corner, the one of the largest weight",
            hint: "Move the point a little: do the coordinates change a little, or do they jump?",
            answer: |q| {
                let corners = [Vec2::ZERO, Vec2::X, Vec2::Y];
                Self::misread(q, |q| q.b = corners[nearest_corner(q.b)])
            },
        },
        Mistake {
            name: "goes along u by b1 alone, and along v by b2 alone",
            hint: "Each corner has both coordinates: does the third corner's u count nowhere?",
            answer: |q| Self::misread(q, |q| (q.t1.y, q.t2.x) = (q.t0.y, q.t0.x)),
        },
        Mistake {
            name: "goes from the first corner to the second by b1 along u, and by b2 along v",
            hint: "Three corners, each with both coordinates: where does the third corner come in?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.t2 = vec2(q.t0.x, q.t1.y);
                    q.t1.y = q.t0.y;
                })
            },
        },
        Mistake {
            name: "forgets t0 in t0 + b1·(t1 − t0) + b2·(t2 − t0)",
            hint: "At b1 = b2 = 0, what do you return? From which corner do both ways begin?",
            answer: |q| InterpolateTexture::right(q) - q.t0,
        },
        Mistake {
            name: "goes by b2 from the second corner to the third, not from the first",
            hint: "At b2 = 1, whose coordinates do you return?",
            answer: |q| Self::misread(q, |q| q.t2 += q.t0 - q.t1),
        },
        Mistake {
            name: "leaves b1 out of the first corner's weight",
            hint: "The three weights add up to 1: do yours, where neither b1 nor b2 is 0?",
            answer: |q| (1.0 - q.b.y) * q.t0 + q.b.x * q.t1 + q.b.y * q.t2,
        },
        Mistake {
            name: "blends the first two corners by b1, and the result with the third by b2",
            hint: "At b1 = b2 = ½ the point lies half way between the second corner and the third: which weights have your three corners there?",
            answer: |q| Self::misread(q, |q| q.b.x *= 1.0 - q.b.y),
        },
        Mistake {
            name: "takes (1 − b1)(1 − b2) for the first corner's weight, as on a square",
            hint: "On the side opposite to the first corner b1 + b2 is 1: which weight should the first corner have there?",
            answer: |q| (1.0 - q.b.x) * (1.0 - q.b.y) * q.t0 + q.b.x * q.t1 + q.b.y * q.t2,
        },
        Mistake {
            name: "takes a square's weights for all three corners, and leaves out its fourth",
            hint: "The three weights add up to 1: do yours, where neither b1 nor b2 is 0?",
            answer: |q| {
                let rest = 1.0 - q.b;
                rest.x * rest.y * q.t0 + q.b.x * rest.y * q.t1 + rest.x * q.b.y * q.t2
            },
        },
        Mistake {
            name: "clamps the coordinates to the range from 0 to 1",
            hint: "A texture may repeat, or end: is that decided here, or where the texture is looked up?",
            answer: |q| InterpolateTexture::right(q).clamp(Vec2::ZERO, Vec2::ONE),
        },
        Mistake {
            name: "keeps only what is behind the decimal point, with its sign",
            hint: "A texture may repeat: is that decided here, or where the texture is looked up?",
            answer: |q| InterpolateTexture::right(q).fract(),
        },
        Mistake {
            name: "takes 1 − b1·b2 for the first corner's weight",
            hint: "The three weights add up to 1: do yours at the second corner?",
            answer: |q| (1.0 - q.b.x * q.b.y) * q.t0 + q.b.x * q.t1 + q.b.y * q.t2,
        },
    ];
}
