//! Curves in one or more panels: profiles of particles against an exact curve, and histories.

use super::colour::{BLACK, Colour};

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A solid line.
    Line,
    /// A dashed line.
    Dashed,
    /// A dot per point.
    Dots,
}

/// Points under one name.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name for the legend; empty for none.
    pub label: String,
    /// Points in drawing order; points that are not numbers break a line.
    pub points: Vec<[f64; 2]>,
    /// Look.
    pub style: Style,
    /// Colour; none takes the next of the palette.
    pub colour: Option<Colour>,
}

impl Series {
    /// A series in the next colour of the palette.
    pub fn new(label: &str, style: Style, points: Vec<[f64; 2]>) -> Self {
        Self {
            label: label.to_owned(),
            points,
            style,
            colour: None,
        }
    }

    /// An exact solution: a solid black line through `samples` values of `exact` over `range`.
    pub fn exact(range: [f64; 2], samples: usize, exact: impl Fn(f64) -> f64) -> Self {
        let last = samples.saturating_sub(1).max(1) as f64;
        let points = (0..samples)
            .map(|k| range[0] + k as f64 / last * (range[1] - range[0]))
            .map(|x| [x, exact(x)])
            .collect();
        Self {
            label: "exact".to_owned(),
            points,
            style: Style::Line,
            colour: Some(BLACK),
        }
    }

    /// Particles at `coordinates` with `values`, as dots.
    pub fn particles(label: &str, coordinates: &[f64], values: &[f64]) -> Self {
        let points = coordinates
            .iter()
            .zip(values)
            .map(|(x, v)| [*x, *v])
            .collect();
        Self::new(label, Style::Dots, points)
    }
}

/// One plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Label of the horizontal axis, with its unit.
    pub x_label: String,
    /// Label of the vertical axis, with its unit.
    pub y_label: String,
    /// Ends of the axes; by default all points with a margin.
    pub window: [Option<[f64; 2]>; 2],
    /// Logarithmic axes.
    pub log: [bool; 2],
    /// What is drawn, first at the bottom.
    pub series: Vec<Series>,
}

impl Panel {
    /// A panel on linear axes that shows all points.
    pub fn new(x_label: &str, y_label: &str, series: Vec<Series>) -> Self {
        Self {
            x_label: x_label.to_owned(),
            y_label: y_label.to_owned(),
            window: [None; 2],
            log: [false; 2],
            series,
        }
    }
}

/// The picture: panels in rows of `columns`.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// Heading.
    pub title: String,
    /// Plots, row by row.
    pub panels: Vec<Panel>,
    /// Panels in a row.
    pub columns: usize,
}

impl Curves {
    /// A picture of one panel.
    pub fn single(title: &str, panel: Panel) -> Self {
        Self {
            title: title.to_owned(),
            panels: vec![panel],
            columns: 1,
        }
    }
}
