//! A box in the plane as two slabs: a ray that hits it, a ray that misses it, and the intervals that decide.

use raybook::image::Image;
use crate::kit::{figure::Canvas, figure::FONT, figure::figure};
use crate::kit::{palette::BLUE, palette::FAINT, palette::GREEN, palette::INK, palette::VERMILION};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray, slab};
use glam::{Vec3, vec3};
use plotters::coord::{cartesian::Cartesian2d, types::RangedCoordf32};
use plotters::element::{Circle, PathElement, Polygon, Rectangle, Text};
use plotters::prelude::{
    BitMapBackend, ChartBuilder, ChartContext, Color, IntoFont, RGBColor, ShapeStyle, TextStyle,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;

/// The box; the diagram is in the plane z = 0.
const BOX: Aabb = Aabb {
    min: vec3(2.0, 1.0, -1.0),
    max: vec3(5.0, 3.0, 1.0),
};

/// What the diagram shows of the plane.
const VIEW: Aabb = Aabb {
    min: vec3(0.0, 0.0, 0.0),
    max: vec3(7.0, 4.0, 0.0),
};

/// Size of the text, in pixels of the canvas.
const TEXT: f64 = 31.0;

/// A chart whose coordinates are metres in the plane.
type Plane<'a, 'b> =
    ChartContext<'a, BitMapBackend<'b>, Cartesian2d<RangedCoordf32, RangedCoordf32>>;

type Drawn = Result<(), Box<dyn Error>>;

/// The slabs' diagram: for a hit and a miss, the plane on the left and the ray's t axis on the right.
///
/// # Errors
/// If it cannot be drawn.
pub fn diagram() -> Result<Image, Box<dyn Error>> {
    figure(1000, 600, |canvas| {
        let (hit, miss) = canvas.split_vertically(600);
        draw_row(&hit, "A hit", vec3(0.0, 0.3, 0.0), vec3(1.0, 0.58, 0.0))?;
        draw_row(&miss, "A miss", vec3(0.0, 0.8, 0.0), vec3(1.0, 1.16, 0.0))
    })
}

fn draw_row(canvas: &Canvas, title: &str, origin: Vec3, toward: Vec3) -> Drawn {
    let ray = Ray::new(origin, Dir3::new_or(toward, Dir3::X));
    let (plane, axis) = canvas.split_horizontally(1060);
    draw_plane(&plane, title, &ray)?;
    draw_axis(&axis, &ray)
}

/// The slab along x or along y: the box without an end in the other directions.
fn slab_along(axis: usize) -> Aabb {
    let mut slab = Aabb::EVERYTHING;
    slab.min[axis] = BOX.min[axis];
    slab.max[axis] = BOX.max[axis];
    slab
}

/// The box, its slabs, the ray, and where the ray meets their planes.
fn draw_plane(canvas: &Canvas, title: &str, ray: &Ray) -> Drawn {
    let mut chart = ChartBuilder::on(canvas)
        .margin(20)
        .caption(title, style(1.2 * TEXT))
        .build_cartesian_2d(0.0..VIEW.max.x, 0.0..VIEW.max.y)?;
    let (min, max) = (BOX.min, BOX.max);
    for (colour, [a, b]) in [
        (BLUE, [(min.x, 0.0), (max.x, VIEW.max.y)]),
        (VERMILION, [(0.0, min.y), (VIEW.max.x, max.y)]),
    ] {
        chart.draw_series([Rectangle::new([a, b], colour.mix(0.2).filled())])?;
    }
    let outline = ShapeStyle::from(INK).stroke_width(4);
    chart.draw_series([Rectangle::new([(min.x, min.y), (max.x, max.y)], outline)])?;
    let label = |text: &'static str, x: f32, y: f32, colour: RGBColor| {
        Text::new(text, (x, y), centred(TEXT, colour))
    };
    chart.draw_series([
        label("x slab", 0.5 * (min.x + max.x), 0.25, BLUE),
        label("y slab", 6.35, 2.0, VERMILION),
    ])?;

    draw_arrow(&mut chart, ray)?;
    for (axis, colour) in [(0, BLUE), (1, VERMILION)] {
        if let Some(inside) = slab::clip(&slab_along(axis), ray, Interval::AHEAD) {
            let meets = [inside.min, inside.max].map(|t| ray.at(t));
            let seen = meets.into_iter().filter(|&p| VIEW.contains(p));
            chart.draw_series(seen.map(|p| Circle::new((p.x, p.y), 10, colour.filled())))?;
        }
    }
    Ok(())
}

/// The ray as an arrow, from its origin to where it leaves the view.
fn draw_arrow(chart: &mut Plane, ray: &Ray) -> Drawn {
    let end = slab::clip(&VIEW, ray, Interval::AHEAD).map_or(1.0, |inside| inside.max);
    let tip = ray.at(end - 0.15);
    let back = tip - 0.3 * *ray.direction;
    let side = 0.1 * vec3(-ray.direction.y, ray.direction.x, 0.0);
    let shaft = [ray.origin, back].map(|p| (p.x, p.y));
    let head = [tip, back + side, back - side].map(|p| (p.x, p.y));
    let line = ShapeStyle::from(INK).stroke_width(5);
    chart.draw_series([PathElement::new(shaft, line)])?;
    chart.draw_series([Polygon::new(head, INK.filled())])?;
    Ok(())
}

/// The t axis, and above it the interval of each slab, and of both.
fn draw_axis(canvas: &Canvas, ray: &Ray) -> Drawn {
    const END: f32 = 8.0;
    let mut chart = ChartBuilder::on(canvas)
        .margin(20)
        .margin_right(40)
        .x_label_area_size(80)
        .y_label_area_size(20)
        .build_cartesian_2d(0.0..END, 0.0..4.0_f32)?;
    chart
        .configure_mesh()
        .disable_y_mesh()
        .disable_y_axis()
        .light_line_style(FAINT.mix(0.0))
        .bold_line_style(FAINT.mix(0.5))
        .x_desc("t: distance along the ray, in metres")
        .label_style((FONT, TEXT))
        .axis_desc_style((FONT, TEXT))
        .draw()?;
    let rows = [
        (3.0, "in the x slab", BLUE, slab_along(0)),
        (2.0, "in the y slab", VERMILION, slab_along(1)),
        (0.8, "in both: from t_near to t_far", GREEN, BOX),
    ];
    for (y, text, colour, bounds) in rows {
        let inside = slab::clip(&bounds, ray, Interval::AHEAD);
        let (text, from) = inside.map_or(("in both: never", 0.2), |inside| (text, inside.min));
        if let Some(Interval { min, max }) = inside {
            chart.draw_series([Rectangle::new([(min, y), (max, y + 0.35)], colour.filled())])?;
        }
        chart.draw_series([Text::new(
            text,
            (from, y + 0.75),
            (FONT, TEXT).into_font().color(&colour),
        )])?;
    }
    Ok(())
}

fn style(size: f64) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}

fn centred(size: f64, colour: RGBColor) -> TextStyle<'static> {
    let middle = Pos::new(HPos::Center, VPos::Center);
    (FONT, size).into_font().color(&colour).pos(middle)
}
