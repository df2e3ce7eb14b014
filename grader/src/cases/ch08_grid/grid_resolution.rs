//! `grid_resolution`: random questions, judge and mistakes.

use crate::upon::changed;
use crate::{Graded, Mistake, Verdict, sample};
use glam::Vec3;
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch08_grid::{Cell, GridResolution};

impl Graded for GridResolution {
    fn random(rng: &mut Pcg) -> GridResolution {
        let mut extents = sample::point(rng, 6.0) + 6.5;
        if rng.random_bool(0.3) {
            let axis = rng.random_range(0..3_usize);
            extents[axis] *= sample::number(rng, 0.0001, 0.01);
        }
        GridResolution {
            extents,
            shapes: rng.random_range(2..60_000),
            density: sample::number(rng, 0.5, 10.0),
        }
    }

    fn judge(q: &GridResolution, golden: &Cell, got: &Cell) -> Verdict {
        for (axis, golden, got) in [
            ("x", golden.x, got.x),
            ("y", golden.y, got.y),
            ("z", golden.z, got.z),
        ] {
            if golden != got {
                return Err(format!(
                    "there are {got} cells along {axis}, and should be {golden}: {} cells in all, each about a cube",
                    cells(q)
                ));
            }
        }
        Ok(())
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "cuts every axis into ∛(λN) cells, a thin one too",
            hint: "Should a long side be cut into as many pieces as a short one?",
            answer: |q| whole(Vec3::splat(cells(q).cbrt())),
        },
        Mistake {
            name: "forgets the density",
            hint: "How many cells should there be for each shape?",
            answer: |q| Self::misread(q, |q| q.density = 1.0),
        },
        Mistake {
            name: "cuts the longest side into ∛(λN) cells",
            hint: "Multiply your three numbers: how many cells is that in all?",
            answer: |q| {
                let longest = q.extents.max_element().max(f32::MIN_POSITIVE);
                whole(q.extents / longest * cells(q).cbrt())
            },
        },
        Mistake {
            name: "cuts every axis into as many cells as the longest",
            hint: "Should a long side be cut into as many pieces as a short one?",
            answer: |q| whole(Vec3::splat(share(q).max_element())),
        },
        Mistake {
            name: "rounds down",
            hint: "2.9 is nearer to 3 than to 2.",
            answer: |q| rounded(share(q), |cells| (cells * (1.0 + LAST_DIGITS)).floor()),
        },
        Mistake {
            name: "rounds down, also what is a whole number but for its last digits",
            hint: "2.9 is nearer to 3 than to 2. And what does your language make of 64 to the power of 1/3?",
            answer: |q| {
                let thick = thick(q).as_dvec3();
                let some = (0..3).filter(|&i| thick[i] > 0.0);
                let content: f64 = some.map(|i| f64::from(q.extents[i])).product();
                let cells = f64::from(q.density) * f64::from(q.shapes);
                let per_metre = (cells / content).powf(1.0 / thick.element_sum());
                let along = q.extents.as_dvec3() * thick * per_metre;
                rounded(along.floor().as_vec3(), |cells| cells)
            },
        },
        Mistake {
            name: "rounds up",
            hint: "2.1 is nearer to 2 than to 3.",
            answer: |q| rounded(share(q), |cells| (cells * (1.0 - LAST_DIGITS)).ceil()),
        },
        Mistake {
            name: "keeps a thin axis in the volume",
            hint: "A flat scene has hardly any volume: into how many cells do you cut its two long sides?",
            answer: |q| {
                let volume = q.extents.element_product().max(f32::MIN_POSITIVE);
                whole(q.extents * (cells(q) / volume).cbrt())
            },
        },
        Mistake {
            name: "gives an axis of extent 0 no cell",
            hint: "How many cells are there in all if one of your numbers is 0?",
            answer: |q| {
                let right = GridResolution::right(q);
                let thin = |n: u32, extent: f32| if extent <= 0.0 { 0 } else { n };
                Cell {
                    x: thin(right.x, q.extents.x),
                    y: thin(right.y, q.extents.y),
                    z: thin(right.z, q.extents.z),
                }
            },
        },
        Mistake {
            name: "multiplies by the density outside the root",
            hint: "Eight times the density: how many times as many cells are there, and how many times as many along an axis?",
            answer: |q| {
                let one = GridResolution { density: 1.0, ..*q };
                whole(share(&one) * q.density)
            },
        },
        Mistake {
            name: "takes the cube root even where fewer axes are cut",
            hint: "In a flat box there are λN cells along two axes: which root gives the cells along one?",
            answer: |q| {
                let right = share(q);
                let count = right.to_array().iter().filter(|n| **n > 0.0).count();
                let content: f32 = (0..3)
                    .filter(|&i| right[i] > 0.0)
                    .map(|i| q.extents[i])
                    .product();
                if count == 3 {
                    return GridResolution::right(q);
                }
                let along = q.extents * (cells(q) / content).cbrt();
                let thick = right.map(|n| f32::from(u8::from(n > 0.0)));
                whole(along * thick)
            },
        },
        Mistake {
            name: "takes the square root even where one axis only is cut",
            hint: "Of a box that is long along one axis only, all cells are in one row: which root gives their number?",
            answer: |q| {
                let (content, thick) = content(q);
                if thick.element_sum() > 1.0 {
                    return GridResolution::right(q);
                }
                whole(q.extents * (cells(q) / content).sqrt() * thick)
            },
        },
        Mistake {
            name: "does not cut at all where an axis is too thin to be cut",
            hint: "A flat box has no volume, but it has an area: into how many cells would you cut that?",
            answer: |q| {
                if share(q).min_element() > 0.0 {
                    GridResolution::right(q)
                } else {
                    whole(Vec3::ONE)
                }
            },
        },
        Mistake {
            name: "cuts all axes but the thin ones into equally many cells",
            hint: "A box is twice as long as it is wide, and its cells are about cubes: are there as many cells along both sides?",
            answer: |q| {
                let right = share(q);
                let count = right.to_array().iter().filter(|n| **n > 0.0).count();
                let along = cells(q).powf(1.0 / (count as f32).max(1.0));
                let thick = right.map(|n| f32::from(u8::from(n > 0.0)));
                whole(thick * along)
            },
        },
        Mistake {
            name: "takes the square root of the cells for their cube root",
            hint: "Nine cells in a square are three along each side: how many along each side are 27 cells in a cube?",
            answer: |q| {
                let right = share(q);
                let thick = right.map(|n| f32::from(u8::from(n > 0.0)));
                let volume: f32 = (0..3)
                    .filter(|&i| thick[i] > 0.0)
                    .map(|i| q.extents[i])
                    .product();
                whole(q.extents * (cells(q) / volume).sqrt() * thick)
            },
        },
        Mistake {
            name: "returns 0 for an axis that gets less than one cell",
            hint: "How many cells are there in all if there is none along one axis?",
            answer: |q| {
                let along = share(q);
                let Cell { x, y, z } = GridResolution::right(q);
                let cut = |n: u32, along: f32| if along > 0.0 { n } else { 0 };
                Cell {
                    x: cut(x, along.x),
                    y: cut(y, along.y),
                    z: cut(z, along.z),
                }
            },
        },
        Mistake {
            name: "forgets the root",
            hint: "Cells per volume has the unit 1/m³: which root makes cells per metre of it?",
            answer: |q| {
                let (volume, thick) = content(q);
                whole(q.extents * (cells(q) / volume) * thick)
            },
        },
        Mistake {
            name: "adds the extents instead of multiplying them",
            hint: "The volume of a box 2 m long, 3 m wide and 4 m high is 24 m³: which operation gives it?",
            answer: |q| {
                let (_, thick) = content(q);
                let sum = (q.extents * thick).element_sum();
                whole(q.extents * (cells(q) / sum).powf(1.0 / thick.element_sum().max(1.0)) * thick)
            },
        },
        Mistake {
            name: "leaves thin axes out once, and does not ask again",
            hint: "With fewer axes the cells are larger: may another axis now get less than one?",
            answer: |q| {
                let thick = at_least(along(q, extended(q)), 1.0) * extended(q);
                whole(along(q, thick) * thick)
            },
        },
        Mistake {
            name: "leaves out an axis only if its extent is 0",
            hint: "A box is a millimetre thick, and its cells are a metre: do the cells along its two long sides come to λN?",
            answer: |q| {
                let thick = extended(q);
                whole(along(q, thick) * thick)
            },
        },
        Mistake {
            name: "cuts every axis into ∛(λN) cells, but for an axis of extent 0",
            hint: "Should a long side be cut into as many pieces as a short one?",
            answer: |q| whole(extended(q) * cells(q).cbrt()),
        },
        Mistake {
            name: "leaves out an axis only if it gets less than half a cell",
            hint: "An axis would get 0.7 of a cell: is that a cell or more, and how many cells share the other axes then?",
            answer: |q| {
                let thick = thick_from(q, 0.5);
                whole(along(q, thick) * thick)
            },
        },
        Mistake {
            name: "leaves out an axis that is shorter than a metre, not shorter than a cell",
            hint: "How long is a cell, where there are a thousand of them in a box of a cubic metre?",
            answer: |q| {
                let thick = at_least(q.extents, 1.0);
                whole(along(q, thick) * thick)
            },
        },
        Mistake {
            name: "takes x · y for the area, whichever two axes are left",
            hint: "A wall that is thin along x: which two of its extents make its area?",
            answer: |q| {
                if thick(q) == Vec3::ONE {
                    return Self::right(q);
                }
                let (two, area) = (two_longest(q), q.extents.x * q.extents.y);
                let along = q.extents * (cells(q) / area).sqrt();
                if area > 0.0 && at_least(along, 1.0) * two == two {
                    whole(along * two)
                } else {
                    all_along_the_longest(q)
                }
            },
        },
        Mistake {
            name: "shares the cells among two axes at the least, even if one of them gets less than a cell",
            hint: "Of a box that is long along one axis only, all cells are in one row: how many of its axes are left out?",
            answer: |q| {
                if thick(q).element_sum() > 1.0 {
                    return Self::right(q);
                }
                let two = two_longest(q);
                if product(q, two) > 0.0 {
                    whole(along(q, two) * two)
                } else {
                    whole(Vec3::ONE)
                }
            },
        },
        Mistake {
            name: "raises to the power of 0, as if 1/3 and 1/2 were quotients of whole numbers",
            hint: "What does your language make of 1/3, and what is any number to this power?",
            answer: |q| {
                let thick = at_least(q.extents, 1.0);
                if thick.element_sum() > 1.0 && q.shapes > 0 {
                    whole(q.extents * thick)
                } else {
                    all_along_the_longest(q)
                }
            },
        },
        Mistake {
            name: "takes 3 ∛N cells along the longest axis, and at most 64, by the rule of another grid",
            hint: "Which rule does the task give, and what of it is in your formula: the density, the volume?",
            answer: |q| {
                let longest = q.extents.max_element().max(f32::MIN_POSITIVE);
                let along = q.extents * (3.0 * (q.shapes as f32).cbrt() / longest);
                whole(along.min(Vec3::splat(64.0)))
            },
        },
        Mistake {
            name: "never cuts an axis into more than 128 cells",
            hint: "Does the task limit the number of cells along an axis?",
            answer: |q| {
                let Cell { x, y, z } = Self::right(q);
                let [x, y, z] = [x, y, z].map(|n| n.min(128));
                Cell { x, y, z }
            },
        },
        Mistake {
            name: "keeps a thin axis in the volume, and makes one cell of all where the volume is 0",
            hint: "A flat scene has hardly any volume, or none: into how many cells do you cut its two long sides?",
            answer: |q| {
                let volume = q.extents.element_product();
                whole(if volume > 0.0 {
                    q.extents * (cells(q) / volume).cbrt()
                } else {
                    Vec3::ONE
                })
            },
        },
        Mistake {
            name: "divides the mean of the extents by the root of the number of cells",
            hint: "A hall is long and low: is the mean of its extents the side of a cube of the same volume?",
            answer: |q| {
                by_side(q, |some, _, root| {
                    some.iter().sum::<f64>() / some.len() as f64 / root
                })
            },
        },
        Mistake {
            name: "divides the mean of the extents by the root of the number of cells, with the extents of the axes that are left out",
            hint: "A hall is long and low: is the mean of its extents the side of a cube of the same volume?",
            answer: |q| by_side(q, |_, all, root| all.iter().sum::<f64>() / 3.0 / root),
        },
        Mistake {
            name: "cuts the longest side into ∛(λN) cells, or √(λN) where a thin axis is left out",
            hint: "Multiply your numbers: how many cells is that in all?",
            answer: |q| by_side(q, |some, _, root| some[0] / root),
        },
        Mistake {
            name: "cuts the shortest side that is not left out into ∛(λN) cells",
            hint: "Multiply your numbers: how many cells is that in all?",
            answer: |q| by_side(q, |some, _, root| some[some.len() - 1] / root),
        },
        Mistake {
            name: "takes the root of the number of cells only, and not of the volume",
            hint: "Cells per volume has the unit 1/m³: what is the unit of your number of cells along an axis?",
            answer: |q| by_side(q, |some, _, root| some.iter().product::<f64>() / root),
        },
        Mistake {
            name: "takes the root of the volume only, and not of the number of cells",
            hint: "Eight times the cells in the same cube: how many times as many are there along an axis?",
            answer: |q| {
                by_side(q, |some, _, root| {
                    let count = some.len() as f64;
                    some.iter().product::<f64>().powf(1.0 / count) / root.powf(count)
                })
            },
        },
        Mistake {
            name: "cuts off what is behind the decimal point, and adds 1",
            hint: "2.1 is nearer to 2 than to 3, and what does your rule make of 2.0?",
            answer: |q| rounded(share(q), |n| n.floor() + 1.0),
        },
        Mistake {
            name: "cuts only the longest axis where any axis is too thin to be cut",
            hint: "A flat box is thin along one axis: how many of its axes are cut?",
            answer: |q| all_axes_or_one(q, f64::round),
        },
        Mistake {
            name: "cuts only the longest axis where any axis is too thin to be cut, and rounds down",
            hint: "A flat box is thin along one axis: how many of its axes are cut? And is 2.9 nearer to 2 or to 3?",
            answer: |q| all_axes_or_one(q, f64::floor),
        },
        Mistake {
            name: "calculates the number of cells for each axis by itself, as the extent times the cube root of λ",
            hint: "How many cells are there in all, for the same λ and twice as many shapes?",
            answer: |q| whole(q.extents * q.density.cbrt()),
        },
    ];
}

/// λN.
pub(super) fn cells(q: &GridResolution) -> f32 {
    q.density * q.shapes as f32
}

/// How a number becomes a whole one.
type Round = fn(f32) -> f32;

/// At least 1 along each axis.
fn whole(along: Vec3) -> Cell {
    by_rounding(along, |_| {})
}

/// By less than this share, numbers of cells differ in their last digits only, which decide nothing.
const LAST_DIGITS: f32 = 1e-6;

/// The same with another rounding.
fn rounded(along: Vec3, round: Round) -> Cell {
    by_rounding(along, |how| *how = round)
}

/// The same by the right rounding, but for what is changed.
fn by_rounding(along: Vec3, change: impl FnOnce(&mut Round)) -> Cell {
    let round = changed(f32::round as Round, change);
    along.map(round).max(Vec3::ONE).as_uvec3().into()
}

/// What is to be rounded: it is right up to the last step.
fn share(q: &GridResolution) -> Vec3 {
    let thick = thick(q);
    along(q, thick) * thick
}

/// 1 for each axis that is cut, and 0 for one that is left out.
fn thick(q: &GridResolution) -> Vec3 {
    thick_from(q, 1.0)
}

/// The same, if an axis is left out that gets less than `least` cells.
fn thick_from(q: &GridResolution, least: f32) -> Vec3 {
    let mut thick = extended(q);
    loop {
        let fewer = at_least(along(q, thick), least) * thick;
        if fewer == thick {
            return thick;
        }
        thick = fewer;
    }
}

/// 1 for each axis whose extent is not 0.
fn extended(q: &GridResolution) -> Vec3 {
    Vec3::from([0, 1, 2].map(|i| f32::from(u8::from(q.extents[i] > 0.0))))
}

/// 1 for each axis along which a number is not less than the least, and 0 for the others.
fn at_least(along: Vec3, least: f32) -> Vec3 {
    along.map(|n| f32::from(u8::from(n >= least)))
}

/// 0 for the thinnest axis, and 1 for the other two.
fn two_longest(q: &GridResolution) -> Vec3 {
    let mut two = Vec3::ONE;
    two[q.extents.min_position()] = 0.0;
    two
}

/// All cells in a row; one cell for a point.
fn all_along_the_longest(q: &GridResolution) -> Cell {
    let mut along = Vec3::ONE;
    if q.extents != Vec3::ZERO {
        along[q.extents.max_position()] = cells(q);
    }
    whole(along)
}

/// The cells along each axis, if some of them share all cells.
fn along(q: &GridResolution, thick: Vec3) -> Vec3 {
    let root = |x: f32| x.powf(1.0 / thick.element_sum());
    q.extents * root(cells(q) / product(q, thick))
}

/// The volume of the axes that are cut, or their area, or their length; and which these are.
fn content(q: &GridResolution) -> (f32, Vec3) {
    let thick = thick(q);
    (product(q, thick), thick)
}

fn product(q: &GridResolution, thick: Vec3) -> f32 {
    let some = (0..3).filter(|&i| thick[i] > 0.0);
    some.map(|i| q.extents[i]).product()
}

/// The cells by another side of a cell: of the extents of the axes that are cut, the longest first, of all three, and of the root of the number
/// of cells. The thinnest axis is left out as long as it gets less than one cell.
fn by_side(q: &GridResolution, side: fn(&[f64], &[f64], f64) -> f64) -> Cell {
    let mut axes = [0, 1, 2];
    axes.sort_by(|a, b| q.extents[*b].total_cmp(&q.extents[*a]));
    let all = axes.map(|axis| f64::from(q.extents[axis]));
    let cells = f64::from(q.density) * f64::from(q.shapes);
    for count in (1..=3).rev() {
        let some = &all[..count];
        if some.iter().product::<f64>() == 0.0 || cells == 0.0 {
            continue;
        }
        let side = side(some, &all, cells.powf(1.0 / count as f64));
        if some[count - 1] >= side {
            let mut along = Vec3::ONE;
            for &axis in &axes[..count] {
                along[axis] = (f64::from(q.extents[axis]) / side).round() as f32;
            }
            return whole(along);
        }
    }
    whole(Vec3::ONE)
}

/// All three axes cut, or only the longest where one of them would get less than one cell, as a program with numbers of double precision rounds.
fn all_axes_or_one(q: &GridResolution, round: fn(f64) -> f64) -> Cell {
    let thick = thick(q);
    let thick = if thick == Vec3::ONE || thick == Vec3::ZERO {
        thick
    } else {
        Vec3::AXES[q.extents.max_position()]
    };
    let content: f64 = (0..3)
        .filter(|&i| thick[i] > 0.0)
        .map(|i| f64::from(q.extents[i]))
        .product();
    let cells = f64::from(q.density) * f64::from(q.shapes);
    let side = (content / cells).powf(1.0 / f64::from(thick.element_sum()));
    let [x, y, z] = [0, 1, 2].map(|i| {
        let along = f64::from(q.extents[i]) / side;
        if thick[i] > 0.0 {
            round(along).max(1.0) as u32
        } else {
            1
        }
    });
    Cell { x, y, z }
}
