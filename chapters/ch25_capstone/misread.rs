//! What a wrong ray tracer shows: some mistakes are the same as a change of the scene, here for the four scenes.

use crate::kit::{palette, sheet};
use raybook::camera::pinhole::LookAtError;
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use raybook::image::rms::rms;
use raybook::scene::description::{Description, Matter};
use raybook::scene::four_scenes::{FOUR, Staged};
use std::error::Error;

/// A mistake.
struct Misread {
    /// What the wrong ray tracer does.
    name: &'static str,
    /// The number of the scene in which the mistake is seen best.
    scene: usize,
    /// Changes the scene and its depth so that a correct ray tracer draws the same wrong picture.
    how: fn(&mut Description, &mut u32),
}

/// One for each scene.
const MISREAD: [Misread; 4] = [
    Misread {
        name: "ambient light forgotten",
        scene: 0,
        how: |scene, _| scene.ambient = Rgb::BLACK,
    },
    Misread {
        name: "first lamp only",
        scene: 1,
        how: |scene, _| scene.lamps.truncate(1),
    },
    Misread {
        name: "depth of 2, not 5",
        scene: 2,
        how: |_, depth| *depth = 2,
    },
    Misread {
        name: "index turned round",
        scene: 3,
        how: |scene, _| {
            for object in &mut scene.objects {
                if let Matter::Glass(clear) = &mut object.matter {
                    clear.index = 1.0 / clear.index;
                }
            }
        },
    },
];

/// Takes a picture of a scene with a maximum number of surfaces in a row, by the camera of this stage.
pub(super) type Photograph<'a> =
    dyn Fn(&Staged, &Description, u32) -> Result<Image, LookAtError> + 'a;

/// A row for each mistake: the right picture, the wrong one with its error, and the difference.
///
/// # Errors
/// If a picture cannot be taken or a caption drawn.
pub(super) fn sheet(photograph: &Photograph) -> Result<Image, Box<dyn Error>> {
    let mut tiles = Vec::new();
    for misread in &MISREAD {
        let staged = &FOUR[misread.scene];
        let (mut scene, mut depth) = ((staged.scene)(), staged.depth);
        let right = photograph(staged, &scene, depth)?;
        (misread.how)(&mut scene, &mut depth);
        let wrong = photograph(staged, &scene, depth)?;
        let error = rms(&right, &wrong, |_, _| true);
        let difference = Image::from_fn(right.width(), right.height(), |x, y| {
            palette::signed(wrong.at(x, y).luminance() - right.at(x, y).luminance())
        });
        tiles.extend([
            (staged.name.to_owned(), right),
            (format!("{}: {error:.3}", misread.name), wrong),
            ("difference".to_owned(), difference),
        ]);
    }
    sheet::sheet(3, &tiles)
}
