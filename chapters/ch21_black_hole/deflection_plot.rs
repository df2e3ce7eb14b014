//! The plot of the deflection of light against its impact parameter.

use raybook::image::Image;
use crate::kit::{figure::FONT, figure::figure};
use crate::kit::{palette::BLUE, palette::FAINT, palette::INK, palette::ORANGE, palette::VERMILION};
use raybook::render::curved::deflection::deflection_angle;
use raybook::render::curved::follow::{Fate, follow};
use raybook::render::curved::{CRITICAL, Photon};
use glam::{DVec3, dvec3};
use plotters::element::{Circle, PathElement, Text};
use plotters::prelude::{ChartBuilder, Color, IntoFont, IntoLogRange};
use plotters::series::{DashedLineSeries, LineSeries};
use std::error::Error;
use std::ops::ControlFlow;

/// The impact parameters of the rays that are followed.
const FOLLOWED: [f64; 9] = [2.6, 2.65, 2.8, 3.2, 4.0, 6.0, 10.0, 20.0, 50.0];

/// Angle against impact parameter, both on logarithmic axes.
///
/// # Errors
/// What plotters reports.
pub fn draw() -> Result<Image, Box<dyn Error>> {
    figure(960, 520, |canvas| {
        let mut chart = ChartBuilder::on(canvas)
            .margin(30)
            .margin_right(60)
            .x_label_area_size(100)
            .y_label_area_size(150)
            .build_cartesian_2d((2.0..100.0).log_scale(), (1.0..1000.0).log_scale())?;
        let font = |size: i32| (FONT, size).into_font().color(&INK);
        chart
            .configure_mesh()
            .light_line_style(FAINT.mix(0.0))
            .bold_line_style(FAINT.mix(0.6))
            .axis_style(INK)
            .label_style(font(32))
            .axis_desc_style(font(36))
            .x_labels(30)
            .x_desc("impact parameter b, in radii of the hole")
            .y_desc("deflection")
            .x_label_formatter(&|b| {
                let named = [2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0];
                if named.contains(b) {
                    format!("{b:.0}")
                } else {
                    String::new()
                }
            })
            .y_label_formatter(&|angle| format!("{angle:.0}°"))
            .draw()?;
        let limit = [(CRITICAL, 1.0), (CRITICAL, 1000.0)];
        chart.draw_series([PathElement::new(limit, VERMILION.stroke_width(4))])?;
        let style = (FONT, 34).into_font().color(&VERMILION);
        chart.draw_series([Text::new(
            "b = 2.598: goes around for ever",
            (2.68, 780.0),
            style,
        )])?;

        let weak = (0..=40).map(|i| {
            let b = 2.0 * 50.0_f64.powf(f64::from(i) / 40.0);
            (b, (2.0 / b).to_degrees())
        });
        let dashes = DashedLineSeries::new(weak, 16, 12, ORANGE.stroke_width(5));
        chart.draw_series(dashes)?;
        let style = (FONT, 34).into_font().color(&ORANGE);
        chart.draw_series([Text::new("2/b", (2.08, 36.0), style)])?;

        let curve = (0..=400).filter_map(|i| {
            let b = CRITICAL + 1e-7 * 1e9_f64.powf(f64::from(i) / 400.0);
            Some((b, deflection_angle(b)?.to_degrees()))
        });
        let curve = curve.filter(|(b, _)| *b < 100.0);
        chart.draw_series(LineSeries::new(curve, BLUE.stroke_width(6)))?;
        let dots = FOLLOWED
            .into_iter()
            .filter_map(|b| Some((b, followed(b)?.to_degrees())));
        chart.draw_series(dots.map(|p| Circle::new(p, 10, BLUE.filled())))?;
        let style = (FONT, 34).into_font().color(&BLUE);
        chart.draw_series([Text::new("around a black hole", (3.7, 80.0), style)])?;
        Ok(())
    })
}

/// The angle, in radians, by which a ray from far away is turned that is followed step by step; `None` if it falls.
pub fn followed(b: f64) -> Option<f64> {
    let start = Photon {
        x: dvec3(-3e5, b, 0.0),
        v: DVec3::X,
    };
    let mut turned = 0.0;
    let fate = follow(start, 1e-10, |piece| {
        let (from, to) = (piece.from.v, piece.to.v);
        turned += from.cross(to).length().atan2(from.dot(to));
        ControlFlow::Continue(())
    });
    matches!(fate, Fate::Escaped(_)).then_some(turned)
}
