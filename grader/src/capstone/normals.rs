//! The outward normals where rays arrive.

use super::scene::Shape;
use super::trace::{Place, Tracer};
use glam::Vec3;
use raybook::math::dir3::Dir3;
use raybook_workbook::exercises::{
    ch03_sphere::SphereNormal, ch06_triangle::TriangleNormal, ch07_mesh::InterpolateNormal,
};
use std::io;

impl Tracer<'_, '_> {
    /// Asks for the normals of balls and triangles; those of floor and box are axes, and the teapot is smooth if
    /// `interpolate_normal` is written.
    pub(super) fn find_normals(&mut self, places: &mut [Place]) -> io::Result<()> {
        let (mut balls, mut of_ball) = (Vec::new(), Vec::new());
        let (mut faces, mut of_face) = (Vec::new(), Vec::new());
        let (mut smooth, mut of_smooth) = (Vec::new(), Vec::new());
        let is_smooth = self.functions.has::<InterpolateNormal>();
        for (i, place) in places.iter_mut().enumerate() {
            let p = place.position;
            match place.thing.shape {
                Shape::Ball { center, radius } => {
                    balls.push(SphereNormal { center, radius, p });
                    of_ball.push(i);
                }
                Shape::Floor => place.normal = Dir3::Y,
                Shape::Block([min, max]) => place.normal = wall(min, max, p),
                Shape::Triangle([p0, p1, p2]) => {
                    faces.push(TriangleNormal { p0, p1, p2 });
                    of_face.push(i);
                }
                Shape::Teapot if is_smooth => {
                    let found = self.teapot.smooth(self.functions, place.part, p)?;
                    if let Some((question, lifted)) = found {
                        place.position = lifted;
                        smooth.push(question);
                        of_smooth.push(i);
                    }
                }
                Shape::Teapot => {
                    if let Some([p0, p1, p2]) = self.teapot.corners(place.part) {
                        faces.push(TriangleNormal { p0, p1, p2 });
                        of_face.push(i);
                    }
                }
            }
        }
        for (i, normal) in of_ball
            .into_iter()
            .zip(self.functions.ask_or_answer(&balls)?)
        {
            places[i].normal = Dir3::new_or(normal, Dir3::Y);
        }
        for (i, normal) in of_face
            .into_iter()
            .zip(self.functions.ask_or_answer(&faces)?)
        {
            places[i].normal = Dir3::new_or(normal.unwrap_or_default(), Dir3::Y);
        }
        for (i, normal) in of_smooth
            .into_iter()
            .zip(self.functions.ask_or_answer(&smooth)?)
        {
            places[i].normal = Dir3::new_or(normal, Dir3::Y);
        }
        Ok(())
    }
}

/// The normal of the wall of a box that a point is nearest to.
fn wall(min: Vec3, max: Vec3, p: Vec3) -> Dir3 {
    let walls = [
        (p.x - min.x, -Dir3::X),
        (max.x - p.x, Dir3::X),
        (p.y - min.y, -Dir3::Y),
        (max.y - p.y, Dir3::Y),
        (p.z - min.z, -Dir3::Z),
        (max.z - p.z, Dir3::Z),
    ];
    let nearest = walls
        .into_iter()
        .min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    nearest.map_or(Dir3::Y, |(_, normal)| normal)
}
