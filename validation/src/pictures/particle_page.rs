//! Draws a particle picture: discs, the frame, the colour bar, lines over the particles.

use super::axes::{Frame, HEADING, MEDIUM, SMALL};
use super::canvas::{Anchor, Drawing, Pen, Stroke};
use super::colour::{BLACK, WHITE, viridis};
use super::font::Font;
use super::legend::{draw_legend, legend_size};
use super::particles::ParticlePicture;
use super::ticks;
use plotters::backend::DrawingBackend;

/// A particle picture laid out: what is shown where.
pub(super) struct Page<'p, 'a> {
    pub(super) picture: &'p ParticlePicture<'a>,
    pub(super) shown: Vec<usize>,
    pub(super) colours: [f64; 2],
    pub(super) scale: f64,
    pub(super) frame: Frame,
}

impl Page<'_, '_> {
    fn draw_bar<DB: DrawingBackend>(&self, pen: &Pen<'_, DB>) -> Result<(), String> {
        let (left, right) = (self.frame.right + 24.0, self.frame.right + 46.0);
        let (top, bottom) = (self.frame.top, self.frame.bottom);
        let bands = 256;
        for k in 0..bands {
            let place = |share: f64| bottom - share * (bottom - top);
            let (from, to) = (
                f64::from(k) / f64::from(bands),
                f64::from(k + 1) / f64::from(bands),
            );
            let colour = viridis(0.5 * (from + to));
            pen.fill_box([left, place(to)], [right, place(from)], colour)?;
        }
        let edge = Stroke {
            colour: BLACK,
            width: 1.0,
            dashed: false,
        };
        let corners = [
            [left, top],
            [right, top],
            [right, bottom],
            [left, bottom],
            [left, top],
        ];
        pen.line(&corners, edge)?;
        let number = Font::plain(SMALL);
        let mut widest: f64 = 0.0;
        for tick in self.bar_ticks() {
            let share = (tick.value - self.colours[0]) / (self.colours[1] - self.colours[0]);
            let y = bottom - share * (bottom - top);
            pen.line(&[[right, y], [right + 5.0, y]], edge)?;
            pen.text(&tick.label, [right + 10.0, y], number, Anchor::Left)?;
            widest = widest.max(number.width(&tick.label));
        }
        let label = [right + widest + 28.0, 0.5 * (top + bottom)];
        pen.text(
            self.picture.value_label,
            label,
            Font::plain(MEDIUM),
            Anchor::Upwards,
        )
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

    fn bar_ticks(&self) -> Vec<ticks::Tick> {
        let count = ((self.frame.bottom - self.frame.top) / 60.0).max(2.0) as usize;
        ticks::linear(self.colours, count)
    }
}

impl Drawing for Page<'_, '_> {
    fn size(&self) -> [f64; 2] {
        let number = Font::plain(SMALL);
        let widest = self
            .bar_ticks()
            .iter()
            .map(|t| number.width(&t.label))
            .fold(0.0, f64::max);
        let title = HEADING.width(self.picture.title) + 2.0 * self.frame.left;
        let width = self.frame.right + 46.0 + widest + 48.0;
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
        self.draw_bar(pen)?;
        let mut x = self.frame.left;
        for entry in self.picture.legend() {
            let entry = [entry];
            draw_legend(pen, &entry, [x, 46.0])?;
            x += legend_size(&entry)[0] + 12.0;
        }
        Ok(())
    }
}
