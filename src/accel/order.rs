//! Shapes in the order in which a structure names them.

/// Sorts shapes by the place at which `named` first names them, and renumbers `named`: so shapes that a ray tests one after
/// another are side by side in memory. Shapes that are not named come last.
///
/// # Panics
/// If `named` names a shape that does not exist.
pub fn by_first_use<S>(shapes: &mut Vec<S>, named: &mut [u32]) {
    const NONE: u32 = u32::MAX;
    let mut numbers = vec![NONE; shapes.len()];
    let mut given = 0;
    for name in named {
        let number = &mut numbers[*name as usize];
        if *number == NONE {
            *number = given;
            given += 1;
        }
        *name = *number;
    }
    let mut numbered: Vec<_> = numbers.into_iter().zip(shapes.drain(..)).collect();
    numbered.sort_by_key(|&(number, _)| number);
    shapes.extend(numbered.into_iter().map(|(_, shape)| shape));
}
