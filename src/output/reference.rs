//! What a run is measured by, for the field data of its files.

use super::vtk_xml::Told;
use crate::sample::{Scale, State};
use aero_solver::frame::Frame;
use aero_solver::gas::Gases;

/// The undisturbed stream and the gas.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// Pressure of the free stream.
    pub pressure: f64,
    /// Density of the free stream.
    pub density: f64,
    /// Velocity of the free stream.
    pub velocity: [f64; 3],
    /// The gas, or both.
    pub gases: Gases,
    /// Specific gas constant, where the scene states or implies it.
    pub gas_constant: Option<f64>,
    /// Spacing of particles or of the lattice.
    pub spacing: f64,
    /// Areas and lengths that coefficients of the bodies refer to, in scene order.
    pub bodies: Vec<[f64; 2]>,
}

impl Reference {
    /// What a file of a frame says of the whole.
    pub(super) fn told(&self, time: f64, is_compressed: bool) -> Told {
        Told {
            fields: self.fields(time),
            units: if self.is_si() {
                "SI: m, kg, s, K"
            } else {
                "those of the scene"
            },
            is_compressed,
        }
    }

    /// By name, with the time of a frame.
    fn fields(&self, time: f64) -> Vec<(&'static str, Vec<f64>)> {
        let mut fields = vec![
            // What ParaView takes for the time.
            ("TimeValue", vec![time]),
            ("free_stream_pressure", vec![self.pressure]),
            ("free_stream_density", vec![self.density]),
            ("free_stream_velocity", self.velocity.to_vec()),
            (
                "gamma",
                vec![self.gases.first.ratio_at(self.density, self.pressure)],
            ),
            ("spacing", vec![self.spacing]),
        ];
        for (k, name) in ["reference_area", "reference_length"]
            .into_iter()
            .enumerate()
        {
            let all: Vec<f64> = self.bodies.iter().map(|body| body[k]).collect();
            if !all.is_empty() {
                fields.push((name, all));
            }
        }
        fields.extend(
            self.gas_constant
                .map(|constant| ("gas_constant", vec![constant])),
        );
        fields
    }

    /// True where the scene's units are SI: a gas constant has no other.
    pub fn is_si(&self) -> bool {
        self.gas_constant.is_some()
    }

    /// What numbers that follow from the state are measured by.
    pub fn scale(&self) -> Scale {
        let speed = self.velocity.iter().map(|u| u * u).sum::<f64>();
        Scale {
            gases: self.gases,
            gas_constant: self.gas_constant,
            stream: [self.pressure, self.density],
            dynamic_pressure: 0.5 * self.density * speed,
        }
    }

    /// Temperatures of a frame in K, where there is a gas constant.
    pub(super) fn temperatures(&self, frame: &Frame) -> Option<Vec<f64>> {
        let scale = self.scale();
        self.gas_constant?;
        states(frame)
            .map(|state| scale.temperature(&state))
            .collect()
    }

    /// Entropies of a frame over that of the free stream.
    pub(super) fn entropies(&self, frame: &Frame) -> Vec<f64> {
        let scale = self.scale();
        states(frame).map(|state| scale.entropy(&state)).collect()
    }
}

/// The gas of a frame, of which no more is known than what it is and how dense and hot.
fn states(frame: &Frame) -> impl Iterator<Item = State> {
    let pairs = frame.pressure.iter().zip(&frame.density).enumerate();
    pairs.map(|(n, (&pressure, &density))| State {
        density,
        pressure,
        second: frame
            .extra
            .second
            .get(n)
            .map_or(0.0, |&second| f64::from(second)),
        ..State::default()
    })
}
