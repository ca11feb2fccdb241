//! What flows through the faces of a block: reconstruct, solve the Riemann problem, add up.

use pulp::{Simd, WithSimd};

use super::calmness::{smoothness, steepness};
use super::drawing::Drawing;
use super::energy::{EnergyFlux, carried};
use super::equation_of_state::EquationOfState;
use super::face_list::Join;
use super::gather::{gather, gather_state, stored};
use super::hll::Jump;
use super::net::{Block, Net};
use super::real::{Lane, MAX_LANES, Real};
use super::reconstruction::{Aside, Neighbours, rise};
use super::slopes::Flow;
use super::slow::meeting;
use super::state::{Conserved, Primitive, dot, scaled};
use crate::each::each;

/// The pass over the faces of a block, as many at once as the processor has lanes. What is not of faces is left to [`super::exchange`], which is
/// compiled once for all processors.
pub struct Through<'a, G, const D: usize> {
    /// The gas.
    pub gas: &'a G,
    /// All faces.
    pub net: &'a Net<D>,
    /// How energy goes through them.
    pub energy: EnergyFlux,
    /// Least Mach number that gas counts by where it meets, see [`super::slow`].
    pub least_mach: f64,
    /// Those to sum up.
    pub block: &'a Block<D>,
    /// The flow.
    pub flow: Flow<'a, D>,
    /// How states are drawn out to the faces.
    pub drawing: Drawing,
    /// Whether the flux through each face is asked for.
    pub keeps_fluxes: bool,
}

/// What went through the faces of a block.
pub struct Passed<const D: usize> {
    /// What each cell gained, per time.
    pub cells: Vec<Conserved<D>>,
    /// Flux through the whole of each face, where asked for.
    pub fluxes: Vec<Conserved<D>>,
}

impl<G: EquationOfState, const D: usize> WithSimd for Through<'_, G, D> {
    type Output = Passed<D>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Passed<D> {
        let Self {
            net, block, flow, ..
        } = self;
        let start = block.cells.start;
        let mut cells = vec![Conserved::ZERO; block.cells.len()];
        let mut fluxes = Vec::new();
        for faces in block.faces.chunks(S::F64_LANES) {
            let mut batch = Batch::new(simd, net, faces, flow);
            batch.has_layers = self.drawing == Drawing::Layers;
            if self.drawing != Drawing::Waves || self.least_mach < 1.0 {
                batch.find_skews(simd, net, faces);
            }
            if self.drawing == Drawing::Waves {
                batch.find_evenness(simd, net, faces);
            }
            let flux = batch.flux(self.gas, self.energy, self.least_mach);
            let flux = stored(&flux);
            for (face, flux) in faces.iter().zip(&flux) {
                for (i, sign) in [(face.i, -1.0), (face.j, 1.0)] {
                    if let Some(cell) = cells.get_mut((i as usize).wrapping_sub(start)) {
                        *cell = cell.plus(sign, flux);
                    }
                }
            }
            if self.keeps_fluxes {
                fluxes.extend_from_slice(&flux[..faces.len()]);
            }
        }
        Passed { cells, fluxes }
    }
}

/// As many faces as the processor has lanes, with the cells on both sides.
struct Batch<S: Simd, const D: usize> {
    states: [Primitive<D, Lane<S>>; 2],
    slopes: [[Primitive<D, Lane<S>>; D]; 2],
    calmness: Lane<S>,
    area: [Lane<S>; D],
    apart: [Lane<S>; D],
    /// See [`Drawing::Layers`].
    has_layers: bool,
    /// See [`Drawing::Waves`].
    evenness: Option<Lane<S>>,
    /// From halfway between the cells to the faces' middles, where that counts.
    skew: Option<[Lane<S>; D]>,
}

impl<S: Simd, const D: usize> Batch<S, D> {
    #[inline(always)]
    fn new(simd: S, net: &Net<D>, faces: &[Join], flow: Flow<'_, D>) -> Self {
        // The lanes beyond the last face do the last one again.
        let face = |l: usize| &faces[l.min(faces.len() - 1)];
        let shapes: [_; MAX_LANES] = each(|l| &net.face_shapes[face(l).shape as usize]);
        let numbers: [[usize; MAX_LANES]; 2] =
            [each(|l| face(l).i as usize), each(|l| face(l).j as usize)];
        let zero = Lane(simd, simd.splat_f64s(0.0));
        let nothing = Primitive {
            density: zero,
            velocity: [zero; D],
            pressure: zero,
        };
        let mut batch = Self {
            states: [nothing; 2],
            slopes: [[nothing; D]; 2],
            calmness: zero,
            area: [zero; D],
            apart: [zero; D],
            has_layers: false,
            evenness: None,
            skew: None,
        };
        let mut calmness = [zero; 2];
        for side in 0..2 {
            let states: [_; MAX_LANES] = each(|l| &flow.states[numbers[side][l]]);
            let cells: [_; MAX_LANES] = each(|l| &flow.slopes[numbers[side][l]]);
            gather_state(simd, &states, &mut batch.states[side]);
            for axis in 0..D {
                let slopes: [_; MAX_LANES] = each(|l| &cells[l].along[axis]);
                gather_state(simd, &slopes, &mut batch.slopes[side][axis]);
            }
            calmness[side] = gather(simd, |l| cells[l].calmness);
        }
        batch.calmness = calmness[0].min(calmness[1]);
        for k in 0..D {
            batch.area[k] = gather(simd, |l| shapes[l].area[k]);
            batch.apart[k] = gather(simd, |l| shapes[l].apart[k]);
        }
        batch
    }

    /// Where the middles of the faces are.
    #[inline(always)]
    fn find_skews(&mut self, simd: S, net: &Net<D>, faces: &[Join]) {
        let shape = |l: usize| &net.face_shapes[faces[l.min(faces.len() - 1)].shape as usize].skew;
        if (0..faces.len()).all(|l| *shape(l) == [0.0; D]) {
            return;
        }
        let mut skew = self.apart;
        for (k, lane) in skew.iter_mut().enumerate() {
            *lane = gather(simd, |l| shape(l)[k]);
        }
        self.skew = Some(skew);
    }

    /// Which faces are between even cells, where any is.
    #[inline(always)]
    fn find_evenness(&mut self, simd: S, net: &Net<D>, faces: &[Join]) {
        let evenness =
            |l: usize| net.face_shapes[faces[l.min(faces.len() - 1)].shape as usize].evenness;
        if (0..faces.len()).any(|l| evenness(l) > 0.0) {
            self.evenness = Some(gather(simd, evenness));
        }
    }

    /// Flux through the whole of each face.
    #[inline(always)]
    fn flux<G: EquationOfState>(
        &self,
        gas: &G,
        energy: EnergyFlux,
        least_mach: f64,
    ) -> Conserved<D, Lane<S>> {
        let size = dot(&self.area, &self.area).sqrt();
        let share = size.like(1.0) / size;
        let normal = scaled(&self.area, share);
        let smooth = smoothness(self.calmness);
        let cells = Neighbours {
            means: self.states,
            rises: [
                rise(&self.slopes[0], &self.apart),
                rise(&self.slopes[1], &self.apart),
            ],
            smooth: steepness(self.calmness),
            order: self.calmness,
            has_layers: self.has_layers,
            evenness: self.evenness,
        };
        let mut sides = cells.states();
        if let Some(skew) = &self.skew {
            let is_mean = self.has_layers || least_mach < 1.0;
            let aside = Aside::new(&self.slopes, &self.apart, skew, is_mean);
            sides = aside.moved(sides, &cells, smooth);
        }
        if least_mach < 1.0 {
            meeting(gas, &mut sides, &normal, least_mach);
        }
        let [left, right] = sides;
        let jump = Jump::new(gas, left, right, normal);
        let (sharp, blunt) = (jump.hllc(), jump.hll());
        let mix = Mix {
            is_smooth: smooth - (1.0 - f64::EPSILON),
            smooth,
            size,
        };
        let mut momentum = sharp.momentum;
        for k in 0..D {
            momentum[k] = mix.of(sharp.momentum[k], blunt.momentum[k]);
        }
        let mass = mix.of(sharp.mass, blunt.mass);
        let by_waves = mix.of(sharp.energy, blunt.energy);
        Conserved {
            mass,
            momentum,
            energy: match energy {
                EnergyFlux::Waves => by_waves,
                EnergyFlux::Enthalpy(enthalpy) => {
                    let (with_mass, share) = carried(gas, mass, &self.states, enthalpy, smooth);
                    by_waves + share * (with_mass - by_waves)
                }
            },
        }
    }
}

/// How much there is of the sharp and of the blunt flux, over the whole face.
struct Mix<R> {
    is_smooth: R,
    smooth: R,
    size: R,
}

impl<R: Real> Mix<R> {
    #[inline(always)]
    fn of(&self, sharp: R, blunt: R) -> R {
        let mixed = blunt + self.smooth * (sharp - blunt);
        self.is_smooth.select(sharp, mixed) * self.size
    }
}
