//! Sobol's sequence in two dimensions.

// ANCHOR: sobol
/// Point i of Sobol's sequence (1967), both coordinates in units of 2⁻³².
///
/// The first is i mirrored, as in van der Corput's. The second is the sum without carry of a fixed number for each bit of i:
/// the rows of Pascal's triangle modulo 2. Any 2ᵏ points that follow one another from a multiple of 2ᵏ have one in each box of
/// the area 2⁻ᵏ, whatever power of ½ its width is: a (0, 2)-net.
#[inline]
pub fn sobol(i: u32) -> [u32; 2] {
    let (mut second, mut direction, mut bits) = (0, 1_u32 << 31, i);
    while bits > 0 {
        if bits & 1 == 1 {
            second ^= direction;
        }
        direction ^= direction >> 1;
        bits >>= 1;
    }
    [i.reverse_bits(), second]
}
// ANCHOR_END: sobol
