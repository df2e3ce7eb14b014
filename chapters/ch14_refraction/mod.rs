//! Glass shows what is in front of the glass and what is behind the glass. Snell's law says where the second ray goes, Fresnel's
//! equations how much light takes which way, and every surface knows the media on both of its sides.
//!
//! New: material/refract.rs material/fresnel.rs material/glass.rs material/dispersion.rs image/spectrum.rs

mod fresnel_plot;
pub mod glassware;
mod letters;
mod parts;
pub mod prism;
mod refraction_fan;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::Args;
use glam::{Vec3, vec3};
use glassware::Stuff;
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::image::Image;
use raybook::render::film::Film;
use raybook::render::local::{Local, NO_SHADOWS};
use raybook::render::sampler::Sampler;
use raybook::render::whitted::Whitted;
use raybook::scene::world::Scene;
use std::process::ExitCode;

/// Where a camera stands, where it looks, and its focal length.
type View = (Vec3, Vec3, f32);

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Index of refraction of the glass; diamond has 2.42
    #[arg(long, value_name = "1..3", default_value = "1.5")]
    index: f32,
    /// Index of refraction of the liquid in the tank; water has 1.333, and some oils have that of glass
    #[arg(long, value_name = "1..3", default_value = "1.333")]
    liquid: f32,
    /// Absorption of the coloured glass, as a multiple of the default
    #[arg(long, value_name = "0..20 ×", default_value = "1")]
    absorption: f32,
    /// Maximum depth: number of surfaces that are followed in a row
    #[arg(long, value_name = "1..64 surfaces", default_value = "12")]
    depth: u32,
    /// Angle at the top of the prisms, in `prism`
    #[arg(long, value_name = "20..65 °", default_value = "60")]
    apex: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let depth = knobs.depth;
    let stuff = Stuff {
        index: knobs.index,
        liquid: knobs.liquid,
        absorption: knobs.absorption,
    };
    let scene = glassware::still_life(stuff);
    let film = stage.film_of(960, 9, 16.0 / 9.0);
    if stage.wants("picture") {
        let picture = photograph(&film, &scene, glassware::VIEW, depth)?;
        let caption = format!(
            "From the left, a ball with a large bubble of air, a solid ball of glass and a ball in a tank; in front, three balls of \
            coloured glass. The glass has an index of refraction of {}, the liquid of {}. With an index of 1.5, a solid ball in \
            air shows the floor upside down; with the index of what is around it, a ball bends no ray.",
            knobs.index, knobs.liquid
        );
        stage.picture("picture", &caption, &picture)?;
    }

    draw_surface(stage, knobs.index)?;

    if stage.wants("prism") {
        let caption = "White light from a slit through a prism of crown glass and through one of flint glass, calculated for 150 \
            wavelengths. Each wavelength has its own index of refraction, so each leaves in its own direction. Flint glass \
            refracts more than crown glass, and spreads the colours farther.";
        stage.figure(
            "prism",
            caption,
            &prism::prisms(&stage.tile(2, 1.5), knobs.apex)?,
        )?;
    }

    let small = |columns, aspect| Film {
        samples: film.samples,
        ..stage.tile(columns, aspect)
    };
    let tile = small(4, 1.0);
    let close = (vec3(0.0, 3.0, 5.0), vec3(0.0, 0.9, 0.0), 0.043);
    if stage.wants("nested") {
        let mut tiles = Vec::new();
        for (name, scene) in glassware::nested(stuff) {
            tiles.push((name, photograph(&tile, &scene, close, depth)?));
        }
        let caption = format!(
            "A surface has a medium on either side, and the ratio of their indices bends a ray. The glass has an index of {}. In \
            the liquid of index {}, the ratio at a ball of glass is {:.2}. If the program takes the liquid for air, the ratio is \
            {0}.",
            knobs.index,
            knobs.liquid,
            knobs.index / knobs.liquid
        );
        stage.figure("nested", &caption, &sheet(4, &tiles)?)?;
    }

    if stage.wants("depth") {
        let [(_, ball), ..] = glassware::nested(stuff);
        let mut tiles = Vec::new();
        for (name, depth) in [("1 surface", 1), ("2", 2), ("3", 3), ("5", 5)] {
            tiles.push((name, photograph(&tile, &ball, close, depth)?));
        }
        let caption = "A ball of glass, with rays that end at the first, second, third and fifth surface: the light of further \
            surfaces is missing, and black.";
        stage.figure("depth", caption, &sheet(4, &tiles)?)?;
    }

    if !stage.wants("absorption") {
        return Ok(());
    }
    let view = (vec3(0.5, 5.6, 8.6), vec3(0.5, 1.15, -0.2), 0.041);
    let sizes = photograph(&small(1, 2.4), &glassware::sizes(stuff), view, depth)?;
    let caption = "The same green glass in balls of 40 cm to 3.2 m diameter. On a way twice as long, the fraction of light that \
        is left is squared.";
    stage.picture("absorption", caption, &sizes)
}

/// Draws what a surface of glass does with light.
fn draw_surface(stage: &Stage, index: f32) -> Drawn {
    stage.drawing("letters", letters::CAPTION, || letters::draw(index))?;
    if stage.wants("parts") {
        stage.diagram("parts", &parts::caption(index), &parts::diagram(index)?)?;
    }

    // Beyond this angle, in degrees, no light leaves the glass; into glass of index 1, all light goes straight on.
    let critical = (index > 1.0).then(|| (1.0 / index).asin().to_degrees());
    let (leaves, reflected) = match critical {
        Some(angle) => (
            format!("Out of glass, nothing goes through beyond {angle:.1}°."),
            "At Brewster's angle, light that is polarised parallel to the plane of incidence is not reflected at all. Beyond the \
            critical angle, all light is reflected.",
        ),
        None => (
            "This index is that of air: nothing is reflected.".to_owned(),
            "This index is that of air: nothing is reflected, at any angle; here Schlick's approximation fails.",
        ),
    };
    if stage.wants("beams") {
        let caption = format!(
            "Beams into glass and out of glass with an index of refraction of {index}. The width of a beam is its share of the \
            light. The reflected light is vermilion, and the light that goes through is blue. {leaves}"
        );
        stage.diagram("beams", &caption, &refraction_fan::diagram(index)?)?;
    }
    if stage.wants("fresnel") {
        let caption = format!(
            "The fraction of the light that is reflected by glass with an index of refraction of {index}, against the angle to the \
            normal. {reflected}"
        );
        stage.diagram("fresnel", &caption, &fresnel_plot::plot(index)?)?;
    }
    Ok(())
}

/// A picture by Whitted's ray tracing, without shadows.
fn photograph(
    film: &Film,
    scene: &Scene,
    (from, to, focal_length): View,
    depth: u32,
) -> Result<Image, LookAtError> {
    let camera = Pinhole::look_at(from, to, Vec3::Y, focal_length, film.aspect())?;
    let local = Local {
        samples: 1,
        arrives: NO_SHADOWS,
    };
    let whitted = Whitted { local, depth };
    Ok(film.render(&camera, &Sampler::Refined, &whitted, scene))
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch14_refraction")
}
