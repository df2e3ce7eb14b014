//! # Depth of field
//!
//! A lens gathers light with all of its opening, and unites it again for one distance only. What is nearer or farther becomes
//! a blurred disc, whose size a formula tells.
//!
//! New: sample/disk.rs sample/polygon.rs camera/aperture.rs camera/lens.rs camera/thin_lens.rs
//! New: render/through_lens.rs render/glints.rs scene/tea_table.rs

use glam::{Vec3, vec2};
use rand::RngExt;
use raybook::camera::{Camera, aperture::Aperture, pinhole::Pinhole, thin_lens::ThinLens};
use raybook::image::Image;
use raybook::lab::stage::{Drawn, Stage};
use raybook::lab::{blur_plot, chapter, sheet::sheet};
use raybook::math::interval::Interval;
use raybook::render::{film::Film, glints::add_glints, local::Local, shadow};
use raybook::render::{through_lens::through_lens, whitted::Whitted};
use raybook::scene::tea_table::{POTS, VIEW, dusk, lamps, tea_table};
use std::error::Error;
use std::process::ExitCode;

/// A hexagon with a flat side below.
const SIX_BLADES: Aperture = Aperture::Blades {
    count: 6,
    turn: 0.0,
};

const WHITTED: Whitted = Whitted {
    local: Local {
        samples: 1,
        arrives: shadow::lit,
    },
    depth: 2,
};

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let scene = tea_table();
    let see = |ray: &_, rng: &mut _| WHITTED.radiance(&scene, ray, rng);
    let open = |ray: &_, distance| !scene.blocks(ray, Interval::new(0.0, distance));
    let photograph = |film: &Film, camera: &ThinLens| {
        let mut picture = through_lens(film, camera, see);
        add_glints(&mut picture, film, camera, &lamps(), open);
        picture
    };

    let film = stage.film_of(960, 40, 16.0 / 9.0);
    let camera = focused(&film, 1, 1.4, SIX_BLADES)?;
    let caption = "A lens of 50 mm at f/1.4, focused on the red teapot. What is nearer or farther is blurred, and each lamp becomes a hexagon: the shape that six blades leave open.";
    stage.picture("picture", caption, &photograph(&film, &camera))?;

    let tile = stage.tile(3, 1.6);
    let with = |samples| Film { samples, ..tile };
    let by_chance = |samples| {
        with(samples).render(|place, rng| {
            let ray = camera.ray(place, vec2(rng.random(), rng.random()));
            see(&ray, rng)
        })
    };
    let tiles = [
        ("4 samples", by_chance(4)),
        (
            "4 samples, spread evenly",
            through_lens(&with(4), &camera, see),
        ),
        ("128 samples", by_chance(128)),
    ];
    let caption = "Few random points of the lens leave noise where the picture is blurred, and only there. Four that are spread evenly over the lens leave less.";
    stage.figure("samples", caption, &sheet(3, &tiles)?)?;

    let tile = stage.tile(3, 1.6);
    let film = Film {
        samples: tile.samples.min(32),
        ..tile
    };
    let mut tiles = Vec::new();
    for (name, f_number) in [("a pin-hole", f32::INFINITY), ("f/8", 8.0), ("f/2", 2.0)] {
        tiles.push((
            name,
            photograph(&film, &focused(&film, 1, f_number, SIX_BLADES)?),
        ));
    }
    let caption = "The smaller the aperture, the less is blurred. The noise of lamps?";
    stage.figure("apertures", caption, &sheet(3, &tiles)?)?;
    let caption = "blur";
    stage.figure("blur", caption, &blur_plot::plot()?)
}

/// The camera at the table, focused on a teapot.
fn focused(
    film: &Film,
    pot: usize,
    f_number: f32,
    aperture: Aperture,
) -> Result<ThinLens, Box<dyn Error>> {
    let (eye, at, focal_length) = VIEW;
    let body = Pinhole::look_at(eye, at, Vec3::Y, focal_length, film.aspect())?;
    let focus = (POTS[pot] - eye).dot(*body.forward);
    Ok(ThinLens::new(&body, f_number, focus, aperture)?)
}

fn main() -> ExitCode {
    chapter::run("ch19_depth_of_field", draw)
}
