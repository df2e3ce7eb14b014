//! One question in full: what is asked, both answers and where they part, every step to the right one, and a drawing.
//!
//! A file per chapter has the steps of its exercises and their drawings; `explainers!` lists them.

pub mod account;
pub mod asked;
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

/// The modules, and the list of the exercises with steps, in the order of the course.
macro_rules! explainers {
    ($($chapter:ident: $($exercise:ident),+;)+) => {
        $(mod $chapter;)+

        /// Every exercise with steps, in the order of the course.
        pub static EXPLAINERS: &[Explainer] =
            &[$($(Explainer::of::<raybook_workbook::exercises::$chapter::$exercise>()),+),+];
    };
}

explainers! {
    ch01_rays: RayAt, CameraRay;
    ch02_hdr: Expose, ToneMap, EncodeSrgb;
    ch03_sphere: SolveQuadratic, SphereHit, SphereNormal;
    ch04_plane: PlaneHit;
    ch05_box: BoxClip, BoundsOf;
    ch06_triangle: TriangleHit, TriangleNormal;
    ch07_mesh: InterpolateNormal, InterpolateTexture, VertexNormals, MeshHit;
    ch08_grid: GridResolution, VoxelsOfTriangle, GridWalk;
    ch09_two_level_grid: RefineCell, TwoLevelWalk;
    ch10_octree: OctreeChild, OctreeBuild, OctreeWalk;
    ch11_bvh: SahCost, SahSplit, BvhBuild, BvhClosest;
    ch12_phong: PhongExercise, BlinnPhongExercise, PointLightExercise;
    ch13_reflection: Reflect;
    ch14_refraction: Refract, Fresnel;
    ch15_shadows: ShadowRay, Lit;
    ch16_soft_shadows: SampleRect, SampleSphereLight, VisibleFraction;
    ch17_rendering_equation: CosineHemisphere, BrdfPhong, ReflectedRadiance;
    ch18_environment: DirectionToCube, DirectionToLatlong, SampleEnvironment, EnvironmentPdf;
    ch19_depth_of_field: ConcentricDisk, ThinLensRay, CircleOfConfusion;
    ch20_panorama: PanoramaRay;
    ch21_black_hole: GeodesicStep, DeflectionAngle;
    ch22_antialiasing: RegularGrid, RotatedGrid, RandomPattern, Jittered, PoissonDisk, PixelAverage;
    ch23_adaptive: NeedsMore, SpendBudget;
    ch24_wide_bvh: Collapse, WideClosest;
    ch25_capstone: Trace;
}

/// The steps and drawings of an exercise, if it has any.
pub fn find(exercise: &str) -> Option<&'static Explainer> {
    EXPLAINERS
        .iter()
        .find(|explainer| explainer.exercise == exercise)
}
