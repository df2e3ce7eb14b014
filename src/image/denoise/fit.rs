//! A plane through colours: a first-order function of what is known of each pixel, by weighted least squares.

use super::Guide;
use super::alike::WINDOW;
use crate::image::rgb::Rgb;

/// Number of terms: 1, two of the place, and seven of the guide.
const TERMS: usize = 10;

/// The terms and the three channels, side by side; the rest is 0.
const ROW: usize = 16;

/// How much the squares of each term are enlarged, as a share: so that a term that hardly changes, or follows from others, cannot
/// explain noise (ridge regression, Hoerl and Kennard 1970).
const RIDGE: f32 = 1e-3;

/// The same for a term that does not change at all.
const UNCHANGED: f32 = 1e-6;

/// What a colour depends on: 1, the place, and the guide.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms([f32; TERMS]);

impl Terms {
    /// Of a pixel in this column and row.
    pub(super) fn of([x, y]: [usize; 2], guide: Guide) -> Self {
        let [r, g, b] = guide.colour.channels();
        let [nx, ny, nz] = guide.normal.to_array();
        let [x, y] = [x, y].map(|i| i as f32 / WINDOW as f32);
        Self([1.0, x, y, nx, ny, nz, r, g, b, guide.nearness])
    }

    /// Relative to a centre, but for the 1.
    #[must_use]
    pub(super) fn from(&self, centre: &Self) -> Self {
        let mut terms = self.0;
        for (term, origin) in terms.iter_mut().zip(centre.0).skip(1) {
            *term -= origin;
        }
        Self(terms)
    }
}

/// A plane that is being fitted: the sums of weighted products, of which the normal equations consist.
#[derive(Clone, Debug, Default)]
pub(super) struct Fit {
    /// Σ w tᵢ tⱼ, and, from column [`TERMS`] on, Σ w tᵢ colour.
    sums: [[f32; ROW]; TERMS],
}

impl Fit {
    /// Adds a colour, with a weight.
    #[inline]
    pub(super) fn add(&mut self, weight: f32, Terms(terms): &Terms, colour: Rgb) {
        let mut row = [0.0; ROW];
        row[..TERMS].copy_from_slice(terms);
        row[TERMS..][..3].copy_from_slice(&colour.channels());
        for (sums, term) in self.sums.iter_mut().zip(terms) {
            let share = weight * term;
            for (sum, other) in sums.iter_mut().zip(&row) {
                *sum += share * other;
            }
        }
    }

    /// The plane for which Σ w |colour − plane|² is least, but for the ridge.
    ///
    /// Gaussian elimination; without pivots, for the matrix is symmetric and positive definite.
    pub(super) fn solve(mut self) -> Plane {
        let sums = &mut self.sums;
        let all = sums[0][0];
        for (i, sums) in sums.iter_mut().enumerate().skip(1) {
            sums[i] += RIDGE * sums[i] + UNCHANGED * all;
        }
        for i in 0..TERMS {
            let pivot = sums[i];
            for row in &mut sums[i + 1..] {
                let share = row[i] / pivot[i];
                for (sum, above) in row.iter_mut().zip(&pivot) {
                    *sum -= share * above;
                }
            }
        }
        let mut slopes = [Rgb::BLACK; TERMS];
        for i in (0..TERMS).rev() {
            let [r, g, b] = [0, 1, 2].map(|channel| sums[i][TERMS + channel]);
            let known = (i + 1..TERMS).map(|j| slopes[j] * sums[i][j]).sum::<Rgb>();
            slopes[i] = (Rgb::new(r, g, b) + known * -1.0) / sums[i][i];
        }
        Plane(slopes)
    }
}

/// A colour as a first-order function: the sum of terms times these.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane([Rgb; TERMS]);

impl Plane {
    /// Its colour; not below black.
    #[inline]
    pub(super) fn at(&self, Terms(terms): &Terms) -> Rgb {
        let colour: Rgb = self
            .0
            .iter()
            .zip(terms)
            .map(|(slope, term)| *slope * *term)
            .sum();
        Rgb::new(colour.r.max(0.0), colour.g.max(0.0), colour.b.max(0.0))
    }
}
