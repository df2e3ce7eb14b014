//! Functions over the unit square whose means are known: four classes, each with any number of members.

use crate::lab::area;
use crate::lab::edge::Edge;
use glam::{DVec2, Vec2};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use std::f64::consts::{PI, TAU};

/// A function over the unit square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// 1 inside a disc.
    Disc {
        /// Its centre.
        centre: DVec2,
        /// Its radius.
        radius: f64,
    },
    /// 1 on one side of a straight edge.
    Edge(Edge),
    /// ½ + ½ cos(2π k·p + φ): smooth.
    Wave {
        /// k, waves along each axis.
        waves: DVec2,
        /// φ.
        phase: f64,
    },
    /// 1 in the odd squares of a turned checkerboard.
    Checker(Checker),
}

/// A checkerboard, turned and moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checker {
    /// The direction of its rows, of length 1.
    pub along: DVec2,
    /// A corner of an even square.
    pub corner: DVec2,
    /// The side of a square.
    pub side: f64,
}

impl Checker {
    /// The column and the row of the square in which a point is.
    pub fn square(&self, p: DVec2) -> DVec2 {
        let from = (p - self.corner) / self.side;
        DVec2::new(from.dot(self.along), from.dot(self.along.perp())).floor()
    }
}

/// A function and its mean over the unit square.
#[derive(Clone, Copy, Debug)]
pub struct Integrand {
    /// The function.
    pub form: Form,
    /// Its mean, exactly.
    pub mean: f64,
}

/// A class of functions.
#[derive(Clone, Copy, Debug)]
pub struct Class {
    /// What its members are.
    pub name: &'static str,
    /// A description of the members.
    pub text: &'static str,
    draw: fn(&mut Pcg) -> Form,
}

/// Edges of discs, straight edges, smooth waves, and checkerboards: at random places, of random sizes and at random angles.
pub const CLASSES: [Class; 4] = [
    Class {
        name: "disc edge",
        text: "Discs with a random centre in the square and a random radius between 0.2 and 0.6",
        draw: |rng| Form::Disc {
            centre: anywhere(rng),
            radius: rng.random_range(0.2..0.6),
        },
    },
    Class {
        name: "straight edge",
        text: "Straight edges at a random angle and at a random place in the square",
        draw: |rng| {
            let normal = DVec2::from_angle(rng.random_range(0.0..TAU));
            let offset = Edge::reach(normal) * rng.random_range(-1.0..1.0);
            Form::Edge(Edge { normal, offset })
        },
    },
    Class {
        name: "smooth",
        text: "Waves in a random direction, half a wave to one and a half across the square, with a random phase",
        draw: |rng| Form::Wave {
            waves: DVec2::from_angle(rng.random_range(0.0..TAU)) * rng.random_range(0.5..1.5),
            phase: rng.random_range(0.0..TAU),
        },
    },
    Class {
        name: "checker",
        text: "Checkerboards at a random angle and place, with two to six squares along a side",
        draw: |rng| {
            Form::Checker(Checker {
                along: DVec2::from_angle(rng.random_range(0.0..TAU)),
                corner: anywhere(rng),
                side: 1.0 / rng.random_range(2.0..6.0),
            })
        },
    },
];

fn anywhere(rng: &mut Pcg) -> DVec2 {
    DVec2::new(rng.random(), rng.random())
}

impl Class {
    /// `count` random members of the class.
    pub fn members(&self, count: usize, rng: &mut Pcg) -> Vec<Integrand> {
        (0..count).map(|_| (self.draw)(rng).into()).collect()
    }
}

impl From<Form> for Integrand {
    fn from(form: Form) -> Self {
        let mean = match &form {
            Form::Disc { centre, radius } => area::of_disc(*centre, *radius),
            Form::Edge(edge) => edge.coverage(),
            Form::Wave { waves, phase } => {
                // The mean of cos(2πk·p + φ) over the square is cos(π(kx + ky) + φ) sinc kx sinc ky.
                let mean = (PI * waves.element_sum() + phase).cos() * sinc(waves.x) * sinc(waves.y);
                0.5 + 0.5 * mean
            }
            Form::Checker(checker) => area::of_checker(checker),
        };
        Self { form, mean }
    }
}

/// sin(πx)/(πx).
fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-9 {
        1.0
    } else {
        (PI * x).sin() / (PI * x)
    }
}

impl Integrand {
    /// The function's value at a point of the unit square.
    pub fn value(&self, p: Vec2) -> f64 {
        let at = p.as_dvec2();
        match &self.form {
            Form::Disc { centre, radius } => {
                f64::from(u8::from(at.distance_squared(*centre) < radius * radius))
            }
            Form::Edge(edge) => f64::from(u8::from(edge.covers(p))),
            Form::Wave { waves, phase } => 0.5 + 0.5 * (TAU * waves.dot(at) + phase).cos(),
            Form::Checker(checker) => checker.square(at).element_sum().rem_euclid(2.0),
        }
    }

    /// The error of the mean over some points.
    pub fn error(&self, points: &[Vec2]) -> f64 {
        let sum: f64 = points.iter().map(|p| self.value(*p)).sum();
        sum / points.len().max(1) as f64 - self.mean
    }
}
