//! How long building takes, how much memory the result, and what its tree costs.

use crate::meshes::Scene;
use crate::race::Ratios;
use crate::racer::{Entry, Racer};
use peak_alloc::PeakAlloc;
use raybook_peers::sah::Sah;
use std::time::Instant;

/// Counts all memory of Rust's; Embree counts its own.
#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// A structure, and what it took to build it.
pub(crate) struct Built {
    /// What was built.
    pub entry: &'static Entry,
    /// The structure, until it is taken.
    racer: Option<Box<dyn Racer>>,
    /// Seconds of each round, with 1 thread and with 2.
    seconds: [Vec<f64>; 2],
    /// Bytes that stay, the structure's copy of the triangles among them, per triangle of the mesh.
    pub bytes_per_triangle: f64,
    /// What its tree costs, if it has one and tells it.
    pub sah: Option<Sah>,
}

impl Built {
    /// The structure itself.
    ///
    /// # Panics
    /// If it was taken before.
    pub(crate) fn take(&mut self) -> Box<dyn Racer> {
        self.racer.take().expect("a structure is taken once")
    }

    /// The best times, with 1 thread and with 2: whatever else the machine does only adds.
    pub(crate) fn best(&self) -> [f64; 2] {
        let least = |seconds: &Vec<f64>| seconds.iter().copied().fold(f64::INFINITY, f64::min);
        self.seconds.each_ref().map(least)
    }

    /// Embree's times divided by these, in the same rounds; with 1 thread and with 2.
    pub(crate) fn ratios(&self, embree: &Self) -> [Ratios; 2] {
        [0, 1].map(|i| Ratios::of(&embree.seconds[i], &self.seconds[i]))
    }

    /// Builds it once more.
    fn again(&mut self, scene: &Scene) -> Result<(), String> {
        for (threads, seconds) in (1..).zip(&mut self.seconds) {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .map_err(|error| format!("no threads: {error}"))?;
            self.racer = None;
            let before = MEMORY.current_usage();
            let start = Instant::now();
            let racer = pool.install(|| (self.entry.build)(scene, threads))?;
            seconds.push(start.elapsed().as_secs_f64());
            let grown = MEMORY.current_usage().saturating_sub(before);
            let bytes = racer.bytes().unwrap_or(grown);
            self.bytes_per_triangle = bytes as f64 / scene.mesh.triangles().len() as f64;
            self.racer = Some(racer);
        }
        Ok(())
    }

    /// Asks what the tree of the last build costs.
    fn ask_cost(&mut self, scene: &Scene) -> Result<(), String> {
        if let Some(racer) = &self.racer {
            self.sah = Sah::of(&scene.mesh.bounds(), &racer.nodes(&scene.mesh)?);
        }
        Ok(())
    }
}

/// Builds all of them in each of several rounds: whatever else the machine does meets all alike.
///
/// # Errors
/// If one cannot be built.
pub(crate) fn build(
    entries: impl Iterator<Item = &'static Entry>,
    scene: &Scene,
    rounds: usize,
) -> Result<Vec<Built>, String> {
    let nothing = |entry| Built {
        entry,
        racer: None,
        seconds: [const { Vec::new() }; 2],
        bytes_per_triangle: 0.0,
        sah: None,
    };
    let mut all: Vec<_> = entries.map(nothing).collect();
    for _ in 0..rounds {
        for one in &mut all {
            one.again(scene)?;
        }
    }
    for one in &mut all {
        one.ask_cost(scene)?;
    }
    Ok(all)
}
