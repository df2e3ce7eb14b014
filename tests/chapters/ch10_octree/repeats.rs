//! What it costs that a shape is named in several leaves.

use glam::vec2;
use raybook::accel::octree::{Octree, build::Limits, reach};
use raybook::accel::{Accel, Tests};
use raybook::inside::octree;
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;
use raybook::shape::{Hit, Shape, Surface, teapot};
use raybook_chapters::shared::showroom::Showroom;
use raybook_common::{STALE, measured};
use std::collections::BTreeSet;
use std::sync::Mutex;

/// A triangle that notes each of its hit tests.
struct Noted<'a>(Facet, &'a Mutex<Vec<u32>>);

impl Shape for Noted<'_> {
    fn bounds(&self) -> Aabb {
        self.0.bounds()
    }
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.1.lock().expect("nobody panics").push(self.0.id);
        self.0.hit(ray, within)
    }
    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.0.surface(ray, hit)
    }
}

/// The rays of a picture of the teapot.
fn rays(room: &Showroom) -> impl Iterator<Item = Ray> {
    (0..80 * 50).map(|i| room.ray(vec2((i % 80) as f32 / 80.0, (i / 80) as f32 / 50.0)))
}

#[test]
fn boxes_of_triangles_are_in_more_leaves_and_tests_are_repeated() {
    let mesh = teapot::mesh(12);
    let room = Showroom::around(&mesh, 1.6);
    let notes = Mutex::new(Vec::new());
    let noted = mesh.facets().into_iter().map(|facet| Noted(facet, &notes));
    let by_triangle = |noted: &Noted, cells: &[Aabb; 8]| reach::by_triangle(&noted.0, cells);
    let exact = Octree::with(noted.collect(), Limits::USUAL, by_triangle);
    let boxes = Octree::new(mesh.facets());
    let (mut tested, mut repeated, mut of_boxes) = (0, 0, Tests::default());
    for ray in rays(&room) {
        exact.closest(&ray, Interval::AHEAD);
        boxes.closest_counted(&ray, Interval::AHEAD, &mut of_boxes);
        let asked = std::mem::take(&mut *notes.lock().expect("nobody panics"));
        let distinct: BTreeSet<_> = asked.iter().collect();
        tested += asked.len();
        repeated += asked.len() - distinct.len();
    }
    let copies = octree::tree(&exact).named.len() as f64 / mesh.triangles().len() as f64;
    let told = format!(
        "On a teapot of {} triangles, a triangle is named in {copies:.1} leaves on average, and {:.0} % of the tests are repetitions. With the \
        boxes of the triangles alone, a ray tests {:.1} times as many triangles.\n",
        mesh.triangles().len(),
        100.0 * repeated as f64 / tested as f64,
        of_boxes.shapes as f64 / tested as f64,
    );
    assert_eq!(measured("octree_repeats", &told), told, "{STALE}");
}
