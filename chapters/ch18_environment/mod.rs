//! Light from all around, kept in a picture of all directions: every pixel of the picture is a light, and bright pixels are
//! sampled more often.
//!
//! New: math/piecewise.rs light/environment/mod.rs light/environment/latlong.rs light/environment/cube.rs
//! New: light/environment/angular.rs light/environment/convert.rs

mod environments;
mod letters;
mod metals;
pub mod skies;
pub mod uniform_environment;

use crate::kit::chapter;
use crate::kit::plate;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use crate::kit::untrusted::Untrusted;
use crate::shared::stock_picture;
use clap::Args;
use environments::{DIRECTIONS, Layouts, layouts, quarters};
use raybook::image::denoise::Guide;
use raybook::image::{Image, file, tone};
use raybook::light::environment::Environment;
use raybook::render::film::Film;
use raybook::render::mis::Strategy;
use raybook::render::path::Path;
use raybook::render::sampler::Sampler;
use raybook_scenes::wrong::TextError;
use raybook_scenes::{Shot, gallery};
use skies::Sky;
use std::path::PathBuf;
use std::process::ExitCode;
use uniform_environment::UniformEnvironment;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Light the scene with this map (.exr, .hdr or .png) instead of the four skies
    #[arg(long, value_name = "FILE", visible_alias = "map")]
    environment: Option<PathBuf>,
    /// Layout of the map: how directions are placed on it
    #[arg(long, value_enum, default_value = "latlong", requires = "environment")]
    layout: Layouts,
    /// Roughness α of the metals in the lowest row, in `metals`
    #[arg(long, value_name = "0.01..1", default_value = "0.45")]
    roughness: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    if let Some(file) = &knobs.environment {
        if !stage.wants("picture") {
            return Ok(());
        }
        let map = knobs.layout.unfold(&file::load(file)?);
        let film = stage.film_of(960, 64, 1.6);
        let caption = format!(
            "All light comes from the map {}.",
            Untrusted::from(file.as_path())
        );
        let picture = denoised(&film, &guides(&film)?, map)?;
        return stage.picture("picture", &caption, &picture);
    }
    let tile = stage.tile(2, 1.6);
    let maps = skies::FOUR.map(|sky| skies::map(sky, 512));
    let [day, sunset, overcast, studio] = &maps;
    if stage.wants("picture") {
        let guides = guides(&tile)?;
        let under = |sky: Sky, map: &Image| {
            let lit = denoised(&tile, &guides, map.clone())?;
            before(&tile, sky, map, &lit)
        };
        let lit = [
            under(skies::clear_day, day)?,
            under(skies::sunset, sunset)?,
            under(skies::overcast, overcast)?,
            under(skies::studio, studio)?,
        ];
        let caption = "All light comes from the map: a clear day, a sunset, an overcast sky, a studio with two softboxes. A \
            filter has removed the remaining noise.";
        stage.picture("picture", caption, &quarters(&lit))?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("layouts") {
        let caption = "The clear day in three layouts: latitude and longitude, a cube unfolded to a cross, and the angular map.";
        stage.figure("layouts", caption, &layouts(day)?)?;
    }

    if stage.wants("chosen") {
        let (chosen, in_the_sun) = environments::chosen(day)?;
        let caption = format!(
            "{DIRECTIONS} directions of the clear day, chosen uniformly on the left and by their light on the right. On the right, \
            {in_the_sun} of them lie in the sun: they look like one dot, because the sun is so small."
        );
        stage.figure("chosen", &caption, &chosen)?;
    }

    if stage.wants("metals") {
        let film = stage.film_of(520, 8, 4.0 / 3.0);
        let light = Box::new(Environment::new(studio.clone()));
        let metals = metals::draw(&film, light, knobs.roughness)?;
        let caption = format!(
            "Gold, copper, silver and aluminium. Top row: smooth. Rows below: rough, with a roughness α of 0.15 and of {0}. In this \
            model, rough silver with α = {0} reflects {1:.0} % of the light that smooth silver reflects.",
            knobs.roughness,
            100.0 * metals::kept(knobs.roughness)
        );
        let tiles = metals::named(&metals.map(tone::aces), knobs.roughness);
        stage.figure("metals", &caption, &sheet(4, &tiles)?)?;
    }

    if stage.wants("plastics") {
        let caption = "Behind, gold, rough copper and rough aluminium; in front, red plastic, matte green paint and blue plastic. A metal \
            gives its own colour to what it reflects. Plastic does not: the image of the window in red plastic is white.";
        let film = stage.film_of(420, 12, 2.0);
        let stock = gallery::METALS_AND_PLASTICS;
        stock_picture::draw(stage, &film, stock, "plastics", caption)?;
    }

    if !stage.wants("importance") {
        return Ok(());
    }
    let few = tile.halved();
    let uniform = Box::new(UniformEnvironment(Environment::new(day.clone())));
    let by_light = Box::new(Environment::new(day.clone()));
    let picture = |light| {
        let lit = photograph(&few, &gallery::STILL_LIFE.under(light, few.width)?);
        before(&few, skies::clear_day, day, &lit)
    };
    let tiles = [
        ("uniform directions", picture(uniform)?),
        ("directions by their light", picture(by_light)?),
    ];
    let caption = "The clear day with the same number of samples. More than half of the light on level ground comes from the \
        sun, which uniform directions hardly ever meet.";
    stage.figure("importance", caption, &sheet(2, &tiles)?)
}

/// A picture of the still life in the light of a map, with the sky of which the map is made behind it: a texel of the map is as large
/// as many pixels.
fn before(film: &Film, sky: Sky, map: &Image, lit: &Image) -> Result<Image, TextError> {
    let view = gallery::STILL_LIFE.shot(film.width)?;
    let map = Environment::new(map.clone());
    // Sky and map are similar, so few samples hide the seam.
    let few = film.halved().halved();
    let open = plate::open(&few, &*view.camera, &view.scene);
    let seen = plate::surroundings(&few, &*view.camera, |toward| map.radiance(toward));
    let sky = plate::surroundings(&few, &*view.camera, sky);
    Ok(plate::before(&sky, &seen, &open, lit))
}

/// What the camera sees, which is the same under every light.
fn guides(film: &Film) -> Result<Vec<Guide>, TextError> {
    let view = gallery::STILL_LIFE.shot(film.width)?;
    Ok(film.guides(&*view.camera, &view.scene))
}

/// The still life in the light of a map, denoised by a filter that knows what the camera sees.
fn denoised(film: &Film, guides: &[Guide], map: Image) -> Result<Image, TextError> {
    let view = gallery::STILL_LIFE.under(Box::new(Environment::new(map)), film.width)?;
    Ok(film.denoised(guides, |film| photograph(film, &view)))
}

fn photograph(film: &Film, view: &Shot) -> Image {
    let path = Path {
        depth: 6,
        roulette_after: 3,
        strategy: Strategy::Both,
    };
    film.render(&*view.camera, &Sampler::Even, &path, &view.scene)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch18_environment")
}
