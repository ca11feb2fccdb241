//! Weakly compressible gas that flows through a duct: particles that move with it, pressure that evolves with damping.

use aero_geometry::Vector;

use super::duct::{Crowd, DENSITY, Duct};
use super::particle::Particle;
use super::sums::Sums;
use super::treatment::{Mistake, Next, Sight, Treatment};
use crate::points::weights::{linear, shepard};

/// The gas, what comes in and what is beyond the outlet.
pub struct Flow<'a> {
    pub duct: Duct,
    treatment: &'a dyn Treatment,
    mistake: Option<Mistake>,
    coming: Vec<Particle>,
    pub gas: Vec<Particle>,
    pub beyond: Vec<Particle>,
    pub time: f64,
    sums: Sums,
}

impl<'a> Flow<'a> {
    /// Gas as it comes in first, everywhere.
    pub fn new(duct: Duct, treatment: &'a dyn Treatment, mistake: Option<Mistake>) -> Self {
        let end = duct.length;
        Self {
            treatment,
            mistake,
            coming: duct.lattice([-duct.depth(), 0.0]),
            gas: duct.lattice([0.0, end]),
            beyond: duct.lattice([end, end + duct.depth()]),
            duct,
            time: 0.0,
            sums: Sums::default(),
        }
    }

    pub fn step(&mut self) {
        self.feed();
        self.advance();
        self.go_on();
        self.cross();
        self.time += self.duct.step();
    }

    /// Gas that comes in has a given velocity, and the pressure at its mirror point in the gas.
    fn feed(&mut self) {
        let deep = self.duct.depth() + self.duct.reach();
        let near = self.gas.iter().filter(|one| one.position.x < deep);
        let near: Vec<Particle> = near.copied().collect();
        let crowd = Crowd::new(near.iter(), &self.duct);
        for one in &mut self.coming {
            let mirror = Vector::<2>::new(-one.position.x, one.position.y);
            let [u, v] = self.duct.entering(&one.position, self.time);
            let pressure = linear(&crowd.cloud, &mirror).map_or(one.state[0], |weights| {
                let share = |(j, w): &(u32, f64)| w * near[crowd.owner(*j as usize)].state[0];
                weights.iter().map(share).sum()
            });
            one.state = [pressure, u, v];
        }
    }

    /// `du/dt = -grad p / rho + nu lap u`, then `dp/dt = -rho c^2 div u + nu_edac lap p` with the new velocities [eqs 1, 2].
    fn advance(&mut self) {
        let count = self.gas.len();
        let (duct, step) = (self.duct, self.duct.step());
        let mut seen = self.seen();
        let crowd = Crowd::new(seen.iter(), &duct);
        self.sums.gather(&crowd, &duct, count, seen.len());
        let pushes = self.sums.pushes(&crowd.states(&seen), duct.viscosity);
        for (one, [x, y, ..]) in seen.iter_mut().zip(&pushes) {
            one.state[1] += step * x;
            one.state[2] += step * y;
        }
        // `rho c^2` and `rho_i` of a pair's density are parted.
        let square = duct.sound * duct.sound;
        let rates = self
            .sums
            .pressings(&crowd.states(&seen), square, duct.diffusion());
        let background = DENSITY * square;
        let [entering, _] = duct.entering(&Vector::<2>::zeros(), self.time);
        let quiet = 0.5 * DENSITY * entering * entering;
        for ((one, rate), [.., x, y]) in seen.iter_mut().zip(rates).zip(&pushes) {
            one.state[0] += step * rate;
            let shift = step * background * Vector::<2>::new(*x, *y);
            one.position += step * (Vector::<2>::new(one.state[1], one.state[2]) + shift);
            // Sound of the intensity of eq 30.
            if one.state[0].abs() < quiet {
                one.remember();
            }
        }
        seen.truncate(count);
        self.gas = seen;
    }

    /// The gas, and what it sees beyond both sides.
    fn seen(&self) -> Vec<Particle> {
        let shown = |one: &Particle| {
            let mut one = *one;
            if let Some(mistake) = self.mistake {
                one.state = mistake.shown(one.state, self.duct.stream);
            }
            one
        };
        let gas = self.gas.iter().copied();
        gas.chain(self.beyond.iter().map(shown))
            .chain(self.coming.iter().copied())
            .collect()
    }

    /// Gas beyond the outlet goes on.
    fn go_on(&mut self) {
        let duct = self.duct;
        let from = duct.length - duct.depth() - duct.reach();
        let near = self.gas.iter().filter(|one| one.position.x > from);
        let near: Vec<Particle> = near.copied().collect();
        let sight = Sight {
            duct: &duct,
            gas: &near,
            gas_crowd: &Crowd::new(near.iter(), &duct),
            beyond: &self.beyond,
            beyond_crowd: &Crowd::new(self.beyond.iter(), &duct),
        };
        let next = |one: &Particle| self.treatment.next(one, &sight);
        let next: Vec<Next> = self.beyond.iter().map(next).collect();
        let told: Vec<f64> = next.iter().filter_map(|next| next.drift).collect();
        let mean = told.iter().sum::<f64>() / told.len().max(1) as f64;
        let is_still = self.mistake == Some(Mistake::Still);
        for (one, next) in self.beyond.iter_mut().zip(next) {
            one.state = next.state;
            one.wave = next.wave;
            if !is_still {
                one.position.x += duct.step() * next.drift.unwrap_or(mean);
            }
        }
    }

    /// What crosses a side becomes what is there.
    fn cross(&mut self) {
        let (end, deep) = (self.duct.length, self.duct.depth());
        for one in &mut self.coming {
            one.position.x += self.duct.step() * one.state[1];
            if one.position.x > 0.0 {
                self.gas.push(Particle::new(one.position, one.state));
                one.position.x -= deep;
            }
        }
        self.beyond.retain(|one| one.position.x < end + deep);
        let has_left = |one: &&Particle| one.position.x > end;
        self.beyond
            .extend(self.gas.iter().filter(has_left).copied());
        self.gas.retain(|one| one.position.x <= end);
    }

    /// Mean state about a place.
    pub fn at(&self, place: &Vector<2>) -> [f64; 3] {
        let reach = self.duct.reach();
        let all = self.gas.iter().chain(&self.beyond).chain(&self.coming);
        let near = all.filter(|one| (one.position.x - place.x).abs() < reach);
        let near: Vec<Particle> = near.copied().collect();
        let crowd = Crowd::new(near.iter(), &self.duct);
        let mut sum = [0.0; 3];
        for (j, weight) in shepard(&crowd.cloud, place).unwrap_or_default() {
            let state = crowd.state(j as usize, &near);
            sum = std::array::from_fn(|k| sum[k] + weight * state[k]);
        }
        sum
    }
}
