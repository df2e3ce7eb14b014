//! Floor 6: from rays to a picture.

pub mod adaptive;
pub mod budget;
pub mod clamped;
pub mod cone;
pub mod curved;
pub mod film;
pub mod followed;
pub mod glints;
pub mod guides;
pub mod local;
pub mod mis;
pub mod needs_more;
pub mod path;
pub mod refine;
pub mod reflection;
pub mod sampler;
pub mod shadow;
pub mod soft_shadow;
pub mod supersample;
pub mod through_lens;
pub mod trace;
pub mod whitted;
