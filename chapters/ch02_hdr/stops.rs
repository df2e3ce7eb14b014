//! Plots whose axis is the brightness in stops: log₂ of the radiance, where 0 is a display's white.

use raybook::image::{Image, rgb::Rgb, tone};
use crate::kit::{figure::FONT, figure::figure};
use crate::kit::{palette::BLUE, palette::FAINT, palette::INK, palette::SKY, palette::VERMILION};
use plotters::prelude::{
    ChartBuilder, Color, IntoFont, IntoLogRange, LineSeries, PathElement, Rectangle,
    SeriesLabelPosition, Text, TextStyle, WHITE,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;

/// Bars of the histogram per stop.
const BARS: f32 = 2.0;

/// The stop at which a PNG's least byte that is not black begins: log₂ of the linear value of code ½/255.
const DARKEST: f32 = -12.7;

/// Where the histogram's logarithmic axis begins, in percent of the pixels.
const LEAST: f32 = 0.001;

/// How many of the pixels are how bright, in half stops; `marks` name a brightness each, in stops.
///
/// The band is what a PNG can show at the exposure of 0 stops.
///
/// # Errors
/// If plotters cannot draw.
pub fn histogram(picture: &Image, marks: &[(f32, &str)]) -> Result<Image, Box<dyn Error>> {
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
    figure(960, 480, |canvas| {
        let mut chart = ChartBuilder::on(canvas)
            .margin(30)
            .x_label_area_size(100)
            .y_label_area_size(140)
            .build_cartesian_2d(from..to, (LEAST..100.0).log_scale())?;
        chart.draw_series([Rectangle::new(
            [(from.max(DARKEST), LEAST), (0.0, 100.0)],
            SKY.mix(0.25).filled(),
        )])?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(FAINT.mix(0.5))
            .x_labels(24)
            .x_label_formatter(&|&stop| signed(stop))
            .y_label_formatter(&|share| format!("{share} %"))
            .x_desc("luminance in stops: 0 is white on a display, one more is twice the light")
            .y_desc("share of the pixels")
            .label_style(text(30))
            .axis_desc_style(text(32))
            .draw()?;
        let drawn = ((least * BARS) as i32..(most * BARS) as i32).filter(|&bar| share(bar) > LEAST);
        chart.draw_series(drawn.map(|bar| {
            let (left, right) = (bar as f32 / BARS + 0.04, (bar + 1) as f32 / BARS - 0.04);
            Rectangle::new([(left, LEAST), (right, share(bar))], BLUE.filled())
        }))?;
        chart.draw_series(marks.iter().map(|&(stop, name)| label((stop, 28.0), name)))?;
        let band = 0.5 * from.max(DARKEST);
        chart.draw_series([label((band, 65.0), "what a PNG holds")])?;
        Ok(())
    })
}

/// What a display shows of a grey radiance: clamped, and under two tone curves.
///
/// # Errors
/// If plotters cannot draw.
pub fn curves() -> Result<Image, Box<dyn Error>> {
    type Curve = fn(Rgb) -> Rgb;
    let curves: [(&str, Curve, _); 3] = [
        ("clamped", tone::clamp, INK),
        ("Reinhard", tone::reinhard, BLUE),
        ("ACES-like", tone::aces, VERMILION),
    ];
    figure(960, 480, |canvas| {
        let mut chart = ChartBuilder::on(canvas)
            .margin(30)
            .x_label_area_size(100)
            .y_label_area_size(140)
            .build_cartesian_2d(-9.0_f32..9.0, 0.0_f32..270.0)?;
        chart
            .configure_mesh()
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(FAINT.mix(0.5))
            .x_labels(18)
            .x_label_formatter(&|&stop| signed(stop))
            .y_label_formatter(&|code| format!("{code:.0}"))
            .x_desc("radiance in stops: 0 is white on a display, one more is twice the light")
            .y_desc("byte in the PNG")
            .label_style(text(30))
            .axis_desc_style(text(32))
            .draw()?;
        for (name, curve, colour) in curves {
            let points = (-900..=900).map(|i| i as f32 / 100.0).map(|stop| {
                (
                    stop,
                    255.0 * tone::encode_srgb(curve(Rgb::gray(stop.exp2())).r),
                )
            });
            chart
                .draw_series(LineSeries::new(points, colour.stroke_width(5)))?
                .label(name)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 50, y)], colour.stroke_width(5))
                });
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .label_font(text(32))
            .legend_area_size(70)
            .margin(30)
            .background_style(WHITE.mix(0.8))
            .draw()?;
        Ok(())
    })
}

/// A name in the middle of a place of the plot.
fn label(place: (f32, f32), name: &str) -> Text<'static, (f32, f32), String> {
    let middle = text(32).pos(Pos::new(HPos::Center, VPos::Center));
    Text::new(name.to_owned(), place, middle)
}

/// A number of stops with its sign, as photographers write it.
fn signed(stop: f32) -> String {
    if stop == 0.0 {
        "0".to_owned()
    } else {
        format!("{stop:+.0}").replace('-', "−")
    }
}

/// Text of so many pixels of the canvas.
fn text(size: u32) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}
