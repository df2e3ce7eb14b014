//! Functions of a right answer that a mistake makes of it, without a number to fit.

use raybook::image::tone::{decode_srgb, encode_srgb};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A function of each number.
pub struct Function {
    /// What a function with this mistake does, as a verb.
    pub name: &'static str,
    /// A question that leads on.
    pub hint: &'static str,
    /// How common it is.
    pub rank: u32,
    takes: Takes,
    /// The wrong number, made of the right one.
    pub of: fn(f64) -> f64,
    /// The right number, made of the wrong one, if that can be said.
    pub back: Option<fn(f64) -> f64>,
}

/// What a function is taken of.
enum Takes {
    /// Any number.
    Number,
    /// A number that may be light, which is neither a length nor an angle.
    Light,
    /// An angle, or a sine, cosine or tangent.
    Angle,
    /// An angle, whose unit is mistaken.
    Units,
}

/// The rank of the last function that is common.
pub const COMMON: u32 = 11;

impl Function {
    /// Whether it is the same number whatever the right one is.
    pub fn is_constant(&self) -> bool {
        let [first, others @ ..] = [0.3, 1.7, -1.7].map(self.of);
        others.iter().all(|other| *other == first)
    }

    /// Whether it leaves most numbers as they are: a limit, or a sign that is lost.
    pub fn is_selective(&self) -> bool {
        let is_limit = self.rank <= COMMON && [0.3, 0.7].into_iter().all(|v| (self.of)(v) == v);
        is_limit || self.is_constant()
    }

    /// Whether a value can be taken for what the function takes: a length has no cosine, 2 has no arc cosine, and a number without
    /// a unit is only taken for degrees beside values that are angles.
    pub fn suits(&self, value: &[f64], unit: &str, has_angles: bool) -> bool {
        // What counts something is no angle.
        let counts = |v: &f64| v.fract() == 0.0 && v.abs() > 1.0;
        let is_bare = unit.is_empty() && !value.iter().all(counts);
        let is_angle = match self.takes {
            Takes::Number => return true,
            Takes::Light => return !["m", "rad"].contains(&unit),
            Takes::Angle => unit == "rad" || is_bare,
            Takes::Units => unit == "rad" || is_bare && has_angles,
        };
        is_angle && value.iter().all(|v| (self.of)(*v).is_finite())
    }
}

macro_rules! functions {
    ($($rank:literal $takes:ident $name:literal, $hint:literal: $of:expr $(, back $back:expr)?;)+) => {
        /// All of them.
        pub const FUNCTIONS: &[Function] = &[$(Function {
            name: $name,
            hint: $hint,
            rank: $rank,
            takes: Takes::$takes,
            of: $of,
            back: functions!(@back $($back)?),
        }),+];
    };
    (@back) => { None };
    (@back $back:expr) => { Some($back) };
}

functions! {
    9 Number "has the sign of the answer wrong", "Which sign should your answer have, and which sign does it have?": |v| -v, back |v| -v;
    11 Units "returns degrees instead of radians", "In which unit is the angle that is asked for?": f64::to_degrees, back f64::to_radians;
    11 Units "converts the answer from degrees to radians although it is in radians already", "In which unit is the angle that you have calculated?": f64::to_radians, back f64::to_degrees;
    10 Number "returns the square of the answer: a missing root, or a square too many", "Check the unit of your answer: is a square root missing, or is something squared twice?": |v| v * v, back f64::sqrt;
    10 Number "returns the square root of the answer: a root too many, or a missing square", "Check the unit of your answer: is there a root too many?": |v| v.max(0.0).sqrt(), back |v| v * v;
    10 Number "returns the reciprocal, 1 over the answer", "Which way round is your fraction?": |v| 1.0 / v, back |v| 1.0 / v;
    11 Number "returns the negative reciprocal, −1 over the answer", "Which way round is your fraction, and what is its sign?": |v| -1.0 / v, back |v| -1.0 / v;
    10 Number "returns 1 minus the answer: the other way round", "Do you answer the opposite of what is asked?": |v| 1.0 - v, back |v| 1.0 - v;
    11 Number "returns the absolute value of the answer", "May the answer be negative? What does its sign mean?": f64::abs;
    11 Number "clamps the answer to the range from 0 to 1", "Is there an upper limit to what is asked for?": |v| v.clamp(0.0, 1.0);
    10 Number "never returns less than 0", "May the answer be negative?": |v| v.max(0.0);
    11 Number "never returns more than 1", "Is there an upper limit to what is asked for?": |v| v.min(1.0);
    11 Number "never returns less than 1", "Is there a lower limit to what is asked for?": |v| v.max(1.0);
    10 Number "rounds the answer down to a whole number", "Look for a division of integers, or for a type of whole numbers.": f64::floor;
    10 Number "rounds the answer up to a whole number", "Is the answer a whole number?": f64::ceil;
    12 Number "rounds the answer to a whole number", "Is the answer a whole number?": f64::round;
    12 Number "cuts off what is behind the decimal point", "Look for a conversion to a whole number.": f64::trunc;
    13 Number "rounds the answer to 2 digits behind the decimal point", "Is anything rounded before the end?": |v| (v * 1e2).round() / 1e2;
    13 Number "rounds the answer to 3 digits behind the decimal point", "Is anything rounded before the end?": |v| (v * 1e3).round() / 1e3;
    13 Light "rounds the answer to a whole multiple of 1/255, as a byte holds it", "Is the answer stored in a byte, or for a moment in one?": |v| (255.0 * v).round() / 255.0;
    13 Light "rounds the answer down to a whole multiple of 1/255, as a byte holds it", "Is the answer stored in a byte, or for a moment in one?": |v| (255.0 * v).floor() / 255.0;
    13 Light "rounds the answer down to a whole multiple of 1/256, as a byte holds it", "Is the answer stored in a byte, or for a moment in one?": |v| (256.0 * v).floor() / 256.0;
    13 Light "makes a byte of the answer: rounds down 256 times it, 255 at most, and divides by 255", "Is the answer stored in a byte, or for a moment in one?": |v| (256.0 * v).floor().min(255.0) / 255.0;
    12 Number "returns only what is behind the decimal point", "May the answer be larger than 1?": |v| v - v.floor();
    12 Light "encodes the answer for a display (sRGB)", "Is the answer meant for a display, or for calculations with light?": |v| encode_srgb(v as f32).into();
    12 Light "decodes the answer as if it were an sRGB value", "Is the answer meant for a display, or for calculations with light?": |v| decode_srgb(v as f32).into();
    12 Light "raises the answer to the power of 1/2.2, as for a display", "Is the answer meant for a display, or for calculations with light?": |v| v.max(0.0).powf(1.0 / 2.2);
    12 Light "raises the answer to the power of 2.2", "Is the answer meant for a display, or for calculations with light?": |v| v.max(0.0).powf(2.2);
    13 Angle "returns the cosine of the answer: a missing arc cosine", "Are you asked for the angle or for its cosine?": f64::cos;
    13 Angle "returns the sine of the answer: a missing arc sine", "Are you asked for the angle or for its sine?": f64::sin;
    13 Angle "returns the tangent of the answer: a missing arc tangent", "Are you asked for the angle or for its tangent?": f64::tan;
    13 Angle "returns the arc cosine of the answer", "Are you asked for the cosine or for the angle?": f64::acos;
    13 Angle "returns the arc sine of the answer", "Are you asked for the sine or for the angle?": f64::asin;
    13 Angle "returns sin where cos is due (or the other way round): √(1 − answer²)", "Which of sine and cosine is 1 at the angle 0?": |v| (1.0 - v * v).max(0.0).sqrt();
    14 Angle "returns 1 − cos where sin is due (or 1 − sin where cos is): 1 − √(1 − answer²)", "How do the sine and the cosine of an angle depend on each other? Try 60°.": |v| 1.0 - (1.0 - v * v).max(0.0).sqrt();
    15 Angle "returns cos √(1 − answer²), as if the sine were the angle", "Of which number is the cosine taken: of an angle, or of its sine?": |v| (1.0 - v * v).max(0.0).sqrt().cos();
    15 Angle "returns sin √(1 − answer²), as if the cosine were the angle", "Of which number is the sine taken: of an angle, or of its cosine?": |v| (1.0 - v * v).max(0.0).sqrt().sin();
    13 Angle "measures the angle from the other axis: π/2 minus the answer", "From where is the angle measured: from the axis, or from the horizon?": |v| FRAC_PI_2 - v, back |v| FRAC_PI_2 - v;
    13 Angle "returns the supplement of the angle: π minus the answer", "Which of the two angles between two lines is asked for?": |v| PI - v, back |v| PI - v;
    13 Angle "returns 2π minus the answer", "In which sense is the angle measured?": |v| TAU - v;
    14 Angle "is half a turn off: the answer plus π", "Where is the angle 0?": |v| v + PI, back |v| v - PI;
    14 Angle "is half a turn off: the answer minus π", "Where is the angle 0?": |v| v - PI, back |v| v + PI;
    14 Number "is half of the range from 0 to 1 off", "Where does the range from 0 to 1 begin?": |v| (v + 0.5) - (v + 0.5).floor(), back |v| (v + 0.5) - (v + 0.5).floor();
    14 Number "returns twice the answer minus 1, as for a range from −1 to 1 instead of 0 to 1", "From where to where does this number go, and from where to where should it?": |v| 2.0 * v - 1.0, back |v| 0.5 * v + 0.5;
    14 Number "returns half of the answer plus ½, as for a range from 0 to 1 instead of −1 to 1", "From where to where does this number go, and from where to where should it?": |v| 0.5 * v + 0.5, back |v| 2.0 * v - 1.0;
    15 Number "cubes the answer", "Check the unit of your answer.": |v| v * v * v;
    15 Number "returns 1 over the square of the answer", "Check the unit of your answer.": |v| 1.0 / (v * v);
    15 Number "returns the exponential of the answer", "Is there an exponential too many, or a logarithm missing?": f64::exp;
    15 Number "returns 2 to the power of the answer", "Is there a power too many, or a logarithm missing?": f64::exp2;
    15 Number "returns the natural logarithm of the answer", "Is there a logarithm too many?": f64::ln;
    15 Number "returns the logarithm to base 2 of the answer", "Is there a logarithm too many?": f64::log2;
    15 Number "returns 1 + the reciprocal of the answer", "Write down the formula again.": |v| 1.0 + 1.0 / v;
    15 Number "maps the answer to v/(1 + v)", "Is tone mapping asked for here?": |v| v / (1.0 + v);
    16 Number "returns 0", "Does your function return what it calculates?": |_| 0.0;
    16 Number "returns 1", "Does your function return what it calculates?": |_| 1.0;
    16 Number "returns a sign only", "Does your function return what it calculates?": |v| if v == 0.0 { 0.0 } else { v.signum() };
}
