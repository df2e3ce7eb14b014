//! A chart: curves, marks, areas and words over two axes.

use crate::kit::axis::{Axis, Scale};
use crate::kit::figure::{Figure, Style, coloured, figure, text};
use crate::kit::palette::{FAINT, INK};
use crate::kit::pen::Pen;
use crate::kit::stage::Drawn;
use plotters::coord::{Shift, cartesian::Cartesian2d};
use plotters::element::DashedPathElement;
use plotters::prelude::{
    ChartBuilder, ChartContext, Circle, Color, DashedLineSeries, DrawingArea, DrawingBackend,
    LineSeries, PathElement, Polygon, RGBColor, Rectangle, Text, WHITE,
};
use plotters::style::text_anchor::Pos;
use plotters::style::{ShapeStyle, SizeDesc};
use std::fmt;

pub use plotters::prelude::SeriesLabelPosition as Corner;

/// Length of a dash, and of the gap after it, in pixels of the canvas.
const DASH: i32 = 14;
const GAP: i32 = 11;

/// Space around a chart, in pixels of the canvas.
const MARGIN: u32 = 26;

/// A chart, made by adding what is to be drawn, and drawn at the end: a later thing covers an earlier one.
///
/// Widths, radii and sizes of text are in pixels of the canvas, places are in the numbers of the axes.
pub struct Chart {
    title: String,
    x: Axis,
    y: Axis,
    text: i32,
    legend: Option<Corner>,
    left: Option<u32>,
    things: Vec<Thing>,
}

/// Something in a chart, with its colour, and how wide its line is or whether it is filled.
struct Thing {
    form: Form,
    style: ShapeStyle,
    /// Its name in the legend.
    name: Option<String>,
}

enum Form {
    Line(Vec<(f64, f64)>),
    Dashes(Vec<(f64, f64)>),
    Dots(Vec<(f64, f64)>, i32),
    Curve(Vec<(f64, f64)>, Pen),
    Bar([(f64, f64); 2]),
    Area(Vec<(f64, f64)>),
    Label((f64, f64), String, Box<Style>),
}

impl fmt::Debug for Chart {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Chart")
            .field("title", &self.title)
            .field("x", &self.x)
            .field("y", &self.y)
            .finish_non_exhaustive()
    }
}

impl Chart {
    /// An empty chart over two axes.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self {
            title: String::new(),
            x,
            y,
            text: 34,
            legend: None,
            left: None,
            things: Vec::new(),
        }
    }

    /// With a title above.
    #[must_use]
    pub fn titled(mut self, title: &str) -> Self {
        title.clone_into(&mut self.title);
        self
    }

    /// With text of another size than 34 pixels.
    #[must_use]
    pub fn text(mut self, size: i32) -> Self {
        self.text = size;
        self
    }

    /// With the names of what is [named](Chart::named), in a corner.
    #[must_use]
    pub fn legend(mut self, corner: Corner) -> Self {
        self.legend = Some(corner);
        self
    }

    /// With this number of pixels to the left of the axes, so that charts one above the other are aligned.
    #[must_use]
    pub fn left(mut self, pixels: u32) -> Self {
        self.left = Some(pixels);
        self
    }

    /// A line through points.
    pub fn line<T: Into<f64>>(
        &mut self,
        points: impl IntoIterator<Item = (T, T)>,
        style: impl Into<ShapeStyle>,
    ) -> &mut Self {
        self.add(Form::Line(places(points)), style)
    }

    /// A line of dashes through points.
    pub fn dashes<T: Into<f64>>(
        &mut self,
        points: impl IntoIterator<Item = (T, T)>,
        style: impl Into<ShapeStyle>,
    ) -> &mut Self {
        self.add(Form::Dashes(places(points)), style)
    }

    /// A line through points, with the pen's dashes and marks.
    pub fn curve<T: Into<f64>>(
        &mut self,
        points: impl IntoIterator<Item = (T, T)>,
        pen: Pen,
    ) -> &mut Self {
        self.add(Form::Curve(places(points), pen), pen.stroke)
    }

    /// A disc at each point, or a ring if the style is not filled.
    pub fn dots<T: Into<f64>>(
        &mut self,
        points: impl IntoIterator<Item = (T, T)>,
        radius: i32,
        style: impl Into<ShapeStyle>,
    ) -> &mut Self {
        self.add(Form::Dots(places(points), radius), style)
    }

    /// A rectangle between two corners, or its outline if the style is not filled.
    pub fn bar<T: Into<f64>>(
        &mut self,
        corners: [(T, T); 2],
        style: impl Into<ShapeStyle>,
    ) -> &mut Self {
        self.add(Form::Bar(corners.map(|(x, y)| (x.into(), y.into()))), style)
    }

    /// A filled polygon.
    pub fn area<T: Into<f64>>(
        &mut self,
        corners: impl IntoIterator<Item = (T, T)>,
        style: impl Into<ShapeStyle>,
    ) -> &mut Self {
        self.add(Form::Area(places(corners)), style)
    }

    /// Words, of which this part is at a place.
    pub fn label<T: Into<f64>>(
        &mut self,
        part: Pos,
        (x, y): (T, T),
        words: &str,
        colour: RGBColor,
    ) -> &mut Self {
        let style = coloured(self.text + 2, colour).pos(part);
        self.add(
            Form::Label((x.into(), y.into()), words.to_owned(), Box::new(style)),
            INK,
        )
    }

    /// Gives the last line its name in the legend.
    pub fn named(&mut self, name: &str) -> &mut Self {
        if let Some(last) = self.things.last_mut() {
            last.name = Some(name.to_owned());
        }
        self
    }

    fn add(&mut self, form: Form, style: impl Into<ShapeStyle>) -> &mut Self {
        self.things.push(Thing {
            form,
            style: style.into(),
            name: None,
        });
        self
    }

    /// The chart as a figure of its own, of this width and height in pixels.
    ///
    /// # Errors
    /// What plotters reports.
    pub fn figure(&self, width: u32, height: u32) -> Figure {
        figure(width, height, |canvas| self.draw(canvas))
    }

    /// Draws the chart on all of a canvas, or of a part of one.
    ///
    /// # Errors
    /// What plotters reports.
    pub fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let mut builder = ChartBuilder::on(canvas);
        builder
            .margin(MARGIN)
            .margin_right(MARGIN + self.overhang(canvas)?)
            .x_label_area_size(self.below())
            .y_label_area_size(self.beside(canvas)?);
        if !self.title.is_empty() {
            builder.caption(&self.title, text(self.text + 8));
        }
        let mut axes = builder.build_cartesian_2d(&self.x.scale, &self.y.scale)?;
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

    fn draw_grid<B: DrawingBackend>(&self, axes: &mut Axes<B>) -> Drawn
    where
        B::ErrorType: 'static,
    {
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

    /// Pixels below the axes: a line for the numbers, and one for the name.
    fn below(&self) -> i32 {
        match (self.x.is_drawn, self.x.name.is_empty()) {
            (false, _) => 0,
            (true, true) => 2 * self.text,
            (true, false) => 3 * self.text + 10,
        }
    }

    /// Pixels to the left of the axes: the widest number, and the name.
    fn beside<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Result<u32, Error<B>> {
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

    /// Pixels by which a number below the right end of the x axis is wider than the axis.
    fn overhang<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Result<u32, Error<B>> {
        Ok(if self.x.is_drawn {
            self.widest(&self.x, canvas)? / 2
        } else {
            0
        })
    }

    /// Width of an axis' widest number.
    fn widest<B: DrawingBackend>(
        &self,
        axis: &Axis,
        canvas: &DrawingArea<B, Shift>,
    ) -> Result<u32, Error<B>> {
        let mut widest = 0;
        for number in axis.texts() {
            widest = widest.max(canvas.estimate_text_size(&number, &text(self.text))?.0);
        }
        Ok(widest)
    }
}

/// What plotters reports.
type Error<B> = plotters::drawing::DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>;

/// The axes on a canvas.
type Axes<'a, 's, B> = ChartContext<'a, B, Cartesian2d<&'s Scale, &'s Scale>>;

fn places<T: Into<f64>>(points: impl IntoIterator<Item = (T, T)>) -> Vec<(f64, f64)> {
    points
        .into_iter()
        .map(|(x, y)| (x.into(), y.into()))
        .collect()
}

impl Thing {
    fn draw<B: DrawingBackend>(&self, axes: &mut Axes<B>) -> Drawn
    where
        B::ErrorType: 'static,
    {
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

/// A whole number, with a thin space between the thousands.
pub fn grouped(v: f64) -> String {
    let digits = format!("{v:.0}");
    let mut grouped = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            grouped.push('\u{2009}');
        }
        grouped.push(digit);
    }
    grouped
}

/// A percentage.
pub fn percent(share: f64) -> String {
    format!("{} %", 100.0 * share as f32)
}

/// A whole number with a minus sign instead of a hyphen.
pub fn whole(v: f64) -> String {
    format!("{v:.0}").replace('-', "−")
}
