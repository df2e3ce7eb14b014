//! raybook: a ray tracer to read, and the library of a course. One idea is one file.
//!
//! Shapes, lights, materials, cameras and accelerators are types that implement the few functions of a trait. A film asks for
//! the radiance of each of its samples, and an integrator follows the rays. What a ray tracer needs is public; [`inside`] is
//! for the course.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ball = Thing::new(Sphere::new(Vec3::ZERO, 1.0), Conductor(Metal::GOLD));
//! let scene = Scene::new(vec![ball], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
//! let film = Film::new(9, 9, 4); // 9 × 9 pixels, with 4 samples each
//! let camera = Pinhole::look_at(vec3(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y, focal_length(40.0), film.aspect())?;
//! let picture = film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
//! let gold = picture.at(4, 4);
//! assert!(gold.r > gold.g && gold.g > gold.b, "gold reflects most of the red light, and least of the blue light");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The features `threads`, `files` and `mmap` are on by default. Without them there is one thread, and there are no files and no
//! large pages, but the results are the same: so the library also runs in a browser.
//!
//! # Conventions
//!
//! The world is right-handed, y points up, lengths are metres, from 1e-9 to 1e9 (the [domain](math::domain)), numbers are `f32`.
//! A [`Dir3`](math::dir3::Dir3) has length 1, so a ray's parameter t is a distance. A miss is `None`. Radiance is an
//! [`Rgb`](image::rgb::Rgb), linear and without an upper limit. Every random number follows from a seed: the same seed gives the
//! same picture, bit for bit, whatever the number of threads. A path names its file: `shape::sphere::Sphere` is in
//! `src/shape/sphere.rs`.
//!
//! # The map of floors
//!
//! A module uses only modules on lower floors, or to its left on its own floor (a test reads this table and checks it).
//!
//! | floor | modules |
//! |---|---|
//! | 0 | threads, vectors, memory, store, math |
//! | 1 | image |
//! | 2 | shape, sample |
//! | 3 | accel |
//! | 4 | light, material, scene |
//! | 5 | camera |
//! | 6 | render |
//! | 7 | prelude |
//!
//! # Where is what
//!
//! | what | where in `src/` |
//! |---|---|
//! | what most programs use, in one line | `prelude.rs` |
//! | rays, unit directions, intervals of distances along a ray | `math/ray.rs` `math/dir3.rs` `math/interval.rs` |
//! | boxes, and the clipping of a ray by a box (slabs) | `math/aabb.rs` `math/slab.rs` |
//! | the lengths for which every answer holds | `math/domain.rs` |
//! | the quadratic equation without cancellation | `math/quadratic.rs` |
//! | random numbers: a stream for each pixel | `math/pcg.rs` |
//! | sampling a tabulated density | `math/piecewise.rs` |
//! | radiance, exposure, tone curves, sRGB | `image/rgb.rs` `image/tone.rs` |
//! | EXR, HDR and PNG files | `image/file.rs` |
//! | files that appear whole or not at all, and their maximum size | `store.rs` `memory.rs` |
//! | pictures looked up between their pixels, and blurred: mip maps for textures | `image/mip.rs` |
//! | denoising | `image/denoise/mod.rs` `render/guides.rs` |
//! | the width of a ray, which tells how much a texture is blurred (ray cones) | `render/cone.rs` |
//! | the difference of two pictures | `image/compare.rs` `image/rms.rs` |
//! | what a shape must answer; leaving a surface without hitting it again | `shape/mod.rs` |
//! | sphere, plane, box | `shape/sphere.rs` `shape/plane.rs` `shape/cuboid.rs` |
//! | triangle: Möller–Trumbore, plane first, determinants, watertight | `shape/triangle.rs` `shape/triangle_by_plane.rs` `shape/triangle_by_determinants.rs` `shape/triangle_watertight.rs` |
//! | instances: a shape at another place | `shape/instance.rs` |
//! | meshes, their normals and texture coordinates, the shadow terminator; OBJ, STL and PLY files | `shape/mesh.rs` `shape/attributes.rs` `shape/mesh_file.rs` |
//! | flat and smooth meshes; normal maps | `shape/mesh_looks.rs` `shape/normal_map.rs` |
//! | Bézier patches and the teapot | `shape/bezier.rs` `shape/teapot.rs` |
//! | sampling patterns of a pixel | `sample/pattern/mod.rs` |
//! | filters | `sample/filter.rs` |
//! | the random numbers of a sample, pair by pair: Sobol's, or those of a pattern | `sample/even.rs` `sample/padded.rs` |
//! | sampling a disc, a polygon, a hemisphere | `sample/disk.rs` `sample/polygon.rs` `sample/hemisphere.rs` |
//! | what an accelerator must answer; counting its work | `accel/mod.rs` |
//! | linear search | `accel/list.rs` |
//! | grid, two-level grid, the walk from cell to cell | `accel/grid/mod.rs` `accel/two_level_grid/mod.rs` `accel/walk.rs` |
//! | octree | `accel/octree/mod.rs` |
//! | bounding volume hierarchy, the surface-area heuristic | `accel/bvh/mod.rs` `accel/bvh/build/cost.rs` |
//! | wide BVH: eight boxes at once, vector instructions, spatial splits | `accel/wide_bvh/mod.rs` `accel/wide_bvh/avx2.rs` `accel/wide_bvh/avx512.rs` `accel/wide_bvh/spatial/mod.rs` |
//! | what a light must answer; point, directional, rectangular and spherical lights | `light/mod.rs` `light/point.rs` `light/directional.rs` `light/rect_light.rs` `light/sphere_light.rs` |
//! | light from everywhere: cube maps and sphere maps | `light/environment/mod.rs` |
//! | what a material must answer, and its lobes; Phong, Blinn, mirror, glass | `material/mod.rs` `material/phong.rs` `material/blinn_phong.rs` `material/mirror.rs` `material/glass.rs` |
//! | Snell's law, Fresnel's equations | `material/refract.rs` `material/fresnel.rs` |
//! | matte and glossy surfaces that conserve energy and are reciprocal: Lambert, modified Phong, normalised Blinn-Phong | `material/lambert.rs` `material/modified_phong.rs` `material/normalised_blinn_phong.rs` |
//! | metals, smooth and rough (GGX); plastic | `material/conductor.rs` `material/ggx.rs` `material/plastic.rs` |
//! | the index of a glass by wavelength, and the colour of a wavelength | `material/dispersion.rs` `image/spectrum.rs` |
//! | textures: a material for each place of a surface, also from a picture | `material/texture.rs` `material/checkered.rs` `material/image_texture.rs` |
//! | a model from an OBJ file: its materials (MTL), their pictures | `material/mtl.rs` `scene/model.rs` |
//! | scenes; scenes described by numbers; a backdrop from a picture | `scene/world.rs` `scene/description.rs` `scene/backdrop.rs` |
//! | pin-hole, thin lens, fisheye, panorama | `camera/pinhole.rs` `camera/thin_lens.rs` `camera/fisheye.rs` `camera/panorama.rs` |
//! | the film loop; from a scene to a picture, and its samplers; the number of rays followed | `render/film.rs` `render/sampler.rs` `render/followed.rs` |
//! | local illumination, shadows, soft shadows | `render/local.rs` `render/shadow.rs` `render/soft_shadow.rs` |
//! | Whitted's ray tracing | `render/whitted.rs` |
//! | path tracing, multiple importance sampling | `render/path.rs` `render/mis.rs` |
//! | caustics: photons from the lights, and paths that leave this light to them | `render/photons.rs` `render/caustics.rs` |
//! | samples clamped to a maximum: no fireflies, smooth edges of lamps | `render/clamped.rs` |
//! | supersampling, adaptive supersampling | `render/supersample.rs` `render/adaptive.rs` |
//! | curved rays, the black hole | `render/curved/mod.rs` |

#![warn(
    clippy::allow_attributes_without_reason,
    missing_debug_implementations,
    unreachable_pub
)]

pub mod accel;
pub mod camera;
pub mod image;
pub mod inside;
pub mod light;
pub mod material;
pub mod math;
pub mod memory;
#[cfg(feature = "files")]
pub mod prelude;
pub mod render;
pub mod sample;
pub mod scene;
pub mod shape;
#[cfg(feature = "files")]
pub mod store;
mod threads;
mod vectors;
