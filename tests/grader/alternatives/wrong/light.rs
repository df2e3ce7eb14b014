//! Chapters 12 to 21: highlights, shadows, directions, lenses, bent rays.

use crate::alternatives::wrong::{Wrong, scale, turn};

const HIGHLIGHTS: &[&str] = &["phong", "blinn_phong"];
const LIGHTS: &[&str] = &["sample_rect", "sample_sphere_light"];

pub const WRONGS: &[Wrong] = &[
    (&["geodesic_step"], "1 % too far", |photon| {
        scale(&mut photon[..3], 1.01);
    }),
    (
        &["geodesic_step"],
        "the velocity is turned by 1°",
        |photon| {
            turn(&mut photon[3..]);
        },
    ),
    (&["deflection_angle"], "1 % too large", |angle| {
        scale(angle, 1.01);
    }),
    (HIGHLIGHTS, "a little more red", |c| c[0] += 0.01),
    (HIGHLIGHTS, "a little less blue", |c| c[2] -= 0.01),
    (&["shadow_ray"], "1° beside the light", |way| {
        turn(&mut way[3..6]);
    }),
    (&["shadow_ray"], "ends 1 % behind the light", |way| {
        way[7] = if way[7].is_finite() {
            1.02 * way[7]
        } else {
            1e6
        };
    }),
    (&["lit"], "the other way round", |lit| lit[0] = 1.0 - lit[0]),
    (&["point_light"], "1° beside the light", |light| {
        turn(&mut light[..3]);
    }),
    (&["point_light"], "1 % too near", |light| light[3] *= 0.99),
    (&["point_light"], "1 % too bright", |light| {
        scale(&mut light[4..], 1.01);
    }),
    (&["refract"], "turned by 1°", |t| turn(t)),
    (&["refract"], "1 % too long", |t| scale(t, 1.01)),
    (&["fresnel"], "Rp is off by 0.001", |r| r[1] += 0.001),
    (&["fresnel"], "R is off by 0.001", |r| r[2] -= 0.001),
    (LIGHTS, "the last density is off by 2 %", |c| {
        c[c.len() - 2] *= 1.02;
    }),
    (LIGHTS, "the last is 20 % too far", |c| {
        c[c.len() - 3] *= 1.2;
    }),
    (LIGHTS, "the last direction is NaN", |c| {
        c[c.len() - 4] = f64::NAN;
    }),
    (&["visible_fraction"], "dark is light", |f| {
        f[1..].iter_mut().for_each(|f| *f = 1.0 - *f);
    }),
    (&["cosine_hemisphere"], "1 % too long", |list| {
        scale(&mut list[1..], 1.01);
    }),
    (&["cosine_hemisphere"], "every third is the first", |list| {
        let first = [list[1], list[2], list[3]];
        for i in (1..list.len()).step_by(9) {
            list[i..i + 3].copy_from_slice(&first);
        }
    }),
    (&["brdf_phong"], "1 % too bright", |f| scale(f, 1.01)),
    (&["reflected_radiance"], "10 % too bright", |l| {
        scale(l, 1.1);
    }),
    (&["direction_to_cube"], "u is off by 0.01", |place| {
        place[1] += 0.01;
    }),
    (&["direction_to_latlong"], "v is off by 0.01", |place| {
        place[1] += if place[1] < 0.5 { 0.01 } else { -0.01 };
    }),
    (
        &["sample_environment"],
        "every third is the first",
        |list| {
            let first: Vec<f64> = list.iter().skip(1).take(3).copied().collect();
            for direction in list[1..].chunks_exact_mut(9) {
                direction[..3].copy_from_slice(&first);
            }
        },
    ),
    (&["environment_pdf"], "1 % too large", |density| {
        scale(density, 1.01);
    }),
    (&["concentric_disk"], "5 % too far out", |points| {
        scale(&mut points[1..], 1.05);
    }),
    (&["concentric_disk"], "every third is the first", |points| {
        let first: Vec<f64> = points[1..3].to_vec();
        for p in points[1..].chunks_exact_mut(6) {
            p[..2].copy_from_slice(&first);
        }
    }),
    (&["thin_lens_ray"], "turned by 1°", |ray| {
        turn(&mut ray[3..]);
    }),
    (&["thin_lens_ray"], "starts 1 mm beside", |ray| {
        ray[0] += 1e-3;
    }),
    (&["circle_of_confusion"], "1 % too wide", |c| {
        scale(c, 1.01);
    }),
    (&["panorama_ray"], "turned by 1°", |ray| {
        turn(&mut ray[3..]);
    }),
    (&["panorama_ray"], "1 % too long", |ray| {
        scale(&mut ray[3..], 1.01);
    }),
    (&["panorama_ray"], "1 cm to the right", |ray| ray[0] += 0.01),
    (&["trace"], "5 % and 0.006 too bright", |c| {
        for channel in c {
            *channel = 1.05 * *channel + 0.006;
        }
    }),
    (&["trace"], "a little more red", |c| c[0] += 0.02),
];
