//! Errors: the place, what was wrong, what is expected.

use crate::{CAMERA, error, parse};
use raybook::sample::pattern::PATTERNS;
use raybook_scenes::load;
use std::fs;

/// Texts, and their errors.
const TEXTS: &[(&str, &str)] = &[
    ("", "test.toml:1:1: a scene needs `camera`"),
    (
        "[Camera]\n",
        "test.toml:1:2: a scene needs `camera`: is it meant by `Camera`?",
    ),
    (
        "x = ",
        "test.toml:1:5: this is not valid TOML: string values must be quoted, expected literal string",
    ),
    (
        "[camera]\nfrom_m = [0, 0, 5]\n",
        "test.toml:1:1: the camera needs `to_m`",
    ),
    (
        "[camera]\nfrom_m = [0, 0, 5]\nto_m = [0, 0, 5]\n",
        "test.toml:3:8: the camera at [0, 0, 5] looks at [0, 0, 5]: it needs two different, finite points",
    ),
    (
        "[camera]\nfrom_m = [0, 5]\n",
        "test.toml:2:10: `from_m` must be three numbers, [x, y, z], from -1e9 to 1e9, and this is [0.0, 5.0]",
    ),
    (
        "[camera]\nfrom_m = [0, 0, 1e30]\nto_m = [0, 0, 0]\n",
        "test.toml:2:10: `from_m` must be three numbers, [x, y, z], from -1e9 to 1e9, and this is [0.0, 0.0, 1e30]",
    ),
    (
        "[camera]\nfrom_m = [0, nan, 5]\nto_m = [0, 0, 0]\n",
        "test.toml:2:10: `from_m` must be three numbers, [x, y, z], from -1e9 to 1e9, and this is [0.0, NaN, 5.0]",
    ),
    (
        "[camera]\nfrom_m = [0, 0, 5]\nto_m = [0, 0, 0]\nview_heigth_degrees = 40\n",
        "test.toml:4:1: the camera has no field `view_heigth_degrees`; did you mean `view_height_degrees`?",
    ),
    (
        "[camera]\nfrom_m = [0, 0, 5]\nto_m = [0, 0, 0]\nf_number = 2\nlens_diameter_m = 0.1\n",
        "test.toml:4:12: the lens is given twice; keep `lens_diameter_m` or `f_number`",
    ),
    (
        "[camera]\nfrom_m = [0, 0, 5]\nto_m = [0, 0, 0]\nfocus_m = 3\n",
        "test.toml:4:11: only a lens has this; give `lens_diameter_m` or `f_number` too",
    ),
    (
        "camera = 3\n",
        "test.toml:1:10: `camera` must be a table, and this is 3",
    ),
    ("pictures = {}\n", "test.toml:1:1: a scene needs `camera`"),
];

/// The same of what follows a camera; the file's name is left out.
const AFTER_A_CAMERA: &[(&str, &str)] = &[
    (
        "[pictures]\n",
        "4:2: a scene has no field `pictures`; did you mean `picture`?",
    ),
    (
        "[picture]\nwidth = 100000\n",
        "5:9: `width` must be a whole number from 1 to 8192, and this is 100000",
    ),
    (
        "[picture]\nwidth = \"640\"\n",
        "5:9: `width` must be a whole number from 1 to 8192, and this is the text \"640\"",
    ),
    (
        "[picture]\nwidth = 640.5\n",
        "5:9: `width` must be a whole number from 1 to 8192, and this is 640.5",
    ),
    (
        "[picture]\nfilter = \"mitchel\"\n",
        "5:10: `mitchel` is none of `box`, `tent`, `gaussian`, `mitchell`; did you mean `mitchell`?",
    ),
    (
        "kind = \"fisheye\"\nprojection = \"orthographic\"\nview_degrees = 200\n",
        "6:16: this fisheye's view, 200°, must be more than 0° and at most 180°: its projection is Orthographic",
    ),
    (
        "[integrator]\nkind = \"paths\"\n",
        "5:8: `paths` is none of `path`, `whitted`, `direct`; did you mean `path`?",
    ),
    (
        "[integrator]\ndepth = 3\n",
        "4:1: the integrator needs `kind`",
    ),
    (
        "[integrator]\nkind = \"path\"\nphotons = 1000\n",
        "6:11: photons light what is near them; give `photon_radius_m` too",
    ),
    (
        "[integrator]\nkind = \"path\"\nphotons = 0\n",
        "6:11: `photons` must be a whole number from 1 to 10000000, and this is 0",
    ),
    (
        "[integrator]\nkind = \"path\"\nphoton_radius_m = 0.1\n",
        "6:19: only photons have this; give `photons` too",
    ),
    (
        "[sampler]\nkind = \"haltn\"\n",
        "5:8: `haltn` is none of `even`, `refined`, `adaptive`, `budget`, (patterns); did you mean `halton`?",
    ),
    (
        "[shapes]\n",
        "4:1: a shape begins with [[shapes]]: `shapes` must be a list of tables",
    ),
    (
        "[[shapes]]\nkind = \"sphere\"\n",
        "4:1: a shape of the kind `sphere` needs `center_m`",
    ),
    (
        "[[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 0, 0]\nradius_mm = 1000\n",
        "7:1: a shape of the kind `sphere` needs `radius_m`: is it meant by `radius_mm`?",
    ),
    (
        "[[shapes]]\nkind = \"sphere\"\ncenter_m = [0, 0, 0]\nradius_m = 0\nmaterial = { kind = \"matte\", colour = 1 }\n",
        "7:12: `radius_m` must be a number from 0.000000001 to 1000000000, and this is 0",
    ),
    (
        "[materials]\ngold = { kind = \"metal\", metal = \"gold\" }\n[[shapes]]\nkind = \"sphere\"\nmaterial = \"gild\"\n",
        "8:12: there is no material `gild`; did you mean `gold`?",
    ),
    (
        "[[shapes]]\nkind = \"teapot\"\nmaterial = \"gold\"\n",
        "6:12: there is no material `gold`: none is described; write [materials.NAME]",
    ),
    (
        "[materials]\nred = { kind = \"matte\", colour = [2, 0, 0] }\n",
        "5:34: `colour` must be a number from 0 to 1, or three, [red, green, blue], and this is [2.0, 0.0, 0.0]",
    ),
    (
        "[materials]\nsatin = { kind = \"blinn-phong\", colour = 0.5, specular = 1.5 }\n",
        "5:58: `specular` must be a number from 0 to 1, and this is 1.5",
    ),
    (
        "[materials]\nred = { kind = \"matte\", colour = { squares = [1, 0, 1] } }\n",
        "5:46: `squares` must be two colours, [[red, green, blue], [red, green, blue]], from 0 to 1",
    ),
    (
        "[[shapes]]\nkind = \"mesh\"\nfile = \"none.obj\"\n",
        "6:8: none.obj: cannot read this file: No such file or directory (os error 2)",
    ),
    (
        "[[shapes]]\nkind = \"mesh\"\nfile = \"china.png\"\n",
        "6:8: china.png: a mesh's name must end in .obj, .stl or .ply",
    ),
    (
        "[environment]\nfile = \"test.txt\"\n",
        "5:8: test.txt: a picture's name must end in .exr, .hdr or .png",
    ),
    (
        "[[lights]]\nkind = \"rectangle\"\ncorner_m = [0, 0, 0]\na_m = [1, 0, 0]\nb_m = [1, 1, 0]\nradiance = 1\n",
        "8:7: the edges `a_m` and `b_m` of a rectangle must be at right angles",
    ),
    (
        "[[shapes]]\nkind = \"polygon\"\ncorners_m = [[0, 0, 0], [1, 0, 0]]\nmaterial = { kind = \"matte\", colour = 1 }\n",
        "6:13: a polygon has at least three corners",
    ),
    (
        "[[shapes]]\nkind = \"polygon\"\ncorners_m = [0, 0, 0]\nmaterial = { kind = \"matte\", colour = 1 }\n",
        "6:13: `corners_m` must be a list of places, [[x, y, z], …], from -1e9 to 1e9, and this is [0.0, 0.0, 0.0]",
    ),
    (
        "[materials]\nfloor = { kind = \"phong\", colour = 0.5, polish = 2 }\n",
        "5:50: `polish` must be a number from 0 to 1, or three, [red, green, blue], and this is 2",
    ),
    (
        "[backdrop]\nhorizon = 1\nexponent = 0\n",
        "6:12: `exponent` must be a number from 0.01 to 100, and this is 0",
    ),
    (
        "[[lights]]\nkind = \"point\"\nposition_m = [0, 1, 0]\nintensity = -1\n",
        "7:13: `intensity` must be a number from 0 to 1e12, or three, [red, green, blue], and this is -1",
    ),
    (
        "[[lights]]\nkind = \"directional\"\ntoward = [0, 0, 0]\nirradiance = 1\n",
        "6:10: `toward` must be three numbers, [x, y, z], that are not all 0, and this is [0.0, 0.0, 0.0]",
    ),
];

#[test]
fn every_error_says_where_what_and_what_to_do() {
    let mut wrong = Vec::new();
    for (text, expected) in TEXTS {
        let got = error(text);
        if got != *expected {
            wrong.push(format!("got {got}\nnot {expected}"));
        }
    }
    let patterns: Vec<_> = PATTERNS
        .iter()
        .map(|one| format!("`{}`", one.name))
        .collect();
    for (text, expected) in AFTER_A_CAMERA {
        let expected = expected.replace("(patterns)", &patterns.join(", "));
        let got = error(&format!("{CAMERA}{text}"));
        if got != format!("test.toml:{expected}") {
            wrong.push(format!("got {got}\nnot test.toml:{expected}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn an_unknown_word_shows_nothing_that_a_terminal_would_obey() {
    let got = error(&format!("{CAMERA}\"\\u001b[2J\\u202e\" = 1\n"));
    assert!(got.contains("`\\u{1b}[2J\\u{202e}`"), "{got}");
    assert!(
        got.starts_with("test.toml:4:1: the camera has no field"),
        "{got}"
    );
}

#[test]
fn a_file_that_is_none_is_refused_at_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let error = |path: &std::path::Path| load(path, None).expect_err("no scene").to_string();
    assert!(error(folder.path()).ends_with("it is a folder"));
    assert!(error(&folder.path().join("none.toml")).contains("No such file"));
    let binary = folder.path().join("binary.toml");
    fs::write(&binary, [0xff, 0xfe, 0]).expect("written");
    assert!(
        error(&binary).contains("cannot read this file: invalid utf-8"),
        "{}",
        error(&binary)
    );
    let long = folder.path().join("long.toml");
    fs::write(&long, "#".repeat(raybook_scenes::LONGEST + 1)).expect("written");
    assert!(error(&long).contains("keep meshes in files of their own"));
    #[cfg(unix)]
    {
        let pipe = folder.path().join("pipe.toml");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.expect("mkfifo runs").success());
        assert!(error(&pipe).ends_with("it is a named pipe (FIFO)"));
        // A mesh that is one is found as soon.
        let mesh = folder.path().join("pipe.obj");
        fs::rename(&pipe, &mesh).expect("renamed");
        let scene = folder.path().join("scene.toml");
        fs::write(
            &scene,
            format!("{CAMERA}[[shapes]]\nkind = \"mesh\"\nfile = \"pipe.obj\"\n"),
        )
        .expect("written");
        assert!(
            error(&scene).contains("scene.toml:6:8: "),
            "{}",
            error(&scene)
        );
        assert!(error(&scene).ends_with("it is a named pipe (FIFO)"));
    }
}

#[test]
fn tables_in_tables_without_end_are_refused() {
    let deep = format!("x = {}1{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(
        error(&deep).contains("this is not valid TOML"),
        "{}",
        error(&deep)
    );
    assert!(parse(CAMERA).is_ok(), "the smallest scene is one");
}
