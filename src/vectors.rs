//! Loops over many numbers, compiled for the wide vectors of a processor that has them.
//!
//! The kernels of the wide tree (`accel/wide_bvh/proof.rs`) ask for the instructions that they name, and are another program for each set of
//! them. Here the program is the same, and only the compiler uses wider vectors.
#![cfg_attr(
    target_arch = "x86_64",
    expect(
        unsafe_code,
        reason = "code for AVX2 may only be called on a processor that has it"
    )
)]

/// Loops over many numbers.
pub(crate) trait Loops {
    /// The result.
    type Answer;

    /// Runs them. This function, and those that hold its loops, are `#[inline(always)]`.
    fn run(self) -> Self::Answer;
}

/// The result of the loops: with AVX2, eight numbers at a time, where the processor has it; otherwise four.
///
/// The result is the same bit for bit: no operation is left out, added or moved.
#[inline]
pub(crate) fn widest<L: Loops>(loops: L) -> L::Answer {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx2")]
        fn with_avx2<L: Loops>(loops: L) -> L::Answer {
            loops.run()
        }
        if is_x86_feature_detected!("avx2") {
            // SAFETY: this processor has AVX2.
            return unsafe { with_avx2(loops) };
        }
    }
    loops.run()
}
