//! A ray tracer that can slip.

use super::slip::{Slip, Slips};
use glam::{Vec2, vec2};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, LightSample, point::PointLight};
use raybook::material::{
    fresnel::fresnel, fresnel::schlick, mirror::reflect, phong::Phong, refract::refract,
};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::shadow::shadow_ray;
use raybook::scene::description::{Backdrop, Description, Form, Matter, Object};
use raybook::shape::{Hit, Shape, Surface, triangle::Triangle};
use std::cell::Cell;
use std::f32::consts::{FRAC_PI_2, PI};

/// A ray that begins on the side of the surface away from where it goes.
fn wrong_side(at: &Surface, direction: Dir3) -> Ray {
    let side = at.normal.dot(*direction).signum();
    Ray::new(
        at.leave(direction).origin - 1e-3 * side * *at.normal,
        direction,
    )
}

/// A ray tracer, and what it does wrongly.
pub struct Tracer<'a> {
    scene: &'a Description,
    slips: Slips,
    /// Surfaces that may still go uncounted: between two mirrors, a ray would go on for ever.
    uncounted: Cell<u32>,
    /// What was seen in mirrors and in glass, where each counts by its own share only.
    beyond: Cell<Rgb>,
}

impl<'a> Tracer<'a> {
    pub fn new(scene: &'a Description, slips: Slips) -> Self {
        let uncounted = [Slip::RefractionNotCounted, Slip::MirrorsNotCounted];
        let many = if uncounted.into_iter().any(|slip| slips.have(slip)) {
            1000
        } else {
            0
        };
        Self {
            scene,
            slips,
            uncounted: Cell::new(many),
            beyond: Cell::new(Rgb::BLACK),
        }
    }

    fn is(&self, slip: Slip) -> bool {
        self.slips.have(slip)
    }

    /// The radiance along the viewer's ray.
    pub fn seen(&self, ray: &Ray, depth: u32) -> Rgb {
        let seen = self.radiance(ray, depth, true);
        seen + self.beyond.get()
    }

    /// The radiance along a ray; `first` for the viewer's.
    fn radiance(&self, ray: &Ray, depth: u32, first: bool) -> Rgb {
        if depth == 0 {
            let end = self.slips.make(|slip| match slip {
                Slip::BackdropAtTheEnd => Some(self.backdrop(ray.direction)),
                Slip::AmbientAtTheEnd => Some(self.scene.ambient),
                _ => None,
            });
            return end.unwrap_or(Rgb::BLACK);
        }
        let Some((object, hit)) = self.nearest(ray) else {
            let hidden = self.is(Slip::NoBackdropInMirrors) && !first;
            let is_black = hidden || self.is(Slip::NoBackdrop);
            return if is_black {
                Rgb::BLACK
            } else {
                self.backdrop(ray.direction)
            };
        };
        let at = object.form.surface(ray, &hit);
        let left = match object.matter {
            Matter::Mirror(_) => self.left(depth, Slip::MirrorsNotCounted),
            _ => depth - 1,
        };
        let see_from = |ray: Ray| self.radiance(&ray, left, false);
        let see = |direction: Dir3| {
            // Who never turns the normal steps off along it, wherever the ray goes.
            let off_along_it = self.is(Slip::NormalNeverTurned) && at.normal.dot(*direction) < 0.0;
            let wrong = self.is(Slip::MirroredFromTheWrongSide)
                || self.is_on_the_wrong_side(&at, -ray.direction);
            if off_along_it || wrong {
                return see_from(wrong_side(&at, direction));
            }
            see_from(self.leave(&at, direction))
        };
        let normal = if self.is(Slip::NormalNeverTurned) {
            at.normal
        } else {
            at.facing(-ray.direction)
        };
        let seen = match &object.matter {
            Matter::Phong(phong) => self.phong(phong, &at, -ray.direction, hit.t),
            Matter::Mirror(_)
                if self.is(Slip::MirrorsBlackFromBehind) && at.normal.dot(*ray.direction) > 0.0 =>
            {
                Rgb::BLACK
            }
            Matter::Mirror(mirror) => {
                let mirrored = reflect(ray.direction, normal);
                self.in_mirror(mirror.share, mirrored, &see)
            }
            Matter::Glass(clear) => 'glass: {
                let index = if self.is(Slip::AlwaysCrownGlass) {
                    1.5
                } else {
                    clear.index
                };
                let entering = self.is(Slip::AlwaysEntering) || at.normal.dot(*ray.direction) < 0.0;
                let (here, there) = if entering == self.is(Slip::IndexTurned) {
                    (index, 1.0)
                } else {
                    (1.0, index)
                };
                let mirrored = || see(reflect(ray.direction, normal));
                // The formula with the outward normal is right where the normal is turned in it.
                let facing = at.facing(-ray.direction);
                let Some(refracted) = refract(ray.direction, facing, here, there) else {
                    let seen = !self.is(Slip::NoTotalReflection);
                    break 'glass if seen { mirrored() } else { Rgb::BLACK };
                };
                let cosine = -ray.direction.dot(*normal);
                let share = self.mirrored_share(cosine, clear.index, here, there);
                let off_along_it =
                    self.is(Slip::NormalNeverTurned) && at.normal.dot(*refracted) > 0.0;
                let behind = if off_along_it || self.is(Slip::RefractedFromTheWrongSide) {
                    wrong_side(&at, refracted)
                } else if self.is(Slip::StraightThroughGlass) {
                    self.leave(&at, ray.direction)
                } else {
                    self.leave(&at, refracted)
                };
                let left = self.left(depth, Slip::RefractionNotCounted);
                let through = self.radiance(&behind, left, false) * self.squeezed(here / there);
                if self.is(Slip::NoShares) {
                    break 'glass through + mirrored();
                }
                let through = through * (1.0 - share);
                if share == 0.0 || self.is(Slip::NothingMirroredInGlass) {
                    through
                } else {
                    through + mirrored() * share
                }
            }
        };
        if self.is(Slip::LastShareOnly) && !matches!(object.matter, Matter::Phong(_)) {
            self.beyond.set(self.beyond.get() + seen);
            return Rgb::BLACK;
        }
        seen
    }

    /// What a mirror of this share shows: what it can `see` along the mirrored direction.
    fn in_mirror(&self, share: Rgb, mirrored: Dir3, see: &dyn Fn(Dir3) -> Rgb) -> Rgb {
        let seen = if self.is(Slip::MirrorsShowTheBackdrop) {
            self.backdrop(mirrored)
        } else {
            see(mirrored)
        };
        let seen = if self.is(Slip::MirrorsWithoutColour) {
            seen
        } else {
            share * seen
        };
        if self.is(Slip::AmbientOnMirrors) {
            seen + self.scene.ambient
        } else {
            seen
        }
    }

    /// What a ray sees that meets nothing.
    fn backdrop(&self, direction: Dir3) -> Rgb {
        let Backdrop { below, above } = self.scene.backdrop;
        let by_height = |height: f32| below * (1.0 - height) + above * height;
        let angle = direction.y.clamp(-1.0, 1.0).asin();
        let height = self.slips.make(|slip| match slip {
            Slip::HeightForShare => Some(direction.y),
            Slip::HeightAboveTheHorizon => Some(direction.y.max(0.0)),
            Slip::HeightWithoutSign => Some(direction.y.abs()),
            Slip::AngleForHeight => Some(0.5 + angle / PI),
            Slip::AngleAboveTheHorizon => Some((angle / FRAC_PI_2).max(0.0)),
            _ => None,
        });
        height.map_or_else(|| self.scene.backdrop.seen(direction), by_height)
    }

    /// How many surfaces a new ray may meet: one less, unless the slip is not to count this one.
    fn left(&self, depth: u32, uncounted: Slip) -> u32 {
        match self.uncounted.get().checked_sub(1) {
            Some(left) if self.is(uncounted) => {
                self.uncounted.set(left);
                depth
            }
            _ => depth - 1,
        }
    }

    fn nearest(&self, ray: &Ray) -> Option<(&Object, Hit)> {
        let mut hits = self.scene.objects.iter().filter_map(|object| {
            let hit = self.hit(object, ray, Interval::AHEAD)?;
            let is_one_sided = match object.form {
                Form::Triangle(_) => self.is(Slip::OneSidedTriangles),
                Form::Plane(_) => self.is(Slip::OneSidedPlanes),
                Form::Sphere(_) => false,
            };
            let is_culled = is_one_sided && is_from_behind(object, ray, &hit);
            (!is_culled).then_some((object, hit))
        });
        let by_distance = |(_, a): &(_, Hit), (_, b): &(_, Hit)| a.t.total_cmp(&b.t);
        if self.is(Slip::FirstForNearest) {
            hits.next()
        } else if self.is(Slip::FarthestForNearest) {
            hits.max_by(by_distance)
        } else {
            hits.min_by(by_distance)
        }
    }

    /// What the radiance behind a surface is multiplied by, at this ratio of the indices before it and behind it.
    fn squeezed(&self, ratio: f32) -> f32 {
        let factor = self.slips.make(|slip| match slip {
            Slip::RefractedSqueezed => Some(ratio * ratio),
            Slip::RefractedSpread => Some(1.0 / (ratio * ratio)),
            _ => None,
        });
        factor.unwrap_or(1.0)
    }

    /// The share of the light that glass of an index mirrors, where the light comes at the angle of this cosine through `here`.
    fn mirrored_share(&self, cosine: f32, index: f32, here: f32, there: f32) -> f32 {
        let share = self.slips.make(|slip| match slip {
            Slip::AllRefracted => Some(0.0),
            Slip::AllRefractedFromInside if here == index => Some(0.0),
            Slip::SharesExchanged => Some(1.0 - fresnel(cosine, here, there).unpolarised),
            Slip::FresnelFromOutside => Some(fresnel(cosine, 1.0, index).unpolarised),
            Slip::FresnelTurned => Some(fresnel(cosine, there, here).unpolarised),
            Slip::FresnelBackwards => Some(fresnel(-cosine, here, there).unpolarised),
            Slip::HalfMirrored => Some(0.5),
            Slip::FourPercentMirrored => Some(0.04),
            Slip::MirroredAsFromStraightAbove => Some(fresnel(1.0, here, there).unpolarised),
            Slip::OnePolarisation => Some(fresnel(cosine, here, there).s),
            Slip::Schlick => Some(schlick(cosine, here, there)),
            _ => None,
        });
        share.unwrap_or_else(|| fresnel(cosine, here, there).unpolarised)
    }

    fn hit(&self, object: &Object, ray: &Ray, within: Interval) -> Option<Hit> {
        let is_one_sided = match object.form {
            Form::Triangle(_) => self.is(Slip::OneSidedTrianglesInShadowsToo),
            Form::Plane(_) => self.is(Slip::OneSidedPlanesInShadowsToo),
            Form::Sphere(_) => false,
        };
        let is_seen = |hit: &Hit| !(is_one_sided && is_from_behind(object, ray, hit));
        let hit = object.form.hit(ray, within).filter(is_seen);
        match &object.form {
            Form::Triangle(corners) if hit.is_none() && self.is(Slip::Parallelogram) => {
                // The other half is p1, p1 + p2 − p0, p2, where the first triangle's u and v are 1 − v and u + v.
                let opposite = corners.p1 + corners.p2 - corners.p0;
                let mut hit = Triangle::new(corners.p1, opposite, corners.p2).hit(ray, within)?;
                hit.uv = vec2(1.0 - hit.uv.y, hit.uv.x + hit.uv.y);
                Some(hit)
            }
            _ => hit,
        }
    }

    /// Whether rays to the viewer's side of a surface start on its other side.
    fn is_on_the_wrong_side(&self, at: &Surface, view: Dir3) -> bool {
        self.is(Slip::FromTheSideAwayFromTheViewer)
            || self.is(Slip::AlwaysFromOutside) && at.normal.dot(*view) < 0.0
    }

    /// The ray that leaves a surface.
    fn leave(&self, at: &Surface, direction: Dir3) -> Ray {
        let ray = at.leave(direction);
        if self.is(Slip::BelowTheSurface) {
            wrong_side(at, direction)
        } else if self.is(Slip::FarOff) {
            let side = at.normal.dot(*direction).signum();
            Ray::new(ray.origin + 0.1 * side * *at.normal, direction)
        } else {
            ray
        }
    }

    /// What a surface shows to a viewer at some distance.
    fn phong(&self, phong: &Phong, at: &Surface, view: Dir3, away: f32) -> Rgb {
        let lamps = &self.scene.lamps;
        let counted = if self.is(Slip::OneLamp) {
            1
        } else {
            lamps.len()
        };
        let (mut is_over, mut is_shadowed) = (false, false);
        let lights = lamps.iter().take(counted).filter_map(|lamp| {
            if is_over {
                return None;
            }
            let mut light = lamp.sample(at.position, Vec2::ZERO)?;
            let distance = light.distance;
            let is_nearer = |other: &PointLight| other.position.distance(at.position) < distance;
            if self.is(Slip::NearestLamp) && lamps.iter().any(is_nearer) {
                return None;
            }
            let divisor = self.slips.make(|slip| match slip {
                Slip::NoFalloff => Some(1.0),
                Slip::FalloffByDistance => Some(distance),
                Slip::FalloffByCube => Some(distance.powi(3)),
                Slip::FalloffUpToTheViewer => Some((distance + away).powi(2)),
                _ => None,
            });
            if let Some(divisor) = divisor {
                light.arriving = lamp.intensity / divisor;
            }
            let factor = self.slips.make(|slip| match slip {
                Slip::LampIsAPower => Some(1.0 / (4.0 * PI)),
                Slip::LampsTwiceAsBright => Some(2.0),
                _ => None,
            });
            light.arriving = light.arriving * factor.unwrap_or(1.0);
            if self.is(Slip::PositionForDirection) {
                light.toward = Dir3::new_or(lamp.position, light.toward);
            }
            let arrives = self.arrives(at, view, &light);
            let is_above = light.toward.dot(*at.facing(view)) > 0.0;
            let is_hidden = is_above && !arrives;
            is_over = self.is(Slip::ShadowEndsTheLoop) && is_hidden;
            is_shadowed |= self.is(Slip::ShadowIsBlack) && is_hidden;
            (arrives || self.is(Slip::HighlightInTheShadow)).then_some((light, arrives))
        });
        let lit = lights.map(|(light, arrives)| self.lit(phong, at, view, &light, arrives));
        let mut lit: Rgb = lit.sum();
        if self.is(Slip::LampsAveraged) && !lamps.is_empty() {
            lit = lit / lamps.len() as f32;
        }
        let times = self.slips.make(|slip| match slip {
            Slip::NoAmbient => Some(0.0),
            Slip::AmbientForEachLamp => Some(lamps.len() as f32),
            _ => None,
        });
        if is_shadowed {
            return Rgb::BLACK;
        }
        phong.ambient * self.scene.ambient * times.unwrap_or(1.0) + lit
    }

    /// Whether a lamp's light arrives.
    fn arrives(&self, at: &Surface, view: Dir3, light: &LightSample) -> bool {
        let (_, mut way) = shadow_ray(at, light);
        if self.is(Slip::ShadowsFromBeyondTheLamp) {
            way = Interval::AHEAD;
        }
        let from_below = self.is_on_the_wrong_side(at, view) || self.is(Slip::ShadowRaysFromBelow);
        let ray = if from_below {
            wrong_side(at, light.toward)
        } else {
            self.leave(at, light.toward)
        };
        let blocks = |object: &&Object| {
            let is_clear = match object.matter {
                Matter::Glass(_) => self.is(Slip::LightThroughGlass),
                Matter::Mirror(_) => self.is(Slip::LightThroughMirrors),
                Matter::Phong(_) => false,
            } || match object.form {
                Form::Sphere(_) => self.is(Slip::LightThroughSpheres),
                Form::Plane(_) => self.is(Slip::LightThroughPlanes),
                Form::Triangle(_) => self.is(Slip::LightThroughTriangles),
            };
            !is_clear && self.hit(object, &ray, way).is_some()
        };
        self.is(Slip::NoShadows) || self.scene.objects.iter().find(blocks).is_none()
    }

    /// What the surface makes of a lamp's light, whether it arrives or should not.
    fn lit(
        &self,
        phong: &Phong,
        at: &Surface,
        view: Dir3,
        light: &LightSample,
        arrives: bool,
    ) -> Rgb {
        let normal = if self.is(Slip::NormalNotTurned) || self.is(Slip::NormalNeverTurned) {
            at.normal
        } else {
            at.facing(view)
        };
        let cosine = light.toward.dot(*normal);
        if cosine <= 0.0 {
            return Rgb::BLACK;
        }
        let half = Dir3::new_or(*light.toward + *view, normal);
        let highlight = self.slips.make(|slip| match slip {
            Slip::ViewTurned => Some(reflect(light.toward, normal).dot(*view)),
            Slip::HalfVector => Some(half.dot(*normal)),
            Slip::LightForMirrored => Some(light.toward.dot(*view)),
            _ => None,
        });
        let highlight = highlight.unwrap_or_else(|| reflect(-light.toward, normal).dot(*view));
        let shine = phong.specular * highlight.max(0.0).powf(phong.exponent);
        let factor = self.slips.make(|slip| match slip {
            Slip::HighlightTimesCosine => Some(cosine),
            Slip::NoHighlight => Some(0.0),
            _ => None,
        });
        let shine = shine * factor.unwrap_or(1.0);
        let diffuse = if self.is(Slip::NoCosine) { 1.0 } else { cosine };
        let diffuse = if self.is(Slip::HighlightInTheShadow) && !arrives {
            0.0
        } else if self.is(Slip::DiffuseOverPi) {
            diffuse / PI
        } else {
            diffuse
        };
        if self.is(Slip::HighlightUnlit) {
            return phong.diffuse * diffuse * light.arriving + shine;
        }
        (phong.diffuse * diffuse + shine) * light.arriving
    }
}

/// Whether a ray meets a surface from the side to which its normal does not point.
pub(super) fn is_from_behind(object: &Object, ray: &Ray, hit: &Hit) -> bool {
    object.form.surface(ray, hit).normal.dot(*ray.direction) > 0.0
}
