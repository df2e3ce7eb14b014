//! Ray tracers with a slip in one place: what they are asked.

use super::tracer::Tracer;
use crate::Graded;
use raybook::image::{rgb::Rgb, tone};
use raybook::scene::description::Form;
use raybook_workbook::exercises::ch25_capstone::Trace;

/// What a ray tracer does wrongly; each is explained by its mistake in `trace.rs`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slip {
    FirstForNearest,
    FarthestForNearest,
    OneSidedTriangles,
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

/// The answer of a ray tracer with this slip.
pub fn answer(q: &Trace, slip: Slip) -> Rgb {
    let depth = match slip {
        Slip::OneSurfaceLess => q.depth.saturating_sub(1),
        Slip::OneSurfaceMore => q.depth.saturating_add(1),
        _ => q.depth,
    };
    let tracer = Tracer::new(&q.scene, slip);
    let radiance = tracer.seen(&q.ray, depth);
    match slip {
        Slip::Clamped => tone::clamp(radiance),
        Slip::Encoded => radiance.map(tone::encode_srgb),
        Slip::Gamma => radiance.map(|v| v.max(0.0).powf(1.0 / 2.2)),
        _ => radiance,
    }
}

/// The answer in a scene without some of its forms.
pub(super) fn without(q: &Trace, missing: fn(&Form) -> bool) -> Rgb {
    Trace::misread(q, |q| q.scene.objects.retain(|o| !missing(&o.form)))
}
