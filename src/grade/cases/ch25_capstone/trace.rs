//! `trace`: its pictures, judge and mistakes.

use super::glass_cases::{mirrors, refracting};
use super::light_cases::{lamps, shadows_and_sides};
use super::slip::{Slip, answer};
use super::{random, trace_judge};
use crate::camera::pinhole::Pinhole;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict};
use crate::image::rgb::Rgb;
use crate::math::pcg::Pcg;
use crate::scene::four_scenes::{ASPECT, FOUR};
use crate::workbook::exercises::ch25_capstone::{Trace, TraceQuestion};
use glam::{Vec3, vec2};

/// Columns and rows of each picture.
const SIZE: [u32; 2] = [72, 48];

/// The picture of scene number N.
const fn picture<const N: usize>() -> Picture<Trace> {
    Picture {
        name: FOUR[N].name,
        width: SIZE[0],
        height: SIZE[1],
        alt: FOUR[N].alt,
        question: pixel::<N>,
        colour: |_, radiance| *radiance,
    }
}

/// What the middle of a pixel of scene number N asks.
fn pixel<const N: usize>(x: u32, y: u32) -> TraceQuestion {
    let staged = &FOUR[N];
    let [from, to] = staged.view;
    let film = vec2(
        (x as f32 + 0.5) / SIZE[0] as f32,
        (y as f32 + 0.5) / SIZE[1] as f32,
    );
    let camera = Pinhole::look_at(from, to, Vec3::Y, staged.focal_length, ASPECT);
    TraceQuestion {
        depth: staged.depth,
        ray: camera.expect("a stage has a view").ray_through(film),
        scene: (staged.scene)(),
    }
}

impl Graded for Trace {
    /// A new ray that starts 1 mm off its surface must not decide an answer, and each ball that it is mirrored by multiplies the
    /// difference by ten. Of coordinates of a metre these are 1 to 2 mm.
    const ULPS: i32 = 1 << 14;

    const PICTURES: &'static [Picture<Self>] = &[
        picture::<0>(),
        picture::<1>(),
        picture::<2>(),
        picture::<3>(),
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
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
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edges = [lamps(), shadows_and_sides(), mirrors(), refracting()];
        edges.into_iter().flatten().collect()
    }

    fn random(rng: &mut Pcg) -> TraceQuestion {
        random::random(rng)
    }

    fn judge(q: &TraceQuestion, golden: &Rgb, got: &Rgb) -> Verdict {
        trace_judge::judge(q, golden, got)
    }
}
