//! The rays that go on from mirrors and glass.

use super::scene::GLASS;
use super::trace::{Place, Tracer};
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook_workbook::exercises::{ch13_reflection::Reflect, ch14_refraction::Refract};
use std::io;

impl Tracer<'_, '_> {
    /// The rays that go on from mirrors.
    pub(super) fn mirrored(&mut self, places: &[Place]) -> io::Result<Vec<Ray>> {
        let question = |place: &Place| Reflect {
            incoming: place.incoming,
            normal: place.normal,
        };
        let answers = self
            .functions
            .ask_or_answer(&places.iter().map(question).collect::<Vec<_>>())?;
        let onward = places.iter().zip(answers);
        Ok(onward
            .map(|(place, to)| place.leave(Dir3::new_or(to, place.facing())))
            .collect())
    }

    /// The rays that go on behind glass, or, totally reflected, before it.
    pub(super) fn refracted(&mut self, places: &[Place]) -> io::Result<Vec<Ray>> {
        let question = |place: &Place| Refract {
            direction: place.incoming,
            normal: place.normal,
            outside: 1.0,
            inside: GLASS,
        };
        let answers = self
            .functions
            .ask(&places.iter().map(question).collect::<Vec<_>>())?;
        let reflected = self.mirrored(places)?;
        let onward = places.iter().zip(answers).zip(reflected);
        Ok(onward
            .map(|((place, through), reflected)| {
                let through = through.flatten().and_then(Dir3::new);
                through.map_or(reflected, |direction| place.leave(direction))
            })
            .collect())
    }
}
