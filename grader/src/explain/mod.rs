//! One question in full: what is asked, both answers and where they part, every step to the right one, and a drawing.
//!
//! A file per chapter has the steps of its exercises and their drawings; `EXPLAINERS` lists them.

pub mod account;
pub mod asked;
mod ch01_rays;
mod ch02_hdr;
mod ch03_sphere;
mod ch04_plane;
mod ch05_box;
mod ch06_triangle;
mod ch07_mesh;
mod ch08_grid;
mod ch09_two_level_grid;
mod ch10_octree;
mod ch11_bvh;
mod ch12_phong;
mod ch13_reflection;
mod ch14_refraction;
mod ch15_shadows;
mod ch16_soft_shadows;
mod ch17_rendering_equation;
mod ch18_environment;
mod ch19_depth_of_field;
mod ch20_panorama;
mod ch21_black_hole;
mod ch22_antialiasing;
mod ch23_adaptive;
mod ch24_wide_bvh;
mod ch25_capstone;
pub mod diagram;
mod nearest;
pub mod parting;
mod rays;
mod section;
pub mod slip;
mod square;
pub mod tell;
mod tree;
mod view;
pub mod way;

use diagram::Diagram;
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::{
    ch01_rays::{CameraRay, RayAt},
    ch02_hdr::{EncodeSrgb, Expose, ToneMap},
    ch03_sphere::{SolveQuadratic, SphereHit, SphereNormal},
    ch04_plane::PlaneHit,
    ch05_box::{BoundsOf, BoxClip},
    ch06_triangle::{TriangleHit, TriangleNormal},
    ch07_mesh::{InterpolateNormal, InterpolateTexture, MeshHit, VertexNormals},
    ch08_grid::{GridResolution, GridWalk, VoxelsOfTriangle},
    ch09_two_level_grid::{RefineCell, TwoLevelWalk},
    ch10_octree::{OctreeBuild, OctreeChild, OctreeWalk},
    ch11_bvh::{BvhBuild, BvhClosest, SahCost, SahSplit},
    ch12_phong::{BlinnPhongExercise, PhongExercise, PointLightExercise},
    ch13_reflection::Reflect,
    ch14_refraction::{Fresnel, Refract},
    ch15_shadows::{Lit, ShadowRay},
    ch16_soft_shadows::{SampleRect, SampleSphereLight, VisibleFraction},
    ch17_rendering_equation::{BrdfPhong, CosineHemisphere, ReflectedRadiance},
    ch18_environment::{DirectionToCube, DirectionToLatlong, EnvironmentPdf, SampleEnvironment},
    ch19_depth_of_field::{CircleOfConfusion, ConcentricDisk, ThinLensRay},
    ch20_panorama::PanoramaRay,
    ch21_black_hole::{DeflectionAngle, GeodesicStep},
    ch22_antialiasing::{
        Jittered, PixelAverage, PoissonDisk, RandomPattern, RegularGrid, RotatedGrid,
    },
    ch23_adaptive::{NeedsMore, SpendBudget},
    ch24_wide_bvh::{Collapse, WideClosest},
    ch25_capstone::Trace,
};
use raybook_workbook::row::{from_numbers, to_numbers};
use way::Way;

/// An exercise whose answers can be worked out on paper.
trait Explained: Exercise<Answer: 'static> + 'static {
    /// Answers the question in double precision, from the question alone, and writes down each step.
    fn work(&self, way: &mut Way) -> Self::Answer;

    /// The ways to the answer: the one that is told, and others that people go.
    const WAYS: &'static [fn(&Self, &mut Way) -> Self::Answer] = &[Self::work];

    /// Draws the question with both answers, where a drawing says more than numbers.
    fn draw(&self, _right: &Self::Answer, _yours: Option<&Self::Answer>) -> Option<Diagram> {
        None
    }
}

/// What a drawing shows, as rows of numbers.
#[derive(Clone, Copy, Debug)]
pub struct Shown<'a> {
    /// The question.
    pub question: &'a [f64],
    /// The right answer.
    pub right: &'a [f64],
    /// The student's answer, if there is one that can be read.
    pub yours: Option<&'a [f64]>,
}

/// The steps and drawings of an exercise whose types are forgotten.
#[derive(Debug)]
pub struct Explainer {
    /// The exercise's name.
    pub exercise: &'static str,
    /// How many ways there are to the answer.
    pub ways: usize,
    /// Goes the way of this number to the answer of a question, and writes its steps down.
    pub work: fn(usize, &[f64], &mut Way) -> Vec<f64>,
    /// The drawing, where one says more than numbers.
    pub draw: fn(Shown<'_>) -> Option<Diagram>,
}

impl Explainer {
    const fn of<E: Explained>() -> Self {
        Self {
            exercise: E::NAME,
            ways: E::WAYS.len(),
            work: |number, question, way| {
                to_numbers(&E::WAYS[number](&from_numbers::<E>(question), way))
            },
            draw: |Shown {
                       question,
                       right,
                       yours,
                   }| {
                let yours = yours.map(from_numbers::<E::Answer>);
                from_numbers::<E>(question).draw(&from_numbers(right), yours.as_ref())
            },
        }
    }
}

/// Every exercise with steps, in the order of the course.
pub static EXPLAINERS: &[Explainer] = &[
    Explainer::of::<RayAt>(),
    Explainer::of::<CameraRay>(),
    Explainer::of::<Expose>(),
    Explainer::of::<ToneMap>(),
    Explainer::of::<EncodeSrgb>(),
    Explainer::of::<SolveQuadratic>(),
    Explainer::of::<SphereHit>(),
    Explainer::of::<SphereNormal>(),
    Explainer::of::<PlaneHit>(),
    Explainer::of::<BoxClip>(),
    Explainer::of::<BoundsOf>(),
    Explainer::of::<TriangleHit>(),
    Explainer::of::<TriangleNormal>(),
    Explainer::of::<InterpolateNormal>(),
    Explainer::of::<InterpolateTexture>(),
    Explainer::of::<VertexNormals>(),
    Explainer::of::<MeshHit>(),
    Explainer::of::<GridResolution>(),
    Explainer::of::<VoxelsOfTriangle>(),
    Explainer::of::<GridWalk>(),
    Explainer::of::<RefineCell>(),
    Explainer::of::<TwoLevelWalk>(),
    Explainer::of::<OctreeChild>(),
    Explainer::of::<OctreeBuild>(),
    Explainer::of::<OctreeWalk>(),
    Explainer::of::<SahCost>(),
    Explainer::of::<SahSplit>(),
    Explainer::of::<BvhBuild>(),
    Explainer::of::<BvhClosest>(),
    Explainer::of::<PhongExercise>(),
    Explainer::of::<BlinnPhongExercise>(),
    Explainer::of::<PointLightExercise>(),
    Explainer::of::<Reflect>(),
    Explainer::of::<Refract>(),
    Explainer::of::<Fresnel>(),
    Explainer::of::<ShadowRay>(),
    Explainer::of::<Lit>(),
    Explainer::of::<SampleRect>(),
    Explainer::of::<SampleSphereLight>(),
    Explainer::of::<VisibleFraction>(),
    Explainer::of::<CosineHemisphere>(),
    Explainer::of::<BrdfPhong>(),
    Explainer::of::<ReflectedRadiance>(),
    Explainer::of::<DirectionToCube>(),
    Explainer::of::<DirectionToLatlong>(),
    Explainer::of::<SampleEnvironment>(),
    Explainer::of::<EnvironmentPdf>(),
    Explainer::of::<ConcentricDisk>(),
    Explainer::of::<ThinLensRay>(),
    Explainer::of::<CircleOfConfusion>(),
    Explainer::of::<PanoramaRay>(),
    Explainer::of::<GeodesicStep>(),
    Explainer::of::<DeflectionAngle>(),
    Explainer::of::<RegularGrid>(),
    Explainer::of::<RotatedGrid>(),
    Explainer::of::<RandomPattern>(),
    Explainer::of::<Jittered>(),
    Explainer::of::<PoissonDisk>(),
    Explainer::of::<PixelAverage>(),
    Explainer::of::<NeedsMore>(),
    Explainer::of::<SpendBudget>(),
    Explainer::of::<Collapse>(),
    Explainer::of::<WideClosest>(),
    Explainer::of::<Trace>(),
];

/// The steps and drawings of an exercise, if it has any.
pub fn find(exercise: &str) -> Option<&'static Explainer> {
    EXPLAINERS
        .iter()
        .find(|explainer| explainer.exercise == exercise)
}
