//! The laws of materials: light and viewer can change places, no more leaves than arrives, and samples fit their density.

use crate::ch17_rendering_equation::cells::Cells;
use crate::ch17_rendering_equation::materials::{
    ANGLES, Furnace, Reciprocal, Row, materials, modified_phong, normalised_blinn_phong,
};
use crate::ch17_rendering_equation::{direction, square, surface};
use raybook::image::rgb::Rgb;
use raybook::material::{Material, conductor::Metal, ggx::Ggx};
use raybook::math::{dir3::Dir3, pcg};
use raybook::render::reflection::reflected_radiance;
use raybook::sample::hemisphere::uniform_hemisphere;
use raybook::shape::Surface;
use raybook_common::statistics::Mean;

/// The materials that have an f, for each of their views from above.
fn scattering() -> Vec<(Row, Dir3)> {
    let rows = |i| materials().into_iter().map(move |row| (i, row));
    let all = (0..ANGLES.len()).flat_map(rows);
    let mut all: Vec<_> = all
        .map(|(i, row)| {
            let view = row.views()[i];
            (row, view)
        })
        .collect();
    all.retain(|(row, _)| row.material.scatters(&row.at));
    all
}

/// Views from above and from below.
fn both_sides(row: &Row) -> impl Iterator<Item = Dir3> {
    row.views().into_iter().flat_map(|view| [view, -view])
}

#[test]
fn light_and_viewer_can_change_places() {
    let mut rng = pcg::stream(1, 1);
    let off = |one: f32, other: f32| (one - other).abs() / one.max(other).max(0.01);
    for row in materials() {
        // How far f and f cos θ are from being reciprocal, at most.
        let (mut brdf, mut reflected) = (0.0_f32, 0.0_f32);
        for _ in 0..1000 {
            let [a, b] = [(); 2].map(|()| uniform_hemisphere(Dir3::Z, square(&mut rng)));
            if a.dot(*row.at.shading_normal)
                .min(b.dot(*row.at.shading_normal))
                > 0.0
            {
                assert!(row.f(a, b) >= 0.0, "{}: f is {}", row.name, row.f(a, b));
                brdf = brdf.max(off(row.f(a, b), row.f(b, a)));
                reflected = reflected.max(off(row.reflected(a, b), row.reflected(b, a)));
            }
        }
        // f32 rounds to 1e-7, which the sharpest lobe makes 1e-4.
        let kept = match row.reciprocal {
            Reciprocal::Brdf => brdf < 2e-4,
            Reciprocal::Reflected => reflected < 2e-4 && brdf > 0.1,
            Reciprocal::Nothing => brdf.min(reflected) > 0.1,
        };
        assert!(
            kept,
            "{}: {:?} should be reciprocal; f is off by {brdf}, f cos θ by {reflected}",
            row.name, row.reciprocal
        );
    }
}

#[test]
fn a_ray_of_light_can_go_back() {
    for row in materials() {
        // At a bump, a ray that would go below the surface is mirrored at the surface itself, and does not go back.
        if row.at.shading_normal != row.at.normal {
            continue;
        }
        for view in both_sides(&row) {
            for (toward, share) in row.delta_lobes(view) {
                let goes_back = |(back, again): (Dir3, f32)| {
                    back.distance(*view) < 1e-3 && (again - share).abs() < 1e-3
                };
                assert!(
                    row.delta_lobes(toward).into_iter().any(goes_back),
                    "{}: {share} of {toward:?} comes to {view:?}, and not back",
                    row.name
                );
            }
        }
    }
}

#[test]
fn as_much_leaves_as_the_table_says_in_a_white_furnace() {
    for row in materials() {
        for view in both_sides(&row) {
            let scattered = row.cells(view).integral(|d| row.reflected(view, d));
            let shares = row.delta_lobes(view).into_iter().map(|(_, share)| share);
            let sent = scattered + f64::from(shares.sum::<f32>());
            let straight = row.at.facing(view).dot(*view) > 0.999;
            let (least, most) = match row.furnace {
                Furnace::Always(share) => (share, share),
                Furnace::StraightUp(share) if straight => (share, share),
                Furnace::StraightUp(most) | Furnace::AtMost(most) => (0.0, most),
            };
            // The integral is wrong by up to 1e-3 where the horizon cuts a lobe off.
            assert!(
                sent > least - 2e-3 && sent < most + 2e-3,
                "{}, {view:?}: {sent} leaves, not {least} to {most}",
                row.name
            );
        }
    }
}

#[test]
fn only_models_that_are_not_reciprocal_send_out_more_than_arrives() {
    let too_much = |row: &Row| match row.furnace {
        Furnace::Always(most) | Furnace::StraightUp(most) | Furnace::AtMost(most) => {
            most > 1.0 + 1e-6
        }
    };
    let rows: Vec<_> = materials().into_iter().filter(too_much).collect();
    assert_eq!(rows.len(), 2, "Phong and Blinn-Phong with a large k_s");
    for row in rows {
        assert_eq!(row.reciprocal, Reciprocal::Nothing, "{}", row.name);
    }
}

#[test]
fn samples_are_as_likely_as_their_density_says() {
    for (row, view) in scattering() {
        let density = |d: Dir3| row.material.pdf(&row.at, view, d);
        let fit = row.cells(view).fit(density, |rng| {
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
        let fit = Cells::around(direction(-0.4, -0.3, 0.8)).fit(
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
        let exact = row
            .cells(view)
            .integral(|d| row.reflected(view, d) * (1.0 + d.x));
        let mean = Mean::sampled(6, 5, |rng| {
            reflected_radiance(&*row.material, &row.at, view, &sky, 200, rng).max_channel()
        });
        assert!(
            (mean.mean - exact).abs() < 5.0 * mean.error + 2e-3,
            "{}, {view:?}: {mean:?}, not {exact}",
            row.name
        );
    }
}
