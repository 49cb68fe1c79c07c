//! The space-time picture of a surface: a strip along the tube from every frame, side by side.

use crate::tracking::column::SpaceTime;

/// The space-time picture of a surface, to be painted: time to the right, the tube downwards.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceTimePicture {
    /// The frame of each column.
    pub frames: Vec<usize>,
    /// How many of the columns have been read; the others are black.
    pub read: usize,
    /// How many rows it has; each is a pixel of the film along the tube.
    pub rows: usize,
    /// Grey values, row by row: one for each frame.
    pub grey: Vec<u8>,
    /// The point of the film's picture that the first row shows.
    pub origin: [f64; 2],
    /// Along the tube, of length 1: from one row to the next.
    pub direction: [f64; 2],
    /// Where the bore begins and ends, in pixels from the axis.
    pub bore: [f64; 2],
}

impl SpaceTimePicture {
    /// Of frames in this order; in pixels of the stored picture.
    pub fn new(picture: &SpaceTime, frames: Vec<usize>) -> Self {
        let rows = picture.columns.iter().map(Vec::len).min().unwrap_or(0);
        let count = frames.len();
        let grey =
            |row: usize, at: usize| picture.columns.get(at).and_then(|column| column.get(row)).copied().unwrap_or(0);
        let value = |row: usize| (0..count).map(move |at| grey(row, at));
        Self {
            frames,
            read: picture.columns.len().min(count),
            rows,
            grey: (0..rows).flat_map(value).collect(),
            origin: picture.origin,
            direction: picture.direction,
            bore: picture.bore,
        }
    }

    /// The row nearest to a point, as a fraction too: a whole number is the middle of a row.
    pub fn row_of(&self, [x, y]: [f64; 2]) -> f64 {
        (x - self.origin[0]) * self.direction[0] + (y - self.origin[1]) * self.direction[1]
    }

    /// The point of a row.
    pub fn position(&self, row: f64) -> [f64; 2] {
        [self.origin[0] + row * self.direction[0], self.origin[1] + row * self.direction[1]]
    }

    /// The column of a frame; `None` where the frame was left out.
    pub fn column_of(&self, frame: usize) -> Option<usize> {
        self.frames.binary_search(&frame).ok()
    }
}
