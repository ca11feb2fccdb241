//! Speed against accuracy: error over CPU seconds on log axes, a line per variant with its spacings
//! written beside the points, and peers' measured points among them.

use super::PictureError;
use super::axes::{Axis, Frame, HEADING, SMALL, range_of};
use super::canvas::{Anchor, Drawing, Pen, Stroke, save};
use super::colour::{Colour, GREY, palette};
use super::font::Font;
use super::legend::{Entry, draw_legend, legend_size};
use crate::reference::{Table, TableError};
use plotters::backend::DrawingBackend;
use std::fmt::Write as _;
use std::path::Path;

/// One run.
#[derive(Clone, Debug, PartialEq)]
pub struct SpeedPoint {
    /// What tells it apart, usually the spacing: `1/16`.
    pub label: String,
    /// CPU seconds, all threads together.
    pub cpu_seconds: f64,
    /// Size of the error, in the chart's unit.
    pub error: f64,
}

/// Runs of one variant or of one other code.
#[derive(Clone, Debug, PartialEq)]
pub struct SpeedSeries {
    /// Name for the legend.
    pub name: String,
    /// Another code's published or measured points: drawn grey and dashed.
    pub peer: bool,
    /// Runs, coarse to fine.
    pub points: Vec<SpeedPoint>,
}

/// The chart of one case.
#[derive(Clone, Debug, PartialEq)]
pub struct SpeedChart {
    /// Heading.
    pub title: String,
    /// What the error is, with its unit.
    pub error_label: String,
    /// Variants and peers.
    pub series: Vec<SpeedSeries>,
}

impl SpeedChart {
    /// Draws the chart into a `.svg` or `.png` file. Runs without a positive error and time have no
    /// place on log axes and are left out (they stay in the table).
    pub fn save(&self, path: &Path) -> Result<(), PictureError> {
        let page = self
            .layout()
            .ok_or_else(|| PictureError::Empty(self.title.clone()))?;
        save(&page, path)
    }

    /// The runs as comma-separated values.
    pub fn to_csv(&self) -> String {
        let mut text = String::from("series,peer,label,cpu_seconds,error\n");
        for series in &self.series {
            for point in &series.points {
                let _ = writeln!(
                    text,
                    "{},{},{},{},{}",
                    quoted(&series.name),
                    series.peer,
                    quoted(&point.label),
                    point.cpu_seconds,
                    point.error
                );
            }
        }
        text
    }

    /// Writes [`to_csv`](Self::to_csv) into a file.
    pub fn save_csv(&self, path: &Path) -> Result<(), PictureError> {
        std::fs::write(path, self.to_csv()).map_err(|e| PictureError::Write {
            path: path.to_owned(),
            reason: e.to_string(),
        })
    }

    fn layout(&self) -> Option<Page<'_>> {
        let points = || {
            self.series
                .iter()
                .flat_map(|s| &s.points)
                .filter(|p| drawable(p))
        };
        let axis = |label: &str, range| Axis {
            label: label.to_owned(),
            range,
            log: true,
        };
        let x = axis(
            "CPU time, s",
            range_of(points().map(|p| p.cpu_seconds), true, 0.08)?,
        );
        let y = axis(
            &self.error_label,
            range_of(points().map(|p| p.error), true, 0.1)?,
        );
        let left = Frame::margin_left(&y, 560.0) + 8.0;
        Some(Page {
            chart: self,
            frame: Frame {
                x,
                y,
                left,
                right: left + 760.0,
                top: 56.0,
                bottom: 616.0,
            },
        })
    }

    /// Colours: the palette's in turn for our own variants, shades of grey for peers.
    fn colours(&self) -> Vec<Colour> {
        let (mut own, mut peers) = (0, 0);
        self.series
            .iter()
            .map(|s| {
                if s.peer {
                    peers += 1;
                    let lift = 35 * ((peers - 1) % 3) as u8;
                    GREY.map(|v| v.saturating_add(lift))
                } else {
                    own += 1;
                    palette(own - 1)
                }
            })
            .collect()
    }
}

/// Peers' points from a table with a `name` column, a `cell` and a `cpu_seconds` column, the error's
/// size taken from `column`; rows of one name make one series, labelled by their cell as `1/16`.
pub fn peers(table: &Table, column: &str) -> Result<Vec<SpeedSeries>, TableError> {
    let (cell, seconds) = (table.column("cell")?, table.column("cpu_seconds")?);
    let error = table.column(column)?;
    let mut series: Vec<SpeedSeries> = Vec::new();
    for (row, name) in table.labels().iter().enumerate() {
        let point = SpeedPoint {
            label: format!("1/{:.0}", 1.0 / cell[row]),
            cpu_seconds: seconds[row],
            error: error[row].abs(),
        };
        match series.iter_mut().find(|s| s.name == *name) {
            Some(same) => same.points.push(point),
            None => series.push(SpeedSeries {
                name: name.clone(),
                peer: true,
                points: vec![point],
            }),
        }
    }
    Ok(series)
}

fn drawable(point: &SpeedPoint) -> bool {
    [point.cpu_seconds, point.error]
        .iter()
        .all(|v| *v > 0.0 && v.is_finite())
}

/// A cell of comma-separated values, in quotes where it needs them.
fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}

struct Page<'a> {
    chart: &'a SpeedChart,
    frame: Frame,
}

impl Page<'_> {
    fn entries(&self) -> Vec<Entry> {
        self.chart
            .series
            .iter()
            .zip(self.chart.colours())
            .map(|(s, colour)| Entry {
                label: s.name.clone(),
                colour,
                line: Some(s.peer),
                dots: true,
            })
            .collect()
    }
}

impl Drawing for Page<'_> {
    fn size(&self) -> [f64; 2] {
        let legend = legend_size(&self.entries())[0];
        [
            self.frame.right + 20.0 + legend + 16.0,
            self.frame.bottom + 66.0,
        ]
    }

    fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        pen.text(
            &self.chart.title,
            [self.frame.left, 28.0],
            HEADING,
            Anchor::Left,
        )?;
        self.frame.draw_grid(pen)?;
        for (number, (series, colour)) in self
            .chart
            .series
            .iter()
            .zip(self.chart.colours())
            .enumerate()
        {
            // The lines fall to the right: above right and below left of a point is free.
            let (offset, anchor) = if number % 2 == 0 {
                ([9.0, -11.0], Anchor::Left)
            } else {
                ([-8.0, 13.0], Anchor::Right)
            };
            let points: Vec<&SpeedPoint> = series.points.iter().filter(|p| drawable(p)).collect();
            let path: Vec<[f64; 2]> = points.iter().map(|p| [p.cpu_seconds, p.error]).collect();
            let stroke = Stroke {
                colour,
                width: 2.2,
                dashed: series.peer,
            };
            self.frame.draw_line(pen, &path, stroke)?;
            let note = Font {
                colour,
                ..Font::plain(SMALL - 2.0)
            };
            for (point, at) in points.iter().zip(path) {
                let [x, y] = self.frame.place(at);
                pen.disc([x, y], 5.0, colour)?;
                pen.text(&point.label, [x + offset[0], y + offset[1]], note, anchor)?;
            }
        }
        self.frame.draw_axes(pen)?;
        draw_legend(
            pen,
            &self.entries(),
            [self.frame.right + 20.0, self.frame.top],
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;

    fn chart() -> SpeedChart {
        let points = |errors: [f64; 3]| {
            ["1/8", "1/16", "1/32"]
                .iter()
                .zip([1.0, 8.0, 70.0])
                .zip(errors)
                .map(|((label, cpu_seconds), error)| SpeedPoint {
                    label: (*label).to_owned(),
                    cpu_seconds,
                    error,
                })
                .collect()
        };
        SpeedChart {
            title: "wedge".to_owned(),
            error_label: "error, %".to_owned(),
            series: vec![
                SpeedSeries {
                    name: "conservative, WOM".to_owned(),
                    peer: false,
                    points: points([3.0, 1.0, 0.0]),
                },
                SpeedSeries {
                    name: "Eilmer".to_owned(),
                    peer: true,
                    points: points([2.0, 1.1, 0.6]),
                },
            ],
        }
    }

    #[test]
    fn the_chart_and_its_table_are_written() {
        let folder = tempfile::tempdir().unwrap();
        chart().save(&folder.path().join("wedge.svg")).unwrap();
        chart().save_csv(&folder.path().join("wedge.csv")).unwrap();
        let svg = std::fs::read_to_string(folder.path().join("wedge.svg")).unwrap();
        assert!(svg.contains("Eilmer") && svg.contains("CPU time, s") && svg.contains("1/16"));
    }

    #[test]
    fn the_table_keeps_runs_that_have_no_place_on_log_axes() {
        let text = chart().to_csv();
        assert_eq!(text.lines().count(), 7);
        assert!(
            text.contains("\"conservative, WOM\",false,1/32,70,0\n"),
            "{text}"
        );
    }

    #[test]
    fn the_peers_of_the_wedge_make_two_series() {
        let found = peers(&reference::wedge_peers(), "beta_error_deg").unwrap();
        let names: Vec<&str> = found.iter().map(|s| s.name.as_str()).collect();
        assert_eq!(names, ["Eilmer 5", "rhoCentralFoam"]);
        assert_eq!(found[1].points[3].label, "1/64");
        assert!(peers(&reference::wedge_peers(), "absent").is_err());
    }

    #[test]
    fn a_chart_without_runs_is_refused() {
        let empty = SpeedChart {
            series: Vec::new(),
            ..chart()
        };
        assert!(matches!(
            empty.save(Path::new("e.svg")),
            Err(PictureError::Empty(_))
        ));
    }
}
