//! Chapter 22: points in a pixel, and the average of what is seen at them.

use super::Explained;
use super::ch12_phong::{colour, parts};
use super::diagram::{Diagram, Ink};
use super::square;
use super::way::Way;
use glam::{DVec2, DVec3, Vec2, dvec2};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::inside::Space;
use raybook::math::pcg;
use raybook::sample::pattern::poisson_disk::poisson_disk;
use raybook_workbook::exercises::ch22_antialiasing::{
    Jittered, PixelAverage, PoissonDisk, RandomPattern, RegularGrid, RotatedGrid,
};

/// The cells of a lattice by column and row, row by row.
fn lattice(way: &mut Way, columns: u32, rows: u32) -> impl Iterator<Item = DVec2> + use<> {
    let columns = way.rounds("the columns", columns as usize);
    let rows = way.rounds("the rows", rows as usize);
    let in_row = move |j| columns.clone().map(move |i| dvec2(i as f64, j as f64));
    rows.flat_map(in_row)
}

impl Explained for RegularGrid {
    fn work(&self, way: &mut Way) -> Vec<Vec2> {
        let corner = dvec2(self.x.into(), self.y.into());
        let count = way.part(
            "(columns, rows)",
            dvec2(self.columns.into(), self.rows.into()),
        );
        way.number(
            "columns · rows: the number of points",
            "",
            count.x * count.y,
        );
        let sides = way.pair(
            "the sides of a cell, (1/columns, 1/rows)",
            "px",
            count.recip(),
        );
        let corner = way.part("the pixel's column and row", corner);
        way.remark("The first point, of column i = 0 and row j = 0; the others go the same way:");
        let cells = lattice(way, self.columns, self.rows);
        way.of_first(cells, |way, cell| {
            let cell = way.part("(i, j)", cell);
            let half = way.part("½ of a cell", 0.5_f64);
            let middle = way.part("(i + ½, j + ½)", cell + half);
            let p = way.pair("((i + ½)/columns, (j + ½)/rows)", "px", middle * sides);
            way.pair(
                "that, moved by the pixel's column and row",
                "px",
                corner + p,
            )
            .as_vec2()
        })
    }

    fn draw(&self, right: &Vec<Vec2>, yours: Option<&Vec<Vec2>>) -> Option<Diagram> {
        let mut drawing = Diagram::new("The pixel with its cells, and the points, y downwards");
        let corner = dvec2(self.x.into(), self.y.into());
        square::cells(&mut drawing, corner, [self.columns, self.rows]);
        square::points(&mut drawing, corner, right, yours);
        Some(drawing)
    }
}

impl Explained for RotatedGrid {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec<Vec2>] =
        &[Self::work, |asked, way| rotated(asked, way, -1.0)];

    fn work(&self, way: &mut Way) -> Vec<Vec2> {
        rotated(self, way, 1.0)
    }

    fn draw(&self, right: &Vec<Vec2>, yours: Option<&Vec<Vec2>>) -> Option<Diagram> {
        Some(in_square(
            "The rotated grid, y downwards; turned the other way it is right too",
            [1, 1],
            right,
            yours,
        ))
    }
}

/// The rotated grid, whose sine has this sign: turned either way it is right.
fn rotated(asked: &RotatedGrid, way: &mut Way, sense: f64) -> Vec<Vec2> {
    let (spacing, offset) = (f64::from(asked.spacing), asked.offset.as_dvec2());
    let spacing = way.part("spacing", spacing);
    let offset = way.part("offset", offset);
    let turn = way.pair(
        "(cos, sin) of arctan ½: (2, 1)/√5",
        "",
        dvec2(2.0, sense) / 5.0_f64.sqrt(),
    );
    let [cos, sin] = turn.to_array();
    let sin_in_x = way.part("sin in x = cos · a − sin · b", sin);
    let sin_in_y = way.part("sin in y = sin · a + cos · b", sin);
    let middle = way.part("the middle of the pixel", dvec2(0.5, 0.5));
    let nearest = way.pair("(offset.x, offset.y), of i = j = 0", "", offset);
    let turned = |q: DVec2| dvec2(cos * q.x - sin_in_x * q.y, sin_in_y * q.x + cos * q.y);
    way.pair("that, rotated", "", turned(nearest));
    way.pair(
        "(½, ½) + spacing times that",
        "",
        middle + spacing * turned(nearest),
    );
    // The square's diagonal, in spacings: wherever its middle is taken to be, no lattice point beyond that is in it.
    let reach = way.number(
        "lattice steps to try on each side",
        "",
        (2.0_f64.sqrt() / spacing).ceil() + 1.0,
    ) as i32;
    let steps =
        (-reach..=reach).flat_map(|j| (-reach..=reach).map(move |i| dvec2(i.into(), j.into())));
    let inside = |p: &DVec2| p.cmpge(DVec2::ZERO).all() && p.cmplt(DVec2::ONE).all();
    let points = steps.map(|step| {
        way.goes_on();
        middle + spacing * turned(step + offset)
    });
    let points: Vec<_> = points.filter(inside).map(DVec2::as_vec2).collect();
    way.number("of all of them in the square", "", points.len() as f64);
    points
}

/// Points in the unit square, which is cut into columns and rows.
fn in_square(title: &str, cells: [u32; 2], right: &[Vec2], yours: Option<&Vec<Vec2>>) -> Diagram {
    let mut drawing = Diagram::new(title);
    square::cells(&mut drawing, DVec2::ZERO, cells);
    square::points(&mut drawing, DVec2::ZERO, right, yours);
    drawing
}

impl Explained for RandomPattern {
    fn work(&self, way: &mut Way) -> Vec<Vec2> {
        let rng = &mut pcg::stream(22, self.seed.into());
        way.number("n: the number of points", "", self.n.into());
        way.remark(
            "Two new random numbers for each point. The first point; the others go the same way:",
        );
        way.of_first(0..self.n, |way, _| {
            let p = dvec2(rng.random(), rng.random());
            way.pair("(ξ₁, ξ₂)", "", p).as_vec2()
        })
    }

    fn draw(&self, right: &Vec<Vec2>, yours: Option<&Vec<Vec2>>) -> Option<Diagram> {
        let title = "The points, y downwards: other ones than the reference's are as right, if they are as evenly and independently spread";
        Some(in_square(title, [1, 1], right, yours))
    }
}

impl Explained for Jittered {
    fn work(&self, way: &mut Way) -> Vec<Vec2> {
        let rng = &mut pcg::stream(22, self.seed.into());
        let count = dvec2(self.columns.into(), self.rows.into());
        way.number(
            "columns · rows: a point in each cell",
            "",
            count.x * count.y,
        );
        way.remark("The first point, of column i = 0 and row j = 0; the others go the same way:");
        let cells = lattice(way, self.columns, self.rows);
        way.of_first(cells, |way, cell| {
            let cell = way.part("(i, j)", cell);
            let u = way.pair(
                "(ξ₁, ξ₂), two new random numbers",
                "",
                dvec2(rng.random(), rng.random()),
            );
            way.pair("((i + ξ₁)/columns, (j + ξ₂)/rows)", "", (cell + u) / count)
                .as_vec2()
        })
    }

    fn draw(&self, right: &Vec<Vec2>, yours: Option<&Vec<Vec2>>) -> Option<Diagram> {
        let title = "The cells and the points, y downwards: one in each cell, anywhere in it";
        Some(in_square(title, [self.columns, self.rows], right, yours))
    }
}

/// The least distance between two points; ∞ of fewer than two.
fn least_distance(points: &[Vec2]) -> f64 {
    let pairs = points.iter().enumerate();
    let pairs = pairs.flat_map(|(i, p)| points[..i].iter().map(move |other| (p, other)));
    let apart = pairs.map(|(p, other)| f64::from(p.distance(*other)));
    apart.fold(f64::INFINITY, f64::min)
}

impl Explained for PoissonDisk {
    fn work(&self, way: &mut Way) -> Vec<Vec2> {
        way.remark("One way of many: throw points at random, and keep those that keep the distance from all before, until hardly another one fits.");
        let rng = &mut pcg::stream(22, self.seed.into());
        let points = poisson_disk(self.distance, Space::Square, rng);
        way.number(
            "the least distance that is allowed",
            "",
            self.distance.into(),
        );
        way.number("points", "", points.len() as f64);
        if points.len() > 1 {
            way.number(
                "the least distance of two of them",
                "",
                least_distance(&points),
            );
        }
        let discs =
            points.len() as f64 * std::f64::consts::PI * (0.5 * f64::from(self.distance)).powi(2);
        way.number(
            "the area of the discs around them whose radius is half the distance",
            "",
            discs,
        );
        points
    }

    fn draw(&self, right: &Vec<Vec2>, yours: Option<&Vec<Vec2>>) -> Option<Diagram> {
        /// More discs than these are a grey area.
        const DISCS: usize = 150;
        let title = "The points, y downwards; the circles, of half the distance, must not overlap. Other points than the reference's are as right";
        let mut drawing = in_square(title, [1, 1], right, yours);
        let own = yours.map_or(right.as_slice(), Vec::as_slice);
        let inside = |p: &&Vec2| (**p - 0.5).abs().max_element() <= 0.5;
        if own.len() <= DISCS {
            for p in own.iter().filter(inside) {
                let radius = 0.5 * f64::from(self.distance);
                drawing.circle(square::down(p.as_dvec2()), radius, Ink::Guide);
            }
        }
        Some(drawing)
    }
}

/// The weight of a sample at an offset.
fn weight(q: &PixelAverage, offset: Vec2) -> f64 {
    let factors = 1.0 - offset.as_dvec2().abs() / f64::from(q.radius);
    factors.x.max(0.0) * factors.y.max(0.0)
}

impl Explained for PixelAverage {
    fn work(&self, way: &mut Way) -> Rgb {
        let (mut sum, mut weights) = (DVec3::ZERO, 0.0);
        for i in way.rounds("the samples", self.samples.len()) {
            let seen = &self.samples[i];
            let offset = way.part("offset", seen.offset.as_dvec2());
            let away = way.made(
                "to take the absolute values of x and y",
                offset,
                offset.abs(),
            );
            let radius = way.part("radius", f64::from(self.radius));
            let factors = way.pair(
                format!("sample {i}: (1 − |x|/radius, 1 − |y|/radius)"),
                "",
                1.0 - away / radius,
            );
            let is_far = way.is_less("a factor is negative", factors.min_element(), 0.0);
            let weight = if is_far {
                0.0
            } else {
                factors.element_product()
            };
            let weight = way.number("w, their product; 0 if one is negative", "", weight);
            let light = way.colour_part("L", parts(seen.radiance));
            let weighted = way.colour("w L", "W·m⁻²·sr⁻¹", weight * light);
            let counted = way.part("w in Σ w", weight);
            (sum, weights) = (sum + weighted, weights + counted);
        }
        let sum = way.colour("Σ w L", "W·m⁻²·sr⁻¹", sum);
        let weights = way.number("Σ w", "", weights);
        if way.is_zero("the weights sum up to 0", weights) {
            way.remark("The weights sum up to 0: black.");
            return Rgb::BLACK;
        }
        let average = way.made("to divide by Σ w", sum, sum / weights);
        colour(way.colour("Σ w L/Σ w", "W·m⁻²·sr⁻¹", average))
    }

    fn draw(&self, _: &Rgb, _: Option<&Rgb>) -> Option<Diagram> {
        let mut drawing = Diagram::new(
            "The samples around the pixel's centre, y downwards, with their weights; the filter reaches to the dashed square",
        );
        drawing.keyed = false;
        let square = |half: f64, ink: Ink, drawing: &mut Diagram| {
            let corners = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)];
            let corners = corners.map(|(x, y)| half * dvec2(x.into(), y.into()));
            drawing.line(&corners, ink);
        };
        let radius = f64::from(self.radius);
        square(0.5, Ink::Shape, &mut drawing);
        drawing.label(dvec2(-0.5, 0.5), dvec2(0.7, -0.8), "the pixel", Ink::Shape);
        square(radius, Ink::Guide, &mut drawing);
        for seen in &self.samples {
            let at = square::down(seen.offset.as_dvec2());
            let weight = weight(self, seen.offset);
            let ink = if weight > 0.0 { Ink::Right } else { Ink::Guide };
            drawing.point(at, ink);
            drawing.label(at, dvec2(0.0, 0.9), format!("{weight:.3}"), ink);
        }
        Some(drawing)
    }
}
