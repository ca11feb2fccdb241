//! Sections of the nozzle: Mach number on the centre line and in the mean, mass flow.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_solver::frame::{Frame, Kind};
use aero_validation::exact::nozzle::BackNozzle;
use aero_validation::metrics::MetricError;
use aero_validation::metrics::gradient::Cloud;
use aero_validation::metrics::interpolate::Sampler;

/// Metres.
pub const INCH: f64 = 0.0254;
/// Half-height of the inlet, inches.
pub const INLET: f64 = 1.5955;
/// Mass flux of the free stream, kg/(s m^2): 230 412 Pa at 300 K and this Mach number.
const FLUX: f64 = 275.13;

/// A section of the nozzle, means over the frames.
#[derive(Clone, Copy, Debug, Default)]
pub struct Station {
    /// Place, inches from the throat.
    pub x: f64,
    /// Mach number on the centre line.
    pub centre: f64,
    /// Mach number, mean over the section.
    pub mean: f64,
    /// Mass flow through the half duct per metre of width, over that of the free stream.
    pub flow: f64,
}

/// Sections an eighth of an inch apart, means over the frames.
pub fn stations(frames: &[Frame]) -> Result<Vec<Station>, MetricError> {
    let mut stations: Vec<Station> = (-23..=23)
        .map(|k| Station {
            x: f64::from(k) / 8.0,
            ..Station::default()
        })
        .collect();
    let share = 1.0 / frames.len() as f64;
    for frame in frames {
        add_sections(&mut stations, frame, share)?;
    }
    Ok(stations)
}

/// Adds `share` of one frame's values to the stations.
fn add_sections(stations: &mut [Station], frame: &Frame, share: f64) -> Result<(), MetricError> {
    /// Points across a section.
    const ACROSS: usize = 40;
    /// Points of the centre line, which is a few rows of particles wide: in steady flow a row keeps its
    /// own noise for ever. Inches; the Mach number varies by less than 0.3 per cent over it.
    const CORE: usize = 5;
    const CORE_HEIGHT: f64 = 0.1;
    let mut position = Vec::new();
    let (mut h, mut mach, mut flux) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..frame.kind.len() {
        if frame.kind[i] == Kind::Ghost as u8 {
            continue;
        }
        // With its image, so that the centre line lies inside.
        let [x, y, z] = frame.position[i];
        for y in [y, -y] {
            position.push([x, y, z]);
            h.push(frame.smoothing_length[i]);
            mach.push(frame.mach[i]);
            flux.push(frame.density[i] * frame.velocity[i][0] / FLUX);
        }
    }
    let volume: Vec<f64> = h.iter().map(|h| (h / SMOOTHING_RATIO).powi(2)).collect();
    let cloud = Cloud {
        position: &position,
        volume: &volume,
        smoothing_length: &h,
        dimension: 2,
    };
    let mach = Sampler::new(cloud, &mach)?;
    let flux = Sampler::new(cloud, &flux)?;
    let shape = BackNozzle::in_inches();
    for station in stations {
        let at = |y: f64| [station.x * INCH, y * INCH, 0.0];
        for k in 0..CORE {
            let y = (k as f64 + 0.5) / CORE as f64 * CORE_HEIGHT;
            let weight = share / CORE as f64;
            station.centre += weight * mach.at(&at(y)).unwrap_or(f64::NAN);
        }
        let height = shape.half_height(station.x);
        for k in 0..ACROSS {
            let y = (k as f64 + 0.5) / ACROSS as f64 * height;
            let weight = share / ACROSS as f64;
            station.mean += weight * mach.at(&at(y)).unwrap_or(f64::NAN);
            station.flow += weight * flux.at(&at(y)).unwrap_or(f64::NAN) * height / INLET;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::GAMMA;
    use super::*;
    use aero_validation::exact::nozzle::Section;

    #[test]
    fn the_free_stream_is_the_one_that_chokes_the_throat() {
        /// As in the scene.
        const MACH: f64 = 0.29615;
        let mach = BackNozzle::in_inches().mach(-3.0, Section::Planar, GAMMA);
        assert!((mach.unwrap() - MACH).abs() < 1e-5);
        let sound = (GAMMA * 287.05 * 300.0_f64).sqrt();
        let flux = 230_412.0 / (287.05 * 300.0) * MACH * sound;
        assert!((flux / FLUX - 1.0).abs() < 1e-4, "{flux}");
    }
}
