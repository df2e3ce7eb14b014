//! The ray tracer.

use super::scene::{Matter, Scene};
use glam::DVec3;

pub struct Tracer {
    pub scene: Scene,
    /// How far off the surface new rays start.
    pub off: f64,
    /// What counts for less than this share is left out.
    pub least: f64,
    /// Keeps a stack of rays in the place of recursion.
    pub stack: bool,
    /// Takes other formulas.
    pub other: bool,
}

/// A ray that is still to be followed, and what its radiance counts for.
struct Waiting {
    o: DVec3,
    d: DVec3,
    depth: usize,
    share: DVec3,
}

impl Tracer {
    pub fn radiance(&self, o: DVec3, d: DVec3, depth: usize) -> DVec3 {
        let share = DVec3::ONE;
        let mut waiting = vec![Waiting { o, d, depth, share }];
        if !self.stack {
            return self.follow(&waiting[0]);
        }
        let mut sum = DVec3::ZERO;
        while let Some(ray) = waiting.pop() {
            let (own, further) = self.step(&ray);
            sum += ray.share * own;
            waiting.extend(further.into_iter().map(|next| Waiting {
                share: ray.share * next.share,
                ..next
            }));
        }
        sum
    }

    fn follow(&self, ray: &Waiting) -> DVec3 {
        if ray.share.max_element() < self.least {
            return DVec3::ZERO;
        }
        let (own, further) = self.step(ray);
        let seen = further.into_iter().map(|next| {
            let counted = Waiting {
                share: ray.share * next.share,
                ..next
            };
            next.share * self.follow(&counted)
        });
        own + seen.sum::<DVec3>()
    }

    /// What the first surface sends itself, and the rays that tell the rest.
    fn step(&self, ray: &Waiting) -> (DVec3, Vec<Waiting>) {
        let &Waiting { o, d, depth, .. } = ray;
        if depth == 0 {
            return (DVec3::ZERO, vec![]);
        }
        let mut nearest: Option<(f64, DVec3, &Matter)> = None;
        for (form, matter) in &self.scene.objects {
            if let Some((t, normal)) = form.hit(o, d, self.other)
                && nearest.is_none_or(|(least, ..)| t < least)
            {
                nearest = Some((t, normal, matter));
            }
        }
        let Some((t, outward, matter)) = nearest else {
            let up = 0.5 * (d.y + 1.0);
            return (
                self.scene.below * (1.0 - up) + self.scene.above * up,
                vec![],
            );
        };
        let (p, leaving) = (o + t * d, outward.dot(d) > 0.0);
        let n = if leaving { -outward } else { outward };
        let mirrored = d - 2.0 * d.dot(n) * n;
        let next = |side: f64, d: DVec3, share: DVec3| Waiting {
            o: p + side * self.off * n,
            d: d.normalize(),
            depth: depth - 1,
            share,
        };
        match *matter {
            Matter::Phong { .. } => (self.phong(matter, p, n, -d), vec![]),
            Matter::Mirror(share) => (DVec3::ZERO, vec![next(1.0, mirrored, share)]),
            Matter::Glass(index) => {
                let eta = if leaving { index } else { 1.0 / index };
                let cos1 = -d.dot(n);
                let square = 1.0 - eta * eta * (1.0 - cos1 * cos1);
                if square <= 0.0 {
                    return (DVec3::ZERO, vec![next(1.0, mirrored, DVec3::ONE)]);
                }
                let cos2 = square.sqrt();
                let share = if self.other {
                    by_angles(eta, cos1.acos(), cos2.acos())
                } else {
                    by_cosines(eta, cos1, cos2)
                };
                let refracted = eta * d + (eta * cos1 - cos2) * n;
                let rays = [(1.0, mirrored, share), (-1.0, refracted, 1.0 - share)];
                let rays = rays.map(|(side, d, share)| next(side, d, DVec3::splat(share)));
                (DVec3::ZERO, rays.into())
            }
        }
    }

    fn phong(&self, matter: &Matter, p: DVec3, n: DVec3, view: DVec3) -> DVec3 {
        let &Matter::Phong {
            ambient,
            diffuse,
            specular,
            exponent,
        } = matter
        else {
            return DVec3::ZERO;
        };
        let o = p + self.off * n;
        let mut sum = ambient * self.scene.ambient;
        for &(position, intensity) in &self.scene.lamps {
            let to_lamp = position - o;
            let (r, l) = (to_lamp.length(), to_lamp.normalize());
            let cosine = l.dot(n);
            let blocks = |t: f64| t < r;
            let mut hits = self
                .scene
                .objects
                .iter()
                .filter_map(|(form, _)| form.hit(o, l, self.other));
            if cosine <= 0.0 || hits.any(|(t, _)| blocks(t)) {
                continue;
            }
            // R·V = V's mirror direction · L.
            let mirrored = if self.other {
                (2.0 * view.dot(n) * n - view).dot(l)
            } else {
                (2.0 * cosine * n - l).dot(view)
            };
            let shine = specular * mirrored.max(0.0).powf(exponent);
            sum += (diffuse * cosine + shine) * intensity / (r * r);
        }
        sum
    }
}

fn by_cosines(eta: f64, cos1: f64, cos2: f64) -> f64 {
    let s = (eta * cos1 - cos2) / (eta * cos1 + cos2);
    let p = (eta * cos2 - cos1) / (eta * cos2 + cos1);
    0.5 * (s * s + p * p)
}

/// Rs = sin²(θ₁ − θ₂)/sin²(θ₁ + θ₂), Rp = tan²(θ₁ − θ₂)/tan²(θ₁ + θ₂); straight on, where both are 0/0, by their limit.
fn by_angles(eta: f64, theta1: f64, theta2: f64) -> f64 {
    let (minus, plus) = (theta1 - theta2, theta1 + theta2);
    if plus < 1e-4 {
        return ((eta - 1.0) / (eta + 1.0)).powi(2);
    }
    0.5 * ((minus.sin() / plus.sin()).powi(2) + (minus.tan() / plus.tan()).powi(2))
}
