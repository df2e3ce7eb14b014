//! What could not be written while a command went on with its work: the exit code tells it.

use std::error::Error;

/// The reasons, in order.
#[derive(Debug, Default)]
pub struct Unwritten(Vec<String>);

impl Unwritten {
    /// What was written, or nothing: then the reason is kept.
    pub fn or_none<T>(&mut self, written: Result<T, impl Into<Box<dyn Error>>>) -> Option<T> {
        let error: Box<dyn Error> = match written {
            Ok(written) => return Some(written),
            Err(error) => error.into(),
        };
        self.0.push(error.to_string());
        None
    }

    /// Whether everything was written.
    ///
    /// # Errors
    /// If not: the reasons, each once.
    pub fn said(mut self) -> Result<(), Box<dyn Error>> {
        self.0.dedup();
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(self.0.join("\n").into())
        }
    }
}
