//! Ray tracers with a slip in one place: what they are asked.

use super::tracer::Tracer;
use raybook::image::{rgb::Rgb, tone};
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
    NoFalloff,
    LampIsAPower,
    LampsTwiceAsBright,
    FalloffByDistance,
    FalloffByCube,
    NoCosine,
    ViewTurned,
    LightForMirrored,
    HalfVector,
    HighlightTimesCosine,
    NoHighlight,
    HighlightUnlit,
    NoShadows,
    ShadowsFromBeyondTheLamp,
    LightThroughGlass,
    LightThroughMirrors,
    LightThroughPlanes,
    LightThroughTriangles,
    ShadowEndsTheLoop,
    BelowTheSurface,
    RefractedFromTheWrongSide,
    MirroredFromTheWrongSide,
    FromTheSideAwayFromTheViewer,
    AlwaysFromOutside,
    FarOff,
    MirrorsWithoutColour,
    AmbientOnMirrors,
    NoBackdropInMirrors,
    OneSurfaceLess,
    OneSurfaceMore,
    BackdropAtTheEnd,
    HeightForShare,
    HeightAboveTheHorizon,
    IndexTurned,
    AlwaysEntering,
    AllRefracted,
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
