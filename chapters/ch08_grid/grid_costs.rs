//! What a ray costs in a grid, against the grid's resolution.

use raybook::accel::grid::Grid;
use raybook::inside::grid::grid_resolution;
use raybook::accel::{Accel, Tests};
use raybook::image::Image;
use crate::kit::{figure::FONT, figure::figure};
use crate::kit::{palette::BLUE, palette::FAINT, palette::GREEN, palette::INK, palette::VERMILION};
use crate::shared::showroom::Showroom;
use raybook::math::interval::Interval;
use raybook::shape::mesh::Mesh;
use glam::vec2;
use plotters::prelude::{
    ChartBuilder, Circle, Color, IntoFont, IntoLogRange, LineSeries, PathElement, RGBColor,
    SeriesLabelPosition, Text, TextStyle, WHITE,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

/// Cells per triangle, λ.
const DENSITIES: [f32; 12] = [
    0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0,
];

/// How many rays each grid is asked.
const RAYS: usize = 2000;

/// What a ray costs, on average, in a grid of so many cells per triangle.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// λ.
    pub density: f32,
    /// Nanoseconds, the best of a few rounds.
    pub time: f32,
    /// Cells visited.
    pub cells: f32,
    /// Triangles tested.
    pub triangles: f32,
}

/// The costs over the densities of a showroom's rays, measured now.
pub fn measure(mesh: &Mesh) -> Vec<Cost> {
    let room = Showroom::around(mesh, 1.6);
    // Evenly over the picture, but no neighbours in a row.
    let place = |i: usize| vec2(i as f32 * 0.618_034 % 1.0, i as f32 / RAYS as f32);
    let rays: Vec<_> = (0..RAYS).map(|i| room.ray(place(i))).collect();
    let per_ray = |x: f64| (x / RAYS as f64) as f32;
    let cost = |&density: &f32| {
        let facets = mesh.facets();
        let resolution = grid_resolution(mesh.bounds().size(), facets.len(), density);
        let grid = Grid::of_facets_with_resolution(facets, resolution);
        let mut tests = Tests::default();
        for ray in &rays {
            grid.closest_counted(ray, Interval::AHEAD, &mut tests);
        }
        let mut best = f64::INFINITY;
        for _ in 0..3 {
            let start = Instant::now();
            for ray in &rays {
                black_box(grid.closest(ray, Interval::AHEAD));
            }
            best = best.min(start.elapsed().as_secs_f64());
        }
        Cost {
            density,
            time: per_ray(1e9 * best),
            cells: per_ray(tests.boxes as f64),
            triangles: per_ray(tests.shapes as f64),
        }
    };
    DENSITIES.iter().map(cost).collect()
}

/// Rays per second in the grid that takes the least time.
pub fn rate(costs: &[Cost]) -> f32 {
    best(costs).map_or(0.0, |best| 1e9 / best.time)
}

/// The one that takes the least time.
fn best(costs: &[Cost]) -> Option<&Cost> {
    costs.iter().min_by(|a, b| a.time.total_cmp(&b.time))
}

/// The costs as lines, with the least time marked.
///
/// # Errors
/// If plotters cannot draw.
pub fn plot(costs: &[Cost]) -> Result<Image, Box<dyn Error>> {
    type Curve = (&'static str, RGBColor, fn(&Cost) -> f32);
    let curves: [Curve; 3] = [
        ("nanoseconds", INK, |cost| cost.time),
        ("triangles tested", VERMILION, |cost| cost.triangles),
        ("cells visited", BLUE, |cost| cost.cells),
    ];
    let most = costs
        .iter()
        .map(|c| c.time.max(c.triangles))
        .fold(10.0, f32::max);
    figure(960, 560, |canvas| {
        let mut chart = ChartBuilder::on(canvas)
            .margin(30)
            .x_label_area_size(100)
            .y_label_area_size(150)
            .build_cartesian_2d(
                (0.0007_f32..450.0).log_scale(),
                (0.7..2.0 * most).log_scale(),
            )?;
        chart
            .configure_mesh()
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(FAINT.mix(0.5))
            .x_label_formatter(&|density| density.to_string())
            .y_label_formatter(&|count| count.to_string())
            .x_desc("λ: cells per triangle")
            .y_desc("per ray")
            .label_style(text(30))
            .axis_desc_style(text(32))
            .draw()?;
        for (name, colour, value) in curves {
            let points = costs.iter().map(move |cost| (cost.density, value(cost)));
            chart
                .draw_series(LineSeries::new(points.clone(), colour.stroke_width(5)))?
                .label(name)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 50, y)], colour.stroke_width(5))
                });
            chart.draw_series(points.map(|point| Circle::new(point, 7, colour.filled())))?;
        }
        if let Some(best) = best(costs) {
            let place = (best.density, best.time);
            chart.draw_series([Circle::new(place, 20, GREEN.stroke_width(6))])?;
            let label = |x, y, words: &str, colour: RGBColor| {
                let middle = Pos::new(HPos::Center, VPos::Center);
                let style = (FONT, 36).into_font().color(&colour).pos(middle);
                Text::new(words.to_owned(), (x, y), style)
            };
            chart.draw_series([
                label(best.density, 0.5 * best.time, "the least time", GREEN),
                label(0.006, 30.0, "too few cells:", INK),
                label(0.006, 18.0, "nearly a list", INK),
                label(30.0, 30.0 * best.time, "too many cells:", INK),
                label(30.0, 18.0 * best.time, "steps through nothing", INK),
            ])?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperMiddle)
            .label_font(text(32))
            .legend_area_size(70)
            .margin(30)
            .background_style(WHITE.mix(0.8))
            .draw()?;
        Ok(())
    })
}

/// Text of so many pixels of the canvas.
fn text(size: u32) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}
