//! Chapter 14: `refract`, `fresnel`.

mod fresnel;
mod refract;

use crate::grade::examine::Examiner;
use crate::workbook::exercises::ch14_refraction::{Fresnel, Refract};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&Refract, &Fresnel];
