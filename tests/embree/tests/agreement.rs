//! raybook and Embree give the same answers.
//!
//! Run with `cargo test --release -p raybook-embree -- --nocapture` to see the tables. Each shape gets a million rays, a fifth
//! of each kind, and each ray is asked twice of Embree: in its fast and in its robust mode. What counts as the same, and
//! where answers may differ, is said in `tests/common/oracle/meeting.rs`.

use raybook::math::pcg;
use raybook_common::oracle::target::Target;
use raybook_common::{STALE, measured};
use raybook_embree::campaign::Campaign;
use raybook_embree::shapes;
use raybook_embree::tally::COLUMNS;
use std::sync::LazyLock;

/// Rays at each kind of shape.
const RAYS: u64 = 1_000_000;

/// Rays at one small scene; there are [`RAYS`] / [`EACH`] of them.
const EACH: usize = 500;

/// How many answers may differ at edges, silhouettes and ends of intervals: 0.02 %. (Measured: at most 0.009 %.)
const MAY_DIFFER: f64 = 2e-4;

/// Numbers of triangles of a mesh, about, and of rays at such meshes: 4·10⁸ tests of triangles in all, for raybook searches linearly.
const MESHES: [(u32, usize); 6] = [
    (1, 405_000),
    (10, 300_000),
    (100, 200_000),
    (1000, 80_000),
    (10_000, 13_000),
    (100_000, 2_000),
];

fn scenes() -> std::ops::Range<usize> {
    0..RAYS as usize / EACH
}

/// A campaign runs once, for its own test and for the book's table.
type Once = LazyLock<Campaign>;

static TRIANGLES: Once = Once::new(|| {
    let mut rng = pcg::stream(1, 1);
    let targets = scenes().map(|i| (shapes::triangle(i, &mut rng).expect("finite"), EACH));
    Campaign::run("triangles", targets).expect("Embree works")
});

static SPHERES: Once = Once::new(|| {
    let mut rng = pcg::stream(1, 2);
    let targets = scenes().map(|i| (shapes::sphere(i, &mut rng), EACH));
    Campaign::run("spheres", targets).expect("Embree works")
});

static PLANES: Once = Once::new(|| {
    let mut rng = pcg::stream(1, 3);
    let targets = scenes().map(|_| (shapes::plane(&mut rng).expect("finite"), EACH));
    Campaign::run("planes", targets).expect("Embree works")
});

static BOXES: Once = Once::new(|| {
    let mut rng = pcg::stream(1, 4);
    let targets = scenes().map(|i| (shapes::cuboid(i, &mut rng).expect("finite"), EACH));
    Campaign::run("boxes", targets).expect("Embree works")
});

static ALL_MESHES: Once = Once::new(|| {
    let kinds = ["soup", "ball", "terrain", "crate"];
    let sizes = MESHES.map(|(triangles, rays)| {
        let targets = kinds.map(|kind| mesh(kind, triangles, rays / kinds.len()));
        let campaign = Campaign::run(&format!("meshes of {triangles}"), targets);
        campaign.expect("Embree works")
    });
    for size in &sizes {
        println!("{size}");
    }
    Campaign::sum("meshes of all sizes", &sizes)
});

static SLIVERS: Once = Once::new(|| {
    let targets = [10, 100, 1000].map(|triangles| mesh("slivers", triangles, 50_000));
    Campaign::run("slivers", targets).expect("Embree works")
});

#[test]
fn triangles_agree() {
    TRIANGLES.check(RAYS, MAY_DIFFER);
}

#[test]
fn spheres_agree() {
    SPHERES.check(RAYS, MAY_DIFFER);
}

#[test]
fn planes_agree() {
    PLANES.check(RAYS, MAY_DIFFER);
}

#[test]
fn boxes_agree() {
    BOXES.check(RAYS, MAY_DIFFER);
}

#[test]
fn meshes_agree() {
    ALL_MESHES.check(RAYS, MAY_DIFFER);
}

/// Triangles that are up to 1000 times as long as wide. Rounding moves their edges by much of their width,
/// so more of the answers may differ: 0.5 %. (Measured: 0.2 %.)
#[test]
fn slivers_agree() {
    SLIVERS.check(150_000, 5e-3);
}

#[test]
fn the_table_of_the_book_is_of_these_comparisons() {
    let campaigns = [&TRIANGLES, &SPHERES, &PLANES, &BOXES, &ALL_MESHES, &SLIVERS];
    let rows = campaigns.map(|campaign| campaign.table()).concat();
    let today = format!("{COLUMNS}{rows}");
    let kept = measured("embree", &today);
    assert_eq!(sure(&kept), sure(&today), "{STALE}");
}

/// The columns that are the same on every processor: the last digits of Embree, and with them a few hits at edges, are its maker's.
fn sure(table: &str) -> Vec<[&str; 4]> {
    let cells = |line| str::split(line, '|').map(str::trim);
    let sure = |line| [1, 2, 3, 7].map(|column| cells(line).nth(column).unwrap_or_default());
    table.lines().map(sure).collect()
}

fn mesh(kind: &str, triangles: u32, rays: usize) -> (Target, usize) {
    let target = Target::mesh(kind, triangles).expect("one of the kinds of meshes");
    (target, rays)
}
