//! The limits of a packing: beyond them its report warns, or the body is refused.

use crate::cover::COVERED;
use crate::{About, PackError, PackReport, Warning};

/// Most of the surface, per cent, that may be without ghosts before a warning.
const UNCOVERED: f64 = 0.1;

/// Most of the surface, per cent, that may be without ghosts at all, unless the loss is allowed.
const LOST: f64 = 2.0;

/// Largest error of the volume, per cent.
pub(crate) const VOLUME: f64 = 1.0;

/// Least distance between two ghosts, in spacings, that is not worth a word; round-off aside.
const GAP: f64 = 0.5 - 1e-6;

/// What of `report` is over its limit.
pub(crate) fn warnings(report: &PackReport) -> Vec<Warning> {
    let mut found = Vec::new();
    let spacing = report.spacing;
    if report.uncovered_area_percent > UNCOVERED {
        found.push(Warning::new(
            About::Cover,
            format!(
                "{:.1} % of the surface is farther than {COVERED} spacings from every ghost, the largest hole {:.1} spacings near {:.4?}: gas \
                 may enter the body there; a spacing of {:.2e} or less closes it",
                report.uncovered_area_percent,
                report.hole_max,
                report.hole_at,
                spacing * COVERED / report.hole_max
            ),
        ));
    }
    if report.volume_error_percent.abs() > VOLUME {
        found.push(Warning::new(
            About::Volume,
            format!(
                "the volume of the packed solid is {:+.1} % off the body's: choose a smaller spacing than {spacing}",
                report.volume_error_percent
            ),
        ));
    }
    if report.coincident_ghosts > 0 || report.min_gap < GAP {
        found.push(Warning::new(
            About::Gap,
            format!(
                "{} ghosts are closer than half a spacing to another one, the closest {:.2} spacings: density is too high there; choose a \
                 smaller spacing than {spacing}",
                report.coincident_ghosts, report.min_gap
            ),
        ));
    }
    found
}

/// Refuses a packing that has lost part of the body.
pub(crate) fn check_loss(report: &PackReport, is_allowed: bool) -> Result<(), PackError> {
    let percent = report.uncovered_area_percent;
    if is_allowed || percent <= LOST {
        return Ok(());
    }
    Err(PackError::Lost {
        percent,
        hole: report.hole_max,
        at: report.hole_at.clone(),
        spacing: report.spacing,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(uncovered: f64) -> PackReport {
        PackReport {
            spacing: 0.1,
            min_gap: 0.7,
            uncovered_area_percent: uncovered,
            hole_max: 2.5,
            hole_at: vec![1.0, 2.0, 3.0],
            ..PackReport::default()
        }
    }

    #[test]
    fn a_body_that_loses_more_than_two_per_cent_of_its_surface_is_refused_unless_that_is_allowed() {
        assert!(check_loss(&report(1.9), false).is_ok());
        assert!(check_loss(&report(2.1), true).is_ok());
        let error = check_loss(&report(2.1), false).unwrap_err().to_string();
        assert!(
            error.contains("2.1 %") && error.contains("at most 0.04,"),
            "{error}"
        );
    }

    #[test]
    fn what_is_over_its_limit_is_warned_of_and_nothing_else() {
        assert!(warnings(&report(0.0)).is_empty());
        let about = |report: &PackReport| -> Vec<About> {
            warnings(report)
                .iter()
                .map(|warning| warning.about)
                .collect()
        };
        assert_eq!(about(&report(0.2)), [About::Cover]);
        let bad = PackReport {
            volume_error_percent: -1.2,
            coincident_ghosts: 4,
            ..report(0.0)
        };
        assert_eq!(about(&bad), [About::Volume, About::Gap]);
    }
}
