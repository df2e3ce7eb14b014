//! Chapter 14: `refract`, `fresnel`.

mod fresnel;
mod refract;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch14_refraction::{Fresnel, Refract};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&Refract, &Fresnel];
