//! The fisheye's projections by name, as on a command line.

use crate::camera::fisheye::Projection;
use clap::ValueEnum;
use clap::builder::PossibleValue;

impl ValueEnum for Projection {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self {
            Self::Equidistant => ("equidistant", "Equal angles are equally long"),
            Self::Equisolid => (
                "equisolid",
                "Equal solid angles have equal areas, as in a mirror ball seen from far away",
            ),
            Self::Stereographic => ("stereographic", "Small things keep their shapes"),
            Self::Orthographic => (
                "orthographic",
                "As a globe looks from far away; at most 180°",
            ),
        };
        Some(PossibleValue::new(name).help(help))
    }
}
