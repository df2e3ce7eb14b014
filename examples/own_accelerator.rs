//! An accelerator of your own: shapes in order along x, so that the search ends as soon as all that are left begin behind the
//! nearest hit. How many shapes it tests, beside the list and the tree.

use raybook::accel::{Count, Tests};
use raybook::prelude::*;

/// Shapes by where their boxes begin along x.
struct Sorted<S> {
    shapes: Vec<(f32, S)>,
}

impl<S: Shape> Sorted<S> {
    fn new(shapes: Vec<S>) -> Self {
        let mut shapes: Vec<_> = shapes.into_iter().map(|s| (s.bounds().min.x, s)).collect();
        shapes.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { shapes }
    }
}

impl<S: Shape> Accel<S> for Sorted<S> {
    fn closest_counted(
        &self,
        ray: &Ray,
        mut within: Interval,
        count: &mut impl Count,
    ) -> Option<(&S, Hit)> {
        let mut closest = None;
        for (begin, shape) in &self.shapes {
            // Along +x nothing that begins behind the hit can be nearer.
            if ray.direction.x > 0.0 && ray.at(within.max).x < *begin {
                break;
            }
            count.tested_shape();
            if let Some(hit) = shape.hit(ray, within) {
                within = within.before(hit.t);
                closest = Some((shape, hit));
            }
        }
        closest
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        self.shapes
            .iter()
            .any(|(_, shape)| shape.blocks(ray, within))
    }
}

fn main() {
    let balls = || {
        (0..1000)
            .map(|i| Sphere::new(vec3((i * 617 % 1000) as f32, 0.0, 0.0), 0.3))
            .collect::<Vec<_>>()
    };
    let ray = Ray::new(vec3(99.5, 0.1, 0.0), Dir3::X);
    println!("list    {}", tested(&List::new(balls()), &ray));
    println!("sorted  {}", tested(&Sorted::new(balls()), &ray));
    println!("tree    {}", tested(&Bvh::new(balls()), &ray));
}

/// The shapes that are tested for the nearest hit along a ray, and how far away it is.
fn tested(accel: &impl Accel<Sphere>, ray: &Ray) -> String {
    let mut count = Tests::default();
    let hit = accel.closest_counted(ray, Interval::AHEAD, &mut count);
    let t = hit.map_or(f32::INFINITY, |(_, hit)| hit.t);
    format!("{:4} balls tested, the nearest after {t} m", count.shapes)
}
