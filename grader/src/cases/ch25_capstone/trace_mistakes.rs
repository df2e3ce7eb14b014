//! `trace`: its mistakes.

use super::slip::{Slip, answer};
use crate::Mistake;
use raybook_workbook::exercises::ch25_capstone::Trace;

/// Whole ray tracers that are wrong in one place.
pub const MISTAKES: &[Mistake<Trace>] = &[
    Mistake {
        name: "takes the first thing of the list that is hit",
        hint: "Two things are in the ray's way, and the one that comes first in the list is behind the other: which is seen?",
        answer: |q| answer(q, Slip::FirstForNearest),
    },
    Mistake {
        name: "hits triangles from the front only",
        hint: "Walk round the triangle: is it there when you look from behind?",
        answer: |q| answer(q, Slip::OneSidedTriangles),
    },
    Mistake {
        name: "takes the parallelogram for the triangle",
        hint: "A hit in the plane can be right in u and right in v and still be outside: what do they have together?",
        answer: |q| answer(q, Slip::Parallelogram),
    },
    Mistake {
        name: "shades with a normal that points away from the viewer",
        hint: "From behind you see the other side of the surface: on which side of it is the lamp?",
        answer: |q| answer(q, Slip::NormalNotTurned),
    },
    Mistake {
        name: "forgets the ambient light",
        hint: "What is left where no lamp shines?",
        answer: |q| answer(q, Slip::NoAmbient),
    },
    Mistake {
        name: "adds the ambient light once for each lamp",
        hint: "Ambient light is there without any lamp: how often do you add it when there are two, and when there are none?",
        answer: |q| answer(q, Slip::AmbientForEachLamp),
    },
    Mistake {
        name: "only asks the first lamp",
        hint: "The light of all the lamps adds up.",
        answer: |q| answer(q, Slip::OneLamp),
    },
    Mistake {
        name: "forgets that light gets weaker with distance",
        hint: "The same lamp twice as far away: how much of its light arrives on a square metre?",
        answer: |q| answer(q, Slip::NoFalloff),
    },
    Mistake {
        name: "leaves the cosine out of the diffuse part",
        hint: "Light that comes aslant is spread over more surface.",
        answer: |q| answer(q, Slip::NoCosine),
    },
    Mistake {
        name: "looks for the highlight on the wrong side",
        hint: "V points from the surface to the viewer: does yours?",
        answer: |q| answer(q, Slip::ViewTurned),
    },
    Mistake {
        name: "takes Blinn's half vector for the highlight",
        hint: "The highlight asked for is Phong's, which is smaller: which two directions are compared in it?",
        answer: |q| answer(q, Slip::HalfVector),
    },
    Mistake {
        name: "throws no shadows",
        hint: "Before a lamp's light counts, ask whether anything is in its way.",
        answer: |q| answer(q, Slip::NoShadows),
    },
    Mistake {
        name: "lets what is beyond a lamp throw a shadow",
        hint: "Where does the way to the lamp end?",
        answer: |q| answer(q, Slip::ShadowsFromBeyondTheLamp),
    },
    Mistake {
        name: "lets a lamp's light pass through glass",
        hint: "Bent light would arrive elsewhere, so in this course glass is in the way like anything else.",
        answer: |q| answer(q, Slip::LightThroughGlass),
    },
    Mistake {
        name: "starts new rays just below the surface that they leave",
        hint: "What is the first thing that such a ray meets? Start it a little off the surface, on the side to which it leaves.",
        answer: |q| answer(q, Slip::BelowTheSurface),
    },
    Mistake {
        name: "forgets the colour of mirrors",
        hint: "Gold is yellow: what does a mirror do to what is seen in it?",
        answer: |q| answer(q, Slip::MirrorsWithoutColour),
    },
    Mistake {
        name: "shows no backdrop in mirrors and glass",
        hint: "A mirrored ray that meets nothing sees what any ray sees that meets nothing.",
        answer: |q| answer(q, Slip::NoBackdropInMirrors),
    },
    Mistake {
        name: "stops one surface too early",
        hint: "With depth 1 one surface is met, and shaded: when is it black?",
        answer: |q| answer(q, Slip::OneSurfaceLess),
    },
    Mistake {
        name: "goes on for one surface too many",
        hint: "With depth 0 nothing is met at all, and with depth 1 a mirror has nothing to show.",
        answer: |q| answer(q, Slip::OneSurfaceMore),
    },
    Mistake {
        name: "shows the backdrop where the depth ends",
        hint: "Beyond the last surface all is black, even where a ray would meet nothing.",
        answer: |q| answer(q, Slip::BackdropAtTheEnd),
    },
    Mistake {
        name: "turns the index of refraction round",
        hint: "From air into glass a ray bends towards the normal: does yours? And from glass into air?",
        answer: |q| answer(q, Slip::IndexTurned),
    },
    Mistake {
        name: "always takes the ray to enter the glass",
        hint: "Which index is on which side depends on the side from which the ray comes: what tells you, before you turn the normal?",
        answer: |q| answer(q, Slip::AlwaysEntering),
    },
    Mistake {
        name: "lets everything through glass that is not totally reflected",
        hint: "Glass mirrors a little of everything, and much of what comes along it: how much, say Fresnel's equations.",
        answer: |q| answer(q, Slip::AllRefracted),
    },
    Mistake {
        name: "forgets what is mirrored in glass",
        hint: "Of the two parts R and 1 − R you show one.",
        answer: |q| answer(q, Slip::NothingMirroredInGlass),
    },
    Mistake {
        name: "shows black where glass reflects totally",
        hint: "If nothing gets out, where does all the light go?",
        answer: |q| answer(q, Slip::NoTotalReflection),
    },
    Mistake {
        name: "cuts radiance off at 1",
        hint: "Radiance has no upper limit; only the display has.",
        answer: |q| answer(q, Slip::Clamped),
    },
    Mistake {
        name: "encodes the radiance for a display",
        hint: "The answer is linear radiance: neither gamma nor sRGB's code belongs here.",
        answer: |q| answer(q, Slip::Encoded),
    },
    Mistake {
        name: "raises the radiance to the power of 1/2.2",
        hint: "The answer is linear radiance: gamma belongs to the display.",
        answer: |q| answer(q, Slip::Gamma),
    },
];
