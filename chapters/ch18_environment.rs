//! # Environment
//!
//! Light from all around, kept in a picture of all directions: every pixel of it is a light, and the bright ones are asked
//! more often.
//!
//! New: math/piecewise.rs light/environment/mod.rs light/environment/latlong.rs light/environment/cube.rs
//! New: light/environment/angular.rs light/environment/convert.rs scene/skies.rs scene/still_life.rs

use raybook::image::{Image, file};
use raybook::lab::environments::{Layouts, layouts, quarters};
use raybook::lab::stage::{Drawn, Stage};
use raybook::lab::{chapter, everywhere::Everywhere, sheet::sheet};
use raybook::light::{Light, environment::Environment};
use raybook::render::{film::Film, mis::Strategy, path::Path};
use raybook::scene::skies::{self, Sky};
use raybook::scene::still_life::{camera, still_life};
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
struct MapOptions {
    /// Light the scene with this map (.exr, .hdr or .png) instead of the four skies
    #[arg(long)]
    environment: Option<PathBuf>,
    /// How the directions lie on it
    #[arg(long, value_enum, default_value = "latlong", requires = "environment")]
    layout: Layouts,
}

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let film = stage.film_of(960, 48, 1.6);
    let small = stage.film_of((film.width / 2) as u32, 48, 1.6);
    let four: [Sky; 4] = [
        skies::clear_day,
        skies::sunset,
        skies::overcast,
        skies::studio,
    ];
    let lit = four.map(|sky| {
        let map = Environment::new(skies::map(sky, 1024));
        picture(&small, Box::new(map))
    });
    let caption = "Nothing shines here but the map: a clear day, a sunset, an overcast sky, a studio with two softboxes.";
    stage.picture("picture", caption, &quarters(&lit))?;

    let day = skies::map(skies::clear_day, 1024);
    let caption = "The clear day in three layouts: latitude and longitude, a cube unfolded to a cross, and the angular map.";
    stage.figure("layouts", caption, &layouts(&day)?)?;

    let few = Film {
        samples: 16,
        ..small
    };
    let uniform = Box::new(Everywhere(Environment::new(day.clone())));
    let tiles = [
        ("16 directions, uniform", picture(&few, uniform)),
        (
            "16 directions, by their light",
            picture(&few, Box::new(Environment::new(day))),
        ),
    ];
    let caption = "Equally many samples of the clear day. Half of the light comes from a sun that uniform directions hardly ever meet.";
    stage.figure("importance", caption, &sheet(2, &tiles)?)
}

/// The still life under one light.
fn picture(film: &Film, light: Box<dyn Light>) -> Image {
    let (scene, camera) = (still_life(light), camera(film.aspect()));
    let path = Path {
        depth: 6,
        sure: 3,
        strategy: Strategy::Both,
    };
    film.render(|place, rng| path.radiance(&scene, &camera.ray_through(place), rng))
}

fn main() -> ExitCode {
    chapter::run_with("ch18_environment", |stage, options: MapOptions| {
        let Some(file) = options.environment else {
            return draw(stage);
        };
        let light = Box::new(Environment::new(options.layout.unfold(&file::load(&file)?)));
        let film = stage.film_of(960, 64, 1.6);
        let caption = format!("Nothing shines here but {}.", file.display());
        stage.picture("picture", &caption, &picture(&film, light))
    })
}
