//! Ray tracers with a slip in one place, or in two: what they are asked.

use super::tracer::Tracer;
use crate::Graded;
use crate::upon::changed;
use raybook::image::{rgb::Rgb, tone};
use raybook::scene::description::Form;
use raybook_workbook::exercises::ch25_capstone::Trace;

/// What a ray tracer does wrongly; each is explained by its mistake in `trace.rs`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slip {
    FirstForNearest,
    FarthestForNearest,
    OneSidedTriangles,
    OneSidedTrianglesInShadowsToo,
    OneSidedPlanes,
    OneSidedPlanesInShadowsToo,
    MirrorsBlackFromBehind,
    Parallelogram,
    NormalNotTurned,
    NormalNeverTurned,
    NoAmbient,
    AmbientForEachLamp,
    OneLamp,
    NearestLamp,
    LampsAveraged,
    NoFalloff,
    LampIsAPower,
    LampsTwiceAsBright,
    FalloffByDistance,
    FalloffByCube,
    FalloffUpToTheViewer,
    NoCosine,
    PositionForDirection,
    DiffuseOverPi,
    ViewTurned,
    LightForMirrored,
    HalfVector,
    HighlightTimesCosine,
    NoHighlight,
    HighlightUnlit,
    HighlightInTheShadow,
    NoShadows,
    ShadowsFromBeyondTheLamp,
    LightThroughGlass,
    LightThroughMirrors,
    LightThroughPlanes,
    LightThroughSpheres,
    LightThroughTriangles,
    ShadowEndsTheLoop,
    ShadowIsBlack,
    BelowTheSurface,
    ShadowRaysFromBelow,
    RefractedFromTheWrongSide,
    MirroredFromTheWrongSide,
    FromTheSideAwayFromTheViewer,
    AlwaysFromOutside,
    FarOff,
    MirrorsWithoutColour,
    MirrorsShowTheBackdrop,
    AmbientOnMirrors,
    NoBackdrop,
    NoBackdropInMirrors,
    OneSurfaceLess,
    OneSurfaceMore,
    BackdropAtTheEnd,
    AmbientAtTheEnd,
    HeightForShare,
    HeightAboveTheHorizon,
    HeightWithoutSign,
    AngleForHeight,
    AngleAboveTheHorizon,
    IndexTurned,
    AlwaysEntering,
    AllRefracted,
    AllRefractedFromInside,
    NothingMirroredInGlass,
    SharesExchanged,
    NoShares,
    FresnelFromOutside,
    FresnelBackwards,
    FresnelTurned,
    Schlick,
    HalfMirrored,
    MirroredAsFromStraightAbove,
    FourPercentMirrored,
    OnePolarisation,
    AlwaysCrownGlass,
    NoTotalReflection,
    RefractionNotCounted,
    MirrorsNotCounted,
    StraightThroughGlass,
    RefractedSqueezed,
    RefractedSpread,
    LastShareOnly,
    Clamped,
    Encoded,
    Gamma,
}

/// What goes wrong in a ray tracer: nothing, one slip, or two of them.
#[derive(Clone, Copy)]
pub struct Slips([Option<Slip>; 2]);

impl Slips {
    /// Whether this slip is among them.
    pub fn have(self, slip: Slip) -> bool {
        self.0.contains(&Some(slip))
    }

    /// What the first of them makes of something that it changes.
    pub fn make<T>(self, change: impl Fn(Slip) -> Option<T>) -> Option<T> {
        self.0.into_iter().flatten().find_map(change)
    }
}

/// The answer of a ray tracer with this slip.
pub fn answer(q: &Trace, slip: Slip) -> Rgb {
    let slips = changed(Slips([None; 2]), |slips| slips.0 = [Some(slip), slips.0[0]]);
    let depth = slips.make(|slip| match slip {
        Slip::OneSurfaceLess => Some(q.depth.saturating_sub(1)),
        Slip::OneSurfaceMore => Some(q.depth.saturating_add(1)),
        _ => None,
    });
    let tracer = Tracer::new(&q.scene, slips);
    let radiance = tracer.seen(&q.ray, depth.unwrap_or(q.depth));
    let shown = slips.make(|slip| match slip {
        Slip::Clamped => Some(tone::clamp(radiance)),
        Slip::Encoded => Some(radiance.map(tone::encode_srgb)),
        Slip::Gamma => Some(radiance.map(|v| v.max(0.0).powf(1.0 / 2.2))),
        _ => None,
    });
    shown.unwrap_or(radiance)
}

/// The answer in a scene without some of its forms.
pub(super) fn without(q: &Trace, missing: fn(&Form) -> bool) -> Rgb {
    Trace::misread(q, |q| q.scene.objects.retain(|o| !missing(&o.form)))
}
