//! A chart: curves, marks, areas and words over two axes.

mod drawing;

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Style, coloured, figure};
use crate::kit::palette::INK;
use crate::kit::pen::Pen;
use plotters::prelude::RGBColor;
use plotters::style::ShapeStyle;
use plotters::style::text_anchor::Pos;
use std::fmt;

pub use plotters::prelude::SeriesLabelPosition as Corner;

/// A chart. Things are added one after the other, and drawn at the end: a later thing covers an earlier thing.
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
            text: 35,
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

    /// With this size of text in pixels, instead of 35.
    #[must_use]
    pub fn text(mut self, size: i32) -> Self {
        self.text = size;
        self
    }

    /// With a legend in a corner: the names of the lines that are [named](Chart::named).
    #[must_use]
    pub fn legend(mut self, corner: Corner) -> Self {
        self.legend = Some(corner);
        self
    }

    /// With this number of pixels to the left of the axes and only the margin to the right, so that charts one above the other are
    /// aligned.
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

    /// Words, anchored at a place by this part of them.
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
}

fn places<T: Into<f64>>(points: impl IntoIterator<Item = (T, T)>) -> Vec<(f64, f64)> {
    points
        .into_iter()
        .map(|(x, y)| (x.into(), y.into()))
        .collect()
}
