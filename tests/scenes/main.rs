//! Scene files: what they say is what is drawn, what is wrong is said with its place, and nothing makes the reader panic.

mod broken;
mod drawn;
mod fuzz;
mod page;
mod shared;

use raybook_common::counting::Counting;
use raybook_scenes::Shot;
use raybook_scenes::wrong::TextError;
use std::path::Path;

#[global_allocator]
static COUNTING: Counting = Counting;

/// The scene of a text; meshes and pictures would be in the gallery.
fn parse(text: &str) -> Result<Shot, TextError> {
    let path = raybook_common::project("chapters/scenes/gallery").join("test.toml");
    raybook_scenes::parse(&path, text, None)
}

/// The error of a text, without the folder.
fn error(text: &str) -> String {
    let error = parse(text)
        .err()
        .unwrap_or_else(|| panic!("this is a scene:\n{text}"));
    let folder = raybook_common::project("chapters/scenes/gallery");
    let error = error.to_string();
    error.replace(&format!("{}/", Path::new(&folder).display()), "")
}

/// A camera that looks along −z from 5 m.
const CAMERA: &str = "[camera]\nfrom_m = [0, 0, 5]\nto_m = [0, 0, 0]\n";
