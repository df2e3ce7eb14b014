//! The race: both take turns at the same rays.

use crate::racers::{MISS, SETTINGS, Settings, Theirs, ours, surface};
use crate::scenes::Scene;
use raybook::accel::octree::Octree;
use rustix::time::{ClockId, clock_gettime};
use std::error::Error;
use std::time::Instant;

/// What came of a set of rays.
pub(crate) struct Row {
    /// The set.
    pub set: &'static str,
    /// How many times as long the other one takes, of each round.
    ratios: Vec<f64>,
    /// The part of the rays on which both agree.
    pub agree: f64,
    /// Seconds of raybook's build with one thread, and of the other's.
    pub build: f64,
    pub their_build: f64,
    /// The other's settings.
    pub settings: Settings,
}

/// Distances of both agree within this part of themselves and of the mesh's radius.
const TOLERANCE: f64 = 1e-5;

/// Races at a scene for a number of rounds, with sets of side² rays.
pub(crate) fn race(scene: &Scene, side: usize, rounds: usize) -> Result<Vec<Row>, Box<dyn Error>> {
    let radius = 0.5 * f64::from(scene.mesh.bounds().size().length());
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let begun = Instant::now();
    let octree = one.install(|| Octree::of_facets(scene.mesh.facets()));
    let build = begun.elapsed().as_secs_f64();
    let surfaces = [surface(&scene.mesh)];
    let sets = scene.sets(side);
    let tried = SETTINGS.map(|settings| {
        let begun = Instant::now();
        let theirs = Theirs::new(&surfaces, radius, settings);
        let their_build = begun.elapsed().as_secs_f64();
        let (time, _) = timed(|| sets.each_ref().map(|(_, rays)| theirs.nearest(rays)));
        (time, theirs, their_build, settings)
    });
    let fastest = tried.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, theirs, their_build, settings) = fastest.ok_or("nothing was tried")?;
    let row = |(set, rays): (_, Vec<_>)| {
        let mut ratios = Vec::new();
        let mut agree = 0.0;
        for round in 0..rounds {
            // Who begins, changes.
            let (ours, theirs) = if round % 2 == 0 {
                let first = timed(|| ours(&octree, &rays));
                (first, timed(|| theirs.nearest(&rays)))
            } else {
                let first = timed(|| theirs.nearest(&rays));
                (timed(|| ours(&octree, &rays)), first)
            };
            ratios.push(theirs.0 / ours.0);
            let same = |(a, b): &(&f64, &f64)| {
                **a == MISS && **b == MISS || (*a - *b).abs() <= TOLERANCE * (a.abs() + radius)
            };
            let same = ours.1.iter().zip(&theirs.1).filter(same).count();
            agree = same as f64 / rays.len() as f64;
        }
        Row {
            set,
            ratios,
            agree,
            build,
            their_build,
            settings,
        }
    };
    Ok(sets.into_iter().map(row).collect())
}

impl Row {
    /// The median ratio, and below which a tenth and nine tenths of the rounds are.
    pub(crate) fn ratio(&self) -> [f64; 3] {
        [0.5, 0.1, 0.9].map(|part| quantile(self.ratios.clone(), part))
    }
}

/// The number below which this part of all is; between two of them, on the line from one to the other.
fn quantile(mut numbers: Vec<f64>, part: f64) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let at = part * (numbers.len() - 1) as f64;
    let (low, high) = (numbers[at.floor() as usize], numbers[at.ceil() as usize]);
    low + at.fract() * (high - low)
}

/// Seconds of processor time, and what came of it.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let begun = seconds();
    let done = work();
    (seconds() - begun, done)
}

/// Seconds of processor time that this thread has had.
fn seconds() -> f64 {
    let now = clock_gettime(ClockId::ThreadCPUTime);
    now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
}
