//! Floor 4: stock scenes that chapters share.

pub mod window;
