//! The angle of a ray that is followed only from a fixed distance before the hole to the same distance behind.

use glam::DVec3;
use raybook::render::curved::deflection::deflection_angle;
use raybook::render::curved::{HORIZON, Photon, geodesic::geodesic_step};
use raybook_workbook::exercises::ch21_black_hole::DeflectionAngle;

/// The angle by which a ray turns that starts at x = −`distance` and y = b along +x, until it is as far from the hole again; none if it falls in.
pub(super) fn followed(q: &DeflectionAngle, distance: f64) -> Option<f32> {
    /// A step's length, as a share of the way to the hole.
    const STEP: f64 = 0.003;
    /// A ray that circles for longer never gets away.
    const MOST: u32 = 100_000;
    let mut photon = Photon {
        x: DVec3::new(-distance, q.impact_parameter.into(), 0.0),
        v: DVec3::X,
    };
    let far = photon.x.length();
    let mut turned = 0.0;
    for _ in 0..MOST {
        let r = photon.x.length();
        if r < HORIZON {
            return None;
        }
        if r > far && photon.x.dot(photon.v) > 0.0 {
            return Some(f64::abs(turned) as f32);
        }
        let before = photon.v;
        photon = geodesic_step(photon, STEP * r).0;
        turned += before.cross(photon.v).z.atan2(before.dot(photon.v));
    }
    None
}

/// The distance, a round one, from which such a ray turns by this angle.
///
/// A ray that starts at the distance d along +x has the impact parameter β = b/√(1 − b²/r³), with r² = d² + b²: its energy is less than 1. Farther
/// away than d the hole turns a nearly straight ray by the share L = 1 − d (3β² + 2d²)/(2r³) of 2/β, with r² = d² + β². What the whole angle α(β) is
/// more than 2/β comes from nearer to the hole, and about L² of that from farther away: measured for d from 10 on and b up to 125, this gives d to
/// 1.5 parts in 100.
pub(super) fn distance_of(b: f64, got: f64) -> Option<f64> {
    /// Distances that students take.
    const ROUND: [f64; 12] = [
        10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 100.0, 200.0, 300.0, 500.0, 1000.0,
    ];
    /// By which share a distance may be off.
    const NEARLY: f64 = 0.015;
    /// Between which distances it is looked for.
    const RANGE: [f64; 2] = [5.0, 2000.0];
    /// Number of halvings of the range, after which it is known to 1 part in 1000.
    const HALVINGS: u32 = 13;
    let angle = |d: f64| {
        let energy = (1.0 - b * b / d.hypot(b).powi(3)).sqrt();
        let own = b / energy;
        let kept = d * (3.0 * own * own + 2.0 * d * d) / (2.0 * d.hypot(own).powi(3));
        let (straight, lost) = (2.0 / own, 1.0 - kept);
        let whole = deflection_angle(own)?;
        Some(whole - lost * straight - lost * lost * (whole - straight))
    };
    let [mut near, mut far] = RANGE;
    for _ in 0..HALVINGS {
        let middle = (near * far).sqrt();
        if angle(middle)? < got {
            near = middle;
        } else {
            far = middle;
        }
    }
    let is_near = |round: &f64| (near / round - 1.0).abs() < NEARLY;
    ROUND.into_iter().find(is_near)
}

/// The angle of a ray whose way begins at some `times` b, there with the slope du/dφ = 1/b of a ray that comes from infinity, where u = 1/r: it has
/// a little more energy, and the angle from infinity on is left out.
pub(super) fn begun_at(q: &DeflectionAngle, times: f64) -> Option<f32> {
    /// Parts of the sum of the angle that is left out, which is nearly that of a straight ray.
    const PARTS: u32 = 100;
    let b = f64::from(q.impact_parameter);
    let begin = 1.0 / (times * b);
    let square = 1.0 / (b * b) + begin * begin - begin.powi(3);
    let step = begin / f64::from(PARTS);
    let slope = |u: f64| (square - u * u + u.powi(3)).sqrt();
    let before: f64 = (0..PARTS)
        .map(|i| step / slope((f64::from(i) + 0.5) * step))
        .sum();
    deflection_angle(1.0 / square.sqrt()).map(|whole| (whole - before) as f32)
}

/// How many times its impact parameter a ray is away where an angle of this size begins to count, or ends to: a round number. It is looked for only
/// far from the hole, where the ray is nearly straight.
pub(super) fn left_out(b: f64, missing: f64) -> Option<f64> {
    /// Multiples that students take.
    const ROUND: [f64; 9] = [5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 100.0];
    /// By which share the angle may be off.
    const NEARLY: f64 = 0.01;
    /// The least impact parameter in this sense.
    const FAR: f64 = 4.0;
    let is_near = |times: &f64| (missing / (1.0 / times).asin() - 1.0).abs() < NEARLY;
    ROUND.into_iter().find(is_near).filter(|_| b > FAR)
}
