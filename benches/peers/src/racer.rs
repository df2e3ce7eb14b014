//! What takes part in the race.

use crate::meshes::Scene;
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::mesh::Mesh;
use raybook_peers::sah::Node;

/// A ray, and the stretch of it that counts.
pub(crate) type Question = (Ray, Interval);

/// The distance that stands for a miss.
pub(crate) const MISS: f32 = f32::INFINITY;

/// A structure over the triangles of a mesh, asked ray by ray: all that a new one has to provide.
pub(crate) trait Search: Send + Sized {
    /// The distance of the nearest hit within the interval, or [`MISS`].
    fn closest(&self, question: &Question) -> f32;

    /// Whether there is any hit within the interval.
    fn any(&self, question: &Question) -> bool;

    /// The nearest hits of many rays at once, for structures that follow several together; false for all others.
    fn closest_many(&self, _questions: &[Question], _answers: &mut Vec<f32>) -> bool {
        false
    }

    /// Bytes that it says it takes; `None` to take what was allocated while it was built, and is still there.
    fn bytes(&self) -> Option<usize> {
        None
    }

    /// The nodes of its tree of boxes over this mesh, the root among them, in any order; none if it has no such tree, or keeps it to itself.
    ///
    /// # Errors
    /// If another builder, which is asked for the tree, fails.
    fn nodes(&self, _mesh: &Mesh) -> Result<Vec<Node>, String> {
        Ok(Vec::new())
    }
}

/// The same for whole sets of rays, so that only one call in thousands is an indirect one.
pub(crate) trait Racer: Send {
    /// Answers: distances for [`Query::Closest`] and [`Query::ClosestMany`], 0 or [`MISS`] for [`Query::Any`].
    /// False if the structure knows no such query.
    fn run(&self, query: Query, questions: &[Question], answers: &mut Vec<f32>) -> bool;

    /// See [`Search::bytes`].
    fn bytes(&self) -> Option<usize>;

    /// See [`Search::nodes`].
    fn nodes(&self, mesh: &Mesh) -> Result<Vec<Node>, String>;
}

impl<S: Search> Racer for S {
    fn run(&self, query: Query, questions: &[Question], answers: &mut Vec<f32>) -> bool {
        answers.clear();
        match query {
            Query::Closest => answers.extend(questions.iter().map(|q| self.closest(q))),
            Query::Any => {
                let blocked = |q| if self.any(q) { 0.0 } else { MISS };
                answers.extend(questions.iter().map(blocked));
            }
            Query::ClosestMany => return self.closest_many(questions, answers),
        }
        true
    }

    fn bytes(&self) -> Option<usize> {
        Search::bytes(self)
    }

    fn nodes(&self, mesh: &Mesh) -> Result<Vec<Node>, String> {
        Search::nodes(self, mesh)
    }
}

/// What is asked of a set of rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Query {
    /// The nearest hit, ray by ray.
    Closest,
    /// Any hit, ray by ray.
    Any,
    /// The nearest hits, of many rays in one call.
    ClosestMany,
}

impl Query {
    /// The name in tables.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Closest => "closest",
            Self::Any => "any",
            Self::ClosestMany => "closest_many",
        }
    }
}

/// Builds over a scene, with a number of threads; or says why not.
pub(crate) type Build = fn(&Scene, usize) -> Result<Box<dyn Racer>, String>;

/// One that takes part: how it is called, and how it is built over a scene.
pub(crate) struct Entry {
    /// The name in tables.
    pub name: &'static str,
    /// Whether it is one of raybook's.
    pub ours: bool,
    /// Builds it. This is what the build time measures, the copy of the mesh into its own form included.
    pub build: Build,
    /// More triangles than this, and it takes no part.
    pub at_most: usize,
    /// Whether it can take part: on this machine, in this scene.
    pub takes_part: fn(&Scene) -> bool,
}
