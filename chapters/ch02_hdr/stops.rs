//! Plots whose axis is the brightness in stops: log₂ of the radiance, where 0 is a display's white.

use crate::kit::axis::Axis;
use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::{CENTRE, Figure};
use crate::kit::palette::{BLUE, INK, SKY, VERMILION};
use plotters::style::Color;
use raybook::image::{Image, rgb::Rgb, tone};

/// Bars of the histogram per stop.
const BARS: f32 = 2.0;

/// The stop at which a PNG's least byte that is not black begins: log₂ of the linear value of code ½/255.
const DARKEST: f32 = -12.7;

/// Where the histogram's logarithmic axis begins, in percent of the pixels.
const LEAST: f32 = 0.001;

/// The share of the pixels in each half stop of brightness. Each of `marks` names a brightness, in stops.
///
/// The band is what a PNG can show at the exposure of 0 stops.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn histogram(picture: &Image, marks: &[(f32, &str)]) -> Figure {
    let stops = picture.pixels().iter().map(|p| p.luminance().log2());
    let bars: Vec<_> = stops
        .filter(|s| s.is_finite())
        .map(|s| (BARS * s).floor() as i32)
        .collect();
    let least = bars.iter().min().map_or(-1.0, |&bar| bar as f32 / BARS);
    let most = bars
        .iter()
        .max()
        .map_or(1.0, |&bar| (bar + 1) as f32 / BARS);
    let share =
        |bar: i32| 100.0 * bars.iter().filter(|&&b| b == bar).count() as f32 / bars.len() as f32;
    let (from, to) = ((least - 1.0).floor(), (most + 1.0).ceil());
    let mut chart = Chart::new(
        Axis::linear(from..to)
            .named("luminance in stops: 0 is white on a display, one more is twice the light")
            .labels(24)
            .format(signed),
        Axis::log(LEAST..100.0)
            .named("share of the pixels")
            .format(|share| format!("{} %", share as f32)),
    );
    let darkest = from.max(DARKEST);
    chart.bar([(darkest, LEAST), (0.0, 100.0)], SKY.mix(0.25).filled());
    for bar in (least * BARS) as i32..(most * BARS) as i32 {
        let (left, right) = (bar as f32 / BARS + 0.04, (bar + 1) as f32 / BARS - 0.04);
        if share(bar) > LEAST {
            chart.bar([(left, LEAST), (right, share(bar))], BLUE.filled());
        }
    }
    for &(stop, name) in marks {
        chart.label(CENTRE, (stop, 28.0), name, INK);
    }
    chart.label(CENTRE, (0.5 * darkest, 65.0), "what a PNG holds", INK);
    chart.figure(960, 480)
}

/// What a display shows of a grey radiance: clamped, and under two tone curves.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn curves() -> Figure {
    type Curve = fn(Rgb) -> Rgb;
    let curves: [(&str, Curve, _); 3] = [
        ("clamped", tone::clamp, INK),
        ("Reinhard", tone::reinhard, BLUE),
        ("ACES-like", tone::aces, VERMILION),
    ];
    let mut chart = Chart::new(
        Axis::linear(-9.0..9.0)
            .named("radiance in stops: 0 is white on a display, one more is twice the light")
            .labels(18)
            .format(signed),
        Axis::linear(0.0..270.0).named("byte in the PNG"),
    )
    .legend(Corner::UpperLeft);
    for (name, curve, colour) in curves {
        let byte = |stop: f32| 255.0 * tone::encode_srgb(curve(Rgb::gray(stop.exp2())).r);
        let stops = (-900..=900).map(|i| i as f32 / 100.0);
        let points = stops.map(|stop| (stop, byte(stop)));
        chart.line(points, colour.stroke_width(5)).named(name);
    }
    chart.figure(960, 480)
}

/// A number of stops with its sign, as photographers write it.
fn signed(stop: f64) -> String {
    if stop == 0.0 {
        "0".to_owned()
    } else {
        format!("{stop:+.0}").replace('-', "−")
    }
}
