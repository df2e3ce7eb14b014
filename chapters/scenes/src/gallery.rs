//! The stock scenes of the course: files of the gallery, which chapters draw and `raybook render` too.
//!
//! ```
//! use raybook_scenes::gallery::CORNELL;
//!
//! let shot = CORNELL.shot(64)?;
//! assert_eq!(shot.picture.aspect(), 1.0);
//! assert_eq!(shot.scene.lights.len(), 1);
//! # Ok::<(), raybook_scenes::wrong::TextError>(())
//! ```

use crate::fields::Pictures;
use crate::wrong::TextError;
use crate::{Shot, parse_with};
use raybook::light::Light;
use std::path::Path;

/// A scene file of the gallery that is part of the program, with the pictures that it names. It needs no other files.
#[derive(Clone, Copy, Debug)]
pub struct Stock {
    /// Its name, for error messages.
    name: &'static str,
    text: &'static str,
    pictures: Pictures,
}

/// The file of this name, with pictures.
macro_rules! stock {
    ($name:literal $(, $picture:literal)*) => {
        Stock {
            name: $name,
            text: include_str!(concat!("../gallery/", $name)),
            pictures: &[$(($picture, include_bytes!(concat!("../gallery/", $picture)))),*],
        }
    };
}

/// The Cornell box with a mirror ball and a glass ball: the caustic of chapter 17.
pub const CORNELL: Stock = stock!("cornell.toml");

/// A chequered plane to the horizon, with three balls: everything that aliases, for chapters 22 and 23.
pub const HORIZON: Stock = stock!("horizon.toml");

/// Marbles on a polished floor of a chessboard pattern, in the light of a lamp and the sun: chapters 13 and 15.
pub const MARBLES: Stock = stock!("marbles.toml");

/// Metals beside plastics, through a lens: chapter 18.
pub const METALS_AND_PLASTICS: Stock = stock!("metals_and_plastics.toml");

/// Posts, a table and a ball on a pale floor, of which some parts are near the floor and some are high above it: chapter 16.
pub const POSTS: Stock = stock!("posts.toml");

/// Three balls on a plinth, to compare lights: one is matte, one glossy, one of gold. Chapters 18 and 20 bring their own light.
pub const STILL_LIFE: Stock = stock!("still_life.toml");

/// A teapot with a picture and a normal map on it: chapter 7.
pub const TEAPOT: Stock = stock!("teapot.toml", "china.png", "hammered.png");

impl Stock {
    /// The scene, with a camera for a picture of this width in pixels.
    ///
    /// # Errors
    /// If the file is wrong.
    pub fn shot(&self, width: usize) -> Result<Shot, TextError> {
        self.with("", width)
    }

    /// The same under another light instead of the lights of the file.
    ///
    /// # Errors
    /// If the file is wrong.
    pub fn under(&self, light: Box<dyn Light>, width: usize) -> Result<Shot, TextError> {
        let mut shot = self.shot(width)?;
        shot.scene.lights = vec![light];
        Ok(shot)
    }

    /// The same with further tables at the end of the file.
    ///
    /// # Errors
    /// If the file or what follows is wrong.
    pub fn with(&self, more: &str, width: usize) -> Result<Shot, TextError> {
        let text = format!("{}{more}", self.text);
        parse_with(self.pictures, Path::new(self.name), &text, Some(width))
    }
}
