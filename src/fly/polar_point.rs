//! What a flight comes to: coefficients at no spacing, with their bands.

use serde::Serialize;

use super::extrapolate::{Extrapolated, LEAST, beyond, extrapolate};
use super::flight::{Flight, GAMMA};
use super::level::{Coefficients, Level, centre};

/// Part of the surface behind which a body may be thinner than two cells: edges of wings always are.
pub(super) const EDGES: f64 = 0.1;

/// The same from which no trend of its runs is believed: they are runs of as many bodies of other thicknesses.
pub(super) const UNSEEN: f64 = 0.5;

/// What a captured shock, some cells thick, costs of a load at least: so many cells over the radius of a disc as large as the body's front. Runs that are
/// all as coarse agree with one another.
const SHOCK: f64 = 0.2;

/// A value and where half the width of its band comes from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Banded {
    /// At no spacing.
    pub value: f64,
    /// Half width of the band.
    pub band: f64,
    /// Of that by the spacing.
    pub spacing: f64,
    /// By loads that swing.
    pub settling: f64,
    /// By an uneven surface.
    pub packing: f64,
    /// By what no inviscid flow can know.
    pub model: f64,
    /// Observed order.
    pub order: Option<f64>,
}

/// Coefficients at one Mach number and incidence.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// Mach number.
    pub mach: f64,
    /// Degrees.
    pub incidence: f64,
    /// Degrees.
    pub sideslip: f64,
    /// Drag.
    pub cd: f64,
    /// Half width of its band.
    pub cd_band: f64,
    /// Drag of what does not face away from the stream.
    pub cd_forebody: f64,
    /// Half width of its band.
    pub cd_forebody_band: f64,
    /// Drag of what faces away.
    pub cd_base: f64,
    /// Half width of its band.
    pub cd_base_band: f64,
    /// Lift.
    pub cl: f64,
    /// Half width of its band.
    pub cl_band: f64,
    /// Moment, positive nose up.
    pub cm: f64,
    /// Half width of its band.
    pub cm_band: f64,
    /// Force to the right of the body.
    pub cy: f64,
    /// Half width of its band.
    pub cy_band: f64,
    /// Moment about the body's axis upwards, positive nose right.
    pub cn_yaw: f64,
    /// Half width of its band.
    pub cn_yaw_band: f64,
    /// Moment about the body's length, positive right side down.
    pub cl_roll: f64,
    /// Half width of its band.
    pub cl_roll_band: f64,
    /// Behind the nose, in lengths of the body; none without a force across it.
    pub centre_of_pressure: Option<f64>,
    /// Half width of its band.
    pub centre_of_pressure_band: Option<f64>,
    /// None without lift.
    pub lift_to_drag: Option<f64>,
    /// What loads went on to swing by, per cent of the drag.
    pub settled_percent: f64,
    /// In the finest run.
    pub points_or_particles: usize,
    /// Of all runs.
    pub cpu_seconds: f64,
    /// How each band is made up.
    pub bands: Bands,
}

/// How each band is made up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bands {
    /// Of the drag.
    pub cd: Banded,
    /// Of that of the forebody.
    pub cd_forebody: Banded,
    /// Of that of the base.
    pub cd_base: Banded,
    /// Of the lift.
    pub cl: Banded,
    /// Of the moment.
    pub cm: Banded,
    /// Of the force to the right.
    pub cy: Banded,
    /// Of the moment nose right.
    pub cn_yaw: Banded,
    /// Of the moment about the length.
    pub cl_roll: Banded,
}

impl Point {
    /// From runs, coarse to fine, of a body that is thinner than two of the finest cells behind the part `thin` of its surface; none of
    /// no runs.
    pub fn new(flight: &Flight, levels: &[Level], thin: f64) -> Option<Self> {
        let last = levels.last()?;
        let doubted = ((thin - EDGES) / (UNSEEN - EDGES)).clamp(0.0, 1.0);
        let told = told(levels);
        let near_shocks = last.spacing / f64::from(1_u32 << flight.halvings());
        let shock = SHOCK * near_shocks / flight.front_radius();
        let at_none = |runs: &[(f64, f64)]| {
            let found = doubting(doubted, runs);
            Extrapolated {
                band: found.band.max(shock * found.value.abs()),
                ..found
            }
        };
        let banded = |of: fn(&Coefficients) -> f64, model: f64| {
            let told = told.iter();
            let runs: Vec<(f64, f64)> = told.map(|l| (l.spacing, of(&l.coefficients))).collect();
            let found = at_none(&runs);
            let settling = of(&last.swing).abs();
            let packing = last.open * found.value.abs();
            Banded {
                value: found.value,
                band: found.band + settling + packing + model,
                spacing: found.band,
                settling,
                packing,
                model,
                order: found.order,
            }
        };
        let model = last.base_area * half_of_base_pressures(flight.wishes.mach);
        let bands = Bands {
            cd: banded(|c| c.cd, model),
            cd_forebody: banded(|c| c.cd_forebody, 0.0),
            cd_base: banded(|c| c.cd_base, model),
            // A base that lies across the body is drawn back along it.
            cl: banded(
                |c| c.cl,
                model * flight.wishes.incidence.to_radians().tan().abs(),
            ),
            cm: banded(|c| c.cm, model * last.base_arms[0]),
            cy: banded(|c| c.cy, 0.0),
            cn_yaw: banded(|c| c.cn_yaw, model * last.base_arms[1]),
            cl_roll: banded(|c| c.cl_roll, 0.0),
        };
        let centres: Vec<(f64, f64)> = told
            .iter()
            .filter_map(|level| Some((level.spacing, centre(flight, &level.coefficients)?)))
            .collect();
        let centre = (centres.len() == told.len()).then(|| at_none(&centres));
        let has_lift = flight.dimension() == 3 && bands.cl.value.abs() > 1e-6;
        Some(Self {
            mach: flight.wishes.mach,
            incidence: flight.wishes.incidence,
            sideslip: flight.wishes.sideslip,
            cd: bands.cd.value,
            cd_band: bands.cd.band,
            cd_forebody: bands.cd_forebody.value,
            cd_forebody_band: bands.cd_forebody.band,
            cd_base: bands.cd_base.value,
            cd_base_band: bands.cd_base.band,
            cl: bands.cl.value,
            cl_band: bands.cl.band,
            cm: bands.cm.value,
            cm_band: bands.cm.band,
            cy: bands.cy.value,
            cy_band: bands.cy.band,
            cn_yaw: bands.cn_yaw.value,
            cn_yaw_band: bands.cn_yaw.band,
            cl_roll: bands.cl_roll.value,
            cl_roll_band: bands.cl_roll.band,
            centre_of_pressure: centre.map(|found| found.value),
            centre_of_pressure_band: centre.map(|found| found.band),
            lift_to_drag: has_lift.then(|| bands.cl.value / bands.cd.value),
            settled_percent: 100.0 * last.swing.cd
                / last.coefficients.cd.abs().max(f64::MIN_POSITIVE),
            points_or_particles: last.points,
            cpu_seconds: levels.iter().map(|level| level.cpu_seconds).sum(),
            bands,
        })
    }
}

/// The runs that a trend is looked for in: the finest, and those that settled; all where these are too few.
fn told(levels: &[Level]) -> Vec<&Level> {
    let finest = levels.len().saturating_sub(1);
    let settled = levels
        .iter()
        .enumerate()
        .filter(|(n, level)| *n == finest || level.settled);
    let settled: Vec<&Level> = settled.map(|(_, level)| level).collect();
    if settled.len() < LEAST {
        levels.iter().collect()
    } else {
        settled
    }
}

/// From runs whose trend is believed but for this part.
fn doubting(part: f64, runs: &[(f64, f64)]) -> Extrapolated {
    let (trend, none) = (extrapolate(runs), beyond(runs));
    if part == 0.0 {
        return trend;
    }
    let mix = |a: f64, b: f64| {
        if part < 1.0 {
            (1.0 - part) * a + part * b
        } else {
            b
        }
    };
    Extrapolated {
        value: mix(trend.value, none.value),
        band: mix(trend.band, none.band),
        order: trend.order.filter(|_| part < 1.0),
    }
}

/// Half of what lies between no drag and the most that a base can feel, as a pressure coefficient: a vacuum, `2 / (gamma M^2)`, or, in slow streams,
/// more than is measured behind any body in space [Hoerner 1965, Fluid-Dynamic Drag, chapter 3: 0.1 behind slender ones to 0.4 behind a disc].
fn half_of_base_pressures(mach: f64) -> f64 {
    const MOST_DRAWN: f64 = 1.0;
    0.5 * (2.0 / (GAMMA * mach * mach)).min(MOST_DRAWN)
}

#[cfg(test)]
mod tests {
    use super::*;

    use std::path::PathBuf;

    use aero_geometry::{bodies, stl};

    use super::super::wishes::{Air, Wishes};
    use crate::scene::shapes::StlEntry;

    /// A sphere of radius one in space, 10 degrees to a stream of Mach 2.
    fn flight() -> Flight {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("sphere.stl");
        let mut bytes = Vec::new();
        let facets = bodies::sphere(1.0).unwrap().tessellate(24);
        stl::write_binary(&mut bytes, &facets).unwrap();
        std::fs::write(&file, bytes).unwrap();
        Flight::new(Wishes {
            body: StlEntry {
                file,
                ..StlEntry::default()
            },
            axes: Some("-x,+y".parse().unwrap()),
            roll: 0.0,
            mach: 2.0,
            incidence: 10.0,
            sideslip: 0.0,
            air: Air::State(1e5, 300.0),
            with_the_gas: false,
            area: None,
            length: None,
            centre: None,
        })
        .unwrap()
    }

    fn level(spacing: f64, value: f64, settled: bool) -> Level {
        Level {
            spacing,
            finest: spacing,
            folder: PathBuf::new(),
            points: 1,
            steps: 1,
            wall_seconds: 1.0,
            cpu_seconds: 1.0,
            settled,
            end: String::new(),
            coefficients: Coefficients {
                cd: value,
                cd_forebody: value,
                cd_base: 0.0,
                cl: value,
                cm: value,
                cy: value,
                cn_yaw: value,
                cl_roll: value,
            },
            swing: Coefficients::default(),
            open: 0.0,
            base_area: 0.5,
            base_arms: [0.1, 0.2],
            warnings: Vec::new(),
            near_sides: Vec::new(),
        }
    }

    /// Four runs that agree to a millionth.
    #[test]
    fn no_band_is_narrower_than_shocks_allow_and_what_a_base_may_be_counts_in_all() {
        let flight = flight();
        let runs: Vec<Level> = (0..4)
            .map(|n| level(0.4 / f64::from(1 << n), 1.0 + 1e-6 * f64::from(n % 2), true))
            .collect();
        let Bands {
            cd,
            cd_forebody,
            cl,
            cm,
            cy,
            cn_yaw,
            ..
        } = Point::new(&flight, &runs, 0.0).unwrap().bands;
        let least = 0.2 * 0.05 / f64::from(1 << flight.halvings()) / flight.front_radius();
        for banded in [cd, cd_forebody, cl, cm, cy] {
            assert!((banded.spacing - least).abs() < 1e-3 * least, "{banded:?}");
        }
        let model = 0.5 / (1.4 * 4.0);
        assert!((cd.model - model).abs() < 1e-12 && cd_forebody.model == 0.0);
        assert!((cl.model - model * 10_f64.to_radians().tan()).abs() < 1e-12);
        assert!((cm.model - 0.1 * model).abs() < 1e-12);
        assert!((cn_yaw.model - 0.2 * model).abs() < 1e-12 && cy.model == 0.0);
    }

    #[test]
    fn a_run_that_did_not_settle_is_left_out_where_three_did() {
        let mut runs = vec![level(0.8, 9.0, false)];
        runs.extend([0.4, 0.2, 0.1].map(|h| level(h, 1.0 + h, true)));
        let spacings = |runs: &[Level]| told(runs).iter().map(|l| l.spacing).collect::<Vec<_>>();
        assert_eq!(spacings(&runs), [0.4, 0.2, 0.1]);
        // Of too few all count, and the finest always does.
        assert_eq!(spacings(&runs[..3]), [0.8, 0.4, 0.2]);
        runs[3].settled = false;
        assert_eq!(spacings(&runs), [0.4, 0.2, 0.1]);
    }

    #[test]
    fn the_less_of_a_body_is_seen_the_less_its_trend_is_believed() {
        let runs = [(0.4, 1.08), (0.2, 1.04), (0.1, 1.02)];
        let (all, none) = (extrapolate(&runs), beyond(&runs));
        assert!(all.band < none.band);
        assert_eq!(doubting(0.0, &runs), all);
        assert_eq!(doubting(1.0, &runs), none);
        let half = doubting(0.5, &runs);
        assert!((half.band - 0.5 * (all.band + none.band)).abs() < 1e-12);
        assert!((half.value - 0.5 * (all.value + none.value)).abs() < 1e-12);
        assert!(doubting(0.5, &runs[..1]).band.is_infinite());
    }
}
