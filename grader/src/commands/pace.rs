//! The progress of grading a class, with an estimate of what is left.

use indicatif::{ProgressBar, ProgressStyle};
use raybook_chapters::kit::say::complain;
use raybook_grader::mutex::lock;
use std::io::IsTerminal;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// How far a run is, and how long it will take: a bar on a terminal, and elsewhere a line now and then.
pub struct Pace {
    bar: ProgressBar,
    open: usize,
    through: AtomicUsize,
    start: Instant,
    told: Mutex<Instant>,
}

/// How often a line is written where there is no terminal.
const EVERY: Duration = Duration::from_secs(10);

impl Pace {
    /// Nothing is graded yet.
    pub fn of(hand_ins: usize, open: usize) -> Self {
        complain(format!(
            "{hand_ins} hand-ins, {open} to grade (equal ones once)"
        ));
        let bar = ProgressBar::new(open as u64);
        if let Ok(style) = ProgressStyle::with_template(
            "{wide_bar} {pos} of {len} hand-ins, {per_sec}, {eta} left",
        ) {
            bar.set_style(style);
            bar.enable_steady_tick(Duration::from_secs(1));
        }
        let start = Instant::now();
        Self {
            bar,
            open,
            through: AtomicUsize::new(0),
            start,
            told: Mutex::new(start),
        }
    }

    /// Another hand-in is through.
    pub fn next(&self) {
        self.bar.inc(1);
        self.through.fetch_add(1, Ordering::Relaxed);
        self.tell();
    }

    /// Something went on: where there is no terminal, it is time for a line now and then.
    pub fn tell(&self) {
        let through = self.through.load(Ordering::Relaxed);
        let mut told = lock(&self.told);
        if !std::io::stderr().is_terminal()
            && told.elapsed() >= EVERY
            && (1..self.open).contains(&through)
        {
            *told = Instant::now();
            let per_second = through as f64 / self.start.elapsed().as_secs_f64();
            let left = (self.open - through) as f64 / per_second;
            complain(format!(
                "{through} of {} hand-ins, {:.0} a minute, {:.0} s left",
                self.open,
                60.0 * per_second,
                left
            ));
        }
    }

    /// The run is over.
    pub fn end(&self) {
        self.bar.finish_and_clear();
        let through = self.through.load(Ordering::Relaxed);
        let seconds = self.start.elapsed().as_secs_f64();
        if through > 0 {
            complain(format!(
                "{through} hand-ins in {seconds:.0} s, {:.0} a minute",
                60.0 * through as f64 / seconds
            ));
        }
    }
}
