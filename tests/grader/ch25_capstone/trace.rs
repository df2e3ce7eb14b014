//! The radiance of rays, by other parts of the library and by hand.

use glam::{Vec3, vec2, vec3};
use rand::RngExt;
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::light::Light;
use raybook::light::point::PointLight;
use raybook::material::glass::{Glass, Medium};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::shadow::lit;
use raybook::render::trace::trace;
use raybook::render::{local::Local, whitted::Whitted};
use raybook::scene::description::{Backdrop, Description, Matter, Object};
use raybook::scene::four_scenes::{ASPECT, FOUR, Staged};
use raybook::scene::world::{Scene, Thing};

fn view(staged: &Staged, x: f32, y: f32) -> Ray {
    let [from, to] = staged.view;
    let camera = Pinhole::look_at(from, to, Vec3::Y, staged.focal_length, ASPECT);
    camera.expect("a stage has a view").central_ray(vec2(x, y))
}

/// The same scene for Whitted's ray tracer of chapter 13, before black.
fn for_whitted(scene: &Description) -> Scene {
    let things = scene.objects.iter().map(|object| {
        let form = object.form.clone();
        match &object.matter {
            Matter::Phong(phong) => Thing::new(form, *phong),
            Matter::Mirror(mirror) => Thing::new(form, *mirror),
            Matter::Glass(clear) => Thing::new(form, Glass::of(Medium::clear(clear.index))),
        }
    });
    let lamps = scene
        .lamps
        .iter()
        .map(|&lamp| -> Box<dyn Light> { Box::new(lamp) });
    Scene::new(things.collect(), lamps.collect()).surrounded_by(scene.ambient, |_| Rgb::BLACK)
}

#[test]
fn trace_agrees_with_whitted_in_the_four_scenes() {
    let mut bright = 0;
    for staged in &FOUR {
        let mut scene = (staged.scene)();
        scene.backdrop = Backdrop {
            below: Rgb::BLACK,
            above: Rgb::BLACK,
        };
        let other = for_whitted(&scene);
        let whitted = Whitted {
            local: Local {
                samples: 1,
                arrives: Some(lit),
            },
            depth: staged.depth,
        };
        let rng = &mut pcg::stream(25, 0);
        for _ in 0..2000 {
            let ray = view(staged, rng.random(), rng.random());
            let (one, two) = (
                trace(&scene, &ray, staged.depth),
                whitted.radiance(&other, &ray, rng),
            );
            for (a, b) in one.channels().into_iter().zip(two.channels()) {
                // Whitted leaves out what counts for less than 1/512.
                assert!(
                    (a - b).abs() <= 0.005 + 0.002 * b,
                    "{}: {one:?} and {two:?} along {ray:?}",
                    staged.name
                );
            }
            bright += u32::from(one.luminance() > 0.05);
        }
    }
    assert!(bright > 6000, "most rays see something: {bright} of 8000");
}

const SKY: Backdrop = Backdrop {
    below: Rgb::gray(0.2),
    above: Rgb::gray(0.6),
};

fn scene(objects: Vec<Object>) -> Description {
    Description {
        ambient: Rgb::gray(0.5),
        backdrop: SKY,
        lamps: vec![PointLight {
            position: vec3(0.0, 2.0, 0.0),
            intensity: Rgb::gray(8.0),
        }],
        objects,
    }
}

fn down() -> Ray {
    Ray::new(vec3(0.0, 1.0, 0.0), -Dir3::Y)
}

#[track_caller]
fn expect(got: Rgb, expected: f32, what: &str) {
    assert!(
        (got.r - expected).abs() < 1e-5,
        "{what}: {got:?}, not {expected}"
    );
}

#[test]
fn phong_below_a_lamp_is_what_the_formula_says() {
    let floor = Object::plane(Dir3::Y, 0.0, Matter::phong(Rgb::gray(0.3), 0.1, 5.0));
    // I/r² = 8/2² = 2, and all cosines are 1: 0.3·0.5 + (0.3 + 0.1)·2.
    expect(
        trace(&scene(vec![floor.clone()]), &down(), 1),
        0.95,
        "lit from straight above",
    );
    expect(
        trace(&scene(vec![floor.clone()]), &down(), 0),
        0.0,
        "at depth 0 all is black",
    );
    let lid = Object::sphere(vec3(0.0, 1.5, 0.0), 0.2, Matter::glass(1.5));
    expect(
        trace(&scene(vec![floor.clone(), lid]), &down(), 1),
        0.15,
        "in the shadow of glass",
    );
    let beyond = Object::sphere(vec3(0.0, 3.0, 0.0), 0.5, Matter::glass(1.5));
    expect(
        trace(&scene(vec![beyond, floor]), &down(), 1),
        0.95,
        "what is beyond the lamp throws no shadow",
    );
}

#[test]
fn the_depth_counts_surfaces_and_the_backdrop_needs_one_more() {
    let mirror = Object::plane(Dir3::Y, 0.0, Matter::mirror(Rgb::gray(0.5)));
    let scene = scene(vec![mirror]);
    expect(
        trace(&scene, &down(), 2),
        0.5 * 0.6,
        "half of the sky above",
    );
    expect(
        trace(&scene, &down(), 1),
        0.0,
        "a mirror has nothing to show at depth 1",
    );
    let up = Ray::new(vec3(0.0, 1.0, 0.0), Dir3::Y);
    expect(trace(&scene, &up, 1), 0.6, "the sky itself");
}

#[test]
fn glass_head_on_mirrors_four_percent() {
    let water = Object::plane(Dir3::Y, 0.0, Matter::glass(1.5));
    // R = ((1.5 − 1)/(1.5 + 1))² = 0.04 of what is above, the rest of what is below.
    let expected = 0.04 * 0.6 + 0.96 * 0.2;
    expect(
        trace(&scene(vec![water.clone()]), &down(), 2),
        expected,
        "into glass",
    );
    let from_below = Ray::new(vec3(0.0, -1.0, 0.0), Dir3::Y);
    let expected = 0.04 * 0.2 + 0.96 * 0.6;
    expect(
        trace(&scene(vec![water.clone()]), &from_below, 2),
        expected,
        "out of glass",
    );
    let flat = Ray::new(
        vec3(0.0, -1.0, 0.0),
        Dir3::new_or(vec3(0.8, 0.6, 0.0), Dir3::Y),
    );
    // sin θ₁ = 0.8 > 1/1.5: mirrored downwards, d_y = −0.6.
    expect(
        trace(&scene(vec![water]), &flat, 2),
        0.2 + 0.4 * 0.2,
        "totally reflected",
    );
}
