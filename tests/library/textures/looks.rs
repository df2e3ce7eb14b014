//! Flat and smooth meshes, normal maps, and a textured surface's light.

use glam::{Vec2, Vec3, vec2, vec3};
use raybook::prelude::*;
use raybook::shape::normal_map::NormalMap;
use raybook::shape::teapot;
use std::sync::Arc;

/// The square from 0 to 1 in the plane z = 0, whose texture coordinates are turned or mirrored.
fn square(texture: impl Fn(Vec2) -> Vec2) -> Mesh {
    let corners = [
        vec2(0.0, 0.0),
        vec2(1.0, 0.0),
        vec2(1.0, 1.0),
        vec2(0.0, 1.0),
    ];
    let positions = corners.map(|p| p.extend(0.0)).to_vec();
    let textures = corners.map(texture).to_vec();
    Mesh::new(positions, vec![[0, 1, 2], [0, 2, 3]], None, Some(textures)).expect("a mesh")
}

fn seen(mesh: &Mesh) -> Surface {
    let shape = Meshed::new(mesh.clone(), WideBvh::new);
    let ray = Ray::new(vec3(0.3, 0.6, 2.0), -Dir3::Z);
    let hit = shape.hit(&ray, Interval::AHEAD).expect("it is hit");
    shape.surface(&ray, &hit)
}

/// A map that leans everywhere by the same vector.
fn leaning(lean: Vec3) -> Arc<NormalMap> {
    let code = 0.5 * lean.normalize() + 0.5;
    let picture = Image::from_fn(4, 4, |_, _| Rgb::new(code.x, code.y, code.z));
    Arc::new(NormalMap::new(&picture))
}

/// Where the texture coordinates go.
type Turn = fn(Vec2) -> Vec2;

#[test]
fn a_normal_map_leans_along_u_and_v_wherever_these_go() {
    let lean = vec3(0.3, 0.1, 1.0);
    let cases: [(Turn, Vec3); 4] = [
        (|p| p, vec3(0.3, 0.1, 1.0)),
        (|p| 3.0 * p, vec3(0.3, 0.1, 1.0)),
        (|p| vec2(p.y, -p.x), vec3(-0.1, 0.3, 1.0)), // u goes up, v to the left
        (|p| vec2(-p.x, p.y), vec3(-0.3, 0.1, 1.0)), // mirrored
    ];
    for (turn, expected) in cases {
        let at = seen(&square(turn).with_bumps(leaning(lean)));
        let expected = expected.normalize();
        assert!(
            at.shading_normal.abs_diff_eq(expected, 1e-5),
            "{:?}, not {expected}",
            at.shading_normal
        );
        assert_eq!(*at.normal, Vec3::Z, "the surface itself stays flat");
    }
}

#[test]
fn a_flat_normal_map_changes_nothing_and_neither_does_one_without_texture_coordinates() {
    let flat = leaning(Vec3::Z);
    assert!(
        seen(&square(|p| p).with_bumps(flat))
            .shading_normal
            .abs_diff_eq(Vec3::Z, 1e-6)
    );
    for nowhere in [leaning(vec3(1.0, 0.0, 1.0)), leaning(vec3(1.0, 0.0, -1.0))] {
        let at = seen(&square(|_| Vec2::ZERO).with_bumps(nowhere));
        assert_eq!(*at.shading_normal, Vec3::Z);
    }
}

#[test]
fn a_flat_teapot_has_its_triangles_normals_and_a_smooth_one_is_round_again() {
    let pot = teapot::mesh(6);
    let (flat, again) = (pot.flat(), pot.flat().smooth());
    assert_eq!(flat.triangles().len(), pot.triangles().len());
    assert_eq!(flat.positions().len(), 3 * pot.triangles().len());
    let (mut bent, mut sharp) = (0, 0);
    for (i, corners) in flat.triangles().iter().enumerate() {
        let [p0, p1, p2] = corners.map(|i| flat.positions()[i as usize]);
        let Some(face) = Dir3::new((p1 - p0).cross(p2 - p0)) else {
            continue;
        };
        for (&of_flat, &of_pot) in corners.iter().zip(&pot.triangles()[i]) {
            let (of_flat, of_pot) = (of_flat as usize, of_pot as usize);
            assert!(
                flat.normals()[of_flat].abs_diff_eq(*face, 1e-5),
                "facet {i}"
            );
            assert_eq!(flat.textures()[of_flat], pot.textures()[of_pot]);
            bent += u32::from(again.normals()[of_flat].dot(*face) < 0.999);
            sharp += u32::from(again.normals()[of_flat].dot(*pot.normals()[of_pot]) < 0.9);
        }
    }
    let corners = flat.positions().len() as u32;
    assert!(
        bent > corners / 2,
        "smooth: {bent} of {corners} corners lean away from their facet"
    );
    assert!(
        sharp < corners / 20,
        "{sharp} of {corners} corners are not as the teapot was made"
    );
}

#[test]
fn a_textured_surface_sends_on_what_its_picture_says() {
    // Under a white sky, a matte plane is as bright as its albedo, texel by texel.
    let picture = Image::from_fn(2, 2, |x, y| Rgb::gray(0.2 + 0.2 * (2 * y + x) as f32));
    let paper = ImageTexture::new(MipMap::new(&picture), |albedo| Lambert { albedo });
    let square = Meshed::new(square(|p| p), WideBvh::new);
    let scene = Scene::new(vec![Thing::new(square, paper)], vec![])
        .surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
    let mut numbers = raybook::math::pcg::stream(3, 0);
    for (x, y) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let place = vec3(0.25 + 0.5 * x as f32, 0.75 - 0.5 * y as f32, 1.0);
        let got = Path::WHOLE.radiance(&scene, &Ray::new(place, -Dir3::Z), &mut numbers);
        assert!(
            (got.g - picture.at(x, y).g).abs() < 1e-5,
            "texel ({x}, {y}): {got:?}"
        );
    }
}
