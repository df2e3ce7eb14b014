//! The domain: the lengths for which every answer of the library holds.
//!
//! Numbers are `f32`, and a hit test multiplies three lengths: such a product must neither vanish nor overflow. So there is
//! one statement for all shapes, structures and readers:
//!
//! | what | must be |
//! |---|---|
//! | coordinates of corners, centres and ray origins | finite, at most [`LARGEST`] from 0 along each axis |
//! | a mesh | at least [`SMALLEST`] long along one axis, or a single place |
//! | a radius | from 0 to [`LARGEST`] |
//!
//! Inside the domain every accelerator finds the hit that the list finds, and no other. A single triangle may be as small as it
//! likes, or have no area: it is hit as far as rounding can tell.
//!
//! Numbers from outside are checked where they are read: [`Mesh::new`](crate::shape::mesh::Mesh::new), and with it every
//! reader of meshes, and [`Sphere::checked`](crate::shape::sphere::Sphere::checked) refuse what is not in the domain, and say
//! why. An accelerator over shapes that are too large, or have no bounds, as a plane, asks each of them for every ray. A ray
//! that starts outside the domain may miss what it should hit, but it hits nothing that it should miss.

/// The largest |coordinate| and the largest radius, in metres: a million kilometres.
pub const LARGEST: f32 = 1e9;

/// The least extent of a mesh along its longest axis, in metres: a nanometre.
pub const SMALLEST: f32 = 1e-9;

/// The least area of which the product with a length still has all its digits: 2⁻⁸⁴ m².
pub(crate) const AREA_MIN: f32 = 1.0 / (1_u128 << 84) as f32;

/// The largest such area: 2⁸⁰ m².
pub(crate) const AREA_MAX: f32 = (1_u128 << 80) as f32;
