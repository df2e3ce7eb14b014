//! What others published: pictures, of which `tests/published/README.md` says whose they are, and numbers. Above each table of numbers
//! stand author, year and place; where these gave a formula, the test says how its values were computed.

mod deflection;
mod fresnel;
mod pictures;
mod slopes;
mod view_factors;
