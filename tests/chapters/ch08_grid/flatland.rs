//! The plane with its ray, in which cells are numbered.

use glam::{Vec3, vec3};
use raybook::math::aabb::Aabb;
use raybook_chapters::shared::flatland::{plane, ray};

/// Pixels of the canvas to a metre.
const METRE: f32 = 108.0;

#[test]
fn a_number_stands_where_the_ray_does_not_cover_it() {
    let cell = |middle: Vec3| Aabb {
        min: middle - vec3(0.5, 0.5, 0.0),
        max: middle + vec3(0.5, 0.5, 0.0),
    };
    let on_the_ray = ray().at(8.0);
    for (part, is_left) in [(vec3(-0.4, 0.4, 0.0), false), (vec3(0.4, -0.4, 0.0), true)] {
        let cell = cell(on_the_ray - part); // whose corner the ray passes
        let drawn = plane(|plane| plane.visited(&cell, 12, 3));
        let svg = drawn.expect("it is drawn").svg;
        // A tag's place along x, in pixels of the canvas.
        let place = |tag: &str, of: &str| -> f32 {
            let tags = svg.split(tag).skip(1);
            let mut tags =
                tags.filter(|rest| rest.split('>').next().is_some_and(|tag| tag.contains(of)));
            let words = tags.next().and_then(|rest| rest.split('"').next());
            words.and_then(|x| x.parse().ok()).expect(tag)
        };
        let off = place("<text x=\"", "") - place("<rect x=\"", "#E69F00");
        assert_eq!(off < 0.2 * METRE, is_left, "{part}: {off}");
    }
}
