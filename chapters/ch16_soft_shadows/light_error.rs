//! How the error of a light's estimate shrinks as samples are added.

use crate::kit::axis::Axis;
use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::{Canvas, Figure, figure};
use crate::kit::of_each::of_each;
use crate::kit::palette::{BLUE, FAINT, VERMILION};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2, vec3};
use plotters::prelude::Color;
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::light::Light;
use raybook::light::extent::LightSampling;
use raybook::light::rect_light::RectLight;
use raybook::math::interval::Interval;
use raybook::math::pcg;
use raybook::math::pcg::Pcg;
use raybook::math::ray::Ray;
use raybook::shape::Shape;
use raybook::shape::sphere::Sphere;

/// Number of estimates from which each error is measured.
pub(super) const REPEATS: u32 = 300;

/// The numbers of samples, as powers of 2.
const POWERS: std::ops::RangeInclusive<u32> = 0..=10;

/// A light, and a ball that may be in its way.
#[derive(Debug)]
pub struct Setting {
    light: RectLight,
    ball: Sphere,
}

impl Setting {
    /// A square light with a side of 2 m, 1.2 m above the floor, seen from below its edge, with nothing in the way.
    pub fn open() -> Self {
        Self {
            light: RectLight::new(
                vec3(-1.9, 1.2, -1.0),
                2.0 * Vec3::X,
                2.0 * Vec3::Z,
                Rgb::WHITE,
            ),
            ball: Sphere::new(vec3(9.0, 0.0, 0.0), 0.1),
        }
    }

    /// The same square 4 m above, half of it behind a ball.
    pub fn shaded() -> Self {
        Self {
            light: RectLight::new(
                vec3(-1.0, 4.0, -1.0),
                2.0 * Vec3::X,
                2.0 * Vec3::Z,
                Rgb::WHITE,
            ),
            ball: Sphere::new(vec3(-1.0, 2.0, 0.0), 1.0),
        }
    }

    /// The contribution of a sample to the floor, in W/m²; its mean over u is the irradiance.
    fn arrives(&self, choose: LightSampling, u: Vec2) -> f64 {
        let Some(sample) = self.light.choosing(choose).sample(Vec3::ZERO, u) else {
            return 0.0;
        };
        let way = Interval::new(0.0, sample.distance);
        if self.ball.blocks(&Ray::new(Vec3::ZERO, sample.toward), way) {
            return 0.0;
        }
        f64::from(sample.arriving.g * sample.toward.y.max(0.0))
    }

    /// The irradiance, by a lattice of a million points.
    pub fn exact(&self) -> f64 {
        let n = 1000;
        let place = |i: u32| (vec2((i % n) as f32, (i / n) as f32) + 0.5) / n as f32;
        let arrives = |i| self.arrives(LightSampling::BySolidAngle, place(i));
        let row = |i| -> Vec<f64> { (0..n).map(|j| arrives(i * n + j)).collect() };
        let rows = of_each(n as usize, |i| row(i as u32));
        rows.iter().flatten().sum::<f64>() / f64::from(n * n)
    }

    /// The root of the mean square error of an estimate by `samples` samples, relative to the exact value.
    pub fn error(&self, choose: LightSampling, samples: u32, exact: f64, rng: &mut Pcg) -> f64 {
        // Drawn one after the other, and then used by all processors: the points do not depend on their number.
        let draw = |_| vec2(rng.random(), rng.random());
        let points: Vec<Vec2> = (0..REPEATS * samples).map(draw).collect();
        let square = |points: &[Vec2]| {
            let sum: f64 = points.iter().map(|&u| self.arrives(choose, u)).sum();
            (sum / f64::from(samples) / exact - 1.0).powi(2)
        };
        let sets: Vec<_> = points.chunks(samples as usize).collect();
        // A sum in another order would be rounded otherwise.
        let squares = of_each(sets.len(), |i| square(sets[i]));
        (squares.iter().sum::<f64>() / f64::from(REPEATS)).sqrt()
    }
}

/// Error against samples, both axes logarithmic: in full view of a light close by, and half in its shadow.
///
/// # Errors
/// If plotters cannot draw.
pub fn plot() -> Figure {
    figure(1000, 460, |canvas| {
        let (open, shaded) = canvas.split_horizontally(1000);
        panel(
            &open,
            "the whole of a near light is seen",
            &Setting::open(),
            false,
        )?;
        panel(
            &shaded,
            "half of a light is behind a ball",
            &Setting::shaded(),
            true,
        )
    })
}

fn panel(canvas: &Canvas, title: &str, setting: &Setting, legend: bool) -> Drawn {
    let samples = Axis::log2(1.0..1024.0)
        .named("samples")
        .marks(&[1.0, 4.0, 16.0, 64.0, 256.0, 1024.0]);
    let errors = Axis::log(0.003..2.0)
        .named("error")
        .format(|error| format!("{} %", (100.0 * error) as f32));
    let mut chart = Chart::new(samples, errors).titled(title).text(32);
    let (exact, mut rng) = (setting.exact(), pcg::stream(16, 1));
    let guide = POWERS
        .map(|p| f64::from(1_u32 << p))
        .map(|n| (n, 1.3 / n.sqrt()));
    chart.line(guide, FAINT.stroke_width(5)).named("slope −½");
    for (name, choose, colour) in [
        ("by area", LightSampling::ByArea, VERMILION),
        ("by solid angle", LightSampling::BySolidAngle, BLUE),
    ] {
        let measured: Vec<_> = POWERS
            .map(|p| 1_u32 << p)
            .map(|n| (f64::from(n), setting.error(choose, n, exact, &mut rng)))
            .collect();
        chart
            .dots(measured.iter().copied(), 8, colour.filled())
            .line(measured, colour.stroke_width(4))
            .named(name);
    }
    if legend {
        chart = chart.legend(Corner::LowerLeft);
    }
    chart.draw(canvas)
}
