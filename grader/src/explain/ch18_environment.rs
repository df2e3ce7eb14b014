//! Chapter 18: a direction's place on a cube map and on a latitude-longitude map, and directions chosen by the light of one.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::way::Way;
use glam::{DVec2, DVec3, Vec2, Vec3, dvec2};
use raybook_workbook::exercises::ch17_rendering_equation::lattice;
use raybook_workbook::exercises::ch18_environment::{
    CubePlace, DirectionToCube, DirectionToLatlong, EnvironmentPdf, POINTS, SampleEnvironment,
};
use std::f64::consts::{PI, TAU};

impl Explained for DirectionToCube {
    fn work(&self, way: &mut Way) -> CubePlace {
        const FACES: [&str; 6] = ["+x", "−x", "+y", "−y", "+z", "−z"];
        let d = way.part("the direction", self.direction.as_dvec3());
        let axis = d.abs().max_position();
        let m = way.number("m: the component of the greatest magnitude", "", d[axis]);
        let is_negative = way.decides("m is negative", m <= 0.0);
        let face = 2 * axis + usize::from(is_negative);
        way.remark(format!(
            "It belongs to face {face}, which is {}.",
            FACES[face]
        ));
        let (towards, right, down) = match face {
            0 => ("(z, −y)", d.z, -d.y),
            1 => ("(−z, −y)", -d.z, -d.y),
            2 => ("(x, −z)", d.x, -d.z),
            3 => ("(x, z)", d.x, d.z),
            4 => ("(−x, −y)", -d.x, -d.y),
            _ => ("(x, −y)", d.x, -d.y),
        };
        let name = format!("to the right and down on this face: {towards}");
        let along: DVec2 = way.pair(name, "", dvec2(right, down));
        let along = way.part("that/|m|", along / m.abs());
        let place = way.pair("(u, v) = ½ + ½ · that/|m|", "", 0.5 + 0.5 * along);
        let face = way.part("the face's number", face as f64);
        CubePlace {
            face: face as u32,
            u: place.x as f32,
            v: place.y as f32,
        }
    }

    fn draw(&self, right: &CubePlace, yours: Option<&CubePlace>) -> Option<Diagram> {
        /// Each face's name, and the lower left corner of its square in the unfolded cube.
        const FACES: [(&str, DVec2); 6] = [
            ("+x", dvec2(2.0, 1.0)),
            ("−x", dvec2(0.0, 1.0)),
            ("+y", dvec2(1.0, 2.0)),
            ("−y", dvec2(1.0, 0.0)),
            ("+z", dvec2(3.0, 1.0)),
            ("−z", dvec2(1.0, 1.0)),
        ];
        let mut drawing = Diagram::new(
            "The cube unfolded around −z, as seen from inside, and the place on its faces",
        );
        for (name, corner) in FACES {
            let (x, y) = (DVec2::X, DVec2::Y);
            let outline = [corner, corner + x, corner + x + y, corner + y, corner];
            drawing.line(&outline, Ink::Guide);
            drawing.label(corner + 0.5, DVec2::ZERO, name, Ink::Guide);
        }
        for (place, ink) in [(Some(right), Ink::Right), (yours, Ink::Yours)] {
            let on_face = place.and_then(|p| Some((p, FACES.get(p.face as usize)?)));
            if let Some((place, (_, corner))) = on_face {
                let (u, v) = (f64::from(place.u), f64::from(place.v));
                drawing.point(corner + dvec2(u, 1.0 - v), ink);
            }
        }
        Some(drawing)
    }
}

/// The same with φ by its cosine, and the side by the sign of x.
fn by_cosines(asked: &DirectionToLatlong, way: &mut Way) -> Vec2 {
    let d = way.part("the direction", asked.direction.as_dvec3());
    let x = way.part("x", d.x);
    let ahead = way.part("−z", -d.z);
    let level = way.part("√(x² + z²)", d.x.hypot(d.z));
    let is_pole = way.decides("the direction is straight up or down", level == 0.0);
    let cosine = if is_pole { 1.0 } else { ahead / level };
    let cosine = way.part("cos φ = −z/√(x² + z²)", cosine);
    let phi = way.part("φ, on either side", cosine.clamp(-1.0, 1.0).acos());
    let phi = way.part("φ", phi.copysign(x));
    let y = way.part("y = cos θ", d.y);
    let theta = way.part("θ", y.clamp(-1.0, 1.0).acos());
    let turn = way.part("½ + φ/2π", 0.5 + phi / TAU);
    let u = if turn >= 1.0 { 0.0 } else { turn };
    let v = way.part("θ/π", theta / PI);
    dvec2(u, v).as_vec2()
}

impl Explained for DirectionToLatlong {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec2] = &[Self::work, by_cosines];

    fn work(&self, way: &mut Way) -> Vec2 {
        let d = way.part("the direction", self.direction.as_dvec3());
        let x = way.part("x", d.x);
        let ahead = way.part("−z", -d.z);
        let phi = way.number("φ = atan2(x, −z), around from −z", "rad", x.atan2(ahead));
        let turn = way.part("½ + φ/2π", 0.5 + phi / TAU);
        let is_edge = way.decides("φ is π", turn >= 1.0);
        if is_edge {
            way.remark("φ = π is the right edge of the map, which is its left edge, too.");
        }
        let level = way.part("√(x² + z²)", d.x.hypot(d.z));
        let y = way.part("y", d.y);
        let theta = way.number(
            "θ = atan2(√(x² + z²), y), down from +y",
            "rad",
            level.atan2(y),
        );
        let u = if is_edge { 0.0 } else { turn };
        let v = way.part("θ/π", theta / PI);
        way.pair("(u, v) = (½ + φ/2π, θ/π)", "", dvec2(u, v))
            .as_vec2()
    }

    fn draw(&self, right: &Vec2, yours: Option<&Vec2>) -> Option<Diagram> {
        let mut drawing =
            Diagram::new("The place on the map, with a line every 45°; −z is in its middle");
        Map::new(8, 4, &[]).draw(&mut drawing, &[]);
        for (name, d) in [("−z", DVec3::NEG_Z), ("+x", DVec3::X), ("−x", DVec3::NEG_X)] {
            drawing.label(on_map(d), dvec2(0.6, 0.8), name, Ink::Guide);
        }
        for (place, ink) in [(Some(right), Ink::Right), (yours, Ink::Yours)] {
            if let Some(place) = place {
                let (u, v) = (f64::from(place.x), f64::from(place.y));
                drawing.point(dvec2(2.0 * u, -v), ink);
            }
        }
        Some(drawing)
    }
}

/// A latitude-longitude map with the probabilities of its texels.
struct Map {
    width: usize,
    height: usize,
    /// Each texel's radiance times its solid angle, row by row.
    light: Vec<f64>,
}

impl Map {
    fn new(width: u32, height: u32, texels: &[f32]) -> Self {
        let (width, height) = (width.max(1) as usize, height.max(1) as usize);
        let of = |i: usize| f64::from(texels.get(i).copied().unwrap_or(0.0)).max(0.0);
        let mut map = Self {
            width,
            height,
            light: Vec::new(),
        };
        map.light = (0..width * height)
            .map(|i| of(i) * map.solid_angle(i / width))
            .collect();
        map
    }

    /// The cosines of θ at a row's edges, the upper one first.
    fn edges(&self, row: usize) -> [f64; 2] {
        [row, row + 1].map(|edge| (PI * edge as f64 / self.height as f64).cos())
    }

    /// The solid angle of each texel of a row.
    fn solid_angle(&self, row: usize) -> f64 {
        let [top, bottom] = self.edges(row);
        TAU * (top - bottom) / self.width as f64
    }

    /// The light of all texels, as a step of the way.
    fn all_told(&self, way: &mut Way) -> f64 {
        way.number(
            "the sum of radiance times solid angle over all texels",
            "W/m²",
            self.light.iter().sum(),
        )
    }

    fn of_row(&self, row: usize) -> &[f64] {
        &self.light[row * self.width..(row + 1) * self.width]
    }

    /// Draws the texels' edges, and the values where there are few of them.
    fn draw(&self, drawing: &mut Diagram, texels: &[f32]) {
        /// More texels than these have no room for their values.
        const NAMED: usize = 40;
        /// More lines than these are a grey area.
        const LINES: usize = 64;
        let (width, height) = (self.width as f64, self.height as f64);
        let at = |u: f64, v: f64| dvec2(2.0 * u, -v);
        for i in (0..=self.width).filter(|i| self.width <= LINES || i % self.width == 0) {
            let u = i as f64 / width;
            drawing.line(&[at(u, 0.0), at(u, 1.0)], Ink::Guide);
        }
        for i in (0..=self.height).filter(|i| self.height <= LINES || i % self.height == 0) {
            let v = i as f64 / height;
            drawing.line(&[at(0.0, v), at(1.0, v)], Ink::Guide);
        }
        for (i, value) in texels.iter().enumerate().take(self.light.len()) {
            if self.light.len() <= NAMED {
                let (x, y) = ((i % self.width) as f64, (i / self.width) as f64);
                let middle = at((x + 0.5) / width, (y + 0.5) / height);
                drawing.label(middle, DVec2::ZERO, format!("{value:.3}"), Ink::Guide);
            }
        }
    }
}

/// The place of a direction on a latitude-longitude map, as it is drawn: twice as wide as it is high.
fn on_map(d: DVec3) -> DVec2 {
    let theta = d.x.hypot(d.z).atan2(d.y);
    dvec2(2.0 * (0.5 + d.x.atan2(-d.z) / TAU), -theta / PI)
}

/// Which of some weights a share of their sum falls into, and where in it.
fn choose(weights: &[f64], share: f64) -> (usize, f64) {
    let mut left = share * weights.iter().sum::<f64>();
    let mut last = (0, 0.0);
    for (i, weight) in weights
        .iter()
        .enumerate()
        .filter(|(_, weight)| **weight > 0.0)
    {
        last = (i, (left / weight).min(1.0));
        if left < *weight {
            break;
        }
        left -= weight;
    }
    last
}

impl Explained for SampleEnvironment {
    fn work(&self, way: &mut Way) -> Vec<Vec3> {
        let map = Map::new(self.width, self.height, &self.texels);
        let all = map.all_told(way);
        if way.decides("the map is black", all <= 0.0) {
            way.remark("The map is black: there is no direction to choose.");
            return Vec::new();
        }
        let rows: Vec<f64> = (0..map.height)
            .map(|row| map.of_row(row).iter().sum())
            .collect();
        way.remark("The first direction; the others go the same way:");
        way.of_first(lattice(POINTS), |way, u| {
            let u = way.pair("u", "", u.as_dvec2());
            let (row, down) = choose(&rows, u.y);
            let chosen = way.pair(
                "u.y chooses the row by its light: its number, and how far down in it",
                "",
                dvec2(row as f64, down),
            );
            let (row, down) = ((chosen.x.max(0.0) as usize).min(map.height - 1), chosen.y);
            let (column, right) = choose(map.of_row(row), u.x);
            let chosen = way.pair(
                "u.x chooses the texel of the row: its number, and how far right in it",
                "",
                dvec2(column as f64, right),
            );
            let turn = way.part(
                "(column + right)/width",
                chosen.element_sum() / map.width as f64,
            );
            let phi = TAU * (turn - 0.5);
            let phi = way.number("φ, which goes evenly through the texel", "rad", phi);
            let [top, bottom] = map.edges(row);
            let cosine = way.number("cos θ, which does so too", "", top + down * (bottom - top));
            let sine = way.part("sin θ", (1.0 - cosine * cosine).max(0.0).sqrt());
            let toward = DVec3::new(sine * phi.sin(), cosine, -sine * phi.cos());
            way.vector(
                "the direction (sin θ sin φ, cos θ, −sin θ cos φ)",
                "",
                toward,
            )
            .as_vec3()
        })
    }

    fn draw(&self, right: &Vec<Vec3>, yours: Option<&Vec<Vec3>>) -> Option<Diagram> {
        let mut drawing = Diagram::new(
            "The directions on the map; a texel that is brighter or larger on the sphere gets more of them",
        );
        Map::new(self.width, self.height, &self.texels).draw(&mut drawing, &self.texels);
        let yours = yours.map_or(&[][..], Vec::as_slice);
        for (directions, ink) in [(right.as_slice(), Ink::Right), (yours, Ink::Yours)] {
            for d in directions.iter().take(POINTS as usize) {
                drawing.point(on_map(d.as_dvec3()), ink);
            }
        }
        Some(drawing)
    }
}

impl Explained for EnvironmentPdf {
    fn work(&self, way: &mut Way) -> f32 {
        let map = Map::new(self.width, self.height, &self.texels);
        let all = map.all_told(way);
        if way.decides("the map is black", all <= 0.0) {
            way.remark("The map is black: the density is 0.");
            return 0.0;
        }
        let latlong = DirectionToLatlong {
            direction: self.direction,
        };
        let place = latlong.work(way).as_dvec2();
        let texel = |place: f64, count: usize| ((place * count as f64) as usize).min(count - 1);
        let (x, y) = (texel(place.x, map.width), texel(place.y, map.height));
        let at = way.pair(
            "its texel's column and row, from 0",
            "",
            dvec2(x as f64, y as f64),
        );
        let within = |place: f64, count: usize| (place.max(0.0) as usize).min(count - 1);
        let (x, y) = (within(at.x, map.width), within(at.y, map.height));
        let solid_angle = way.number(
            "the texel's solid angle, 2π (cos θ₀ − cos θ₁)/width",
            "sr",
            map.solid_angle(y),
        );
        let probability = way.number(
            "its probability: radiance times solid angle over the sum",
            "",
            map.of_row(y)[x] / all,
        );
        way.number("probability/solid angle", "1/sr", probability / solid_angle) as f32
    }

    fn draw(&self, _: &f32, _: Option<&f32>) -> Option<Diagram> {
        let mut drawing =
            Diagram::new("The direction on the map, whose texels have these radiances");
        drawing.keyed = false;
        Map::new(self.width, self.height, &self.texels).draw(&mut drawing, &self.texels);
        let at = on_map(self.direction.as_dvec3());
        drawing.point(at, Ink::Shape);
        drawing.label(at, dvec2(0.6, 0.8), "the direction", Ink::Shape);
        Some(drawing)
    }
}
