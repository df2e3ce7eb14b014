//! What a search costs: the steps of the student's function, beside the reference's and linear search, as scenes grow.

pub(crate) mod searches;

use crate::ask::{Asker, Said};
use crate::examine::Examiner;
use crate::explain::diagram::{Diagram, Ink};
use crate::sample;
use glam::{DVec2, Vec3, dvec2};
use raybook::math::{dir3::Dir3, pcg, pcg::Pcg, ray::Ray};
use raybook_workbook::row;
use searches::{Over, SEARCHES, Steps};
use std::io;

/// The numbers of triangles in the scenes.
pub(crate) const SIZES: [u32; 6] = [8, 16, 32, 64, 128, 256];
/// Rays through each scene.
const RAYS: usize = 12;

/// The mean number of steps per ray for each of the sizes.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// The exercise that is asked.
    pub exercise: &'static str,
    /// What is a step.
    pub step: &'static str,
    /// The student's steps.
    pub yours: Vec<f64>,
    /// The reference's.
    pub reference: Vec<f64>,
}

/// Asks the program for the steps of an exercise as scenes grow; none if it is no search, or an answer is missing.
///
/// # Errors
/// If the program cannot be started.
pub fn measure(asker: &mut Asker<'_>, examiner: &dyn Examiner) -> io::Result<Option<Cost>> {
    let asked = examiner.asked();
    let Some(search) = SEARCHES.iter().find(|search| search.exercise == asked.name) else {
        return Ok(None);
    };
    let mut rng = pcg::stream(17, 0);
    let (mut questions, mut counts) = (Vec::new(), Vec::new());
    for size in SIZES {
        let Over { question, steps } = (search.over)(&scene(size, &mut rng));
        let rays: [_; RAYS] = std::array::from_fn(|_| ray(&mut rng));
        questions.extend(rays.map(question));
        counts.push((rays, steps));
    }
    let lines = questions.iter();
    let lines = lines.map(|q| format!("{} {}", asked.name, row::format(asked.question, q)));
    asker.next_exercise();
    let replies = asker.ask(&lines.collect::<Vec<_>>())?;
    let read = |said: &Said| match said {
        Said::Answer(answer) => asked.read_answer(answer.unescaped()).ok(),
        _ => None,
    };
    let yours: Option<Vec<_>> = replies.iter().map(|reply| read(&reply.said)).collect();
    let reference: Vec<_> = questions.iter().map(|q| (asked.call)(q)).collect();
    // The mean of each scene's rays.
    let mean = |(rays, steps): &([Ray; RAYS], Steps), answers: &[Vec<f64>]| {
        let each = rays.iter().zip(answers);
        each.map(|(ray, answer)| steps(*ray, answer)).sum::<f64>() / RAYS as f64
    };
    let means = |answers: &[Vec<f64>]| {
        let scenes = counts.iter().zip(answers.chunks(RAYS));
        scenes
            .map(|(scene, answers)| mean(scene, answers))
            .collect()
    };
    Ok(yours.map(|yours| Cost {
        exercise: search.exercise,
        step: search.step,
        yours: means(&yours),
        reference: means(&reference),
    }))
}

/// A scene of this size: triangles strewn in a cube, the smaller the more there are, so that about as much of what a ray sees is
/// covered.
pub(crate) fn scene(size: u32, rng: &mut Pcg) -> Vec<[Vec3; 3]> {
    let extent = 3.0 / (size as f32).sqrt();
    let triangle = |_| {
        let center = sample::point(rng, 2.0);
        std::array::from_fn(|_| center + sample::point(rng, extent))
    };
    (0..size).map(triangle).collect()
}

/// A ray through the scene from outside.
pub(crate) fn ray(rng: &mut Pcg) -> Ray {
    let origin = 5.0 * *sample::direction(rng);
    Ray::new(
        origin,
        Dir3::new_or(sample::point(rng, 1.5) - origin, Dir3::X),
    )
}

/// The exponent a of steps that grow like N^a: the slope of the line through their logarithms, by least squares.
pub(crate) fn exponent(steps: &[f64]) -> f64 {
    let points: Vec<_> = points(steps);
    let middle = points.iter().copied().sum::<DVec2>() / points.len() as f64;
    let apart = points.iter().map(|p| *p - middle);
    let [xy, xx] = apart.fold([0.0, 0.0], |[xy, xx], d| [xy + d.x * d.y, xx + d.x * d.x]);
    xy / xx
}

/// Sizes and steps as powers of two.
fn points(steps: &[f64]) -> Vec<DVec2> {
    let sizes = SIZES.iter().map(|size| f64::from(*size));
    sizes
        .zip(steps)
        .map(|(size, steps)| dvec2(size.log2(), steps.max(0.5).log2()))
        .collect()
}

impl Cost {
    /// What the curves say.
    pub fn words(&self) -> String {
        let last = |steps: &[f64]| steps.last().copied().unwrap_or(0.0);
        format!(
            "From {} to {} triangles your steps per ray grow like N^{:.2}, the reference's like N^{:.2}, and those of linear search like N. At {} triangles yours takes {:.0} steps, the reference {:.0}. A step is {}.",
            SIZES[0],
            SIZES[5],
            exponent(&self.yours),
            exponent(&self.reference),
            SIZES[5],
            last(&self.yours),
            last(&self.reference),
            self.step,
        )
    }

    /// The curves, with logarithmic axes.
    pub fn plot(&self) -> Diagram {
        let mut plot =
            Diagram::new("Steps per ray over the number of triangles; both axes are logarithmic");
        plot.stretched = true;
        plot.keyed = false;
        let linear: Vec<_> = SIZES.iter().map(|size| f64::from(*size)).collect();
        let [left, right] = [f64::from(SIZES[0]).log2(), f64::from(SIZES[5]).log2()];
        for power in 0..=8 {
            let y = f64::from(power);
            plot.line(&[dvec2(left, y), dvec2(right, y)], Ink::Guide);
            plot.label(
                dvec2(left, y),
                dvec2(-0.5, 0.0),
                format!("{}", 1 << power),
                Ink::Guide,
            );
        }
        for size in SIZES {
            plot.label(
                dvec2(f64::from(size).log2(), 0.0),
                dvec2(0.0, -1.2),
                format!("{size}"),
                Ink::Guide,
            );
        }
        for (steps, ink, name) in [
            (&linear, Ink::Shape, "linear search"),
            (&self.reference, Ink::Right, "reference"),
            (&self.yours, Ink::Yours, "yours"),
        ] {
            let points = points(steps);
            plot.line(&points, ink);
            for p in &points {
                plot.point(*p, ink);
            }
            if let Some(last) = points.last() {
                plot.label(*last, dvec2(-0.4, 1.2), name, ink);
            }
        }
        plot
    }
}
