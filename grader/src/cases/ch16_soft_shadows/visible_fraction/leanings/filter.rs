//! The weights of fractions in a sum that tells most of a bias, whether their random numbers are the same or not.

use super::{LATTICE, Point};

/// The covariance of two fractions that have the same random numbers.
fn covariance(one: &Point, other: &Point) -> f64 {
    let both = one.seen.iter().zip(&other.seen);
    let both = both.filter(|(one, other)| **one && **other).count();
    let share = both as f64 / one.seen.len() as f64;
    (share - one.fraction * other.fraction) / one.samples.max(other.samples)
}

/// A filter that is matched to the covariances of fractions.
pub(super) struct Filter {
    /// The lower triangle L of the covariances C = L·Lᵀ (Cholesky).
    lower: Vec<Vec<f64>>,
}

impl Filter {
    /// For fractions that have random numbers of their own, or may have the same ones.
    pub(super) fn new(points: &[Point], independent: bool) -> Self {
        let mut lower = covariances(points, independent);
        factor(&mut lower);
        Self { lower }
    }

    /// The weights C⁻¹b of the sum that tells most of these biases b. For fractions with random numbers of their own they are b/σ².
    pub(super) fn weights(&self, biases: Vec<f64>) -> Vec<f64> {
        solved(&self.lower, biases)
    }
}

/// The covariances of all fractions, below the diagonal and on it, as the mean of two extremes: all have random numbers of their own, and all have the
/// same ones. So the weights of a filter that is matched to them are good in either.
fn covariances(points: &[Point], independent: bool) -> Vec<Vec<f64>> {
    let of_two = |i: usize, j: usize| match () {
        () if i == j => points[i].variance,
        () if independent => 0.0,
        () => 0.5 * covariance(&points[i], &points[j]),
    };
    let row = |i: usize| (0..=i).map(|j| of_two(i, j)).collect();
    (0..points.len()).map(row).collect()
}

/// The lower triangle L of a matrix C = L·Lᵀ, in its place (Cholesky).
fn factor(matrix: &mut [Vec<f64>]) {
    for i in 0..matrix.len() {
        for j in 0..=i {
            let before: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - before;
            matrix[i][j] = if i == j {
                // Each has the lattice's variance of its own.
                rest.max(LATTICE * LATTICE * 1e-3).sqrt()
            } else {
                rest / matrix[j][j]
            };
        }
    }
}

/// The solution x of L·Lᵀ·x = b.
fn solved(lower: &[Vec<f64>], mut b: Vec<f64>) -> Vec<f64> {
    for i in 0..b.len() {
        let before: f64 = (0..i).map(|k| lower[i][k] * b[k]).sum();
        b[i] = (b[i] - before) / lower[i][i];
    }
    for i in (0..b.len()).rev() {
        let after: f64 = (i + 1..b.len()).map(|k| lower[k][i] * b[k]).sum();
        b[i] = (b[i] - after) / lower[i][i];
    }
    b
}
