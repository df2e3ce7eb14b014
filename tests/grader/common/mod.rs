//! What the tests of the grader share.

pub mod command;
pub mod executable;
pub mod starter;
