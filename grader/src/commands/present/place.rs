//! A place where pictures are drawn, one at a time: who comes later stops who was there before.

use indicatif::ProgressBar;
use raybook_chapters::kit::stage::{Output, Stage};
use raybook_grader::mutex::lock;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

/// Where pictures are drawn, one at a time.
pub(super) struct Place {
    /// Held by who draws.
    pub easel: Arc<Mutex<()>>,
    /// The drawing that goes on, or was the latest.
    drawing: Mutex<Drawing>,
    /// How many drawings were asked for: the latest is the one that counts.
    asked: AtomicU64,
}

/// What others may know of a drawing, and do to it.
struct Drawing {
    stopper: Arc<AtomicBool>,
    /// How far it is.
    bar: ProgressBar,
    /// The pictures that it has finished.
    outputs: Arc<Mutex<Vec<Output>>>,
}

impl Place {
    pub(super) fn new() -> Self {
        Self {
            easel: Arc::default(),
            drawing: Mutex::new(Drawing {
                stopper: Arc::default(),
                bar: ProgressBar::hidden(),
                outputs: Arc::default(),
            }),
            asked: AtomicU64::default(),
        }
    }

    /// Stops what is being drawn, and what waits for that; returns a number for what comes next.
    pub(super) fn clear(&self) -> u64 {
        let ticket = 1 + self.asked.fetch_add(1, Ordering::SeqCst);
        lock(&self.drawing).stopper.store(true, Ordering::SeqCst);
        ticket
    }

    /// Makes the drawing on this stage known, and returns whether it is still the one that counts.
    pub(super) fn begin(&self, stage: &Stage, bar: ProgressBar, ticket: u64) -> bool {
        *lock(&self.drawing) = Drawing {
            stopper: stage.stopper(),
            bar,
            outputs: stage.outputs(),
        };
        // Asked after the stopper can be seen: who comes later stops this one.
        self.asked.load(Ordering::SeqCst) == ticket
    }

    /// How much of the pixels is drawn that are known to be needed, from 0 to 1 or more.
    pub(super) fn share(&self) -> f64 {
        let bar = &lock(&self.drawing).bar;
        bar.position() as f64 / bar.length().unwrap_or_default() as f64
    }

    /// The caption of a picture, if it is finished.
    pub(super) fn caption(&self, png: &Path) -> Option<String> {
        let outputs = Arc::clone(&lock(&self.drawing).outputs);
        let outputs = lock(&outputs);
        let output = outputs.iter().find(|output| output.png == png)?;
        Some(output.caption.clone())
    }
}
