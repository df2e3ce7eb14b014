//! The lobes of Phong and of Blinn, side by side.

use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::{CENTRE, Canvas, Figure, figure, text, write};
use crate::kit::numbers::whole;
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::{axis::Axis, stage::Drawn};
use glam::{Vec3, vec3};
use plotters::prelude::{Color, PathElement, Polygon, RGBColor};
use raybook::image::rgb::Rgb;
use raybook::light::LightSample;
use raybook::material::{blinn_phong::BlinnPhong, phong::Phong};
use raybook::math::dir3::Dir3;

/// From the normal to the light in the right drawing, in degrees.
const RIGHT: f32 = 70.0;

/// How far the left drawing may reach to a side, and the length of its longest line with the letter at its end, in pixels of the
/// canvas.
const REACH: f32 = 476.0;
const LONGEST: f32 = 740.0;

/// The length of 1 in the left drawing, and where the point is, in pixels of the canvas.
const LENGTH: f32 = 620.0;
const POINT: (f32, f32) = (480.0, 830.0);

/// The share of a highlight that goes to the viewer.
type Share = Box<dyn Fn(Dir3, &LightSample) -> f32>;

/// A highlight alone, as a curve: its name, the share that goes to the viewer, its colour and its width.
struct Lobe {
    name: String,
    share: Share,
    colour: RGBColor,
    width: u32,
}

/// Phong's lobe for an exponent, and Blinn's lobes for four times this exponent and for the same exponent.
fn lobes(exponent: f32) -> [Lobe; 3] {
    let phong = highlight(exponent);
    let [wide, narrow] = [1.0, 4.0].map(|times| BlinnPhong(highlight(times * exponent)));
    let four = 4.0 * exponent;
    [
        Lobe {
            name: format!("Phong, α = {exponent}"),
            share: Box::new(move |v, l| phong.reflect(Dir3::Z, v, l).r),
            colour: BLUE,
            width: 9,
        },
        Lobe {
            name: format!("Blinn, α′ = 4α = {four}"),
            share: Box::new(move |v, l| narrow.reflect(Dir3::Z, v, l).r),
            colour: VERMILION,
            width: 4,
        },
        Lobe {
            name: format!("Blinn, α′ = α = {exponent}"),
            share: Box::new(move |v, l| wide.reflect(Dir3::Z, v, l).r),
            colour: ORANGE,
            width: 4,
        },
    ]
}

/// The lobes on the left in polar coordinates in the plane of light and normal, on the right over the angle out of that plane. On
/// the left, the light is `incidence` degrees from the normal. Phong's highlight has this exponent.
///
/// # Errors
/// What plotters reports.
pub(super) fn draw(exponent: f32, incidence: f32) -> Figure {
    let lobes = lobes(exponent);
    figure(960, 480, |canvas| {
        let (left, right) = canvas.split_horizontally(960);
        in_plane(&left, &lobes, incidence)?;
        across(&right, &lobes)
    })
}

/// A highlight without a diffuse part; its peak is as bright as the light that arrives.
fn highlight(exponent: f32) -> Phong {
    Phong {
        ambient: Rgb::BLACK,
        diffuse: Rgb::BLACK,
        specular: Rgb::WHITE,
        exponent,
    }
}

/// The direction at these angles, in degrees, from the normal, +z, and around it, from +x.
fn direction(from_normal: f32, around: f32) -> Dir3 {
    let ((s, c), (sin, cos)) = (
        from_normal.to_radians().sin_cos(),
        around.to_radians().sin_cos(),
    );
    Dir3::new_or(vec3(s * cos, s * sin, c), Dir3::Z)
}

/// Light that comes from the left, at this angle from the normal.
fn light(degrees: f32) -> LightSample {
    LightSample {
        toward: direction(degrees, 180.0),
        distance: f32::INFINITY,
        arriving: Rgb::WHITE,
        pdf: f32::INFINITY,
    }
}

/// The lobes as curves around the point: the distance of the curve is the share of the light that goes in this direction.
fn in_plane(canvas: &Canvas, lobes: &[Lobe], incidence: f32) -> Drawn {
    let at = |d: Vec3, length: f32| {
        (
            (POINT.0 + length * d.x) as i32,
            (POINT.1 - length * d.z) as i32,
        )
    };
    let line = |from, to, colour: RGBColor, width| {
        canvas.draw(&PathElement::new(
            vec![from, to],
            colour.stroke_width(width),
        ))
    };
    let surface = [at(Vec3::NEG_X, 420.0), at(Vec3::X, 420.0)];
    let below = surface.map(|(x, y)| (x, y + 40));
    canvas.draw(&Polygon::new(
        vec![surface[0], surface[1], below[1], below[0]],
        FAINT.mix(0.5),
    ))?;
    line(surface[0], surface[1], INK, 5)?;
    let light = light(incidence);
    // Under slanting light all is drawn smaller, so that it stays within the drawing.
    let scale = (REACH / (LONGEST * incidence.to_radians().sin())).min(1.0);
    for lobe in lobes {
        let views = (-180..=180).map(|i| direction(0.5 * i as f32, 0.0));
        let length = |v| scale * LENGTH * (lobe.share)(v, &light);
        let curve = views.map(|v| at(*v, length(v))).collect();
        canvas.draw(&PathElement::new::<Vec<_>, _>(
            curve,
            lobe.colour.stroke_width(lobe.width),
        ))?;
    }
    let mirrored = direction(incidence, 0.0);
    for (name, d, length) in [
        ("n", Vec3::Z, 640.0),
        ("l", *light.toward, 640.0),
        ("m", *mirrored, 700.0),
    ] {
        line(at(d, 0.0), at(d, scale * length), INK, 3)?;
        write(
            canvas,
            name,
            at(d, scale * length + 40.0),
            text(40).pos(CENTRE),
        )?;
    }
    let title = "in the plane of light and normal";
    write(canvas, title, (480, 60), text(36).pos(CENTRE))
}

/// The lobes over the angle by which the viewer is turned out of the plane, around the normal.
fn across(canvas: &Canvas, lobes: &[Lobe]) -> Drawn {
    let mut chart = Chart::new(
        Axis::linear(-65.0..65.0)
            .named("angle around the normal from m")
            .labels(7)
            .format(|degrees| format!("{}°", whole(degrees))),
        Axis::linear(0.0..1.35) // the legend stands above the curves
            .named("fraction of the peak")
            .marks(&[0.0, 0.2, 0.4, 0.6, 0.8, 1.0]),
    )
    .titled(&format!(
        "turned out of that plane, {RIGHT}° from the normal"
    ))
    .text(30)
    .legend(Corner::UpperLeft);
    let light = light(RIGHT);
    for lobe in lobes {
        let angles = (-260..=260).map(|i| 0.25 * i as f32);
        let share = |around| (lobe.share)(direction(RIGHT, around), &light);
        let curve = angles.map(|around| (around, share(around)));
        let stroke = lobe.colour.stroke_width(lobe.width);
        chart.line(curve, stroke).named(&lobe.name);
    }
    chart.draw(canvas)
}
