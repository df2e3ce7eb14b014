//! Sobol's sequence in two dimensions.

// ANCHOR: sobol
/// Point i of Sobol's sequence (1967), both coordinates in units of 2⁻³².
///
/// The first is i mirrored, as in van der Corput's. The second is the sum without carry of a fixed number for each bit of i:
/// the rows of Pascal's triangle modulo 2. Any 2ᵏ points that follow one another from a multiple of 2ᵏ have one in each box of
/// the area 2⁻ᵏ, whatever power of ½ its width is: a (0, 2)-net.
///
/// Number k of the triangle's row n is odd if n has all the binary digits that k has (Lucas 1878). So five steps, one for each
/// digit of a bit's place, add up the rows of all bits at once: no loop, and no bit that a processor would have to guess.
#[inline]
pub fn sobol(i: u32) -> [u32; 2] {
    let mut sum = i;
    sum ^= sum >> 1 & 0x5555_5555;
    sum ^= sum >> 2 & 0x3333_3333;
    sum ^= sum >> 4 & 0x0f0f_0f0f;
    sum ^= sum >> 8 & 0x00ff_00ff;
    sum ^= sum >> 16;
    [i.reverse_bits(), sum.reverse_bits()]
}
// ANCHOR_END: sobol

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_coordinate_is_the_sum_of_rows_of_pascals_triangle_without_carry() {
        // Each row follows from the one before: a number is the sum of the two above it.
        let slow = |i: u32| {
            let rows = std::iter::successors(Some(1_u32 << 31), |row| Some(row ^ row >> 1));
            let rows = rows.zip(0..32).filter(|(_, bit)| i >> bit & 1 == 1);
            rows.fold(0, |sum, (row, _)| sum ^ row)
        };
        for i in (0..5000)
            .chain((0..32).map(|bit| 1 << bit))
            .chain([u32::MAX, 0xdead_beef])
        {
            assert_eq!(sobol(i), [i.reverse_bits(), slow(i)], "point {i}");
        }
    }
}
