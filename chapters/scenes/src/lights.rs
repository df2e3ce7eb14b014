//! Lights, and what is around the scene.

use crate::fields::{Fields, Make};
use crate::wrong::TextError;
use glam::Vec3;
use raybook::image::{Image, mip::MipMap, rgb::Rgb};
use raybook::light::Light;
use raybook::light::directional::DirectionalLight;
use raybook::light::environment::Environment;
use raybook::light::extent::LightSampling;
use raybook::light::point::PointLight;
use raybook::light::rect_light::RectLight;
use raybook::light::sphere_light::SphereLight;
use raybook::math::domain::LARGEST;
use raybook::math::ray::Ray;
use raybook::scene::backdrop::panorama;
use raybook::scene::world::Scene;
use raybook::shape::sphere::Sphere;

pub(crate) fn lights(all: Vec<Fields>) -> Result<Vec<Box<dyn Light>>, TextError> {
    let light = |fields: Fields| fields.made("a light", &KINDS);
    all.into_iter().map(light).collect()
}

/// The kinds by their words.
const KINDS: [(&str, Make<Box<dyn Light>>); 4] = [
    ("rectangle", rectangle),
    ("sphere", sphere),
    ("point", point),
    ("directional", directional),
];

fn rectangle(fields: &Fields) -> Result<Box<dyn Light>, TextError> {
    let [corner, a, b] = corner_and_edges(fields)?;
    let radiance = fields.need("radiance", Fields::light)?;
    Ok(Box::new(RectLight::new(corner, a, b, radiance)))
}

fn sphere(fields: &Fields) -> Result<Box<dyn Light>, TextError> {
    let center = fields.need("center_m", Fields::place)?;
    let sphere = Sphere::checked(center, fields.need("radius_m", Fields::length)?);
    Ok(Box::new(SphereLight {
        sphere: sphere.map_err(|error| fields.wrong("radius_m", error.to_string()))?,
        radiance: fields.need("radiance", Fields::light)?,
        choose: LightSampling::BySolidAngle,
    }))
}

fn point(fields: &Fields) -> Result<Box<dyn Light>, TextError> {
    Ok(Box::new(PointLight {
        position: fields.need("position_m", Fields::place)?,
        intensity: fields.need("intensity", Fields::light)?,
    }))
}

fn directional(fields: &Fields) -> Result<Box<dyn Light>, TextError> {
    Ok(Box::new(DirectionalLight {
        toward: fields.need("toward", Fields::direction)?,
        irradiance: fields.need("irradiance", Fields::light)?,
    }))
}

/// The corner of a rectangle and two edges, at right angles and none of them zero.
pub(crate) fn corner_and_edges(fields: &Fields) -> Result<[Vec3; 3], TextError> {
    /// The cosine that rounding may leave.
    const CROOKED: f32 = 1e-3;
    let corner = fields.need("corner_m", Fields::place)?;
    let a = fields.need("a_m", Fields::place)?;
    let b = fields.need("b_m", Fields::place)?;
    let (long, wide) = (a.length(), b.length());
    if !(long >= 1e-9 && wide >= 1e-9 && long <= LARGEST && wide <= LARGEST) {
        let message = format!("the edges `a_m` and `b_m` must be from 1e-9 to {LARGEST:e} m long");
        return Err(fields.wrong("a_m", message));
    }
    if (a / long).dot(b / wide).abs() > CROOKED {
        let message = "the edges `a_m` and `b_m` of a rectangle must be at right angles";
        return Err(fields.wrong("b_m", message));
    }
    Ok([corner, a, b])
}

/// Ambient light, the environment and the backdrop.
pub(crate) fn surroundings(fields: &Fields, scene: &mut Scene) -> Result<(), TextError> {
    scene.ambient = fields.light("ambient")?.unwrap_or(Rgb::BLACK);
    if let Some(environment) = fields.table("environment", "the environment")? {
        let scale = environment.light("scale")?.unwrap_or(Rgb::WHITE);
        let map = picture(&environment)?.map(|texel| texel * scale);
        environment.finish()?;
        scene.lights.push(Box::new(Environment::new(map)));
    }
    if let Some(backdrop) = fields.table("backdrop", "the backdrop")? {
        if backdrop.value("file").is_some() {
            scene.backdrop = Box::new(panorama(MipMap::new(&picture(&backdrop)?)));
        } else {
            let below = backdrop.light("below")?.unwrap_or(Rgb::BLACK);
            let horizon = backdrop.light("horizon")?.unwrap_or(Rgb::BLACK);
            let above = backdrop.light("above")?.unwrap_or(horizon);
            let exponent = backdrop.number("exponent", 0.01..=100.0)?.unwrap_or(1.0);
            scene.backdrop = Box::new(move |ray: &Ray| {
                let high = ray.direction.y;
                let end = if high < 0.0 { below } else { above };
                horizon.lerp(end, high.abs().powf(exponent))
            });
        }
        backdrop.finish()?;
    }
    Ok(())
}

/// The picture that the field `file` names.
pub(crate) fn picture(fields: &Fields) -> Result<Image, TextError> {
    let name = fields.need("file", Fields::text)?;
    fields.picture("file", name)
}
