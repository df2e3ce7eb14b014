//! Recorded questions and Embree's answers, as lines of text.
//!
//! A line holds, with spaces between: a name; the ray's origin and direction; the ends of the interval; the shape in words and
//! numbers; `=`; and the answer: `t id u v` and the normal, or `none`. Every number is as short as it can be read back
//! exactly. A line that is empty or begins with `#` is a comment.

use crate::oracle::judge::Answer;
use crate::oracle::target::{Target, spaced};
use glam::{Vec2, Vec3};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::sphere::Sphere;
use std::str::FromStr;

/// One question and Embree's answer.
#[derive(Debug)]
pub struct Recorded {
    /// What the question is about.
    pub name: String,
    /// The ray.
    pub ray: Ray,
    /// The distances that count.
    pub within: Interval,
    /// What it is shot at.
    pub target: Target,
    /// Embree's answer.
    pub answer: Option<Answer>,
}

/// The line that records a question and its answer.
pub fn line(
    name: &str,
    ray: &Ray,
    within: Interval,
    target: &Target,
    answer: Option<Answer>,
) -> String {
    let (o, d) = (spaced(ray.origin), spaced(*ray.direction));
    let answer = answer.map_or_else(
        || "none".to_owned(),
        |Answer { t, id, uv, normal }| format!("{t} {id} {} {} {}", uv.x, uv.y, spaced(normal)),
    );
    format!(
        "{name}  {o}  {d}  {} {}  {}  = {answer}",
        within.min, within.max, target.words
    )
}

/// A shape from its words.
///
/// # Errors
/// A sentence that says which word is not what was expected.
pub fn shape(text: &str) -> Result<Target, String> {
    let mut words = Words(text.split_whitespace());
    let target = target(&mut words)?;
    words.end()?;
    Ok(target)
}

/// All lines of a recording.
///
/// # Errors
/// A sentence that begins with `file:line`, for the first line that does not hold what it must.
pub fn parse(file: &str, text: &str) -> Result<Vec<Recorded>, String> {
    let lines = text.lines().zip(1..);
    lines
        .filter(|(line, _)| !line.trim().is_empty() && !line.starts_with('#'))
        .map(|(line, number)| parse_line(line).map_err(|why| format!("{file}:{number}: {why}")))
        .collect()
}

fn parse_line(line: &str) -> Result<Recorded, String> {
    let (question, answer) = line
        .split_once(" = ")
        .ok_or("` = ` is missing between question and answer")?;
    let mut words = Words(question.split_whitespace());
    let recorded = Recorded {
        name: words.word("a name")?.to_owned(),
        ray: Ray::new(
            words.vector("the ray's origin")?,
            words.direction("the ray's direction")?,
        ),
        within: Interval::new(
            words.value("the interval's first end")?,
            words.value("the interval's second end")?,
        ),
        target: target(&mut words)?,
        answer: if answer.trim() == "none" {
            None
        } else {
            Some(parse_answer(answer)?)
        },
    };
    words.end()?;
    Ok(recorded)
}

fn parse_answer(text: &str) -> Result<Answer, String> {
    let mut words = Words(text.split_whitespace());
    let answer = Answer {
        t: words.value("t, or `none`")?,
        id: words.value("the triangle's number")?,
        uv: Vec2::new(words.value("b1")?, words.value("b2")?),
        normal: words.vector("the normal")?,
    };
    words.end()?;
    Ok(answer)
}

fn target(words: &mut Words) -> Result<Target, String> {
    let not_finite = |error: raybook::shape::mesh::MeshError| error.to_string();
    match words.word("a shape")? {
        "sphere" => Ok(Target::sphere(Sphere::new(
            words.vector("the centre")?,
            words.value("the radius")?,
        ))),
        "triangle" => Target::triangle([
            words.vector("the first corner")?,
            words.vector("the second corner")?,
            words.vector("the third corner")?,
        ])
        .map_err(not_finite),
        "plane" => Target::plane(
            words.vector("a point of the plane")?,
            words.direction("the plane's normal")?,
        )
        .map_err(not_finite),
        "cuboid" => Target::cuboid(Aabb {
            min: words.vector("the least corner")?,
            max: words.vector("the greatest corner")?,
        })
        .map_err(not_finite),
        "mesh" => {
            let (kind, triangles) = (
                words.word("a kind of mesh")?,
                words.value("a number of triangles")?,
            );
            Target::mesh(kind, triangles).ok_or_else(|| format!("there is no mesh `{kind}`"))
        }
        other => Err(format!(
            "expected sphere, triangle, plane, cuboid or mesh, found `{other}`"
        )),
    }
}

/// The words of a line that are still to be read.
struct Words<'a>(std::str::SplitWhitespace<'a>);

impl<'a> Words<'a> {
    fn word(&mut self, what: &str) -> Result<&'a str, String> {
        self.0
            .next()
            .ok_or_else(|| format!("expected {what}, found the end"))
    }

    fn value<T: FromStr>(&mut self, what: &str) -> Result<T, String> {
        let word = self.word(what)?;
        word.parse()
            .map_err(|_| format!("expected {what}, found `{word}`"))
    }

    fn vector(&mut self, what: &str) -> Result<Vec3, String> {
        Ok(Vec3::new(
            self.value(what)?,
            self.value(what)?,
            self.value(what)?,
        ))
    }

    /// A direction that is of length 1 to the last digit: normalising it again changes nothing.
    fn direction(&mut self, what: &str) -> Result<Dir3, String> {
        let v = self.vector(what)?;
        Dir3::new(v)
            .filter(|direction| **direction == v)
            .ok_or_else(|| format!("expected {what} of length 1, found {}", spaced(v)))
    }

    fn end(&mut self) -> Result<(), String> {
        self.0.next().map_or(Ok(()), |word| {
            Err(format!("expected the end, found `{word}`"))
        })
    }
}
