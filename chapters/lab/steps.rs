//! The progress of the lab.

use crate::kit::say::say;
use indicatif::{ProgressBar, ProgressStyle};

/// What is done, as a bar, or as lines where there is no terminal.
#[derive(Debug)]
pub struct Steps {
    bar: ProgressBar,
}

impl Steps {
    /// A number of steps, none done.
    pub fn new(steps: u64) -> Self {
        let style = ProgressStyle::with_template("{bar:32} {percent:>3} %  {elapsed}  {msg}")
            .unwrap_or_else(|_| ProgressStyle::default_bar());
        Self {
            bar: ProgressBar::new(steps).with_style(style),
        }
    }

    /// Says what comes next.
    pub fn begin(&self, what: String) {
        if self.bar.is_hidden() {
            say(&what);
        }
        self.bar.set_message(what);
    }

    /// One more step is done.
    pub fn done(&self) {
        self.bar.inc(1);
    }

    /// All steps are done.
    pub fn finish(&self) {
        self.bar.finish();
    }
}
