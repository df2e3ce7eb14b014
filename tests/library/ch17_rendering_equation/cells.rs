//! The sphere of directions in cells: for integrals, and for Pearson's χ² test of samples against their density.

use glam::vec3;
use raybook::math::{basis::Basis, dir3::Dir3, pcg, pcg::Pcg};
use std::f32::consts::{FRAC_PI_2, PI, TAU};

/// Zones of the hemisphere around an axis, and as many of the other hemisphere. Their borders are at the angles π/2 (i/10)² to the
/// axis: a highlight around the axis has zones of its own, the first of them 0.9° wide, and the horizon is a border.
const ZONES: usize = 10;
/// Sectors of a zone.
const SECTORS: usize = 8;
/// Cells of the sphere.
const CELLS: usize = 2 * ZONES * SECTORS;
/// Points of a cell along each side, for its integral.
const FINE: usize = 16;
/// The golden ratio: the fractional parts of its multiples are spread evenly.
const GOLDEN_RATIO: f32 = 1.618_034;
/// Samples of a χ² test.
const SAMPLES: u32 = 20_000;
/// The expected number of samples that a cell needs: smaller cells count as one.
const ENOUGH: f64 = 5.0;

/// Zones and sectors around an axis.
pub struct Cells(Basis);

impl Cells {
    pub fn around(axis: Dir3) -> Self {
        Self(Basis::around(axis))
    }

    /// The cell of a direction.
    fn of(&self, d: Dir3) -> usize {
        let [x, y, z] = [self.0.x, self.0.y, self.0.z].map(|axis| axis.dot(*d));
        let t = (x.hypot(y).atan2(z.abs()) / FRAC_PI_2).sqrt();
        let zone = ((t * ZONES as f32) as usize).min(ZONES - 1);
        let zone = if z < 0.0 { ZONES + zone } else { zone };
        let sector = ((y.atan2(x) / TAU + 0.5) * SECTORS as f32) as usize;
        zone * SECTORS + sector.min(SECTORS - 1)
    }

    /// ∫ f dω over each cell, by points in rows. Each row is shifted by another part of the step between its points, so that an edge of f
    /// along the rows' columns, as the horizon, lies between points in some rows and not in others.
    fn integrals(&self, f: impl Fn(Dir3) -> f32) -> [f64; CELLS] {
        let around: [_; SECTORS * FINE] =
            std::array::from_fn(|j| (TAU * j as f32 / (SECTORS * FINE) as f32 - PI).sin_cos());
        let mut sums = [0.0; CELLS];
        for i in 0..ZONES * FINE {
            let t = (i as f32 + 0.5) / (ZONES * FINE) as f32;
            let (sin, cos) = (FRAC_PI_2 * t * t).sin_cos();
            // dω = sin θ dθ dφ with θ = π/2 t², so that dθ = π t dt.
            let piece = sin * PI * t / (ZONES * FINE) as f32 * TAU / (SECTORS * FINE) as f32;
            let shift = TAU * (i as f32 * GOLDEN_RATIO).fract() / (SECTORS * FINE) as f32;
            let (sin_shift, cos_shift) = shift.sin_cos();
            for (j, (s, c)) in around.into_iter().enumerate() {
                let sin_phi = s * cos_shift + c * sin_shift;
                let cos_phi = c * cos_shift - s * sin_shift;
                for (half, z) in [cos, -cos].into_iter().enumerate() {
                    let d = vec3(sin * cos_phi, sin * sin_phi, z);
                    let d = Dir3::new(self.0.to_world(d)).expect("a direction");
                    let cell = (half * ZONES + i / FINE) * SECTORS + j / FINE;
                    sums[cell] += f64::from(piece * f(d));
                }
            }
        }
        sums
    }

    /// ∫ f dω over the sphere.
    pub fn integral(&self, f: impl Fn(Dir3) -> f32) -> f64 {
        self.integrals(f).iter().sum()
    }

    /// Pearson's test of samples against their density. A sample may be `None`, with the probability that the density leaves.
    pub fn fit(
        &self,
        density: impl Fn(Dir3) -> f32,
        mut sample: impl FnMut(&mut Pcg) -> Option<Dir3>,
    ) -> Fit {
        let shares = self.integrals(density);
        let mut found = [0_u32; CELLS];
        let mut none = 0;
        let mut rng = pcg::stream(7, 7);
        for _ in 0..SAMPLES {
            match sample(&mut rng) {
                Some(d) => found[self.of(d)] += 1,
                None => none += 1,
            }
        }
        let total: f64 = shares.iter().sum();
        let missing = ((1.0 - total).max(0.0), none);
        let all = shares.into_iter().zip(found).chain([missing]);
        Fit::of(
            total,
            all.map(|(share, n)| (share * f64::from(SAMPLES), f64::from(n))),
        )
    }
}

/// How well samples fit a density.
#[derive(Clone, Copy, Debug)]
pub struct Fit {
    /// ∫ p dω: the density's integral.
    pub total: f64,
    /// χ² = Σ (found − expected)²/expected, over all cells.
    pub chi_squared: f64,
    /// χ² of samples that fit exceeds this once in a million times.
    pub limit: f64,
}

impl Fit {
    /// The fit of cells, each with its expected and its found number.
    fn of(total: f64, cells: impl Iterator<Item = (f64, f64)>) -> Self {
        let (large, small): (Vec<_>, Vec<_>) = cells.partition(|cell| cell.0 >= ENOUGH);
        let sum = small.iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        // A sample where none is expected counts as one of many too many.
        let rest = (sum.0.max(0.1), sum.1);
        let square = |(expected, found): &(f64, f64)| (found - expected).powi(2) / expected;
        Self {
            total,
            chi_squared: large.iter().chain([&rest]).map(square).sum(),
            limit: limit(large.len() as f64),
        }
    }

    pub fn is_good(&self) -> bool {
        self.total < 1.0 + 1e-3 && self.chi_squared < self.limit
    }

    #[track_caller]
    pub fn assert_good(&self, what: &str) {
        assert!(self.is_good(), "{what}: {self:?}");
    }
}

/// The number that χ² with this many degrees of freedom exceeds once in a million times (Wilson and Hilferty 1931): the cube root of
/// χ² is nearly normally distributed.
fn limit(degrees: f64) -> f64 {
    /// The normal distribution's quantile of 1 − 10⁻⁶.
    const QUANTILE: f64 = 4.753;
    let variance = 2.0 / (9.0 * degrees);
    degrees * (1.0 - variance + QUANTILE * variance.sqrt()).powi(3)
}

#[test]
fn the_limit_is_nearly_exact() {
    // χ² of 10 degrees of freedom exceeds x with the probability e^(−x/2) Σ (x/2)^i/i!, i below 5; of 100, i below 50.
    for (degrees, exact) in [(10.0, 46.86), (100.0, 182.13)] {
        let limit = limit(degrees);
        assert!((limit / exact - 1.0).abs() < 0.03, "{degrees}: {limit}");
    }
}

#[test]
fn the_cells_are_the_sphere() {
    for axis in [Dir3::Z, -Dir3::X] {
        let sphere = Cells::around(axis).integral(|_| 1.0);
        assert!(
            (sphere / f64::from(2.0 * TAU) - 1.0).abs() < 1e-4,
            "{sphere}"
        );
    }
}
