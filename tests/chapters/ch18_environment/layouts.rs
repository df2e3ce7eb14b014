//! The three layouts: where directions are, and the way from one to another.

use crate::ch18_environment::direction;
use glam::{Vec2, vec2};
use raybook::image::{Image, rgb::Rgb};
use raybook::light::environment::angular::Angular;
use raybook::light::environment::convert::{LatLong, Layout, convert};
use raybook::light::environment::cube::{self, Cross};
use raybook::light::environment::latlong;
use raybook::math::{dir3::Dir3, pcg};

/// Directions are unit vectors of `f32`, and a place a handful of operations away from them: rounding only.
const ROUNDED: f32 = 2e-6;

#[test]
fn known_directions_are_where_they_should_be() {
    let middle = vec2(0.5, 0.5);
    assert_eq!(latlong::place(-Dir3::Z), middle, "−z is in the middle");
    assert_eq!(
        latlong::place(Dir3::X),
        vec2(0.75, 0.5),
        "+x is right of it"
    );
    assert_eq!(
        latlong::place(-Dir3::X),
        vec2(0.25, 0.5),
        "−x is left of it"
    );
    assert_eq!(latlong::place(Dir3::Z), vec2(0.0, 0.5), "+z is at the edge");
    assert_eq!(latlong::place(Dir3::Y).y, 0.0, "+y is the top edge");
    assert_eq!(latlong::place(-Dir3::Y).y, 1.0, "−y is the bottom edge");
    for (face, axis) in [Dir3::X, -Dir3::X, Dir3::Y, -Dir3::Y, Dir3::Z, -Dir3::Z]
        .into_iter()
        .enumerate()
    {
        assert_eq!(
            cube::place(axis),
            (face, middle),
            "the middle of face {face}"
        );
    }
    assert_eq!(
        Angular.place(-Dir3::Z),
        middle,
        "−z is the angular map's middle"
    );
    let right = Angular.place(Dir3::X);
    assert!(
        right.distance(vec2(0.75, 0.5)) < ROUNDED,
        "+x is half way to the rim, not at {right}"
    );
}

#[test]
fn up_is_up_and_right_is_right_in_every_layout() {
    let (mut right, mut up) = (-*Dir3::Z, -*Dir3::Z);
    right.x = 0.1;
    up.y = 0.1;
    let [right, up] = [right, up].map(|v| Dir3::new(v).expect("not zero"));
    let check = |name: &str, layout: &dyn Layout| {
        let middle = layout.place(-Dir3::Z);
        assert!(
            layout.place(right).x > middle.x,
            "{name}: +x is right of −z"
        );
        assert!(layout.place(up).y < middle.y, "{name}: +y is above −z");
    };
    check("lat-long", &LatLong);
    check("cross", &Cross);
    check("angular", &Angular);
}

#[test]
fn a_place_and_its_direction_are_inverses() {
    let mut rng = pcg::stream(181, 0);
    for _ in 0..20_000 {
        let d = direction(&mut rng);
        for (name, back) in [
            ("lat-long", LatLong.direction(LatLong.place(d))),
            ("cross", Cross.direction(Cross.place(d))),
            ("angular", Angular.direction(Angular.place(d))),
        ] {
            let back = back.expect("every direction has a place");
            // In the angular map all of the rim is one direction: there a rounding of the place moves it most.
            let allowed = if name == "angular" { 20.0 } else { 2.0 } * ROUNDED;
            assert!(
                back.distance(*d) < allowed,
                "{name}: {d:?} becomes {back:?}, off by {}",
                back.distance(*d)
            );
        }
    }
}

#[test]
fn neighbouring_squares_of_the_cross_meet() {
    // Along the middle row, the right edge of a square is the left edge of the next.
    for (column, next) in [(0, 1), (1, 2), (2, 3)] {
        for y in [0.1, 0.5, 0.9] {
            let at = |x: f32| Cross.direction(vec2(x / 4.0, (1.0 + y) / 3.0));
            let left = at(column as f32 + 0.9999).expect("a wall");
            let right = at(next as f32 + 0.0001).expect("a wall");
            assert!(
                left.distance(*right) < 1e-3,
                "walls {column} and {next} meet at {y}"
            );
        }
    }
    // Below the ceiling and above the floor is −z.
    for (from, to) in [(0.9999, 1.0001), (2.0001, 1.9999)] {
        let at = |y: f32| Cross.direction(vec2(1.3 / 4.0, y / 3.0)).expect("a face");
        assert!(
            at(from).distance(*at(to)) < 1e-3,
            "−z meets ceiling and floor"
        );
    }
}

/// A smooth light: brightest towards a direction that no layout knows.
fn smooth(d: Dir3) -> Rgb {
    let toward = Dir3::new_or(glam::vec3(0.3, 0.5, -0.8), Dir3::Y);
    let c = d.dot(*toward);
    Rgb::new(1.0 + c, (2.0 * c).exp(), 1.0 + d.x * d.y)
}

fn map(layout: &impl Layout, width: usize, height: usize) -> Image {
    Image::from_fn(width, height, |x, y| {
        let place = vec2(x as f32 + 0.5, y as f32 + 0.5) / vec2(width as f32, height as f32);
        layout.direction(place).map_or(Rgb::BLACK, smooth)
    })
}

/// The largest and the mean error of a map against the light it should hold.
fn errors(map: &Image, layout: &impl Layout) -> (f32, Vec2) {
    let size = vec2(map.width() as f32, map.height() as f32);
    let (mut largest, mut shift, mut count) = (0.0_f32, Vec2::ZERO, 0.0);
    for (x, y) in (0..map.height()).flat_map(|y| (0..map.width()).map(move |x| (x, y))) {
        let place = (vec2(x as f32, y as f32) + 0.5) / size;
        if let Some(d) = layout.direction(place) {
            let error = map.at(x, y).g - smooth(d).g;
            largest = largest.max(error.abs());
            shift += error * vec2(d.x, d.y);
            count += 1.0;
        }
    }
    (largest, shift / count)
}

#[test]
fn conversions_keep_the_light_where_it_is() {
    let original = map(&LatLong, 512, 256);
    let cross = convert(&original, &LatLong, &Cross, 512, 384);
    let angular = convert(&original, &LatLong, &Angular, 384, 384);
    let back = convert(&cross, &Cross, &LatLong, 512, 256);
    // A texel is 0.012 rad; the light changes by at most 2e² = 15 per radian, by less than half a texel per conversion.
    for (name, (largest, shift), allowed) in [
        ("lat-long to cross", errors(&cross, &Cross), 0.12),
        ("lat-long to angular", errors(&angular, &Angular), 0.15),
        ("and back from the cross", errors(&back, &LatLong), 0.20),
    ] {
        assert!(largest < allowed, "{name}: a texel is off by {largest}");
        // A shift by half a texel would be an error of one sign along its direction: some 0.01 here.
        assert!(
            shift.abs().max_element() < 1e-3,
            "{name}: the light has moved, by {shift}"
        );
    }
}

#[test]
fn a_shift_by_half_a_texel_would_be_noticed() {
    let shifted = Image::from_fn(512, 256, |x, y| {
        smooth(latlong::direction(vec2(x as f32 / 512.0, y as f32 / 256.0)))
    });
    let (_, shift) = errors(&shifted, &LatLong);
    assert!(shift.abs().max_element() > 2e-3, "it is {shift}");
}

#[test]
fn a_map_of_one_texel_is_light_from_everywhere() {
    let one = Image::from_fn(1, 1, |_, _| Rgb::gray(3.0));
    let cross = convert(&one, &LatLong, &Cross, 8, 6);
    assert_eq!(cross.at(2, 3), Rgb::gray(3.0), "a wall");
    assert_eq!(cross.at(0, 0), Rgb::BLACK, "outside the cross");
}
