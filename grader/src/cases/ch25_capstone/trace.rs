//! `trace`: random questions, judge and mistakes.

use super::slip::{Slip, answer, without};
use super::tracer::is_from_behind;
use crate::{Flaw, Graded, Mistake, Picture, Verdict, judge, sample};
use glam::{Vec3, vec2, vec3};
use rand::RngExt;
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::light::point::PointLight;
use raybook::material::phong::Phong;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook::scene::{
    description::Backdrop, description::Description, description::Form, description::Matter,
    description::Object, four_scenes::ASPECT, four_scenes::FOUR,
};
use raybook_workbook::exercises::ch25_capstone::Trace;
use std::ptr;

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
fn pixel<const N: usize>(x: u32, y: u32) -> Trace {
    let staged = &FOUR[N];
    let [from, to] = staged.view;
    let film = vec2(
        (x as f32 + 0.5) / SIZE[0] as f32,
        (y as f32 + 0.5) / SIZE[1] as f32,
    );
    let camera = Pinhole::look_at(from, to, Vec3::Y, staged.focal_length, ASPECT);
    Trace {
        depth: staged.depth,
        ray: camera.expect("a stage has a view").central_ray(film),
        scene: (staged.scene)(),
    }
}

impl Graded for Trace {
    /// A new ray that starts 1 mm off its surface must not decide an answer, and each ball that it is mirrored by multiplies the
    /// difference by ten. Of coordinates of a metre these are 1 to 2 mm.
    const ULPS: i32 = 1 << 14;

    /// A floor, up to four balls that do not touch, a triangle behind them; one lamp or two; a ray to a ball.
    fn random(rng: &mut Pcg) -> Trace {
        let mut objects = vec![Object::plane(Dir3::Y, -1.2, matter(rng, false))];
        let mut places: Vec<_> = [(-1.2, -1.2), (1.2, -1.2), (-1.2, 1.2), (1.2, 1.2)].into();
        let mut target = Vec3::ZERO;
        for _ in 0..rng.random_range(1..=4) {
            let (x, z) = places.swap_remove(rng.random_range(0..places.len()));
            let center = vec3(x, 0.0, z) + sample::point(rng, 0.25);
            let center = center.map(round);
            target = center;
            objects.push(Object::sphere(
                center,
                number(rng, 0.5, 0.9),
                matter(rng, true),
            ));
        }
        let mut corner = |x, y| vec3(x, y, -3.0) + sample::point(rng, 0.8);
        let corners =
            [corner(-2.5, -1.0), corner(2.5, -1.0), corner(0.0, 3.0)].map(|p| p.map(round));
        objects.push(Object::triangle(corners, matter(rng, false)));
        let first = rng.random_range(0..objects.len());
        objects.rotate_left(first);
        let lamps = (0..rng.random_range(1..=2)).map(|_| PointLight {
            position: vec3(
                number(rng, -4.0, 4.0),
                number(rng, 3.0, 6.0),
                number(rng, 0.0, 5.0),
            ),
            intensity: colour(rng, 90.0),
        });
        let lamps = lamps.collect();
        let eye = vec3(
            number(rng, -2.0, 2.0),
            number(rng, 0.0, 2.5),
            number(rng, 4.5, 6.5),
        );
        Trace {
            depth: rng.random_range(2..=5),
            ray: sample::ray(eye, target + sample::point(rng, 0.6) - eye),
            scene: Description {
                ambient: colour(rng, 0.6),
                backdrop: Backdrop {
                    below: colour(rng, 1.0),
                    above: colour(rng, 1.0),
                },
                lamps,
                objects,
            },
        }
    }

    /// Whether a radiance is right.
    ///
    /// # Errors
    /// If a channel is too far off; then also what the ray meets first.
    fn judge(q: &Trace, golden: &Rgb, got: &Rgb) -> Verdict {
        let tolerance = |golden: f32| ABSOLUTE + RELATIVE * golden.abs();
        let channels = || golden.channels().into_iter().zip(got.channels());
        if channels().all(|(golden, got)| (golden - got).abs() <= tolerance(golden)) {
            return Ok(());
        }
        let ratio = got.luminance() / golden.luminance();
        let same_colour =
            channels().all(|(golden, got)| (ratio * golden - got).abs() <= 0.02 * got);
        let by_itself = answer(q, Slip::MirroredFromTheWrongSide);
        let near = |(own, got): (f32, f32)| (own - got).abs() <= tolerance(own);
        let meets_itself = by_itself
            .channels()
            .into_iter()
            .zip(got.channels())
            .all(near);
        let mirrors = q
            .scene
            .nearest(&q.ray)
            .is_some_and(|(object, _)| !matches!(object.matter, Matter::Phong(_)));
        let why = if meets_itself && mirrors {
            "your answer is what is seen if a new ray meets the surface that it leaves".to_owned()
        } else if *got == Rgb::BLACK {
            "your answer is black, and there is light".to_owned()
        } else if *golden == Rgb::BLACK {
            "everything should be black here".to_owned()
        } else if lit_by_nothing(q, got) && is_seen_from_behind(q) {
            "your answer is the ambient light alone, and you see the surface from behind, on the side away from its normal".to_owned()
        } else if lit_by_nothing(q, got) {
            "your answer is the ambient light alone: no lamp adds anything".to_owned()
        } else if same_colour && ratio > 0.0 {
            format!("the colour is right, but {ratio:.3} times as bright as it should be")
        } else {
            let wrong = ["red", "green", "blue"].into_iter().zip(channels());
            let whys = wrong.filter_map(|(name, (golden, got))| {
                judge::number_within(name, "", golden, got, tolerance(golden)).err()
            });
            whys.collect::<Vec<_>>().join(", ")
        };
        Err(format!("{why}; {}", first(q)))
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "ambient light alone, and you see the surface from behind",
            name: "does not turn the normal to the viewer where a surface that lamps light is seen from behind",
            hint: "From behind you see the other side of the surface: on which side of it is the lamp? And which of your vectors says which side you see?",
        },
        Flaw {
            complaint: "ambient light alone: no lamp",
            name: "lets no lamp's light arrive: the shadow ray meets the surface that it starts from, or the normal points away from the viewer",
            hint: "Where does the way to the lamp begin: on the surface, or a little off it, on the side of the lamp? From behind, has the normal been turned?",
        },
        Flaw {
            complaint: "meets the surface that it leaves",
            name: "lets new rays meet the surface that they leave, at least some of them",
            hint: "Rounding puts a point a hair above its surface or below it: what is the first thing that a ray from there meets? Start it a little off the surface, on the side to which it leaves.",
        },
        Flaw {
            complaint: "your answer is black",
            name: "returns black where there is light",
            hint: "Which of your conditions ends in black? Print the depth, and what the ray meets.",
        },
    ];

    /// Whole ray tracers that are wrong in one place.
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes the first thing of the list that is hit",
            hint: "Two things are in the ray's way, and the one that comes first in the list is behind the other: which is seen?",
            answer: |q| answer(q, Slip::FirstForNearest),
        },
        Mistake {
            name: "meets no planes",
            hint: "Which of the three shapes does your loop ask, and what does it do with the others?",
            answer: |q| without(q, |form| matches!(form, Form::Plane(_))),
        },
        Mistake {
            name: "meets no spheres",
            hint: "Which of the three shapes does your loop ask, and what does it do with the others?",
            answer: |q| without(q, |form| matches!(form, Form::Sphere(_))),
        },
        Mistake {
            name: "meets no triangles",
            hint: "Which of the three shapes does your loop ask, and what does it do with the others?",
            answer: |q| without(q, |form| matches!(form, Form::Triangle(_))),
        },
        Mistake {
            name: "takes the farthest thing that is hit",
            hint: "Two things are in the ray's way: which of them hides the other, that of the smaller t or that of the larger?",
            answer: |q| answer(q, Slip::FarthestForNearest),
        },
        Mistake {
            name: "hits triangles from the front only",
            hint: "Walk round the triangle: is it there when you look from behind?",
            answer: |q| answer(q, Slip::OneSidedTriangles),
        },
        Mistake {
            name: "takes the parallelogram for the triangle",
            hint: "A hit can have its u and its v between 0 and 1 and still be outside: which condition must u and v meet together?",
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
            hint: "The light of all the lamps adds up: how many lamps does your loop ask?",
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
            name: "starts shadow rays, and no others, just below the surface that they leave, which is in their way itself",
            hint: "What is the first thing that such a ray meets? Start it a little off the surface, on the side to which it leaves.",
            answer: |q| answer(q, Slip::ShadowRaysFromBelow),
        },
        Mistake {
            name: "starts shadow rays and mirrored rays on the side of the surface away from the viewer",
            hint: "What is the first thing that such a ray meets? Start it a little off the surface, on the side to which it leaves.",
            answer: |q| answer(q, Slip::FromTheSideAwayFromTheViewer),
        },
        Mistake {
            name: "starts shadow rays and mirrored rays on the outside of the surface, even if the viewer is inside",
            hint: "A viewer inside of a ball, or below a floor: on which side do the rays leave that you see?",
            answer: |q| answer(q, Slip::AlwaysFromOutside),
        },
        Mistake {
            name: "asks no further lamp after one that is in the shadow",
            hint: "One lamp is hidden: what do you know of the next one? Which word leaves a loop, and which only its present round?",
            answer: |q| answer(q, Slip::ShadowEndsTheLoop),
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
            hint: "Glass mirrors a little of the light that comes straight, and most of the light that grazes it: which equations say how much?",
            answer: |q| answer(q, Slip::AllRefracted),
        },
        Mistake {
            name: "forgets what is mirrored in glass",
            hint: "Glass shows two parts, R and 1 − R: which of them does yours show?",
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
        Mistake {
            name: "takes the direction's y itself for the share of the backdrop above",
            hint: "The direction's y goes from −1 to 1: from where to where must a share go?",
            answer: |q| answer(q, Slip::HeightForShare),
        },
        Mistake {
            name: "adds the mirrored and the refracted light of glass without their shares",
            hint: "Glass splits the light: can more leave its surface than arrives?",
            answer: |q| answer(q, Slip::NoShares),
        },
        Mistake {
            name: "exchanges what glass mirrors and what it lets through",
            hint: "Look straight into a window: do you see yourself, or what is behind it?",
            answer: |q| answer(q, Slip::SharesExchanged),
        },
        Mistake {
            name: "uses Fresnel's equations as if the light always came from outside",
            hint: "Inside of the glass, which index is on the side from which the ray comes?",
            answer: |q| answer(q, Slip::FresnelFromOutside),
        },
        Mistake {
            name: "starts new rays too far off the surface that they leave",
            hint: "A step of 10 cm: what may lie in between?",
            answer: |q| answer(q, Slip::FarOff),
        },
        Mistake {
            name: "lets light get weaker with the distance, not its square",
            hint: "The same lamp twice as far away: on how much more surface is its light spread?",
            answer: |q| answer(q, Slip::FalloffByDistance),
        },
        Mistake {
            name: "multiplies the highlight by the cosine of the light",
            hint: "In Phong's formula, which of the two terms has the factor L·N?",
            answer: |q| answer(q, Slip::HighlightTimesCosine),
        },
        Mistake {
            name: "leaves out the highlight",
            hint: "Phong's formula is a sum: how many terms has yours?",
            answer: |q| answer(q, Slip::NoHighlight),
        },
        Mistake {
            name: "forgets the lamp's light in the highlight",
            hint: "Switch the lamp off: is your highlight gone?",
            answer: |q| answer(q, Slip::HighlightUnlit),
        },
        Mistake {
            name: "exchanges the two indices in Fresnel's equations",
            hint: "Of the two indices, which one is on the side from which the light comes?",
            answer: |q| answer(q, Slip::FresnelTurned),
        },
        Mistake {
            name: "gives Fresnel's equations a cosine below 0",
            hint: "The ray runs against the normal: what is the sign of their dot product? How bright is glass that you look at straight?",
            answer: |q| answer(q, Slip::FresnelBackwards),
        },
        Mistake {
            name: "takes Schlick's approximation for Fresnel's equations",
            hint: "Look from inside the glass, just before all is reflected: how far is the approximation from the equations?",
            answer: |q| answer(q, Slip::Schlick),
        },
        Mistake {
            name: "takes the direction's y, and 0 below the horizon, for the share of the backdrop above",
            hint: "The direction's y goes from −1 to 1: from where to where must a share go?",
            answer: |q| answer(q, Slip::HeightAboveTheHorizon),
        },
        Mistake {
            name: "takes the lamp's intensity for a power, and divides by 4π",
            hint: "The intensity is given per steradian already: is there a 4π left to divide by?",
            answer: |q| answer(q, Slip::LampIsAPower),
        },
        Mistake {
            name: "counts the lamps' light twice",
            hint: "Which factor stands before the lamp's light?",
            answer: |q| answer(q, Slip::LampsTwiceAsBright),
        },
        Mistake {
            name: "mirrors half of the light in glass, whatever the angle",
            hint: "Look straight into a window, and along it: do you see as much of yourself?",
            answer: |q| answer(q, Slip::HalfMirrored),
        },
        Mistake {
            name: "takes Rs for the share that glass mirrors",
            hint: "The light here is not polarised: of which two shares is R the mean?",
            answer: |q| answer(q, Slip::OnePolarisation),
        },
        Mistake {
            name: "takes 1.5 for the index of any glass",
            hint: "Each glass has an index of its own: where does it stand?",
            answer: |q| answer(q, Slip::AlwaysCrownGlass),
        },
        Mistake {
            name: "starts the refracted ray on the side of the surface from which the ray came",
            hint: "Behind the surface the ray goes on: on which side of it must it start, so that it does not meet it again?",
            answer: |q| answer(q, Slip::RefractedFromTheWrongSide),
        },
        Mistake {
            name: "starts mirrored rays just below the surface that they leave",
            hint: "What is the first thing that such a ray meets? Start it a little off the surface, on the side to which it leaves.",
            answer: |q| answer(q, Slip::MirroredFromTheWrongSide),
        },
        Mistake {
            name: "never turns the normal to the viewer, for no material",
            hint: "From inside of a ball its normal points away from you: what becomes of a cosine, and of the start of a new ray?",
            answer: |q| answer(q, Slip::NormalNeverTurned),
        },
        Mistake {
            name: "lets a lamp's light pass through mirrors",
            hint: "The back of a mirror is dark: does light come through?",
            answer: |q| answer(q, Slip::LightThroughMirrors),
        },
        Mistake {
            name: "lets a lamp's light pass through planes",
            hint: "A wall between the lamp and the floor: does light come through? Which of the three shapes does your loop ask?",
            answer: |q| answer(q, Slip::LightThroughPlanes),
        },
        Mistake {
            name: "lets a lamp's light pass through triangles",
            hint: "A sail between the lamp and the floor: does light come through? Which of the three shapes does your loop ask?",
            answer: |q| answer(q, Slip::LightThroughTriangles),
        },
        Mistake {
            name: "takes the direction to the light for its mirror direction in the highlight",
            hint: "Where do you have to stand to see a lamp in a polished floor: beside the lamp?",
            answer: |q| answer(q, Slip::LightForMirrored),
        },
        Mistake {
            name: "lets light get weaker with the cube of the distance",
            hint: "How does the area of a sphere grow with its radius? Is a vector that you divide by normalised already?",
            answer: |q| answer(q, Slip::FalloffByCube),
        },
        Mistake {
            name: "lets glass mirror the share that it mirrors straight ahead, whatever the angle",
            hint: "Look straight into a window, and along it: do you see as much of yourself?",
            answer: |q| answer(q, Slip::MirroredAsFromStraightAbove),
        },
        Mistake {
            name: "lets every glass mirror 4 %, whatever its index and the angle",
            hint: "Which glass mirrors 4 %, and from where do you look at it? By which formula do angle and index come in?",
            answer: |q| answer(q, Slip::FourPercentMirrored),
        },
        Mistake {
            name: "adds the ambient light to what a mirror shows",
            hint: "Which of the three materials has a share of ambient light, and which show only what others send?",
            answer: |q| answer(q, Slip::AmbientOnMirrors),
        },
        Mistake {
            name: "weighs what a ray sees by the share of the last surface only, not by those of all surfaces before",
            hint: "A mirror in a mirror: two shares of 0.8 leave 0.64 of the light. What does a ray of yours know of the shares before?",
            answer: |q| answer(q, Slip::LastShareOnly),
        },
        Mistake {
            name: "does not count the surfaces that a refracted ray has met",
            hint: "A ray enters a ball of glass and leaves it: how many surfaces are that, and how many does your depth count?",
            answer: |q| answer(q, Slip::RefractionNotCounted),
        },
        Mistake {
            name: "does not count the mirrors that a ray has met",
            hint: "Two mirrors face each other: when does your ray end?",
            answer: |q| answer(q, Slip::MirrorsNotCounted),
        },
        Mistake {
            name: "lets light get weaker with the whole way, from the lamp over the surface to the viewer",
            hint: "Step back from a wall in the light of a lamp: does it become darker?",
            answer: |q| answer(q, Slip::FalloffUpToTheViewer),
        },
        Mistake {
            name: "shows black, without the ambient light, where a lamp is hidden",
            hint: "In the shadow of one lamp, which light still arrives?",
            answer: |q| answer(q, Slip::ShadowIsBlack),
        },
        Mistake {
            name: "shows black where a ray meets nothing",
            hint: "What does a ray see that meets nothing?",
            answer: |q| answer(q, Slip::NoBackdrop),
        },
        Mistake {
            name: "divides the diffuse coefficient by π",
            hint: "The coefficient is given per steradian: is a reflectance still to be made a BRDF?",
            answer: |q| answer(q, Slip::DiffuseOverPi),
        },
        Mistake {
            name: "lets light go straight on through glass, without bending it",
            hint: "Look through a ball of glass: is what lies behind it where you see it?",
            answer: |q| answer(q, Slip::StraightThroughGlass),
        },
        Mistake {
            name: "leaves the highlight in the shadow",
            hint: "Hide the lamp: which of its two terms can still be seen?",
            answer: |q| answer(q, Slip::HighlightInTheShadow),
        },
        Mistake {
            name: "takes the mean of the lamps' light, not their sum",
            hint: "Switch on a second lamp: does the first one become darker?",
            answer: |q| answer(q, Slip::LampsAveraged),
        },
        Mistake {
            name: "shows the ambient light where the depth ends",
            hint: "How bright is all beyond the last surface that may be met?",
            answer: |q| answer(q, Slip::AmbientAtTheEnd),
        },
        Mistake {
            name: "takes the direction's y without its sign for the share of the backdrop above",
            hint: "What is seen straight below: the colour below, or the one above?",
            answer: |q| answer(q, Slip::HeightWithoutSign),
        },
        Mistake {
            name: "shows nothing but the backdrop in mirrors",
            hint: "A ball stands before the mirror: what does the mirrored ray meet?",
            answer: |q| answer(q, Slip::MirrorsShowTheBackdrop),
        },
        Mistake {
            name: "makes the lamps grey, as bright as their luminance",
            hint: "A red lamp on a white wall: which colour has the wall?",
            answer: |q| {
                Self::misread(q, |q| {
                    for lamp in &mut q.scene.lamps {
                        lamp.intensity = Rgb::gray(lamp.intensity.luminance());
                    }
                })
            },
        },
        Mistake {
            name: "only asks the nearest lamp",
            hint: "The light of all the lamps adds up: how many lamps does your loop ask?",
            answer: |q| answer(q, Slip::NearestLamp),
        },
        Mistake {
            name: "lets a lamp's light pass through spheres",
            hint: "A ball between the lamp and the floor: does light come through? Which of the three shapes does your loop ask?",
            answer: |q| answer(q, Slip::LightThroughSpheres),
        },
        Mistake {
            name: "lets everything through glass that comes from inside and is not totally reflected",
            hint: "Look out of the water at a steep angle: is nothing of the water seen in its surface?",
            answer: |q| answer(q, Slip::AllRefractedFromInside),
        },
        Mistake {
            name: "takes the lamp's position for the direction to it",
            hint: "Move the surface, and not the lamp: does the direction to the lamp change?",
            answer: |q| answer(q, Slip::PositionForDirection),
        },
        Mistake {
            name: "makes mirrors grey, as bright as their share's luminance",
            hint: "A golden mirror: which colour has what is seen in it?",
            answer: |q| {
                Self::misread(q, |q| {
                    for object in &mut q.scene.objects {
                        if let Matter::Mirror(mirror) = &mut object.matter {
                            mirror.share = Rgb::gray(mirror.share.luminance());
                        }
                    }
                })
            },
        },
        Mistake {
            name: "multiplies what glass lets through by (n₁/n₂)², as of light that is squeezed into a narrower cone",
            hint: "The task's rule for glass has two shares, which add up to 1: which factor is in yours besides?",
            answer: |q| answer(q, Slip::RefractedSqueezed),
        },
        Mistake {
            name: "multiplies what glass lets through by (n₂/n₁)², as of light that is spread from a narrower cone",
            hint: "The task's rule for glass has two shares, which add up to 1: which factor is in yours besides?",
            answer: |q| answer(q, Slip::RefractedSpread),
        },
        Mistake {
            name: "takes the direction's angle, not its y, for the share of the backdrop above: 0 straight below, ½ on the horizon, 1 straight above",
            hint: "A ray goes up at 30°, and its y is ½: which of the two numbers does the backdrop's rule take?",
            answer: |q| answer(q, Slip::AngleForHeight),
        },
        Mistake {
            name: "takes the angle above the horizon over 90°, and 0 below the horizon, for the share of the backdrop above",
            hint: "A ray goes up at 30°, and its y is ½: which of the two numbers does the backdrop's rule take? And which share is seen on the horizon?",
            answer: |q| answer(q, Slip::AngleAboveTheHorizon),
        },
        Mistake {
            name: "hits triangles from the front only, with shadow rays too",
            hint: "Walk round the triangle: is it there when you look from behind? Does it throw a shadow there?",
            answer: |q| answer(q, Slip::OneSidedTrianglesInShadowsToo),
        },
        Mistake {
            name: "hits planes from the front only",
            hint: "Look at the plane from its other side: is it there? Which sign has the cosine then?",
            answer: |q| answer(q, Slip::OneSidedPlanes),
        },
        Mistake {
            name: "hits planes from the front only, with shadow rays too",
            hint: "Look at the plane from its other side: is it there? Does it throw a shadow there?",
            answer: |q| answer(q, Slip::OneSidedPlanesInShadowsToo),
        },
        Mistake {
            name: "shows black in mirrors from behind",
            hint: "The normal may point away from the viewer: does a mirror stop mirroring there?",
            answer: |q| answer(q, Slip::MirrorsBlackFromBehind),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[
        picture::<0>(),
        picture::<1>(),
        picture::<2>(),
        picture::<3>(),
    ];
}

/// A number with two digits after the point, as people write it.
fn round(v: f32) -> f32 {
    (100.0 * v).round() / 100.0
}

fn number(rng: &mut Pcg, min: f32, max: f32) -> f32 {
    round(sample::number(rng, min, max))
}

fn colour(rng: &mut Pcg, max: f32) -> Rgb {
    let mut channel = || number(rng, 0.1 * max, max);
    Rgb::new(channel(), channel(), channel())
}

fn matter(rng: &mut Pcg, glassy: bool) -> Matter {
    match rng.random_range(0..10) {
        0 | 1 => Matter::mirror(colour(rng, 1.0)),
        2..5 if glassy => Matter::glass(number(rng, 1.2, 1.8)),
        _ => Matter::Phong(Phong {
            ambient: colour(rng, 0.3),
            diffuse: colour(rng, 0.3),
            specular: colour(rng, 0.3),
            exponent: number(rng, 2.0, 30.0),
        }),
    }
}

/// A channel may differ by this fraction of its value …
///
/// Measured over 2070 cases by six right methods: leaving out what counts for less than 1/512 is worst, and 3.6 times
/// nearer than this; starts 1 mm off the surface are 5 times nearer, double precision by other formulas 300 times.
const RELATIVE: f32 = 0.01;

/// … and this much.
const ABSOLUTE: f32 = 0.005;

/// Whether an answer is what Phong's surface shows without a lamp.
fn lit_by_nothing(q: &Trace, got: &Rgb) -> bool {
    let nearest = q.scene.nearest(&q.ray);
    nearest.is_some_and(|(object, _)| match &object.matter {
        Matter::Phong(phong) => {
            let ambient = (phong.ambient * q.scene.ambient).channels();
            let pairs = ambient.into_iter().zip(got.channels());
            pairs.into_iter().all(|(a, b)| (a - b).abs() <= 1e-3 * a)
        }
        _ => false,
    })
}

/// Whether the ray comes from the side away from which the normal of what it meets first points.
fn is_seen_from_behind(q: &Trace) -> bool {
    let nearest = q.scene.nearest(&q.ray);
    nearest.is_some_and(|(object, hit)| is_from_behind(object, &q.ray, &hit))
}

/// What the ray meets first.
fn first(q: &Trace) -> String {
    if q.depth == 0 {
        return "no surface may be met at depth 0".to_owned();
    }
    let Some((object, hit)) = q.scene.nearest(&q.ray) else {
        return "the ray meets nothing and sees the backdrop".to_owned();
    };
    let before = q.scene.objects.iter().take_while(|o| !ptr::eq(*o, object));
    let i = before.count();
    let form = match object.form {
        Form::Sphere(_) => "sphere",
        Form::Plane(_) => "plane",
        Form::Triangle(_) => "triangle",
    };
    let matter = match object.matter {
        Matter::Phong(_) => "of Phong's material",
        Matter::Mirror(_) => "that is a mirror",
        Matter::Glass(_) => "of glass",
    };
    format!(
        "the ray first meets objects[{i}], a {form} {matter}, at t = {:.3}",
        hit.t
    )
}
