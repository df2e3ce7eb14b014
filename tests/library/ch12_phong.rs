//! Chapter 12: lights without extent, Phong, Blinn, and what they add up to.

mod highlights;
mod lights;
mod local;
use raybook_common::rays;

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::LightSample;
use raybook::material::{Material, blinn_phong::BlinnPhong, phong::Phong};
use raybook::math::{dir3::Dir3, pcg};
use raybook::shape::Surface;
use rays::random_direction;

const PHONG: Phong = Phong {
    ambient: Rgb::gray(0.5),
    diffuse: Rgb::new(0.1, 0.2, 0.3),
    specular: Rgb::new(0.5, 0.25, 0.125),
    exponent: 2.0,
};

/// Both models, by name.
const MODELS: [(&str, &dyn Material); 2] = [("Phong", &PHONG), ("Blinn", &BlinnPhong(PHONG))];

fn toward(v: Vec3) -> Dir3 {
    Dir3::new(v).expect("a test's direction is one")
}

/// Light of 1 W/m² from a direction.
fn from(direction: Vec3) -> LightSample {
    LightSample {
        toward: toward(direction),
        distance: 1.0,
        arriving: Rgb::WHITE,
        pdf: f32::INFINITY,
    }
}

/// The ground, seen as its normal says.
fn ground(normal: Dir3) -> Surface {
    Surface::flat(Vec3::ZERO, 0.0, normal)
}

#[track_caller]
fn close(got: Rgb, expected: Rgb, why: &str) {
    for (got, expected) in got.channels().into_iter().zip(expected.channels()) {
        // A handful of roundings of numbers near 1.
        assert!(
            (got - expected).abs() < 1e-6,
            "{why}: {got}, not {expected}"
        );
    }
}

#[test]
fn known_directions_have_known_radiances() {
    // A 3-4-5 triangle: L·N = 0.8, R = (−0.6, 0.8, 0), and V is at 90° to R or half way between the normal and R.
    let slanting = vec3(0.6, 0.8, 0.0);
    let Phong {
        diffuse, specular, ..
    } = PHONG;
    let cases = [
        ("straight above", Vec3::Y, Vec3::Y, 1.0, 1.0, 1.0),
        (
            "in the mirror direction",
            slanting,
            vec3(-0.6, 0.8, 0.0),
            0.8,
            1.0,
            1.0,
        ),
        ("from the normal", slanting, Vec3::Y, 0.8, 0.64, 0.9),
        (
            "along the light",
            slanting,
            slanting,
            0.8,
            0.28 * 0.28,
            0.64,
        ),
        (
            "square to the mirror direction",
            slanting,
            vec3(0.8, 0.6, 0.0),
            0.8,
            0.0,
            0.5,
        ),
    ];
    for (why, light, view, cosine, phong, blinn) in cases {
        let got = MODELS.map(|(_, model)| model.lit(&ground(Dir3::Y), toward(view), &from(light)));
        close(got[0], diffuse * cosine + specular * phong, why);
        close(got[1], diffuse * cosine + specular * blinn, why);
    }
}

#[test]
fn light_that_is_not_above_the_surface_gives_nothing() {
    let below = [
        ("straight below", Vec3::NEG_Y),
        ("just below, in the viewer's face", vec3(-1.0, -0.01, 0.0)),
        ("at the horizon", Vec3::NEG_X),
        ("at the horizon, −0", vec3(-1.0, -0.0, 0.0)),
    ];
    for (name, model) in MODELS {
        for (why, light) in below {
            for view in [Vec3::Y, vec3(1.0, 0.02, 0.0)] {
                let got = model.lit(&ground(Dir3::Y), toward(view), &from(light));
                assert_eq!(got, Rgb::BLACK, "{name}: the light is {why}");
            }
        }
        let above = from(vec3(-1.0, 0.01, 0.0));
        let got = model.lit(&ground(Dir3::Y), toward(vec3(1.0, 0.01, 0.0)), &above);
        assert!(
            got.r > 0.4,
            "{name}: just above the horizon there is a highlight, not {got:?}"
        );
    }
}

#[test]
fn a_surface_seen_from_behind_is_lit_on_the_side_that_is_seen() {
    let mut rng = pcg::stream(12, 0);
    let mut lit = 0;
    for (name, model) in MODELS {
        for _ in 0..1000 {
            let [normal, view, light] = [(); 3].map(|()| random_direction(&mut rng));
            let [front, back] =
                [normal, -normal].map(|n| model.lit(&ground(n), view, &from(*light)));
            assert_eq!(front, back, "{name}: it has two equal sides");
            let same_side = normal.dot(*view) * normal.dot(*light) > 0.0;
            assert_eq!(
                front != Rgb::BLACK,
                same_side,
                "{name}: lit and seen from one side"
            );
            lit += u32::from(same_side);
        }
    }
    assert!((600..1400).contains(&lit), "{lit} of 2000 were lit");
}
