//! Floor 6: from rays to a picture.

pub mod film;
