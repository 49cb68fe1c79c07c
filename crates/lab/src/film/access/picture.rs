//! Decoded picture: painted upright on a canvas, or read as stored grey values.

use super::codecs::{self, Painter, PlaneLayout, VideoFrame};
use super::source::{Source, object};
use film::containers::Orientation;
use film::{Colour, Plane};
use js_sys::{Array, Uint8Array};
use std::rc::Rc;
use view::browser;
use view::views::document;
use wasm_bindgen::{Clamped, JsCast, JsValue};
use web_sys::{HtmlCanvasElement, ImageBitmap, ImageData};

/// Formats whose first plane has the grey values, one byte each. The numbers are steps in the colour planes: rows per
/// row of blocks of 2 × 2 pixels, and bytes per block.
const GREY_FIRST: [(&str, usize, usize); 7] =
    [("I420", 1, 1), ("I420A", 1, 1), ("I422", 2, 1), ("I422A", 2, 1), ("I444", 2, 2), ("I444A", 2, 2), ("NV12", 1, 2)];

/// Picture of a film. Releases its memory when dropped.
pub enum Picture {
    /// Picture of the decoder.
    Frame(VideoFrame),
    /// Copy for later display, or a decoded JPEG.
    Bitmap(ImageBitmap),
    /// Drawn grey values.
    Grey(Rc<Plane>),
}

impl Drop for Picture {
    fn drop(&mut self) {
        match self {
            Self::Frame(frame) => frame.close(),
            Self::Bitmap(bitmap) => bitmap.close(),
            Self::Grey(_) => {}
        }
    }
}

impl Picture {
    /// Width and height as stored, px.
    pub fn size(&self) -> [usize; 2] {
        match self {
            Self::Frame(frame) => {
                let part = frame.visible_rect();
                part.map_or([0; 2], |part| [part.width(), part.height()].map(|length| length as usize))
            }
            Self::Bitmap(bitmap) => [bitmap.width(), bitmap.height()].map(|length| length as usize),
            Self::Grey(plane) => [plane.width(), plane.height()],
        }
    }

    /// Source for drawing on a canvas.
    fn pixels(&self) -> Option<&JsValue> {
        match self {
            Self::Frame(frame) => Some(frame.as_ref()),
            Self::Bitmap(bitmap) => Some(bitmap.as_ref()),
            Self::Grey(_) => None,
        }
    }

    /// Copy that holds no memory of the decoder.
    pub async fn kept(self) -> Option<Self> {
        let Self::Frame(frame) = &self else { return Some(self) };
        let promise = codecs::create_image_bitmap(frame).ok()?;
        Some(Self::Bitmap(browser::wait(promise).await.ok()?.dyn_into().ok()?))
    }

    /// Paints the picture upright over a whole canvas.
    pub fn paint(&self, canvas: &HtmlCanvasElement, orientation: Orientation) -> Option<()> {
        let painter = painter(canvas, false)?;
        if let Self::Grey(plane) = self {
            let colours: Vec<u8> = plane.grey().iter().flat_map(|&grey| [grey, grey, grey, 255]).collect();
            let [width, height] = [plane.width(), plane.height()].map(|length| length as u32);
            let data = ImageData::new_with_u8_clamped_array_and_sh(Clamped(&colours), width, height).ok()?;
            return painter.put_image_data(&data, 0.0, 0.0).ok();
        }
        let size = [canvas.width(), canvas.height()].map(f64::from);
        // Size before the turn; the exchange of width and height is its own inverse.
        let stored = orientation.upright_size(size);
        let corner = orientation.upright([0.0, 0.0], stored);
        let edge = |point: [f64; 2]| {
            let [x, y] = orientation.upright(point, stored);
            [x - corner[0], y - corner[1]]
        };
        let (across, down) = (edge([1.0, 0.0]), edge([0.0, 1.0]));
        painter.set_transform(across[0], across[1], down[0], down[1], corner[0], corner[1]);
        painter.draw_image(self.pixels()?, 0.0, 0.0, stored[0], stored[1]).ok()
    }
}

/// Reader of grey values and colours, with buffers for reuse.
pub struct Greys {
    /// Width and height of the planes: orientation as stored, square px.
    size: [usize; 2],
    buffer: Option<Uint8Array>,
    canvas: Option<HtmlCanvasElement>,
}

impl Greys {
    /// Reader for the pictures of a film.
    pub fn of(source: &Source) -> Self {
        let film = &source.film;
        let size = film.orientation.upright_size(film.display_size()).map(|side| (side.round() as usize).max(1));
        Self { size, buffer: None, canvas: None }
    }

    /// Grey values and colours of a picture as stored.
    pub async fn read(&mut self, picture: &Picture) -> Option<Plane> {
        if let Picture::Grey(plane) = picture {
            return Some(Plane::clone(plane));
        }
        if let Picture::Frame(frame) = picture
            && picture.size() == self.size
            && let Some(plane) = self.copied(frame).await
        {
            return Some(plane);
        }
        self.drawn(picture)
    }

    /// Copies the values of the decoder, if their layout is known.
    async fn copied(&mut self, frame: &VideoFrame) -> Option<Plane> {
        let [width, height] = self.size;
        let format = frame.format()?;
        let planes = GREY_FIRST.iter().find(|planes| planes.0 == format);
        if planes.is_none() && !["BGRX", "BGRA", "RGBX", "RGBA"].contains(&format.as_str()) {
            return None;
        }
        let length = frame.allocation_size().ok()?;
        let buffer = self.buffer.take().filter(|buffer| buffer.length() == length);
        let buffer = buffer.unwrap_or_else(|| Uint8Array::new_with_length(length));
        let layout = browser::wait(frame.copy_to(&buffer).ok()?).await.ok()?;
        let layouts: Vec<PlaneLayout> = Array::from(&layout).iter().map(JsCast::unchecked_into).collect();
        let values = buffer.to_vec();
        self.buffer = Some(buffer);
        // Every `step`-th row of a plane, starting at byte `late`.
        let rows = |plane: usize, late: usize, step: usize| {
            let layout = layouts.get(plane)?;
            let (offset, stride) = (layout.offset() as usize + late, layout.stride() as usize);
            Some(values.get(offset..)?.chunks(stride.max(1)).step_by(step))
        };
        if let Some(&(name, down, across)) = planes {
            let grey: Vec<u8> = rows(0, 0, 1)?.take(height).flat_map(|row| row.iter().take(width)).copied().collect();
            let half = |plane: usize, late: usize| -> Option<Vec<u8>> {
                let rows = rows(plane, late, down)?.take(height.div_ceil(2));
                Some(rows.flat_map(|row| row.iter().step_by(across).take(width.div_ceil(2))).copied().collect())
            };
            let second = if name == "NV12" { (1, 1) } else { (2, 0) };
            let colour = half(1, 0).zip(half(second.0, second.1)).map(|(blue, red)| Colour { blue, red });
            let plane = Plane::new(width, height, grey)?;
            return Some(match colour {
                Some(colour) => plane.clone().coloured(colour).unwrap_or(plane),
                None => plane,
            });
        }
        let blue_first = format.starts_with('B');
        let turned = |&[a, b, c, _]: &[u8; 4]| if blue_first { [c, b, a] } else { [a, b, c] };
        let pixels = rows(0, 0, 1)?.take(height).flat_map(|row| row.as_chunks().0.iter().take(width)).map(turned);
        Plane::of_rgb(width, height, &pixels.collect::<Vec<_>>())
    }

    /// Paints the picture on a canvas and reads it back: for JPEG, more than eight bits, and non-square pixels.
    fn drawn(&mut self, picture: &Picture) -> Option<Plane> {
        let size = self.size;
        let canvas = match self.canvas.take() {
            Some(canvas) => canvas,
            None => document().create_element("canvas").ok()?.dyn_into().ok()?,
        };
        let plane = drawn(picture.pixels()?, &canvas, size);
        self.canvas = Some(canvas);
        plane
    }
}

/// Grey values and colours of a drawable object, scaled to `size` (width, height, px).
pub fn drawn(pixels: &JsValue, canvas: &HtmlCanvasElement, size: [usize; 2]) -> Option<Plane> {
    if [canvas.width(), canvas.height()].map(|length| length as usize) != size {
        canvas.set_width(size[0] as u32);
        canvas.set_height(size[1] as u32);
    }
    let painter = painter(canvas, true)?;
    let [width, height] = size.map(|length| length as f64);
    painter.draw_image(pixels, 0.0, 0.0, width, height).ok()?;
    let values = painter.image_data(0.0, 0.0, width, height).ok()?.data().0;
    let pixels: Vec<[u8; 3]> = values.as_chunks().0.iter().map(|&[r, g, b, _]| [r, g, b]).collect();
    Plane::of_rgb(size[0], size[1], &pixels)
}

/// Context of a canvas. `read`: true keeps the pixels in main memory for reading.
fn painter(canvas: &HtmlCanvasElement, read: bool) -> Option<Painter> {
    let options = object(&[("willReadFrequently", read.into()), ("alpha", false.into())]);
    let painter = canvas.get_context_with_context_options("2d", &options).ok()??;
    Some(painter.unchecked_into())
}
