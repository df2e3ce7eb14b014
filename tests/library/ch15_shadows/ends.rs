//! Where light ends on a mesh that pretends to be round.

use raybook::light::LightSample;
use raybook::prelude::*;
use raybook::render::shadow::lit;
use raybook::shape::{attributes::lift, teapot};

fn direction(x: f32, y: f32) -> Dir3 {
    Dir3::new(vec3(x, y, 0.0)).expect("not 0")
}

#[test]
fn on_a_sphere_of_triangles_a_point_is_lifted_to_the_sphere() {
    // Three points of the unit sphere, with its normals.
    let normals = [
        vec3(0.0, 0.3, 1.0),
        vec3(0.25, -0.2, 1.0),
        vec3(-0.25, -0.2, 1.0),
    ];
    let normals = normals.map(|n| Dir3::new(n).expect("not 0"));
    let corners = normals.map(|n| *n);
    for (b, most) in [
        (vec2(0.33, 0.33), 0.05),
        (vec2(0.5, 0.5), 0.05),
        (vec2(0.1, 0.2), 0.05),
    ] {
        let p = (1.0 - b.x - b.y) * corners[0] + b.x * corners[1] + b.y * corners[2];
        let lifted = p + lift(p, corners, normals, b);
        let (below, above) = (1.0 - p.length(), lifted.length() - 1.0);
        assert!(below > 0.005, "p is {below} below the sphere");
        // It is on the planes that touch the sphere in the corners, or a little below: outside the sphere, and near it.
        assert!(
            (-1e-6..most).contains(&above),
            "and is lifted to {above} above it"
        );
    }
    for b in [Vec2::ZERO, Vec2::X, Vec2::Y] {
        let p = corners[(b.x + 2.0 * b.y) as usize];
        assert_eq!(lift(p, corners, normals, b), Vec3::ZERO, "a corner stays");
    }
    let hollow = normals.map(|n| -n);
    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    let third = Vec2::splat(1.0 / 3.0);
    assert_eq!(
        lift(middle, corners, hollow, third),
        Vec3::ZERO,
        "a hollow stays"
    );
}

#[test]
fn a_ray_to_the_outside_starts_at_the_round_surface_and_all_others_at_the_facet() {
    let at = Surface {
        shading_normal: direction(0.3, 1.0),
        lift: vec3(0.0, 0.01, 0.0),
        ..Surface::flat(Vec3::ZERO, 1e-6, Dir3::Y)
    };
    let start = |toward: Dir3| at.leave_smooth(toward).origin.y;
    // The round surface sees what the facet does not.
    for toward in [direction(1.0, 0.5), direction(1.0, -0.1)] {
        assert!((start(toward) - 0.01).abs() < 1e-4, "{toward:?}");
    }
    for toward in [direction(1.0, -0.5), direction(-1.0, 0.1), -Dir3::Y] {
        assert_eq!(at.leave_smooth(toward), at.leave(toward));
    }
    let flat = Surface {
        lift: Vec3::ZERO,
        ..at
    };
    assert_eq!(flat.leave_smooth(Dir3::X), flat.leave(Dir3::X));
}

#[test]
fn on_a_coarse_teapot_light_ends_where_the_round_surface_turns_away() {
    let pot = Meshed::new(teapot::mesh(3), WideBvh::new);
    let scene = Scene::new(
        vec![Thing::new(pot, Lambert { albedo: Rgb::WHITE })],
        vec![],
    );
    let light = LightSample::unit(Dir3::new_or(vec3(-0.978, 0.0, 0.208), Dir3::X));
    // Facets are 30° wide, and their middles at 15° and so on; light ends at 12° + 90°, on the facet at 105°.
    // Around the belly, from the side of the sun to the other one: what the light gives, by the facet and by the round surface.
    let (mut seen_by_all, mut by_facet, mut by_round) = (0, 0, 0);
    for i in 0..4000 {
        let turn = i as f32 / 4000.0 * std::f32::consts::PI;
        let out = Dir3::new_or(vec3(-turn.cos(), 0.0, turn.sin()), Dir3::Z);
        let ray = Ray::new(vec3(0.0, 0.9, 0.0) + 6.0 * *out, -out);
        let seen = scene.closest(&ray).expect("the belly");
        let cosine = seen.surface.shading_normal.dot(*light.toward);
        // The handle is in the way of the light where it meets the belly, at the beginning.
        if cosine <= 0.02 || turn < 0.6 {
            continue;
        }
        let flat = Surface {
            lift: Vec3::ZERO,
            ..seen.surface
        };
        seen_by_all += 1;
        by_facet += u32::from(lit(&scene, &flat, &light));
        by_round += u32::from(lit(&scene, &seen.surface, &light));
    }
    assert!(seen_by_all > 1000, "{seen_by_all} points face the light");
    assert!(
        by_facet < seen_by_all - 50,
        "{by_facet} of {seen_by_all}: facets are in their own shadow"
    );
    assert!(
        by_round > seen_by_all - 5,
        "{by_round} of {seen_by_all}: the round surface is not"
    );
}
