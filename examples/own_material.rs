//! A material of your own: velvet, which is brightest where it is seen at a grazing angle. And a texture: stripes of it.

use raybook::material::texture::Texture;
use raybook::prelude::*;
use std::error::Error;
use std::f32::consts::FRAC_1_PI;

#[derive(Clone, Copy)]
struct Velvet {
    colour: Rgb,
}

impl Material for Velvet {
    /// f = colour · (1 − (n·l)(n·v))/π: reciprocal, for l and v may change places, and never more than the colour.
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        let normal = at.facing(view);
        let (into, out) = (normal.dot(*toward), normal.dot(*view));
        if into <= 0.0 {
            return Rgb::BLACK;
        }
        self.colour * (FRAC_1_PI * (1.0 - into * out))
    }
}

struct Striped;

impl Texture for Striped {
    type Material = Velvet;

    fn at(&self, surface: &Surface) -> Velvet {
        let stripe = (4.0 * surface.position.y).rem_euclid(2.0) < 1.0;
        let colour = if stripe {
            Rgb::new(0.9, 0.1, 0.2)
        } else {
            Rgb::new(0.2, 0.1, 0.5)
        };
        Velvet { colour }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let floor = Lambert {
        albedo: Rgb::gray(0.5),
    };
    let things = vec![
        Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), floor),
        Thing::new(Sphere::new(vec3(0.0, 1.0, 0.0), 1.0), Striped),
    ];
    let scene = Scene::new(things, vec![])
        .surrounded_by(Rgb::BLACK, |ray| Rgb::gray(1.0 + ray.direction.y));
    let film = Film::new(480, 320, 64);
    let camera = Pinhole::look_at(
        vec3(0.0, 1.8, 5.5),
        vec3(0.0, 0.9, 0.0),
        Vec3::Y,
        0.035,
        film.aspect(),
    )?;
    let picture = film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
    file::save("own_material.png".as_ref(), &picture)?;
    println!("wrote own_material.png");
    Ok(())
}
