//! Panels with what is on them, as plain arrays.

use aero_geometry::Vector;

use super::press::pressed;
use super::{Panels, Pressed, is_shown};
use crate::Simulation;
use crate::frame::{Load, PanelFrame};
use crate::problem::Problem;
use crate::rings::Rings;
use crate::walls::rigid::{Pose, pad};

/// What heat does on a panel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heated {
    /// Into the gas, per area and time.
    pub flux: f64,
    /// Temperature of the gas there.
    pub temperature: f64,
}

impl<const D: usize> Simulation<D> {
    /// The surfaces that the domain holds with the pressure on them now, bodies in scene order and wall sides after.
    pub fn panels(&self) -> PanelFrame {
        let panels = self.laid_panels();
        let time = self.clock.time;
        let pose = |owner| self.walls.pose(owner, time);
        let mut pressed = pressed(self, panels);
        let spread = panels.add_what_is_left(&self.problem, pose, &self.loads(), &mut pressed);
        PanelFrame {
            spread,
            ..panels.frame(&self.problem, time, &pressed, &[], pose)
        }
    }

    fn laid_panels(&self) -> &Panels<D> {
        self.panels.get_or_init(|| Panels::new(&self.problem))
    }

    /// Loads of a pressure of one everywhere: on bodies, then on wall sides.
    pub fn uniform_loads(&self) -> Vec<Load> {
        self.laid_panels().uniform_loads(&self.problem)
    }
}

impl<const D: usize> Panels<D> {
    /// What of the panels lies in the domain of `problem` at `time`, where owners are as `pose` says; `heated` is empty where no heat is
    /// conducted.
    pub fn frame(
        &self,
        problem: &Problem<D>,
        time: f64,
        pressed: &[Pressed<D>],
        heated: &[Heated],
        pose: impl Fn(usize) -> Pose<D>,
    ) -> PanelFrame {
        let stream = &problem.free_stream;
        let dynamic_pressure = 0.5 * stream.density * stream.velocity.norm_squared();
        let rings = Rings::new(problem);
        let mut frame = PanelFrame {
            time,
            corners: D,
            ..PanelFrame::default()
        };
        let mut of_owner: Option<(u32, Pose<D>)> = None;
        for (number, (panel, pressed)) in self.all.iter().zip(pressed).enumerate() {
            let pose = match &of_owner {
                Some((owner, pose)) if *owner == panel.owner => *pose,
                _ => pose(panel.owner as usize),
            };
            of_owner = Some((panel.owner, pose));
            let centre: Vector<D> = pose.position(&panel.centre);
            if !is_shown(&problem.domain, &centre) {
                continue;
            }
            for corner in &panel.corners {
                frame.points.push(pad(&pose.position(corner)).into());
            }
            frame
                .normal
                .push(pad(&pose.direction(&panel.normal)).into());
            frame.area.push(panel.size * rings.surface(&centre));
            frame.pressure.push(pressed.pressure);
            let over = pressed.pressure - stream.pressure;
            frame.pressure_coefficient.push(if dynamic_pressure > 0.0 {
                over / dynamic_pressure
            } else {
                0.0
            });
            frame.friction.push(pad(&pressed.friction).into());
            frame.mach.push(pressed.mach);
            frame.body.push(panel.owner);
            if let Some(heated) = heated.get(number) {
                frame.heat.flux.push(heated.flux);
                frame.heat.temperature.push(heated.temperature);
            }
        }
        frame
    }
}
