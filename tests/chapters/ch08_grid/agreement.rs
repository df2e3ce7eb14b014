//! The grid finds what the list finds.

use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::accel::{Accel, grid::Grid, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::scene::{soup::soup, stadium::stadium, terrain::terrain};
use raybook::shape::{mesh::Facet, teapot};

const AHEAD: Interval = Interval::AHEAD;

/// Corners on a lattice of quarters, so that many are equal, in one plane, on the axes or without area.
fn corner() -> impl Strategy<Value = Vec3> {
    let quarter = || (-8..9_i16).prop_map(|i| 0.25 * f32::from(i));
    prop_oneof![
        3 => (quarter(), quarter(), quarter()).prop_map(|(x, y, z)| vec3(x, y, z)),
        2 => prop::array::uniform3(-2.0_f32..2.0).prop_map(Vec3::from),
    ]
}

fn direction() -> impl Strategy<Value = Vec3> {
    let component = || {
        prop_oneof![
            Just(0.0_f32),
            Just(-0.0),
            Just(1.0),
            Just(-1.0),
            -1.0_f32..1.0
        ]
    };
    (component(), component(), component()).prop_map(|(x, y, z)| vec3(x, y, z))
}

fn facets() -> impl Strategy<Value = Vec<Facet>> {
    let triangles = prop::collection::vec([corner(), corner(), corner()], 0..40);
    (triangles, 0..3_usize).prop_map(|(mut triangles, again)| {
        for _ in 0..again {
            triangles.extend(triangles.first().copied());
        }
        facets_of(triangles)
    })
}

fn facets_of(triangles: Vec<[Vec3; 3]>) -> Vec<Facet> {
    triangles
        .into_iter()
        .zip(0..)
        .map(|(corners, id)| Facet { corners, id })
        .collect()
}

/// The same shape, or the same distance up to rounding. A triangle that is seen from its edge has no certain distance.
fn agrees(
    accel: &impl Accel<Facet>,
    list: &List<Facet>,
    ray: &Ray,
    within: Interval,
) -> Result<(), String> {
    let (found, right) = (accel.closest(ray, within), list.closest(ray, within));
    let told = || format!("{ray:?} {within:?}: {found:?}, but the list has {right:?}");
    if accel.any(ray, within) != right.is_some() {
        return Err(format!("any differs; {}", told()));
    }
    match (&found, &right) {
        (None, None) => Ok(()),
        (Some((a, x)), Some((b, y))) => {
            let scale = b.corners.map(|p| (p - ray.origin).abs().max_element());
            let scale = scale.into_iter().fold(y.t, f32::max);
            let edge_on = [a, b].into_iter().any(|facet| {
                let [p0, p1, p2] = facet.corners;
                let n = Dir3::new((p1 - p0).cross(p2 - p0));
                n.is_none_or(|n| n.dot(*ray.direction).abs() < 1e-3)
            });
            let close = (x.t - y.t).abs() <= 32.0 * (f32::EPSILON / 2.0) * scale;
            if x.id == y.id || close || edge_on {
                Ok(())
            } else {
                Err(told())
            }
        }
        _ => Err(told()),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn the_grid_agrees_with_the_list(
        facets in facets(),
        rays in prop::collection::vec((corner(), direction()), 1..20),
        resolution in prop::array::uniform3(1_u32..24),
        scale in prop_oneof![Just(1.0_f32), Just(1e-6), Just(1e6), 0.1_f32..10.0],
        away in prop_oneof![3 => Just(Vec3::ZERO), 1 => Just(vec3(1000.0, -300.0, 20.0))],
        max in prop_oneof![Just(f32::INFINITY), 0.5_f32..4.0],
    ) {
        let place = |p: Vec3| scale * (p + away);
        let facets: Vec<_> = facets.into_iter().map(|f| Facet { corners: f.corners.map(place), ..f }).collect();
        let list = List::new(facets.clone());
        let n = facets.len() as f32;
        let grids = [
            Grid::of_facets(facets.clone()),
            Grid::new(facets.clone()),
            Grid::of_facets_with_resolution(facets, resolution.into()),
        ];
        for grid in &grids {
            prop_assert_eq!(grid.validate(), Ok(()), "of {} facets", n);
            for &(origin, direction) in &rays {
                let ray = Ray::new(place(origin), Dir3::new_or(direction, Dir3::Z));
                let told = agrees(grid, &list, &ray, Interval::new(0.0, scale * max));
                prop_assert_eq!(told, Ok(()));
                let from = Ray::new(place(3.0 * origin - 2.0 * direction), ray.direction);
                prop_assert_eq!(agrees(grid, &list, &from, AHEAD), Ok(()));
            }
        }
    }
}

#[test]
fn rays_from_far_away_find_what_the_list_finds() {
    let mesh = teapot::mesh(6);
    let (grid, list) = (Grid::of_facets(mesh.facets()), List::new(mesh.facets()));
    let mut hits = 0;
    for distance in [10.0, 1e3, 1e5, 1e6] {
        for i in 0..300_u16 {
            let turn = vec3(
                (f32::from(i)).sin(),
                0.3 * (0.7 * f32::from(i)).cos(),
                f32::from(i).cos(),
            );
            let aim = vec3(0.0, 1.5, 0.0)
                + vec3((3.1 * f32::from(i)).sin(), (2.3 * f32::from(i)).sin(), 0.0);
            let toward = Dir3::new_or(-turn, Dir3::X);
            let ray = Ray::new(aim - distance * *toward, toward);
            assert_eq!(
                agrees(&grid, &list, &ray, AHEAD),
                Ok(()),
                "from {distance} m away"
            );
            hits += u32::from(grid.any(&ray, AHEAD));
        }
    }
    assert!(hits > 600, "most rays hit: {hits}");
}

#[test]
fn stock_scenes_agree_from_everywhere() {
    for mesh in [soup(3000, 1), terrain(40), stadium(1).mesh] {
        let (grid, list) = (Grid::of_facets(mesh.facets()), List::new(mesh.facets()));
        assert_eq!(grid.validate(), Ok(()));
        let bounds = mesh.bounds();
        let mut hits = 0;
        for i in 0..400_u16 {
            let wave = |a: f32| (a * f32::from(i)).sin();
            let from =
                bounds.center() + 0.9 * bounds.size() * vec3(wave(1.1), wave(2.3).abs(), wave(3.7));
            let to = bounds.center() + 0.4 * bounds.size() * vec3(wave(5.3), wave(4.1), wave(6.1));
            let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
            assert_eq!(agrees(&grid, &list, &ray, AHEAD), Ok(()));
            hits += u32::from(list.any(&ray, AHEAD));
        }
        assert!(hits > 100, "rays hit something: {hits}");
    }
}

#[test]
fn a_wrong_grid_is_noticed() {
    let mesh = teapot::mesh(4);
    let fewer: Vec<_> = mesh
        .facets()
        .into_iter()
        .filter(|f| f.id % 10 > 0)
        .collect();
    let (grid, list) = (Grid::of_facets(fewer), List::new(mesh.facets()));
    let wrong = (0..200_u16).filter(|&i| {
        let from = vec3(4.0 * f32::from(i).sin(), 2.5, 4.0 * f32::from(i).cos());
        let ray = Ray::new(from, Dir3::new_or(vec3(0.0, 1.2, 0.0) - from, Dir3::X));
        agrees(&grid, &list, &ray, AHEAD).is_err()
    });
    assert!(wrong.count() > 5, "a tenth of the triangles is missing");
}
