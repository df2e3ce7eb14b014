//! A texture is averaged over what a sample of a pixel covers.

use glam::Mat3;
use raybook::image::rms::rms;
use raybook::material::texture::Texture;
use raybook::prelude::*;
use raybook::render::cone::Cone;
use std::sync::Arc;

/// Glows as brightly as the texture is wide.
struct Width;

impl Material for Width {
    fn emitted(&self, at: &Surface, _view: Dir3) -> Rgb {
        Rgb::gray(at.texture_width)
    }

    fn scatters(&self, _at: &Surface) -> bool {
        false
    }
}

/// A square with texture coordinates from 0 to 1, `side` metres long, before z = 0.
fn wall(side: f32) -> Meshed<WideBvh> {
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let positions = corners.map(|(x, y)| side * vec3(x - 0.5, y - 0.5, 0.0));
    let textures = corners.map(|(x, y)| vec2(x, y));
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    let mesh = Mesh::new(positions.into(), triangles, None, Some(textures.into()));
    Meshed::new(mesh.expect("a square is a mesh"), WideBvh::new)
}

/// What the middle of a film of 101 rows, 40 degrees high, sees from a point of the z axis, looking along −z.
fn middle(z: f32, samples: usize, integrator: &dyn Integrator, things: Vec<Thing>) -> f32 {
    let eye = vec3(0.0, 0.0, z);
    let camera = Pinhole::look_at(eye, eye - Vec3::Z, Vec3::Y, focal_length(40.0), 1.0);
    let camera = camera.expect("it looks along the axis");
    let scene = Scene::new(things, vec![]);
    let film = Film::new(101, 101, samples);
    film.render(&camera, &Sampler::Even, integrator, &scene)
        .at(50, 50)
        .g
}

/// The edge of the pixel in the middle, a metre away.
fn pixel() -> f32 {
    2.0 * 20.0_f32.to_radians().tan() / 101.0
}

#[track_caller]
fn near(got: f32, expected: f32, what: &str) {
    assert!(
        (got / expected - 1.0).abs() < 0.01,
        "{what}: {got}, not {expected}"
    );
}

/// A camera whose rays are parallel, 3 m across and 2 m down.
struct Parallel;

impl Camera for Parallel {
    fn ray(&self, film: Vec2, _lens: Vec2) -> Ray {
        let place = vec3(3.0 * (film.x - 0.5), 2.0 * (0.5 - film.y), 0.0);
        Ray::new(place, -Dir3::Z)
    }
}

#[test]
fn of_parallel_rays_a_pixel_is_as_wide_at_any_distance() {
    let cone = Cone::of_sample(&Parallel, &Film::new(30, 20, 4));
    near(cone.width, 0.1 / 2.0, "one of four samples");
    assert_eq!(cone.after(50.0), cone);
}

#[test]
fn a_texture_is_as_wide_as_the_pixel_that_sees_it() {
    for z in [0.5, 2.0, 30.0] {
        for side in [1.0, 50.0] {
            let got = middle(z, 1, &Path::WHOLE, vec![Thing::new(wall(side), Width)]);
            near(got, pixel() * z / side, "a wall");
        }
    }
    let ball = Thing::new(Sphere::new(Vec3::ZERO, 0.5), Width);
    // At the equator 1 is 2πr to the east and πr to the north.
    let per_metre = 1.0 / (2.0_f32.sqrt() * std::f32::consts::PI * 0.5);
    near(
        middle(3.0, 1, &Path::WHOLE, vec![ball]),
        pixel() * 2.5 * per_metre,
        "a ball",
    );
    let plane = Thing::new(Plane::through(Vec3::ZERO, Dir3::Z), Width);
    near(
        middle(3.0, 1, &Path::WHOLE, vec![plane]),
        pixel() * 3.0,
        "a plane",
    );
    let board = Cuboid::between(vec3(-2.0, -1.0, -1.0), vec3(2.0, 1.0, 0.0));
    near(
        middle(3.0, 1, &Path::WHOLE, vec![Thing::new(board, Width)]),
        pixel() * 3.0 / 8.0_f32.sqrt(),
        "a box",
    );
}

#[test]
fn more_samples_are_narrower_and_a_leaning_or_larger_wall_is_what_it_is() {
    let alone = middle(3.0, 1, &Path::WHOLE, vec![Thing::new(wall(1.0), Width)]);
    for (samples, share) in [(4, 0.5), (16, 0.25), (64, 0.125), (256, 0.125)] {
        let got = middle(
            3.0,
            samples,
            &Path::WHOLE,
            vec![Thing::new(wall(1.0), Width)],
        );
        near(got, alone * share, &format!("{samples} samples"));
    }
    let placed = |scale: f32, degrees: f32| Instance {
        shape: Arc::new(wall(1.0)),
        scale,
        rotation: Mat3::from_rotation_x(degrees.to_radians()),
        translation: Vec3::ZERO,
    };
    let twice = Thing::new(placed(2.0, 0.0), Width);
    near(
        middle(3.0, 1, &Path::WHOLE, vec![twice]),
        alone / 2.0,
        "twice as large",
    );
    let leaning = Thing::new(placed(1.0, 60.0), Width);
    near(
        middle(3.0, 1, &Path::WHOLE, vec![leaning]),
        alone * 2.0,
        "at 60 degrees",
    );
}

#[test]
fn in_a_mirror_the_way_goes_on() {
    // The eye is at 1, the mirror at 0, and the wall behind the eye at 5: six metres of way.
    let turned = Instance {
        shape: Arc::new(wall(2.0)),
        scale: 1.0,
        rotation: Mat3::from_rotation_y(std::f32::consts::PI),
        translation: vec3(0.0, 0.0, 5.0),
    };
    let thing = Thing::new(turned, Width);
    let mirror = Thing::new(wall(1.0), Mirror { share: Rgb::WHITE });
    let got = middle(1.0, 1, &Path::WHOLE, vec![thing, mirror]);
    near(got, pixel() * 6.0 / 2.0, "by a mirror");
}

#[test]
fn a_floor_of_fine_squares_turns_grey_far_away_with_a_sample_a_pixel() {
    struct Sharp(ImageTexture<Lambert>);
    impl Texture for Sharp {
        type Material = Lambert;
        fn at(&self, surface: &Surface) -> Lambert {
            let texture_width = 0.0;
            self.0.at(&Surface {
                texture_width,
                ..*surface
            })
        }
    }
    let squares = Image::from_fn(64, 64, |x, y| Rgb::gray(((x / 4 + y / 4) % 2) as f32));
    let map = Arc::new(MipMap::new(&squares));
    let paper = || ImageTexture::new(map.clone(), |albedo| Lambert { albedo });
    let floor = || Plane::through(Vec3::ZERO, Dir3::Y);
    let draw = |samples, material: Arc<dyn Material>| {
        let thing = Thing {
            shape: Arc::new(floor()),
            material,
        };
        let scene = Scene::new(vec![thing], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::gray(0.5));
        let eye = vec3(0.0, 1.0, 0.0);
        let camera = Pinhole::look_at(eye, vec3(0.1, 0.2, -4.0), Vec3::Y, focal_length(30.0), 2.0);
        let film = Film::new(96, 48, samples);
        film.render(
            &camera.expect("a view"),
            &Sampler::Even,
            &Path::WHOLE,
            &scene,
        )
    };
    let truth = draw(512, Arc::new(Sharp(paper())));
    let (sharp, soft) = (
        draw(1, Arc::new(Sharp(paper()))),
        draw(1, Arc::new(paper())),
    );
    let (sharp, soft) = (
        rms(&truth, &sharp, |_, _| true),
        rms(&truth, &soft, |_, _| true),
    );
    assert!(
        soft < 0.4 * sharp,
        "RMS error {soft} with cones, {sharp} without"
    );
}

#[test]
fn a_cone_of_no_width_is_the_sharp_picture() {
    let mut at = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
    at.texture_per_metre = 3.0;
    Cone::THIN.after(1e6).cover(&mut at, Dir3::Y);
    assert_eq!(at.texture_width, 0.0);
}
