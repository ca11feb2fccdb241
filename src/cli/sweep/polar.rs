//! The table of a sweep: a row for each point and body, as text, CSV, JSON and a picture.

use std::fmt::Write as _;
use std::path::Path;

use aero::fly::{Flight, Shares};
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use serde::Serialize;
use serde_json::Value;

use crate::cli::CommandError;

/// Coefficients of one body at one point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Mach number of the stream; absent where neither sweep nor scene states it.
    pub mach: Option<f64>,
    /// Angle of attack, degrees; absent where neither sweep nor scene states it.
    pub incidence: Option<f64>,
    /// Sideslip, degrees; absent where neither sweep nor scene states it.
    pub sideslip: Option<f64>,
    /// The point whose mirror image this one is: it is not run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mirror_of: Option<String>,
    /// Name of the body.
    pub body: String,
    /// Drag coefficient.
    pub cd: Option<f64>,
    /// Lift coefficient.
    pub cl: Option<f64>,
    /// Moment coefficient, positive nose up.
    pub cm: Option<f64>,
    /// Drag of what does not face away from the stream; of a body from its file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cd_forebody: Option<f64>,
    /// Drag of what does; of a body from its file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cd_base: Option<f64>,
    /// Behind the nose, in lengths; of a body from its file, where a force is across it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre_of_pressure: Option<f64>,
    /// Lift over drag.
    pub lift_to_drag: Option<f64>,
    /// True where the flow had become steady.
    pub settled: bool,
    /// What the forces went on to swing by, per cent.
    pub settled_percent: Option<f64>,
    /// In the run.
    pub points_or_particles: u64,
    /// What the run said when it ended.
    pub end: String,
    /// Steps or iterations.
    pub steps: u64,
    /// Processor time, s.
    pub cpu_seconds: f64,
}

/// Which point of a sweep: Mach number, incidence, sideslip.
pub type Point = [Option<f64>; 3];

/// The rows of a run's summary.
pub fn rows(point: Point, summary: &Value) -> Vec<Row> {
    let [mach, incidence, sideslip] = point;
    let end = summary["stop_reason"]
        .as_str()
        .unwrap_or_default()
        .to_owned();
    let settled = end.starts_with("steady") || end.starts_with("settled");
    // A flow that goes through time is known by its mean, one that settles by where it came to rest.
    let is_mean = summary["motion"] != "fixed" || !end.starts_with("settled after");
    let bodies = summary["bodies"].as_object().into_iter().flatten();
    let row = |(name, body): (&String, &Value)| {
        let coefficient = |key: &str| {
            let mean = body[format!("{key}_mean")].as_f64().filter(|_| is_mean);
            mean.or_else(|| body[key].as_f64())
        };
        let (cd, cl) = (coefficient("cd"), coefficient("cl"));
        Row {
            mach,
            incidence,
            sideslip,
            mirror_of: None,
            body: name.clone(),
            cd,
            cl,
            cm: coefficient("cm"),
            cd_forebody: None,
            cd_base: None,
            centre_of_pressure: None,
            lift_to_drag: cd.zip(cl).map(|(cd, cl)| cl / cd),
            settled,
            settled_percent: coefficient("settled_percent"),
            points_or_particles: summary["particles"]["fluid"].as_u64().unwrap_or(0),
            end: end.clone(),
            steps: summary["steps"].as_u64().unwrap_or(0),
            cpu_seconds: summary["cpu_seconds"].as_f64().unwrap_or(0.0),
        }
    };
    bodies.map(row).collect()
}

impl Row {
    /// Parts the drag into that of forebody and base, and finds where the force across the body stands, by what a run of `flight` has left in `folder`.
    pub fn part(&mut self, flight: &Flight, folder: &Path) -> Result<(), CommandError> {
        let w = &flight.wishes;
        let stream = [
            self.mach.unwrap_or(w.mach),
            self.incidence.unwrap_or(w.incidence),
            self.sideslip.unwrap_or(w.sideslip),
        ];
        let Some(cd) = self.cd else {
            return Ok(());
        };
        let whole = [cd, self.cl.unwrap_or(0.0), self.cm.unwrap_or(0.0)];
        let shares = Shares::read(&flight.in_stream(stream), folder, whole);
        let shares = shares.map_err(CommandError::failed)?;
        self.cd_forebody = Some(shares.cd_forebody);
        self.cd_base = Some(shares.cd_base);
        self.centre_of_pressure = shares.centre_of_pressure;
        Ok(())
    }

    /// The row of a stream that comes from the other side of a flow with a mirror across its lift, where this is that of the point `name`.
    pub fn mirrored(&self, name: &str) -> Self {
        let other = |value: Option<f64>| value.map(|value| 0.0 - value);
        Self {
            incidence: other(self.incidence),
            cl: other(self.cl),
            cm: other(self.cm),
            lift_to_drag: other(self.lift_to_drag),
            mirror_of: Some(name.to_owned()),
            steps: 0,
            cpu_seconds: 0.0,
            ..self.clone()
        }
    }
}

/// The table for people.
pub fn text(rows: &[Row]) -> String {
    let mut text = format!(
        "{:>8} {:>9} {:>8}  {:12} {:>9} {:>9} {:>9} {:>8}  {}\n",
        "Mach", "incidence", "sideslip", "body", "cd", "cl", "cm", "L/D", "settled"
    );
    let number = |value: Option<f64>, width: usize, digits: usize| {
        value.map_or(format!("{:>width$}", "-"), |value| {
            format!("{value:>width$.digits$}")
        })
    };
    for row in rows {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{} {} {}  {:12} {} {} {} {}  {}",
            number(row.mach, 8, 3),
            number(row.incidence, 9, 2),
            number(row.sideslip, 8, 2),
            row.body,
            number(row.cd, 9, 5),
            number(row.cl, 9, 5),
            number(row.cm, 9, 5),
            number(row.lift_to_drag, 8, 3),
            if row.settled { "yes" } else { "NO" },
        );
    }
    text
}

/// Writes `sweep.csv`, `sweep.json` and, where there is something to draw, `sweep.svg`.
pub fn write(rows: &[Row], folder: &Path) -> Result<(), CommandError> {
    let json = serde_json::to_string_pretty(rows).map_err(CommandError::failed)?;
    for (name, content) in [("sweep.csv", csv(rows)), ("sweep.json", json)] {
        let path = folder.join(name);
        std::fs::write(&path, content).map_err(|error| {
            CommandError::failed(format!("cannot write `{}`: {error}", path.display()))
        })?;
    }
    let Some(picture) = picture(rows) else {
        return Ok(());
    };
    picture
        .save(&folder.join("sweep.svg"))
        .map_err(CommandError::failed)
}

fn csv(rows: &[Row]) -> String {
    let mut text =
        "mach,incidence,sideslip,body,cd,cl,cm,lift_to_drag,settled,settled_percent,points_or_particles,steps,cpu_seconds,cd_forebody,cd_base,centre_of_pressure\n"
            .to_owned();
    let number = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
    for row in rows {
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
            number(row.mach),
            number(row.incidence),
            number(row.sideslip),
            quoted(&row.body),
            number(row.cd),
            number(row.cl),
            number(row.cm),
            number(row.lift_to_drag),
            row.settled,
            number(row.settled_percent),
            row.points_or_particles,
            row.steps,
            row.cpu_seconds,
            number(row.cd_forebody),
            number(row.cd_base),
            number(row.centre_of_pressure),
        );
    }
    text
}

/// A name as CSV wants it.
fn quoted(name: &str) -> String {
    if name.contains([',', '"', '\n']) {
        format!("\"{}\"", name.replace('"', "\"\""))
    } else {
        name.to_owned()
    }
}

/// A number of each row.
type Column = fn(&Row) -> Option<f64>;

/// Drag, lift and moment against what is swept most finely, a line for each value of the others; none of a single point.
fn picture(rows: &[Row]) -> Option<Curves> {
    let keys: [(&str, Column); 3] = [
        ("incidence, degrees", |row| row.incidence),
        ("Mach number", |row| row.mach),
        ("sideslip, degrees", |row| row.sideslip),
    ];
    let count = |of: Column| {
        let mut found: Vec<f64> = rows.iter().filter_map(of).collect();
        found.sort_by(f64::total_cmp);
        found.dedup();
        found.len()
    };
    let (x_label, x_of) = keys.into_iter().rev().max_by_key(|(_, of)| count(*of))?;
    if count(x_of) < 2 {
        return None;
    }
    let label = |row: &Row| {
        let mut words = vec![row.body.clone()];
        for (name, of) in keys.into_iter().filter(|(name, _)| *name != x_label) {
            if let Some(value) = of(row).filter(|_| count(of) > 1) {
                words.push(format!(
                    "{} {value}",
                    name.split(',').next().unwrap_or(name)
                ));
            }
        }
        words.join(", ")
    };
    let values: [(&str, Column); 4] = [
        ("cd", |row| row.cd),
        ("cl", |row| row.cl),
        ("cm", |row| row.cm),
        ("L/D", |row| row.lift_to_drag),
    ];
    let panels = values.map(|(y_label, y_of)| {
        let mut series: Vec<Series> = Vec::new();
        for row in rows {
            let (Some(x), Some(y)) = (x_of(row), y_of(row)) else {
                continue;
            };
            let name = label(row);
            match series.iter_mut().find(|series| series.label == name) {
                Some(series) => series.points.push([x, y]),
                None => series.push(Series::new(&name, Style::Line, vec![[x, y]])),
            }
        }
        for series in &mut series {
            series.points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        }
        Panel::new(x_label, y_label, series)
    });
    Some(Curves {
        title: "Polar".to_owned(),
        panels: panels.to_vec(),
        columns: 2,
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_settled_flow_is_known_by_its_end_and_another_by_its_mean() {
        let summary = |motion: &str, end: &str| {
            json!({"motion": motion, "stop_reason": end, "steps": 7, "cpu_seconds": 1.5,
                "bodies": {"wing": {"cd": 0.2, "cl": 0.6, "cm": null, "cd_mean": 0.1, "cl_mean": 0.4}}})
        };
        let point = [Some(2.0), Some(4.0), None];
        let row = &rows(point, &summary("fixed", "settled after 9 iterations"))[0];
        assert_eq!((row.cd, row.settled, row.cm), (Some(0.2), true, None));
        assert!((row.lift_to_drag.unwrap() - 3.0).abs() < 1e-12);
        let row = &rows(point, &summary("fixed", "not settled: forces"))[0];
        assert_eq!((row.cd, row.settled), (Some(0.1), false));
        let row = &rows(point, &summary("with-the-gas", "steady: forces"))[0];
        assert_eq!((row.cd, row.settled), (Some(0.1), true));
        assert!(text(&rows(point, &summary("fixed", "not settled"))).contains("NO"));
    }
}
