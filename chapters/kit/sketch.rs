//! Lines, areas and labels in space, as a camera sees them.

use crate::kit::figure::{CENTRE, Canvas, coloured, write};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2};
use plotters::prelude::{Circle, Color, PathElement, Polygon, RGBColor, WHITE};
use raybook::camera::pinhole::Pinhole;
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

    /// A label beside a point: `offset` pixels to the right of it and below, where the label's middle will be.
    ///
    /// # Errors
    /// As for [`Sketch::line`].
    pub fn label(&self, p: Vec3, offset: Vec2, text: &str, colour: RGBColor) -> Drawn {
        label(self.canvas, self.at(p) + offset, text, colour)
    }
}

/// A label whose middle is at a pixel of the canvas.
///
/// # Errors
/// If plotters cannot draw.
pub fn label(canvas: &Canvas, place: Vec2, text: &str, colour: RGBColor) -> Drawn {
    /// Height of the letters, in pixels.
    const SIZE: u32 = 38;
    /// Width of the white rim that lifts the letters off what they cross, in pixels.
    const HALO: f32 = 4.0;
    let lettering = |shift: Vec2, colour: RGBColor| {
        write(
            canvas,
            text,
            pixel(place + shift),
            coloured(SIZE, colour).pos(CENTRE),
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
