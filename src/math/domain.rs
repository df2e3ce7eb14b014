//! The domain: the lengths for which every answer of the library holds.
//!
//! Numbers are `f32`, and a hit test multiplies three lengths: the product must neither vanish nor overflow. Therefore the same
//! limits hold for all shapes, structures and readers:
//!
//! | what | must be |
//! |---|---|
//! | coordinates of corners, centres and ray origins | finite, at most [`LARGEST`] from 0 along each axis |
//! | a mesh | at least [`SMALLEST`] long along one axis, or a single place |
//! | a radius | above 0, at most [`LARGEST`] |
//!
//! Inside the domain, every accelerator finds the same hit as the list. A single triangle may be arbitrarily small, or have no
//! area: then it is hit as far as rounding allows.
//!
//! Input is checked where it is read: [`Mesh::new`](crate::shape::mesh::Mesh::new), and with it every reader of meshes, and
//! [`Sphere::checked`](crate::shape::sphere::Sphere::checked) refuse numbers outside the domain, and tell the reason. Shapes that
//! are too large or, like a plane, have no finite box are tested by an accelerator for every ray. A ray that starts outside the
//! domain may miss a shape that it should hit, but it hits no shape that it should miss.
//!
//! ```
//! use raybook::math::domain::LARGEST;
//! use raybook::prelude::*;
//!
//! assert!(Sphere::checked(Vec3::ZERO, LARGEST).is_ok());
//! assert!(Sphere::checked(Vec3::ZERO, 2.0 * LARGEST).is_err());
//! ```

/// The largest |coordinate| and the largest radius, in metres: a million kilometres.
pub const LARGEST: f32 = 1e9;

/// The least extent of a mesh along its longest axis, in metres: a nanometre.
pub const SMALLEST: f32 = 1e-9;

/// The least area whose product with a length in the domain still has all digits: 2⁻⁸⁴ m².
pub(crate) const AREA_MIN: f32 = 1.0 / (1_u128 << 84) as f32;

/// The largest area whose product with a length in the domain does not overflow: 2⁸⁰ m².
pub(crate) const AREA_MAX: f32 = (1_u128 << 80) as f32;
