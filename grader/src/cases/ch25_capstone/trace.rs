//! `trace`: its pictures, judge and mistakes.

use super::{random, trace_judge, trace_mistakes};
use raybook::camera::pinhole::Pinhole;
use crate::{Graded, Mistake, Picture, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook::scene::four_scenes::{ASPECT, FOUR};
use raybook_workbook::exercises::ch25_capstone::Trace;
use glam::{Vec3, vec2};

/// Columns and rows of each picture.
const SIZE: [u32; 2] = [72, 48];

/// The picture of scene number N.
const fn picture<const N: usize>() -> Picture<Trace> {
    Picture {
        name: FOUR[N].name,
        width: SIZE[0],
        height: SIZE[1],
        alt: FOUR[N].alt,
        question: pixel::<N>,
        colour: |_, radiance| *radiance,
    }
}

/// What the middle of a pixel of scene number N asks.
fn pixel<const N: usize>(x: u32, y: u32) -> Trace {
    let staged = &FOUR[N];
    let [from, to] = staged.view;
    let film = vec2(
        (x as f32 + 0.5) / SIZE[0] as f32,
        (y as f32 + 0.5) / SIZE[1] as f32,
    );
    let camera = Pinhole::look_at(from, to, Vec3::Y, staged.focal_length, ASPECT);
    Trace {
        depth: staged.depth,
        ray: camera.expect("a stage has a view").ray_through(film),
        scene: (staged.scene)(),
    }
}

impl Graded for Trace {
    /// A new ray that starts 1 mm off its surface must not decide an answer, and each ball that it is mirrored by multiplies the
    /// difference by ten. Of coordinates of a metre these are 1 to 2 mm.
    const ULPS: i32 = 1 << 14;

    const PICTURES: &'static [Picture<Self>] = &[
        picture::<0>(),
        picture::<1>(),
        picture::<2>(),
        picture::<3>(),
    ];

    const MISTAKES: &'static [Mistake<Self>] = trace_mistakes::MISTAKES;

    fn random(rng: &mut Pcg) -> Trace {
        random::random(rng)
    }

    fn judge(q: &Trace, golden: &Rgb, got: &Rgb) -> Verdict {
        trace_judge::judge(q, golden, got)
    }
}
