//! Shapes without a box are asked beside the grid.

use glam::{uvec3, vec3};
use raybook::accel::{Accel, Tests, grid::Grid};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Hit, Shape, Surface, mesh::Facet, plane::Plane, teapot};

const AHEAD: Interval = Interval::AHEAD;

#[test]
fn planes_are_asked_beside_the_grid() {
    /// A plane or a facet.
    enum Either {
        Plane(Plane),
        Facet(Facet),
    }
    impl Shape for Either {
        fn bounds(&self) -> Aabb {
            match self {
                Self::Plane(plane) => plane.bounds(),
                Self::Facet(facet) => facet.bounds(),
            }
        }
        fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
            match self {
                Self::Plane(plane) => plane.hit(ray, within),
                Self::Facet(facet) => facet.hit(ray, within),
            }
        }
        fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
            match self {
                Self::Plane(plane) => plane.surface(ray, hit),
                Self::Facet(facet) => facet.surface(ray, hit),
            }
        }
    }
    let facets = teapot::mesh(3).facets().into_iter().map(Either::Facet);
    let ground = Either::Plane(Plane::through(vec3(0.0, -1.0, 0.0), Dir3::Y));
    let grid = Grid::with_resolution(facets.chain([ground]).collect(), uvec3(7, 5, 6));
    assert_eq!(grid.validate(), Ok(()));
    let mut tests = Tests::default();
    let down = Ray::new(vec3(9.0, 4.0, 9.0), -Dir3::Y);
    let hit = grid
        .closest_counted(&down, AHEAD, &mut tests)
        .map(|(_, hit)| hit.t);
    assert_eq!(
        (hit, tests),
        (
            Some(5.0),
            Tests {
                boxes: 0,
                shapes: 1
            }
        ),
        "only the plane is there"
    );
    let body = Ray::new(vec3(0.5, 9.0, 0.3), -Dir3::Y);
    assert!(
        grid.closest(&body, AHEAD)
            .is_some_and(|(_, hit)| hit.t < 8.0),
        "the teapot is above the plane"
    );
    assert!(
        grid.any(&down, AHEAD) && !grid.any(&Ray::new(down.origin, Dir3::Y), AHEAD),
        "nothing is above"
    );
}
