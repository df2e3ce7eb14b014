//! The fisheye's projections by name, as on a command line.

use clap::ValueEnum;
use clap::builder::PossibleValue;
use raybook::camera::fisheye::Projection;

/// A projection that is chosen by its name.
#[derive(Clone, Copy, Debug)]
pub(super) struct Named(pub(super) Projection);

impl ValueEnum for Named {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [Named; Projection::ALL.len()] = {
            let [a, b, c, d] = Projection::ALL;
            [Named(a), Named(b), Named(c), Named(d)]
        };
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self.0 {
            Projection::Equidistant => (
                "equidistant",
                "Equal angles from the axis are equal lengths on the film",
            ),
            Projection::Equisolid => (
                "equisolid",
                "Equal solid angles have equal areas, as in a mirror ball seen from far away",
            ),
            Projection::Stereographic => ("stereographic", "Small objects keep their shapes"),
            Projection::Orthographic => (
                "orthographic",
                "As a globe seen from far away; at most 180°",
            ),
        };
        Some(PossibleValue::new(name).help(help))
    }
}
