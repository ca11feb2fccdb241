//! Lays a particle picture out and draws it: discs, the frame, the colour bar, lines over the particles.

use super::PictureError;
use super::axes::{Axis, Frame, HEADING, range_of};
use super::bar::Bar;
use super::canvas::{Anchor, Drawing, Pen, Stroke, save};
use super::colour::{WHITE, viridis};
use super::legend::{Entry, draw_legend, legend_size};
use super::particles::ParticlePicture;
use plotters::backend::DrawingBackend;
use std::path::Path;

impl<'a> ParticlePicture<'a> {
    /// Draws the picture into a `.png` or `.svg` file.
    pub fn save(&self, path: &Path) -> Result<(), PictureError> {
        for (what, found) in [
            ("value", self.value.len()),
            ("diameter", self.diameter.len()),
        ] {
            if found != self.position.len() {
                return Err(PictureError::Length {
                    title: self.title.to_owned(),
                    what,
                    found,
                    expected: self.position.len(),
                });
            }
        }
        let page = self
            .layout()
            .ok_or_else(|| PictureError::Empty(self.title.to_owned()))?;
        save(&page, path)
    }

    fn layout(&self) -> Option<Page<'_, 'a>> {
        let [across, up] = self.axes.map(|a| a.min(2));
        let in_slab = |p: &[f64; 3]| {
            self.slab
                .is_none_or(|s| (p[s.axis.min(2)] - s.centre).abs() <= s.half)
        };
        let in_window = |p: &[f64; 3]| {
            self.window.is_none_or(|[x, y]| {
                (x[0]..=x[1]).contains(&p[across]) && (y[0]..=y[1]).contains(&p[up])
            })
        };
        let mut shown: Vec<usize> = (0..self.position.len())
            .filter(|&k| self.position[k].iter().all(|v| v.is_finite()))
            .filter(|&k| in_slab(&self.position[k]) && in_window(&self.position[k]))
            .collect();
        // Small discs lie over large ones.
        shown.sort_by(|&a, &b| {
            self.diameter[b]
                .total_cmp(&self.diameter[a])
                .then(a.cmp(&b))
        });
        let span = |axis: usize| {
            let edges = shown.iter().flat_map(|&k| {
                let (middle, half) = (self.position[k][axis], 0.5 * self.diameter[k]);
                [middle - half, middle + half]
            });
            range_of(edges, false, 0.0)
        };
        let [x, y] = match self.window {
            Some(window) => window,
            None => [span(across)?, span(up)?],
        };
        let colours = match self.value_range {
            Some(range) => range,
            None => central_range(shown.iter().map(|&k| self.value[k]).collect())?,
        };
        let axis = |label: &str, range| Axis {
            label: label.to_owned(),
            range,
            log: false,
        };
        let (x, y) = (axis(self.axis_labels[0], x), axis(self.axis_labels[1], y));
        // Equal axes, as large as fits 980 x 760 points; a slender tube is widened to be seen.
        let [dx, dy] = [x.range[1] - x.range[0], y.range[1] - y.range[0]];
        let scale = (980.0 / dx).min(760.0 / dy);
        let (width, height) = ((dx * scale).max(160.0), (dy * scale).max(120.0));
        let left = Frame::margin_left(&y, height);
        let top = if self.legend().is_empty() {
            56.0
        } else {
            56.0 + 32.0
        };
        Some(Page {
            picture: self,
            shown,
            colours,
            scale,
            frame: Frame {
                x,
                y,
                left,
                right: left + width,
                top,
                bottom: top + height,
            },
        })
    }

    fn legend(&self) -> Vec<Entry> {
        self.overlays
            .iter()
            .filter(|o| !o.label.is_empty())
            .map(|o| Entry {
                label: o.label.clone(),
                colour: o.colour,
                line: Some(o.dashed),
                dots: false,
            })
            .collect()
    }
}

/// Values that hold the middle 99 per cent, so that one wild particle does not take all colours.
fn central_range(mut values: Vec<f64>) -> Option<[f64; 2]> {
    values.retain(|v| v.is_finite());
    values.sort_by(f64::total_cmp);
    let last = values.len().checked_sub(1)?;
    let at = |share: f64| values[(share * last as f64).round() as usize];
    range_of([at(0.005), at(0.995)].into_iter(), false, 0.0)
}

/// A particle picture laid out: what is shown where.
struct Page<'p, 'a> {
    picture: &'p ParticlePicture<'a>,
    shown: Vec<usize>,
    colours: [f64; 2],
    scale: f64,
    frame: Frame,
}

impl Page<'_, '_> {
    fn bar(&self) -> Bar<'_> {
        Bar {
            frame: &self.frame,
            range: self.colours,
            label: self.picture.value_label,
            colour: viridis,
        }
    }

    /// Whitens what discs at the edge have left outside the frame.
    fn clear_outside<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        let (l, r, t, b) = (
            self.frame.left,
            self.frame.right,
            self.frame.top,
            self.frame.bottom,
        );
        let wide = 60.0;
        for (from, to) in [
            ([l - wide, t - wide], [l, b + wide]),
            ([r, t - wide], [r + wide, b + wide]),
            ([l - wide, t - wide], [r + wide, t]),
            ([l - wide, b], [r + wide, b + wide]),
        ] {
            pen.fill_box(from, to, WHITE)?;
        }
        Ok(())
    }
}

impl Drawing for Page<'_, '_> {
    fn size(&self) -> [f64; 2] {
        let title = HEADING.width(self.picture.title) + 2.0 * self.frame.left;
        let width = self.frame.right + self.bar().width();
        [width.max(title), self.frame.bottom + 64.0]
    }

    fn draw<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        let [across, up] = self.picture.axes.map(|a| a.min(2));
        for &k in &self.shown {
            let p = self.picture.position[k];
            let share =
                (self.picture.value[k] - self.colours[0]) / (self.colours[1] - self.colours[0]);
            let centre = self.frame.place([p[across], p[up]]);
            // Half the diagonal of a cell, so that regular particles leave no gaps.
            let radius = (std::f64::consts::FRAC_1_SQRT_2 * self.picture.diameter[k] * self.scale)
                .clamp(0.7, 60.0);
            pen.disc(centre, radius, viridis(share))?;
        }
        self.clear_outside(pen)?;
        for overlay in &self.picture.overlays {
            let stroke = Stroke {
                colour: overlay.colour,
                width: 2.4,
                dashed: overlay.dashed,
            };
            self.frame.draw_line(pen, &overlay.points, stroke)?;
        }
        pen.text(
            self.picture.title,
            [self.frame.left, 28.0],
            HEADING,
            Anchor::Left,
        )?;
        self.frame.draw_axes(pen)?;
        self.bar().draw(pen)?;
        let mut x = self.frame.left;
        for entry in self.picture.legend() {
            let entry = [entry];
            draw_legend(pen, &entry, [x, 46.0])?;
            x += legend_size(&entry)[0] + 12.0;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::particles::{Overlay, Slab};

    fn sheet() -> (Vec<[f64; 3]>, Vec<f64>, Vec<f64>) {
        let position: Vec<[f64; 3]> = (0..200)
            .map(|k| [f64::from(k % 20) * 0.1, f64::from(k / 20) * 0.1, 0.0])
            .collect();
        let value = position.iter().map(|p| p[0] + p[1]).collect();
        let diameter = vec![0.1; position.len()];
        (position, value, diameter)
    }

    #[test]
    fn a_picture_is_written_and_keeps_equal_axes() {
        let (position, value, diameter) = sheet();
        let mut picture = ParticlePicture::new("test", &position, &diameter, &value, "density");
        picture
            .overlays
            .push(Overlay::theory("shock", vec![[0.0, 0.0], [2.0, 1.0]]));
        let page = picture.layout().unwrap();
        let wide = (page.frame.right - page.frame.left) / 2.0;
        let high = page.frame.bottom - page.frame.top;
        assert!((wide / high - 1.0).abs() < 1e-9);
        let folder = tempfile::tempdir().unwrap();
        picture.save(&folder.path().join("p.png")).unwrap();
    }

    #[test]
    fn a_slab_and_a_window_leave_only_their_particles() {
        let (mut position, value, diameter) = sheet();
        for (k, p) in position.iter_mut().enumerate() {
            p[2] = (k % 2) as f64;
        }
        let mut picture = ParticlePicture::new("test", &position, &diameter, &value, "density");
        picture.slab = Some(Slab {
            axis: 2,
            centre: 0.0,
            half: 0.5,
        });
        picture.window = Some([[0.0, 0.95], [0.0, 2.0]]);
        assert_eq!(picture.layout().unwrap().shown.len(), 50);
    }

    #[test]
    fn nothing_to_draw_and_unequal_arrays_are_refused() {
        let (position, value, diameter) = sheet();
        let path = Path::new("never.png");
        let empty = ParticlePicture::new("test", &[], &[], &[], "density");
        assert!(matches!(empty.save(path), Err(PictureError::Empty(_))));
        let short = ParticlePicture::new("test", &position, &diameter, &value[1..], "density");
        let error = short.save(path).unwrap_err();
        assert!(error.to_string().contains("199 entries for 200"), "{error}");
    }
}
