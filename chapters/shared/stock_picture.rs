//! A picture of a stock scene, as its file says.

use crate::kit::stage::{Drawn, Stage};
use raybook::render::film::Film;
use raybook_scenes::gallery::Stock;

/// Draws a stock scene by the integrator and the sampler of its file. A filter that knows what the camera sees removes the noise that
/// is left. The PNG has the tone of the file.
///
/// # Errors
/// If the file is wrong, or the picture cannot be written.
pub fn draw(stage: &Stage, film: &Film, stock: Stock, name: &str, caption: &str) -> Drawn {
    let shot = stock.shot(film.width)?;
    let guides = film.guides(&*shot.camera, &shot.scene);
    let radiance = film.denoised(&guides, |film| shot.render(film));
    stage.developed(name, caption, &radiance, &shot.picture.developed(&radiance))
}
