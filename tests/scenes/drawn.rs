//! What a scene file says is what is drawn: as by the library itself, bit for bit.

use crate::{CAMERA, parse};
use rand::RngExt;
use raybook::image::compare::{Tolerance, compare};
use raybook::image::file;
use raybook::material::normalised_blinn_phong::NormalisedBlinnPhong;
use raybook::math::pcg;
use raybook::prelude::*;
use raybook::render::local::{Local, NO_SHADOWS, Visibility};
use raybook::render::shadow;
use raybook::render::{caustics::Caustics, photons::Photons};
use raybook::sample::filter::Filter;
use raybook::scene::cornell;
use raybook_common::{project, rays::random_direction};
use raybook_scenes::wrong::TextError;
use raybook_scenes::{Shot, gallery, load};

#[test]
fn a_scene_file_draws_what_the_library_draws() {
    let text = "[picture]\nwidth = 24\nheight = 16\nsamples = 8\nseed = 5\n\
        [camera]\nfrom_m = [0, 1, 5]\nto_m = [0, 0.5, 0]\nfocal_length_mm = 35\nf_number = 2\nfocus_m = 4\n\
        [integrator]\nkind = \"path\"\ndepth = 5\n\
        [[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 1, 0]\nradius_m = 1\nmaterial = \"gold\"\n\
        [[shapes]]\nkind = \"plane\"\npoint_m = [0, 0, 0]\nmaterial = { kind = \"matte\", colour = 0.5 }\n\
        [[shapes]]\nkind = \"sphere\"\ncenter_m = [1.2, 0.4, 1.5]\nradius_m = 0.4\n\
        material = { kind = \"blinn-phong\", colour = 0.9, specular = 0.25, exponent = 30 }\n\
        [materials.gold]\nkind = \"metal\"\nmetal = \"gold\"\nroughness = 0.2\n\
        [[lights]]\nkind = \"rectangle\"\ncorner_m = [-1, 4, -1]\na_m = [2, 0, 0]\nb_m = [0, 0, 2]\nradiance = 12\n\
        [backdrop]\nhorizon = 0.4\n";
    let shot = parse(text).unwrap_or_else(|error| panic!("{error}"));
    let film = Film {
        seed: 5,
        threads: 2,
        ..Film::new(24, 16, 8)
    };
    let drawn = shot.render(&film);
    let things = vec![
        Thing::new(
            Sphere::new(vec3(0.0, 1.0, 0.0), 1.0),
            Ggx {
                metal: Metal::GOLD,
                alpha: 0.2,
            },
        ),
        Thing::new(
            Plane::through(Vec3::ZERO, Dir3::Y),
            Lambert {
                albedo: Rgb::gray(0.5),
            },
        ),
        Thing::new(
            Sphere::new(vec3(1.2, 0.4, 1.5), 0.4),
            NormalisedBlinnPhong {
                diffuse: Rgb::gray(0.9 * 0.75),
                specular: Rgb::gray(0.25),
                exponent: 30.0,
            },
        ),
    ];
    let lamp = RectLight::new(
        vec3(-1.0, 4.0, -1.0),
        2.0 * Vec3::X,
        2.0 * Vec3::Z,
        Rgb::gray(12.0),
    );
    let scene = Scene::new(things, vec![Box::new(lamp)])
        .surrounded_by(Rgb::BLACK, |_| Rgb::gray(0.4).lerp(Rgb::gray(0.4), 0.5));
    let view = Pinhole::look_at(
        vec3(0.0, 1.0, 5.0),
        vec3(0.0, 0.5, 0.0),
        Vec3::Y,
        0.035,
        1.5,
    )
    .unwrap();
    let camera = ThinLens::with_view(&view, 0.035 / 2.0, 4.0, Aperture::Round).unwrap();
    let path = Path {
        depth: 5,
        ..Path::WHOLE
    };
    let expected = film.render(&camera, &Sampler::Even, &path, &scene);
    for (a, b) in drawn.pixels().iter().zip(expected.pixels()) {
        // Below the horizon the file's backdrop is black, above it a constant: the floor hides all that is below.
        let off = (*a + *b * -1.0).map(f32::abs).max_channel();
        assert!(off < 1e-4, "{a:?}, not {b:?}");
    }
}

#[test]
fn the_gallery_is_of_scenes() {
    let mut scenes = 0;
    for entry in std::fs::read_dir(project("chapters/scenes/gallery")).expect("the gallery") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|e| e == "toml") {
            let shot = load(&path, Some(16)).unwrap_or_else(|error| panic!("{error}"));
            let film = Film::new(shot.picture.width, shot.picture.height, 4);
            let picture = shot.render(&film);
            let mean =
                picture.pixels().iter().copied().sum::<Rgb>() / picture.pixels().len() as f32;
            assert!(
                (0.01..20.0).contains(&mean.luminance()),
                "{}: {mean:?}",
                path.display()
            );
            scenes += 1;
        }
    }
    assert!(scenes >= 7, "{scenes} scenes");
}

/// A scene of the gallery, for a picture of this width.
fn stock(name: &str, width: usize) -> Result<Shot, TextError> {
    let file = project("chapters/scenes/gallery").join(name);
    load(&file.with_extension("toml"), Some(width))
}

#[test]
fn a_stock_scene_is_the_picture_of_its_chapter() {
    let plain = |film: &Film, shot: &Shot| shot.render(film);
    let filtered = |film: &Film, shot: &Shot| film.denoised(&[], |film| shot.render(film));
    let drawn = [
        (
            "marbles",
            "ch15_shadows",
            4,
            plain as fn(&Film, &Shot) -> Image,
        ),
        ("posts", "ch16_soft_shadows", 4, filtered),
        ("horizon", "ch23_adaptive", 6, plain), // which takes at least 6
    ];
    for (name, chapter, samples, draw) in drawn {
        let path = project("golden").join(chapter).join("picture.exr");
        let kept = file::load(&path).unwrap_or_else(|error| panic!("{error}"));
        let shot = stock(name, kept.width()).unwrap_or_else(|error| panic!("{error}"));
        let film = Film {
            seed: shot.picture.seed,
            threads: 2,
            ..Film::new(shot.picture.width, shot.picture.height, samples)
        };
        compare(&kept, &draw(&film, &shot), &Tolerance::RENDERED_AGAIN)
            .unwrap_or_else(|difference| panic!("{chapter}: {difference}"));
    }
}

#[test]
fn a_stock_scene_brings_its_pictures() {
    let shots = [
        stock("teapot", 64),
        gallery::TEAPOT.shot(64), // whose file is not found from here
    ];
    let [of_file, built_in] = shots.map(|shot| {
        let shot = shot.unwrap_or_else(|error| panic!("{error}"));
        shot.render(&Film::new(shot.picture.width, shot.picture.height, 4))
    });
    assert!(of_file.same_bits(&built_in));
    let blue = |pixel: &&Rgb| pixel.b > 1.5 * pixel.r;
    assert!(
        of_file.pixels().iter().filter(blue).count() > 3,
        "the flowers are seen"
    );
}

#[test]
fn the_walls_and_the_lamp_of_cornells_box_are_the_librarys() {
    let file = stock("cornell", 24).unwrap_or_else(|error| panic!("{error}"));
    let (file, library) = (file.scene, cornell::cornell_box());
    let mut rng = pcg::stream(14, 0);
    let near = |v: f32, of: f32| (v - of).abs() <= 1e-6 * of; // the library's millimetres are rounded once more
    for i in 0..2000 {
        // From above the blocks and the balls, upwards; or down onto the floor beside them.
        let mut random = || 0.05 + 0.4 * rng.random::<f32>();
        let (from, toward) = if i % 4 > 0 {
            let toward = random_direction(&mut pcg::stream(15, i));
            let from = vec3(random(), 0.4, random());
            (from, if toward.y < 0.0 { -toward } else { toward })
        } else {
            (vec3(0.1 * random(), 0.3, 0.02), -Dir3::Y)
        };
        let ray = Ray::new(from, toward);
        let [a, b] = [&file, &library].map(|scene| {
            let seen = scene.closest(&ray)?;
            let at = seen.surface;
            Some((seen.t, seen.material.eval(&at, at.normal, at.normal)))
        });
        let same = match (a, b) {
            (Some((a, paint)), Some((b, other))) => near(a, b) && paint == other,
            (a, b) => a == b,
        };
        assert!(same, "{ray:?}: {a:?}, not {b:?}");
        let lamp = |scene: &Scene| scene.lights[0].sample(from, vec2(0.3, 0.6));
        let [a, b] = [&file, &library].map(|scene| lamp(scene).expect("light"));
        assert!(
            near(a.pdf, b.pdf) && near(a.arriving.g, b.arriving.g),
            "{a:?}, not {b:?}"
        );
    }
}

#[test]
fn direct_light_is_the_librarys_local_illumination() {
    let with = |integrator: &str| {
        let text = format!(
            "ambient = 0.1\n{CAMERA}[integrator]\n{integrator}\n\
            [[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 0, 0]\nradius_m = 1\nmaterial = {{ kind = \"phong\", colour = 0.5 }}\n\
            [[shapes]]\nkind = \"sphere\"\ncenter_m = [1.6, 0, 1.07]\nradius_m = 0.4\nmaterial = {{ kind = \"mirror\" }}\n\
            [[lights]]\nkind = \"sphere\"\ncenter_m = [9, 0, 6]\nradius_m = 1\nradiance = 50\n\
            [backdrop]\nhorizon = 0.3\nbelow = 0.3\n"
        );
        let shot = parse(&text).unwrap_or_else(|error| panic!("{error}"));
        (shot.render(&Film::new(32, 24, 4)), shot)
    };
    let [shadows, none] = [
        ("light_samples = 3", 3, Some(shadow::lit as Visibility)),
        ("shadows = false", 1, NO_SHADOWS),
    ]
    .map(|(fields, samples, arrives)| {
        let (drawn, shot) = with(&format!("kind = \"direct\"\n{fields}"));
        let local = Local { samples, arrives };
        let film = Film::new(32, 24, 4);
        let expected = film.render(&*shot.camera, &Sampler::Even, &local, &shot.scene);
        assert!(drawn.same_bits(&expected), "{fields}");
        drawn
    });
    let pairs = shadows.pixels().iter().zip(none.pixels());
    let darker = pairs.filter(|(shadow, lit)| shadow.g < 0.5 * lit.g);
    assert!(darker.count() > 2, "the mirror's shadow");
    let mirror = (0..32).filter(|&x| shadows.at(x, 12) == Rgb::BLACK);
    assert!(mirror.count() > 2, "the mirror is black");
    let (whitted, _) = with("kind = \"whitted\"");
    assert!((0..32).all(|x| whitted.at(x, 12) != Rgb::BLACK));
}

#[test]
fn shapes_are_scaled_then_turned_then_moved() {
    let text = format!(
        "{CAMERA}[[shapes]]\nkind = \"box\"\ncorner_m = [0, 0, 0]\nopposite_m = [1, 1, 1]\n\
        scale = 2\nturn_degrees = [0, 0, 90]\nmove_m = [10, 0, 0]\nmaterial = {{ kind = \"glowing\", radiance = 3 }}\n"
    );
    let shot = parse(&text).unwrap_or_else(|error| panic!("{error}"));
    // Turned about z by 90°, x goes up and y to the left: the box is from (8, 0) to (10, 2).
    let sees = |x: f32, y: f32| {
        shot.scene
            .closest(&Ray::new(vec3(x, y, 9.0), -Dir3::Z))
            .map(|seen| seen.t)
    };
    for (x, y, t) in [
        (8.1, 0.1, Some(7.0)),
        (9.9, 1.9, Some(7.0)),
        (7.9, 1.0, None),
        (10.1, 1.0, None),
        (9.0, 2.1, None),
    ] {
        assert_eq!(sees(x, y).map(f32::round), t, "at {x}, {y}");
    }
}

#[test]
fn photons_are_the_librarys() {
    let shot = |fields: &str| {
        let text = format!(
            "{CAMERA}[integrator]\nkind = \"path\"\n{fields}\n\
            [[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 0, 0]\nradius_m = 0.7\nmaterial = {{ kind = \"glass\" }}\n\
            [[shapes]]\nkind = \"plane\"\npoint_m = [0, -1, 0]\nnormal = [0, 1, 0]\nmaterial = {{ kind = \"matte\", colour = 0.5 }}\n\
            [[lights]]\nkind = \"sphere\"\ncenter_m = [0, 4, 0]\nradius_m = 0.4\nradiance = 20\n"
        );
        parse(&text).unwrap_or_else(|error| panic!("{error}"))
    };
    let film = Film::new(32, 24, 4);
    let shot = shot("depth = 8\nphotons = 50_000\nphoton_radius_m = 0.1\nbrightest_sample = 3");
    let caustics = Caustics {
        path: Path {
            depth: 8,
            ..Path::WHOLE
        },
        photons: Photons::shot(&shot.scene, 50_000, 0.1, 0),
        brightest: 3.0,
    };
    assert!(caustics.photons.all().len() > 100, "{caustics:?}");
    let expected = film.render(&*shot.camera, &Sampler::Even, &caustics, &shot.scene);
    assert!(shot.render(&film).same_bits(&expected));
}

#[test]
fn another_width_keeps_the_shape_of_the_picture() {
    let text = format!("{CAMERA}[picture]\nwidth = 300\nheight = 200\n");
    let path = project("chapters/scenes/gallery").join("test.toml");
    for (width, height) in [(3, 2), (1, 1), (8192, 5461)] {
        let shot = raybook_scenes::parse(&path, &text, Some(width)).expect("a scene");
        assert_eq!((shot.picture.width, shot.picture.height), (width, height));
    }
}

#[test]
fn a_filter_is_the_films_filter() {
    let with = |filter: &str| {
        let text = format!(
            "{CAMERA}[picture]\n{filter}\n[[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 0, 0]\nradius_m = 1\n\
            material = {{ kind = \"glowing\", radiance = 1 }}\n"
        );
        let shot = parse(&text).unwrap_or_else(|error| panic!("{error}"));
        (shot.render(&Film::new(16, 12, 16)), shot)
    };
    let (plain, _) = with("");
    let (boxed, _) = with("filter = \"box\"");
    assert!(plain.same_bits(&boxed), "a box is the default");
    let (drawn, shot) = with("filter = \"mitchell\"");
    let film = Film {
        filter: Filter::MITCHELL,
        ..Film::new(16, 12, 16)
    };
    let expected = film.render(&*shot.camera, &Sampler::Even, &Path::WHOLE, &shot.scene);
    assert!(drawn.same_bits(&expected));
    let brightest = |picture: &Image| picture.pixels().iter().map(|p| p.g).fold(0.0, f32::max);
    assert!(
        brightest(&drawn) > 1.01 && brightest(&plain) < 1.01,
        "it overshoots at the rim"
    );
}

#[test]
fn a_fisheye_leaves_its_corners_black() {
    let text =
        format!("{CAMERA}kind = \"fisheye\"\n[backdrop]\nabove = 1\nhorizon = 1\nbelow = 1\n");
    let shot = parse(&text).unwrap_or_else(|error| panic!("{error}"));
    // The picture is 640 wide and 480 high: the disc is three quarters as wide as it.
    let picture = shot.render(&Film::new(64, 48, 4));
    assert_eq!([picture.at(0, 0), picture.at(4, 24)], [Rgb::BLACK; 2]);
    assert!(picture.at(32, 24).g > 0.99 && picture.at(12, 24).g > 0.99);
}
