//! Hits are on the surface, in the bounds, and in the interval.

use crate::laws::forms::{Form, aimed, config, direction, form};
use proptest::prelude::*;
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use raybook::shape::{Hit, ROUNDING, Shape};

const LINE: Interval = Interval::new(f32::NEG_INFINITY, f32::INFINITY);

/// All hits of a whole line, in order: whatever was found, the search goes on behind it.
fn all_hits(shape: &dyn Shape, ray: &Ray) -> Vec<Hit> {
    let mut hits: Vec<Hit> = Vec::new();
    let mut within = LINE;
    while let Some(hit) = shape.hit(ray, within) {
        assert!(
            hits.len() < 8,
            "none of these shapes has so many surfaces: {hits:?}, {hit:?}"
        );
        within.min = hit.t;
        hits.push(hit);
    }
    hits
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn a_hit_is_on_the_surface_and_in_the_bounds((form, ray) in aimed(3.0)) {
        let shape = form.build();
        for hit in all_hits(&*shape, &ray) {
            let at = shape.surface(&ray, &hit);
            // √3: `error` is meant along each axis. 1e-12 absorbs the rounding of f64 itself.
            let error = f64::from(at.error) * 3.0_f64.sqrt() + 1e-12;
            prop_assert!(form.distance(at.position) <= error, "the position is {} off the surface, its error is said to be {}", form.distance(at.position), at.error);
            // o + t·d is rounded at the size of its terms. Twice, for the rounding of t.
            let along = error + 2.0 * f64::from(ROUNDING * (ray.origin.abs().max_element() + hit.t.abs()));
            prop_assert!(form.distance(ray.at(hit.t)) <= along, "o + t·d is {} off the surface, {along} is allowed", form.distance(ray.at(hit.t)));
            let bounds = shape.bounds();
            let grown = Aabb { min: bounds.min - at.error, max: bounds.max + at.error };
            prop_assert!(grown.contains(at.position), "{} is outside the bounds {bounds:?}", at.position);
        }
    }

    #[test]
    fn normals_have_unit_length((form, ray) in aimed(1.0)) {
        let shape = form.build();
        let hits = all_hits(&*shape, &ray);
        prop_assert!(!hits.is_empty(), "a ray at the inside hits");
        for hit in hits {
            let at = shape.surface(&ray, &hit);
            // Three roundings of 6e-8 in the square root of the sum of squares, and one more in the quotient.
            prop_assert!((at.normal.length() - 1.0).abs() < 3e-7, "the normal's length is {}", at.normal.length());
            prop_assert!((at.shading_normal.length() - 1.0).abs() < 3e-7, "the shading normal's length is {}", at.shading_normal.length());
        }
    }

    #[test]
    fn an_interval_picks_the_first_of_the_lines_hits_inside_it((form, ray) in aimed(3.0), a in -30.0_f32..30.0, b in -30.0_f32..30.0, ends in 0..6) {
        let shape = form.build();
        let hits = all_hits(&*shape, &ray);
        // The interval's ends: anywhere, or exactly at hits, where it is open.
        let at = |i: usize, otherwise: f32| hits.get(i).map_or(otherwise, |hit| hit.t);
        let within = match ends {
            0 => Interval::new(a, b),
            1 => Interval::new(at(0, a), b),
            2 => Interval::new(a, at(0, b)),
            3 => Interval::new(at(0, a), at(1, b)),
            4 => Interval::new(at(0, a).next_down(), at(1, b).next_up()),
            _ => Interval::AHEAD,
        };
        let expected = hits.iter().find(|hit| within.contains(hit.t)).copied();
        prop_assert_eq!(shape.hit(&ray, within), expected, "among {:?} in {:?}", hits, within);
        prop_assert_eq!(shape.blocks(&ray, within), expected.is_some(), "`blocks` and `hit` disagree in {:?}", within);
    }

    #[test]
    fn a_ray_that_starts_beyond_the_bounds_and_leaves_misses(form in form(), away in direction()) {
        let shape = form.build();
        let bounds = shape.bounds();
        let origin = bounds.center() + bounds.size().length() * *away;
        let hit = shape.hit(&Ray::new(origin, away), Interval::AHEAD);
        prop_assert!(hit.is_none() || matches!(form, Form::Plane(..)), "{hit:?} is behind the ray");
    }
}
