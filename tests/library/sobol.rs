//! Sobol's sequence, against its definition.

use raybook::sample::pattern::sobol::sobol;

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
