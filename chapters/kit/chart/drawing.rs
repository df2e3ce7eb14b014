//! How a chart is drawn: its margins, its grid, and what is in it.

use super::{Chart, Form, Thing};
use crate::kit::axis::{Axis, Scale};
use crate::kit::figure::{CENTRE, Canvas, Style, text, write};
use crate::kit::palette::{FAINT, INK};
use crate::kit::paper::Paper;
use crate::kit::stage::Drawn;
use plotters::coord::cartesian::Cartesian2d;
use plotters::element::DashedPathElement;
use plotters::prelude::{
    ChartBuilder, ChartContext, Circle, Color, DashedLineSeries, LineSeries, PathElement, Polygon,
    Rectangle, Text, WHITE,
};
use plotters::style::SizeDesc;
use std::io;

/// Length of a dash, and of the gap after it, in pixels of the canvas.
const DASH: i32 = 14;
const GAP: i32 = 11;

/// Space around a chart, in pixels of the canvas.
const MARGIN: u32 = 26;

impl Chart {
    /// Draws the chart on all of a canvas, or of a part of one.
    ///
    /// # Errors
    /// What plotters reports.
    pub fn draw(&self, canvas: &Canvas) -> Drawn {
        let mut builder = ChartBuilder::on(canvas);
        builder
            .margin(MARGIN)
            .margin_top(MARGIN + self.above())
            .margin_right(MARGIN + self.overhang(canvas)?)
            .x_label_area_size(self.below())
            .y_label_area_size(self.beside(canvas)?);
        let mut axes = builder.build_cartesian_2d(&self.x.scale, &self.y.scale)?;
        self.draw_title(canvas, &axes)?;
        self.draw_grid(&mut axes)?;
        for thing in &self.things {
            if let Form::Curve(points, pen) = &thing.form {
                let (left, top) = canvas.get_base_pixel();
                let pixel = |p: &(f64, f64)| {
                    let (x, y) = axes.backend_coord(p);
                    (x - left, y - top)
                };
                let through: Vec<_> = points.iter().map(pixel).collect();
                pen.line(canvas, &through)?;
                for at in through {
                    pen.mark(canvas, at)?;
                }
            }
            thing.draw(&mut axes)?;
        }
        if let Some(corner) = &self.legend {
            axes.configure_series_labels()
                .position(corner.clone())
                .label_font(text(self.text))
                .legend_area_size(66)
                .margin(14)
                .background_style(WHITE.mix(0.9))
                .border_style(FAINT)
                .draw()?;
        }
        Ok(())
    }

    /// The title, above the middle of the axes, unless it would leave the canvas there.
    fn draw_title(&self, canvas: &Canvas, axes: &Axes) -> Drawn {
        if self.title.is_empty() {
            return Ok(());
        }
        let style = text(self.text + 8).pos(CENTRE);
        let half = canvas.estimate_text_size(&self.title, &style)?.0 as i32 / 2;
        let (left, _) = canvas.get_base_pixel();
        let (across, _) = axes.plotting_area().get_pixel_range();
        let middle = across.start.midpoint(across.end) - left;
        let right = canvas.dim_in_pixel().0 as i32;
        let x = middle.min(right - half).max(half);
        let y = (MARGIN + self.above() / 2) as i32 - self.text / 4;
        write(canvas, &self.title, (x, y), style)
    }

    fn draw_grid(&self, axes: &mut Axes) -> Drawn {
        let [x_format, y_format] = [&self.x, &self.y].map(|axis| |v: &f64| (axis.format)(*v));
        let mut grid = axes.configure_mesh();
        if !self.x.is_drawn {
            grid.disable_x_axis().disable_x_mesh();
        }
        if !self.y.is_drawn {
            grid.disable_y_axis().disable_y_mesh();
        }
        grid.max_light_lines(0)
            .bold_line_style(FAINT.mix(0.5))
            .axis_style(INK)
            .label_style(text(self.text))
            .axis_desc_style(text(self.text + 2))
            .x_labels(self.x.labels)
            .y_labels(self.y.labels)
            .x_label_formatter(&x_format)
            .y_label_formatter(&y_format)
            .x_desc(&self.x.name)
            .y_desc(&self.y.name)
            .draw()?;
        Ok(())
    }

    /// Pixels above the axes, for the title.
    fn above(&self) -> u32 {
        if self.title.is_empty() {
            0
        } else {
            2 * self.text as u32
        }
    }

    /// Pixels below the axes: a line for the numbers, and one for the name.
    fn below(&self) -> i32 {
        match (self.x.is_drawn, self.x.name.is_empty()) {
            (false, _) => 0,
            (true, true) => 2 * self.text,
            (true, false) => 3 * self.text + 10,
        }
    }

    /// Pixels to the left of the axes: the widest number, and the name.
    fn beside(&self, canvas: &Canvas) -> Result<u32, Error> {
        if let Some(pixels) = self.left {
            return Ok(pixels);
        }
        if !self.y.is_drawn {
            return Ok(0);
        }
        let name = if self.y.name.is_empty() {
            0
        } else {
            2 * self.text as u32
        };
        Ok(self.widest(&self.y, canvas)? + 24 + name)
    }

    /// Pixels by which a number below the right end of the x axis is wider than the axis; none where charts are aligned.
    fn overhang(&self, canvas: &Canvas) -> Result<u32, Error> {
        Ok(if self.x.is_drawn && self.left.is_none() {
            self.widest(&self.x, canvas)? / 2
        } else {
            0
        })
    }

    /// Width of an axis' widest number.
    fn widest(&self, axis: &Axis, canvas: &Canvas) -> Result<u32, Error> {
        let mut widest = 0;
        for number in axis.texts() {
            widest = widest.max(canvas.estimate_text_size(&number, &text(self.text))?.0);
        }
        Ok(widest)
    }
}

/// What plotters reports.
type Error = plotters::drawing::DrawingAreaErrorKind<io::Error>;

/// The axes on a canvas.
type Axes<'a, 'p, 's> = ChartContext<'a, Paper<'p>, Cartesian2d<&'s Scale, &'s Scale>>;

impl Thing {
    fn draw(&self, axes: &mut Axes) -> Drawn {
        let style = self.style;
        match &self.form {
            Form::Line(points) => {
                let line = axes.draw_series(LineSeries::new(points.iter().copied(), style))?;
                if let Some(name) = &self.name {
                    line.label(name)
                        .legend(move |(x, y)| PathElement::new([(x, y), (x + 50, y)], style));
                }
            }
            Form::Dashes(points) => {
                let dashes = DashedLineSeries::new(points.iter().copied(), DASH, GAP, style);
                let dashes = axes.draw_series(dashes)?;
                if let Some(name) = &self.name {
                    dashes.label(name).legend(move |(x, y)| {
                        let dash = DASH.in_pixels(&(0, 0));
                        DashedPathElement::new([(x, y), (x + 50, y)], dash, GAP, style)
                    });
                }
            }
            Form::Dots(points, radius) => {
                axes.draw_series(points.iter().map(|&p| Circle::new(p, *radius, style)))?;
            }
            Form::Curve(..) => {} // drawn in pixels
            Form::Bar(corners) => {
                axes.draw_series([Rectangle::new(*corners, style)])?;
            }
            Form::Area(corners) => {
                axes.draw_series([Polygon::new(corners.clone(), style)])?;
            }
            Form::Label(at, words, style) => {
                axes.draw_series([Text::new(words.clone(), *at, Style::clone(style))])?;
            }
        }
        Ok(())
    }
}
