//! The lamp's light where rays arrive: what a surface sends on of it, and what is in the shadow.

use super::scene::{LAMP, Shape, camera};
use super::trace::{Place, Tracer};
use glam::{Vec2, Vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook_workbook::exercises::{
    ch03_sphere::SphereNormal,
    ch12_phong::{Arriving, Highlight, PhongExercise, PointLightExercise},
    ch15_shadows::{ShadowRay, Way},
};
use std::io;

/// The highlights' exponent.
const EXPONENT: f32 = 60.0;
/// Light that comes from everywhere, in W·m⁻²·sr⁻¹.
const AMBIENT: f32 = 0.12;

impl Tracer<'_, '_> {
    /// The light that places scatter to where the rays came from: of the lamp, if `phong` is written; else their normals, or, without
    /// these, how far away they are, as colours.
    pub(super) fn scattered(&mut self, places: &[Place]) -> io::Result<Vec<Rgb>> {
        if !self.functions.has::<PhongExercise>() {
            let normals = self.functions.has::<SphereNormal>();
            let (eye, near) = (camera(Vec2::ZERO).focal_point, 4.0);
            let colour = |place: &Place| {
                let n = place.normal;
                if normals {
                    Rgb::new(n.x, n.y, n.z).map(|v| 0.5 + 0.5 * v)
                } else {
                    place.thing.colour * (near / place.position.distance(eye)).powi(2)
                }
            };
            return Ok(places.iter().map(colour).collect());
        }
        let (position, intensity) = LAMP;
        let lamp = |place: &Place| PointLightExercise {
            position,
            intensity,
            at: place.position,
        };
        let arriving = self
            .functions
            .ask_or_answer(&places.iter().map(lamp).collect::<Vec<_>>())?;
        let lit = self.lit(places)?;
        let question = |(place, arriving): (&Place, Option<Arriving>)| {
            let dark = (Vec3::Y, Rgb::BLACK);
            let (toward, irradiance) =
                arriving.map_or(dark, |light| (light.toward, light.arriving));
            PhongExercise {
                at: Highlight {
                    normal: place.facing(),
                    view: -place.incoming,
                    toward: Dir3::new_or(toward, Dir3::Y),
                    arriving: irradiance,
                    diffuse: colour_of(place) * std::f32::consts::FRAC_1_PI,
                    specular: Rgb::WHITE * 0.2,
                    exponent: EXPONENT,
                },
            }
        };
        let questions: Vec<_> = places.iter().zip(arriving).map(question).collect();
        let answers = self.functions.ask(&questions)?.into_iter();
        let radiance = answers.zip(lit).zip(places).map(|((answer, lit), place)| {
            let direct = answer.filter(|_| lit).unwrap_or(Rgb::BLACK);
            colour_of(place) * AMBIENT + direct
        });
        Ok(radiance.collect())
    }

    /// Whether the lamp reaches each place; all, if `shadow_ray` is not written.
    fn lit(&mut self, places: &[Place]) -> io::Result<Vec<bool>> {
        /// More than the positions' rounding errors, in metres.
        const ERROR: f32 = 1e-4;
        if !self.functions.has::<ShadowRay>() {
            return Ok(vec![true; places.len()]);
        }
        let question = |place: &Place| {
            let toward = LAMP.0 - place.position;
            ShadowRay {
                position: place.position,
                error: ERROR,
                normal: place.normal,
                toward: Dir3::new_or(toward, Dir3::Y),
                distance: toward.length(),
            }
        };
        let ways = self
            .functions
            .ask(&places.iter().map(question).collect::<Vec<_>>())?;
        // Without an answer nothing is in the way.
        let clear = (Ray::new(LAMP.0, Dir3::Y), Interval::AHEAD);
        let reach = |way: Way| {
            (
                Ray::new(way.origin, Dir3::new_or(way.direction, Dir3::Y)),
                way.within,
            )
        };
        let reaches = ways.into_iter().map(|way| way.map_or(clear, reach));
        let reaches: Vec<_> = reaches.collect();
        let hits = self.nearest(&reaches)?.into_iter();
        Ok(hits.map(|hit| hit.is_none()).collect())
    }
}

/// The diffuse colour at a place: the floor has tiles of a metre.
fn colour_of(place: &Place) -> Rgb {
    let tile = place.position.floor();
    let dark = place.thing.shape == Shape::Floor && (tile.x + tile.z).rem_euclid(2.0) == 1.0;
    place.thing.colour * if dark { 0.45 } else { 1.0 }
}
