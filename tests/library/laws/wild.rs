//! Nothing panics, whatever the bits.

use crate::laws::forms::config;
use glam::{Mat3, Vec3, vec3};
use proptest::prelude::*;
use raybook::accel::{Meshed, list::List};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, quadratic, ray::Ray, slab};
use raybook::shape::mesh::Mesh;
use raybook::shape::{
    Shape, cuboid::Cuboid, instance::Instance, plane::Plane, sphere::Sphere, triangle::Triangle,
    triangle_by_determinants, triangle_by_plane,
};
use std::sync::Arc;

/// Any `f32`: any bits, or a number that is likely to make trouble, or a harmless one.
fn number() -> impl Strategy<Value = f32> {
    let trouble = [
        0.0,
        1.0,
        f32::INFINITY,
        f32::NAN,
        f32::MAX,
        f32::MIN_POSITIVE,
        f32::EPSILON,
    ];
    prop_oneof![
        any::<u32>().prop_map(f32::from_bits),
        (prop::sample::select(trouble.to_vec()), any::<bool>()).prop_map(|(x, minus)| if minus {
            -x
        } else {
            x
        }),
        -2.0_f32..2.0,
    ]
}

pub(crate) fn vector() -> impl Strategy<Value = Vec3> {
    (number(), number(), number()).prop_map(|(x, y, z)| vec3(x, y, z))
}

pub(crate) fn direction() -> impl Strategy<Value = Dir3> {
    vector().prop_filter_map("no direction", Dir3::new)
}

/// A shape out of whatever numbers; `None` where its constructor refuses them.
type Build = fn([Vec3; 3], Dir3, f32) -> Option<Box<dyn Shape>>;

/// One of each.
const SHAPES: &[Build] = &[
    |[center, ..], _, radius| Some(Box::new(Sphere { center, radius })),
    |[a, ..], normal, _| Some(Box::new(Plane::through(a, normal))),
    |_, normal, offset| Some(Box::new(Plane { normal, offset })),
    |[min, max, _], _, _| {
        let bounds = Aabb { min, max };
        Some(Box::new(Cuboid { bounds }))
    },
    |[a, b, c], _, _| Some(Box::new(Triangle::new(a, b, c))),
    |[a, b, c], _, _| {
        let mesh = Mesh::new(vec![a, b, c], vec![[0, 1, 2], [2, 1, 1]], None, None);
        Some(Box::new(Meshed::new(mesh.ok()?, List::new)))
    },
    |[center, translation, _], axis, scale| {
        let shape = Arc::new(Sphere {
            center,
            radius: 1.0,
        });
        let instance = Instance {
            shape,
            scale,
            rotation: Mat3::from_axis_angle(*axis, 1.0),
            translation,
        };
        (scale > 0.0).then(|| Box::new(instance) as _)
    },
];

pub(crate) fn interval() -> impl Strategy<Value = Interval> {
    prop_oneof![
        Just(Interval::AHEAD),
        (number(), number()).prop_map(|(a, b)| Interval::new(a, b))
    ]
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn a_direction_has_unit_length_or_is_none(v in vector()) {
        match Dir3::new(v) {
            Some(d) => prop_assert!((d.length() - 1.0).abs() < 3e-7, "{v} has direction {d:?}, of length {}", d.length()),
            None => prop_assert!(v == Vec3::ZERO || !v.is_finite(), "{v} has a direction"),
        }
    }

    #[test]
    fn no_ray_and_no_shape_panics(build in prop::sample::select(SHAPES), points in [vector(), vector(), vector()], normal in direction(), x in number(), origin in vector(), direction in direction(), within in interval(), out in direction()) {
        let Some(shape) = build(points, normal, x) else { return Ok(()) };
        let ray = Ray::new(origin, direction);
        let bounds = shape.bounds();
        let _ = (bounds.center(), bounds.size(), bounds.union(&bounds));
        let hit = shape.hit(&ray, within);
        prop_assert_eq!(shape.blocks(&ray, within), hit.is_some(), "`blocks` and `hit` disagree");
        if let Some(hit) = hit {
            prop_assert!(within.contains(hit.t), "t = {} is not in {within:?}", hit.t);
            let at = shape.surface(&ray, &hit);
            for n in [at.normal, at.shading_normal] {
                prop_assert!((n.length() - 1.0).abs() < 3e-7, "the normal {n:?} has length {}", n.length());
            }
            let away = at.leave(out);
            let _ = shape.hit(&away, Interval::AHEAD);
        }
    }

    #[test]
    fn no_way_to_hit_a_triangle_panics(corners in [vector(), vector(), vector()], origin in vector(), direction in direction(), within in interval()) {
        let [p0, p1, p2] = corners;
        let (triangle, ray) = (Triangle::new(p0, p1, p2), Ray::new(origin, direction));
        for hit in [triangle_by_plane::hit, triangle_by_determinants::hit, |t: &Triangle, r: &Ray, w| t.hit(r, w)] {
            if let Some(hit) = hit(&triangle, &ray, within) {
                let (b1, b2) = (hit.uv.x, hit.uv.y);
                prop_assert!(within.contains(hit.t) && b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0, "{hit:?} is outside");
            }
        }
    }

    #[test]
    fn no_box_and_no_quadratic_equation_panics(a in vector(), b in vector(), origin in vector(), direction in direction(), within in interval()) {
        let clipped = slab::clip(&Aabb { min: a, max: b }, &Ray::new(origin, direction), within);
        if let Some(Interval { min, max }) = clipped {
            prop_assert!(min <= max, "{min} to {max} is not an interval");
        }
        if let Some((t0, t1)) = quadratic::solve(a.x, a.y, a.z) {
            prop_assert!(t0 <= t1 || t0.is_nan() || t1.is_nan(), "{t0} and {t1} are not in order");
        }
    }
}
