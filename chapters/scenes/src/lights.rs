//! Lights, and what is around the scene.

use crate::fields::Fields;
use crate::wrong::TextError;
use glam::Vec3;
use raybook::image::{Image, file, mip::MipMap, rgb::Rgb};
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
    all.into_iter().map(light).collect()
}

fn light(mut fields: Fields) -> Result<Box<dyn Light>, TextError> {
    let kinds = ["rectangle", "sphere", "point", "directional"];
    let kind = fields.choice("kind", &kinds)?;
    let kind = fields.need("kind", kind)?;
    fields.named(format!("a light of the kind `{kind}`"));
    let place = |key: &'static str| fields.need(key, fields.place(key)?);
    let light = |key: &'static str| fields.need(key, fields.light(key)?);
    let light: Box<dyn Light> = match kind {
        "rectangle" => {
            let (corner, a, b) = (place("corner_m")?, place("a_m")?, place("b_m")?);
            square(&fields, a, b)?;
            Box::new(RectLight::new(corner, a, b, light("radiance")?))
        }
        "sphere" => {
            let radius = fields.number("radius_m", 1e-9..=LARGEST)?;
            let sphere = Sphere::checked(place("center_m")?, fields.need("radius_m", radius)?);
            Box::new(SphereLight {
                sphere: sphere.map_err(|error| fields.wrong("radius_m", error.to_string()))?,
                radiance: light("radiance")?,
                choose: LightSampling::BySolidAngle,
            })
        }
        "point" => Box::new(PointLight {
            position: place("position_m")?,
            intensity: light("intensity")?,
        }),
        _ => Box::new(DirectionalLight {
            toward: fields.need("toward", fields.direction("toward")?)?,
            irradiance: light("irradiance")?,
        }),
    };
    fields.finish()?;
    Ok(light)
}

/// Whether two edges are at right angles, and none of them is zero.
pub(crate) fn square(fields: &Fields, a: Vec3, b: Vec3) -> Result<(), TextError> {
    /// The cosine that rounding may leave.
    const CROOKED: f32 = 1e-3;
    let (long, wide) = (a.length(), b.length());
    if !(long >= 1e-9 && wide >= 1e-9 && long <= LARGEST && wide <= LARGEST) {
        let message = format!("the edges `a_m` and `b_m` must be from 1e-9 to {LARGEST:e} m long");
        return Err(fields.wrong("a_m", message));
    }
    if (a / long).dot(b / wide).abs() > CROOKED {
        let message = "the edges `a_m` and `b_m` of a rectangle must be at right angles";
        return Err(fields.wrong("b_m", message));
    }
    Ok(())
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
            scene.backdrop = Box::new(move |ray: &Ray| {
                let high = ray.direction.y;
                let end = if high < 0.0 { below } else { above };
                horizon.lerp(end, high.abs())
            });
        }
        backdrop.finish()?;
    }
    Ok(())
}

/// The picture that the field `file` names.
pub(crate) fn picture(fields: &Fields) -> Result<Image, TextError> {
    let name = fields.text("file")?;
    let name = fields.need("file", name)?;
    file::load(&fields.source().beside(name))
        .map_err(|error| fields.wrong("file", error.to_string()))
}
