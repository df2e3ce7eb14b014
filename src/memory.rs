//! How much memory a file may make us take.

/// Most bytes of memory that a file may take, as it lies on the disk or as the picture or the mesh that is in it: 1 GiB.
///
/// A picture of 8192 × 8192 pixels takes three quarters of it. A small file can promise far more than there is memory.
pub const BUDGET: u64 = 1 << 30;

/// A number of bytes for people, in gigabytes.
pub fn gigabytes(bytes: u64) -> String {
    format!("{:.1} GB", bytes as f64 * 1e-9)
}
