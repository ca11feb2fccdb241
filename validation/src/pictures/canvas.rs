//! Paper and pen: sizes in points (one point is one pixel of the finished picture), drawn finer
//! inside and reduced, so that edges are smooth in a PNG and places exact in an SVG.

use super::band::Band;
use super::colour::{Colour, WHITE, rgb};
use super::dashes::dashes;
use super::font::{FINE, Font, load_font};
use super::{Format, PictureError, format_of};
use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{BitMapElement, Circle, PathElement, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, FontTransform, ShapeStyle, TextStyle};
use std::fs::File;
use std::io::BufWriter;
use std::ops::Range;
use std::path::Path;

/// A picture that can draw itself on paper of its own choice of size.
pub(super) trait Drawing {
    /// Width and height in points.
    fn size(&self) -> [f64; 2];
    /// Draws everything.
    fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String>;
}

/// Where a text's given place lies in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Left,
    Centre,
    Right,
    /// Centred, running upwards.
    Upwards,
}

/// How a line looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stroke {
    pub(super) colour: Colour,
    pub(super) width: f64,
    pub(super) dashed: bool,
}

/// Draws in points.
pub(super) struct Pen<'a, DB: DrawingBackend> {
    area: &'a DrawingArea<DB, Shift>,
    format: Format,
    /// Fine rows that are drawn.
    shown: Range<u32>,
}

/// Draws a picture into a PNG or SVG file.
pub(super) fn save(drawing: &impl Drawing, path: &Path) -> Result<(), PictureError> {
    let failed = |reason: String| PictureError::Write {
        path: path.to_owned(),
        reason,
    };
    let format = format_of(path)?;
    load_font().map_err(failed)?;
    let [width, height] = drawing.size().map(|v| v.round().max(1.0) as u32);
    let fine = (FINE * width, FINE * height);
    match format {
        Format::Svg => {
            let mut text = String::new();
            {
                let area = SVGBackend::with_string(&mut text, fine).into_drawing_area();
                draw_on(&area, drawing, format, 0..fine.1).map_err(failed)?;
            }
            // The view box keeps the fine coordinates; only the size on the page is reduced.
            let fine_size = format!("width=\"{}\" height=\"{}\"", fine.0, fine.1);
            let size = format!("width=\"{width}\" height=\"{height}\"");
            std::fs::write(path, text.replacen(&fine_size, &size, 1))
                .map_err(|e| failed(e.to_string()))
        }
        Format::Png => {
            let pixels = paint(drawing, [width, height], BAND).map_err(failed)?;
            write_png(path, [width, height], &pixels).map_err(|e| failed(e.to_string()))
        }
    }
}

/// Fine pixels that are drawn at once, in bytes.
const BAND: usize = 4 << 20;

/// Pixels of a picture of so many columns and rows, drawn as many rows at a time as that many bytes hold.
fn paint(
    drawing: &impl Drawing,
    [width, height]: [u32; 2],
    bytes: usize,
) -> Result<Vec<u8>, String> {
    let size = (FINE * width, FINE * height);
    let row = 3 * size.0 as usize * FINE as usize;
    let rows = (bytes / row).clamp(1, height as usize);
    let mut fine = vec![0; rows * row];
    let mut pixels = Vec::with_capacity(3 * width as usize * height as usize);
    for top in (0..height).step_by(rows) {
        let bottom = height.min(top + rows as u32);
        let shown = FINE * top..FINE * bottom;
        let area = Band::new(size, shown.clone(), &mut fine).into_drawing_area();
        draw_on(&area, drawing, Format::Png, shown)?;
        drop(area);
        reduce(&fine, [width, bottom - top], &mut pixels);
    }
    Ok(pixels)
}

/// A picture of so many columns and rows, three bytes to the pixel.
fn write_png(
    path: &Path,
    [width, height]: [u32; 2],
    pixels: &[u8],
) -> Result<(), png::EncodingError> {
    let file = BufWriter::new(File::create(path)?);
    let mut encoder = png::Encoder::new(file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()
}

fn draw_on<DB: DrawingBackend>(
    area: &DrawingArea<DB, Shift>,
    drawing: &impl Drawing,
    format: Format,
    shown: Range<u32>,
) -> Result<(), String> {
    area.fill(&rgb(WHITE)).map_err(|e| e.to_string())?;
    drawing.draw(&Pen {
        area,
        format,
        shown,
    })?;
    area.present().map_err(|e| e.to_string())
}

/// Adds the means of blocks of fine pixels, of so many columns and rows.
fn reduce(fine: &[u8], [width, height]: [u32; 2], pixels: &mut Vec<u8>) {
    let (n, width) = (FINE as usize, width as usize);
    for y in 0..height as usize {
        for x in 0..width {
            for c in 0..3 {
                let mut sum = 0;
                for j in 0..n {
                    for i in 0..n {
                        let pixel = (n * y + j) * n * width + n * x + i;
                        sum += usize::from(fine[3 * pixel + c]);
                    }
                }
                pixels.push(((sum + n * n / 2) / (n * n)) as u8);
            }
        }
    }
}

impl<DB: DrawingBackend> Pen<'_, DB> {
    /// An open line through `points`.
    pub(super) fn line(&self, points: &[[f64; 2]], stroke: Stroke) -> Result<(), String> {
        let style = rgb(stroke.colour).stroke_width(fine_width(stroke.width));
        let pieces = if stroke.dashed {
            dashes(points, 4.0 * stroke.width + 2.0, 2.0 * stroke.width + 2.0)
        } else {
            vec![points.to_vec()]
        };
        for piece in pieces {
            let mut corners: Vec<(i32, i32)> = piece.iter().map(fine).collect();
            corners.dedup();
            match self.format {
                Format::Svg if corners.len() > 1 => self.path(corners, style)?,
                Format::Svg => {}
                // The bitmap backend fills a thick line's outline by the even-odd rule, which leaves
                // holes where the line doubles back: draw it piece by piece with round joints.
                Format::Png => {
                    for pair in corners.windows(2) {
                        self.path(pair.to_vec(), style)?;
                    }
                    for joint in corners.iter().skip(1).take(corners.len().saturating_sub(2)) {
                        let radius = (fine_width(stroke.width) / 2) as i32;
                        let disc = Circle::new(*joint, radius, rgb(stroke.colour).filled());
                        self.area.draw(&disc).map_err(|e| e.to_string())?;
                    }
                }
            }
        }
        Ok(())
    }

    fn path(&self, corners: Vec<(i32, i32)>, style: ShapeStyle) -> Result<(), String> {
        self.area
            .draw(&PathElement::new(corners, style))
            .map_err(|e| e.to_string())
    }

    /// A filled upright rectangle between two corners.
    pub(super) fn fill_box(
        &self,
        from: [f64; 2],
        to: [f64; 2],
        colour: Colour,
    ) -> Result<(), String> {
        let shape = Rectangle::new([fine(&from), fine(&to)], rgb(colour).filled());
        self.area.draw(&shape).map_err(|e| e.to_string())
    }

    /// Pixels, a point wide each, in rows of so many from the top, from a corner on.
    pub(super) fn pixels(
        &self,
        corner: [f64; 2],
        columns: usize,
        colours: &[Colour],
    ) -> Result<(), String> {
        let n = FINE as usize;
        let [x, y] = corner;
        for (k, row) in colours.chunks(columns.max(1)).enumerate() {
            let place = fine(&[x, y + k as f64]);
            let rows = i64::from(place.1)..i64::from(place.1) + i64::from(FINE);
            if rows.end <= i64::from(self.shown.start) || i64::from(self.shown.end) <= rows.start {
                continue;
            }
            let mut line = Vec::with_capacity(3 * n * columns);
            for colour in row {
                for _ in 0..n {
                    line.extend_from_slice(colour);
                }
            }
            let size = ((n * columns) as u32, FINE);
            let bitmap = BitMapElement::with_owned_buffer(place, size, line.repeat(n));
            let bitmap = bitmap.ok_or("the pixels do not fill the picture")?;
            self.area.draw(&bitmap).map_err(|e| e.to_string())?;
        }
        Ok(())
    }

    /// A filled disc.
    pub(super) fn disc(&self, centre: [f64; 2], radius: f64, colour: Colour) -> Result<(), String> {
        let radius = (radius * f64::from(FINE)).round().max(1.0) as i32;
        self.area
            .draw(&Circle::new(fine(&centre), radius, rgb(colour).filled()))
            .map_err(|e| e.to_string())
    }

    /// A text whose anchor lies at `place`, vertically centred on it.
    pub(super) fn text(
        &self,
        text: &str,
        place: [f64; 2],
        font: Font,
        anchor: Anchor,
    ) -> Result<(), String> {
        let (horizontal, turn) = match anchor {
            Anchor::Left => (HPos::Left, FontTransform::None),
            Anchor::Right => (HPos::Right, FontTransform::None),
            Anchor::Centre => (HPos::Center, FontTransform::None),
            Anchor::Upwards => (HPos::Center, FontTransform::Rotate270),
        };
        let colour = rgb(font.colour);
        // The bitmap backend centres the box of a line of text, whose letters stand high in it.
        let drop = match self.format {
            Format::Png => 0.11 * font.size,
            Format::Svg => 0.0,
        };
        let place = match anchor {
            Anchor::Upwards => [place[0] + drop, place[1]],
            _ => [place[0], place[1] + drop],
        };
        let style = TextStyle::from(font.description().transform(turn))
            .color(&colour)
            .pos(Pos::new(horizontal, VPos::Center));
        self.area
            .draw(&Text::new(text.to_owned(), fine(&place), style))
            .map_err(|e| e.to_string())
    }
}

fn fine([x, y]: &[f64; 2]) -> (i32, i32) {
    let scale = |v: f64| (v * f64::from(FINE)).round() as i32;
    (scale(*x), scale(*y))
}

fn fine_width(width: f64) -> u32 {
    (width * f64::from(FINE)).round().max(1.0) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Page(&'static str);

    impl Drawing for Page {
        fn size(&self) -> [f64; 2] {
            [200.0, 60.0]
        }

        fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
            pen.text(self.0, [100.0, 30.0], Font::plain(20.0), Anchor::Centre)
        }
    }

    #[test]
    fn text_leaves_ink_without_any_font_of_the_system() {
        load_font().unwrap();
        let pixels = paint(&Page("βρ₁ = 29.8°"), [200, 60], BAND).unwrap();
        let dark = pixels.chunks(3).filter(|p| p[0] < 100).count();
        assert!((200..3000).contains(&dark), "{dark}");
    }

    #[test]
    fn pixels_are_means_of_their_blocks() {
        let (width, height, n) = (7, 5, FINE as usize);
        let fine: Vec<u8> = (0..3 * n * n * width * height)
            .map(|k| (k * k % 251) as u8)
            .collect();
        let mut reduced = Vec::new();
        reduce(&fine, [width as u32, height as u32], &mut reduced);
        assert_eq!(reduced.len(), 3 * width * height);
        for (at, found) in reduced.iter().enumerate() {
            let (pixel, colour) = (at / 3, at % 3);
            let (x, y) = (n * (pixel % width), n * (pixel / width));
            let places = (0..n * n).map(|k| (y + k / n) * n * width + x + k % n);
            let mean =
                places.map(|k| f64::from(fine[3 * k + colour])).sum::<f64>() / (n * n) as f64;
            assert!((f64::from(*found) - mean).abs() <= 0.5, "{at}");
        }
    }

    struct Everything;

    impl Drawing for Everything {
        fn size(&self) -> [f64; 2] {
            [90.0, 70.0]
        }

        fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
            let colours: Vec<Colour> = (0..30 * 20).map(|k| [k as u8, 90, 7]).collect();
            pen.pixels([4.0, -3.0], 30, &colours)?;
            pen.pixels([50.0, 60.0], 30, &colours)?;
            pen.fill_box([20.0, 10.0], [34.0, 61.0], [20, 60, 110])?;
            for k in 0..40 {
                let place = [f64::from(37 * k % 97), f64::from(29 * k % 79) - 4.0];
                pen.disc(place, 0.3 * f64::from(k), [200, 5 * k as u8, 40])?;
            }
            for (width, dashed) in [(0.3, false), (0.3, true), (3.0, false), (2.0, true)] {
                let stroke = Stroke {
                    colour: [0, 80, 0],
                    width,
                    dashed,
                };
                pen.line(&[[-9.0, 66.0], [40.0, 4.0], [97.0, 35.0 + width]], stroke)?;
                pen.line(&[[8.0, -5.0], [8.0 + width, 90.0]], stroke)?;
            }
            pen.text("upwards", [80.0, 30.0], Font::plain(18.0), Anchor::Upwards)?;
            pen.text("Mach", [40.0, 40.0], Font::plain(24.0), Anchor::Centre)
        }
    }

    #[test]
    fn a_picture_drawn_a_few_rows_at_a_time_is_the_same() {
        load_font().unwrap();
        let row = 3 * 90 * (FINE * FINE) as usize;
        let whole = paint(&Everything, [90, 70], 70 * row).unwrap();
        assert_eq!(whole.len(), 3 * 90 * 70);
        for rows in [0, 1, 7, 69] {
            let found = paint(&Everything, [90, 70], rows * row).unwrap();
            let differ = whole.iter().zip(&found).filter(|(a, b)| a != b).count();
            assert_eq!((found.len(), differ), (whole.len(), 0), "{rows} rows");
        }
    }

    #[test]
    fn files_are_written_in_the_format_of_their_name() {
        let folder = tempfile::tempdir().unwrap();
        let png = folder.path().join("a.png");
        save(&Page("x"), &png).unwrap();
        assert!(std::fs::read(&png).unwrap().starts_with(b"\x89PNG"));
        let svg = folder.path().join("a.SVG");
        save(&Page("x < y"), &svg).unwrap();
        let text = std::fs::read_to_string(&svg).unwrap();
        assert!(
            text.starts_with("<svg width=\"200\" height=\"60\" viewBox=\"0 0 600 180\""),
            "{text}"
        );
        assert!(text.contains("x &lt; y"));
    }

    #[test]
    fn other_names_and_absent_folders_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let error = save(&Page("x"), &folder.path().join("a.jpg")).unwrap_err();
        assert!(error.to_string().contains(".png or .svg"), "{error}");
        assert!(save(&Page("x"), &folder.path().join("absent/a.png")).is_err());
        assert!(save(&Page("x"), &folder.path().join("absent/a.svg")).is_err());
    }
}
