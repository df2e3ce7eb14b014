//! Searches, whose steps are counted.

use glam::{Vec3, vec3};
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook_grader::inside::cost::searched;

#[test]
fn a_search_ends_with_the_cell_in_which_the_nearest_hit_lies() {
    let at = |z: f32| [vec3(-1.0, -1.0, z), vec3(1.0, -1.0, z), vec3(0.0, 1.0, z)];
    let triangles = [at(-2.0), at(-4.0), at(-6.0)];
    let ray = Ray::new(Vec3::ZERO, -Dir3::Z);
    let steps = |groups: &[(&[u32], f32)]| searched(&triangles, ray, groups.iter().copied());
    // The first cell is empty, the second holds the hit, and the third is not entered.
    assert_eq!(steps(&[(&[], 1.0), (&[0], 3.0), (&[1], 5.0)]), 3.0);
    // A hit behind the end of its cell waits for nearer ones.
    assert_eq!(steps(&[(&[2], 3.0), (&[1], 5.0), (&[0], 7.0)]), 4.0);
    assert_eq!(steps(&[(&[], 1.0), (&[], 2.0)]), 2.0, "nothing is hit");
}
