//! How the work of a search grows with the number of triangles.

use crate::accel::{Accel, Tests, bvh::Bvh};
use crate::image::Image;
use crate::lab::figure::{FONT, figure};
use crate::lab::palette::{BLUE, FAINT, INK, VERMILION};
use crate::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use crate::scene::soup::soup;
use crate::shape::mesh::Facet;
use glam::Vec3;
use plotters::prelude::{ChartBuilder, Circle, Color, IntoFont, IntoLogRange, LineSeries, Text};
use rand::RngExt;
use std::error::Error;

/// Numbers of triangles that are tried.
pub const SIZES: [u32; 9] = [
    100, 300, 1000, 3000, 10_000, 30_000, 100_000, 200_000, 400_000,
];

/// Rays from one random point of the unit cube towards another.
pub fn rays(count: usize) -> Vec<Ray> {
    let mut rng = pcg::stream(11, 0);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
    let mut ray = || {
        let (from, to) = (point(), point());
        Ray::new(from, Dir3::new_or(to - from, Dir3::X))
    };
    (0..count).map(|_| ray()).collect()
}

/// The boxes and shapes that a search tests, the mean over these rays.
pub fn tests(accel: &impl Accel<Facet>, rays: &[Ray]) -> f64 {
    let mut count = Tests::default();
    for ray in rays {
        accel.closest_counted(ray, Interval::AHEAD, &mut count);
    }
    (count.boxes + count.shapes) as f64 / rays.len() as f64
}

/// Tests per ray against triangles, both on logarithmic axes: the list, the tree.
///
/// # Errors
/// What plotters reports.
pub fn draw() -> Result<Image, Box<dyn Error>> {
    let rays = rays(1000);
    let tree: Vec<_> = SIZES
        .iter()
        .map(|&n| (f64::from(n), tests(&Bvh::new(soup(n, 1).facets()), &rays)))
        .collect();
    let list: Vec<_> = SIZES
        .iter()
        .map(|&n| (f64::from(n), f64::from(n)))
        .collect();
    figure(960, 560, |canvas| {
        let mut chart = ChartBuilder::on(canvas)
            .margin(40)
            .margin_right(90)
            .x_label_area_size(110)
            .y_label_area_size(200)
            .build_cartesian_2d((80.0..500_000.0).log_scale(), (10.0..500_000.0).log_scale())?;
        let font = |size: i32| (FONT, size).into_font().color(&INK);
        chart
            .configure_mesh()
            .light_line_style(FAINT.mix(0.0))
            .bold_line_style(FAINT.mix(0.6))
            .axis_style(INK)
            .label_style(font(34))
            .axis_desc_style(font(38))
            .x_desc("triangles")
            .y_desc("boxes and triangles tested per ray")
            .x_label_formatter(&|n| power(*n))
            .y_label_formatter(&|n| power(*n))
            .draw()?;
        for (points, colour, name, at) in [
            (&list, VERMILION, "list: N", (12_000.0, 40_000.0)),
            (&tree, BLUE, "tree: log N", (12_000.0, 90.0)),
        ] {
            chart.draw_series(LineSeries::new(
                points.iter().copied(),
                colour.stroke_width(6),
            ))?;
            let dots = points.iter().map(|&p| Circle::new(p, 9, colour.filled()));
            chart.draw_series(dots)?;
            let style = (FONT, 44).into_font().color(&colour);
            chart.draw_series([Text::new(name, at, style)])?;
        }
        Ok(())
    })
}

/// A number with a thin space between the thousands.
fn power(n: f64) -> String {
    let n = n as u64;
    if n >= 1000 {
        format!("{}\u{2009}{:03}", n / 1000, n % 1000)
    } else {
        n.to_string()
    }
}
