//! Whether two pictures show the same: their sizes, then tolerances, each of which catches another kind of error.
//!
//! ```
//! use raybook::image::compare::{Difference, Tolerance, compare};
//! use raybook::prelude::*;
//!
//! let gray = |v: f32| Image::from_fn(8, 8, |_, _| Rgb::gray(v));
//! let again = Tolerance::RENDERED_AGAIN;
//! assert!(compare(&gray(0.5), &gray(0.5001), &again).is_ok());
//! // 1 % in every pixel is invisible, but is an error of the whole picture.
//! assert!(matches!(compare(&gray(0.5), &gray(0.505), &again), Err(Difference::Mean { .. })));
//! ```

use crate::image::Image;

/// How much a picture may differ from the expected one.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    /// A channel may differ by this fraction of the expected value …
    pub relative: f32,
    /// … plus this much, before its pixel counts as an outlier.
    pub absolute: f32,
    /// Maximum fraction of the pixels that are outliers: on a silhouette, another processor may round differently.
    pub outliers: f32,
    /// Maximum number of pixels in a cluster. Outliers that touch, also at corners, form a cluster.
    pub cluster: usize,
    /// Maximum difference of the two pictures' means, as a fraction: it finds errors that are small but everywhere.
    pub mean: f32,
}

impl Tolerance {
    /// For a picture rendered again by the same program, perhaps on another processor, whose `sin` or `pow` may differ
    /// in the last bit, so that a ray on a silhouette hits something else.
    ///
    /// Measured with every ray's direction moved by an ulp, which is worse: in chapter 2's scene half of the channels
    /// change by less than 1e-7, 99 % by less than 5e-4, and the worst, waves at kilometres' distance, by 4e-3.
    /// On the other hand, an error of 1 % in a part of the picture, or radiance that was rounded to bytes, must be found:
    /// for this the sum of `relative` and `absolute` must be below 0.004 (`tests/library/ch02_hdr` has the table).
    /// A pixel or two may differ on a silhouette, or three in a row along an edge; a dead column is more.
    pub const RENDERED_AGAIN: Self = Self {
        relative: 0.002,
        absolute: 0.001,
        outliers: 0.004,
        cluster: 3,
        mean: 0.001,
    };
}

/// The first test that a picture failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Difference {
    /// Not the same size.
    #[error("the picture is {} × {} pixels, {} × {} were expected", actual.0, actual.1, expected.0, expected.1)]
    Size {
        /// Width and height expected.
        expected: (usize, usize),
        /// Width and height found.
        actual: (usize, usize),
    },
    /// A channel is NaN or infinite, in either picture: then a difference means nothing.
    #[error("pixel ({x}, {y}) is not a finite number")]
    NotFinite {
        /// Column.
        x: usize,
        /// Row.
        y: usize,
    },
    /// Too bright or too dark as a whole.
    #[error("the mean is {actual}, {expected} was expected: {:+.2} %", 100.0 * (actual / expected - 1.0))]
    Mean {
        /// Mean over all channels of the expected picture.
        expected: f32,
        /// Mean over all channels of the picture.
        actual: f32,
    },
    /// Outliers side by side: a dead column, a shifted edge.
    #[error("{size} neighbouring pixels differ, the first at ({x}, {y})")]
    Cluster {
        /// Pixels in the largest cluster.
        size: usize,
        /// Column of its first pixel.
        x: usize,
        /// Row of its first pixel.
        y: usize,
    },
    /// Too many outliers in all.
    #[error("{count} pixels differ, at most {allowed} may; the first is ({x}, {y})")]
    Outliers {
        /// Outliers found.
        count: usize,
        /// Outliers allowed.
        allowed: usize,
        /// Column of the first.
        x: usize,
        /// Row of the first.
        y: usize,
    },
}

/// Compares a picture with the expected one.
///
/// # Errors
/// The first [`Difference`] in this order: size, finiteness, mean, clusters, number of outliers.
pub fn compare(expected: &Image, actual: &Image, tolerance: &Tolerance) -> Result<(), Difference> {
    let (width, height) = (expected.width(), expected.height());
    if (width, height) != (actual.width(), actual.height()) {
        return Err(Difference::Size {
            expected: (width, height),
            actual: (actual.width(), actual.height()),
        });
    }
    let finite =
        |picture: &Image, i: usize| picture.pixels()[i].channels().iter().all(|v| v.is_finite());
    if let Some(i) = (0..width * height).find(|&i| !finite(actual, i) || !finite(expected, i)) {
        return Err(Difference::NotFinite {
            x: i % width,
            y: i / width,
        });
    }
    let (expected_mean, actual_mean) = (mean(expected), mean(actual));
    if (actual_mean - expected_mean).abs() > tolerance.mean * expected_mean.abs() {
        return Err(Difference::Mean {
            expected: expected_mean,
            actual: actual_mean,
        });
    }
    let mut outlier: Vec<bool> = expected
        .pixels()
        .iter()
        .zip(actual.pixels())
        .map(|(e, a)| {
            let far = |(e, a): (f32, f32)| {
                (a - e).abs() > tolerance.absolute + tolerance.relative * e.abs()
            };
            e.channels().into_iter().zip(a.channels()).any(far)
        })
        .collect();
    let count = outlier.iter().filter(|&&far| far).count();
    let Some(first) = outlier.iter().position(|&far| far) else {
        return Ok(());
    };
    let (start, size) = largest_cluster(&mut outlier, width);
    if size > tolerance.cluster {
        return Err(Difference::Cluster {
            size,
            x: start % width,
            y: start / width,
        });
    }
    let allowed = (tolerance.outliers * (width * height) as f32) as usize;
    if count > allowed {
        return Err(Difference::Outliers {
            count,
            allowed,
            x: first % width,
            y: first / width,
        });
    }
    Ok(())
}

/// Mean over all channels of all pixels; summed in `f64`, so that the sum of millions of pixels loses no digits.
fn mean(picture: &Image) -> f32 {
    let sum: f64 = picture
        .pixels()
        .iter()
        .flat_map(|p| p.channels())
        .map(f64::from)
        .sum();
    (sum / (3 * picture.pixels().len()).max(1) as f64) as f32
}

/// The first pixel and the size of the largest group of marked pixels that touch; unmarks them all.
fn largest_cluster(marked: &mut [bool], width: usize) -> (usize, usize) {
    let mut largest = (0, 0);
    for start in 0..marked.len() {
        let mut size = 0;
        let mut open = vec![start];
        while let Some(i) = open.pop() {
            if !std::mem::take(&mut marked[i]) {
                continue;
            }
            size += 1;
            let (x, y) = (i % width, i / width);
            for ny in y.saturating_sub(1)..=(y + 1).min(marked.len() / width - 1) {
                for nx in x.saturating_sub(1)..=(x + 1).min(width - 1) {
                    open.push(ny * width + nx);
                }
            }
        }
        if size > largest.1 {
            largest = (start, size);
        }
    }
    largest
}
