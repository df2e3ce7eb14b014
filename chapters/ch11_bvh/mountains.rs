//! A mountain range of 320 000 triangles in the evening, searched by a tree, with shadows.

use crate::shared::outdoors::haze;
use glam::vec3;
use raybook::image::rgb::Rgb;
use raybook::math::dir3::Dir3;
use raybook::shape::Surface;

/// Metres of air in front of the mountains for each metre of the model.
const METRES: f32 = 1.8;

/// The y of the direction in which the air ends: behind the mountains, which stand before the horizon.
pub(super) const AIR_ENDS: f32 = -0.16;

/// Where the evening sun stands.
pub(super) fn toward_sun() -> Dir3 {
    Dir3::new_or(vec3(0.80, 0.42, 0.10), Dir3::Y)
}

/// The colour of a point of the mountains at a distance from the eye in metres, in the light of sun and sky, behind the air.
pub(super) fn shade(at: &Surface, distance: f32, in_sunlight: bool) -> Rgb {
    let toward = at.shading_normal.dot(*toward_sun()).max(0.0);
    let sunlight = Rgb::new(2.3, 1.75, 1.15) * if in_sunlight { toward } else { 0.0 };
    let skylight = Rgb::new(0.20, 0.29, 0.44) * (0.5 + 0.5 * at.shading_normal.y);
    haze(ground(at) * (sunlight + skylight), METRES * distance)
}

/// Grass in the valleys, rock on steep slopes, snow on top.
fn ground(at: &Surface) -> Rgb {
    let smooth = |from: f32, to: f32, x: f32| {
        let x = ((x - from) / (to - from)).clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    };
    let (height, level) = (at.position.y, at.shading_normal.y);
    let rock = Rgb::new(0.36, 0.31, 0.27);
    let grass = Rgb::new(0.20, 0.30, 0.09);
    let snow = Rgb::new(0.92, 0.94, 0.98);
    let low = rock.lerp(grass, smooth(0.62, 0.8, level) * smooth(0.9, 0.35, height));
    low.lerp(snow, smooth(0.62, 0.95, height + 0.35 * (level - 0.7)))
}
