//! Lines, areas and labels in space, as a camera sees them, or flat on a plane.

use crate::kit::figure::{CENTRE, Canvas, Figure, HALO, coloured, figure, write};
use crate::kit::palette::INK;
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2, vec3};
use plotters::prelude::{Circle, Color, PathElement, Polygon, RGBColor, ShapeStyle, WHITE};
use plotters::style::text_anchor::Pos;
use raybook::camera::pinhole::Pinhole;
use std::error::Error;
use std::f32::consts::TAU;
use std::fmt;

/// A canvas, and the camera that looks at the things that are drawn on it.
///
/// Nearer things do not hide farther things by themselves: draw the farthest first. Widths, radii and sizes are in pixels of the
/// canvas.
pub struct Sketch<'a, 'b> {
    /// What is drawn on.
    pub canvas: &'a Canvas<'b>,
    /// The camera that looks.
    pub viewer: Pinhole,
}

impl fmt::Debug for Sketch<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Sketch")
            .field("viewer", &self.viewer)
            .finish_non_exhaustive()
    }
}

/// The point of the plane z = 0.
pub const fn xy(x: f32, y: f32) -> Vec3 {
    vec3(x, y, 0.0)
}

/// A figure of this width and height in pixels, on which the plane z = 0 lies flat, as if drawn on paper: what of it is so high, around
/// its middle.
///
/// # Errors
/// If plotters cannot draw.
pub fn flat(
    size: (u32, u32),
    middle: Vec3,
    height: f32,
    mut draw: impl FnMut(&Sketch) -> Drawn,
) -> Figure {
    figure(size.0, size.1, |canvas| {
        draw(&on_plane(canvas, middle, height)?)
    })
}

/// A view of the plane z = 0 as if drawn on paper: what of it is so high, around its middle.
///
/// # Errors
/// If the height is no length.
pub fn on_plane<'a, 'b>(
    canvas: &'a Canvas<'b>,
    middle: Vec3,
    height: f32,
) -> Result<Sketch<'a, 'b>, Box<dyn Error>> {
    let (wide, high) = canvas.dim_in_pixel();
    let aspect = wide as f32 / high as f32;
    // At the focal length, a metre of the image plane is a metre of what is seen.
    let mut viewer = Pinhole::look_at(middle + Vec3::Z, middle, Vec3::Y, 1.0, aspect)?;
    viewer.plane = height * vec2(aspect, 1.0);
    Ok(Sketch { canvas, viewer })
}

impl Sketch<'_, '_> {
    /// The pixel on which a point ahead of the viewer appears: the inverse of [`Pinhole::ray`](raybook::camera::Camera::ray).
    pub fn at(&self, p: Vec3) -> Vec2 {
        let v = p - self.viewer.focal_point;
        let shrink = self.viewer.focal_length / v.dot(*self.viewer.forward);
        let on_plane = shrink * vec2(v.dot(*self.viewer.right), -v.dot(*self.viewer.up));
        let (width, height) = self.canvas.dim_in_pixel();
        (0.5 + on_plane / self.viewer.plane) * vec2(width as f32, height as f32)
    }

    /// A line through points.
    ///
    /// # Errors
    /// If plotters cannot draw; likewise below.
    pub fn line(&self, points: &[Vec3], colour: RGBColor, width: u32) -> Drawn {
        let points: Vec<_> = points.iter().map(|&p| pixel(self.at(p))).collect();
        self.canvas
            .draw(&PathElement::new(points, colour.stroke_width(width)))?;
        Ok(())
    }

    /// A line of dashes.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn dashes(&self, from: Vec3, to: Vec3, colour: RGBColor, width: u32) -> Drawn {
        /// Length of a dash and of a gap, in pixels.
        const DASH: f32 = 18.0;
        let pieces = (self.at(from).distance(self.at(to)) / DASH).max(1.0) as usize | 1;
        let place = |i: usize| from.lerp(to, i as f32 / pieces as f32);
        (0..pieces)
            .step_by(2)
            .try_for_each(|i| self.line(&[place(i), place(i + 1)], colour, width))
    }

    /// A filled polygon; an opacity of 1 hides what is below.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn area(&self, corners: &[Vec3], colour: RGBColor, opacity: f64) -> Drawn {
        let corners: Vec<_> = corners.iter().map(|&p| pixel(self.at(p))).collect();
        self.canvas
            .draw(&Polygon::new(corners, colour.mix(opacity)))?;
        Ok(())
    }

    /// A point.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn dot(&self, p: Vec3, radius: i32, colour: RGBColor) -> Drawn {
        self.canvas
            .draw(&Circle::new(pixel(self.at(p)), radius, colour.filled()))?;
        Ok(())
    }

    /// A line with a head at its end.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn arrow(&self, from: Vec3, to: Vec3, colour: RGBColor, width: u32) -> Drawn {
        let (tail, tip) = (self.at(from), self.at(to));
        let head = (4.0 + 5.0 * width as f32) * (tip - tail).normalize_or_zero();
        let neck = tip - head;
        let corners = [tip, neck + 0.4 * head.perp(), neck - 0.4 * head.perp()].map(pixel);
        let shaft = vec![pixel(tail), pixel(neck)];
        self.canvas
            .draw(&PathElement::new(shaft, colour.stroke_width(width)))?;
        self.canvas
            .draw(&Polygon::new(corners.to_vec(), colour.filled()))?;
        Ok(())
    }

    /// A line with a head at both ends: how long something is.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn measure(&self, from: Vec3, to: Vec3, colour: RGBColor) -> Drawn {
        let middle = 0.5 * (from + to);
        [from, to]
            .iter()
            .try_for_each(|&end| self.arrow(middle, end, colour, 3))
    }

    /// An arc around a point of a plane of constant z, from an angle to another: from the right, upwards.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn arc(
        &self,
        middle: Vec3,
        radius: f32,
        angles: [f32; 2],
        colour: RGBColor,
        width: u32,
    ) -> Drawn {
        self.line(&on_circle(middle, radius, angles), colour, width)
    }

    /// A disc that faces the viewer.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn disc(&self, middle: Vec3, radius: f32, colour: RGBColor, opacity: f64) -> Drawn {
        self.round(middle, radius, colour.mix(opacity).filled())
    }

    /// A circle that faces the viewer.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn circle(&self, middle: Vec3, radius: f32, colour: RGBColor, width: u32) -> Drawn {
        self.round(middle, radius, colour.stroke_width(width))
    }

    fn round(&self, middle: Vec3, radius: f32, style: ShapeStyle) -> Drawn {
        let rim = self.at(middle + radius * *self.viewer.right);
        let radius = self.at(middle).distance(rim).round() as i32;
        self.canvas
            .draw(&Circle::new(pixel(self.at(middle)), radius, style))?;
        Ok(())
    }

    /// Words in a circle, such as the node of a tree, which hides what is below.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn circled(&self, middle: Vec3, radius: f32, text: &str, colour: RGBColor) -> Drawn {
        self.disc(middle, radius, WHITE, 1.0)?;
        self.disc(middle, radius, colour, 0.15)?;
        self.circle(middle, radius, colour, 4)?;
        self.label(middle, Vec2::ZERO, text, INK)
    }

    /// The angle between two directions along a plane of constant z: an arc around the point from which they go, and its name beyond the arc.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn angle(&self, apex: Vec3, directions: [Vec3; 2], radius: f32, name: &str) -> Drawn {
        let angles = directions.map(|d| d.y.atan2(d.x));
        self.arc(apex, radius, angles, INK, 3)?;
        let middle = Vec2::from_angle(0.5 * (angles[0] + angles[1])).extend(0.0);
        let place = apex + radius * middle;
        let beyond = (self.at(apex + 2.0 * radius * middle) - self.at(place)).normalize_or_zero();
        self.label(place, 30.0 * beyond, name, INK)
    }

    /// A label beside a point: `offset` pixels to the right of it and below, where the label's middle will be.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn label(&self, p: Vec3, offset: Vec2, text: &str, colour: RGBColor) -> Drawn {
        self.words(p, offset, text, colour, CENTRE)
    }

    /// As [`Sketch::label`], where `anchor` says what of the words will be there: their middle, or an end.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn words(&self, p: Vec3, offset: Vec2, text: &str, colour: RGBColor, anchor: Pos) -> Drawn {
        words(self.canvas, self.at(p) + offset, text, colour, anchor)
    }
}

/// The points of an arc around a point of a plane of constant z.
fn on_circle(middle: Vec3, radius: f32, [from, to]: [f32; 2]) -> Vec<Vec3> {
    /// Points of a whole circle.
    const POINTS: f32 = 120.0;
    let steps = ((to - from).abs() / TAU * POINTS).ceil().max(1.0) as u32;
    let angle = |i: u32| from + (to - from) * i as f32 / steps as f32;
    let point = |i: u32| middle + radius * Vec2::from_angle(angle(i)).extend(0.0);
    (0..=steps).map(point).collect()
}

/// A label whose middle is at a pixel of the canvas.
///
/// # Errors
/// If plotters cannot draw.
pub fn label(canvas: &Canvas, place: Vec2, text: &str, colour: RGBColor) -> Drawn {
    words(canvas, place, text, colour, CENTRE)
}

/// Words at a pixel of the canvas, with a white rim that lifts them off what they cross; `anchor` says what of them is there.
fn words(canvas: &Canvas, place: Vec2, text: &str, colour: RGBColor, anchor: Pos) -> Drawn {
    /// Height of the letters, in pixels.
    const SIZE: u32 = 38;
    let lettering = |shift: Vec2, colour: RGBColor| {
        write(
            canvas,
            text,
            pixel(place + shift),
            coloured(SIZE, colour).pos(anchor),
        )
    };
    for i in 0..12 {
        lettering(HALO * Vec2::from_angle(i as f32 * TAU / 12.0), WHITE)?;
    }
    lettering(Vec2::ZERO, colour)
}

fn pixel(place: Vec2) -> (i32, i32) {
    (place.x.round() as i32, place.y.round() as i32)
}
