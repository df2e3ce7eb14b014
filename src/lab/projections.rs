//! The fisheye's projections by name, as on a command line and in captions.

use crate::camera::fisheye::Projection;

/// How a fisheye draws its disc.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Projections {
    /// Equal angles are equally long
    Equidistant,
    /// Equal solid angles have equal areas
    Equisolid,
    /// Small things keep their shapes
    Stereographic,
    /// As seen in a mirror ball from far away
    Orthographic,
}

impl Projections {
    /// The projection.
    pub fn projection(self) -> Projection {
        match self {
            Self::Equidistant => Projection::Equidistant,
            Self::Equisolid => Projection::Equisolid,
            Self::Stereographic => Projection::Stereographic,
            Self::Orthographic => Projection::Orthographic,
        }
    }
}
