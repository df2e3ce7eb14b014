//! The limit on the memory for a file.
//!
//! ```
//! use raybook::memory;
//!
//! assert_eq!(memory::gigabytes(memory::BUDGET), "1.1 GB"); // 1 GiB is 7 % more than 1 GB
//! ```

/// Maximum size in bytes of a file, and of the picture or mesh that is read from it: 1 GiB.
///
/// A picture of 8192 × 8192 pixels takes three quarters of it. Without the limit, a small file could claim more than all memory.
pub const BUDGET: u64 = 1 << 30;

/// A number of bytes as text, in gigabytes (10⁹ bytes).
pub fn gigabytes(bytes: u64) -> String {
    format!("{:.1} GB", bytes as f64 * 1e-9)
}
