//! What each ray hits first, by asking about every thing in turn.

use super::scene::{Shape, Thing};
use super::trace::Tracer;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook_workbook::exercises::{
    ch03_sphere::SphereHit, ch04_plane::PlaneHit, ch05_box::BoxClip, ch06_triangle::TriangleHit,
};
use std::io;

/// A ray, and the distances on it that count.
pub type Reach = (Ray, Interval);

/// What a ray hits first.
#[derive(Clone, Copy)]
pub(super) struct Nearest {
    /// The distance along the ray, in metres.
    pub(super) t: f32,
    /// Which thing.
    pub(super) thing: usize,
    /// Which of its triangles, if it is a mesh.
    pub(super) part: u32,
}

impl Tracer<'_, '_> {
    /// The nearest hit of each ray.
    pub(super) fn nearest(&mut self, reaches: &[Reach]) -> io::Result<Vec<Option<Nearest>>> {
        let mut nearest: Vec<Option<Nearest>> = vec![None; reaches.len()];
        for (thing, Thing { shape, .. }) in self.things.clone().into_iter().enumerate() {
            let found: Vec<Option<(f32, u32)>> = if shape == Shape::Teapot {
                self.teapot.hits(self.functions, reaches)?
            } else {
                let distances = self.distances(shape, reaches)?.into_iter();
                distances.map(|t| Some((t?, 0))).collect()
            };
            for ((best, found), (_, within)) in nearest.iter_mut().zip(found).zip(reaches) {
                let is_nearer = |t: f32| within.contains(t) && best.is_none_or(|best| t < best.t);
                if let Some((t, part)) = found.filter(|&(t, _)| is_nearer(t)) {
                    *best = Some(Nearest { t, thing, part });
                }
            }
        }
        Ok(nearest)
    }

    /// Where each ray hits a shape that is no mesh.
    fn distances(&mut self, shape: Shape, reaches: &[Reach]) -> io::Result<Vec<Option<f32>>> {
        let reaches = reaches.iter().copied();
        Ok(match shape {
            Shape::Ball { center, radius } => {
                let question = |(ray, within)| SphereHit {
                    ray,
                    within,
                    center,
                    radius,
                };
                let answers = self
                    .functions
                    .ask(&reaches.map(question).collect::<Vec<_>>())?;
                answers.into_iter().map(Option::flatten).collect()
            }
            Shape::Floor => {
                let (normal, offset) = (Dir3::Y, 0.0);
                let question = |(ray, within)| PlaneHit {
                    ray,
                    within,
                    normal,
                    offset,
                };
                let answers = self
                    .functions
                    .ask(&reaches.map(question).collect::<Vec<_>>())?;
                answers.into_iter().map(Option::flatten).collect()
            }
            Shape::Block([min, max]) => {
                let question = |(ray, within)| BoxClip {
                    ray,
                    within,
                    min,
                    max,
                };
                let questions: Vec<_> = reaches.map(question).collect();
                let answers = self.functions.ask(&questions)?.into_iter().zip(questions);
                // A ray that starts inside sees the wall behind which it leaves.
                let first = |inside: Interval, within: Interval| {
                    if inside.min > within.min {
                        inside.min
                    } else {
                        inside.max
                    }
                };
                let distance = |(inside, question): (Option<Option<Interval>>, BoxClip)| {
                    Some(first(inside??, question.within))
                };
                answers.map(distance).collect()
            }
            Shape::Teapot => vec![None; reaches.len()],
            Shape::Triangle([p0, p1, p2]) => {
                let question = |(ray, within)| TriangleHit {
                    ray,
                    within,
                    p0,
                    p1,
                    p2,
                };
                let answers = self
                    .functions
                    .ask(&reaches.map(question).collect::<Vec<_>>())?;
                let hits = answers.into_iter().map(Option::flatten);
                hits.map(|hit| Some(hit?.t)).collect()
            }
        })
    }
}
