//! Shadow rays as they should not be.

use clap::ValueEnum;
use raybook::light::LightSample;
use raybook::math::interval::Interval;
use raybook::math::ray::Ray;
use raybook::render::local::Arrives;
use raybook::render::shadow;
use raybook::scene::world::Scene;
use raybook::shape::Surface;

/// How far off the surface a shadow ray starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Offset {
    /// A millimetre
    #[value(name = "1mm")]
    Millimetre,
    /// A centimetre
    #[value(name = "1cm")]
    Centimetre,
    /// Ten centimetres
    #[value(name = "10cm")]
    Decimetre,
    /// A metre
    #[value(name = "1m")]
    Metre,
}

/// The right shadow ray, and three wrong ones, of which one starts too far off.
pub(super) fn ways(offset: Offset) -> [(&'static str, Arrives); 4] {
    let loose: (_, Arrives) = match offset {
        Offset::Millimetre => ("starts a millimetre off", starts_off::<1>),
        Offset::Centimetre => ("starts a centimetre off", starts_off::<10>),
        Offset::Decimetre => ("starts 10 cm off: loose shadows", starts_off::<100>),
        Offset::Metre => ("starts a metre off: loose shadows", starts_off::<1000>),
    };
    [
        ("right", shadow::lit),
        ("starts on the surface: acne", starts_off::<0>),
        loose,
        ("does not end at the lamp", |scene, at, light| {
            let (ray, _) = shadow::shadow_ray(at, light);
            !scene.blocks(&ray, Interval::AHEAD)
        }),
    ]
}

/// A shadow ray from the computed point, which lies a little above or below the surface; its first millimetres do not count.
fn starts_off<const MILLIMETRES: u32>(scene: &Scene, at: &Surface, light: &LightSample) -> bool {
    let ray = Ray::new(at.position, light.toward);
    let off = MILLIMETRES as f32 / 1000.0;
    !scene.blocks(&ray, Interval::new(off, light.distance))
}
