//! Internals of the grader that only its tests need.
//!
//! They are not stable. The tests are a program of their own, so that the grader is not compiled once more for them: what they
//! cannot reach through what is public, they take from here.

pub use crate::attempt::attempt;
pub use crate::budget::Budget;
pub use crate::clock::{Clock, usage};
pub use crate::each::each;
pub use crate::serve::until::Until;
#[cfg(target_os = "linux")]
pub use crate::stat::Stat;

/// Internals of the book: its listings, the library's items, and what an earlier build made.
pub mod book {
    pub use crate::book::code::html;
    pub use crate::book::fit::fit;
    pub use crate::book::items::{Item, section};
    pub use crate::book::kept::or_make;
    pub use crate::book::names::Names;
}

/// Internals of grading a class: what is compiled once for all.
pub mod class {
    pub use crate::class::prebuilt::{standard_headers, unchanged};
}

/// Internals of a diagnosis.
pub mod diagnose {
    pub use crate::diagnose::function::{FUNCTIONS, Function};
    pub use crate::diagnose::slips::STEPS;

    use crate::diagnose::{evidence::Evidence, misread::misreadings, search::search};
    use crate::examine::{Case, Examiner};
    use crate::mutex::lock;

    /// The number of steps that slips go until the search for what explains these answers ends.
    pub fn steps(
        examiner: &dyn Examiner,
        cases: &[Case],
        answers: &[(Option<String>, bool)],
    ) -> usize {
        let evidence = Evidence::new(examiner, cases, answers);
        let readings = misreadings(examiner.asked().question, examiner.limits());
        search(&evidence, &readings);
        lock(&evidence.slips).steps
    }
}

/// Internals of pictures made of answers.
pub mod picture {
    use crate::picture::progressive;
    use raybook::image::rgb::Rgb;

    /// The colour of a pixel without an answer.
    pub const MISSING: Rgb = progressive::MISSING;
}

/// Internals of a search's cost.
pub mod cost {
    pub use crate::report::cost::searches::{Over, SEARCHES, searched};

    use crate::report::cost;
    use glam::Vec3;
    use raybook::math::{pcg::Pcg, ray::Ray};

    /// The numbers of triangles in the scenes.
    pub const SIZES: [u32; 6] = cost::SIZES;

    /// A scene of this size.
    pub fn scene(size: u32, rng: &mut Pcg) -> Vec<[Vec3; 3]> {
        cost::scene(size, rng)
    }

    /// A ray through the scene from outside.
    pub fn ray(rng: &mut Pcg) -> Ray {
        cost::ray(rng)
    }

    /// The exponent a of steps that grow like N^a.
    pub fn exponent(steps: &[f64]) -> f64 {
        cost::exponent(steps)
    }
}

/// Internals of the sandbox.
#[cfg(target_os = "linux")]
pub mod sandbox {
    pub use crate::sandbox::watch::{Bounds, build};

    use crate::sandbox::{self, Missing, layers};
    use std::path::PathBuf;

    /// The place of a running program that another build has replaced since.
    pub fn as_it_was(program: PathBuf) -> PathBuf {
        sandbox::as_it_was(program)
    }

    /// Whether this version of landlock, seccomp, and filters for the processor are enough.
    ///
    /// # Errors
    /// Which layer is missing.
    pub fn suffices(landlock: i32, seccomp: bool, filters: bool) -> Result<(), Missing> {
        layers::suffices(landlock, seccomp, filters)
    }
}

/// Internals of how slow a machine is.
pub mod slowness {
    pub use crate::slowness::{SLOWEST, USUAL, measured, of};
}

/// Internals of what students are given.
pub mod starter {
    use crate::starter::lesson;

    /// A line of a lesson without links to other pages than lessons, and with the names of formulas spelt out.
    pub fn plain(line: &str) -> String {
        lesson::plain(line)
    }
}
