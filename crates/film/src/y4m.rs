//! Uncompressed films in the format YUV4MPEG2 of the MJPEG tools, with 8 bits per value.

use crate::plane::{Colour, Plane};
use units::{Words, words};

/// Maximum length of a header line in bytes.
const LINE: usize = 1024;
/// Maximum number of pixels per frame.
const PIXELS: usize = 64 << 20;

/// Reason why a film cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The file does not begin with the signature of the format.
    Signature,
    /// The header has no valid size or frame rate.
    Header {
        /// Header line, at most 100 characters.
        line: String,
    },
    /// Unsupported pixel format, such as one with more than 8 bits.
    Pixels {
        /// Name of the pixel format in the header.
        name: String,
    },
    /// Invalid or incomplete header of a frame.
    Frame {
        /// Number of frames read before it.
        read: usize,
    },
}

impl Fault {
    /// Message: what happened, and what to do.
    pub fn words(&self) -> Words {
        match self {
            Self::Signature => {
                words("The file is not a YUV4MPEG2 film. Convert it with `ffmpeg -i FILM -pix_fmt yuv420p film.y4m`.")
            }
            Self::Header { line } => words!("The header of the film has no valid size or frame rate: {line}"),
            Self::Pixels { name } => words!(
                "Pixels stored as {name} are not read. Convert the film with `ffmpeg -i FILM -pix_fmt yuv420p film.y4m`."
            ),
            Self::Frame { read } => {
                words!("The film is damaged after {read} frames.")
            }
        }
    }
}

/// Content of the film header.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Header {
    /// Width in px.
    pub width: usize,
    /// Height in px.
    pub height: usize,
    /// Frames per second; `None` if unknown.
    pub rate: Option<f64>,
    /// Width and height of both colour planes; `None` for grey films.
    colour: Option<[usize; 2]>,
}

impl Header {
    fn read(line: &[u8]) -> Result<Header, Fault> {
        let line = String::from_utf8_lossy(line);
        let mut words = line.split(' ');
        if words.next() != Some("YUV4MPEG2") {
            return Err(Fault::Signature);
        }
        let fault = || Fault::Header { line: line.chars().take(100).collect() };
        let (mut width, mut height, mut rate, mut pixels) = (0_usize, 0_usize, None, "420jpeg");
        for word in words {
            let Some((key, value)) = word.split_at_checked(1) else { continue };
            match key {
                "W" => width = value.parse().map_err(|_| fault())?,
                "H" => height = value.parse().map_err(|_| fault())?,
                "F" => rate = quotient(value).ok_or_else(fault)?,
                "C" => pixels = value,
                _ => {}
            }
        }
        width.checked_mul(height).filter(|size| (1..=PIXELS).contains(size)).ok_or_else(fault)?;
        let half = |size: usize| size.div_ceil(2);
        let colour = match pixels {
            "mono" => None,
            "420jpeg" | "420mpeg2" | "420paldv" | "420" => Some([half(width), half(height)]),
            "422" => Some([half(width), height]),
            "444" => Some([width, height]),
            name => return Err(Fault::Pixels { name: name.chars().take(40).collect() }),
        };
        Ok(Header { width, height, rate, colour })
    }

    /// Size of a frame in bytes.
    fn bytes(&self) -> usize {
        self.width * self.height + self.colour.map_or(0, |[width, height]| 2 * width * height)
    }

    /// Frame with the given bytes.
    fn plane(&self, mut bytes: Vec<u8>) -> Option<Plane> {
        let colours = bytes.split_off((self.width * self.height).min(bytes.len()));
        let plane = Plane::new(self.width, self.height, bytes)?;
        let Some([width, height]) = self.colour else { return Some(plane) };
        let (across, down) = (width.div_ceil(self.width.div_ceil(2)), height.div_ceil(self.height.div_ceil(2)));
        let half = |values: &[u8]| -> Vec<u8> {
            let rows = values.chunks(width).step_by(down);
            rows.flat_map(|row| row.iter().step_by(across)).copied().collect()
        };
        let (blue, red) = colours.split_at_checked(width * height)?;
        plane.coloured(Colour { blue: half(blue), red: half(red) })
    }
}

/// Frame rate such as `30000:1001`; `Some(None)` for `0:0`, an unknown rate.
fn quotient(text: &str) -> Option<Option<f64>> {
    let (above, below) = text.split_once(':')?;
    let (above, below): (u32, u32) = (above.parse().ok()?, below.parse().ok()?);
    match (above, below) {
        (0, 0) => Some(None),
        (0, _) | (_, 0) => None,
        _ => Some(Some(f64::from(above) / f64::from(below))),
    }
}

enum Section {
    /// Header line of the film.
    Header(Vec<u8>),
    /// Header line of a frame.
    Line(Vec<u8>),
    /// Grey values, followed by colours.
    Pixels(Vec<u8>),
}

/// Incremental reader. Accepts the bytes of a film in parts of any size.
pub struct Reader {
    header: Option<Header>,
    part: Section,
    read: usize,
}

impl Default for Reader {
    fn default() -> Self {
        Reader { header: None, part: Section::Header(Vec::new()), read: 0 }
    }
}

impl Reader {
    /// Header, once it has been read.
    pub fn header(&self) -> Option<Header> {
        self.header
    }

    /// Reads bytes until a frame is complete, and removes them from the slice. `None` if more bytes are needed.
    ///
    /// # Errors
    ///
    /// A [`Fault`] if the bytes are not a readable film.
    pub fn frame(&mut self, bytes: &mut &[u8]) -> Result<Option<Plane>, Fault> {
        while !bytes.is_empty() {
            match &mut self.part {
                Section::Header(line) => {
                    if take_line(line, bytes).map_err(|()| Fault::Signature)? {
                        self.header = Some(Header::read(line)?);
                        self.part = Section::Line(Vec::new());
                    }
                }
                Section::Line(line) => {
                    let fault = Fault::Frame { read: self.read };
                    if take_line(line, bytes).map_err(|()| fault.clone())? {
                        if !line.starts_with(b"FRAME") {
                            return Err(fault);
                        }
                        self.part = Section::Pixels(Vec::new());
                    }
                }
                Section::Pixels(pixels) => {
                    let Some(header) = self.header else { return Err(Fault::Signature) };
                    take(pixels, header.bytes(), bytes);
                    if pixels.len() == header.bytes() {
                        let pixels = std::mem::take(pixels);
                        self.part = Section::Line(Vec::new());
                        self.read += 1;
                        return Ok(header.plane(pixels));
                    }
                }
            }
        }
        Ok(None)
    }
}

/// Moves bytes until `into` has `size` of them.
fn take(into: &mut Vec<u8>, size: usize, bytes: &mut &[u8]) {
    let (now, rest) = bytes.split_at(size.saturating_sub(into.len()).min(bytes.len()));
    into.extend_from_slice(now);
    *bytes = rest;
}

/// Moves bytes up to the end of a line and returns true if it was reached. An error for a line that is too long.
fn take_line(line: &mut Vec<u8>, bytes: &mut &[u8]) -> Result<bool, ()> {
    let end = bytes.iter().position(|byte| *byte == b'\n');
    take(line, line.len() + end.unwrap_or(bytes.len()).min(LINE + 1), bytes);
    if line.len() > LINE {
        return Err(());
    }
    if end.is_some() {
        *bytes = bytes.get(1..).unwrap_or_default();
    }
    Ok(end.is_some())
}
