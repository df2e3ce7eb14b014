//! How long building takes, and how much memory the result.

use crate::meshes::Scene;
use crate::racer::{Entry, Racer};
use peak_alloc::PeakAlloc;
use std::time::Instant;

/// Counts all memory of Rust's; Embree counts its own.
#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// A structure, and what it took to build it.
pub(crate) struct Built {
    /// The structure, until it is taken.
    racer: Option<Box<dyn Racer>>,
    /// Seconds with 1 thread and with 2.
    pub seconds: [f64; 2],
    /// Bytes that stay, the structure's copy of the triangles among them, per triangle of the mesh.
    pub bytes_per_triangle: f64,
}

impl Built {
    /// The structure itself.
    ///
    /// # Panics
    /// If it was taken before.
    pub(crate) fn take(&mut self) -> Box<dyn Racer> {
        self.racer.take().expect("a structure is taken once")
    }
}

/// Builds it several times, and takes the best times: whatever else the machine does only adds.
///
/// # Errors
/// If it cannot be built.
pub(crate) fn build(entry: &Entry, scene: &Scene, times: usize) -> Result<Built, String> {
    let mut seconds = [f64::INFINITY; 2];
    let mut built = None;
    for _ in 0..times {
        for (threads, best) in (1..).zip(&mut seconds) {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .map_err(|error| format!("no threads: {error}"))?;
            drop(built.take());
            let before = MEMORY.current_usage();
            let start = Instant::now();
            let racer = pool.install(|| (entry.build)(scene, threads))?;
            *best = best.min(start.elapsed().as_secs_f64());
            let grown = MEMORY.current_usage().saturating_sub(before);
            let bytes = racer.bytes().unwrap_or(grown);
            built = Some((racer, bytes));
        }
    }
    let (racer, bytes) = built.ok_or("built no time")?;
    let bytes_per_triangle = bytes as f64 / scene.mesh.triangles().len() as f64;
    Ok(Built {
        racer: Some(racer),
        seconds,
        bytes_per_triangle,
    })
}
