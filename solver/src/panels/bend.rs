//! Gas presses a round wall with more than its pressure, and is pulled along the wall as much.
//!
//! Its kernels reach over the wall's horizon: more than half of a kernel about a place on a convex wall is gas, by `e`, what lies between
//! the surface and the plane that touches it there, and the force per area of an even pressure `p` is `p (1 + 2 e)`: 1 + 0.4 / R where the
//! wall bends in one direction with a radius of R spacings, twice that on a sphere; on a hollow wall it is less by as much. It is the
//! tension of a layer of gas that feels fewer neighbours along the wall than elsewhere, as that of a liquid's surface raises the pressure
//! in a drop. It is no pressure.
//!
//! The tension is `p int s^2 W ds` over the wall, `s` along it, and comes of counting a pair of gas and solid where the gas is. Pairs belong to
//! the places where their lines cross the wall [Irving & Kirkwood 1950, J. Chem. Phys. 18, 817, doi 10.1063/1.1747782], which are as far again:
//! with what is pulled from panel to panel by the way between them, `sum (p + p') (x' - x) W A'`, a wall is pressed with the pressure alone,
//! where it bends, in corners, at edges and where a side cuts it. All pulls together are nothing.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

use foldhash::HashMap;

use super::seen::Seen;
use crate::each::each;
use crate::rings::Rings;

/// Patches to the width of the widest kernel.
const PATCHES: f64 = 16.0;

/// Panels of one patch have normals alike to a part in so many.
const TURNS: f64 = 4.0;

/// Panels to a patch from where patches take less time.
const WORTH_WHILE: usize = 2;

/// Gas in front of a panel.
#[derive(Clone, Copy, Debug)]
pub struct Front {
    /// How far it reaches.
    pub reach: f64,
    /// Its pressure.
    pub pressure: f64,
}

/// What bends do at a panel.
#[derive(Clone, Copy, Debug)]
pub struct Bent<const D: usize> {
    /// Part of a kernel between the surface and the plane that touches it there; negative where the surface is hollow.
    pub beyond: f64,
    /// Force per area that the layer's tension pulls it with from all around.
    pub pull: Vector<D>,
}

/// What bends do at each of the `panels` with the gas in `front` of them, which reaches as far as the `widest` at most; nothing where no gas is,
/// nor at images. Where many panels are much smaller than a kernel, patches of them are summed.
pub fn bends<const D: usize>(
    panels: &[Seen<D>],
    (rings, widest): (&Rings, f64),
    front: impl Fn(&Seen<D>) -> Option<Front>,
) -> Vec<Bent<D>> {
    let places: Vec<Place<D>> = (panels.iter())
        .map(|panel| Place::new(panel, front(panel)))
        .collect();
    let patches = Surface::of_patches(&places, widest / PATCHES);
    if WORTH_WHILE * patches.places.len() > panels.len() {
        Surface::of_all(&places).bends(&places, rings, widest)
    } else {
        patches.bends(&places, rings, widest)
    }
}

/// A panel or a patch of them, with the gas in front, if there is any.
#[derive(Clone, Copy, Debug)]
struct Place<const D: usize> {
    /// Of a patch the means, and the size of the mean normal times area.
    seen: Seen<D>,
    front: Option<Front>,
    area: f64,
}

impl<const D: usize> Place<D> {
    fn new(seen: &Seen<D>, front: Option<Front>) -> Self {
        Self {
            seen: *seen,
            front,
            area: seen.size,
        }
    }
}

/// Panels, each by itself or by patches.
struct Surface<const D: usize> {
    places: Vec<Place<D>>,
    /// Which of the places each panel belongs to.
    of_panel: Vec<usize>,
}

impl<const D: usize> Surface<D> {
    fn of_all(panels: &[Place<D>]) -> Self {
        Self {
            places: panels.to_vec(),
            of_panel: (0..panels.len()).collect(),
        }
    }

    /// The `panels` by patches of that width whose normals are alike.
    fn of_patches(panels: &[Place<D>], width: f64) -> Self {
        let mut numbers: HashMap<_, usize> = HashMap::default();
        let mut places: Vec<Place<D>> = Vec::new();
        let number = |Place { seen, front, .. }: &Place<D>| {
            let cell: [i64; D] = each(|k| (seen.centre[k] / width).floor() as i64);
            let turn: [i64; D] = each(|k| (TURNS * seen.normal[k]).round() as i64);
            let kind = (cell, turn, front.is_some(), seen.is_image);
            let number = *numbers.entry(kind).or_insert(places.len());
            if number == places.len() {
                let nothing = Seen {
                    centre: Vector::zeros(),
                    normal: Vector::zeros(),
                    size: 0.0,
                    ..*seen
                };
                let front = front.map(|_| Front {
                    reach: 0.0,
                    pressure: 0.0,
                });
                places.push(Place::new(&nothing, front));
            }
            let place = &mut places[number];
            place.seen.centre += seen.centre * seen.size;
            place.seen.normal += seen.normal * seen.size;
            place.area += seen.size;
            if let (Some(mean), Some(front)) = (&mut place.front, front) {
                mean.reach += front.reach * seen.size;
                mean.pressure += front.pressure * seen.size;
            }
            number
        };
        let of_panel = panels.iter().map(number).collect();
        for Place { seen, front, area } in &mut places {
            seen.centre /= *area;
            seen.size = seen.normal.norm();
            seen.normal /= seen.size;
            if let Some(front) = front {
                front.reach /= *area;
                front.pressure /= *area;
            }
        }
        Self { places, of_panel }
    }

    fn bends(&self, panels: &[Place<D>], rings: &Rings, widest: f64) -> Vec<Bent<D>> {
        let centres: Vec<Vector<D>> = self.places.iter().map(|place| place.seen.centre).collect();
        let grid = Pencils::new(&centres, widest);
        let for_each_near = |at: &Vector<D>, reach: f64, act: &mut dyn FnMut(&Place<D>)| {
            grid.for_each_run_near(at, at, reach, |run| {
                let run = grid.order()[run].iter();
                run.for_each(|&n| act(&self.places[n as usize]));
            });
        };
        let pull = |place: &Place<D>| {
            let (at, mut sum) = (&place.seen, Vector::zeros());
            if let Some(own) = place.front.filter(|_| !at.is_image) {
                for_each_near(&at.centre, widest, &mut |other| {
                    if let Some(its) = other.front {
                        let reach = 0.5 * (own.reach + its.reach);
                        let pull = pull(at, &other.seen, reach) * (own.pressure + its.pressure);
                        sum += rings.pulled(&at.centre, &other.seen.centre, pull);
                    }
                });
            }
            sum * (at.size / place.area)
        };
        let pulls: Vec<Vector<D>> = self.places.par_iter().map(pull).collect();
        let bend = |(panel, &place): (&Place<D>, &usize)| {
            let (at, mut beyond) = (&panel.seen, 0.0);
            if let Some(own) = panel.front.filter(|_| !at.is_image) {
                for_each_near(&at.centre, own.reach, &mut |other| {
                    beyond += between(at, &other.seen, own.reach);
                });
            }
            let pull = pulls[place];
            Bent { beyond, pull }
        };
        panels.par_iter().zip(&self.of_panel).map(bend).collect()
    }
}

/// The part of it over `other`.
fn between<const D: usize>(at: &Seen<D>, other: &Seen<D>, reach: f64) -> f64 {
    if !at.bends_on_to(other) {
        return 0.0;
    }
    let arm: Vector<D> = other.centre - at.centre;
    let kernel = QuinticSpline::<D>::value(arm.norm(), reach / SUPPORT);
    -arm.dot(&at.normal) * at.normal.dot(&other.normal) * other.size * kernel
}

/// Pull on `at` towards `other`, for a pressure of one half at both: one way and the other it is the same.
fn pull<const D: usize>(at: &Seen<D>, other: &Seen<D>, reach: f64) -> Vector<D> {
    if at.is_around_an_edge_from(other) {
        return Vector::zeros();
    }
    let arm: Vector<D> = other.centre - at.centre;
    arm * (other.size * QuinticSpline::<D>::value(arm.norm(), reach / SUPPORT))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cap of a sphere of radius one, in rings of panels of about that size.
    fn cap(size: f64) -> Vec<Seen<3>> {
        let rings = (std::f64::consts::PI / size).round() as usize;
        let mut panels = Vec::new();
        for ring in 0..rings / 3 {
            let [from, to] =
                [ring, ring + 1].map(|n| std::f64::consts::PI * n as f64 / rings as f64);
            let around = (std::f64::consts::TAU * (0.5 * (from + to)).sin() / size).ceil() as usize;
            for n in 0..around {
                let (theta, phi) = (
                    0.5 * (from + to),
                    std::f64::consts::TAU * (n as f64 + 0.5) / around as f64,
                );
                let normal = Vector::<3>::new(
                    theta.cos(),
                    theta.sin() * phi.cos(),
                    theta.sin() * phi.sin(),
                );
                panels.push(Seen {
                    centre: normal,
                    normal,
                    size: std::f64::consts::TAU * (from.cos() - to.cos()) / around as f64,
                    sign: Vector::repeat(1.0),
                    number: panels.len() as u32,
                    is_image: false,
                });
            }
        }
        panels
    }

    #[test]
    fn fine_panels_by_patches_bend_as_they_do_one_by_one() {
        let (reach, rings) = (0.6, Rings::default());
        let front = Front {
            reach,
            pressure: 1.0,
        };
        let mean = |size: f64| {
            let panels = cap(size);
            let places: Vec<_> = (panels.iter())
                .map(|panel| Place::new(panel, Some(front)))
                .collect();
            let patches = Surface::of_patches(&places, reach / PATCHES).places.len();
            let bends = bends(&panels, (&rings, reach), |_| Some(front));
            let all = Surface::of_all(&places).bends(&places, &rings, reach);
            let near_the_pole = (0..panels.len()).filter(|&n| panels[n].normal[0] > 0.95);
            let (mut apart, mut sum, mut left) = (0.0_f64, 0.0, 0.0_f64);
            for n in near_the_pole.clone() {
                let (by_patches, one_by_one) = (&bends[n], &all[n]);
                apart = apart.max((by_patches.beyond - one_by_one.beyond).abs());
                sum += one_by_one.beyond;
                // What an even pressure is pulled with takes away what it presses with beyond it.
                let other = by_patches.pull + panels[n].normal * (2.0 * by_patches.beyond);
                left = left.max(other.norm());
            }
            let mean = sum / near_the_pole.count() as f64;
            (panels.len() as f64 / patches as f64, mean, apart, left)
        };
        let (coarse, exact, apart, left) = mean(0.07);
        assert!(coarse < 1.5 && apart == 0.0, "{coarse} {apart}");
        assert!(left < 0.2 * exact, "{left} left of {exact}");
        let (fine, bend, apart, left) = mean(0.018);
        assert!(fine > 2.0, "{fine} panels to a patch");
        assert!((bend / exact - 1.0).abs() < 0.03, "{bend} for {exact}");
        assert!(apart < 0.03 * bend, "{apart} off {bend}");
        assert!(left < 0.1 * bend, "{left} left of {bend}");
    }
}
