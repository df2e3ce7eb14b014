//! Ray tracing in steps that each ask one function about all rays at once: what they hit, where, under which light.

use super::functions::Functions;
use super::scene::{GLASS, LAMP, Made, Shape, Thing, camera, sky, things};
use glam::{Vec2, Vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook_workbook::exercises::{
    ch01_rays::CameraRay,
    ch03_sphere::{SphereHit, SphereNormal},
    ch04_plane::PlaneHit,
    ch05_box::BoxClip,
    ch06_triangle::{TriangleHit, TriangleNormal},
    ch12_phong::{Arriving, Highlight, PhongExercise, PointLightExercise},
    ch13_reflection::Reflect,
    ch14_refraction::Refract,
    ch15_shadows::{ShadowRay, Way},
};
use std::io;

/// How often light is mirrored or refracted on its way.
const BOUNCES: u32 = 5;
/// How far a ray starts from the surface that it leaves, in metres.
const LIFT: f32 = 1e-3;
/// The share of the light that the mirror reflects, and its colour gives the rest.
const MIRRORED: f32 = 0.7;
/// The highlights' exponent.
const EXPONENT: f32 = 60.0;
/// Light that comes from everywhere, in W·m⁻²·sr⁻¹.
const AMBIENT: f32 = 0.12;

/// A ray, and the distances on it that count.
type Reach = (Ray, Interval);

/// Where a ray arrives.
#[derive(Clone, Copy)]
struct Place {
    /// Which of the rays.
    ray: usize,
    thing: Thing,
    position: Vec3,
    /// Where the ray came from.
    incoming: Dir3,
    /// The outward normal.
    normal: Dir3,
}

impl Place {
    /// The normal on the side from which the ray came.
    fn facing(&self) -> Dir3 {
        if self.normal.dot(*self.incoming) > 0.0 {
            -self.normal
        } else {
            self.normal
        }
    }

    /// A ray that leaves in this direction.
    fn leave(&self, direction: Dir3) -> Ray {
        let side = LIFT.copysign(direction.dot(*self.normal));
        Ray::new(self.position + side * *self.normal, direction)
    }
}

/// Traces rays through the scene by asking.
pub struct Tracer<'a, 'b> {
    functions: &'a mut Functions<'b>,
    things: Vec<Thing>,
}

impl<'a, 'b> Tracer<'a, 'b> {
    /// Of everything whose hit function is written.
    pub fn new(functions: &'a mut Functions<'b>) -> Self {
        let mut things = things();
        things.retain(|thing| match thing.shape {
            Shape::Ball { .. } => functions.has::<SphereHit>(),
            Shape::Floor => functions.has::<PlaneHit>(),
            Shape::Block(_) => functions.has::<BoxClip>(),
            Shape::Triangle(_) => functions.has::<TriangleHit>(),
        });
        Self { functions, things }
    }

    /// What is seen through places on the film.
    pub fn seen(&mut self, film: &[Vec2]) -> io::Result<Vec<Rgb>> {
        let questions: Vec<CameraRay> = film.iter().map(|film| camera(*film)).collect();
        let answers = self.functions.ask_or_answer(&questions)?;
        let rays = answers.iter().zip(&questions).map(|(ray, question)| {
            Ray::new(ray.origin, Dir3::new_or(ray.direction, question.forward))
        });
        self.radiance(&rays.collect::<Vec<_>>(), BOUNCES)
    }

    /// The radiance that comes along each ray.
    fn radiance(&mut self, rays: &[Ray], bounces: u32) -> io::Result<Vec<Rgb>> {
        let mut colours: Vec<_> = rays.iter().map(|ray| sky(*ray.direction)).collect();
        let (clear, solid): (Vec<_>, Vec<_>) = self
            .places(rays)?
            .into_iter()
            .partition(|place| place.thing.made == Made::Glass && self.functions.has::<Refract>());
        for (place, colour) in solid.iter().zip(self.scattered(&solid)?) {
            colours[place.ray] = colour;
        }
        let mirrors = solid
            .iter()
            .filter(|place| place.thing.made == Made::Mirror);
        let mirrors: Vec<_> = mirrors.copied().collect();
        if bounces > 0 && self.functions.has::<Reflect>() && !mirrors.is_empty() {
            let onward = self.mirrored(&mirrors)?;
            for (place, colour) in mirrors.iter().zip(self.radiance(&onward, bounces - 1)?) {
                let own = &mut colours[place.ray];
                *own = own.lerp(colour, MIRRORED);
            }
        }
        if bounces > 0 && !clear.is_empty() {
            let onward = self.refracted(&clear)?;
            for (place, colour) in clear.iter().zip(self.radiance(&onward, bounces - 1)?) {
                colours[place.ray] = colour;
            }
        }
        Ok(colours)
    }

    /// The nearest place where each ray arrives.
    fn places(&mut self, rays: &[Ray]) -> io::Result<Vec<Place>> {
        let reaches: Vec<_> = rays.iter().map(|ray| (*ray, Interval::AHEAD)).collect();
        let hits = self.nearest(&reaches)?.into_iter().enumerate();
        let hits = hits.filter_map(|(i, hit)| Some((i, hit?)));
        let mut places: Vec<_> = hits
            .map(|(ray, (t, thing))| Place {
                ray,
                thing: self.things[thing],
                position: rays[ray].at(t),
                incoming: rays[ray].direction,
                normal: Dir3::Y,
            })
            .collect();
        self.find_normals(&mut places)?;
        Ok(places)
    }

    /// The smallest distance at which each ray hits something, and what.
    fn nearest(&mut self, reaches: &[Reach]) -> io::Result<Vec<Option<(f32, usize)>>> {
        let mut nearest: Vec<Option<(f32, usize)>> = vec![None; reaches.len()];
        for (i, thing) in self.things.clone().into_iter().enumerate() {
            let found = self.distances(thing.shape, reaches)?.into_iter();
            for ((best, found), (_, within)) in nearest.iter_mut().zip(found).zip(reaches) {
                let is_nearer = |t: &f32| best.is_none_or(|(before, _)| *t < before);
                if let Some(t) = found.filter(|t| within.contains(*t)).filter(is_nearer) {
                    *best = Some((t, i));
                }
            }
        }
        Ok(nearest)
    }

    /// Where each ray hits a shape.
    fn distances(&mut self, shape: Shape, reaches: &[Reach]) -> io::Result<Vec<Option<f32>>> {
        let reaches = reaches.iter().copied();
        Ok(match shape {
            Shape::Ball { center, radius } => {
                let question = |(ray, within)| SphereHit {
                    ray,
                    within,
                    center,
                    radius,
                };
                let answers = self
                    .functions
                    .ask(&reaches.map(question).collect::<Vec<_>>())?;
                answers.into_iter().map(Option::flatten).collect()
            }
            Shape::Floor => {
                let (normal, offset) = (Dir3::Y, 0.0);
                let question = |(ray, within)| PlaneHit {
                    ray,
                    within,
                    normal,
                    offset,
                };
                let answers = self
                    .functions
                    .ask(&reaches.map(question).collect::<Vec<_>>())?;
                answers.into_iter().map(Option::flatten).collect()
            }
            Shape::Block([min, max]) => {
                let question = |(ray, within)| BoxClip {
                    ray,
                    within,
                    min,
                    max,
                };
                let questions: Vec<_> = reaches.map(question).collect();
                let answers = self.functions.ask(&questions)?.into_iter().zip(questions);
                // A ray that starts inside sees the wall behind which it leaves.
                let first = |inside: Interval, within: Interval| {
                    if inside.min > within.min {
                        inside.min
                    } else {
                        inside.max
                    }
                };
                let distance = |(inside, question): (Option<Option<Interval>>, BoxClip)| {
                    Some(first(inside??, question.within))
                };
                answers.map(distance).collect()
            }
            Shape::Triangle([p0, p1, p2]) => {
                let question = |(ray, within)| TriangleHit {
                    ray,
                    within,
                    p0,
                    p1,
                    p2,
                };
                let answers = self
                    .functions
                    .ask(&reaches.map(question).collect::<Vec<_>>())?;
                let hits = answers.into_iter().map(Option::flatten);
                hits.map(|hit| Some(hit?.t)).collect()
            }
        })
    }

    /// Asks for the normals of balls and triangles; those of floor and box are axes.
    fn find_normals(&mut self, places: &mut [Place]) -> io::Result<()> {
        let (mut balls, mut of_ball) = (Vec::new(), Vec::new());
        let (mut faces, mut of_face) = (Vec::new(), Vec::new());
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
        Ok(())
    }

    /// The light that places scatter to where the rays came from: of the lamp, if `phong` is written; else their normals, or, without
    /// these, how far away they are, as colours.
    fn scattered(&mut self, places: &[Place]) -> io::Result<Vec<Rgb>> {
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

    /// The rays that go on from mirrors.
    fn mirrored(&mut self, places: &[Place]) -> io::Result<Vec<Ray>> {
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
    fn refracted(&mut self, places: &[Place]) -> io::Result<Vec<Ray>> {
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

/// The diffuse colour at a place: the floor has tiles of a metre.
fn colour_of(place: &Place) -> Rgb {
    let tile = place.position.floor();
    let dark = place.thing.shape == Shape::Floor && (tile.x + tile.z).rem_euclid(2.0) == 1.0;
    place.thing.colour * if dark { 0.45 } else { 1.0 }
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
