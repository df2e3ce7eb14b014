//! Chapter 03: the sphere, and rays that leave it.

mod quadratic;
use raybook_common::rays;

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::shape::{Shape, sphere::Sphere};
use raybook_common::{hit_table, snapshot};
use rays::{random_direction, random_scale, ray, sure_hit};

#[test]
fn named_rays_hit_the_sphere_where_a_drawing_says() {
    let sphere = Sphere::new(vec3(0.0, 1.0, -4.0), 2.0);
    let along_z = |y: f32, z: f32, toward: f32| ray(vec3(0.0, y, z), vec3(0.0, 0.0, toward));
    let rays = [
        ("from the front", along_z(1.0, 0.0, -1.0)),
        ("from behind", along_z(1.0, -10.0, 1.0)),
        ("off the middle", along_z(2.0, 0.0, -1.0)),
        ("from above", ray(vec3(1.0, 9.0, -4.0), Vec3::NEG_Y)),
        ("slanting", ray(vec3(-3.0, 1.0, 0.0), vec3(3.0, 0.0, -4.0))),
        ("from the centre", ray(sphere.center, Vec3::X)),
        ("from inside", ray(vec3(1.0, 1.0, -4.0), Vec3::X)),
        ("from the surface inwards", along_z(1.0, -2.0, -1.0)),
        ("from the surface outwards", along_z(1.0, -2.0, 1.0)),
        ("touching the top", along_z(3.0, 0.0, -1.0)),
        ("just above the top", along_z(3.001, 0.0, -1.0)),
        ("beside it", ray(vec3(5.0, 1.0, 0.0), Vec3::NEG_Z)),
        ("away from it", along_z(1.0, 0.0, 1.0)),
        ("from 1000 km", along_z(2.0, 1e6, -1.0)),
        ("from nowhere", along_z(f32::NAN, 0.0, -1.0)),
    ];
    snapshot("ch03_sphere_hits", &hit_table(&sphere, &rays));
}

/// Both distances in f64, by the schoolbook: its 53 bits suffice here.
fn roots_in_f64(sphere: &Sphere, ray: &Ray) -> Option<[f64; 2]> {
    let o = ray.origin.as_dvec3() - sphere.center.as_dvec3();
    let d = ray.direction.as_dvec3();
    let (a, b) = (d.length_squared(), o.dot(d));
    let discriminant = b * b - a * (o.length_squared() - f64::from(sphere.radius).powi(2));
    (discriminant >= 0.0).then(|| [-1.0, 1.0].map(|sign| (sign * discriminant.sqrt() - b) / a))
}

#[test]
fn both_distances_agree_with_f64() {
    let mut rng = pcg::stream(3, 2);
    let (mut hits, mut misses) = (0, 0);
    for _ in 0..50_000 {
        let center = 4.0 * *random_direction(&mut rng);
        let sphere = Sphere::new(center, rng.random_range(1.0..4.0));
        let ray = Ray::new(
            5.0 * *random_direction(&mut rng),
            random_direction(&mut rng),
        );
        let near = sphere.hit(&ray, Interval::AHEAD);
        let Some([t0, t1]) = roots_in_f64(&sphere, &ray).filter(|roots| roots[1] > 0.0) else {
            assert_eq!(near, None, "{sphere:?} {ray:?}: f64 finds nothing ahead");
            misses += 1;
            continue;
        };
        // A chord of 0.2 m is not the silhouette's, where a root's error is √ of a rounding.
        if t1 - t0 > 0.2 && t0.abs() > 1e-3 {
            hits += 1;
            let near = near.expect("f64 hits").t;
            let far = sphere.hit(&ray, Interval::new(near, f32::INFINITY));
            let expected = if t0 > 0.0 { vec![t0, t1] } else { vec![t1] };
            let found: Vec<_> = far.map_or(vec![near], |far| vec![near, far.t]);
            assert_eq!(
                found.len(),
                expected.len(),
                "{sphere:?} {ray:?}: so many are ahead"
            );
            for (t, exact) in found.iter().zip(expected) {
                // Roundings of 12 m, divided by the chord's slope; measured: 6e-6.
                let off = (f64::from(*t) - exact).abs();
                assert!(off < 3e-5, "{sphere:?} {ray:?}: {t} is not {exact}");
            }
        }
    }
    assert!(
        hits > 5_000 && misses > 20_000,
        "{hits} hits, {misses} misses: too few"
    );
}

#[test]
fn a_small_sphere_is_hit_exactly_from_ten_thousand_kilometres() {
    let sphere = Sphere::new(Vec3::ZERO, 0.1);
    for axis in Vec3::AXES.into_iter().flat_map(|axis| [axis, -axis]) {
        for millimetres in 0..100_u8 {
            let aside = 0.001 * f32::from(millimetres) * axis.any_orthonormal_vector();
            let ray = ray(-1e7 * axis + aside, axis);
            let (hit, at) = sure_hit(&sphere, &ray);
            let r = f64::from(sphere.radius);
            let depth = (r * r - aside.as_dvec3().length_squared()).sqrt();
            let exact = aside.as_dvec3() - depth * axis.as_dvec3();
            // A few roundings of numbers up to r, and at the rim √ enlarges them; measured: 2e-8.
            let off = at.position.as_dvec3().distance(exact);
            assert!(off < 1e-7, "{} is not {exact}", at.position);
            let turned = at.normal.as_dvec3().distance(exact / r);
            assert!(turned < 1e-6, "{} is not the normal at {exact}", *at.normal);
            assert_eq!(hit.t, 1e7, "t itself has steps of one metre there");
        }
    }
    let (b, c) = (-2e7_f32, 1e14_f32 - 0.01);
    assert_eq!(
        b * b - 4.0 * c,
        0.0,
        "in the schoolbook's discriminant, r² is lost"
    );
}

#[test]
fn the_bounds_hold_the_surface_and_the_normal_points_outwards() {
    let mut rng = pcg::stream(3, 3);
    for _ in 0..20_000 {
        let center = rng.random_range(0.0..1e3) * *random_direction(&mut rng);
        let sphere = Sphere::new(center, rng.random_range(1e-3..10.0));
        let ray = Ray::new(center, random_direction(&mut rng));
        let (_, at) = sure_hit(&sphere, &ray);
        assert!(
            sphere.bounds().contains(at.position),
            "{sphere:?}: {at:?} is outside"
        );
        assert!(
            at.normal.distance(*ray.direction) < 1e-6,
            "{ray:?}: the normal is {at:?}"
        );
        let [u, v] = at.texture.to_array();
        assert!(
            (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v),
            "{at:?}: texture"
        );
        let turned = sphere.normal_at(at.position).distance(*at.normal);
        assert!(
            turned * sphere.radius <= 2.0 * at.error,
            "{sphere:?}: normal_at at {at:?}"
        );
    }
}

#[test]
fn a_ray_that_leaves_is_gone_and_one_that_enters_meets_the_far_side() {
    let mut rng = pcg::stream(3, 4);
    let (mut left, mut entered) = (0, 0);
    for _ in 0..100_000 {
        let r = random_scale(&mut rng);
        let center = r * rng.random_range(0.0..1e3) * *random_direction(&mut rng);
        let sphere = Sphere::new(center, r);
        let origin = center + 5.0 * r * *random_direction(&mut rng);
        let inside = center + 0.9 * r * *random_direction(&mut rng);
        let ray = ray(origin, inside - origin);
        let (_, at) = sure_hit(&sphere, &ray);
        let onward = at.leave(random_direction(&mut rng));
        let cosine = at.normal.dot(*onward.direction);
        let next = sphere.hit(&onward, Interval::AHEAD);
        if cosine >= 0.0 {
            left += 1;
            assert_eq!(next, None, "{sphere:?}: {onward:?} is outside");
        } else if -cosine * r > 20.0 * at.error {
            entered += 1;
            let t = next.expect("inside a sphere every ray hits").t;
            let chord = -2.0 * cosine * r;
            // It starts up to √3·error below the surface; slanting, that is 1/cosine as far.
            let (off, most) = ((t - chord).abs(), 4.0 * at.error / -cosine);
            assert!(off < most, "{sphere:?}: {t} is not {chord}");
        }
    }
    assert!(
        left > 40_000 && entered > 35_000,
        "{left} left, {entered} entered: too few"
    );
}

#[test]
fn no_ray_and_no_sphere_makes_it_panic() {
    let numbers = [0.0, -1.0, 1e-30, 1e38, f32::INFINITY, f32::NAN];
    for (x, r) in numbers.into_iter().flat_map(|x| numbers.map(|r| (x, r))) {
        let sphere = Sphere {
            center: vec3(x, 0.0, 0.0),
            radius: r,
        };
        for o in numbers {
            let ray = Ray::new(vec3(o, 0.0, 2.0), -Dir3::Z);
            if let Some(hit) = sphere.hit(&ray, Interval::AHEAD) {
                assert!(
                    hit.t > 0.0 && hit.t.is_finite(),
                    "{sphere:?} {ray:?}: {hit:?}"
                );
                let _ = sphere.surface(&ray, &hit);
            }
        }
    }
}
