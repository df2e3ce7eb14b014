//! The grid finds what the list finds.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::accel::{Accel, Tests, grid::Grid, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::teapot;

#[test]
fn quick() {
    for mesh in [
        soup(2000, 1),
        teapot::mesh(6),
        raybook::scene::terrain::terrain(30),
    ] {
        let b = mesh.bounds();
        let grid = Grid::of_facets(mesh.facets());
        let coarse = Grid::new(mesh.facets());
        grid.validate().expect("valid");
        coarse.validate().expect("valid");
        println!(
            "{:?} refs {} shapes {} / {}",
            grid.lattice(),
            grid.references(),
            mesh.triangles().len(),
            coarse.references()
        );
        let list = List::new(mesh.facets());
        let mut rng = pcg::stream(7, 0);
        let mut hits = 0;
        let mut tests = Tests::default();
        for i in 0..20000 {
            let mut v = |s: f32| {
                b.center()
                    + b.size()
                        * s
                        * (Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>() - 0.5)))
            };
            let o = v(if i % 2 == 0 { 4.0 } else { 0.8 });
            let d = v(1.0) - o;
            let ray = Ray::new(
                o,
                Dir3::new_or(
                    if i % 5 == 0 {
                        d * vec3(1.0, 0.0, -0.0)
                    } else {
                        d
                    },
                    Dir3::X,
                ),
            );
            let a = list.closest(&ray, Interval::AHEAD).map(|h| h.1);
            assert_eq!(
                grid.closest_counted(&ray, Interval::AHEAD, &mut tests)
                    .map(|h| h.1.t),
                a.map(|h| h.t),
                "{ray:?}"
            );
            assert_eq!(
                coarse.closest(&ray, Interval::AHEAD).map(|h| h.1.t),
                a.map(|h| h.t),
                "{ray:?}"
            );
            assert_eq!(grid.any(&ray, Interval::AHEAD), a.is_some());
            hits += u32::from(a.is_some());
        }
        println!("{hits} hits {tests:?}");
    }
}
