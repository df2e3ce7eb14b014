//! Whether two answers to the same question are the same, within the bounds of [`Meeting`].

use crate::oracle::meeting::Meeting;
use crate::oracle::target::Target;
use glam::{Vec2, Vec3};
use raybook::math::{interval::Interval, ray::Ray};

/// What a ray hits first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The distance, in metres.
    pub t: f32,
    /// Which triangle.
    pub id: u32,
    /// Where on the triangle: (b₁, b₂).
    pub uv: Vec2,
    /// The outward normal.
    pub normal: Vec3,
}

/// What comes of comparing two answers.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Both miss.
    BothMiss,
    /// Both hit the same.
    Same {
        /// How much of the bounds the differences use; 1 is all.
        share: f64,
        /// Whether the bounds are narrow.
        sharp: bool,
    },
    /// They differ, and nobody is wrong.
    Excused(Excuse),
    /// They differ, and somebody is wrong: a sentence.
    Wrong(String),
}

/// Why two right answers may differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Excuse {
    /// The ray passes an edge or the silhouette within reach of rounding.
    Edge,
    /// The hit lies at an end of the interval, within rounding.
    End,
    /// Two triangles are hit at the same distance, within rounding.
    Tie,
}

/// Compares raybook's answer with Embree's.
pub fn judge(
    target: &Target,
    ray: &Ray,
    within: Interval,
    [ours, theirs]: [Option<Answer>; 2],
) -> Verdict {
    let wrong = |why: &str| {
        Verdict::Wrong(format!(
            "{why}\n  shape   {}\n  ray     {ray:?}\n  within  {within:?}\n  raybook {ours:?}\n  Embree  {theirs:?}",
            target.words
        ))
    };
    let nearer = match (ours, theirs) {
        (None, None) => return Verdict::BothMiss,
        (Some(a), Some(b)) => {
            if a.id == b.id || !target.numbered {
                let Some(meeting) = target.meeting(ray, &b) else {
                    return wrong("Embree names a triangle that does not exist");
                };
                let shares = shares(target, &meeting, &a, &b);
                // Asked one by one: `max` would pass over a NaN.
                if shares.iter().all(|&share| share <= 1.0) {
                    return Verdict::Same {
                        share: shares.into_iter().fold(0.0, f64::max),
                        sharp: meeting.is_sharp(),
                    };
                }
                if target.numbered {
                    return wrong(&format!(
                        "the same triangle, but t, (b1, b2) and the normal differ by {shares:.3?} of their bounds"
                    ));
                }
            }
            if a.t < b.t { a } else { b }
        }
        (Some(only), None) | (None, Some(only)) => only,
    };
    let is_true = |answer: &Answer| {
        let meetings = target.meetings(ray, answer);
        meetings.iter().any(|m| m.touches() && m.is_at(answer.t))
    };
    for (who, answer) in [("raybook", ours), ("Embree", theirs)] {
        if answer.is_some_and(|answer| !is_true(&answer)) {
            return wrong(&format!(
                "the ray does not meet the surface where {who} says"
            ));
        }
    }
    let suspects = target.meetings(ray, &nearer);
    if suspects.iter().any(Meeting::is_at_edge) {
        Verdict::Excused(Excuse::Edge)
    } else if suspects.iter().any(|m| m.is_at_end(within)) {
        Verdict::Excused(Excuse::End)
    } else if is_tie(&suspects, ours, theirs) {
        Verdict::Excused(Excuse::Tie)
    } else {
        wrong("one of them overlooks a hit, or sees one that is not there")
    }
}

/// The differences of t, barycentrics and normal, as parts of their bounds.
fn shares(target: &Target, meeting: &Meeting, a: &Answer, b: &Answer) -> [f64; 3] {
    let uv = if target.numbered {
        f64::from((a.uv - b.uv).abs().max_element())
    } else {
        0.0
    };
    [
        f64::from((a.t - b.t).abs()) / meeting.slack_t,
        uv / meeting.slack_uv,
        f64::from((a.normal - b.normal).length()) / meeting.slack_normal,
    ]
}

/// Whether both hit, at distances that the bounds cannot tell apart, different triangles (so that normals may differ).
fn is_tie(suspects: &[Meeting], ours: Option<Answer>, theirs: Option<Answer>) -> bool {
    let (Some(a), Some(b)) = (ours, theirs) else {
        return false;
    };
    a.id != b.id && suspects.iter().any(|m| m.is_at(a.t) && m.is_at(b.t))
}
