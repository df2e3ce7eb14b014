//! Both octrees.

use arctk::dom::{Surface, Tree, TreeBuilder};
use arctk::geom::{Mesh as Triangles, Triangle};
use nalgebra::{Point3, Unit, Vector3};
use raybook::accel::{Accel, octree::Octree};
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::mesh::{Facet, Mesh};

/// The distance of a miss.
pub(crate) const MISS: f64 = f64::INFINITY;

/// Distances of the nearest hits, as raybook's octree finds them.
pub(crate) fn ours(octree: &Octree<Facet>, rays: &[Ray]) -> Vec<f64> {
    let nearest = |ray: &Ray| {
        let hit = octree.closest(ray, Interval::AHEAD);
        hit.map_or(MISS, |(_, hit)| hit.t.into())
    };
    rays.iter().map(nearest).collect()
}

/// The octree of `arctk`, over surfaces that it borrows.
pub(crate) struct Theirs<'a> {
    tree: Tree<'a, ()>,
    /// How far a ray is moved on from a cell into the next, in metres.
    step: f64,
}

/// The mesh as `arctk` takes it. A triangle without a surface would have no normal, and no ray hits it.
pub(crate) fn surface(mesh: &Mesh) -> Surface<'static, ()> {
    let point = |i: u32| {
        let p = mesh.positions()[i as usize];
        Point3::new(p.x.into(), p.y.into(), p.z.into())
    };
    let triangle = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(point);
        let normal: Vector3<f64> = (b - a).cross(&(c - a));
        let normal = Unit::try_new(normal, 0.0)?;
        Some(Triangle::new([a, b, c], [normal; 3]))
    };
    let triangles = mesh.triangles().iter().filter_map(triangle).collect();
    Surface::new(Triangles::new(triangles), &())
}

/// How finely `arctk` divides.
#[derive(Clone, Copy)]
pub(crate) struct Settings {
    /// Number of triangles up to which a cell is not divided.
    pub leaf: usize,
    /// Maximum number of levels.
    pub levels: u32,
}

/// The settings that are tried: those with which it is fastest take part in the race.
pub(crate) const SETTINGS: [Settings; 7] = [
    Settings {
        leaf: 4,
        levels: 10,
    },
    Settings { leaf: 8, levels: 8 },
    Settings {
        leaf: 8,
        levels: 10,
    },
    Settings {
        leaf: 16,
        levels: 8,
    },
    Settings {
        leaf: 16,
        levels: 10,
    },
    Settings {
        leaf: 32,
        levels: 10,
    },
    Settings {
        leaf: 64,
        levels: 10,
    },
];

impl<'a> Theirs<'a> {
    /// The tree over a surface of this radius, in metres.
    pub(crate) fn new(
        surfaces: &'a [Surface<'static, ()>],
        radius: f64,
        settings: Settings,
    ) -> Self {
        /// Parts of the radius: more than rounding in double precision does, and less than a triangle.
        const STEP: f64 = 1e-7;
        let builder = TreeBuilder {
            tar_tris: settings.leaf,
            max_depth: settings.levels,
            padding: STEP * radius,
        };
        Self {
            tree: builder.build(surfaces),
            step: STEP * radius,
        }
    }

    /// Distances of the nearest hits.
    pub(crate) fn nearest(&self, rays: &[Ray]) -> Vec<f64> {
        let nearest = |ray: &Ray| {
            let (o, d) = (ray.origin, *ray.direction);
            let o = Point3::new(o.x.into(), o.y.into(), o.z.into());
            let d = Vector3::new(d.x.into(), d.y.into(), d.z.into());
            let ray = arctk::rt::Ray::new(o, Unit::new_normalize(d));
            let hit = self.tree.scan(ray, self.step, f64::MAX);
            hit.map_or(MISS, |hit| hit.dist)
        };
        rays.iter().map(nearest).collect()
    }
}
