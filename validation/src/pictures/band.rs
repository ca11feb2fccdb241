//! Rows of a picture that is drawn a few at a time: fine pixels of all of it at once would be most of the memory of a small run.

use plotters::backend::BitMapBackend;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, DrawingBackend, DrawingErrorKind, rasterizer,
};
use std::ops::Range;

type Done<'a> = Result<(), DrawingErrorKind<<BitMapBackend<'a> as DrawingBackend>::ErrorType>>;

/// Some rows of a bitmap. It takes what is drawn to all of the picture, and keeps what lies in them. What is round or slanted is
/// broken up in the picture's coordinates, so that no pixel depends on the rows that it is drawn with.
pub(super) struct Band<'a> {
    pixels: BitMapBackend<'a>,
    size: (u32, u32),
    rows: Range<u32>,
}

impl<'a> Band<'a> {
    /// Rows of a picture of so many columns and rows, on pixels of three bytes for just these rows.
    pub(super) fn new(size: (u32, u32), rows: Range<u32>, pixels: &'a mut [u8]) -> Self {
        let height = rows.end - rows.start;
        Self {
            pixels: BitMapBackend::with_buffer(pixels, (size.0, height)),
            size,
            rows,
        }
    }

    /// A place of the picture as one of the band.
    fn within(&self, (x, y): BackendCoord) -> BackendCoord {
        (x, y - self.rows.start as i32)
    }

    /// Whether rows of the picture, both included, touch the band.
    fn touches(&self, first: i32, last: i32) -> bool {
        last >= self.rows.start as i32 && first < self.rows.end as i32
    }
}

impl<'a> DrawingBackend for Band<'a> {
    type ErrorType = <BitMapBackend<'a> as DrawingBackend>::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Done<'a> {
        self.pixels.ensure_prepared()
    }

    fn present(&mut self) -> Done<'a> {
        self.pixels.present()
    }

    fn draw_pixel(&mut self, place: BackendCoord, colour: BackendColor) -> Done<'a> {
        self.pixels.draw_pixel(self.within(place), colour)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Done<'a> {
        if from.0 != to.0 && from.1 != to.1 {
            return rasterizer::draw_line(self, from, to, style);
        }
        let (from, to) = (self.within(from), self.within(to));
        self.pixels.draw_line(from, to, style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        corner: BackendCoord,
        opposite: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Done<'a> {
        if !fill {
            return rasterizer::draw_rect(self, corner, opposite, style, fill);
        }
        let (corner, opposite) = (self.within(corner), self.within(opposite));
        self.pixels.draw_rect(corner, opposite, style, fill)
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        centre: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Done<'a> {
        let reach = (radius + style.stroke_width()) as i32;
        if !self.touches(centre.1 - reach, centre.1 + reach) {
            return Ok(());
        }
        rasterizer::draw_circle(self, centre, radius, style, fill)
    }

    /// Only rows of `source` in the band are handed on: those above are not.
    fn blit_bitmap(
        &mut self,
        (x, y): BackendCoord,
        (width, height): (u32, u32),
        source: &[u8],
    ) -> Done<'a> {
        let first = (self.rows.start as i32 - y).clamp(0, height as i32);
        let last = (self.rows.end as i32 - y).clamp(first, height as i32);
        if first == last {
            return Ok(());
        }
        let row = 3 * width as usize;
        self.pixels.blit_bitmap(
            self.within((x, y + first)),
            (width, (last - first) as u32),
            &source[first as usize * row..last as usize * row],
        )
    }
}
