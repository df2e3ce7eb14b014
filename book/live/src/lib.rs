//! The live picture of the book's chapter 24: the teapot in confetti, drawn in the reader's browser by the course's own library.
//!
//! The scene is the chapter's own file, and so are the colours and the sky. `book/theme/live.js` calls the functions here, with
//! numbers only: that is all that passes between a page and WebAssembly. A reference is the number of a place in memory.

#![warn(clippy::allow_attributes_without_reason, missing_debug_implementations)]
#![expect(
    unsafe_code,
    reason = "a page calls functions by their names, so these must be unmangled, and unlike all others in the module"
)]

#[path = "../../../chapters/ch24_wide_bvh/confetti.rs"]
mod confetti;
#[path = "../../../chapters/kit/okabe_ito.rs"]
mod okabe_ito;
#[expect(dead_code, reason = "of what is outdoors, only the sky is seen")]
#[path = "../../../chapters/shared/outdoors.rs"]
mod outdoors;

/// What the chapter's file calls `crate::kit`.
mod kit {
    pub(crate) use crate::okabe_ito;
}

/// What the chapter's file calls `crate::shared`.
mod shared {
    pub(crate) use crate::outdoors;
}

use confetti::{Confetti, EYE, MIDDLE};
use glam::vec3;
use raybook::accel::wide_bvh::{Kernel, WideBvh};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::{rgb::Rgb, tone};
use raybook::render::film::Film;
use raybook::sample::even::Even;
use std::fmt;

/// Pieces of confetti: as many as in the picture that the live one takes the place of.
const PIECES: u32 = 120_000;

/// The scene, and a picture of it that gets better with each sample.
pub struct Live {
    confetti: Confetti,
    tree: WideBvh,
    camera: Pinhole,
    film: Film<'static>,
    /// The sum of the samples of each pixel, row by row.
    light: Vec<Rgb>,
    /// The mean of the samples, as a page shows it: red, green, blue and opacity.
    shown: Vec<[u8; 4]>,
}

impl fmt::Debug for Live {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Live")
            .field("camera", &self.camera)
            .field("film", &self.film)
            .finish_non_exhaustive()
    }
}

/// The number of kernels; number 0 is the fastest one.
#[unsafe(no_mangle)]
pub extern "C" fn kernels() -> usize {
    Kernel::all().len()
}

/// Where the name of a kernel begins.
#[unsafe(no_mangle)]
pub extern "C" fn name(kernel: usize) -> *const u8 {
    Kernel::all()[kernel].name().as_ptr()
}

/// The length of the name of a kernel, in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn name_length(kernel: usize) -> usize {
    Kernel::all()[kernel].name().len()
}

/// The scene with its tree, which takes a moment; [`look`] begins its first picture.
#[unsafe(no_mangle)]
pub extern "C" fn build() -> Box<Live> {
    let confetti = Confetti::new(PIECES);
    Box::new(Live {
        tree: WideBvh::new(confetti.mesh.facets()),
        confetti,
        camera: confetti::camera(EYE, 1.0),
        film: Film::new(1, 1, 1),
        light: Vec::new(),
        shown: Vec::new(),
    })
}

/// The same scene and picture; the next rays are followed by another kernel.
#[unsafe(no_mangle)]
pub extern "C" fn with(live: Box<Live>, kernel: usize) -> Box<Live> {
    Box::new(Live {
        tree: live.tree.with(Kernel::all()[kernel]),
        ..*live
    })
}

/// Begins a picture of `width` × `height` pixels, for `samples` samples each. The camera of the chapter's picture is turned around
/// the teapot and raised, by angles in radians; returns by how much it was raised, for it stays above the floor, and never is upright.
#[unsafe(no_mangle)]
pub extern "C" fn look(
    live: &mut Live,
    width: usize,
    height: usize,
    samples: usize,
    turn: f32,
    rise: f32,
) -> f32 {
    let away = EYE - MIDDLE;
    let before = (away.y / away.length()).asin();
    let up = (before + rise).clamp(-0.05, 1.4);
    let (sin, cos) = (away.x.atan2(away.z) + turn).sin_cos();
    let eye = away.length() * vec3(up.cos() * sin, up.sin(), up.cos() * cos);
    live.film = Film::new(width, height, samples);
    live.camera = confetti::camera(MIDDLE + eye, live.film.aspect());
    live.light = vec![Rgb::BLACK; width * height];
    live.shown = vec![[0; 4]; width * height];
    up - before
}

/// Adds the sample of this number, from 0, to each pixel of some rows; returns the number of rays that were followed for it.
#[unsafe(no_mangle)]
pub extern "C" fn draw(live: &mut Live, sample: usize, top: usize, bottom: usize) -> u32 {
    let film = &live.film;
    let mut rays = 0;
    for y in top..bottom.min(film.height) {
        for x in 0..film.width {
            let mut numbers = Even::of_pixel(film.seed, [x, y], sample, film.samples);
            let place = film.place([x, y], numbers.pair());
            let ray = live.camera.central_ray(place);
            let seen = live.confetti.follow(&ray, &live.tree, 1, &mut numbers);
            rays += seen.rays as u32;
            let light = &mut live.light[y * film.width + x];
            *light += seen.radiance;
            let [r, g, b] = (*light / (sample + 1) as f32).channels().map(tone::to_byte);
            live.shown[y * film.width + x] = [r, g, b, u8::MAX];
        }
    }
    rays
}

/// Where the picture begins: four bytes a pixel, row by row.
#[unsafe(no_mangle)]
pub extern "C" fn shown(live: &Live) -> *const [u8; 4] {
    live.shown.as_ptr()
}
