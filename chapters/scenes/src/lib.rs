//! Scene files: a scene, its camera and how it is rendered, as a text that people write. The book's page "Scene files" describes
//! the format; `raybook render` draws them.
//!
//! ```
//! use raybook::{image::rgb::Rgb, render::film::Film};
//!
//! let text = r#"
//!     [camera]
//!     from_m = [0, 0, 5]
//!     to_m = [0, 0, 0]
//!
//!     [[shapes]]
//!     kind = "sphere"
//!     center_m = [0, 0, 0]
//!     radius_m = 1
//!     material = { kind = "glowing", radiance = 0.5 }
//! "#;
//! let shot = raybook_scenes::parse("ball.toml".as_ref(), text, Some(8))?;
//! let picture = shot.render(&Film::new(8, 6, 1));
//! assert_eq!([picture.at(4, 3), picture.at(0, 0)], [Rgb::gray(0.5), Rgb::BLACK]);
//! # Ok::<(), raybook_scenes::wrong::TextError>(())
//! ```

mod camera;
pub mod fields;
pub mod gallery;
mod lights;
mod materials;
pub mod rendering;
mod shapes;
pub mod values;
pub mod wrong;

use fields::{Fields, Pictures};
use raybook::camera::Camera;
use raybook::image::Image;
use raybook::render::film::Film;
use raybook::scene::world::Scene;
use raybook::store::{self, StoreError};
use rendering::{Picture, Rendering};
use std::fmt;
use std::io;
use std::path::Path;
use wrong::{Source, TextError};

/// The longest scene file, in bytes; meshes and pictures have files of their own.
pub const LONGEST: usize = 1 << 24;

/// A scene, and everything that is needed to take its picture.
pub struct Shot {
    /// The scene.
    pub scene: Scene,
    /// The camera, for a picture of the size in the file.
    pub camera: Box<dyn Camera>,
    /// Integrator and sampler.
    pub rendering: Rendering,
    /// The picture's size, samples and exposure.
    pub picture: Picture,
    /// What files of the scene describe and the scene does not have.
    pub remarks: Vec<String>,
}

impl fmt::Debug for Shot {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Shot")
            .field("scene", &self.scene)
            .field("rendering", &self.rendering)
            .field("picture", &self.picture)
            .finish_non_exhaustive()
    }
}

impl Shot {
    /// The radiance of the picture, by the file's filter, on a film which has the number of samples and the callback for the progress.
    pub fn render(&self, film: &Film) -> Image {
        let Rendering {
            sampler,
            integrator,
        } = &self.rendering;
        let film = Film {
            filter: self.picture.filter,
            ..*film
        };
        film.render(&*self.camera, sampler, &**integrator, &self.scene)
    }
}

/// Reads a scene file, and the meshes and pictures that it names; their places are relative to the scene file.
///
/// `width` is the width of the picture in pixels, if it differs from the width in the file; the height follows.
///
/// # Errors
/// If a file cannot be read, or is wrong; where and why.
pub fn load(path: &Path, width: Option<usize>) -> Result<Shot, TextError> {
    let text = store::read_text(path)?;
    if text.len() > LONGEST {
        let reason = format!("it has more than {LONGEST} bytes; keep meshes in files of their own");
        let failed = StoreError::of(path, "read this scene");
        return Err(failed(io::Error::new(io::ErrorKind::FileTooLarge, reason)).into());
    }
    parse(path, &text, width)
}

/// The scene of a text; `path` is the file of the text, to find other files and for error messages.
///
/// # Errors
/// Those of [`load`].
pub fn parse(path: &Path, text: &str, width: Option<usize>) -> Result<Shot, TextError> {
    parse_with(&[], path, text, width)
}

/// As [`parse`], with pictures that need no files.
pub(crate) fn parse_with(
    pictures: Pictures,
    path: &Path,
    text: &str,
    width: Option<usize>,
) -> Result<Shot, TextError> {
    let source = Source { path, text };
    let table = source.parse()?;
    let fields = Fields::new(source, "a scene", 0, table.get_ref()).with_pictures(pictures);
    let mut picture = rendering::picture(fields.table("picture", "the picture")?)?;
    if let Some(width) = width {
        picture = picture.of_width(width);
    }
    let camera = fields.need("camera", |fields, key| fields.table(key, "the camera"))?;
    let camera = camera::camera(camera, picture.aspect())?;
    let rendering = rendering::rendering(&fields)?;
    let materials = materials::Materials::of(fields.table("materials", "the materials")?)?;
    let (things, remarks) = shapes::things(fields.tables("shapes", "a shape")?, &materials)?;
    let lights = lights::lights(fields.tables("lights", "a light")?)?;
    let mut scene = Scene::new(things, lights);
    lights::surroundings(&fields, &mut scene)?;
    fields.finish()?;
    Ok(Shot {
        scene,
        camera,
        rendering,
        picture,
        remarks,
    })
}
