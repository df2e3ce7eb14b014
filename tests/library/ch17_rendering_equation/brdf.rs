//! The laws of materials: light and viewer can change places, no more leaves than arrives, and samples fit their density.

use crate::ch17_rendering_equation::cells::Cells;
use crate::ch17_rendering_equation::materials::{
    Furnace, Reciprocal, Row, materials, modified_phong, normalised_blinn_phong, views,
};
use crate::ch17_rendering_equation::{direction, square, surface};
use raybook::image::rgb::Rgb;
use raybook::material::{Delta, Material, conductor::Metal, ggx::Ggx, mirror::reflect};
use raybook::math::{dir3::Dir3, pcg};
use raybook::render::reflection::reflected_radiance;
use raybook::sample::hemisphere::uniform_hemisphere;
use raybook::shape::Surface;
use raybook_common::statistics::Mean;

/// Cells around the direction in which a highlight is expected.
fn cells(at: &Surface, view: Dir3) -> Cells {
    Cells::around(reflect(-view, at.facing(view)))
}

/// The materials that have an f, seen from above.
fn scattering() -> impl Iterator<Item = (Row, Dir3)> {
    let rows = || {
        materials()
            .into_iter()
            .filter(|row| row.material.scatters(&row.at))
    };
    views()
        .into_iter()
        .flat_map(move |view| rows().map(move |row| (row, view)))
}

/// The cosine of a direction to the normal for shading; 0 for directions below.
fn cosine(at: &Surface, view: Dir3, toward: Dir3) -> f32 {
    at.facing(view).dot(*toward).max(0.0)
}

fn lobes(row: &Row, view: Dir3) -> Vec<Delta> {
    let mut lobes = Vec::new();
    row.material
        .delta_lobes(&row.at, view, &mut |lobe| lobes.push(lobe));
    lobes
}

#[test]
fn light_and_viewer_can_change_places() {
    let mut rng = pcg::stream(1, 1);
    for row in materials() {
        let (mut brdf, mut reflected) = (0.0_f32, 0.0_f32);
        for _ in 0..1000 {
            let pair = [(); 2].map(|()| uniform_hemisphere(Dir3::Z, square(&mut rng)));
            if pair.iter().any(|d| row.at.shading_normal.dot(**d) <= 0.0) {
                continue;
            }
            let f = |[a, b]: [Dir3; 2]| row.material.eval(&row.at, a, b).max_channel();
            let sent = |[a, b]: [Dir3; 2]| f([a, b]) * cosine(&row.at, a, b);
            let back = [pair[1], pair[0]];
            assert!(f(pair) >= 0.0, "{}: f is {}", row.name, f(pair));
            let off = |one: f32, other: f32| (one - other).abs() / one.max(other).max(0.01);
            brdf = brdf.max(off(f(pair), f(back)));
            reflected = reflected.max(off(sent(pair), sent(back)));
        }
        let (same, other) = match row.reciprocal {
            Reciprocal::Brdf => (brdf, 1.0),
            Reciprocal::Reflected => (reflected, brdf),
            Reciprocal::Nothing => (0.0, brdf.min(reflected)),
        };
        assert!(
            same < 2e-4 && other > 0.1,
            "{}: {:?} is said to be reciprocal; f is off by {brdf}, f cos θ by {reflected}",
            row.name,
            row.reciprocal
        );
    }
}

#[test]
fn a_ray_of_light_can_go_back() {
    for row in materials() {
        for view in views().into_iter().flat_map(|view| [view, -view]) {
            for lobe in lobes(&row, view) {
                let found = lobes(&row, lobe.toward).into_iter().any(|back| {
                    back.toward.distance(*view) < 1e-3
                        && (back.share.max_channel() - lobe.share.max_channel()).abs() < 1e-3
                });
                // At a bump, a ray that would go below the surface is mirrored at the surface itself.
                let bent = row.at.shading_normal != row.at.normal;
                assert!(found || bent, "{}, {view:?}: {lobe:?}", row.name);
            }
        }
    }
}

#[test]
fn no_more_leaves_than_arrives() {
    for row in materials() {
        for view in views().into_iter().flat_map(|view| [view, -view]) {
            let mirrored: f32 = lobes(&row, view)
                .iter()
                .map(|l| l.share.max_channel())
                .sum();
            let f = |d: Dir3| row.material.eval(&row.at, view, d).max_channel();
            let scattered = if row.material.scatters(&row.at) {
                cells(&row.at, view).integral(|d| f(d) * cosine(&row.at, view, d))
            } else {
                0.0
            };
            let sent = f64::from(mirrored) + scattered;
            let straight = view.dot(*row.at.facing(view)) > 0.999;
            let (least, most) = match row.furnace {
                Furnace::Always(share) => (share, share),
                Furnace::StraightUp(share) if straight => (share, share),
                Furnace::StraightUp(most) | Furnace::AtMost(most) => (0.0, most),
            };
            // The integral's own error, where a lobe is cut off by the horizon.
            assert!(
                sent > least - 2e-3 && sent < most + 2e-3,
                "{}, {view:?}: {sent} leaves, not {least} to {most}",
                row.name
            );
        }
    }
}

#[test]
fn physical_materials_are_those_that_are_reciprocal_and_send_out_at_most_1() {
    for row in materials() {
        let (Furnace::Always(most) | Furnace::StraightUp(most) | Furnace::AtMost(most)) =
            row.furnace;
        assert!(
            most <= 1.0 + 1e-6 || row.reciprocal != Reciprocal::Brdf,
            "{}: {most}",
            row.name
        );
    }
}

#[test]
fn samples_are_as_likely_as_their_density_says() {
    for (row, view) in scattering() {
        let density = |d: Dir3| row.material.pdf(&row.at, view, d);
        let fit = cells(&row.at, view).fit(density, |rng| {
            let sample = row.material.sample(&row.at, view, square(rng))?;
            assert!(density(sample) > 0.0, "{}: {sample:?}", row.name);
            Some(sample)
        });
        fit.assert_good(&format!("{}, {view:?}", row.name));
    }
}

#[test]
fn a_density_of_another_lobe_would_be_noticed() {
    let (at, view) = (surface(Dir3::Z), direction(0.4, 0.3, 0.8));
    let gold = |alpha| {
        let metal = Metal::GOLD;
        Box::new(Ggx { metal, alpha })
    };
    let pairs: [[Box<dyn Material>; 2]; 4] = [
        [7.0, 9.0].map(|n| Box::new(modified_phong(0.3, 0.6, n)) as _),
        [7.0, 9.0].map(|n| Box::new(normalised_blinn_phong(0.3, 0.6, n)) as _),
        [0.5, 0.6].map(|ks| Box::new(modified_phong(0.3, ks, 7.0)) as _),
        [gold(0.3), gold(0.33)].map(|metal| metal as _),
    ];
    for (i, [sampled, claimed]) in pairs.iter().enumerate() {
        let fit = cells(&at, view).fit(
            |d| claimed.pdf(&at, view, d),
            |rng| sampled.sample(&at, view, square(rng)),
        );
        assert!(!fit.is_good(), "pair {i}: {fit:?}");
    }
}

#[test]
fn a_scattered_ray_is_a_sample_with_its_density_and_its_f() {
    let mut rng = pcg::stream(2, 2);
    for (row, view) in scattering() {
        let u = square(&mut rng);
        let toward = row.material.sample(&row.at, view, u);
        let ray = row.material.scatter(&row.at, view, u);
        assert_eq!(ray.map(|ray| ray.toward), toward, "{}", row.name);
        if let Some(ray) = ray {
            let pdf = row.material.pdf(&row.at, view, ray.toward);
            let f = row.material.eval(&row.at, view, ray.toward);
            assert_eq!((ray.pdf, ray.f), (pdf, f), "{}", row.name);
        }
    }
}

#[test]
fn nothing_is_reflected_from_or_to_behind() {
    let (up, down) = (direction(0.3, 0.0, 1.0), direction(0.3, 0.0, -1.0));
    for Row {
        name, material, at, ..
    } in materials()
    {
        for (view, toward) in [(up, down), (down, up)] {
            assert_eq!(
                material.eval(&at, view, toward),
                Rgb::BLACK,
                "{name}: {view:?} {toward:?}"
            );
        }
        let turned = Surface {
            normal: -at.normal,
            shading_normal: -at.shading_normal,
            ..at
        };
        assert_eq!(
            material.eval(&at, down, down),
            material.eval(&turned, down, down),
            "{name}: seen from behind, the back is the front"
        );
    }
}

#[test]
fn the_reflected_radiance_is_the_integral() {
    let sky = |d: Dir3| Rgb::gray(1.0 + d.x);
    for (row, view) in scattering() {
        // Where f grows without bound, towards the horizon, so do the squares of samples: their mean says little.
        if row.reciprocal != Reciprocal::Brdf {
            continue;
        }
        let f = |d: Dir3| row.material.eval(&row.at, view, d).g * cosine(&row.at, view, d);
        let exact = cells(&row.at, view).integral(|d| f(d) * (1.0 + d.x));
        let mean = Mean::sampled(6, 5, |rng| {
            reflected_radiance(&*row.material, &row.at, view, &sky, 200, rng).g
        });
        assert!(
            (mean.mean - exact).abs() < 5.0 * mean.error + 2e-3,
            "{}, {view:?}: {mean:?}, not {exact}",
            row.name
        );
    }
}
