//! # Grid
//!
//! Space cut into equal cells, each with a list of the triangles in it: a ray asks only the triangles in the cells that it
//! passes through, one cell after the other, and stops at the first hit.
//!
//! New: accel/bounded.rs accel/ray_box.rs accel/lattice.rs accel/margin.rs accel/overlap.rs accel/walk.rs
//! New: accel/grid/mod.rs accel/grid/build.rs accel/grid/mailbox.rs accel/grid/resolution.rs accel/grid/validate.rs
//! New: scene/soup.rs scene/stadium.rs scene/teapots.rs scene/terrain.rs

use glam::{Vec3, vec2, vec3};
use raybook::accel::{Accel, grid::Grid};
use raybook::camera::pinhole::Pinhole;
use raybook::image::{Image, rgb::Rgb};
use raybook::lab::stage::{Drawn, Stage};
use raybook::lab::{
    chapter, daylight::daylight, grid_costs, heat, outdoors, palette, showroom, walk_figure,
};
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::scene::{
    stadium::{Part, stadium},
    teapots::teapots,
};
use raybook::shape::mesh::{Facet, Mesh};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let film = stage.film_of(640, 4, 1.6);
    let crowd = teapots(400, 4);
    let grid = Grid::of_facets(crowd.mesh.facets());
    let camera = Pinhole::look_at(
        vec3(6.0, 15.0, 42.0),
        vec3(0.0, 0.0, 17.0),
        Vec3::Y,
        0.035,
        film.aspect(),
    )?;
    let glaze = |id| {
        crowd
            .teapot(id)
            .map(|out| palette::viridis(0.95 - 0.9 * out))
    };
    let main = picture(&film, &camera, &crowd.mesh, &grid, |id| {
        (glaze(id).unwrap_or(Rgb::gray(0.6)), true)
    });
    let caption = format!(
        "{} triangles in a grid of {} cells. A ray asks a few of them; a list would ask all.",
        crowd.mesh.triangles().len(),
        grid.lattice().resolution
    );
    stage.picture("picture", &caption, &main)?;
    let caption = "The cells through which a ray passes, in their order, to the first hit. Of the six triangles it tests the three whose cells it visits; cells that hold others are blue.";
    stage.figure("walk", caption, &walk_figure::diagram()?)?;
    let heat = heat::heat(
        &showroom::small(&film),
        |place| camera.ray_through(place),
        &grid,
    );
    let caption = "What each ray of the picture costs. Most cells on its way are empty; a ray that grazes the crowd visits the most.";
    stage.figure("heat", caption, &heat.figure("cells visited")?)?;

    let rays: Vec<_> = (0..4000)
        .map(|i| camera.ray_through(vec2(i as f32 * 0.618_034 % 1.0, i as f32 / 4000.0)))
        .collect();
    let costs = grid_costs::measure(&crowd.mesh, &rays);
    let rate = grid_costs::best(&costs).map_or(0.0, |best| 1e3 / best.time);
    let caption = format!(
        "The same rays in grids of more and more cells: fewer triangles are tested, more cells visited. The best of these grids answers {rate:.1} million rays per second and thread, here and now."
    );
    stage.figure("resolution", &caption, &grid_costs::plot(&costs)?)?;
    draw_stadium(stage, &showroom::small(&film))
}

/// The teapot in the stadium, and what it costs.
fn draw_stadium(stage: &Stage, film: &Film) -> Drawn {
    let scene = stadium(4);
    let grid = Grid::of_facets(scene.mesh.facets());
    let camera = |from, to| Pinhole::look_at(from, to, Vec3::Y, 0.035, film.aspect());
    let colour = |id| match scene.part(id) {
        Part::Teapot => (Rgb::new(0.80, 0.25, 0.06), true),
        Part::Ground => (Rgb::new(0.22, 0.42, 0.12), false),
        Part::Steps => (Rgb::gray(0.55), false),
        Part::Seats => (Rgb::new(0.10, 0.28, 0.62), false),
        Part::Roof => (Rgb::gray(0.85), false),
    };
    let (far, near) = (
        camera(vec3(-38.0, 13.0, 34.0), vec3(3.0, 0.5, -3.0))?,
        camera(vec3(0.35, 0.42, 0.95), vec3(0.05, 0.15, 0.0))?,
    );
    let heat = heat::heat(film, |place| near.ray_through(place), &grid);
    let maps = [
        (
            "the stadium".to_owned(),
            picture(film, &far, &scene.mesh, &grid, colour),
        ),
        (
            "the teapot on its centre spot".to_owned(),
            picture(film, &near, &scene.mesh, &grid, colour),
        ),
        heat.of_boxes("cells visited"),
        heat.of_triangles(),
    ];
    let cell = grid.lattice().cell;
    let caption = format!(
        "The teapot in the stadium. A cell is {:.1} m wide: the teapot and the camera are in one of them, and every ray of the second view tests the whole teapot, even one that goes to the seats.",
        cell.x
    );
    stage.figure("stadium", &caption, &heat::with_scale(2, &maps)?)
}

/// A picture by daylight; `colour` says a triangle's colour, and whether it looks round.
fn picture(
    film: &Film,
    camera: &Pinhole,
    mesh: &Mesh,
    grid: &Grid<Facet>,
    colour: impl Fn(u32) -> (Rgb, bool) + Sync,
) -> Image {
    film.render(|place, _| {
        let ray = camera.ray_through(place);
        let Some((_, hit)) = grid.closest(&ray, Interval::AHEAD) else {
            return outdoors::sky(ray.direction);
        };
        let at = mesh.surface(&ray, &hit);
        let (colour, round) = colour(hit.id);
        let normal = if round { at.shading_normal } else { at.normal };
        daylight(colour, &at, normal, &ray, |shadow| {
            grid.any(shadow, Interval::AHEAD)
        })
    })
}

fn main() -> ExitCode {
    chapter::run("ch08_grid", draw)
}
