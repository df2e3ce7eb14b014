//! raybook's answers beside Embree's.

mod accelerators;
mod agreement;
mod facts;
mod facts_about_meshes;
mod golden;
mod leaks;
mod recording;
