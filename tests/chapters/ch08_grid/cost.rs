//! What a ray costs in a grid, in counts.

use glam::vec3;
use rand::RngExt;
use raybook::accel::{Accel, Tests, grid::Grid};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::{soup::soup, stadium::stadium, terrain::terrain};
use raybook::shape::{Hit, Shape, Surface, mesh::Facet};
use raybook_chapters::shared::{law::Reach, law::mean_tests, law::power};
use std::sync::atomic::{AtomicU32, Ordering};

/// A facet that counts how often it is asked.
struct Asked<'a>(Facet, &'a AtomicU32);

impl Shape for Asked<'_> {
    fn bounds(&self) -> Aabb {
        self.0.bounds()
    }
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.1.fetch_add(1, Ordering::Relaxed);
        self.0.hit(ray, within)
    }
    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.0.surface(ray, hit)
    }
}

/// Rays across the box of a scene.
fn rays(bounds: Aabb, count: usize) -> Vec<Ray> {
    let mut rng = pcg::stream(5, 0);
    let mut point = || {
        let unit = vec3(rng.random(), rng.random(), rng.random());
        bounds.min + unit * bounds.size()
    };
    let ray = |_| {
        let (from, to) = (point(), point());
        let direction = Dir3::new_or(to - from, Dir3::X);
        Ray::new(
            from - 2.0 * bounds.size().max_element() * *direction,
            direction,
        )
    };
    (0..count).map(ray).collect()
}

#[test]
fn a_ray_hardly_asks_a_triangle_twice_and_one_of_few_never() {
    let few = 32;
    for mesh in [soup(few, 2), soup(500, 2), terrain(20), stadium(1).mesh] {
        let counters: Vec<_> = mesh.triangles().iter().map(|_| AtomicU32::new(0)).collect();
        let shapes = mesh
            .facets()
            .into_iter()
            .map(|f| Asked(f, &counters[f.id as usize]))
            .collect();
        let grid = Grid::with_resolution(shapes, glam::uvec3(40, 30, 40));
        let (mut asked, mut again) = (0, 0);
        for ray in rays(mesh.bounds(), 100) {
            for any in [false, true] {
                if any {
                    grid.any(&ray, Interval::AHEAD);
                } else {
                    grid.closest(&ray, Interval::AHEAD);
                }
                for counter in &counters {
                    let times = counter.swap(0, Ordering::Relaxed);
                    (asked, again) = (asked + times, again + times.saturating_sub(1));
                }
            }
        }
        assert!(
            if counters.len() <= few as usize {
                again == 0
            } else {
                again < asked / 4
            },
            "of {asked} tests of {} triangles, {again} asked again",
            counters.len()
        );
        assert!(
            grid.references() > 2 * counters.len(),
            "triangles are in several cells, so it could have happened"
        );
    }
}

#[test]
fn steps_and_tests_grow_with_the_cube_root_of_the_triangles() {
    let counts = [100, 1000, 10_000, 100_000, 1_000_000]
        .map(|n| (n, mean_tests(n, Reach::Across, Grid::of_facets)));
    for (i, what) in ["steps", "tests"].into_iter().enumerate() {
        let points = counts.map(|(n, count)| (f64::from(n), count[i]));
        let power = power(&points);
        assert!(
            (0.29..0.38).contains(&power),
            "{what} grow with N^{power:.3}, not N^⅓: {points:?}"
        );
    }
}

#[test]
fn the_search_ends_at_the_first_cell_that_ends_behind_the_hit() {
    let wall = |x: f32, id| Facet {
        corners: [vec3(x, -1.0, -1.0), vec3(x, 3.0, -1.0), vec3(x, -1.0, 3.0)],
        id,
    };
    let facets: Vec<_> = (0..10_u16).map(|i| wall(f32::from(i), i.into())).collect();
    let grid = Grid::of_facets_with_resolution(facets, glam::uvec3(100, 1, 1));
    let mut count = Tests::default();
    let ray = Ray::new(vec3(-5.0, 0.1, 0.1), Dir3::X);
    let hit = grid.closest_counted(&ray, Interval::AHEAD, &mut count);
    assert_eq!(hit.map(|(_, hit)| hit.id), Some(0), "the first wall");
    assert!(
        count.boxes <= 2 && count.shapes == 1,
        "{count:?}: the other nine walls are behind it"
    );
}
