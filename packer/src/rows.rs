//! Seeds along a contour: equidistant, with lattice sites and corners kept.

use aero_geometry::Vector;

use crate::contour::Contour;

/// A row of more steps than this between two corners takes any rounding of its count.
const LONG_ROW: f64 = 4.0;

/// A shorter one must be a whole number of steps long, to this part.
const EVEN: f64 = 0.03;

/// Where an interval of a contour ends.
#[derive(Clone, Copy, Debug, PartialEq)]
enum End {
    /// At a particle that is already placed.
    Pin,
    /// On a mirror plane; `kink` where the contour meets it at an angle.
    Plane { kink: bool },
    /// Where the region cuts the contour.
    Cut,
}

/// Lattice and spacing that the rows follow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowPlan<const D: usize> {
    /// Spacing `dx`.
    pub spacing: f64,
    /// Corner of the lattice.
    pub anchor: Vector<D>,
}

impl<const D: usize> RowPlan<D> {
    /// Arc lengths of the seeds on one contour; `carry` takes the rounding of the count on to the next contour. An end on a mirror plane counts one half.
    pub fn seeds(&self, contour: &Contour<D>, carry: &mut f64) -> Vec<f64> {
        let spacing = self.spacing;
        let total = contour.length();
        let pins = self.pins(contour);
        let mut fill = Fill {
            spacing,
            carry,
            seeds: Vec::new(),
        };
        if contour.closed {
            let Some(&first) = pins.first() else {
                fill.ring(total);
                return fill.seeds;
            };
            for (n, &pin) in pins.iter().enumerate() {
                fill.seeds.push(pin);
                let next = pins.get(n + 1).copied().unwrap_or(first + total);
                fill.between(pin, next, [End::Pin, End::Pin]);
            }
            for s in &mut fill.seeds {
                if *s >= total {
                    *s -= total;
                }
            }
            return fill.seeds;
        }
        let last = contour.points.len() - 1;
        let end = |n: usize| {
            if contour.on_plane[usize::from(n > 0)] {
                // The contour crosses a mirror plane squarely unless it has a kink there.
                let normal = &contour.normals[n];
                End::Plane {
                    kink: normal[0].abs().min(normal[1].abs()) > 0.02,
                }
            } else {
                End::Cut
            }
        };
        let ends = [end(0), end(last)];
        let mut from = (0.0, ends[0]);
        for &pin in &pins {
            fill.between(from.0, pin, [from.1, End::Pin]);
            fill.seeds.push(pin);
            // A pin on the plane stands for half a particle here and for half in the image.
            from = (pin, End::Pin);
        }
        if pins.last().is_none_or(|&pin| pin < total - 1e-6 * spacing) {
            fill.between(from.0, total, [from.1, ends[1]]);
        }
        fill.seeds
    }

    /// Arc lengths that must hold a particle: lattice sites on straight parts along the lattice,
    /// and corners.
    fn pins(&self, contour: &Contour<D>) -> Vec<f64> {
        let mut pins: Vec<f64> = Vec::new();
        for n in 1..contour.points.len() {
            self.sites_on(contour, n, &mut pins);
        }
        let total = contour.length();
        // A corner is kept where the rows between it and its neighbours come out even.
        let suits = |a: f64, b: f64| {
            let gap = (a - b).abs();
            let gap = if contour.closed {
                gap.min(total - gap)
            } else {
                gap
            };
            let steps = gap / self.spacing;
            steps > LONG_ROW || (steps > 0.5 && (steps - steps.round()).abs() < EVEN * steps)
        };
        let kinks = (0..contour.points.len()).filter(|&n| contour.kinks[n]);
        for corner in kinks.map(|n| contour.arc[n]) {
            if pins.iter().all(|&pin| suits(pin, corner))
                && (contour.closed || suits(corner, 0.0) && suits(corner, total))
            {
                pins.push(corner);
            }
        }
        pins.sort_unstable_by(f64::total_cmp);
        pins.dedup_by(|b, a| *b - *a < 0.5 * self.spacing);
        if contour.closed
            && pins.len() > 1
            && pins[0] + total - pins[pins.len() - 1] < 0.5 * self.spacing
        {
            pins.pop();
        }
        let clear = |end: usize, gap: f64| {
            !contour.on_plane[end] || gap < 1e-6 * self.spacing || gap > 0.49 * self.spacing
        };
        pins.retain(|&pin| clear(0, pin) && clear(1, total - pin));
        pins
    }

    /// Lattice sites on segment `n`, where it runs along the lattice.
    fn sites_on(&self, contour: &Contour<D>, n: usize, pins: &mut Vec<f64>) {
        let (p, q) = (contour.points[n - 1], contour.points[n]);
        let normals = [contour.normals[n - 1], contour.normals[n]];
        for along in 0..2 {
            let across = 1 - along;
            let level = (p[across] - self.anchor[across]) / self.spacing - 0.5;
            let straight = normals.iter().all(|m| m[along].abs() < 1e-9)
                && (p[across] - q[across]).abs() < 1e-9 * self.spacing
                && (level - level.round()).abs() < 1e-6;
            if !straight {
                continue;
            }
            let site = |x: f64| (x - self.anchor[along]) / self.spacing - 0.5;
            let (a, b) = (site(p[along]), site(q[along]));
            let (low, high) = ((a.min(b) - 1e-6).ceil(), (a.max(b) + 1e-6).floor());
            let mut place = low;
            while place <= high {
                let part = if a == b { 0.0 } else { (place - a) / (b - a) };
                pins.push(contour.arc[n - 1] + part * (contour.arc[n] - contour.arc[n - 1]));
                place += 1.0;
            }
        }
    }
}

/// Fills intervals, passing the rounding of each on to the next.
struct Fill<'a> {
    spacing: f64,
    carry: &'a mut f64,
    seeds: Vec<f64>,
}

impl Fill<'_> {
    /// A closed contour without pins.
    fn ring(&mut self, length: f64) {
        let wanted = length / self.spacing + *self.carry;
        let count = wanted.round().max(0.0);
        *self.carry = wanted - count;
        self.seeds
            .extend((0..count as usize).map(|n| length * n as f64 / count));
    }

    /// The open interval between two ends; pins themselves are placed already.
    fn between(&mut self, from: f64, to: f64, ends: [End; 2]) {
        match ends {
            [End::Pin, End::Pin] => self.between_pins(from, to),
            [End::Plane { .. }, _] | [_, End::Plane { .. }] => self.reach_planes(from, to, ends),
            [End::Pin | End::Cut, End::Cut] => {
                let first = if ends[0] == End::Pin { 1.0 } else { 0.5 };
                self.steps(from, to, first, 1.0);
            }
            [End::Cut, End::Pin] => self.steps(to, from, 1.0, -1.0),
        }
    }

    fn between_pins(&mut self, from: f64, to: f64) {
        let exact = (to - from) / self.spacing - 1.0;
        let wanted = exact + *self.carry;
        let count = if exact.abs() < 1e-6 {
            0.0
        } else {
            wanted.round().max(0.0)
        };
        *self.carry = wanted - count;
        let step = (to - from) / (count + 1.0);
        self.seeds
            .extend((1..=count as usize).map(|n| from + n as f64 * step));
    }

    /// Steps of exactly one spacing from `from` until the region cuts the contour.
    fn steps(&mut self, from: f64, to: f64, first: f64, sign: f64) {
        let count = ((to - from).abs() / self.spacing - first + 1e-6).floor() + 1.0;
        self.seeds.extend(
            (0..count.max(0.0) as usize).map(|n| from + sign * (first + n as f64) * self.spacing),
        );
    }

    /// An interval with a mirror plane at one end or both. A particle may sit on the plane (and
    /// count one half) or half a step away from it.
    fn reach_planes(&mut self, from: f64, to: f64, ends: [End; 2]) {
        let length = to - from;
        if let [End::Plane { kink }, End::Cut] | [End::Cut, End::Plane { kink }] = ends {
            let (start, end, sign) = if ends[1] == End::Cut {
                (from, to, 1.0)
            } else {
                (to, from, -1.0)
            };
            self.steps(start, end, if kink { 0.0 } else { 0.5 }, sign);
            return;
        }
        // In units of the step the interval is: particles inside, plus one half per particle on
        // a plane, plus one half where it ends at a pin.
        let pinned = ends.contains(&End::Pin);
        let offset = if pinned { 0.5 } else { 0.0 };
        let wanted = length / self.spacing - offset + *self.carry;
        let weight = (0.5 * (2.0 * wanted).round()).max(0.0);
        *self.carry = wanted - weight;
        let odd = (2.0 * weight) as u64 % 2 == 1;
        let kink = ends.map(|end| end == End::Plane { kink: true });
        let on = match (ends[0] == End::Pin, ends[1] == End::Pin) {
            (true, _) => [false, odd],
            (_, true) => [odd, false],
            _ if odd => {
                if kink[1] && !kink[0] {
                    [false, true]
                } else {
                    [true, false]
                }
            }
            _ => {
                let both = (kink[0] || kink[1]) && weight >= 1.0;
                [both, both]
            }
        };
        let steps = weight + offset;
        if steps <= 0.0 {
            return;
        }
        let step = length / steps;
        let first = if on[0] {
            0.0
        } else if ends[0] == End::Pin {
            1.0
        } else {
            0.5
        };
        let last = if on[1] {
            0.0
        } else if ends[1] == End::Pin {
            1.0
        } else {
            0.5
        };
        let count = (steps - first - last).round() + 1.0;
        self.seeds
            .extend((0..count.max(0.0) as usize).map(|n| from + (first + n as f64) * step));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fill(length: f64, ends: [End; 2]) -> (Vec<f64>, f64) {
        let mut carry = 0.0;
        let mut fill = Fill {
            spacing: 1.0,
            carry: &mut carry,
            seeds: Vec::new(),
        };
        fill.between(0.0, length, ends);
        let mut seeds = fill.seeds;
        seeds.sort_unstable_by(f64::total_cmp);
        (seeds, carry)
    }

    const PLANE: End = End::Plane { kink: false };

    #[test]
    fn between_two_planes_whole_lengths_leave_half_a_step_at_both() {
        assert_eq!(fill(3.0, [PLANE, PLANE]).0, vec![0.5, 1.5, 2.5]);
    }

    #[test]
    fn between_two_planes_an_odd_half_puts_one_particle_on_a_plane() {
        assert_eq!(fill(2.5, [PLANE, PLANE]).0, vec![0.0, 1.0, 2.0]);
        let kink = End::Plane { kink: true };
        assert_eq!(fill(2.5, [PLANE, kink]).0, vec![0.5, 1.5, 2.5]);
    }

    #[test]
    fn from_a_pin_to_a_plane_the_mirrored_pair_is_one_step_apart() {
        assert_eq!(fill(2.5, [End::Pin, PLANE]).0, vec![1.0, 2.0]);
        assert_eq!(fill(3.0, [End::Pin, PLANE]).0, vec![1.0, 2.0, 3.0]);
    }

    #[test]
    fn rounding_is_carried_to_the_next_interval() {
        let (seeds, carry) = fill(3.3, [End::Pin, End::Pin]);
        assert_eq!(seeds.len(), 2);
        assert!((carry - 0.3).abs() < 1e-12);
    }

    #[test]
    fn a_cut_row_keeps_the_exact_spacing() {
        assert_eq!(fill(3.2, [End::Cut, End::Pin]).0.len(), 3);
        assert_eq!(fill(2.9, [End::Cut, End::Cut]).0, vec![0.5, 1.5, 2.5]);
    }
}
