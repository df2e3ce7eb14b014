//! What a search costs.

mod growth;
mod searches;
