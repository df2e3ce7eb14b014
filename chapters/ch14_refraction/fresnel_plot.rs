//! The plot of how much a surface reflects against the angle, both ways.

use raybook::image::Image;
use crate::kit::{figure::Canvas, figure::FONT, figure::figure};
use crate::kit::{palette::BLUE, palette::FAINT, palette::GREEN, palette::INK, palette::VERMILION};
use raybook::material::fresnel::{fresnel, schlick};
use plotters::element::{Circle, DashedPathElement, PathElement, Text};
use plotters::prelude::{ChartBuilder, Color, IntoFont, RGBColor, TextStyle, WHITE};
use plotters::series::{DashedLineSeries, LineSeries};
use plotters::style::SizeDesc;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;

type Drawn = Result<(), Box<dyn Error>>;

/// The index of refraction of window glass.
const GLASS: f32 = 1.5;

/// Size of the text, in pixels of the canvas.
const TEXT: u32 = 32;

/// Points per degree.
const FINE: i32 = 8;

/// A curve: its name, colour, width, and its height by cos θ, n₁ and n₂.
type Curve = (&'static str, RGBColor, u32, fn(f32, f32, f32) -> f32);

const CURVES: [Curve; 3] = [
    ("Rs", BLUE, 5, |c, n1, n2| fresnel(c, n1, n2).s),
    ("Rp", VERMILION, 5, |c, n1, n2| fresnel(c, n1, n2).p),
    ("R = (Rs + Rp)/2", INK, 8, |c, n1, n2| {
        fresnel(c, n1, n2).unpolarised
    }),
];

/// Rs, Rp, R and Schlick's approximation from air into glass, and from glass into air.
///
/// # Errors
/// If plotters cannot draw.
pub fn plot() -> Result<Image, Box<dyn Error>> {
    figure(1000, 470, |canvas| {
        let (into, out) = canvas.split_horizontally(1000);
        panel(&into, "from air into glass", 1.0, GLASS)?;
        panel(&out, "from glass into air", GLASS, 1.0)
    })
}

fn panel(canvas: &Canvas, title: &str, n1: f32, n2: f32) -> Drawn {
    let mut chart = ChartBuilder::on(canvas)
        .margin(24)
        .caption(title, text(40))
        .x_label_area_size(90)
        .y_label_area_size(110)
        .build_cartesian_2d(0.0_f32..90.0, 0.0_f32..1.04)?;
    chart
        .configure_mesh()
        .light_line_style(WHITE.mix(0.0))
        .bold_line_style(FAINT.mix(0.5))
        .x_labels(10)
        .x_label_formatter(&|angle| format!("{angle:.0}°"))
        .y_label_formatter(&|share| format!("{:.0} %", 100.0 * share))
        .x_desc("angle to the normal")
        .label_style(text(TEXT - 4))
        .axis_desc_style(text(TEXT))
        .draw()?;
    let critical = (n2 < n1).then(|| (n2 / n1).asin().to_degrees());
    let brewster = (n2 / n1).atan().to_degrees();
    let marks = [
        (Some(brewster), "Brewster's angle", 0.0, HPos::Right),
        (critical, "critical angle", 1.0, HPos::Left),
    ];
    for (angle, name, share, end) in marks {
        let Some(angle) = angle else { continue };
        let (top, beside) = match end {
            HPos::Left => (0.6, angle + 1.5),
            _ => (0.5, angle + 4.0),
        };
        let line = [(angle, 0.0), (angle, top - 0.03)];
        chart.draw_series([PathElement::new(line, FAINT.stroke_width(4))])?;
        let label = format!("{name} {angle:.1}°");
        let style = text(TEXT - 2).pos(Pos::new(end, VPos::Center));
        chart.draw_series([Text::new(label, (beside, top), style)])?;
        chart.draw_series([Circle::new((angle, share), 9, INK.filled())])?;
    }
    let points = |height: fn(f32, f32, f32) -> f32| {
        (0..=90 * FINE).map(move |i| {
            let angle = i as f32 / FINE as f32;
            (angle, height(angle.to_radians().cos().max(0.0), n1, n2))
        })
    };
    for (name, colour, width, height) in CURVES {
        let style = colour.stroke_width(width);
        chart
            .draw_series(LineSeries::new(points(height), style))?
            .label(name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 50, y)], style));
    }
    let (dash, gap, style) = (14, 12, GREEN.stroke_width(5));
    chart
        .draw_series(DashedLineSeries::new(points(schlick), dash, gap, style))?
        .label("Schlick's approximation")
        .legend(move |(x, y)| {
            DashedPathElement::new([(x, y), (x + 50, y)], dash.in_pixels(&(0, 0)), gap, style)
        });
    if n1 < n2 {
        chart
            .configure_series_labels()
            .position(plotters::prelude::SeriesLabelPosition::UpperLeft)
            .label_font(text(TEXT))
            .legend_area_size(70)
            .margin(24)
            .background_style(WHITE.mix(0.85))
            .draw()?;
    }
    Ok(())
}

fn text(size: u32) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}
