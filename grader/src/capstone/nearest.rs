//! What each ray hits first, by asking about every thing in turn.

use super::scene::Shape;
use super::trace::Tracer;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook_workbook::exercises::{
    ch03_sphere::SphereHit, ch04_plane::PlaneHit, ch05_box::BoxClip, ch06_triangle::TriangleHit,
};
use std::io;

/// A ray, and the distances on it that count.
pub type Reach = (Ray, Interval);

impl Tracer<'_, '_> {
    /// The smallest distance at which each ray hits something, and what.
    pub(super) fn nearest(&mut self, reaches: &[Reach]) -> io::Result<Vec<Option<(f32, usize)>>> {
        let mut nearest: Vec<Option<(f32, usize)>> = vec![None; reaches.len()];
        for (i, thing) in self.things.clone().into_iter().enumerate() {
            let found = self.distances(thing.shape, reaches)?.into_iter();
            for ((best, found), (_, within)) in nearest.iter_mut().zip(found).zip(reaches) {
                let is_nearer = |t: &f32| best.is_none_or(|(before, _)| *t < before);
                if let Some(t) = found.filter(|t| within.contains(*t)).filter(is_nearer) {
                    *best = Some((t, i));
                }
            }
        }
        Ok(nearest)
    }

    /// Where each ray hits a shape.
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
