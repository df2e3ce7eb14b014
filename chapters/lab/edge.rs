//! An edge through a pixel: the share of the pixel that is covered, and the error of a pattern.

use glam::{DVec2, Vec2};

/// Number of positions at which an edge passes through the pixel.
const STEPS: u32 = 256;

/// The half plane of points p with n·p < d, where n points at an angle, in radians, and d counts from the pixel's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// n.
    pub normal: DVec2,
    /// d, in pixels.
    pub offset: f64,
}

impl Edge {
    /// Whether a point of the unit square is covered.
    pub fn covers(&self, p: Vec2) -> bool {
        self.normal.dot(p.as_dvec2() - 0.5) < self.offset
    }

    /// How far the pixel reaches from its centre along n.
    pub fn reach(normal: DVec2) -> f64 {
        0.5 * normal.abs().element_sum()
    }

    /// The covered share of the unit square, exactly.
    ///
    /// Its derivative by d is the length of the edge in the square: 0 outside, constant between the two middle corners,
    /// and linear in between. So the share is piecewise quadratic.
    pub fn coverage(&self) -> f64 {
        let (a, b) = (self.normal.x.abs(), self.normal.y.abs());
        let (small, large) = (a.min(b), a.max(b));
        let from_left = self.offset + 0.5 * (small + large); // 0 at the first corner
        let width = small + large;
        let corner = |t: f64| {
            if small > 1e-12 {
                t * t / (2.0 * small * large)
            } else {
                0.0
            }
        };
        match from_left {
            t if t <= 0.0 => 0.0,
            t if t >= width => 1.0,
            t if t < small => corner(t),
            t if t > large => 1.0 - corner(width - t),
            t => (t - 0.5 * small) / large,
        }
    }
}

/// The root of the mean squared error of the covered share, over all edges at this angle that pass through the pixel and over
/// realisations of a pattern.
pub fn rms(realisations: &[Vec<Vec2>], angle: f64) -> f64 {
    let normal = DVec2::from_angle(angle);
    let reach = Edge::reach(normal);
    let offsets = (0..STEPS).map(|step| {
        let offset = reach * (2.0 * (f64::from(step) + 0.5) / f64::from(STEPS) - 1.0);
        (offset, Edge { normal, offset }.coverage())
    });
    let edges: Vec<_> = offsets.collect();
    let mut sum = 0.0;
    for points in realisations {
        let along = points.iter().map(|p| normal.dot(p.as_dvec2() - 0.5));
        let mut along: Vec<_> = along.collect();
        along.sort_unstable_by(f64::total_cmp);
        let mut covered = 0;
        for (offset, coverage) in &edges {
            while covered < along.len() && along[covered] < *offset {
                covered += 1;
            }
            sum += (covered as f64 / points.len() as f64 - coverage).powi(2);
        }
    }
    (sum / (realisations.len() * edges.len()) as f64).sqrt()
}
