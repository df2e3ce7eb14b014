//! Laws: what must hold for every shape and every ray, asked of thousands of random ones.
//!
//! The random numbers follow from fixed seeds, so that a run can be repeated.

#[path = "laws/boxes.rs"]
mod boxes;
#[path = "laws/forms.rs"]
mod forms;
#[path = "laws/hits.rs"]
mod hits;
#[path = "laws/leave.rs"]
mod leave;
#[path = "laws/motion.rs"]
mod motion;
#[path = "laws/wild.rs"]
mod wild;
