//! `report.html`, a page that needs nothing else; `fly.json`; the table of the terminal.

use std::fmt::Write as _;
use std::path::Path;

use serde::Serialize;

use super::body_view::Skin;
use super::error::FlyError;
use super::figure::escaped;
use super::flight::Flight;
use super::level::Level;
use super::polar_point::{Banded, EDGES, Point, UNSEEN};
use super::{curves, pictures, skins};
use crate::output::write_json;

/// What is said where a body is thinner than two of the `finest` cells behind a part of its surface that is more than edges.
fn thin_words(thin: f64, finest: f64) -> Option<String> {
    (thin > EDGES).then(|| {
        format!(
            "behind {:.0} % of the surface the body is thinner than two of the finest cells, {finest:.2e} m each: give more --minutes, or a \
             smaller --spacing",
            100.0 * thin
        )
    })
}

/// The same of a flight whose finest cells are so wide.
pub fn thin_warning(flight: &Flight, finest: f64) -> Option<String> {
    let [thin, _] = skins::thin_parts(&skins::by_thickness(flight, finest));
    thin_words(thin, finest)
}

/// What came of a flight.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Name of the body.
    pub body: String,
    /// How it lies and what is computed, in words.
    pub attitude: Vec<String>,
    /// Coefficients with their bands.
    pub points: Vec<Point>,
    /// Area that they refer to, m2.
    pub reference_area: f64,
    /// Length, m.
    pub reference_length: f64,
    /// Point of the moments, m behind the nose.
    pub moment_centre: f64,
    /// The same above the middle of the body's box, and to the left of it.
    pub moment_centre_across: [f64; 2],
    /// The runs, coarse to fine.
    pub levels: Vec<Level>,
    /// What the user should know.
    pub warnings: Vec<String>,
    /// The surface by how many of the finest cells lie across the body.
    #[serde(skip)]
    thickness: Skin,
}

impl Report {
    /// Of runs, coarse to fine.
    ///
    /// # Errors
    /// Where there are none.
    pub fn new(
        flight: &Flight,
        attitude: Vec<String>,
        levels: Vec<Level>,
        mut warnings: Vec<String>,
    ) -> Result<Self, FlyError> {
        let thickness = levels
            .last()
            .map(|level| skins::by_thickness(flight, level.finest))
            .unwrap_or_default();
        let [thin, _] = skins::thin_parts(&thickness);
        let point = Point::new(flight, &levels, thin);
        let point = point
            .ok_or_else(|| FlyError::Files("no run came far enough to tell anything".into()))?;
        warnings.extend(
            levels
                .last()
                .into_iter()
                .flat_map(|level| level.warnings.clone()),
        );
        let finest = levels.last().map_or(0.0, |level| level.finest);
        if let Some(words) = thin_words(thin, finest) {
            let wide = if thin > UNSEEN {
                "; bands are three times what all runs differ by, for none of them has seen its shape"
            } else {
                "; bands are the wider for it"
            };
            warnings.push(words + wide);
        }
        for level in &levels {
            if !level.settled {
                warnings.push(format!(
                    "the run at spacing {:.3e} did not settle: {}",
                    level.spacing, level.end
                ));
            }
        }
        if levels.len() < 3 {
            warnings.push(format!(
                "{} spacings fitted the budget, three are needed to see an order: the band is three times the difference of two, or \
                 unknown of one; give more --minutes",
                levels.len()
            ));
        }
        Ok(Self {
            body: flight.name.clone(),
            attitude,
            points: vec![point],
            reference_area: flight.area,
            reference_length: flight.reference_length(),
            moment_centre: flight.centre(),
            moment_centre_across: flight.centre_across(),
            levels,
            warnings,
            thickness,
        })
    }

    /// The table for the terminal.
    pub fn text(&self) -> String {
        let mut text = format!(
            "{:24} {:>10} {:>10}   {:>8} {:>8} {:>8} {:>8}  {}\n",
            "", "value", "+-", "spacing", "settling", "packing", "model", "order"
        );
        for (name, banded) in self.rows() {
            let order = banded
                .order
                .map_or("-".into(), |order| format!("{order:.1}"));
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "{name:24} {:>10.5} {:>10.5}   {:>8.5} {:>8.5} {:>8.5} {:>8.5}  {order}",
                banded.value,
                banded.band,
                banded.spacing,
                banded.settling,
                banded.packing,
                banded.model
            );
        }
        for (name, value, band) in self.others() {
            let _ = writeln!(
                text,
                "{name:24} {value:>10.4} {}",
                band.map_or(String::new(), |band| format!("{band:>10.4}"))
            );
        }
        let _ = writeln!(
            text,
            "of gauge pressure, area {:.5e} m2, length {:.4} m, moments about {:.4} m behind the nose",
            self.reference_area, self.reference_length, self.moment_centre
        );
        for warning in &self.warnings {
            let _ = writeln!(text, "warning: {warning}");
        }
        text
    }

    /// How many runs there are and how fine they got, with so many halvings near shocks.
    pub fn runs_words(&self, halvings: u8) -> String {
        let finest = self.levels.iter().map(|level| level.spacing);
        let finest = finest.fold(f64::INFINITY, f64::min) / f64::from(1_u32 << halvings);
        let count = self.levels.len();
        let runs = if count == 1 { "run" } else { "runs" };
        format!("{count} {runs}, down to a spacing of {finest:.3e} m near shocks")
    }

    fn rows(&self) -> Vec<(&'static str, Banded)> {
        let Some(point) = self.points.first() else {
            return Vec::new();
        };
        let mut rows = vec![
            ("cd, drag", point.bands.cd),
            ("  of the forebody", point.bands.cd_forebody),
        ];
        let has_base = |level: &Level| level.base_area > 0.0;
        if self.levels.last().is_some_and(has_base) {
            rows.push(("  of the base", point.bands.cd_base));
        }
        if point.bands.cl.value != 0.0 || point.bands.cm.value != 0.0 {
            rows.push(("cl, lift", point.bands.cl));
            rows.push(("cm, nose up", point.bands.cm));
        }
        if point.bands.cy.value != 0.0 {
            rows.push(("cy, to the right", point.bands.cy));
            rows.push(("cn_yaw, nose right", point.bands.cn_yaw));
            rows.push(("cl_roll, right side down", point.bands.cl_roll));
        }
        rows
    }

    fn others(&self) -> Vec<(&'static str, f64, Option<f64>)> {
        let point = self.points.first();
        let ratio = point
            .and_then(|point| point.lift_to_drag)
            .map(|ratio| ("L/D", ratio, None));
        let centre = point.and_then(|point| {
            Some((
                "centre of pressure, x/L",
                point.centre_of_pressure?,
                point.centre_of_pressure_band,
            ))
        });
        ratio.into_iter().chain(centre).collect()
    }
}

const STYLE: &str = "body{font:15px/1.5 system-ui,sans-serif;max-width:1180px;margin:2rem auto;padding:0 1rem;color:#19191c}\
h1{font-size:1.6rem}h2{font-size:1.2rem;margin-top:2.2rem;border-bottom:1px solid #e4e5e9}\
table{border-collapse:collapse;font-variant-numeric:tabular-nums}td,th{padding:.25rem .8rem;text-align:right;border-bottom:1px solid #e4e5e9}\
td:first-child,th:first-child{text-align:left}.two{display:grid;grid-template-columns:repeat(auto-fit,minmax(440px,1fr));gap:1rem}\
figure{margin:0}figcaption{color:#555;font-size:.9rem}svg{width:100%;height:auto}svg text{font:12px system-ui,sans-serif;fill:#333}\
.frame{fill:none;stroke:#888}.stream{stroke:#d62728;stroke-width:3}.head{fill:#d62728}.warning{background:#fff4d6;padding:.4rem .8rem;margin:.3rem 0}";

/// Writes `fly.json` and `report.html`.
///
/// # Errors
/// Files that cannot be read back or written.
pub fn write_report(flight: &Flight, report: &Report, folder: &Path) -> Result<(), FlyError> {
    let files = |error: &dyn std::fmt::Display| FlyError::Files(error.to_string());
    write_json(&folder.join("fly.json"), report).map_err(|error| files(&error))?;
    let page = page(flight, report, folder)?;
    std::fs::write(folder.join("report.html"), page).map_err(|error| files(&error))
}

fn page(flight: &Flight, report: &Report, folder: &Path) -> Result<String, FlyError> {
    let w = &flight.wishes;
    let mut title = format!("{} at Mach {}", report.body, w.mach);
    for (name, angle) in [("incidence", w.incidence), ("sideslip", w.sideslip)] {
        if angle != 0.0 {
            let _ = write!(title, ", {name} {angle}°");
        }
    }
    let mut page = format!(
        "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title><style>{STYLE}</style></head><body><h1>{0}</h1>",
        escaped(&title)
    );
    let mut part = |heading: &str, content: &str| {
        // Writing to a string cannot fail.
        let _ = write!(page, "<h2>{heading}</h2>{content}");
    };
    part("Coefficients", &table(flight, report));
    let warnings: Vec<String> = report
        .warnings
        .iter()
        .map(|warning| format!("<p class=\"warning\">{}</p>", escaped(warning)))
        .collect();
    let none = "<p>none</p>".to_owned();
    part(
        "Warnings",
        if warnings.is_empty() {
            none
        } else {
            warnings.concat()
        }
        .as_str(),
    );
    let lines: Vec<String> = report
        .attitude
        .iter()
        .map(|line| format!("<li>{}</li>", escaped(line)))
        .collect();
    let lies = format!(
        "<ul>{}</ul>{}",
        lines.concat(),
        abreast(&pictures::attitude(flight))
    );
    part("How the body lies", &lies);
    if let (Some(level), Some(point)) = (report.levels.last(), report.points.first()) {
        part(
            "Pressure on the body",
            &abreast(&pictures::pressure(flight, level)?),
        );
        part("The flow", &abreast(&pictures::planes(flight, level)?));
        let curves = curves::draw(flight, &report.levels, point, folder)?;
        part(
            "Convergence",
            &format!("<figure>{curves}</figure>{}", runs(report)),
        );
        let [two, four] = skins::thin_parts(&report.thickness).map(|part| 100.0 * part);
        let says = format!(
            "<p>Behind {two:.1} % of the surface the body is thinner than two of the finest cells, behind {four:.1} % than four; yellow is \
             {} and more.</p>",
            skins::ENOUGH
        );
        part(
            "How finely thin parts are resolved",
            &(says + &abreast(&pictures::thickness(&report.thickness))),
        );
    }
    page.push_str("</body></html>\n");
    Ok(page)
}

fn abreast(figures: &[String]) -> String {
    format!("<div class=\"two\">{}</div>", figures.concat())
}

fn table(flight: &Flight, report: &Report) -> String {
    let mut text = "<table><tr><th></th><th>value</th><th>±</th><th>spacing</th><th>settling</th><th>packing</th><th>model</th><th>order</th></tr>".to_owned();
    for (name, b) in report.rows() {
        let order = b.order.map_or("–".into(), |order| format!("{order:.1}"));
        let _ = write!(
            text,
            "<tr><td>{name}</td><td>{:.5}</td><td>{:.5}</td><td>{:.5}</td><td>{:.5}</td><td>{:.5}</td><td>{:.5}</td><td>{order}</td></tr>",
            b.value, b.band, b.spacing, b.settling, b.packing, b.model
        );
    }
    for (name, value, band) in report.others() {
        let band = band.map_or(String::new(), |band| format!("{band:.4}"));
        let _ = write!(
            text,
            "<tr><td>{name}</td><td>{value:.4}</td><td>{band}</td></tr>"
        );
    }
    let _ = write!(
        text,
        "</table><p>Of gauge pressure; area {:.5e} m², length {:.4} m, {}. An inviscid base has no exact \
         answer: its model band is half of what lies between no drag and a vacuum, or a pressure coefficient of -1 where that is more.</p>",
        report.reference_area,
        report.reference_length,
        flight.centre_words()
    );
    text
}

fn runs(report: &Report) -> String {
    let mut text = "<table><tr><th>spacing, m</th><th>finest, m</th><th>points</th><th>iterations</th><th>processor s</th><th>cd</th><th>forebody</th><th>cl</th><th>cm</th><th>end</th></tr>".to_owned();
    for level in &report.levels {
        let c = &level.coefficients;
        let _ = write!(
            text,
            "<tr><td>{:.4e}</td><td>{:.4e}</td><td>{}</td><td>{}</td><td>{:.1}</td><td>{:.5}</td><td>{:.5}</td><td>{:.5}</td><td>{:.5}</td><td>{}</td></tr>",
            level.spacing,
            level.finest,
            level.points,
            level.steps,
            level.cpu_seconds,
            c.cd,
            c.cd_forebody,
            c.cl,
            c.cm,
            escaped(&level.end)
        );
    }
    text + "</table>"
}
