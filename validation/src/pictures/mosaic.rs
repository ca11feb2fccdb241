//! Panels of coloured tiles: how something turned out over two parameters.

use super::PictureError;
use super::axes::{HEADING, MEDIUM, SMALL};
use super::canvas::{Anchor, Drawing, Pen, save};
use super::colour::{BLACK, Colour, PALE};
use super::font::Font;
use plotters::backend::DrawingBackend;
use std::path::Path;

/// How a tile turned out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// As it should.
    Fine,
    /// To its end, but off.
    Degraded,
    /// Not to its end.
    Failed,
}

impl Verdict {
    const ALL: [Self; 3] = [Self::Fine, Self::Degraded, Self::Failed];

    /// A word for it.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Fine => "fine",
            Self::Degraded => "degraded",
            Self::Failed => "failed",
        }
    }

    /// Told apart by colour-blind readers too, and in grey. Source: Okabe & Ito, "Color Universal
    /// Design" (2008), lightened.
    const fn colour(self) -> Colour {
        match self {
            Self::Fine => [150, 210, 240],
            Self::Degraded => [245, 205, 110],
            Self::Failed => [225, 110, 60],
        }
    }
}

/// One tile.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tile {
    /// How it turned out.
    pub verdict: Verdict,
    /// A few letters about it.
    pub note: String,
}

/// One panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Heading.
    pub title: String,
    /// Rows from top to bottom, each with as many tiles as there are columns.
    pub rows: Vec<Vec<Tile>>,
}

/// Panels of the same parameters, two abreast.
#[derive(Clone, Debug, PartialEq)]
pub struct Mosaic {
    /// Heading.
    pub title: String,
    /// What varies from column to column.
    pub across: String,
    /// Its values.
    pub columns: Vec<String>,
    /// What varies from row to row.
    pub down: String,
    /// Its values.
    pub rows: Vec<String>,
    /// The panels.
    pub panels: Vec<Panel>,
}

const TILE: [f64; 2] = [62.0, 34.0];
const LEFT: f64 = 92.0;
const TOP: f64 = 112.0;
/// Room below a panel's tiles for its axis, and the next one's heading.
const BELOW: f64 = 100.0;
const ABREAST: usize = 2;

impl Mosaic {
    /// Draws the panels into a `.svg` or `.png` file.
    pub fn save(&self, path: &Path) -> Result<(), PictureError> {
        if self.panels.is_empty() || self.columns.is_empty() || self.rows.is_empty() {
            return Err(PictureError::Empty(self.title.clone()));
        }
        save(self, path)
    }

    /// Width and height of one panel with its margins.
    fn pitch(&self) -> [f64; 2] {
        [
            LEFT + TILE[0] * self.columns.len() as f64 + 24.0,
            TILE[1] * self.rows.len() as f64 + BELOW,
        ]
    }

    fn draw_panel<DB: DrawingBackend>(
        &self,
        pen: &Pen<'_, DB>,
        panel: &Panel,
        [left, top]: [f64; 2],
    ) -> Result<(), String> {
        let small = Font::plain(SMALL);
        let medium = Font::plain(MEDIUM);
        pen.text(&panel.title, [left, top - 20.0], medium, Anchor::Left)?;
        let note = Font::plain(14.0);
        for (r, row) in panel.rows.iter().enumerate() {
            for (c, tile) in row.iter().enumerate() {
                let (x, y) = (left + TILE[0] * c as f64, top + TILE[1] * r as f64);
                let (end, bottom) = (x + TILE[0] - 2.0, y + TILE[1] - 2.0);
                pen.fill_box([x, y], [end, bottom], tile.verdict.colour())?;
                let middle = [0.5 * (x + end), 0.5 * (y + bottom)];
                pen.text(&tile.note, middle, note, Anchor::Centre)?;
            }
        }
        let bottom = top + TILE[1] * self.rows.len() as f64;
        for (r, label) in self.rows.iter().enumerate() {
            let middle = top + TILE[1] * (r as f64 + 0.5);
            pen.text(label, [left - 10.0, middle], small, Anchor::Right)?;
        }
        for (c, label) in self.columns.iter().enumerate() {
            let middle = left + TILE[0] * (c as f64 + 0.5);
            pen.text(label, [middle, bottom + 14.0], small, Anchor::Centre)?;
        }
        let centre = left + 0.5 * TILE[0] * self.columns.len() as f64;
        pen.text(
            &self.across,
            [centre, bottom + 38.0],
            medium,
            Anchor::Centre,
        )?;
        let middle = 0.5 * (top + bottom);
        pen.text(&self.down, [left - 72.0, middle], medium, Anchor::Upwards)
    }
}

impl Drawing for Mosaic {
    fn size(&self) -> [f64; 2] {
        let [width, height] = self.pitch();
        let abreast = self.panels.len().min(ABREAST) as f64;
        let lines = self.panels.len().div_ceil(ABREAST) as f64;
        let title = HEADING.width(&self.title) + 60.0;
        [title.max(width * abreast), TOP + height * lines - 40.0]
    }

    fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        pen.text(&self.title, [24.0, 28.0], HEADING, Anchor::Left)?;
        let mut x = 24.0;
        let font = Font {
            colour: BLACK,
            ..Font::plain(SMALL)
        };
        for verdict in Verdict::ALL {
            pen.fill_box([x - 1.0, 49.0], [x + 25.0, 67.0], PALE)?;
            pen.fill_box([x, 50.0], [x + 24.0, 66.0], verdict.colour())?;
            pen.text(verdict.word(), [x + 32.0, 58.0], font, Anchor::Left)?;
            x += 62.0 + font.width(verdict.word());
        }
        let [width, height] = self.pitch();
        for (k, panel) in self.panels.iter().enumerate() {
            let corner = [
                LEFT + width * (k % ABREAST) as f64,
                TOP + height * (k / ABREAST) as f64,
            ];
            self.draw_panel(pen, panel, corner)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mosaic(panels: usize) -> Mosaic {
        let tile = |verdict| Tile {
            verdict,
            note: "0.1".into(),
        };
        let panel = Panel {
            title: "a scheme".into(),
            rows: vec![Verdict::ALL.map(tile).to_vec()],
        };
        Mosaic {
            title: "How it went".into(),
            across: "Mach number".into(),
            columns: ["1", "2", "3"].map(String::from).to_vec(),
            down: "angle".into(),
            rows: vec!["10".into()],
            panels: vec![panel; panels],
        }
    }

    #[test]
    fn a_picture_names_its_verdicts_and_its_panels() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("map.svg");
        mosaic(3).save(&path).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        for word in [
            "fine",
            "degraded",
            "failed",
            "a scheme",
            "Mach number",
            "angle",
        ] {
            assert!(text.contains(word), "{word}");
        }
    }

    #[test]
    fn nothing_to_show_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let error = mosaic(0).save(&folder.path().join("map.svg")).unwrap_err();
        assert!(error.to_string().contains("How it went"), "{error}");
    }
}
