//! A plane through colours: a first-order function of what is known of each pixel, by weighted least squares.

use super::Guide;
use super::alike::WINDOW;
use crate::image::rgb::Rgb;
use std::array;

/// How much the squares of each term are enlarged, as a share: so that a term that hardly changes, or follows from others, cannot
/// explain noise (ridge regression, Hoerl and Kennard 1970).
const RIDGE: f32 = 1e-3;

/// The same for a term that does not change at all.
const UNCHANGED: f32 = 1e-6;

/// Number of terms: 1, and two of the place.
pub(crate) const PLACE: usize = 3;

/// Number of terms with a guide, which has seven.
pub(super) const GUIDED: usize = PLACE + 7;

/// What a colour depends on: the first N of 1, the place, and the guide.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Terms<const N: usize>([f32; N]);

impl<const N: usize> Terms<N> {
    /// Of a pixel in this column and row.
    pub(crate) fn of([x, y]: [usize; 2], guide: Guide) -> Self {
        let [r, g, b] = guide.colour.channels();
        let [nx, ny, nz] = guide.normal.to_array();
        let [x, y] = [x, y].map(|i| i as f32 / WINDOW as f32);
        let all: [f32; GUIDED] = [1.0, x, y, nx, ny, nz, r, g, b, guide.nearness];
        Self(array::from_fn(|i| all[i]))
    }

    /// Relative to a centre, but for the 1.
    #[must_use]
    #[inline(always)]
    pub(super) fn from(&self, centre: &Self) -> Self {
        let mut terms = array::from_fn(|i| self.0[i] - centre.0[i]);
        terms[0] = 1.0;
        Self(terms)
    }
}

/// Red, green, blue, and a 0 beside them: a vector of the processor holds four numbers.
type Channels = [f32; 4];

/// Adds a multiple of some numbers to others.
#[inline(always)]
fn add<const N: usize>(sums: &mut [f32; N], factor: f32, others: &[f32; N]) {
    for (sum, other) in sums.iter_mut().zip(others) {
        *sum += factor * other;
    }
}

/// A plane that is being fitted: the sums of weighted products, of which the normal equations consist.
#[derive(Clone, Debug)]
pub(super) struct Fit<const N: usize> {
    /// Σ w tᵢ tⱼ.
    terms: [[f32; N]; N],
    /// Σ w tᵢ colour.
    colours: [Channels; N],
}

impl<const N: usize> Fit<N> {
    /// Through nothing yet.
    pub(super) fn new() -> Self {
        Self {
            terms: [[0.0; N]; N],
            colours: [[0.0; 4]; N],
        }
    }

    /// Adds a colour, with a weight.
    #[inline(always)]
    pub(super) fn add(&mut self, weight: f32, Terms(terms): &Terms<N>, colour: Rgb) {
        let colour = [colour.r, colour.g, colour.b, 0.0];
        let rows = self.terms.iter_mut().zip(&mut self.colours);
        for ((products, colours), term) in rows.zip(terms) {
            add(products, weight * term, terms);
            add(colours, weight * term, &colour);
        }
    }

    /// The plane for which Σ w |colour − plane|² is least, but for the ridge.
    ///
    /// Gaussian elimination; without pivots, for the matrix is symmetric and positive definite.
    #[inline(always)]
    pub(super) fn solve(self) -> Plane<N> {
        let Self {
            mut terms,
            mut colours,
        } = self;
        let all = terms[0][0];
        for (i, row) in terms.iter_mut().enumerate().skip(1) {
            row[i] += RIDGE * row[i] + UNCHANGED * all;
        }
        for i in 0..N {
            let (pivot, colour) = (terms[i], colours[i]);
            for j in i + 1..N {
                let share = terms[j][i] / pivot[i];
                add(&mut terms[j], -share, &pivot);
                add(&mut colours[j], -share, &colour);
            }
        }
        let mut slopes = [[0.0; 4]; N];
        for i in (0..N).rev() {
            let mut slope = colours[i];
            for j in i + 1..N {
                add(&mut slope, -terms[i][j], &slopes[j]);
            }
            slopes[i] = slope.map(|channel| channel / terms[i][i]);
        }
        Plane(slopes)
    }
}

/// A colour as a first-order function: the sum of terms times these.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane<const N: usize>([Channels; N]);

impl<const N: usize> Plane<N> {
    /// Its colour; not below black.
    #[inline(always)]
    pub(super) fn at(&self, Terms(terms): &Terms<N>) -> Rgb {
        let mut colour = [0.0; 4];
        for (slope, term) in self.0.iter().zip(terms) {
            add(&mut colour, *term, slope);
        }
        let [r, g, b, _] = colour.map(|channel| channel.max(0.0));
        Rgb::new(r, g, b)
    }
}
