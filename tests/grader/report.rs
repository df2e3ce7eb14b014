//! `raybook report`: one page that needs no other file, in which nothing from outside is more than text.

use crate::common::command::raybook;
use crate::explain::command::program;
use raybook_common::project;
use std::fs;

#[test]
fn the_report_of_a_workbook_is_one_page() {
    let Some((_home, folder)) = program() else {
        return;
    };
    // The search of chapter 11 uses the box and the triangle.
    for file in [
        "ch05_box.py",
        "ch06_triangle.py",
        "ch08_grid.py",
        "ch10_octree.py",
        "ch11_bvh.py",
    ] {
        let solution = project("tests/solutions/python").join(file);
        fs::copy(solution, folder.join(file)).expect("it can be copied");
    }
    let file = folder.join("ch03_sphere.py");
    let text = fs::read_to_string(&file).expect("it is there");
    let shouted = "    root = b * b\n    print('<script>alert(1)</script>')\n    root = root";
    fs::write(&file, text.replace("    root = b * b", shouted)).expect("it can be written");

    let (code, said) = raybook(
        &folder,
        &[
            "report",
            "sphere_hit",
            "reflect",
            "grid_walk",
            "octree_walk",
            "ch11",
            "triangle_hit",
        ],
    );
    assert_eq!(code, 1, "{said}");
    let page = fs::read_to_string(folder.join("out/report.html")).expect("it is written");
    for part in [
        "7 of 9 exercises are right",
        "takes the far root",
        "data:image/png;base64,",
        "data:image/svg+xml;base64,",
        "your steps per ray grow like N^0.",
        "A step is a cell or a triangle.",
        "A step is a leaf or a triangle.",
        "A step is a box or a triangle.",
        "pixels are wrong",
        "&lt;script&gt;alert(1)",
        "<main>",
        "id=\"sphere_hit-0-difference\"",
        "3 Sphere: 0 of ",
        "prefers-color-scheme: dark",
    ] {
        assert!(page.contains(part), "`{part}` is in {page:.2000}");
    }
    assert!(
        page.contains("id=\"triangle_hit-0\"") && !page.contains("triangle_hit-0-difference"),
        "no empty picture where there is no difference"
    );
    assert!(!page.contains("<script"), "nothing runs in the page");
    for (attribute, address) in addresses(&page) {
        assert!(
            address.starts_with("data:") || address.starts_with('#'),
            "{attribute}={address:.80} is fetched from elsewhere"
        );
    }
    assert_eq!(
        page.matches("<img ").count(),
        page.matches(" alt=\"").count(),
        "every picture says what it shows"
    );
}

/// What the page's elements refer to.
fn addresses(page: &str) -> Vec<(&str, &str)> {
    let of = |attribute: &'static str| {
        let pieces = page.split(attribute).skip(1);
        pieces.map(move |rest| (attribute, rest.split('"').next().unwrap_or_default()))
    };
    of(" src=\"").chain(of(" href=\"")).collect()
}
