//! No self-shadow, at any scale.

use crate::ch15_shadows::rays::{random_direction, random_scale, ray};
use crate::ch15_shadows::{from_lamp, from_sun, lit, scene};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::light::LightSample;
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{
    Shape, Surface, cuboid::Cuboid, plane::Plane, sphere::Sphere, triangle::Triangle,
};
use raybook_common::{STALE, grouped, measured};

/// A convex shape of about this size, somewhere; it never shadows the side that faces a light.
fn shape(rng: &mut Pcg, size: f32) -> Box<dyn Shape> {
    let mut point = |reach: f32| reach * size * *random_direction(rng);
    let (center, a, b) = (point(3.0), point(1.0), point(1.0));
    match rng.random_range(0..4) {
        0 => Box::new(Sphere::new(center, size)),
        1 => Box::new(Plane::through(center, random_direction(rng))),
        2 => Box::new(Cuboid::between(center, center + a)),
        _ => Box::new(Triangle::new(center, center + a, center + b)),
    }
}

/// Where a ray meets one, and light from its side: above the tangent plane by a sine of 0.01 or more.
fn surface_and_light(
    rng: &mut Pcg,
    shape: &dyn Shape,
    size: f32,
) -> Option<(Surface, LightSample)> {
    let bounds = shape.bounds();
    let aim = if bounds.min.is_finite() {
        bounds.center()
    } else {
        Vec3::ZERO
    };
    let origin = aim + 6.0 * size * *random_direction(rng);
    let target = aim + 0.5 * size * *random_direction(rng);
    let ray = Ray::new(origin, Dir3::new(target - origin)?);
    let hit = shape.hit(&ray, Interval::AHEAD)?;
    let at = shape.surface(&ray, &hit);
    let light = if rng.random_bool(0.2) {
        from_sun(*random_direction(rng))
    } else {
        let away = size * 10.0_f32.powf(rng.random_range(-2.0..2.0));
        from_lamp(at.position + away * *random_direction(rng), &at)
    };
    let seen_side = -at.normal.dot(*ray.direction).signum();
    (at.normal.dot(*light.toward) * seen_side > 0.01).then_some((at, light))
}

#[test]
fn nothing_convex_shadows_the_side_that_faces_the_light() {
    let mut rng = pcg::stream(15, 2);
    let (mut right, mut naive) = (0_u64, 0_u64);
    for _ in 0..60_000 {
        let size = random_scale(&mut rng);
        let one = shape(&mut rng, size);
        let Some((at, light)) = surface_and_light(&mut rng, &*one, size) else {
            continue;
        };
        let scene = scene(vec![one]);
        assert!(lit(&scene, &at, &light), "{size} m: {at:?} {light:?}");
        right += 1;
        let from_point = Ray::new(at.position, light.toward);
        naive += u64::from(scene.blocks(&from_point, Interval::new(0.0, light.distance)));
    }
    let told = format!(
        "The tests shoot {} shadow rays off spheres, planes, boxes and triangles, from a micrometre to a thousand kilometres. None of them \
        hits the surface from which it starts. When the same rays start from the computed points themselves, {} of them do.\n",
        grouped(right),
        grouped(naive)
    );
    assert_eq!(measured("shadow_rays", &told), told, "{STALE}");
    assert!(right > 10_000, "{right} were tried");
    assert!(
        naive > 1000,
        "the test can fail: {naive} rays from the point itself find its surface"
    );
}

#[test]
fn scenes_of_all_sizes_have_the_same_shadows() {
    let mut rng = pcg::stream(15, 3);
    let mut hidden = 0;
    for _ in 0..5000 {
        let [x, z] = [(); 2].map(|()| rng.random_range(-3.0..3.0_f32));
        // The rim of the shadow is a matter of rounding.
        let rim = (x.hypot(z) - 4.0 / 3.0_f32.sqrt()).abs();
        if rim < 1e-3 {
            continue;
        }
        let answers = [1e-6, 1e-3, 1.0, 1e3, 1e6].map(|size: f32| {
            let ground = Plane::through(Vec3::ZERO, Dir3::Y);
            let down = ray(size * vec3(x, 9.0, z), Vec3::NEG_Y);
            let (_, at) = crate::ch15_shadows::rays::sure_hit(&ground, &down);
            let ball = Sphere::new(2.0 * size * Vec3::Y, size);
            let scene = scene(vec![Box::new(ground), Box::new(ball)]);
            lit(&scene, &at, &from_lamp(4.0 * size * Vec3::Y, &at))
        });
        assert!(
            answers.iter().all(|&a| a == answers[0]),
            "({x}, {z}): {answers:?}"
        );
        hidden += u32::from(!answers[0]);
    }
    assert!(
        (1000..4000).contains(&hidden),
        "{hidden} of 5000 are in shadow"
    );
}
