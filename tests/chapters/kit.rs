//! What every chapter draws with.

mod address;
mod bars;
mod figure;
mod pen;
