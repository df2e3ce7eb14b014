//! OBJ files with their MTL files and pictures.

use raybook::image::{Image, file, rgb::Rgb};
use raybook::material::mtl;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::scene::model;
use raybook::scene::world::Scene;
use raybook::shape::{Shape, obj};
use std::fs;
use std::path::Path;

const OBJ: &str = "mtllib paints.mtl
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1
usemtl wood
f 1/1 2/2 3/3 4/4
usemtl red paint
f 2 5 6 3
usemtl wood
f 5/1 7/2 8/3 6/4
";

const MTL: &str = "# two materials
newmtl wood
Kd 1 1 1
map_Kd -s 1 1 1 sub\\wood.png
norm bumps.png
newmtl red paint
Kd 0.8 0.1 0.1
Ks 0 0 0
illum 1
";

fn folder(obj: &str, mtl: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write =
        |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
    write("model.obj", obj);
    write("paints.mtl", mtl);
    let brown = Image::from_fn(2, 2, |_, _| Rgb::new(0.5, 0.25, 0.0));
    file::save(&folder.path().join("sub/wood.png"), &brown).expect("saved");
    // The codes 0.8, 0.5 and 0.9 mean 0.6, 0 and 0.8.
    let code = |v: f32| raybook::image::tone::decode_srgb(v);
    let bumps = Image::from_fn(1, 1, |_, _| Rgb::new(code(0.8), code(0.5), code(0.9)));
    file::save(&folder.path().join("bumps.png"), &bumps).expect("saved");
    folder
}

fn seen(scene: &Scene, x: f32) -> (Rgb, Dir3) {
    let seen = scene
        .closest(&Ray::new(glam::vec3(x, 0.5, 1.0), -Dir3::Z))
        .expect("a face");
    let f = seen
        .material
        .eval(&seen.surface, Dir3::Z, seen.surface.shading_normal);
    (f * std::f32::consts::PI, seen.surface.shading_normal)
}

#[test]
fn each_face_has_the_colour_the_picture_and_the_bumps_of_its_material() {
    let folder = folder(OBJ, MTL);
    let things = model::load(&folder.path().join("model.obj"))
        .expect("a model")
        .things;
    assert_eq!(things.len(), 2, "a thing for each material");
    let scene = Scene::new(things, vec![]);
    for (x, colour, lean) in [
        (0.5, [0.5, 0.25, 0.0], 0.6),
        (1.5, [0.8, 0.1, 0.1], 0.0),
        (2.5, [0.5, 0.25, 0.0], 0.6),
    ] {
        let (got, normal) = seen(&scene, x);
        for (got, expected) in got.channels().into_iter().zip(colour) {
            // A PNG has 255 steps.
            assert!(
                (got - expected).abs() < 0.004,
                "at {x}: {got}, not {expected}"
            );
        }
        // The bumps' vector is (0.6, 0, 0.8) in all.
        assert!((normal.x - lean).abs() < 0.01, "at {x}: {normal:?}");
    }
}

#[test]
fn parts_together_are_the_whole_mesh() {
    let (whole, parts) = (obj::parse(OBJ).unwrap(), obj::parse_parts(OBJ).unwrap());
    let sizes: Vec<_> = parts
        .parts
        .iter()
        .map(|part| part.mesh.triangles().len())
        .collect();
    assert_eq!(sizes, [4, 2], "two squares of wood, and one of paint");
    assert_eq!(whole.triangles().len(), 6);
    assert_eq!(parts.libraries, ["paints.mtl"]);
    let ray = Ray::new(glam::vec3(1.2, 0.3, 1.0), -Dir3::Z);
    let facets = parts.parts[1].mesh.facets();
    assert!(
        facets
            .iter()
            .any(|facet| facet.hit(&ray, Interval::AHEAD).is_some())
    );
}

#[test]
fn what_is_wrong_is_said_with_file_line_and_column() {
    for (obj, mtl, message) in [
        (
            OBJ,
            "newmtl wood\nKd 1 x 1\n",
            "paints.mtl:2:6: expected a number, found `x`",
        ),
        (
            OBJ,
            "Kd 1 1 1\n",
            "paints.mtl:1:1: expected newmtl and a name, before the first property, found `Kd`",
        ),
        (
            OBJ,
            "newmtl wood\nNs\n",
            "paints.mtl:2:1: an exponent (Ns) needs 1 number, and here are 0",
        ),
        (
            OBJ,
            "newmtl wood\nKd 1 1\n",
            "paints.mtl:2:1: a colour (Kd) needs 1 number, or 3 for red, green and blue, and here are 2",
        ),
        (
            OBJ,
            "newmtl wood\nmap_Kd\n",
            "paints.mtl:2:1: a picture (map_Kd) needs the name of a file, and here are 0",
        ),
        (
            OBJ,
            "newmtl Wood\nnewmtl red paint\n",
            "model.obj: its faces use the material `wood`, which its files of materials (mtllib) do not describe; they describe Wood, red paint",
        ),
        (
            OBJ,
            "newmtl wood\nmap_Kd none.png\nnewmtl red paint\n",
            "none.png: cannot read this file: No such file or directory (os error 2)",
        ),
        (
            "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
            "",
            "none.mtl: cannot read this file: No such file or directory (os error 2)",
        ),
        (
            "mtllib paints.mtl\n",
            MTL,
            "model.obj: there is no face in this file; is it a mesh?",
        ),
    ] {
        let folder = folder(obj, mtl);
        let error = model::load(&folder.path().join("model.obj"))
            .expect_err(message)
            .to_string();
        let name = folder.path().display().to_string();
        assert_eq!(error.replace(&(name + "/"), ""), message);
    }
}

#[test]
fn shares_are_cut_off_at_what_nature_allows_and_unknown_words_passed_over() {
    let all = mtl::parse("newmtl a\nKd 2 -1 0.5\nillum 2\nPr 0.3\nTr 0.25\nNi 77\nKe 3\n").unwrap();
    assert_eq!(all[0].diffuse, Rgb::new(1.0, 0.0, 0.5));
    assert_eq!((all[0].opacity, all[0].index), (0.75, 4.0));
    assert_eq!(all[0].emitted, Rgb::gray(3.0));
    assert!(mtl::parse("").unwrap().is_empty());
}

#[test]
fn a_picture_of_the_highlight_is_used_beside_that_of_the_colour() {
    let with = |mtl: &str| {
        let folder = folder(OBJ, mtl);
        let model = model::load(&folder.path().join("model.obj")).expect("a model");
        let scene = Scene::new(model.things, vec![]);
        let ray = Ray::new(glam::vec3(0.5, 0.5, 1.0), -Dir3::Z);
        let at = scene.closest(&ray).expect("wood");
        let f = at.material.eval(&at.surface, Dir3::Z, Dir3::Z);
        let mut share = Rgb::BLACK;
        at.material
            .delta_lobes(&at.surface, Dir3::Z, &mut |lobe| share += lobe.share);
        (f * std::f32::consts::PI, share)
    };
    // The picture is (0.5, 0.25, 0). A highlight of exponent 0 reflects 1/2 of its irradiance per π, in all directions.
    let text = |ks: &str| {
        format!("newmtl wood\nKd 0.8\n{ks}\nmap_Ks sub/wood.png\nNs 0\nillum 2\nnewmtl red paint\n")
    };
    let near = |got: Rgb, expected: [f32; 3]| {
        let off = got.channels().into_iter().zip(expected);
        off.fold(0.0_f32, |most, (a, b)| most.max((a - b).abs())) < 0.01
    };
    let (matte, _) = with(&text("Ks 0"));
    assert!(near(matte, [0.8; 3]), "without a highlight: {matte:?}");
    let (plain, _) = with(&text("Ks 0.4").replace("map_Ks", "# map_Ks"));
    let (mapped, _) = with(&text("Ks 0.4"));
    let (both, _) = with(&text("Ks 0.4\nmap_Kd sub/wood.png"));
    // The matte part is the share that the strongest channel of the highlight leaves.
    let lobe = (plain.g - 0.8 * 0.6) / 0.4;
    assert!(lobe > 0.3, "{plain:?}");
    let left = 0.8 * (1.0 - 0.2);
    let expected = [0.2, 0.1, 0.0].map(|ks| left + ks * lobe);
    assert!(near(mapped, expected), "{mapped:?}, not {expected:?}");
    let expected = [0.2, 0.1, 0.0].map(|ks| 2.5 * ks * left + ks * lobe);
    assert!(near(both, expected), "{both:?}, not {expected:?}");
    let (_, mirror) = with(&text("Ks 0.4").replace("illum 2", "illum 3"));
    assert!(near(mirror, [0.2, 0.1, 0.0]), "{mirror:?}");
}

#[test]
fn what_a_file_describes_and_the_library_does_not_have_is_remarked() {
    let bumps =
        "newmtl wood\nKa 1\nmap_Bump -bm 2 none.png\nPr 0.3\nnewmtl red paint\nmap_Bump none.png\n";
    let rough = "newmtl wood\nPr 0.3\nnewmtl red paint\n";
    for (mtl, remarks) in [
        (MTL, &[][..]),
        (rough, &["paints.mtl: not used: `Pr`"]),
        (
            bumps,
            &[
                "paints.mtl: not used: `Pr`, `map_Bump`; bumps must be a normal map, which `norm` names",
            ],
        ),
    ] {
        let folder = folder(OBJ, mtl);
        let model = model::load(&folder.path().join("model.obj")).expect("a model");
        let name = folder.path().display().to_string();
        let got: Vec<_> = model
            .remarks
            .iter()
            .map(|one| one.replace(&(name.clone() + "/"), ""))
            .collect();
        assert_eq!(got, remarks);
    }
}

#[test]
fn a_model_without_materials_is_there_all_the_same() {
    let folder = folder("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl what\nf 1 2 3\n", "");
    let model = model::load(Path::new(&folder.path().join("model.obj"))).expect("a model");
    assert_eq!(model.things.len(), 1);
}
