//! What values mean: numbers, vectors, colours.
//!
//! ```
//! use raybook_scenes::{values::number, wrong::Source};
//!
//! let source = Source { path: "numbers.toml".as_ref(), text: "whole = 1_000\nshort = 0.5\ntext = '7'" };
//! let table = source.parse()?;
//! let values = ["whole", "short", "text"].map(|name| number(table.get_ref()[name].get_ref()));
//! assert_eq!(values, [Some(1000.0), Some(0.5), None]);
//! # Ok::<(), raybook_scenes::wrong::TextError>(())
//! ```

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::math::domain::LARGEST;
use toml::de::DeValue;

/// A description of a value, for error messages.
pub(crate) fn described(value: &DeValue) -> String {
    match value {
        DeValue::String(text) => {
            let short: String = text.chars().take(40).collect();
            format!("the text \"{}\"", short.escape_debug())
        }
        DeValue::Integer(number) => number.as_str().chars().take(40).collect(),
        DeValue::Float(number) => number.as_str().chars().take(40).collect(),
        DeValue::Boolean(yes) => yes.to_string(),
        DeValue::Datetime(_) => "a date".to_owned(),
        DeValue::Array(list) => {
            let numbers: Option<Vec<_>> = list.iter().map(|v| number(v.get_ref())).collect();
            match numbers {
                Some(numbers) if list.len() <= 4 => format!("{numbers:?}"),
                _ => format!("a list of {}", list.len()),
            }
        }
        DeValue::Table(_) => "a table".to_owned(),
    }
}

/// A number, whole or not.
pub fn number(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Integer(_) => whole(value).map(|v| v as f64),
        DeValue::Float(float) => float.as_str().replace('_', "").parse().ok(),
        _ => None,
    }
}

/// A whole number.
pub(crate) fn whole(value: &DeValue) -> Option<i64> {
    let number = value.as_integer()?;
    i64::from_str_radix(&number.as_str().replace('_', ""), number.radix()).ok()
}

/// Three finite numbers.
pub(crate) fn three(value: &DeValue) -> Option<Vec3> {
    let list = value.as_array()?;
    let mut numbers = list
        .iter()
        .map(|value| Some(number(value.get_ref())? as f32));
    let v = vec3(numbers.next()??, numbers.next()??, numbers.next()??);
    (list.len() == 3 && v.is_finite()).then_some(v)
}

/// Three coordinates within the domain, in metres.
pub(crate) fn place(value: &DeValue) -> Option<Vec3> {
    three(value).filter(|v| v.abs().cmple(Vec3::splat(LARGEST)).all())
}

/// A colour, in each channel from 0 to `most`.
pub(crate) fn colour(value: &DeValue, most: f32) -> Option<Rgb> {
    let gray = number(value).map(|v| Vec3::splat(v as f32));
    let v = gray.or_else(|| three(value))?;
    let within = v.cmpge(Vec3::ZERO).all() && v.cmple(Vec3::splat(most)).all();
    within.then(|| Rgb::new(v.x, v.y, v.z))
}
