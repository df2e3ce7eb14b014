//! A shape of your own: a disc. It says where a ray meets it, and what its surface is like there.

use raybook::prelude::*;
use raybook::shape::ROUNDING;
use std::error::Error;

/// A round, flat disc.
struct Disc {
    middle: Vec3,
    normal: Dir3,
    radius: f32,
}

impl Shape for Disc {
    fn bounds(&self) -> Aabb {
        // Along an axis, a disc reaches as far as its radius times the sine of the axis' angle to the normal.
        let reach = self.radius
            * (Vec3::ONE - *self.normal * *self.normal)
                .max(Vec3::ZERO)
                .map(f32::sqrt);
        Aabb {
            min: self.middle - reach,
            max: self.middle + reach,
        }
    }

    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        // n·(o + t·d − c) = 0, and no further from the middle than the radius; t is NaN or ∞ along the disc, and then no hit
        let t = self.normal.dot(self.middle - ray.origin) / self.normal.dot(*ray.direction);
        let inside = ray.at(t).distance(self.middle) <= self.radius;
        (within.contains(t) && inside).then_some(Hit {
            t,
            uv: Vec2::ZERO,
            id: 0,
        })
    }

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let position = ray.at(hit.t);
        let largest = position.abs().max(ray.origin.abs()).max(self.middle.abs());
        Surface::flat(position, ROUNDING * largest.max_element(), self.normal)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let disc = |y: f32, radius: f32, lean: f32| Disc {
        middle: vec3(0.0, y, 0.0),
        normal: Dir3::new_or(vec3(lean, 1.0, 0.2), Dir3::Y),
        radius,
    };
    let colour = |r, g, b| Lambert {
        albedo: Rgb::new(r, g, b),
    };
    let things = vec![
        Thing::new(disc(0.0, 2.0, 0.0), colour(0.7, 0.68, 0.6)),
        Thing::new(disc(0.6, 1.3, 0.3), colour(0.1, 0.4, 0.6)),
        Thing::new(disc(1.2, 0.7, -0.4), colour(0.8, 0.3, 0.1)),
    ];
    let scene = Scene::new(things, vec![])
        .surrounded_by(Rgb::BLACK, |ray| Rgb::gray(0.5 + 0.5 * ray.direction.y));
    let film = Film::new(480, 320, 32);
    let camera = Pinhole::look_at(
        vec3(0.0, 2.5, 7.0),
        vec3(0.0, 0.5, 0.0),
        Vec3::Y,
        0.035,
        film.aspect(),
    )?;
    let picture = film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
    file::save("own_shape.png".as_ref(), &picture)?;
    println!("wrote own_shape.png");
    Ok(())
}
